// Forces and torques of cracks, what they dissipate, and their sums on cells.
#include "crack_loads.hpp"

#include "../cells/walls.hpp"
#include "../record/columns.hpp"
#include "../damage/pipeline.hpp"
#include "carried.hpp"

namespace bondem {
namespace {


constexpr Index rubbed_loss = 2;  // column of the losses of an element

// Forces of the cracks of a group, and the energy that they dissipate.
void load_group(const CrackGroup &group, const Moving &all, const double *period, const CohesiveCracks &cracks,
                const CrackLists &lists, Index portion, bool changes) {
    group.prefetch(cracks.state);
    const Lanes zero = {};
    const CrackPlace at = place_of(group, all.pose, period, cracks);
    Row<Lanes> row = group.lines(cracks.state);
    Lanes *const state = row.column;
    const Lanes s = at.s, s_before = state[6];
    const Vector3<Lanes> slip = turned_by(at.ends.i, Vector3<Lanes>{state[0], state[1], state[2]});
    CrackLoads<Lanes> loads = crack_loads(at.facet, at.now.faces, s, at.stress, slip, at.friction);
    Lanes rate = loads.rate;
    const Mask<Lanes> bound = (s > zero) | (s_before > zero);
    if (any(bound)) {
        Lanes plane;
        const FacetBending<Lanes> bending = facet_bending(at.ends, resistances_of(group, cracks, &plane));
        loads.on_i = plus(loads.on_i, s, bending.torque);
        loads.on_j = minus(loads.on_j, s, bending.torque);
        rate = select(bound, rate + bending.energy, rate);
    }
    const Mask<Lanes> treated = opposite(flagged(lists.flag.data + group.e));
    const auto kept = [&](Lanes x) { return select(treated, x, zero); };
    const Vector3<Lanes> f = loads.force, rub = loads.friction.force, now = loads.friction.slip, came = now - slip;
    CrackLosses<Lanes> lost = {zero, zero};
    if (changes) {
        const CrackStep<Lanes> step = {s_before, s, state[7], rate, {state[3], state[4], state[5]}, rub, came};
        lost = crack_losses(at.facet.k, step);
        lost = {kept(lost.cracked), kept(lost.rubbed)};
        const Vector3<Lanes> own = turned_by(inverse(at.ends.i), now);
        const Vector3<Lanes> none = {};
        const Vector3<Lanes> own_kept = select<Lanes>(treated, own, none), rub_kept = select<Lanes>(treated, rub, none);
        group.put(cracks.state, {{own_kept.x, own_kept.y, own_kept.z, rub_kept.x, rub_kept.y, rub_kept.z, s_before,
                                  rate}});
        if (any(lost.cracked != zero))
            group.put(cracks.history, 1, group.number(cracks.history, 1) + lost.cracked);
        const Mask<Lanes> breaks = treated & (s == zero) & (s_before > zero);
        if (any(breaks)) {
            for (int n = 0; n < group.known; n++)
                if (breaks[n] != 0) lists.flag(group.e + n) = crack::fell;
            lists.flagged(portion) = 2;
        }
    }
    for (int n = 0; n < group.known; n++) {
        double *const pull = &cracks.pull(group.crack[n], 0);
        if (treated[n] != 0) pull[0] = f.x[n], pull[1] = f.y[n], pull[2] = f.z[n];
    }
    const Vector3<Lanes> p = loads.on_i, q = loads.on_j;
    put_halves(lists.output.data, group, {{kept(f.x), kept(f.y), kept(f.z), lost.rubbed, kept(p.x), kept(p.y),
                                           kept(p.z), zero}},
               {{kept(-f.x), kept(-f.y), kept(-f.z), zero, kept(q.x), kept(q.y), kept(q.z), zero}});
    // one by one: the sum has the same bits for any number of lanes
    for (int n = 0; n < group.known; n++) lists.lost(portion, 0) += lost.cracked[n];
}

}  // namespace

void load_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets, const CohesiveCracks &cracks,
                 const CrackLists &lists) {
    const bool changes = turn.clock.dt > 0.0;
    over_treated(turn, lists, [&](Index, Index, Index portion) { lists.lost(portion, 0) = 0.0; },
                 [&](const CrackGroup &group, Index portion) {
                     load_group(group, all, facets.period.data, cracks, lists, portion, changes);
                 });
}

void log_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets, const CohesiveCracks &cracks,
                const CrackLists &lists, const EventLog &log) {
    if (!(turn.clock.dt > 0.0)) return;
    const Index count = lists.size(0);
    double lost = 0.0;
    log.written(1) = log.written(0);
    for (Index q = 0; q < portions(count, crack::of_portion); q++) {
        lost += lists.lost(q, 0) + lists.lost(q, 1);
        if (lists.flagged(q) != 2) continue;
        for (Index e = q * crack::of_portion; e < least(count, (q + 1) * crack::of_portion); e++) {
            if (lists.flag(e) != crack::fell) continue;
            const Index k = lists.treated(e);
            const SingleCrack one(all.pose, facets, cracks, k);
            const CrackFaces<double> &at = one.now.faces;
            const Vector centre = {all.pose(facets.i(k), 0), all.pose(facets.i(k), 1), all.pose(facets.i(k), 2)};
            const double gap = dot(at.gap, at.normal);
            const Removal removal = {history_of(cracks, k).spent, gap, centre + at.arm_i};
            log_event(turn.clock, log, k, gap > 0.0 ? tension_mode : shear_mode, removal);
        }
    }
    log.released(0) += lost;
}

