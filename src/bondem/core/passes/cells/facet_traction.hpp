#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"

namespace bondem {

// Brings tractions to the time of the clock.
void follow_tractions(const Turn &turn, const Timeline &timeline, const FacetTractions &tractions,
                      const CellDilatation &cells);
// Adds half the work of tractions that change: once by the stresses before, and once by those after.
void add_traction_work(const Turn &turn, const Moving &all, const FacetTractions &tractions, const Rows &rows);

}  // namespace bondem
