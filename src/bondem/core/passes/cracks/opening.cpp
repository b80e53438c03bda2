// Faces of cracks, and the stresses of their cells as cracks open or press.
//
// V θ = Σ g·δ - (1 - s) g·F⁺ / k of the halves of a cell (`laws/crack.hpp`), and σ = weight · V θ. Newton's method on
// this piecewise linear, rising function: a step is exact where no half closes or opens on the way.
#include "opening.hpp"

#include "crack_groups.hpp"

namespace bondem {
namespace {

constexpr int most_steps = 30;
constexpr double rounding_of_stress = 1e-14;

void measure(const CrackGroup &group, const Moving &all, const double *period, const CohesiveCracks &cracks,
             const CrackLists &lists, Index portion, bool changes) {
    const CrackPlace at = place_of(group, all.pose, period, cracks);
    const SwellingHalves<Lanes> half = swelling_halves(at.facet, at.s, at.now.faces);
    put_halves(lists.half.data, group, row_of(half.i), row_of(half.j));
    if (!changes) return;
    const Mask<Lanes> away = (at.s == Lanes{}) & turned_away(at.now, at.area);
    put_flags(lists.flag, lists.flagged, group, portion, away, crack::parts);
}

// The stresses of the cells of a list from place q on.
void relax(Index q, const Moving &all, const CellDilatation &cells, const CrackLists &lists, bool only_stale) {
    const Short *const cell = lists.cell.data + q;
    Lanes weight, stress, base, work;
    Index half[lanes];
    for (int n = 0; n < lanes; n++) {
        const Short p = cell[n];
        weight[n] = cells.weight(p);
        stress[n] = all.pose(p, stress_column);
        base[n] = lists.base(p);
        const Index later = lists.head(cell[2 * lanes + n]);
        __builtin_prefetch(lists.half.data + 8 * later);
        work[n] = !only_stale || lists.stale(p) != 0 ? 1.0 : 0.0;
    }
    for (int n = 0; n < lanes; n++) lists.stale(cell[n]) = 0;
    const Lanes zero = {}, none = bondem::all<Lanes>(infinity);
    Mask<Lanes> moves = work > zero;
    if (!any(moves)) return;
    for (int step = 0; step < most_steps; step++) {
        Lanes swelling = base, softness = zero, up = none, down = -none;
        for (int n = 0; n < lanes; n++) half[n] = lists.head(cell[n]);
        for (;;) {
            const double *row[lanes];
            Index more = 0;
            for (int n = 0; n < lanes; n++) {
                row[n] = lists.half.data + 8 * half[n];
                more |= half[n];
                half[n] = half[n] == 0 ? 0 : lists.node(half[n], 0);
                __builtin_prefetch(lists.half.data + 8 * half[n]);
            }
            if (more == 0) break;
            const SwellingHalf<Lanes> of = half_of(gather_rows(row));
            const Lanes press = of.closed + stress * of.pressed, turns = of.turns - stress;
            const Mask<Lanes> closed = press < zero;
            up = select(turns > zero, least(up, turns), up);
            down = select(turns <= zero, most(down, turns), down);
            const Lanes open = of.pulled + stress * of.square;
            const Lanes opening = select(closed, open - press * of.along, open);
            const Lanes square = select(closed, of.square - of.pressed * of.along, of.square);
            swelling += of.swollen - of.loose * opening;
            softness += of.loose * square;
        }
        const Lanes change = (weight * swelling - stress) / (1.0 + weight * softness);
        stress = select(moves, stress + change, stress);
        moves &= opposite(((down < change) & (change < up)) | (absolute(change) <= rounding_of_stress * absolute(stress)));
        if (!any(moves)) break;
    }
    for (int n = 0; n < lanes; n++) all.pose(cell[n], stress_column) = stress[n];
}

void relax_all(const Turn &turn, const Moving &all, const CellDilatation &cells, const CrackLists &lists,
               bool only_stale) {
    over_places(turn, lists.size(2), [&](Index first, Index last, Index) {
        for (Index q = first; q < last; q += lanes) relax(q, all, cells, lists, only_stale);
    });
}

}  // namespace

void begin_bases(const Turn &turn, const Moving &all, const CellDilatation &cells, const CrackLists &lists) {
    for (Index p = turn.first; p < turn.last; p++) {
        const double weight = cells.weight(p);
        lists.base(p) = weight != 0.0 ? all.pose(p, stress_column) / weight : 0.0;
    }
}

void measure_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets, const CohesiveCracks &cracks,
                    const CrackLists &lists) {
    const bool changes = turn.clock.dt > 0.0;
    over_treated(turn, lists,
                 [&](Index first, Index last, Index portion) {
                     lists.flagged(portion) = 0;
                     for (Index e = first; e < last; e++) lists.flag(e) = crack::unchanged;
                 },
                 [&](const CrackGroup &group, Index portion) {
                     measure(group, all, facets.period.data, cracks, lists, portion, changes);
                 });
}

void relax_cracked_cells(const Turn &turn, const Moving &all, const CellDilatation &cells, const CrackLists &lists) {
    relax_all(turn, all, cells, lists, false);
}
void relax_stale_cells(const Turn &turn, const Moving &all, const CellDilatation &cells, const CrackLists &lists) {
    relax_all(turn, all, cells, lists, true);
}

}  // namespace bondem
