// Body forces on groups of elements, with accelerations that follow schedules. The work of the forces is added for
// each half of a step, by the velocity in that half.
#include "body_forces.hpp"

#include "../../registered.hpp"
#include "../boundary/timeline.hpp"
#include "elements.hpp"

namespace bondem {
namespace {

void add_work(const Range &range, const Moving &all, const BodyForces &body, Short p) {
    const double *g = &body.present(body.group(p), 0);
    const Motion<double> moving(gather(all.motion.data, p));
    const double power = g[0] * moving.v.x + g[1] * moving.v.y + g[2] * moving.v.z;
    body.work(p, 0) += 0.5 * range.clock.dt * power / moving.m;
}

}  // namespace

// Sets the accelerations by body forces at the time of the clock.
void follow_body_forces(const Range &range, const Timeline &timeline, const BodyForces &body) {
    bool changed = false;
    for (Index b = 0; b < body.schedule.size(); b++) {
        const double factor = value_at(timeline, body.schedule(b), range.clock.time);
        changed |= factor != body.factor(b);
        body.factor(b) = factor;
    }
    if (!changed) return;  // groups may be as many as elements
    for (Index g = 0; g < body.present.size(); g++)
        for (Index d = 0; d < 3; d++) {
            double sum = 0.0;
            for (Index b = 0; b < body.schedule.size(); b++) sum += body.member(g, b) * body.factor(b) * body.pull(b, d);
            body.present(g, d) = sum;
        }
}
BONDEM_PASS(follow_body_forces, of_rows, "")

void add_body_forces(const Range &range, const Moving &all, const StepBlocks &blocks, const BodyForces &body) {
    for (Index e = range.first; e < range.last; e++) {
        const Short p = range.element[e];
        const double inverse_mass = all.motion(p, 3);
        for (Index d = 0; d < 3; d++) blocks.sums(range.row[e], d) += body.present(body.group(p), d) / inverse_mass;
        add_work(range, all, body, p);
    }
}
BONDEM_PASS(add_body_forces, elements_of_blocks, "own motion; changes sums work")

void add_body_work(const Range &range, const Moving &all, const BodyForces &body) {
    if (!range.clock.goes_on) return;
    for (Index e = range.first; e < range.last; e++) add_work(range, all, body, range.element[e]);
}
BONDEM_PASS(add_body_work, elements_of_blocks, "own motion; changes work")

void open_body_work(const Range &range, const Moving &all, const BodyForces &body) {
    for (Index p = range.first; p < range.last; p++) add_work(range, all, body, Short(p));
}
BONDEM_PASS(open_body_work, of_elements, "own motion; changes work")

}  // namespace bondem
