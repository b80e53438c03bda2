// Dynamic relaxation: damped motion to equilibrium, with masses m of no physical meaning and a time step of 1.
//
// Each step damps at the critical rate c = 2 ω. ω is the frequency at which the free elements move at present, by
// Rayleigh's quotient of their velocities v and the stiffness K:
//
//     ω² = Σ v·ΔF / Σ m v²      ΔF = K v
//
// averaged over about 1 / ω steps. Loads and prescribed motions grow linearly over the first steps (the ramp). The
// motion ends when the unbalanced force is small against applied and supporting forces plus rounding errors. Forces
// are compared as roots of sums of squares, with torques divided by a length.
#include "../../registered.hpp"
#include "../../tables/statics_tables.hpp"
#include "../beams/beam_passes.hpp"
#include "../motion/elements.hpp"

namespace bondem {
namespace {

enum RelaxationEnding : Index { balanced, all_steps_done };

// Fastest and slowest fading of the running means, and the largest rate of damping, below its limit of 2.
constexpr double fastest_fading = 0.5, slowest_fading = 1e-4, largest_rate = 1.9;

// Share of loads and prescribed motions in a step.
double share_in(const DynamicRelaxation &c, Index step) { return least(1.0, (double(step) + 1.0) / double(c.ramp)); }

struct Balance {
    double ratio;  // unbalanced force over applied and supporting force [-]
    double power, mass;  // Σ v·ΔF and Σ m v² of the last step
};

// Compares forces and loads, stores the forces, and sets the sums to zero.
Balance balance(const DynamicRelaxation &c, const Array<double, 2> &sums, double share) {
    double out = 0.0, applied = 0.0, borne = 0.0, power = 0.0, mass = 0.0;
    const auto square = [](double a) { return a * a; };
    for (Index p = 0; p < c.pose.size(); p++) {
        const Wrench<double> load(gather(sums.data, Short(p)));
        clear(sums.data, Short(p));
        for (Index d = 0; d < 6; d++) {
            const double metric = d < 3 ? 1.0 : 1.0 / c.length, pull = share * c.load(p, d);
            const double force = d < 3 ? load.force[d] : load.torque[d - 3];
            applied += square(pull * metric);
            if (c.free(p, d)) {
                const double v = c.velocity(p, d);
                out += square((force + pull) * metric);
                power += v * (c.before(p, d) - force);
                mass += v * v / c.inverse(p, d / 3);
            } else {
                borne += square(force * metric);
            }
            c.before(p, d) = force;
        }
    }
    return {root(out) / (root(applied) + root(borne) + c.noise / c.tolerance), power, mass};
}

double squared_frequency(const Array<double, 1> &memory) {
    return memory(1) > 0.0 ? most(memory(0), 0.0) / memory(1) : 0.0;
}
// Critical rate of damping for the present frequency; updates the running means.
double damping_rate(const Array<double, 1> &memory, const Balance &now) {
    const double fade = least(fastest_fading, most(root(squared_frequency(memory)), slowest_fading));
    memory(0) += fade * (now.power - memory(0));
    memory(1) += fade * (now.mass - memory(1));
    return least(2.0 * root(squared_frequency(memory)), largest_rate);
}

// Moves elements along their free components by damped forces, and along the others by their prescribed motion.
void move(const DynamicRelaxation &c, double share, double rate, Index step) {
    const double keep = (2.0 - rate) / (2.0 + rate), push = 2.0 / (2.0 + rate);
    const double moving = step < c.ramp ? 1.0 / double(c.ramp) : 0.0;
    for (Index p = 0; p < c.pose.size(); p++) {
        for (Index d = 0; d < 6; d++) {
            const double force = c.before(p, d) + share * c.load(p, d);
            c.velocity(p, d) =
                c.free(p, d) ? keep * c.velocity(p, d) + push * c.inverse(p, d / 3) * force : moving * c.motion(p, d);
        }
        const double *v = &c.velocity(p, 0);
        Row<double> &pose = row_at(c.pose.data, Short(p));
        for (Index d = 0; d < 3; d++) pose.column[d] += v[d];
        const Quaternion<double> q = turned(orientation(pose), Vector{v[3], v[4], v[5]});
        pose.column[4] = q.w, pose.column[5] = q.x, pose.column[6] = q.y, pose.column[7] = q.z;
    }
}

template <class Load>
Index relax(const DynamicRelaxation &c, const BeamSums &sums, const RelaxationSpan &span, const Load load) {
    const Poses poses = {{c.pose.data, {c.pose.shape[0], c.pose.shape[1]}}};
    for (Index &done = span.done(0) = 0; done < span.steps; done++) {
        const Index step = span.first + done;
        load(poses);
        const double share = share_in(c, step);
        const Balance now = balance(c, sums.sums, share);
        span.ratio(0) = now.ratio;
        if (step >= c.ramp && now.ratio <= c.tolerance) return balanced;
        move(c, share, damping_rate(c.memory, now), step);
    }
    return all_steps_done;
}

}  // namespace

// Takes steps until the forces of beams balance the loads; rows of the sums are those of the elements, and zero.
Index relax_beams(Index, const Beams &beams, const BeamSums &sums, const DynamicRelaxation &relaxation,
                  const RelaxationSpan &span) {
    return relax(relaxation, sums, span, [&](const Poses &poses) { load_beams(1, poses, beams, sums); });
}
BONDEM_CALL(relax_beams, "balanced all_steps_done")

// Takes steps until the forces of beams that differ in length only balance the loads.
Index relax_uniform_beams(Index, const Beams &beams, const UniformBeams &uniform, const BeamSums &sums,
                          const DynamicRelaxation &relaxation, const RelaxationSpan &span) {
    const auto load = [&](const Poses &poses) { load_uniform_beams(1, poses, beams, uniform, sums); };
    return relax(relaxation, sums, span, load);
}
BONDEM_CALL(relax_uniform_beams, "balanced all_steps_done")

}  // namespace bondem
