// Forces and torques of cracks, what they dissipate, and their sums on cells.
#include "crack_loads.hpp"

#include "../cells/walls.hpp"
#include "../record/columns.hpp"
#include "../damage/pipeline.hpp"
#include "carried.hpp"

namespace bondem {
namespace {


constexpr Index rubbed_loss = 2;  // column of the losses of an element

// Energy dissipated by the cracks of a group, the places of the list alone.
double load_group(const CrackGroup &group, const Moving &all, const CohesiveCracks &cracks, const CrackLists &lists,
                  Index portion, bool changes) {
    const Index e = group.e;
    const Row<Lanes> a = gather(all.pose.data, group.i), b = gather(all.pose.data, group.j);
    const Ends<Lanes> ends = {{}, orientation(a), orientation(b)};
    Row<Lanes> first = group.state(cracks, 0), second = group.state(cracks, 8);
    const Lanes zero = {}, s = second.column[crack::integrity - 8], s_before = first.column[crack::before];
    const CrackFaces<Lanes> at = measured_faces(lists, e);
    const auto constant = [&](int column) { return group.number(cracks.constant, crack::constant_width, column); };
    const FacetCompliance<Lanes> facet = {constant(6), constant(7)};
    const Lanes friction = constant(15);
    const Vector3<Lanes> slip = turned_by(ends.i, Vector3<Lanes>{first.column[2], first.column[3], first.column[4]});
    CrackLoads<Lanes> loads = crack_loads(facet, at, s, {a.column[stress_column], b.column[stress_column]}, slip, friction);
    Lanes rate = loads.rate;
    if (any((s > zero) | (s_before > zero))) {
        const Row<Lanes> h = group.columns(cracks.constant, crack::constant_width, 24);
        const FacetBending<Lanes> bending =
            facet_bending(ends, {h.column[0], h.column[1], h.column[2], h.column[3], h.column[4], h.column[5]});
        loads.on_i = plus(loads.on_i, s, bending.torque);
        loads.on_j = minus(loads.on_j, s, bending.torque);
        rate = rate + bending.energy;
    }
    const Mask<Lanes> treated = opposite(flagged(lists.flag.data + e));
    const auto kept = [&](Lanes x) { return select(treated, x, zero); };
    const Vector3<Lanes> f = loads.force, rub = loads.friction.force, now = loads.friction.slip, came = now - slip;
    CrackLosses<Lanes> lost = {zero, zero};
    if (changes) {
        const Vector3<Lanes> rub_before = {second.column[0], second.column[1], second.column[2]};
        lost = crack_losses(facet.k, CrackStep<Lanes>{s_before, s, first.column[crack::rate], rate, rub_before, rub, came});
        lost = {kept(lost.cracked), kept(lost.rubbed)};
        const Quaternion<Lanes> back = {ends.i.w, -ends.i.x, -ends.i.y, -ends.i.z};
        const Vector3<Lanes> own = turned_by(back, now);
        first.column[2] = kept(own.x), first.column[3] = kept(own.y), first.column[4] = kept(own.z);
        first.column[crack::rate] = rate;
        second.column[0] = kept(rub.x), second.column[1] = kept(rub.y), second.column[2] = kept(rub.z);
        second.column[crack::spent - 8] = second.column[crack::spent - 8] + lost.cracked;
        const Mask<Lanes> breaks = treated & (s == zero) & (s_before > zero);
        group.put(cracks.row, crack::row_width, 0, first);
        group.put(cracks.row, crack::row_width, 8, second);
        if (any(breaks)) {
            for (int n = 0; n < group.known; n++)
                if (breaks[n] != 0) lists.flag(e + n) = crack::fell;
            lists.flagged(portion) = 2;
        }
    }
    for (int n = 0; n < group.known; n++) {
        double *const pull = &cracks.pull(group.crack[n], 0);
        if (treated[n] != 0) pull[0] = f.x[n], pull[1] = f.y[n], pull[2] = f.z[n];
    }
    const Vector3<Lanes> p = loads.on_i, q = loads.on_j;
    put_halves(lists.output.data, e, {{kept(f.x), kept(f.y), kept(f.z), lost.rubbed, kept(p.x), kept(p.y), kept(p.z), zero}},
               {{kept(-f.x), kept(-f.y), kept(-f.z), zero, kept(q.x), kept(q.y), kept(q.z), zero}});
    double sum = 0.0;
    for (int n = 0; n < group.known; n++) sum += lost.cracked[n];
    return sum;
}

}  // namespace

void load_cracks(const Turn &turn, const Moving &all, const FacetStrengths &, const CohesiveCracks &cracks, const CrackLists &lists) {
    const Index count = lists.size(0);
    const bool changes = turn.clock.dt > 0.0;
    over_places(turn, count, [&](Index first, Index last, Index portion) {
        double lost = 0.0;
        for (Index e = first; e < last; e += lanes)
            lost += load_group({lists.treated, lists.treated_i, lists.treated_j, e, count}, all, cracks, lists, portion,
                               changes);
        lists.lost(portion, 0) = lost;
    });
}

void log_cracks(const Turn &turn, const Moving &all, const CohesiveCracks &cracks, const CrackLists &lists, const EventLog &log) {
    if (!(turn.clock.dt > 0.0)) return;
    const Index count = lists.size(0);
    double lost = 0.0;
    log.written(1) = log.written(0);
    for (Index q = 0; q < portions(count, crack::of_portion); q++) {
        lost += lists.lost(q, 0) + lists.lost(q, 1);
        if (lists.flagged(q) != 2) continue;
        for (Index e = q * crack::of_portion; e < least(count, (q + 1) * crack::of_portion); e++) {
            if (lists.flag(e) != crack::fell) continue;
            const Index c = lists.treated(e);
            const auto measured = [&](Index r) { return lists.measured(r, e); };
            const double gap = measured(0) * measured(3) + measured(1) * measured(4) + measured(2) * measured(5);
            const Vector place = {all.pose(cracks.i(c), 0) + measured(12), all.pose(cracks.i(c), 1) + measured(13),
                                  all.pose(cracks.i(c), 2) + measured(14)};
            log_event(turn.clock, log, cracks.facet(c), gap > 0.0 ? tension_mode : shear_mode, {cracks.row(c, crack::spent), gap, place});
        }
    }
    log.released(0) += lost;
}

void add_crack_loads(const Turn &turn, const Moving &all, const StressesOfCells &stresses, const CohesiveCracks &cracks,
                     const CrackLists &lists, const StepCut &cut) {
    for (Index at = turn.first; at < turn.last; at++) {
        const Short p = turn.element[at];
        if (lists.head(p) == 0) continue;
        double sum[8] = {};
        Carried carried = {};
        for (Index h = lists.head(p); h > 0; h = lists.after(h)) {
            const double *const of = &lists.output(h, 0);
            for (int d = 0; d < 8; d++) sum[d] += of[d];
            carried.add(constants_of(cracks, lists.treated((h - 1) >> 1)) + (h & 1 ? 0 : 8), of);
        }
        all.loss(p, rubbed_loss) += sum[3];
        double *const to = &cut.sums(turn.row[at], 0);
        for (int d = 0; d < 3; d++) to[d] += sum[d], to[4 + d] += sum[4 + d];
        carried.put(stresses, p);
    }
}

void sum_stressed_dilatation(const Turn &turn, const Moving &all, const CellDilatation &cells, const CrackEnergies &found) {
    double sum = 0.0;
    for (Index p = turn.first; p < turn.last; p++) {
        const double stress = all.pose(p, stress_column), weight = cells.weight(p);
        if (weight != 0.0) sum += 0.5 * stress * stress / weight;
    }
    found.dilatation(turn.block) = sum;
}

void sum_heat(const Turn &turn, const StressesOfCells &stresses, const YieldingCells &cells, const CrackEnergies &found) {
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
        if (cracks.row(c, crack::status) != crack::active) continue;
        const SingleCrack one(all.pose, facets.period.data, cracks, c);
        const double s = cracks.row(c, crack::integrity);
        const CrackHalves<double> half = crack_halves(one.stiffness, one.now.faces, one.stress(all.pose, cracks, c));
        const CrackEnergy<double> energy = crack_energy(one.stiffness, one.now.faces, s, half, row_vector(cracks, c, crack::rub));
        const double *h = constants_of(cracks, c) + 24;
        normal += energy.across;
        along += energy.along;
        bend += s * facet_bending(one.ends, Symmetric3<double>{h[0], h[1], h[2], h[3], h[4], h[5]}).energy;
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
