// Contact of two faces a and b of cells that no facet joins: a spring along their mean normal.
//
//     u = ½ g·(n_b - n_a)      A_ab = w A_0 (1 - g²/R²)²      A_0 = 2 A_a A_b / (A_a + A_b),  R² = 3 (A_a + A_b) / 2π
//
// u is the overlap, and g the vector from the centroid of face a to that of face b. n is an outward normal, A the
// area of a face, and w the weight of the pair. Faces whose centroids are further apart than R do not overlap. The
// integral of A_ab over all lateral positions is A_a A_b for w = 1, as for the true polygons. The A_ab of two sets of
// faces that each cover a plane therefore add up to the area of the plane, on average.
//
// Energy: U = ½ κ A_ab (u - u0)², with the overlap u0 at which the contact began. κ = 2 κ_a κ_b / (κ_a + κ_b) follows
// from the stiffnesses per area of the facets of both faces. Forces and torques are its exact gradient: F
// (n_a - n_b) / 2 along the normals, with F = κ A_ab (u - u0), and 4 U (1 - g²/R²)⁻¹ g / R² where faces slide out of
// each other. Forces and torques on both cells have neither a resultant force nor a resultant moment.
//
// Signs: forces act on cell b. Limits: faces are assumed to be compact, and rotations within a step to be small.
#pragma once
#include "../vector3.hpp"

namespace bondem {

// A face of a cell in space.
struct CellFace {
    Vector arm, normal;  // from the centre of the cell to the centroid [m], outward [-]
    double area, stiffness;  // [m²], κ [N/m³]
};
// Two faces and their relative position.
struct TwoFaces {
    CellFace a, b;
    Vector branch, between;  // from the centre of cell a to that of b, and g [m]
    double overlap;  // u [m]
    double share;  // 1 - g²/R² [-]

    TwoFaces(const CellFace &a, const CellFace &b, Vector branch)
        : a(a), b(b), branch(branch), between(branch + b.arm - a.arm),
          overlap(0.5 * (dot(between, b.normal) - dot(between, a.normal))),
          share(1.0 - inverse_square() * dot(between, between)) {}
    double inverse_square() const { return 2.0943951023931953 / (a.area + b.area); }  // 1 / R²
    // A_ab of weight 1, 0 where the faces do not overlap [m²].
    double area() const {
        return share > 0.0 ? 2.0 * a.area * b.area / (a.area + b.area) * share * share : 0.0;
    }
};
// Force, torques and energy of two faces in contact.
struct FaceLoads {
    double kn, pressed;  // κ A_ab [N/m], F [N]
    double energy;  // [J]
    Vector normal, point;  // from a to b [-]; the middle of the centroids, from the centre of cell a [m]
    Vector force, torque_a, torque_b;  // [N, N·m]
};
// Contact of faces of weight w, whose overlap counts from u0; zero for faces that do not touch.
inline FaceLoads face_loads(const TwoFaces &at, double w, double u0) {
    const double overlap = at.overlap - u0, area = at.area();
    if (!(overlap > 0.0 && area > 0.0 && w > 0.0)) return {};
    const CellFace &a = at.a, &b = at.b;
    const double kn = w * area * 2.0 * a.stiffness * b.stiffness / (a.stiffness + b.stiffness), F = kn * overlap;
    const Vector n = 0.5 * (a.normal - b.normal);
    const Vector f = F * n + (2.0 * F * overlap * at.inverse_square() / at.share) * at.between;
    return {kn, F, 0.5 * F * overlap, (1.0 / length(n)) * n, 0.5 * (a.arm + at.branch + b.arm), f,
            (0.5 * F) * cross(a.normal, at.between) - cross(a.arm, f),
            cross(b.arm, f) - (0.5 * F) * cross(b.normal, at.between)};
}

}  // namespace bondem
