// Tables of the passes over bonds of the non-local law, in addition to `Beams`, which has their ends and integrity.
#pragma once
#include "../array.hpp"

namespace bondem {

// Bonds of the non-local law, m of them, the data that they store, and their present loads.
struct NonLocalBonds {
    Array<const double, 1> area;  // [m²], (m,)
    Array<const double, 1> kn;  // [N/m], (m,)
    Array<const double, 1> kt;  // [N/m], (m,)
    Array<const double, 2> normal;  // from i to j in the reference [-], (3, m)
    Array<const double, 2> lever_i;  // from the element i to the contact point in the reference [m], (3, m)
    Array<const double, 2> lever_j;  // from the element j to the contact point in the reference [m], (3, m)
    double nu;  // ν [-]
    Index limited;  // 1 to limit the extra shear force
    Array<double, 2> history;  // gap [m], extra force [N] and its work [J], in the frame of element i, (7, m)
    Array<double, 2> output;  // force on i, torque on i, minus torque on j, now [N, N·m], (9, m)
};
// Bonds at small strain, and the stresses and gaps of the iteration before.
struct SmallPairs {
    Array<const Index, 2> pairs;  // elements of each bond, (m, 2)
    Array<const double, 1> area;  // [m²], (m,)
    Array<const double, 1> kt;  // [N/m], (m,)
    double nu;  // ν [-]
    Index limited;  // 1 to limit the extra shear force
    Array<const double, 2> normal;  // [-], (m, 3)
    Array<const double, 2> stress;  // of the elements, xx, yy, zz, xy, xz, yz [Pa], (n, 6)
    Array<const double, 2> gap;  // [m], (m, 3)
};
// Springs and dashpots of bonds at small strain.
struct SmallSprings {
    Array<const double, 1> kn;  // [N/m], (m,)
    Array<const double, 2> lever_i;  // from the element i to the contact point [m], (m, 3)
    Array<const double, 2> lever_j;  // from the element j to the contact point [m], (m, 3)
    Array<const double, 1> along;  // dashpots along the normals [N·s/m], (m,)
    Array<const double, 1> across;  // dashpots across the normals [N·s/m], (m,)
};
// Steps of small motions (u, θ) of n elements; `stress` and `gap` are the arrays of `SmallPairs`.
struct SmallSteps {
    double dt;  // [s]
    double gamma;  // local damping [-]
    Array<const double, 2> weight;  // masses and moments of inertia [kg, kg·m²], (n, 6)
    Array<const double, 1> volume;  // V [m³], (n,)
    Array<double, 2> motion;  // [m, rad], (n, 6)
    Array<double, 2> speed;  // [m/s, rad/s], (n, 6)
    Array<double, 2> load;  // forces and torques [N, N·m], (n, 6)
    Array<double, 2> moment;  // V σ of the present forces [N·m], (n, 6)
    Array<double, 2> stress;  // of the elements, xx, yy, zz, xy, xz, yz [Pa], (n, 6)
    Array<double, 2> gap;  // [m], (m, 3)
    Array<double, 1> size;  // twice the kinetic energy after each step [J], (steps,)
};
// Extra forces of the bonds of the non-local law.
struct ExtraForces {
    Array<double, 2> force;  // [N], (m, 3)
};

}  // namespace bondem
