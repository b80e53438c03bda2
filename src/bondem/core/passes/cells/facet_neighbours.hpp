// Facets, walls and neighbours of one cell, and reasons to postpone its motion (`passes/damage/pipeline.hpp`).
#pragma once
#include "../damage/pipeline.hpp"
#include "facets.hpp"

namespace bondem {

// Calls on(k) for the facets of a cell, first those of which it is j; `for_each_wall_of` does so for its walls.
template <class On> inline void for_each_facet_of(const FacetRelease &release, Index p, On on) {
    for_each_bond_of(release, p, [&](Index k, bool) { on(k); });
}
template <class On> inline void for_each_wall_of(const FacetRelease &release, Index p, On on) {
    for (Index e = release.wall_start(p); e < release.wall_start(p + 1); e++) on(release.wall(e));
}
inline Index other_cell(const ElasticFacets &facets, Index k, Index p) {
    return facets.i(k) != Short(p) ? facets.i(k) : facets.j(k);
}

// Reasons for which a cell is postponed, one bit each: neighbour, facet of its own; and a bit for listed cells.
namespace postponed_for {
enum : Byte { neighbour = 1, own_facet = 2, listed = 4 };
}
// True if a postponed cell loses a facet in this step.
inline bool loses_facet(const Postponed &postponed, Index p) {
    return (get_shared(postponed.flag(p)) & postponed_for::own_facet) != 0;
}

}  // namespace bondem
