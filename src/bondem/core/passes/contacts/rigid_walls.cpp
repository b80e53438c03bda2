// Walls as rigid bodies: how they move, what they do to elements, and what elements do to them.
//
// A driven wall follows its schedules. A servo is a platen of some mass that is pushed along its normal by a wanted force
// against the force of the elements; a share of the missing force resists its motion, and its speed is limited. A free wall moves by the force of the elements and one of its
// own: half a kick before it moves, half when the forces on it are known. The work of a wall on the elements is the
// trapezoid of its power.
#include "rigid_walls.hpp"

#include "../boundary/timeline.hpp"
#include "../record/columns.hpp"
#include "pairs.hpp"
#include "travel.hpp"
#include "wall_shapes.hpp"

namespace bondem {
namespace {

void kick(const WallMotions &motions, const Walls &walls, double dt) {
    for (Index e = 0; e < motions.free_wall.size(); e++) {
        const Index w = motions.free_wall(e);
        for (Index c = 0; c < 3; c++)
            walls.body(w, rate + c) += dt * (walls.body(w, wall_force + c) + motions.free_force(e, c)) / motions.free_mass(e);
    }
}

double power(const Walls &walls, Index w) {
    double sum = 0.0;
    for (Index c = 0; c < 4; c++) sum += walls.body(w, wall_force + c) * walls.body(w, rate + c);
    return sum;
}

double wanted(const WallMotions &motions, Index schedule, double t) {
    return value_at(Timeline{motions.times, motions.values, motions.start}, schedule, t);
}

void follow_servo(const Turn &turn, const WallMotions &motions, const Walls &walls, Index e) {
    const Index w = motions.servo_wall(e);
    const WallPlace wall(walls, w);
    const double dt = turn.clock.dt, force = wanted(motions, motions.servo_schedule(e), turn.clock.time + dt);
    const double missing = force - walls.body(w, normal_force), moving = wall.towards_elements();
    const double resisting = motions.servo_damping(e) * absolute(missing);
    const double acting = missing - (moving > 0.0 ? resisting : moving < 0.0 ? -resisting : 0.0);
    const double inward = moving + dt * acting / motions.servo_mass(e);
    const double speed = within(inward, -motions.servo_speed(e), motions.servo_speed(e));
    if (wall.flat()) {
        const Vector v = speed * wall.axis();
        for (Index c = 0; c < 3; c++) walls.body(w, rate + c) = v[c];
    } else {
        walls.body(w, rate + 3) = wall.among() ? speed : -speed;
    }
}

// An element at a wall.
struct AtWall {
    double radius, inverse_mass;
    Vector spin, velocity;  // angular velocity, and velocity against the wall
    double growing;  // of the wall towards the element [m/s]

