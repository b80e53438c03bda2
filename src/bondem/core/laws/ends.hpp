// Poses of the two elements of a bond or facet, and the force, torques and energy of the bond or facet.
#pragma once
#include "rotations.hpp"

namespace bondem {

template <class T> struct Ends {
    Vector3<T> branch;  // centre of j minus centre of i [m]
    Quaternion<T> i, j;  // orientations
};
// Force and torques of a bond on its elements.
template <class T> struct BeamLoads {
    Vector3<T> force;  // on j; its opposite on i [N]
    Vector3<T> on_i, on_j;  // torques [N·m]
};
// The energy of a bond in its four modes [J].
template <class T> struct BeamEnergy {
    T normal, shear, bending, twisting;
};

}  // namespace bondem
