// Walls as rigid bodies: their motion, and the forces between walls and elements. A contact is evaluated in the frame
// of its wall, which moves and turns with the wall.
//
// A driven wall follows its schedules. A servo is a wall of some mass on which a prescribed force acts against the
// force of the elements. A flat servo moves along its normal, and a round one changes its radius. A fraction of the
// unbalanced force resists this motion, and the speed is limited. A free wall moves by the forces of the elements and
// by given forces. One half of the change of momentum and angular momentum of a free wall precedes the motion of a
// step, the other half follows. In between the wall turns about its principal axes in the order 1 2 3 2 1 (Dullweber,
// Leimkuhler and McLachlan, J. Chem. Phys. 107, 1997). The work of a wall is the trapezoidal sum of its power.
#include "contact_passes.hpp"

#include "../../ledger.hpp"
#include "../../registered.hpp"
#include "../boundary/timeline.hpp"
#include "../../tables/columns.hpp"
#include "pairs.hpp"
#include "seen_from_wall.hpp"
#include "wall_shapes.hpp"

namespace bondem {
namespace {

double wanted(const WallMotions &motions, Index schedule, double t) {
    return value_at(Timeline{motions.times, motions.values, motions.start}, schedule, t);
}

void follow_drive(const Range &range, const WallMotions &motions, const Walls &walls, Index e) {
    const double t = range.clock.time, dt = range.clock.dt;
    const Index s = motions.drive_schedule(e), component = motions.drive_component(e);
    const double rate =
        motions.drive_rate(e) ? wanted(motions, s, t + 0.5 * dt) : (wanted(motions, s, t + dt) - wanted(motions, s, t)) / dt;
    WallRow &row = walls.body.row<WallRow>(motions.drive_wall(e));
    if (component < 3)
        row.velocity[component] = rate;
    else if (component == 3)
        row.growth_rate = rate;
    else
        row.spin = rate * motions.drive_axis.row<const Vector>(e);
}

void follow_servo(const Range &range, const WallMotions &motions, const Walls &walls, Index e) {
    const Index w = motions.servo_wall(e);
    const WallPlace wall(walls, w);
    WallRow &row = walls.body.row<WallRow>(w);
    const double dt = range.clock.dt, force = wanted(motions, motions.servo_schedule(e), range.clock.time + dt);
    const double missing = force - row.normal_force, moving = wall.towards_elements();
    const double resisting = motions.servo_damping(e) * absolute(missing);
    const double acting = missing - (moving > 0.0 ? resisting : moving < 0.0 ? -resisting : 0.0);
    const double inward = moving + dt * acting / motions.servo_mass(e);
    const double speed = within(inward, -motions.servo_speed(e), motions.servo_speed(e));
    if (wall.flat())
        row.velocity = speed * wall.axis();
    else
        row.growth_rate = wall.among() ? speed : -speed;
}

bool turns_freely(const WallInertia &inertia) { return !is_zero(inertia.inverse_moment); }

// Turns a free wall over dt by its angular momentum: about its principal axes one after the other, each turn exact.
void turn_freely(WallRow &row, const WallInertia &inertia, double dt) {
    Quaternion<double> frame = product(row.orientation, inertia.principal);
    Vector momentum = rotate(inverse(frame), row.momentum);
    const auto turn_about = [&](Index axis, double time) {
        Vector turn = {};
        turn[axis] = 0.5 * time * inertia.inverse_moment[axis] * momentum[axis];
        const HalfAngle<double> half = half_angle(dot(turn, turn));
        const Quaternion<double> by = {half.cosine, half.sinc * turn.x, half.sinc * turn.y, half.sinc * turn.z};
        frame = product(frame, by);
        momentum = rotate(inverse(by), momentum);
    };
    turn_about(0, 0.5 * dt);
    turn_about(1, 0.5 * dt);
    turn_about(2, dt);
    turn_about(1, 0.5 * dt);
    turn_about(0, 0.5 * dt);
    const Quaternion<double> next = product(frame, inverse(inertia.principal));
    const double scale = 1.5 - 0.5 * (next.w * next.w + next.x * next.x + next.y * next.y + next.z * next.z);
    row.spin = (1.0 / dt) * rotation_vector(product(next, inverse(row.orientation)));
    row.orientation = {scale * next.w, scale * next.x, scale * next.y, scale * next.z};
}

void move_wall(const Walls &walls, Index w, double dt) {
    WallRow &row = walls.body.row<WallRow>(w);
    const WallInertia &inertia = walls.inertia.row<const WallInertia>(w);
    for (Index c = 0; c < 3; c++) row.displacement[c] += dt * row.velocity[c];
    row.growth += dt * row.growth_rate;
    if (turns_freely(inertia))
        turn_freely(row, inertia, dt);
    else if (!is_zero(row.spin))
        row.orientation = turned(row.orientation, dt * row.spin);
}

// Inverse mass of a wall along a normal at an arm from the point about which it turns [1/kg]; 0 unless it is free.
double inverse_mass_at(const WallRow &row, const WallInertia &inertia, Vector arm, Vector normal) {
    if (!turns_freely(inertia)) return inertia.inverse_mass;
    const Vector lever = rotate(inverse(product(row.orientation, inertia.principal)), cross(arm, normal));
    return inertia.inverse_mass + dot(lever, each(inertia.inverse_moment, lever));
}

template <class Law>
ContactLoads<double> wall_loads(const Law &law, const ContactRow &of, const SeenFromWall &seen, const WallSurface &now,
                                double rest, double mass, double dt) {
    const double radius = seen.now.radius;
    const Overlaps<double> overlap = {positive(rest - now.gap), positive(rest - seen.before.gap)};
    const double before = law.at_wall(radius, overlap.before).kn;
    const auto k = contact_stiffness(law, law.at_wall(radius, overlap.now), before, of.soft, mass, overlap);
    const double twist = 0.5 * dot(seen.now.spin, now.normal);
    return contact_loads<Law::hardens>(k, of.friction, overlap.now, seen.now.meeting(now), seen.last.meeting(seen.before), twist,
                                       seen.memory, dt);
}

void press_wall(const Moving &all, const ContactConstants &c, const WallContacts &contacts, const Walls &walls,
                const ContactSums &to, Index e, double dt) {
    const Short p = contacts.element(e);
    const Index w = contacts.wall(e);
    const WallPlace wall(walls, w);
    const double rest = contacts.gap(e);
    const WallSurface now = surface_of(all, c, contacts, walls, e);
    WallLoad &output = contacts.output.row<WallLoad>(e);
    if (!(rest - now.gap > 0.0 || contacts.touch(e) == touching)) {
        output = {};
        return;
    }
    const double radius = c.radius(p);
    const Vector place = centre(all.pose.data, p), at = minus(place, radius + now.gap, now.normal) - wall.pivot();
    Vector *const memory = &contacts.memory.row<Vector>(e);
    const Motion<double> moving(gather(all.motion.data, p));
    SeenFromWall seen = seen_from(wall, place, radius, moving, {memory[0], memory[1]}, dt);
    seen.before.gap += dt * seen.now.growing;
    const double of_wall = inverse_mass_at(wall.row, walls.inertia.row<const WallInertia>(w), at, now.normal);
    const ContactRow &of = c.at_wall(p, w);
    ContactLoads<double> loads;
    with_law(c, of, [&](auto law) { loads = wall_loads(law, of, seen, now, rest, 1.0 / (moving.m + of_wall), dt); });
    memory[0] = loads.memory.stretch, memory[1] = loads.memory.viscous;
    contacts.touch(e) = rest - now.gap > 0.0 ? touching : separate;
    const Vector f = loads.force, torque = -(radius + now.gap) * cross(now.normal, f);
    output = {-f, dot(f, now.normal), -cross(at, f)};
    for (Index x = 0; x < 3; x++) {
        to.sums(p, x) += f[x];
        to.sums(p, 4 + x) += torque[x];
    }
    to.sums(p, load_column::damped) += loads.damped;
    to.sums(p, load_column::rubbed) += loads.rubbed;
}

}  // namespace

void kick_free(const WallMotions &motions, const Walls &walls, Index e, double dt) {
    WallRow &row = walls.body.row<WallRow>(motions.free_wall(e));
    for (Index c = 0; c < 3; c++) row.velocity[c] += dt * (row.force[c] + motions.free_force(e, c)) / motions.free_mass(e);
    if (!turns_freely(walls.inertia.row<const WallInertia>(motions.free_wall(e)))) return;
    row.momentum = plus(row.momentum, dt, row.torque + motions.free_torque.row<const Vector>(e));
}

void show_free_spin(const Walls &walls, Index w) {
    WallRow &row = walls.body.row<WallRow>(w);
    const WallInertia &inertia = walls.inertia.row<const WallInertia>(w);
    if (!turns_freely(inertia)) return;
    const Quaternion<double> frame = product(row.orientation, inertia.principal);
    row.spin = rotate(frame, each(inertia.inverse_moment, rotate(inverse(frame), row.momentum)));
}

void move_walls(const Range &range, const WallMotions &motions, const Walls &walls) {
    const double dt = range.clock.dt;
    for (Index e = 0; e < motions.drive_wall.size(); e++) follow_drive(range, motions, walls, e);
    for (Index e = 0; e < motions.servo_wall.size(); e++) follow_servo(range, motions, walls, e);
    for (Index e = 0; e < motions.free_wall.size(); e++) kick_free(motions, walls, e, 0.5 * dt);
    for (Index w = 0; w < walls.body.size(); w++) move_wall(walls, w, dt);
}
BONDEM_PASS(move_walls, of_rows, "")

void press_walls(const Range &range, const Moving &all, const ContactConstants &c, const WallContacts &contacts,
                 const Walls &walls, const ContactSums &to) {
    for (Index e = contacts.start(range.first); e < contacts.start(range.last); e++)
        press_wall(all, c, contacts, walls, to, e, range.clock.dt);
}
BONDEM_PASS(press_walls, of_elements, "own motion pose; changes sums")

// Keeps the deepest overlap over radius of the elements of a portion with a wall, in a step that measures distances.
void measure_wall_overlaps(const Range &range, const Moving &all, const ContactConstants &c, const WallContacts &contacts,
                           const Walls &walls, const NearPairs &near, const Travel &travel) {
    double &deepest = travel.portion(range.block, 2);
    if (measures_anew(range, near, travel)) deepest = deepest_at_walls(range, all, c, contacts, walls, deepest);
}
BONDEM_PASS(measure_wall_overlaps, of_elements, "")

void add_to_wall(const WallContacts &contacts, Index e) {
    const double *const load = &contacts.output(e, 0);
    const Index first = wall_sum::count * Index(contacts.wall(e));
    for (Index c = 0; c < wall_sum::count; c++)
        if (load[c] != 0.0) exact_sum(contacts.sums, first + c).add(load[c]);
}

void load_wall_by_sums(const WallContacts &contacts, const Walls &walls, Index w, double half) {
    const WallPlace wall(walls, w);
    WallRow &row = walls.body.row<WallRow>(w);
    row.work -= half * (moving_power(row) + turning_power(row));
    const auto sum = [&](Index c) { return exact_sum(contacts.sums, wall_sum::count * w + c).take(); };
    for (Index c = 0; c < 3; c++) row.force[c] = sum(wall_sum::force + c), row.torque[c] = sum(wall_sum::torque + c);
    row.normal_force = sum(wall_sum::normal);
    row.growth_force = 0.0;
    if (!wall.flat()) row.growth_force = wall.among() ? -row.normal_force : row.normal_force;
    row.work -= half * (moving_power(row) + turning_power(row));
}

// Sums the forces of elements on walls, adds their work, and closes the step of free walls.
void load_walls(const Range &range, const WallContacts &contacts, const WallMotions &motions, const Walls &walls) {
    const double half = 0.5 * range.clock.dt;
    for (Index e = 0; e < contacts.wall.size(); e++) add_to_wall(contacts, e);
    for (Index w = 0; w < walls.body.size(); w++) load_wall_by_sums(contacts, walls, w, half);
    for (Index e = 0; e < motions.free_wall.size(); e++) {
        kick_free(motions, walls, e, half);
        show_free_spin(walls, motions.free_wall(e));
    }
}
BONDEM_PASS(load_walls, of_rows, "")

void sum_wall_energies(const Range &range, const Moving &all, const ContactConstants &c, const WallContacts &contacts,
                       const Walls &walls, const Ledger &ledger) {
    add_up(ledger, history_column::contact, contacts.start(range.first), contacts.start(range.last), [&](Index e) {
        double energy = 0.0;
        if (contacts.touch(e) != touching) return energy;
        const double overlap = positive(contacts.gap(e) - surface_of(all, c, contacts, walls, e).gap);
        const Vector s = contacts.memory.row<const Vector>(e);
        const Short p = contacts.element(e);
        const ContactRow &of = c.at_wall(p, contacts.wall(e));
        with_law(c, of, [&](auto law) {
            energy = contact_energy(law.at_wall(c.radius(p), overlap), of.soft, overlap, dot(s, s));
        });
        return energy;
    });
}
BONDEM_PASS(sum_wall_energies, of_elements, "")

void count_wall_work(const Range &, const Walls &walls, const Ledger &ledger) {
    for (Index w = 0; w < walls.body.size(); w++)
        sum_of(ledger, history_column::work).add(absolute(walls.body.row<const WallRow>(w).work));
}
BONDEM_PASS(count_wall_work, of_rows, "")

void write_walls(const Range &range, const Walls &walls, const Gauges &gauges, const Ledger &ledger,
                 const HistoryRows &history) {
    for (Index w = 0; w < walls.body.size(); w++)
        sum_of(ledger, history_column::work).add(walls.body.row<const WallRow>(w).work);
    for (Index g = 0; g < gauges.quantity.size(); g++) {
        const Index quantity = gauges.quantity(g);
        if (quantity < wall_quantity::displacement) continue;
        write_wall(walls.body.row<const WallRow>(gauges.element(gauges.start(g))), quantity,
                   &history.record(range.clock.record, history_column::count + 3 * g));
    }
}
BONDEM_PASS(write_walls, of_rows, "")

}  // namespace bondem
