// Loads of a bond or facet, which a failure criterion evaluates, and the result of the criterion.
//
// A criterion is a function of these loads and of four coefficients, which Python computes once per bond
// (`bondem/damage/`). A criterion returns an index and a mode of failure. The bond fails where the index reaches 1.
// The index is proportional to the loads, or at least grows with them; the mode is that of its largest part.
#pragma once
#include "../../lanes.hpp"
#include "../../tables/columns.hpp"

namespace bondem {

// Loads of a bond, tension positive. A facet has an axial and a shear force only.
template <class T> struct BondLoads {
    T axial;  // force along the bond, or along the normal of the facet [N]
    T shear;  // size of the force across it [N]
    T bending, twisting;  // sizes of the moments [N·m]
    T strain;  // ℓ / L - 1 [-]
    T angle;  // the larger one between the axis and its ends [rad]
};
// Four coefficients of a bond.
template <class T> struct Coefficients {
    T a, b, c, d;
};
// A criterion on the loads of single bonds, and the properties in which criteria differ.
struct BondCriterion {
    static constexpr bool sees_angles = false;  // needs the angles at the ends of a beam, which cost time
    static constexpr bool of_facets = false;  // applies to facets of cells too (`needs_beams` is false in Python)
    static constexpr bool softens = false;  // beams may soften after reaching it (`pulled_and_sheared` in Python)
};
// Index and mode that a criterion returns.
template <class T> struct Verdict {
    T index;  // the bond fails at 1 [-]
    T mode;  // a `failure_mode`
};

template <class T> BONDEM_INLINE T constant(double value) { return T{} + value; }

}  // namespace bondem
