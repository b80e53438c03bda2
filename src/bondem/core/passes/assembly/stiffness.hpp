#pragma once
#include "../../tables/stiffness_tables.hpp"

namespace bondem {

// Fills the block rows of beams at rest.
Index assemble_beams(Index threads, const BeamRows &beams, const BlockRows &rows);
// Fills the block rows of facets at rest, and those of the dilatation of cells.
Index assemble_facets(Index threads, const FacetRows &facets, const BlockRows &rows, const DilatationRows &dilatation);

}  // namespace bondem
