// Tables of passes that evaluate laws of cracks and yielding for m samples, with a row per quantity.
#pragma once
#include "../array.hpp"

namespace bondem {

// Samples of facets that follow the softening curve (`laws/softening.hpp`).
struct SofteningSamples {
    // traction [Pa], normal, T_b [Pa], mean stress of both cells xx, yy, zz, xy, xz, yz [Pa]; f_t, 1 / T_l, c,
    // 1 / T_l of slip [Pa, 1/Pa], tan φ, 1 for one integrity in all directions; axes e_1, e_2, e_3; s_1, s_2, s_3,
    // grip; slip as a traction [Pa], distance of the faces over that of the cells [-]
    Array<const double, 2> given;  // (36, m)
    double kink;  // κ of the softening curve [-]
    double steep;  // m of the softening curve [-]
    Index wide;  // 1 to evaluate by lanes, 0 by single numbers
    // s_1, s_2, s_3 and grip after softening, and the traction below which s_1 does not fall [Pa]
    Array<double, 2> left;  // (5, m)
};
// Samples of cracks (`laws/crack.hpp`).
struct CrackSamples {
    // branch, orientations of i and j, levers of i and j, shares of i and j, normal; H, k, w; axes as a quaternion,
    // s_1, s_2, s_3, grip, 1 with friction; σ of i and j [Pa], slip in the frame of i [m], friction; integrities,
    // roots of energies and friction force before
    Array<const double, 2> given;  // (60, m)
    Index wide;  // 1 to evaluate by lanes, 0 by single numbers
    // force, torques on i and j, friction force, slip; three roots [√J], bending [J], torque of bending; energy across and
    // along; energy dissipated by the crack and by friction; V θ of the halves of i and j [m³]
    Array<double, 2> found;  // (28, m)
};
// Samples of cells that yield (`laws/plasticity.hpp`).
struct YieldSamples {
    Array<const double, 2> stress;  // [Pa], (6, m)
    Array<const double, 2> strength;  // cohesion [Pa], slope, dilation, stiffness [Pa], slip carried over, (5, m)
    Index cone;  // 1 for Drucker and Prager, 0 for Mohr and Coulomb
    Index wide;  // 1 to evaluate by lanes, 0 by single numbers
    // bound of F [Pa], Δγ, its part for the next step, strain xx, yy, zz, xy, xz, yz; principal stresses [Pa]; F plus
    // the cohesion [Pa]
    Array<double, 2> found;  // (13, m)
};
// Bounds of principal stresses, and of the opening traction of bending (`laws/stress.hpp`).
struct StressBoundSamples {
    Array<const double, 2> stress;  // [Pa], (6, m)
    Array<const double, 1> bent;  // T_b [Pa], (m,)
    Index wide;  // 1 to evaluate by lanes, 0 by single numbers
    // bounds of σ_1 and σ_3; T_b less the largest pressure, at least 0, and an upper bound of that [Pa]
    Array<double, 2> found;  // (4, m)
};

}  // namespace bondem
