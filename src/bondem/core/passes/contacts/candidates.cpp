// Lists of the pairs of elements, and of the elements at walls, that may touch before the lists are made anew.
//
// Each pair is listed once. Pairs are sorted by the element of the larger number, then by the other, as bonds are.
#include "../../registered.hpp"
#include "../../tables/contact_tables.hpp"
#include "../../tables/step_tables.hpp"
#include "../packing/grid_visits.hpp"
#include "pairs.hpp"
#include "wall_shapes.hpp"

namespace bondem {
namespace {

// Position of a number among entries first … last - 1 of a list, or -1.
Index place_of(const Array<const Short, 1> &list, Index first, Index last, Short wanted) {
    for (Index e = first; e < last; e++)
        if (list(e) == wanted) return e;
    return -1;
}

// Puts a pair into the ascending list begin … count - 1 of its later element.
void insert(const FoundPairs &found, Index begin, Index count, Short first, Index bond) {
    Index k = count;
    for (; k > begin && found.first(k - 1) > first; k--) {
        found.first(k) = found.first(k - 1);
        found.bond(k) = found.bond(k - 1);
    }
    found.first(k) = first;
    found.bond(k) = bond;
}

// Restores gap and memory of a contact of the previous list.
template <class Found>
void recall(const Found &found, Index k, const Array<const double, 1> &rest_gap, Index rest,
            const Array<const double, 2> &touching_memory, Index known) {
    found.gap(k) = rest >= 0 ? rest_gap(rest) : 0.0;
    found.touch(k) = known >= 0 ? touching : separate;
    for (Index c = 0; c < found.memory.shape[1]; c++) found.memory(k, c) = known >= 0 ? touching_memory(known, c) : 0.0;
}

double gap_of(const Poses &all, const Walls &walls, const WallSources &from, Index p, Index w) {
    return WallPlace(walls, w).surface(centre(all.pose.data, Short(p)), from.radius(p)).gap;
}

}  // namespace

// Lists near spheres of a sorted grid that no bond joins, and wanted pairs of bonds, with the memory of pairs that
// touch. Ends when the list is full.
Index list_pairs(Index, const SphereGrid &grid, const PairSources &from, const FoundPairs &found) {
    const Period period(grid.period);
    const Index n = grid.sphere.size(), room = found.first.size();
    Index count = 0;
    found.start(0) = 0;
    for (Index p = 0; p < n; p++) {
        const Index begin = count;
        bool full = false;
        const auto add = [&](Index q, Index bond) {
            if (count < room)
                insert(found, begin, count++, Short(q), bond);
            else
                full = true;
        };
        visit_neighbours(
            grid, period, p, [&](Index q) { return q < p; },
            [&](Index q) {
                if (place_of(from.bond_first, from.bond_start(p), from.bond_start(p + 1), Short(q)) < 0) add(q, -1);
            });
        for (Index b = from.bond_start(p); b < from.bond_start(p + 1); b++)
            if (from.wanted(b)) add(from.bond_first(b), b);
        if (full) return 1;
        for (Index k = begin; k < count; k++) {
            const Short q = found.first(k);
            found.second(k) = Short(p);
            recall(found, k, from.rest_gap, place_of(from.rest_first, from.rest_start(p), from.rest_start(p + 1), q),
                   from.touching_memory,
                   place_of(from.touching_first, from.touching_start(p), from.touching_start(p + 1), q));
        }
        found.start(p + 1) = count;
    }
    return 0;
}
BONDEM_CALL(list_pairs, "all_listed room_full")

// Counts walls within the skin of each element.
Index count_wall_contacts(Index, const Poses &all, const Walls &walls, const WallSources &from) {
    from.start(0) = 0;
    for (Index p = 0; p < all.pose.size(); p++) {
        from.start(p + 1) = from.start(p);
        for (Index w = 0; w < walls.body.size(); w++) from.start(p + 1) += gap_of(all, walls, from, p, w) <= from.skin;
    }
    return 0;
}
BONDEM_CALL(count_wall_contacts, "")

// Lists elements near walls in their order, with the memory of those that touch.
Index list_wall_contacts(Index, const Poses &all, const Walls &walls, const WallSources &from, const FoundWalls &found) {
    for (Index p = 0; p < all.pose.size(); p++) {
        Index k = from.start(p);
        for (Index w = 0; w < walls.body.size(); w++) {
            const double gap = gap_of(all, walls, from, p, w);
            if (!(gap <= from.skin)) continue;
            found.element(k) = Short(p);
            found.wall(k) = Short(w);
            found.now(k) = gap;
            recall(found, k, from.rest_gap, place_of(from.rest_wall, from.rest_start(p), from.rest_start(p + 1), Short(w)),
                   from.touching_memory,
                   place_of(from.touching_wall, from.touching_start(p), from.touching_start(p + 1), Short(w)));
            k++;
        }
    }
    return 0;
}
BONDEM_CALL(list_wall_contacts, "")

}  // namespace bondem
