// Rigid walls around a packing: force on a sphere without the part that walls carry, and return of spheres from
// beyond walls.
//
// `PackingWalls` describes flat walls, a round wall, and any other shape by the depth below its walls on a grid.
#pragma once
#include "../../tables/packing_tables.hpp"
#include "../../vector3.hpp"

namespace bondem {

// Largest gap to a wall of the grid, over the radius of a sphere, at which they touch.
constexpr double touch = 1e-6;
// Largest number of rounds of `carried_by_grid`: walls at a right angle need one, walls at 45° about 30.
constexpr int most_rounds = 30;

inline bool has_grid(const PackingWalls &walls) { return walls.depth.all() > 0; }

// Flat walls and the round wall, read once for many spheres.
struct PlainWalls {
    Vector lower, upper, weight;
    double radius;

    explicit PlainWalls(const PackingWalls &walls) : radius(walls.radius) {
        for (Index a = 0; a < 3; a++) {
            lower[a] = walls.lower(a);
            upper[a] = walls.upper(a);
            weight[a] = walls.weight(a);
        }
    }
    double round_distance(Vector x) const {
        return root(weight.x * x.x * x.x + weight.y * x.y * x.y + weight.z * x.z * x.z);
    }
    Vector round_normal(Vector x, double rho) const { return each(weight, x) / rho; }

    // The force on a sphere without the parts that touching flat walls and the round wall carry.
    Vector carried(Vector x, double r, Vector force) const {
        const double near = r * (1.0 + 1e-12);
        for (Index a = 0; a < 3; a++)
            if ((x[a] - lower[a] <= near && force[a] < 0.0) || (upper[a] - x[a] <= near && force[a] > 0.0)) force[a] = 0.0;
        const double rho = round_distance(x);
        if (radius - rho <= near) {
            const Vector normal = round_normal(x, rho);
            force = minus(force, most(dot(force, normal), 0.0), normal);
        }
        return force;
    }
    // The part of a direction along the flat walls that a sphere touches.
    Vector along_touched(Vector x, double r, Vector direction) const {
        const double near = r * (1.0 + 1e-12);
        for (Index a = 0; a < 3; a++)
            if (x[a] - lower[a] <= near || upper[a] - x[a] <= near) direction[a] = 0.0;
        return direction;
    }
    // Moves a sphere back to the walls that it has passed; its velocity into them is lost.
    void keep_within(double r, Vector &x, Vector &v) const {
        for (Index a = 0; a < 3; a++) {
            if (x[a] < lower[a] + r) {
                x[a] = lower[a] + r;
                v[a] = most(v[a], 0.0);
            }
            if (x[a] > upper[a] - r) {
                x[a] = upper[a] - r;
                v[a] = least(v[a], 0.0);
            }
        }
        const double rho = round_distance(x);
        if (rho > radius - r) {
            const Vector normal = round_normal(x, rho);
            const double inward = rho - (radius - r), out = most(dot(v, normal), 0.0);
            x = minus(x, inward, normal);
            v = minus(v, out, normal);
        }
    }
};

struct Depth {
    double depth;
    Vector gradient;
};

struct Spline {
    double value[3], slope[3];

    // Quadratic B-spline at t in -0.5 … 0.5 from the nearest node: weights of the node before, at and after it.
    explicit Spline(double t)
        : value{0.5 * (0.5 - t) * (0.5 - t), 0.75 - t * t, 0.5 * (0.5 + t) * (0.5 + t)},
          slope{t - 0.5, -2.0 * t, t + 0.5} {}
};

// Depth at a point and its gradient, smooth over the grid; where it is more than two spacings above `enough`, only
// the depth of the nearest node, with zero gradient.
inline Depth grid_depth(const PackingWalls &walls, Vector x, double enough) {
    const double h = walls.spacing;
    double at[3];
    Index node[3];
    for (Index a = 0; a < 3; a++) {
        at[a] = (x[a] - walls.corner(a)) / h;
        node[a] = within(Index(at[a] + 0.5), Index(1), walls.depth.shape[a] - 2);
    }
    const double coarse = walls.depth(node[0], node[1], node[2]);
    if (coarse > enough + 2.0 * h) return {coarse, {0.0, 0.0, 0.0}};
    // The gradient has no jump, because a sphere would oscillate between two normals.
    const Spline u(within(at[0] - double(node[0]), -0.5, 0.5)), v(within(at[1] - double(node[1]), -0.5, 0.5)),
        w(within(at[2] - double(node[2]), -0.5, 0.5));
    Depth found = {0.0, {0.0, 0.0, 0.0}};
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++)
            for (int c = 0; c < 3; c++) {
                const double value = walls.depth(node[0] + a - 1, node[1] + b - 1, node[2] + c - 1);
                found.depth += u.value[a] * v.value[b] * w.value[c] * value;
                found.gradient.x += u.slope[a] * v.value[b] * w.value[c] * value;
                found.gradient.y += u.value[a] * v.slope[b] * w.value[c] * value;
                found.gradient.z += u.value[a] * v.value[b] * w.slope[c] * value;
            }
    return {found.depth, found.gradient / h};
}

inline double steepness(Vector gradient) { return most(dot(gradient, gradient), 0.01); }

// The force on a sphere without the parts that touching plain walls and the wall of the grid carry. With both, the
// rest is the projection of the force onto the free directions of motion: the carried parts are found in turn, until
// that of the grid is constant. Without this projection a sphere in a wedge is never at rest.
inline Vector carried_by_grid(const PlainWalls &plain, const PackingWalls &walls, Vector x, double r, Vector force) {
    Vector left = plain.carried(x, r, force);
    const Depth at = grid_depth(walls, x, r);
    if (at.depth > r * (1.0 + touch)) return left;
    const double steep = steepness(at.gradient), enough = 1e-9 * length(force);
    double out = least(dot(left, at.gradient), 0.0) / steep;
    for (int round = 0; round < most_rounds; round++) {
        const Vector pressing = minus(force, out, at.gradient);
        left = plain.carried(x, r, pressing);
        const double next = out + least(dot(left, at.gradient) / steep, -out);
        if (absolute(next - out) <= enough) break;
        out = next;
    }
    return left;
}

// Moves a sphere beyond the wall of the grid back to it by three Newton steps; its velocity into the wall is lost. A
// sphere that touches flat walls moves along them, or each wall in turn would push it off the other.
inline void keep_on_grid(const PlainWalls &plain, const PackingWalls &walls, double r, Vector &x, Vector &v) {
    bool beyond = false;
    double steep = 1.0;
    Vector gradient = {0.0, 0.0, 0.0}, along = gradient;
    for (int step = 0; step < 3; step++) {
        const Depth at = grid_depth(walls, x, r);
        gradient = at.gradient;
        beyond = beyond || at.depth < r;
        if (!beyond) return;
        along = plain.along_touched(x, r, gradient);
        steep = steepness(along);
        x = x + ((r - at.depth) * along) / steep;
    }
    const double out = least(dot(v, gradient), 0.0) / steep;
    v = minus(v, out, along);
}

}  // namespace bondem
