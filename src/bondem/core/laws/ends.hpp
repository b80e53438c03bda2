// Poses of two elements relative to the bond or facet between them.
#pragma once
#include "rotations.hpp"

namespace bondem {

template <class T> struct Ends {
    Vector3<T> branch;  // centre of j minus centre of i [m]
    Quaternion<T> i, j;  // orientations
};

}  // namespace bondem
