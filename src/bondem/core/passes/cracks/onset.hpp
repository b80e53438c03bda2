#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/crack_tables.hpp"

namespace bondem {

// Marks facets of the material that begin to crack.
void mark_cracking_facets(const Turn &turn, const Moving &all, const ElasticFacets &facets, const FacetForces &kept,
                          const FacetStrengths &strengths, const StressesOfCells &stresses, const CrackOnset &onset);
// Marks facets of planes, such as joints, that begin to crack.
void mark_cracking_planes(const Turn &turn, const Moving &all, const ElasticFacets &facets, const FacetForces &kept,
                          const FacetStrengths &strengths, const CrackOnset &onset);
// Begins the cracks of facets that are marked.
void begin_cracks(const Turn &turn, const ElasticFacets &facets, const FacetForces &kept,
                  const FacetStrengths &strengths,
                  const CrackOnset &onset, const CohesiveCracks &cracks);

}  // namespace bondem
