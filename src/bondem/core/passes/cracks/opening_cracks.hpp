// Faces of active cracks, and the stresses of their cells, for one crack or cell or for one per SIMD lane.
//
// The stress of a cell is σ = weight · V θ, with the weight λ / V (`laws/cell.hpp`) and the volume times dilatation
// V θ. V θ is less where the halves of its cracks lose a part of their force, and this part depends on σ
// (`laws/crack.hpp`). Newton's method solves the piecewise linear equation for σ. An iteration is exact if no half
// closes or opens in it.
#pragma once
#include "crack_axes.hpp"

namespace bondem {

// Writes the halves of a group of active cracks, flags cracks that part, and chooses axes of cracks without loss.
template <class Group, class T = typename Group::Number>
BONDEM_INLINE void measure_each(const Group &group, const Moving &all, const ElasticFacets &facets, const CellSlack &slack,
                                const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists,
                                Index portion, bool changes) {
    group.prefetch(lists);
    const CrackPlace<T> at = place_of(group, all.pose, facets.period.data, cracks);
    const HalfRows<T> i = rows_of(swelling_half(at.facet.k, at.facet.part, at.now, at.now.share_i));
    const HalfRows<T> j = rows_of(swelling_half(at.facet.k, T(1.0 - at.facet.part), at.now, at.now.share_j));
    group.put_halves(lists, i.first, j.first);
    group.put_halves(lists, i.second, j.second, 8);
    if (!changes) return;
    const CrackIntegrity<T> &left = at.now.left;
    const Mask<T> whole = opposite(at.isotropic) & (left.s[0] == bondem::all<T>(1.0));
    if (any(whole))
        group.where(whole, [&](Index k, Index, int) { choose_axes(all, facets, slack, stresses, cracks, lists, k); });
    const Mask<T> separate = (left.s[0] == T{}) & (left.grip == T{});
    if (!any(separate)) return;
    const Mask<T> slid = separate & turned_away(at.now, at.area, cracks.slide);
    Mask<T> away = separate & turned_away(at.now, at.area, 1.0);
    if (any(slid)) away = away | (slid & (group.softening(cracks).plane > T{}));
    group.flag(lists.flag, lists.flagged, portion, away, crack::parts);
}

namespace crack {
constexpr int most_steps = 30;
constexpr double rounding_of_stress = 1e-14;
}  // namespace crack

// One cell, and the halves of its active cracks one after the other.
struct OneCell {
    using Number = double;
    Short p;

    template <class Of> BONDEM_INLINE double each(Of of) const { return of(p); }
    template <class To> BONDEM_INLINE void put(double a, To to) const { to(p, a); }

    struct Halves {
        const CrackLists &lists;
        Index half;
        Halves(const OneCell &cell, const CrackLists &lists) : lists(lists), half(lists.head(cell.p)) {}
        BONDEM_INLINE bool next(SwellingHalf<double> &of) {
            if (half == 0) return false;
            of = half_at(lists, half);
            half = lists.next(half);
            return true;
        }
    };
};

#if defined(BONDEM_LANES)

// Group of cells of a list, as many as there are lanes, and the halves of their active cracks.
struct CellGroup {
    using Number = Lanes;
    const Short *cell;

    template <class Of> BONDEM_INLINE Lanes each(Of of) const {
        Lanes all;
        for (int n = 0; n < lanes; n++) all[n] = of(cell[n]);
        return all;
    }
    template <class To> BONDEM_INLINE void put(Lanes a, To to) const {
        for (int n = 0; n < lanes; n++) to(cell[n], a[n]);
    }

    struct Halves {
        const CrackLists &lists;
        Index half[lanes];
        Halves(const CellGroup &group, const CrackLists &lists) : lists(lists) {
            for (int n = 0; n < lanes; n++) half[n] = lists.head(group.cell[n]);
        }
        BONDEM_INLINE bool next(SwellingHalf<Lanes> &of) {
            const double *row[lanes], *second[lanes];
            Index more = 0;
            for (int n = 0; n < lanes; n++) {
                row[n] = lists.half.data + 16 * half[n];
                second[n] = row[n] + 8;
                more |= half[n];
                half[n] = lists.next(half[n]);
                prefetch(lists.half.data + 16 * half[n]);
                prefetch(lists.half.data + 16 * half[n] + 8);
            }
            if (more == 0) return false;
            of = half_of(HalfRows<Lanes>{gather_rows(row), gather_rows(second)});
            return true;
        }
    };
};

#endif

// Finds the stresses of cells by Newton's method, from V θ without their active cracks and the halves of these.
template <class Cells, class T = typename Cells::Number>
BONDEM_INLINE void relax(const Cells &at, const Moving &all, const CellDilatation &cells, const CrackLists &lists) {
    const T weight = at.each([&](Short p) { return cells.weight(p); });
    T stress = at.each([&](Short p) { return all.pose(p, stress_column); });
    const T base = at.each([&](Short p) { return lists.base(p); });
    const T zero = {}, none = bondem::all<T>(infinity);
    Mask<T> moves = none > zero;
    for (int step = 0; step < crack::most_steps; step++) {
        T swelling = base, softness = zero, up = none, down = -none;
        typename Cells::Halves halves(at, lists);
        for (SwellingHalf<T> of; halves.next(of);) {
            for (int d = 0; d < 3; d++) {
                const T turns = of.turns[d] - stress;
                up = select(turns > zero, least(up, turns), up);
                down = select(turns <= zero, most(down, turns), down);
            }
            const Swelling<T> sum = swelling_of(of, stress);
            swelling += sum.swelling;
            softness += sum.softness;
        }
        const T change = (weight * swelling - stress) / (1.0 + weight * softness);
        stress = select(moves, stress + change, stress);
        moves &= opposite(((down < change) & (change < up)) |
                          (absolute(change) <= crack::rounding_of_stress * absolute(stress)));
        if (!any(moves)) break;
    }
    at.put(stress, [&](Short p, double a) { all.pose(p, stress_column) = a; });
}

}  // namespace bondem
