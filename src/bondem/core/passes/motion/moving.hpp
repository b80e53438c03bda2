// Motion of an element by the forces f on it: changes of its velocity v and position x that open and close a step.
//
//     open     v += begin a,   x += dt v + extra a        with a = f / m; angular velocities likewise
//     close    v += finish a
//
// `begin`, `extra` and `finish` are coefficients of the scheme (`StepScheme`), m the mass and dt the time step.
// Velocities change twice also where one change would do, so that no bit depends on where a run pauses.
#pragma once
#include "resisted.hpp"

namespace bondem {

template <class T> BONDEM_INLINE void kick(Motion<T> &moving, double h, Vector3<T> a, Vector3<T> b) {
    moving.v = plus(moving.v, T{} + h, a);
    moving.w = plus(moving.w, T{} + h, b);
}

template <class Who, class T> BONDEM_INLINE void keep(double *acceleration, const Who &who, Vector3<T> a, Vector3<T> b) {
    const T all[6] = {a.x, a.y, a.z, b.x, b.y, b.z};
    for (Index c = 0; c < 6; c++) put_number(acceleration, 6, c, who.element, all[c]);
}

// Adds the loss of the last step by the trapezoidal rule, which keeps the energy balance of second order.
template <class Who, class T> BONDEM_INLINE void add_loss(double *loss, const Who &who, double dt, T power) {
    const T taken = number_at(loss, 3, 0, who.element), before = number_at(loss, 3, 1, who.element);
    put_number(loss, 3, 0, who.element, taken + 0.5 * dt * (before + power));
    put_number(loss, 3, 1, who.element, power);
}

// Moves the elements `who` under a load; `row` is their row r of the boundary and `resistance` their damping, each
// `NoRow` for none.
template <class Who, class Boundary, class Resisted>
BONDEM_INLINE void move(const Who &who, const Clock &clock, const Moving &all, Wrench<typename Who::Number> load,
                        const Boundary &row, const Resisted &resistance, Index r) {
    using T = typename Who::Number;
    constexpr bool owns_row = sizeof(Boundary) > sizeof(NoRow), resisted = sizeof(Resisted) > sizeof(NoRow);
    double *const pose = all.pose.data, *const motion = all.motion.data;
    Motion<T> moving(gather(motion, who.element));
    const Row<T> x = gather(pose, who.element);
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

// Opens the step of an element by its stored acceleration.
template <class Boundary>
inline void open_one(Index p, const Clock &clock, const Moving &all, const Boundary &row) {
    const One one(p);
    const double *stored = &all.acceleration(p, 0);
    const Vector a = {stored[0], stored[1], stored[2]}, b = {stored[3], stored[4], stored[5]};
    Motion<double> moving(gather(all.motion.data, one.element));
    kick(moving, clock.begin, a, b);
    if constexpr (sizeof(Boundary) > sizeof(NoRow)) {
        row.drive(row.half, moving);
        row.add_work(0.5 * clock.dt, moving);
    }
    scatter(all.pose.data, one.element, drifted(gather(all.pose.data, one.element), clock, moving, a, b));
    scatter(all.motion.data, one.element, moving.row());
}

}  // namespace bondem