void add_crack_loads(const Turn &turn, const Moving &all, const StressesOfCells &stresses,
                     const CohesiveCracks &cracks,
                     const CrackLists &lists, const StepCut &cut) {
    for (Index at = turn.first; at < turn.last; at++) {
        const Short p = turn.element[at];
        const Index later = lists.head(turn.element[least(at + 4, turn.last - 1)]);
        __builtin_prefetch(lists.node.data + 4 * later);
        __builtin_prefetch(lists.output.data + 8 * later);
        if (lists.head(p) == 0) continue;
        double sum[8] = {};
        Carried carried = {};
        for (Index h = lists.head(p); h > 0;) {
            const double *const of = &lists.output(h, 0);
            const int32_t *const node = &lists.node(h, 0);
            h = node[0];
            __builtin_prefetch(lists.output.data + 8 * h);
            for (int d = 0; d < 8; d++) sum[d] += of[d];
            carried.add(node + 1, of);
        }
        all.loss(p, rubbed_loss) += sum[3];
        double *const to = &cut.sums(turn.row[at], 0);
        for (int d = 0; d < 3; d++) to[d] += sum[d], to[4 + d] += sum[4 + d];
        carried.put(stresses, cracks.pitch.data, p);
    }
}

void sum_stressed_dilatation(const Turn &turn, const Moving &all, const CellDilatation &cells,
                             const CrackEnergies &found) {
    double sum = 0.0;
    for (Index p = turn.first; p < turn.last; p++) {
        const double stress = all.pose(p, stress_column), weight = cells.weight(p);
        if (weight != 0.0) sum += 0.5 * stress * stress / weight;
    }
    found.dilatation(turn.block) = sum;
}

void sum_heat(const Turn &turn, const StressesOfCells &stresses, const YieldingCells &cells,
              const CrackEnergies &found) {
    double sum = 0.0;
    for (Index p = turn.first; p < turn.last; p++) {
        const double *const row = &cells.plastic(p, 0), *const s = &stresses.tensor(p, 0), *const e = row + 10;
        if (row[9] == 0.0) continue;
        const double work = s[0] * e[0] + s[1] * e[1] + s[2] * e[2] + 2.0 * (s[3] * e[3] + s[4] * e[4] + s[5] * e[5]);
        sum += row[16] + 0.5 * stresses.volume(p) * work;
    }
    found.heat(turn.block) = sum;
}

void sum_crack_energies(const Turn &, const Moving &all, const ElasticFacets &facets, const CohesiveCracks &cracks,
                        const CrackEnergies &found) {
    double normal = 0.0, along = 0.0, bend = 0.0;
    for (Index c = 0; c < cracks.size(0); c++) {
        const Index k = cracks.order(c);
        if (history_of(cracks, k).status != crack::active) continue;
        const SingleCrack one(all.pose, facets, cracks, k);
        const double *const q = state_of(cracks, k).rub;
        const float *const h = softening_of(cracks, k).H;
        const CrackHalves<double> half = crack_halves(one.stiffness, one.now.faces, one.stress);
        const Vector rub = {q[0], q[1], q[2]};
        const CrackEnergy<double> energy = crack_energy(one.stiffness, one.now.faces, one.s, half, rub);
        normal += energy.across;
        along += energy.along;
        bend += one.s * facet_bending(one.ends, Symmetric3<double>{h[0], h[1], h[2], h[3], h[4], h[5]}).energy;
    }
    found.cracked(0) = normal, found.cracked(1) = along, found.cracked(2) = bend;
}

void add_crack_energies(const Turn &, const Moving &all, const WallConstraints &walls, const CrackEnergies &found,
                        const Portions &portions) {
    if (portions.bonds.size() == 0) return;
    double dilatation = 0.0;
    for (Index q = 0; q < found.dilatation.size(); q++) dilatation += found.dilatation(q);
    for (Index g = 0; g < walls.cell.size(); g++) dilatation += energy_of_hold(all.pose, all.rest, walls, g);
    portions.bonds(0, 0) += dilatation + found.cracked(0);
    portions.bonds(0, 1) += found.cracked(1);
    portions.bonds(0, 2) += found.cracked(2);
}

void write_heat(const Turn &turn, const CrackEnergies &found, const HistoryRows &history) {
    double heat = 0.0;
    for (Index q = 0; q < found.heat.size(); q++) heat += found.heat(q);
    history.record(turn.clock.record, column::plastic) = heat;
}

}  // namespace bondem