    // Direction and velocity at the contact, where the wall is so far from the surface.
    Meeting<double> meeting(const WallSurface &at) const {
        return {at.normal, velocity - growing * at.normal - cross((radius + at.gap) * spin, at.normal)};
    }
};

template <class Law>
ContactLoads<double> wall_loads(const Law &law, const ContactConstants &c, const AtWall &who, const WallSurface &now,
                                const WallSurface &last, double rest, double friction, const ContactMemory<double> &memory,
                                double dt) {
    const Overlaps<double> overlap = {positive(rest - now.gap), positive(rest - last.gap)};
    const double before = law.at_wall(who.radius, overlap.before).kn;
    const auto k =
        contact_stiffness(law, law.at_wall(who.radius, overlap.now), before, c.soft, 1.0 / who.inverse_mass, overlap);
    const double twist = 0.5 * dot(who.spin, now.normal);
    return contact_loads<Law::hardens>(k, friction, overlap.now, who.meeting(now), who.meeting(last), twist, memory, dt);
}

WallSurface surface_of(const Moving &all, const ContactConstants &c, const WallContacts &contacts, const Walls &walls, Index e) {
    const Short p = contacts.element(e);
    return WallPlace(walls, contacts.wall(e)).surface(centre(all.pose.data, p), c.radius(p));
}

void press_wall(const Moving &all, const ContactConstants &c, const WallContacts &contacts, const Walls &walls,
                const ContactSums &to, Index e, double dt) {
    const Short p = contacts.element(e);
    const Index w = contacts.wall(e);
    const WallPlace wall(walls, w);
    const double rest = contacts.gap(e);
    const WallSurface now = surface_of(all, c, contacts, walls, e);
    for (Index x = 0; x < 4; x++) contacts.output(e, x) = 0.0;
    if (!(rest - now.gap > 0.0 || contacts.touch(e) == touching)) return;
    const Motion<double> moving(gather(all.motion.data, p));
    const AtWall who = {c.radius(p), moving.m, moving.w, moving.v - wall.velocity(), wall.growing()};
    WallSurface last = wall.surface(minus(centre(all.pose.data, p), dt, who.velocity), who.radius);
    last.gap += dt * who.growing;
    Vector *const memory = &contacts.memory.row<Vector>(e);
    ContactLoads<double> loads;
    with_law(c, [&](auto law) {
        loads = wall_loads(law, c, who, now, last, rest, walls.friction(w), {memory[0], memory[1]}, dt);
    });
    memory[0] = loads.memory.stretch, memory[1] = loads.memory.viscous;
    contacts.touch(e) = rest - now.gap > 0.0 ? touching : separate;
    const Vector f = loads.force, torque = -(who.radius + now.gap) * cross(now.normal, f);
    contacts.output.row<Vector>(e) = -f;
    contacts.output(e, 3) = dot(f, now.normal);
    for (Index x = 0; x < 3; x++) {
        to.sums(p, x) += f[x];
        to.sums(p, 4 + x) += torque[x];
    }
    to.sums(p, 3) += loads.damped;
    to.sums(p, 7) += loads.rubbed;
}

}  // namespace

void move_walls(const Turn &turn, const WallMotions &motions, const Walls &walls) {
    const double t = turn.clock.time, dt = turn.clock.dt;
    for (Index e = 0; e < motions.drive_wall.size(); e++) {
        const Index s = motions.drive_schedule(e);
        walls.body(motions.drive_wall(e), rate + motions.drive_component(e)) =
            motions.drive_rate(e) ? wanted(motions, s, t + 0.5 * dt) : (wanted(motions, s, t + dt) - wanted(motions, s, t)) / dt;
    }
    for (Index e = 0; e < motions.servo_wall.size(); e++) follow_servo(turn, motions, walls, e);
    kick(motions, walls, 0.5 * dt);
    for (Index w = 0; w < walls.body.size(); w++)
        for (Index c = 0; c < 4; c++) walls.body(w, c) += dt * walls.body(w, rate + c);
}

void press_walls(const Turn &turn, const Moving &all, const ContactConstants &c, const WallContacts &contacts,
                 const Walls &walls, const ContactSums &to) {
    for (Index e = contacts.start(turn.first); e < contacts.start(turn.last); e++)
        press_wall(all, c, contacts, walls, to, e, turn.clock.dt);
}

void measure_wall_overlaps(const Turn &turn, const Moving &all, const ContactConstants &c, const WallContacts &contacts,
                           const Walls &walls, const NearPairs &near, const Travel &travel) {
    if (!measures_anew(turn, near, travel)) return;
    double deepest = travel.portion(turn.block, 2);
    for (Index e = contacts.start(turn.first); e < contacts.start(turn.last); e++)
        deepest = most(deepest, (contacts.gap(e) - surface_of(all, c, contacts, walls, e).gap) / c.radius(contacts.element(e)));
    travel.portion(turn.block, 2) = deepest;
}

void load_walls(const Turn &turn, const WallContacts &contacts, const WallMotions &motions, const Walls &walls) {
    const double half = 0.5 * turn.clock.dt;
    const Index count = walls.body.size();
    for (Index w = 0; w < count; w++) {
        walls.body(w, wall_work) -= half * power(walls, w);
        for (Index c = 0; c < 4; c++) walls.body(w, wall_force + c) = 0.0;
        walls.body(w, normal_force) = 0.0;
    }
    for (Index e = 0; e < contacts.wall.size(); e++) {
        const Index w = contacts.wall(e);
        for (Index c = 0; c < 3; c++) walls.body(w, wall_force + c) += contacts.output(e, c);
        walls.body(w, normal_force) += contacts.output(e, 3);
    }
    for (Index w = 0; w < count; w++) {
        const WallPlace wall(walls, w);
        const double normal = walls.body(w, normal_force);
        if (!wall.flat()) walls.body(w, wall_force + 3) = wall.among() ? -normal : normal;
        walls.body(w, wall_work) -= half * power(walls, w);
    }
    kick(motions, walls, half);
}

void sum_wall_energies(const Turn &turn, const Moving &all, const ContactConstants &c, const WallContacts &contacts,
                       const Walls &walls, const ContactEnergies &energies) {
    double sum = 0.0;
    for (Index e = contacts.start(turn.first); e < contacts.start(turn.last); e++) {
        if (contacts.touch(e) != touching) continue;
        const double overlap = positive(contacts.gap(e) - surface_of(all, c, contacts, walls, e).gap);
        const Vector s = contacts.memory.row<const Vector>(e);
        with_law(c, [&](auto law) {
            sum += contact_energy(law.at_wall(c.radius(contacts.element(e)), overlap), c.soft, overlap, dot(s, s));
        });
    }
    energies.energy(turn.block) += sum;
}

void count_wall_work(const Turn &, const Walls &walls, const Portions &portions) {
    double supplied = 0.0;
    for (Index w = 0; w < walls.body.size(); w++) supplied += absolute(walls.body(w, wall_work));
    portions.budget(2) = supplied;
}

void write_walls(const Turn &turn, const Walls &walls, const Gauges &gauges, const HistoryRows &history) {
    for (Index w = 0; w < walls.body.size(); w++)
        history.record(turn.clock.record, column::work) += walls.body(w, wall_work);
    for (Index g = 0; g < gauges.quantity.size(); g++) {
        const Index quantity = gauges.quantity(g);
        if (quantity < gauge_of_wall::displacement) continue;
        write_wall(&walls.body(gauges.element(gauges.start(g)), 0), quantity,
                   &history.record(turn.clock.record, column::fixed_columns + 3 * g));
    }
}

}  // namespace bondem
