// Moments M on regions, applied as forces f on points of elements. The moment of these forces about the centroid of
// the points is M:
//
//     f = w ω × s      J ω = M      J = Σ w (s² 1 - s⊗s)
//
// w is the weight of a point (Σ w = 1), s its present position from the centroid, and ω the solution of J ω = M. The
// forces have no resultant. Torques supply the part of M that forces cannot, such as the moment about a line on which
// all points lie.
#include "../../registered.hpp"
#include "following.hpp"

namespace bondem {
namespace {

// Square of the ratio to the trace of J below which the inertia about an axis counts as zero.
constexpr double none = 1e-8;

struct Point {
    Vector arm, place;  // from the centre of its element, and where it is [m]
};

Point point_of(const CoupleTable &couples, const Moving &all, Index k) {
    const Row<double> x = gather(all.pose.data, Short(couples.element(k)));
    const Vector arm = rotate(orientation(x), couples.arm.row<const Vector>(k));
    return {arm, Vector{x.column[0], x.column[1], x.column[2]} + arm};
}

// Rotation ω with J ω = m, zero about axes along which the points lie: (J² + ε² 1) ω = J m.
Vector turn_of(const CoupleTable &couples, const Moving &all, Index first, Index last, Vector centre, Vector m) {
    double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, xz = 0.0, yz = 0.0;
    for (Index k = first; k < last; k++) {
        const double w = couples.share(k);
        const Vector s = point_of(couples, all, k).place - centre;
        xx += w * (s.y * s.y + s.z * s.z);
        yy += w * (s.x * s.x + s.z * s.z);
        zz += w * (s.x * s.x + s.y * s.y);
        xy -= w * s.x * s.y;
        xz -= w * s.x * s.z;
        yz -= w * s.y * s.z;
    }
    const double size = xx + yy + zz;
    if (size <= 0.0) return {0.0, 0.0, 0.0};
    xx /= size, yy /= size, zz /= size, xy /= size, xz /= size, yz /= size;
    const Vector b = {xx * m.x + xy * m.y + xz * m.z, xy * m.x + yy * m.y + yz * m.z, xz * m.x + yz * m.y + zz * m.z};
    const double a = xx * xx + xy * xy + xz * xz + none, d = xy * xy + yy * yy + yz * yz + none;
    const double f = xz * xz + yz * yz + zz * zz + none;
    const double p = xx * xy + xy * yy + xz * yz, q = xx * xz + xy * yz + xz * zz, r = xy * xz + yy * yz + yz * zz;
    // cofactors of J² + ε² 1
    const double A = d * f - r * r, B = q * r - p * f, C = p * r - q * d;
    const double D = a * f - q * q, E = p * q - a * r, F = a * d - p * p;
    const double scale = 1.0 / (size * (a * A + p * B + q * C));
    return {scale * (A * b.x + B * b.y + C * b.z), scale * (B * b.x + D * b.y + E * b.z),
            scale * (C * b.x + E * b.y + F * b.z)};
}

void add_couple(const CoupleTable &couples, Index c, double amplitude, const Moving &all, const Rows &rows) {
    const Index first = couples.start(c), last = couples.start(c + 1);
    const Vector m = amplitude * couples.moment.row<const Vector>(c);
    Vector centre = {0.0, 0.0, 0.0};
    for (Index k = first; k < last; k++) centre = plus(centre, couples.share(k), point_of(couples, all, k).place);
    const Vector w = turn_of(couples, all, first, last, centre, m);
    Vector rest = m;
    for (Index k = first; k < last; k++) {
        const Point point = point_of(couples, all, k);
        const Vector s = point.place - centre, f = couples.share(k) * cross(w, s), about = cross(point.arm, f);
        rest = rest - cross(s, f);
        const Index r = couples.row(k);
        for (Index axis = 0; axis < 3; axis++) {
            rows.force(r, axis) += f[axis];
            rows.force(r, 3 + axis) += about[axis];
        }
    }
    for (Index k = first; k < last; k++)
        for (Index axis = 0; axis < 3; axis++) rows.force(couples.row(k), 3 + axis) += couples.share(k) * rest[axis];
}

}  // namespace

void follow_couples(const Range &range, const Timeline &timeline, const CoupleTable &couples, const Moving &all,
                    const Rows &rows) {
    for (Index c = 0; c < couples.schedule.size(); c++)
        add_couple(couples, c, value_at(timeline, couples.schedule(c), range.clock.time), all, rows);
}
BONDEM_PASS(follow_couples, of_rows, "ends pose; adds force")

}  // namespace bondem
