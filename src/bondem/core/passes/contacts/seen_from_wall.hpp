// How an element and what its contact remembers look from a wall that may turn.
#pragma once
#include "../../laws/contact.hpp"
#include "../beams/bonds.hpp"
#include "wall_shapes.hpp"

namespace bondem {

// An element at a wall, as one that turns with the wall sees it.
struct AtWall {
    double radius;
    Vector spin, velocity;  // angular velocity and velocity against the wall, at the place of the element
    double growing;  // of the wall towards the element [m/s]

    // Direction and velocity at the contact, where the wall is so far from the surface.
    Meeting<double> meeting(const WallSurface &at) const {
        return {at.normal, velocity - growing * at.normal - cross((radius + at.gap) * spin, at.normal)};
    }
};

// The same now and a step ago, and what the contact knew then, turned with the wall since.
struct SeenFromWall {
    AtWall now, last;
    WallSurface before;
    ContactMemory<double> memory;
};
inline SeenFromWall seen_from(const WallPlace &wall, Vector place, double radius, const Motion<double> &moving,
                       const ContactMemory<double> &memory, double dt) {
    const WallRow &row = wall.row;
    const Vector velocity = moving.v - row.velocity;
    const AtWall who = {radius, moving.w, velocity, wall.growing()};
    if (is_zero(row.spin)) return {who, who, wall.surface(minus(place, dt, velocity), radius), memory};
    const auto with_wall = [&](Vector v) { return rotate(turned({1.0, 0.0, 0.0, 0.0}, dt * row.spin), v); };
    const Vector arm = place - wall.pivot(), came = with_wall(minus(arm, dt, velocity));
    const AtWall now = {radius, moving.w - row.spin, minus_cross(velocity, row.spin, arm), who.growing};
    const AtWall last = {radius, with_wall(moving.w) - row.spin, minus_cross(with_wall(velocity), row.spin, came), who.growing};
    return {now, last, wall.surface(wall.pivot() + came, radius), {with_wall(memory.stretch), with_wall(memory.viscous)}};
}

}  // namespace bondem
