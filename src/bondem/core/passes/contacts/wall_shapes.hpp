// Where the surface of a sphere is from a wall.
#pragma once
#include "../../tables/contact_tables.hpp"
#include "../../vector3.hpp"

namespace bondem {

// Columns of a wall, and of its shape.
enum WallColumn : Index { growth = 3, rate = 4, wall_force = 8, wall_work = 12, normal_force = 13 };
enum ShapeColumn : Index { axis_column = 3, radius_column = 6, kind_column = 7, hole_column = 8 };
// A plane, a cylinder around the elements and one among them, a sphere around them and one among them, a disc.
enum WallKind : Index { plane_wall, cylinder_around, cylinder_among, sphere_around, sphere_among, disc_wall };

// What a gauge reads of a wall, beside the quantities of elements.
namespace gauge_of_wall {
enum Quantity : Index { displacement = 5, force, growth_and_force, velocity };
}
inline void write_wall(const double *body, Index quantity, double *to) {
    using namespace gauge_of_wall;
    const double *const from = quantity == displacement ? body : quantity == velocity ? body + rate : body + wall_force;
    for (Index c = 0; c < 3; c++) to[c] = from[c];
    if (quantity == growth_and_force) to[0] = body[growth], to[1] = body[wall_force + 3], to[2] = body[normal_force];
}

struct WallSurface {
    double gap;  // from the surface of the sphere to the wall [m]
    Vector normal;  // from the wall to the sphere
};

// One wall: its shape, and where it is.
struct WallPlace {
    const double *shape, *body;

    WallPlace(const Walls &walls, Index w) : shape(&walls.shape(w, 0)), body(&walls.body(w, 0)) {}

    Index kind() const { return Index(shape[kind_column]); }
    bool flat() const { return kind() == plane_wall || kind() == disc_wall; }
    // Whether elements are outside of a round wall.
    bool among() const { return kind() == cylinder_among || kind() == sphere_among; }
    Vector axis() const { return {shape[axis_column], shape[axis_column + 1], shape[axis_column + 2]}; }
    Vector velocity() const { return {body[rate], body[rate + 1], body[rate + 2]}; }
    // Speed at which the wall grows towards the elements [m/s].
    double growing() const { return among() ? body[rate + 3] : -body[rate + 3]; }
    double towards_elements() const { return flat() ? dot(velocity(), axis()) : growing(); }

    WallSurface surface(Vector centre, double radius) const {
        const Vector d = centre - Vector{shape[0], shape[1], shape[2]} - Vector{body[0], body[1], body[2]};
        const Vector n = axis();  // zero of a sphere
        const double along = dot(d, n);
        if (kind() == plane_wall) return {along - radius, n};
        const Vector across = minus(d, along, n);
        const double distance = length(across);
        if (kind() == disc_wall) return disc(n, along, across, distance, radius);
        const double sign = among() ? 1.0 : -1.0, scale = distance > 0.0 ? sign / distance : 0.0;
        return {sign * (distance - shape[radius_column] - body[growth]) - radius, scale * across};
    }

  private:
    // Beside a disc the nearest place is its rim, or that of its hole.
    WallSurface disc(Vector n, double along, Vector across, double distance, double radius) const {
        const double past = most(distance - shape[radius_column], 0.0) - most(shape[hole_column] - distance, 0.0);
        if (past == 0.0) return {along - radius, n};
        const double away = root(along * along + past * past), up = along / away;
        return {away - radius, plus(up * n, distance > 0.0 ? past / (distance * away) : 0.0, across)};
    }
};

}  // namespace bondem
