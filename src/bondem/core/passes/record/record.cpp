// A row of the history (time, energy balance and gauges), and the guard of the energy.
#include "record.hpp"

#include "../../registered.hpp"
#include "../../tables/columns.hpp"
#include "reading.hpp"

namespace bondem {
namespace {

using namespace history_column;

// Kinetic energy over all energy supplied so far above which a run counts as unstable. The ratio exceeds one by the
// error of the scheme only; unstable motion grows by orders of magnitude in a hundred steps.
constexpr double beyond = 1000.0;

struct Kinetic {
    double translation, rotation;  // [J]
};
Kinetic kinetic_energy(double *motion, Index p) {
    const Motion<double> moving(gather(motion, Short(p)));
    return {0.5 * dot(moving.v, moving.v) / moving.m, 0.5 * dot(moving.w, moving.w) / moving.u};
}

}  // namespace

void sum_element_energies(const Turn &turn, const Moving &all, const Portions &portions) {
    double sum[4] = {};
    for (Index p = turn.first; p < turn.last; p++) {
        const Kinetic energy = kinetic_energy(all.motion.data, p);
        sum[0] += energy.translation;
        sum[1] += energy.rotation;
        sum[2] += all.loss(p, 0);
        sum[3] += all.loss(p, 2);
    }
    for (Index c = 0; c < 4; c++) portions.elements(turn.block, c) = sum[c];
}
BONDEM_PASS(sum_element_energies, of_elements, "")

// Finds whether a number is not finite, or the motion has more energy than can have come in.
void judge_energy(const Turn &, const Rows &rows, const Portions &portions) {
    Index wide = 0, lost = 0, not_finite = 0;
    for (Index q = 0; q < portions.turned.size(); q++) {
        wide += portions.turned(q, 0);
        lost += portions.turned(q, 1);
        not_finite |= portions.turned(q, 2);
    }
    double kinetic = 0.0, supplied = portions.budget(guard_energy::walls);
    for (Index q = 0; q < portions.elements.size(); q++) kinetic += portions.elements(q, 0) + portions.elements(q, 1);
    for (Index r = 0; r < rows.work.size(); r++) supplied += absolute(rows.work(r));
    portions.found(guard_number::wide) = wide;
    portions.found(guard_number::lost) = lost;
    portions.found(guard_number::ending) = 1;
    if (not_finite || !(kinetic < infinity && supplied < infinity)) return;
    portions.budget(guard_energy::supplied) = most(portions.budget(guard_energy::supplied), supplied);
    const double known = portions.budget(guard_energy::start) + portions.budget(guard_energy::supplied);
    portions.found(guard_number::ending) = kinetic > beyond * known ? 2 : 0;
}
BONDEM_PASS(judge_energy, single, "")

// Writes time and the entries of the energy balance.
void write_ledger(const Turn &turn, const Rows &rows, const Portions &portions, const HistoryRows &history) {
    double *const record = &history.record(turn.clock.record, 0);
    record[time] = turn.clock.time;
    for (Index q = 0; q < portions.elements.size(); q++) {
        record[translation] += portions.elements(q, 0);
        record[rotation] += portions.elements(q, 1);
        record[loss] += portions.elements(q, 2);
        record[friction] += portions.elements(q, 3);
    }
    for (Index q = 0; q < portions.bonds.size(); q++)
        for (Index c = 0; c < 4; c++) record[normal + c] += portions.bonds(q, c);
    for (Index r = 0; r < rows.work.size(); r++) record[work] += rows.work(r);
}
BONDEM_PASS(write_ledger, single, "")

// Writes three components of each gauge of elements.
void read_gauges(const Turn &turn, const Moving &all, const Rows &rows, const Gauges &gauges, const HistoryRows &history) {
    for (Index g = 0; g < gauges.quantity.size(); g++) {
        const Index quantity = gauges.quantity(g), reduction = gauges.reduction(g);
        const Index first = gauges.start(g), last = gauges.start(g + 1);
        if (quantity >= gauge_quantity::of_walls) continue;
        for (Index axis = 0; axis < 3; axis++) {
            double value = reduction == gauge_reduction::max_abs ? -infinity : 0.0;
            for (Index e = first; e < last; e++) {
                const double x = gauge::read(all, rows, quantity, gauges.element(e), axis);
                value = reduction == gauge_reduction::max_abs ? most(value, absolute(x)) : value + x;
            }
            history.record(turn.clock.record, history_column::count + 3 * g + axis) =
                reduction == gauge_reduction::mean ? value / double(last - first) : value;
        }
    }
}
BONDEM_PASS(read_gauges, of_rows, "")

}  // namespace bondem
