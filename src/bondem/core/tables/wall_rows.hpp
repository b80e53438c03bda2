// Rows of the tables of walls. Python reads names and places of their numbers from here (`bondem/boundary/wall_rows.py`).
#pragma once
#include "../laws/rotations.hpp"

namespace bondem {

// Place, motion and loads of a wall.
struct WallRow {
    Vector displacement;  // of the point about which it turns [m]
    double growth;  // of its radius [m]
    Vector velocity;  // of that point [m/s]
    double growth_rate;  // [m/s]
    Vector force;  // of the elements [N]
    double growth_force;  // of the elements on its radius [N]
    double work;  // on the elements [J]
    double normal_force;  // sum of the normal forces [N]
    Quaternion<double> orientation;  // against the reference
    Vector spin;  // angular velocity; within a step, the turn of the step over its duration [rad/s]
    Vector torque;  // of the elements about the point about which it turns [N·m]
    Vector momentum;  // angular momentum of a free wall about its centre [kg·m²/s]
};
// Shape of a wall in the reference, of a kind of `WallKind`.
struct WallShape {
    Vector point;  // a point of it [m], and its normal or axis, zero of a sphere
    Vector axis;  // a point of it [m], and its normal or axis, zero of a sphere
    double radius;  // radius, and that of the hole of a disc [m]
    double kind;  // radius, and that of the hole of a disc [m]
    double hole;  // radius, and that of the hole of a disc [m]
    Vector about;  // the point about which it turns [m]
};
// Mass and inertia of a free wall; zero for other walls.
struct WallInertia {
    double inverse_mass;  // [1/kg]
    Vector inverse_moment;  // of its principal moments; zero where it does not turn [1/(kg·m²)]
    Quaternion<double> principal;  // orientation of the principal axes in the reference
};
// Place of a wall when the list of contacts was made.
struct WallListed {
    Vector point;
    Vector axis;
    double growth;  // [m]
    double farthest;  // distance of an element from the point [m]
};
// Force of an element on a wall.
struct WallLoad {
    Vector force;  // [N]
    double normal;  // its component along the normal [N]
    Vector torque;  // about the point about which the wall turns [N·m]
};

}  // namespace bondem
