// Poses of two elements relative to the bond or facet between them.
#pragma once
#include "rotations.hpp"

namespace bondem {

template <class T> struct Ends {
    Vector3<T> branch;  // centre of j minus centre of i [m]
    Quaternion<T> i, j;  // orientations
};
// Adds the parts of the energy of a bond of integrity s.
template <class Energy> inline void add_energy(double *sum, double s, const Energy &whole) {
    sum[0] += s * whole.normal, sum[1] += s * whole.shear, sum[2] += s * whole.bending, sum[3] += s * whole.twisting;
}

}  // namespace bondem
