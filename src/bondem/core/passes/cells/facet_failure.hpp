#pragma once
#include "../../laws/criteria/bond_criteria.hpp"
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/damage_tables.hpp"

namespace bondem {

// Takes the loads that a failure changes, times a sign, off the kept sum of postponed cell p: those of its facets, where
// it or the other cell loses a facet, and those of its walls where it loses one.
void take_off_changing(double sign, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                       const FacetRelease &release, const Postponed &postponed, Index p);
// Adds them as they are after the failure; the loads of its walls are brought up to date.
void add_changed(const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                 const FacetRelease &release, const Postponed &postponed, Index p);

// Lists the cells whose loads change, and takes the loads of their facets and walls off the kept sums.
void withdraw_facets(const Turn &turn, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                     const FacetRelease &release, const Candidates &candidates, const Postponed &postponed);
// Removes the facets that fail, and brings the stresses of their cells up to date.
void break_facets(const Turn &turn, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                  const FacetRelease &release, const Candidates &candidates, const EventLog &log);
// Adds the loads of the facets that are left, and of walls, to the kept sums.
void restore_facets(const Turn &turn, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                    const FacetRelease &release, const Candidates &candidates, const Postponed &postponed);
// Sets the forces of walls on the rows of their cells anew.
void renew_wall_rows(const Turn &turn, const WallConstraints &walls, const Rows &rows, const Candidates &candidates);
// Weighs all cells by the facets that they have left, as a run begins.
Index weigh_cells(Index threads, const ElasticFacets &facets, const FacetRelease &release);
// Finds which of the marked facets fail by a criterion, at the present stresses, and holds their cells and the neighbours of
// these. The second function gives the index of every facet, at the stresses in the poses.
#define BONDEM_DECLARED(_, name, Criterion)                                                                             \
    void judge_facets_by_##name(const Turn &turn, const Moving &all, const ElasticFacets &facets,                       \
                                const FacetRelease &release, const Strengths &strengths, const Candidates &candidates,  \
                                const Postponed &postponed);                                                            \
    Index index_facets_by_##name(Index threads, const Poses &all, const ElasticFacets &facets,                          \
                                 const Strengths &strengths, const FailureIndices &found);
BONDEM_FACET_CRITERIA(BONDEM_DECLARED, )
#undef BONDEM_DECLARED

}  // namespace bondem
