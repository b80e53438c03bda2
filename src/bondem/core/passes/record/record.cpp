// A row of the history: time, the energy ledger, and gauges. And the guard of the energy.
#include "record.hpp"

#include "../motion/elements.hpp"
#include "columns.hpp"

namespace bondem {
namespace {

using namespace column;
// What a gauge reads of an element, and how it makes one number of many.
enum Quantity : Index { displacement, velocity, angle, spin, force, of_walls };
enum Reduction : Index { mean, sum, largest };
// Kinetic energy over all there ever was from which on a run is taken for unstable. It never exceeds one but by the error
// of the scheme, and what grows does so by orders of magnitude in a hundred steps.
constexpr double beyond = 1000.0;

struct Kinetic {
    double translation, rotation;  // [J]
};
Kinetic kinetic_energy(double *motion, Index p) {
    const Motion<double> moving(gather(motion, Short(p)));
    return {0.5 * dot(moving.v, moving.v) / moving.m, 0.5 * dot(moving.w, moving.w) / moving.u};
}

// Component of the rotation vector of a unit quaternion [rad], of length at most π.
double rotation_component(Quaternion<double> q, Index axis) {
    const Vector v = {q.x, q.y, q.z};
    const double sine = length(v);
    if (sine < 1e-12) return 2.0 * v[axis];
    return 2.0 * __builtin_atan2(sine, absolute(q.w)) * v[axis] / sine * (q.w >= 0.0 ? 1.0 : -1.0);
}

double read(const Moving &all, const Rows &rows, Index quantity, Index p, Index axis) {
    switch (quantity) {
        case displacement: return all.pose(p, axis) - all.rest(p, axis);
        case velocity: return all.motion(p, axis);
        case angle: return rotation_component(orientation(gather(all.pose.data, Short(p))), axis);
        case spin: return all.motion(p, 4 + axis);
        default: break;
    }
    const Index r = rows.of(p);
    if (r < 0) return 0.0;
    const double of_walls = rows.grip.size() > 0 ? rows.grip(r, axis) : 0.0;  // that hold facets of the cell
    return of_walls + (rows.fixed(r, axis) ? rows.reaction(r, axis) : rows.force(r, axis));
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

void judge_energy(const Turn &, const Rows &rows, const Portions &portions) {
    Index wide = 0, lost = 0, not_finite = 0;
    for (Index q = 0; q < portions.turned.size(); q++) {
        wide += portions.turned(q, 0);
        lost += portions.turned(q, 1);
        not_finite |= portions.turned(q, 2);
    }
    double kinetic = 0.0, supplied = portions.budget(2);
    for (Index q = 0; q < portions.elements.size(); q++) kinetic += portions.elements(q, 0) + portions.elements(q, 1);
    for (Index r = 0; r < rows.work.size(); r++) supplied += absolute(rows.work(r));
    portions.found(0) = wide;
    portions.found(1) = lost;
    portions.found(2) = 1;
    if (not_finite || !(kinetic < infinity && supplied < infinity)) return;
    portions.budget(1) = most(portions.budget(1), supplied);
    portions.found(2) = kinetic > beyond * (portions.budget(0) + portions.budget(1)) ? 2 : 0;
}

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

void read_gauges(const Turn &turn, const Moving &all, const Rows &rows, const Gauges &gauges, const HistoryRows &history) {
    for (Index g = 0; g < gauges.quantity.size(); g++) {
        const Index quantity = gauges.quantity(g), reduction = gauges.reduction(g);
        const Index first = gauges.start(g), last = gauges.start(g + 1);
        if (quantity >= of_walls) continue;
        for (Index axis = 0; axis < 3; axis++) {
            double value = reduction == largest ? -infinity : 0.0;
            for (Index e = first; e < last; e++) {
                const double x = read(all, rows, quantity, gauges.element(e), axis);
                value = reduction == largest ? most(value, absolute(x)) : value + x;
            }
            history.record(turn.clock.record, fixed_columns + 3 * g + axis) =
                reduction == mean ? value / double(last - first) : value;
        }
    }
}

}  // namespace bondem
