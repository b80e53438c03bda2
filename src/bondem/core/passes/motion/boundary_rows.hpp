// Loads, reactions and prescribed velocities of an element with boundary conditions, in its row of the table `Rows`.
#pragma once
#include "elements.hpp"

namespace bondem {

// A row of the boundary; six components are force or velocity along x, y, z, then torque or angular velocity.
struct BoundaryRow {
    const Byte *fixed;  // which components have prescribed motion
    double *force, *half, *full, *reaction, *work;

    BoundaryRow(const Rows &rows, Index r)
        : fixed(&rows.fixed(r, 0)), force(&rows.force(r, 0)), half(&rows.half(r, 0)), full(&rows.full(r, 0)),
          reaction(&rows.reaction(r, 0)), work(&rows.work(r)) {}

    Vector free(Vector a, Index first) const {
        return {fixed[first] ? 0.0 : a.x, fixed[first + 1] ? 0.0 : a.y, fixed[first + 2] ? 0.0 : a.z};
    }
    // Stores the reaction, the negative force and torque of the bonds.
    void react(Vector f, Vector t) const {
        const double all[6] = {-f.x, -f.y, -f.z, -t.x, -t.y, -t.z};
        for (Index c = 0; c < 6; c++) reaction[c] = all[c];
    }
    // Adds the work of loads and reactions over half a step.
    void add_work(double half_step, const Motion<double> &moving) const {
        const auto bears = [&](Index c) { return fixed[c] ? reaction[c] : force[c]; };
        const Vector v = moving.v, w = moving.w;
        const double power = bears(0) * v.x + bears(1) * v.y + bears(2) * v.z + bears(3) * w.x + bears(4) * w.y + bears(5) * w.z;
        *work += half_step * power;
    }
    // Sets the prescribed velocities, and adds the change of kinetic energy to the work.
    void drive(const double *velocity, Motion<double> &moving) const {
        const auto gain = [&](Index c, double now) { return fixed[c] ? velocity[c] * velocity[c] - now * now : 0.0; };
        const Vector v = moving.v, w = moving.w;
        const double translation = gain(0, v.x) + gain(1, v.y) + gain(2, v.z);
        const double rotation = gain(3, w.x) + gain(4, w.y) + gain(5, w.z);
        *work += 0.5 * (translation / moving.m + rotation / moving.u);
        for (Index axis = 0; axis < 3; axis++) {
            if (fixed[axis]) moving.v[axis] = velocity[axis];
            if (fixed[3 + axis]) moving.w[axis] = velocity[3 + axis];
        }
    }
};

}  // namespace bondem
