// Shape and place of a wall: its distance from the surface of a sphere, its power, and quantities that gauges record.
#pragma once
#include "../../tables/contact_tables.hpp"
#include "../record/reading.hpp"

namespace bondem {

inline bool is_zero(Vector v) { return v.x == 0.0 && v.y == 0.0 && v.z == 0.0; }
// Rotation vector of a unit quaternion [rad], of length at most π.
inline Vector rotation_vector(Quaternion<double> q) {
    return {gauge::rotation_component(q, 0), gauge::rotation_component(q, 1), gauge::rotation_component(q, 2)};
}

inline double moving_power(const WallRow &row) {
    double sum = 0.0;
    for (Index c = 0; c < 3; c++) sum += row.force[c] * row.velocity[c];
    sum += row.growth_force * row.growth_rate;
    return sum;
}
inline double turning_power(const WallRow &row) { return dot(row.torque, row.spin); }
inline Vector read_wall(const WallRow &row, Index quantity) {
    switch (quantity) {
        case wall_quantity::displacement: return row.displacement;
        case wall_quantity::velocity: return row.velocity;
        case wall_quantity::growth: return {row.growth, row.growth_force, row.normal_force};
        case wall_quantity::torque: return row.torque;
        case wall_quantity::rotation: return rotation_vector(row.orientation);
        case wall_quantity::angular_velocity: return row.spin;
        case wall_quantity::power: break;
        default: return row.force;
    }
    const double moving = -moving_power(row), turning = -turning_power(row);
    return {moving, turning, moving + turning};
}
inline void write_wall(const WallRow &row, Index quantity, double *to) {
    const Vector read = read_wall(row, quantity);
    for (Index c = 0; c < 3; c++) to[c] = read[c];
}

struct WallSurface {
    double gap;  // from the surface of the sphere to the wall [m]
    Vector normal;  // from the wall to the sphere
};

// One wall: its shape and place.
struct WallPlace {
    const WallShape &shape;
    const WallRow &row;

    WallPlace(const Walls &walls, Index w) : shape(walls.shape.row<const WallShape>(w)), row(walls.body.row<const WallRow>(w)) {}

    Index kind() const { return Index(shape.kind); }
    bool flat() const { return kind() == plane_wall || kind() == disc_wall; }
    // True if elements are outside of a round wall.
    bool among() const { return kind() == cylinder_among || kind() == sphere_among; }
    BONDEM_INLINE bool turned() const { return !is_zero({row.orientation.x, row.orientation.y, row.orientation.z}); }
    BONDEM_INLINE Vector axis() const { return turned() ? turned_axis() : shape.axis; }
    // Point about which a wall turns [m].
    Vector pivot() const { return shape.about + row.displacement; }
    // Vector from the point of a wall to a place [m].
    BONDEM_INLINE Vector from_point(Vector place) const {
        return turned() ? from_turned_point(place) : from_resting_point(place);
    }
    // Speed at which the wall grows towards the elements [m/s].
    double growing() const { return among() ? row.growth_rate : -row.growth_rate; }
    double towards_elements() const { return flat() ? dot(row.velocity, axis()) : growing(); }

    BONDEM_INLINE WallSurface surface(Vector centre, double radius) const {
        const bool turns = turned();
        const Vector d = turns ? from_turned_point(centre) : from_resting_point(centre);
        const Vector n = turns ? turned_axis() : shape.axis;  // zero of a sphere
        const double along = dot(d, n);
        if (kind() == plane_wall) return {along - radius, n};
        return beside_axis(d, n, along, radius);
    }

  private:
    BONDEM_INLINE Vector from_resting_point(Vector place) const { return place - shape.point - row.displacement; }
    // A separate function, so that walls that have not turned cost no more.
    __attribute__((noinline)) Vector turned_axis() const { return rotate(row.orientation, shape.axis); }
    __attribute__((noinline)) Vector from_turned_point(Vector place) const {
        return place - pivot() - rotate(row.orientation, shape.point - shape.about);
    }
    // Distance from a wall that is no plane, for a place at a given distance along its axis.
    __attribute__((noinline)) WallSurface beside_axis(const Vector &d, const Vector &n, double along, double radius) const {
        const Vector across = minus(d, along, n);
        const double distance = length(across);
        if (kind() == disc_wall) return disc(n, along, across, distance, radius);
        const double sign = among() ? 1.0 : -1.0, scale = distance > 0.0 ? sign / distance : 0.0;
        return {sign * (distance - shape.radius - row.growth) - radius, scale * across};
    }
    // Beside a disc the nearest place is its rim, or that of its hole.
    WallSurface disc(Vector n, double along, Vector across, double distance, double radius) const {
        const double past = most(distance - shape.radius, 0.0) - most(shape.hole - distance, 0.0);
        if (past == 0.0) return {along - radius, n};
        const double away = root(along * along + past * past), up = along / away;
        return {away - radius, plus(up * n, distance > 0.0 ? past / (distance * away) : 0.0, across)};
    }
};

// Surface of the wall of contact e, for the element of the contact.
inline WallSurface surface_of(const Moving &all, const ContactConstants &c, const WallContacts &contacts,
                              const Walls &walls, Index e) {
    const Short p = contacts.element(e);
    return WallPlace(walls, contacts.wall(e)).surface(centre(all.pose.data, p), c.radius(p));
}
// The deepest overlap over radius of the elements of a portion with a wall, at least `deepest` [-].
inline double deepest_at_walls(const Range &range, const Moving &all, const ContactConstants &c,
                               const WallContacts &contacts, const Walls &walls, double deepest) {
    for (Index e = contacts.start(range.first); e < contacts.start(range.last); e++) {
        const double overlap = contacts.gap(e) - surface_of(all, c, contacts, walls, e).gap;
        deepest = most(deepest, overlap / c.radius(contacts.element(e)));
    }
    return deepest;
}

// Largest displacement of a wall [m] since the list of contacts was made, for elements within reach of their
// places at that time.
//
// Every wall is a surface of revolution: a turn about its own axis moves nothing.
inline double travel_of_wall(const Walls &walls, Index w, double reach) {
    const WallPlace wall(walls, w);
    const WallListed &then = walls.listed.row<const WallListed>(w);
    const Vector moved = -wall.from_point(then.point);
    const double grown = absolute(wall.row.growth - then.growth);
    return length(moved) + grown + length(wall.axis() - then.axis) * (then.farthest + reach);
}

}  // namespace bondem
