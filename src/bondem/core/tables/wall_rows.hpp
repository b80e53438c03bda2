// Rows of the tables of walls. Python views them as structured arrays with the names of these fields
// (`bondem/boundary/wall_rows.py`).
#pragma once
#include "../laws/rotations.hpp"

namespace bondem {

// Place, motion and loads of a wall.
struct WallRow {
    Vector displacement;  // of the point about which it turns [m]
    double growth;  // of its radius [m]
    Vector velocity;  // of the point about which it turns [m/s]
    double growth_rate;  // velocity of its growth [m/s]
    Vector force;  // force of the elements on the wall [N]
    double growth_force;  // of the elements on its radius [N]
    double work;  // work of the wall on the elements [J]
    double normal_force;  // sum of the normal forces [N]
    Quaternion<double> orientation;  // rotation since the reference
    Vector spin;  // angular velocity; within a step, the turn of the step over its duration [rad/s]
    Vector torque;  // of the elements about the point about which it turns [N·m]
    Vector momentum;  // angular momentum of a free wall about its centre [kg·m²/s]
};
// Shape of a wall in the reference, of a kind of `WallKind`.
struct WallShape {
    Vector point;  // a point of the wall [m]
    Vector axis;  // normal or axis of the wall, zero of a sphere [-]
    double radius;  // radius [m]
    double kind;  // `WallKind`
    double hole;  // radius of the hole of a disc [m]
    Vector about;  // the point about which it turns [m]
};
// Inverse mass and inertia of a free wall; zero for other walls.
struct WallInertia {
    double inverse_mass;  // [1/kg]
    Vector inverse_moment;  // of its principal moments; zero where it does not turn [1/(kg·m²)]
    Quaternion<double> principal;  // orientation of the principal axes in the reference
};
// Place of a wall when the list of contacts was made.
struct WallListed {
    Vector point;  // point of the wall, moved with it [m]
    Vector axis;  // axis of the wall, turned with it [-]
    double growth;  // [m]
    double farthest;  // distance of an element from the point [m]
};
// Force of an element on a wall.
struct WallLoad {
    Vector force;  // [N]
    double normal;  // component of the force along the normal [N]
    Vector torque;  // about the point about which the wall turns [N·m]
};

}  // namespace bondem
