// Motion of an element at a wall, and the tangential spring and dashpot of their contact, in the frame of the wall.
#pragma once
#include "../../laws/contact.hpp"
#include "../beams/bonds.hpp"
#include "wall_shapes.hpp"

namespace bondem {

// An element at a wall, in the frame of the wall.
struct AtWall {
    double radius;
    Vector spin, velocity;  // angular velocity and velocity against the wall, at the place of the element
    double growing;  // of the wall towards the element [m/s]

    // Direction and velocity at the contact with the surface of the wall at a gap.
    Meeting<double> meeting(const WallSurface &at) const {
        return {at.normal, velocity - growing * at.normal - cross((radius + at.gap) * spin, at.normal)};
    }
};

// An element at a wall now and a step ago, and the memory of its contact, turned with the wall over the step.
struct SeenFromWall {
    AtWall now, last;
    WallSurface before;
    ContactMemory<double> memory;
};
// An element in the frame of a wall that turns; a separate function, so that other walls cost no more.
__attribute__((noinline)) inline SeenFromWall seen_from_turning(const WallPlace &wall, Vector place, const AtWall &who,
                                                                const ContactMemory<double> &memory, double dt) {
    const WallRow &row = wall.row;
    const auto with_wall = [&](Vector v) { return rotate(turned({1.0, 0.0, 0.0, 0.0}, dt * row.spin), v); };
    const Vector arm = place - wall.pivot(), before = with_wall(minus(arm, dt, who.velocity));
    const AtWall now = {who.radius, who.spin - row.spin, minus_cross(who.velocity, row.spin, arm), who.growing};
    const AtWall last = {who.radius, with_wall(who.spin) - row.spin,
                         minus_cross(with_wall(who.velocity), row.spin, before), who.growing};
    const ContactMemory<double> turned_memory = {with_wall(memory.stretch), with_wall(memory.viscous)};
    return {now, last, wall.surface(wall.pivot() + before, who.radius), turned_memory};
}
BONDEM_INLINE SeenFromWall seen_from(const WallPlace &wall, Vector place, double radius, const Motion<double> &moving,
                                     const ContactMemory<double> &memory, double dt) {
    const AtWall who = {radius, moving.w, moving.v - wall.row.velocity, wall.growing()};
    if (!is_zero(wall.row.spin)) return seen_from_turning(wall, place, who, memory, dt);
    return {who, who, wall.surface(minus(place, dt, who.velocity), radius), memory};
}

}  // namespace bondem
