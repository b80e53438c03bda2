// Soft spheres between rigid walls, brought to mechanical equilibrium.
//
// Overlapping spheres repel with unit stiffness, and walls are impenetrable. FIRE 2.0 minimises the energy (Guénolé
// et al., Comput. Mater. Sci. 175, 2020): motion with inertia, steered along the forces, and stopped whenever the
// energy rises. Time is dimensionless. A sphere far larger than its neighbours has a hundred contacts. Such a sphere
// has a larger mass, so that its frequency is about that of the other spheres.
#include "../../lanes.hpp"
#include "../../registered.hpp"
#include "../../tables/columns.hpp"
#include "../../tables/packing_tables.hpp"
#include "../../threads.hpp"
#include "packing_walls.hpp"
#include "periodic.hpp"

namespace bondem {
namespace {

constexpr Index relaxation_block = 128;  // spheres whose sums are added first, whatever the number of threads

enum Relaxed : Index { converged, out_of_date, exhausted, loose };

// Columns of the sums of a block, which are added up in order: no result depends on the threads.
enum Sum { power, force_square, speed_square, overlap, contacts, deepest, farthest, eased_square };
enum Fire { time_step, mixing, downhill };

// Parameters of FIRE: first and longest time step (the stiffest sphere is stable up to about 0.7), first mixing, and
// downhill steps before it accelerates.
constexpr double first_step = 0.15, longest_step = 0.45, first_mixing = 0.25, patience = 10.0;
// Longest step between walls on a grid: a sphere pressed into a rounded edge oscillates fast.
constexpr double longest_step_on_grid = 0.25;

double total(const Array<double, 2> &part, Sum column) {
    double sum = 0.0;
    for (Index b = 0; b < part.size(); b++) sum += part(b, column);
    return sum;
}

double largest(const Array<double, 2> &part, Sum column) {
    double found = 0.0;
    for (Index b = 0; b < part.size(); b++) found = most(found, part(b, column));
    return found;
}

// Force of the neighbours on a sphere; sum, number and largest of the overlaps in a block.
struct Pressed {
    Vector force = {0.0, 0.0, 0.0};
    double overlaps = 0.0, touching = 0.0, deepest = 0.0;
};

// Adds the forces of the neighbours on sphere i, computed four at a time and added one after the other. There is no
// branch: about a third of the neighbours do not touch, in an order that a processor cannot predict.
BONDEM_INLINE void press_sphere(const Spheres &spheres, const Near &near, Four edge, Four inverse, Index i, Pressed &sum) {
    const double *const sphere = &spheres.sphere(0, 0);
    const auto row = [&](Index j) -> Four { return *reinterpret_cast<const FourInMemory *>(sphere + 4 * j); };
    const Four own = row(i), centre = {own[0], own[1], own[2], 0.0};
    Four force = {sum.force.x, sum.force.y, sum.force.z, 0.0};
    const Index end = near.start(i + 1);
    for (Index k = near.start(i); k < end; k += 4) {
        Four apart[4], column[4];
        for (Index n = 0; n < 4; n++) {
            const Four d = row(k + n < end ? Index(near.neighbour(k + n)) : i) - centre;
            column[n] = apart[n] = d - edge * nearest(d * inverse);
        }
        transpose_four(column);
        const Four zero = {}, tiny = zero + 1e-300;
        const Four square = column[0] * column[0] + column[1] * column[1] + column[2] * column[2];
        const Four distance = root(square > tiny ? square : tiny), gap = own[3] + column[3] - distance;
        Four deep = gap > zero ? gap : zero;
        for (Index n = end - k; n < 4; n++) deep[n] = 0.0;
        const Four push = deep / distance;
        for (Index n = 0; n < 4; n++) {
            force = force - push[n] * apart[n];
            sum.overlaps += deep[n];
            sum.touching += deep[n] > 0.0 ? 1.0 : 0.0;
            sum.deepest = most(sum.deepest, deep[n]);
        }
    }
    sum.force = {force[0], force[1], force[2]};
}

// Finds the forces on the spheres of a block, and the sums of the block.
void press(const Spheres &spheres, const PackingWalls &walls, const Near &near, Index b, const Array<double, 2> &part) {
    const Period period(spheres.period);
    const PlainWalls plain(walls);
    const bool grid = has_grid(walls);
    const Four edge = {period.edge.x, period.edge.y, period.edge.z, 0.0};
    const Four inverse = {period.inverse.x, period.inverse.y, period.inverse.z, 0.0};
    double powers = 0.0, forces = 0.0, eased = 0.0, speeds = 0.0;
    Pressed sum;
    const Index last = least((b + 1) * relaxation_block, spheres.sphere.size());
    for (Index i = b * relaxation_block; i < last; i++) {
        const Vector x = spheres.sphere.row<const Vector>(i);
        const double r = spheres.sphere(i, 3);
        sum.force = {0.0, 0.0, 0.0};
        press_sphere(spheres, near, edge, inverse, i, sum);
        const Vector force = grid ? carried_by_grid(plain, walls, x, r, sum.force) : plain.carried(x, r, sum.force);
        spheres.force.row<Vector>(i) = force;
        const Vector v = spheres.velocity.row<Vector>(i);
        const Vector steering = spheres.ease(i) * force;
        powers += dot(steering, v);
        forces += dot(force, force);
        eased += dot(steering, steering);
        speeds += dot(v, v);
    }
    part(b, power) = powers;
    part(b, force_square) = forces;
    part(b, eased_square) = eased;
    part(b, speed_square) = speeds;
    part(b, overlap) = sum.overlaps;
    part(b, contacts) = sum.touching;
    part(b, deepest) = sum.deepest;
}

struct Descent {
    double back;  // time by which positions move back along the old velocity
    double dt, keep, steer;  // time step, and shares of old velocity and of force in the new velocity
};

// Moves the spheres of a block; finds the square of the largest displacement since the neighbour lists were made.
void descend(const Spheres &spheres, const PackingWalls &walls, const Near &near, Descent step, Index b,
             const Array<double, 2> &part) {
    const PlainWalls plain(walls);
    const bool grid = has_grid(walls);
    double found = 0.0;
    const Index last = least((b + 1) * relaxation_block, spheres.sphere.size());
    for (Index i = b * relaxation_block; i < last; i++) {
        const double ease = spheres.ease(i);
        const Vector force = ease * spheres.force.row<Vector>(i), old = spheres.velocity.row<Vector>(i);
        const double push = step.steer + step.dt, r = spheres.sphere(i, 3), back = step.back * ease, dt = step.dt * ease;
        Vector x = spheres.sphere.row<Vector>(i), v;
        for (Index a = 0; a < 3; a++) {
            v[a] = push * force[a] + step.keep * old[a];
            x[a] = x[a] - back * old[a] + dt * v[a];
        }
        plain.keep_within(r, x, v);
        if (grid) keep_on_grid(plain, walls, r, x, v);
        spheres.sphere.row<Vector>(i) = x;
        spheres.velocity.row<Vector>(i) = v;
        const Vector moved = x - near.listed.row<const Vector>(i);
        found = most(found, dot(moved, moved));
    }
    part(b, farthest) = found;
}

void report_on(const Relaxing &relaxing, Index n, Index step) {
    const Array<double, 2> &part = relaxing.part;
    const double count = total(part, contacts);
    relaxing.report(relaxation_report::rms_force) = root(total(part, force_square) / double(n));
    relaxing.report(relaxation_report::mean_overlap) = total(part, overlap) / most(count, 1.0);
    relaxing.report(relaxation_report::contacts) = 0.5 * count;
    relaxing.report(relaxation_report::largest_overlap) = largest(part, deepest);
    relaxing.report(relaxation_report::steps) = double(step);
}

Descent next_step(const Relaxing &relaxing, double longest) {
    double &dt = relaxing.fire(time_step), &mix = relaxing.fire(mixing), &trusted = relaxing.fire(downhill);
    if (total(relaxing.part, power) > 0.0) {
        trusted += 1.0;
        if (trusted > patience) {
            dt = least(1.1 * dt, longest);
            mix *= 0.99;
        }
        const double ratio = root(total(relaxing.part, speed_square) / total(relaxing.part, eased_square));
        return {0.0, dt, 1.0 - mix, mix * ratio};
    }
    const double back = 0.5 * dt;
    dt = most(0.5 * dt, 0.02);
    mix = first_mixing;
    trusted = 0.0;
    return {back, dt, 0.0, 0.0};
}

}  // namespace

// Minimises the overlap energy, as far as the neighbour lists are valid. Returns the outcome; after `out_of_date`
// make new lists and call again.
Index relax_spheres(Index threads, const Spheres &spheres, const PackingWalls &walls, const Near &near,
                    const Relaxing &relaxing) {
    const Index n = spheres.sphere.size(), blocks = relaxing.part.size();
    const double longest = has_grid(walls) ? longest_step_on_grid : longest_step;
    if (relaxing.fire(time_step) == 0.0) {
        relaxing.fire(time_step) = first_step;
        relaxing.fire(mixing) = first_mixing;
    }
    for (Index step = 0; step <= relaxing.steps; step++) {
        for_each_task(threads, blocks, [&](Index b) { press(spheres, walls, near, b, relaxing.part); });
        report_on(relaxing, n, step);
        if (relaxing.report(relaxation_report::rms_force) <= relaxing.tolerance * relaxing.report(relaxation_report::mean_overlap)) return converged;
        if (relaxing.report(relaxation_report::mean_overlap) < relaxing.loose) return loose;
        if (step == relaxing.steps) return exhausted;
        const Descent down = next_step(relaxing, longest);
        for_each_task(threads, blocks, [&](Index b) { descend(spheres, walls, near, down, b, relaxing.part); });
        if (largest(relaxing.part, farthest) > near.slack * near.slack) return out_of_date;
    }
    return exhausted;
}
BONDEM_CALL(relax_spheres, "converged out_of_date exhausted loose")

}  // namespace bondem
