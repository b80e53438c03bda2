// Elements whose forces are complete close the step, and open the next where it goes on without a pause:
//
//     close    v += finish a                       a = f / m, and so do the angular velocities with torque and inertia
//     open     v += begin a,   x += dt v + extra a
//
// The sums of the forces are left at zero. There are two kicks also where they could be one: no bit depends on where a
// run pauses.
#include "move.hpp"

#include "resisted.hpp"

namespace bondem {
namespace {

// Elements ahead of the loop whose rows are asked for.
constexpr Index ahead = 32;

BONDEM_INLINE Vector3<double> kicked(Vector3<double> v, double h, Vector3<double> a) { return plus(v, h, a); }
BONDEM_INLINE Vector3<Lanes> kicked(Vector3<Lanes> v, double h, Vector3<Lanes> a) { return plus(v, Lanes{} + h, a); }

template <class T> BONDEM_INLINE void kick(Motion<T> &moving, double h, Vector3<T> a, Vector3<T> b) {
    moving.v = kicked(moving.v, h, a);
    moving.w = kicked(moving.w, h, b);
}

template <class Who, class T> BONDEM_INLINE void keep(double *acceleration, const Who &who, Vector3<T> a, Vector3<T> b) {
    const T all[6] = {a.x, a.y, a.z, b.x, b.y, b.z};
    for (Index c = 0; c < 6; c++) put_number(acceleration, 6, c, who.element, all[c]);
}

// Adds the loss of the last step by the trapezoidal rule, which keeps the ledger second order.
template <class Who, class T> BONDEM_INLINE void add_loss(double *loss, const Who &who, double dt, T power) {
    const T taken = number_at(loss, 3, 0, who.element), before = number_at(loss, 3, 1, who.element);
    put_number(loss, 3, 0, who.element, taken + 0.5 * dt * (before + power));
    put_number(loss, 3, 1, who.element, power);
}

// What the elements `who` do; `row` is their row of the boundary and `resistance` what resists them, each or none.
template <class Who, class Boundary, class Resisted>
BONDEM_INLINE void move(const Who &who, const Clock &clock, const Moving &all, double *sums, const Boundary &row,
                        const Resisted &resistance, Index r) {
    using T = typename Who::Number;
    constexpr bool owns_row = sizeof(Boundary) > sizeof(NoRow), resisted = sizeof(Resisted) > sizeof(NoRow);
    double *const pose = all.pose.data, *const motion = all.motion.data;
    Wrench<T> load(gather(sums, who.row));
    Motion<T> moving(gather(motion, who.element));
    const Row<T> x = gather(pose, who.element);
    clear(sums, who.row);
    if constexpr (owns_row) {
        row.react(load.force, load.torque);
        row.add_work(0.5 * clock.dt, moving);
        const double *f = row.force;
        load.force = row.free(load.force + Vector{f[0], f[1], f[2]}, 0);
        load.torque = row.free(load.torque + Vector{f[3], f[4], f[5]}, 3);
    }
    const Wrench<T> whole = load;
    if constexpr (resisted)
        if (resistance.gamma != 0.0) {
            load.force = locally_damped(load.force, moving.v, resistance.gamma);
            load.torque = locally_damped(load.torque, moving.w, resistance.gamma);
        }
    Vector3<T> a = moving.m * load.force, b = moving.u * load.torque;
    const double *absorbing = nullptr;
    if constexpr (resisted)
        if (resistance.viscous) {
            Vector3<T> v = moving.v, w = moving.w;
            if constexpr (owns_row) {
                absorbing = absorbing_of(resistance, r);
                v = row.free(v, 0), w = row.free(w, 3);
            }
            resist(resistance, absorbing, clock.finish > 0.0 ? clock.finish : clock.begin, moving.m, v, w, a, b);
        }
    kick(moving, clock.finish, a, b);
    if constexpr (resisted) {
        T power = power_lost(whole, load, moving);
        if (resistance.viscous) {
            T more = {};  // of the dashpots of bonds
            if (resistance.dashed.size() > 0) {
                const Wrench<T> dash(gather(resistance.dashed.data, who.row));
                const T along = dot(dash.force, moving.v);
                more = -(dash.torque.z * moving.w.z + (dash.torque.y * moving.w.y + (dash.torque.x * moving.w.x + along)));
                clear(resistance.dashed.data, who.row);
            }
            Vector3<T> v = moving.v, w = moving.w;
            if constexpr (owns_row) v = row.free(v, 0), w = row.free(w, 3);
            power = power + viscous_power(resistance, absorbing, v, w, moving.m, moving.u, more);
        }
        add_loss(all.loss.data, who, clock.dt, power);
    }
    if constexpr (owns_row) row.drive(row.full, moving);
    if (!clock.goes_on) {
        keep(all.acceleration.data, who, a, b);
        scatter(motion, who.element, moving.row());
        return;
    }
    kick(moving, clock.begin, a, b);
    if constexpr (owns_row) {
        row.drive(row.half, moving);
        row.add_work(0.5 * clock.dt, moving);
    }
    scatter(pose, who.element, drifted(x, clock, moving, a, b));
    scatter(motion, who.element, moving.row());
}

template <class Resisted>
BONDEM_INLINE void move_free(const Turn &turn, const Moving &all, const StepCut &cut, const Resisted &resistance) {
    const Index last = turn.held;
    for (Index e = turn.first; e < last; e += lanes) {
        const Several later(turn, least(e + ahead, last - 1), last);
        prefetch(all.pose.data, later.element);
        prefetch(all.motion.data, later.element);
        move(Several(turn, e, last), turn.clock, all, cut.sums.data, NoRow{}, resistance, -1);
    }
}

template <class Resisted>
inline void move_held(const Turn &turn, const Moving &all, const StepCut &cut, const Rows &rows, const Resisted &resistance) {
    for (Index e = turn.held; e < turn.last; e++) {
        const One one(turn, e);
        const Index r = rows.of(one.element);
        move(one, turn.clock, all, cut.sums.data, BoundaryRow(rows, r), resistance, r);
    }
}

}  // namespace

void move_elements(const Turn &turn, const Moving &all, const StepCut &cut) { move_free(turn, all, cut, NoRow{}); }
void move_resisted(const Turn &turn, const Moving &all, const StepCut &cut, const Resistance &resistance) {
    move_free(turn, all, cut, resistance);
}
void move_rows(const Turn &turn, const Moving &all, const StepCut &cut, const Rows &rows) {
    move_held(turn, all, cut, rows, NoRow{});
}
void move_resisted_rows(const Turn &turn, const Moving &all, const StepCut &cut, const Rows &rows,
                        const Resistance &resistance) {
    move_held(turn, all, cut, rows, resistance);
}

namespace {

// An element opens a step by the acceleration that it kept.
template <class Boundary>
inline void open_one(Index p, const Clock &clock, const Moving &all, const Boundary &row) {
    const One one(p);
    const double *kept = &all.acceleration(p, 0);
    const Vector a = {kept[0], kept[1], kept[2]}, b = {kept[3], kept[4], kept[5]};
    Motion<double> moving(gather(all.motion.data, one.element));
    kick(moving, clock.begin, a, b);
    if constexpr (sizeof(Boundary) > sizeof(NoRow)) {
        row.drive(row.half, moving);
        row.add_work(0.5 * clock.dt, moving);
    }
    scatter(all.pose.data, one.element, drifted(gather(all.pose.data, one.element), clock, moving, a, b));
    scatter(all.motion.data, one.element, moving.row());
}

}  // namespace

void open_elements(const Turn &turn, const Moving &all) {
    for (Index p = turn.first; p < turn.last; p++) open_one(p, turn.clock, all, NoRow{});
}
void open_elements_and_rows(const Turn &turn, const Moving &all, const Rows &rows) {
    for (Index p = turn.first; p < turn.last; p++) {
        const Index r = rows.of(p);
        if (r < 0)
            open_one(p, turn.clock, all, NoRow{});
        else
            open_one(p, turn.clock, all, BoundaryRow(rows, r));
    }
}

void reopen_elements(const Turn &turn, const Moving &all) {
    for (Index e = turn.first; e < turn.held; e++) open_one(turn.element[e], turn.clock, all, NoRow{});
}
void reopen_rows(const Turn &turn, const Moving &all, const Rows &rows) {
    for (Index e = turn.held; e < turn.last; e++) {
        const Short p = turn.element[e];
        open_one(p, turn.clock, all, BoundaryRow(rows, rows.of(p)));
    }
}

}  // namespace bondem
