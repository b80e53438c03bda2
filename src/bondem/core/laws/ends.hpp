// Two elements as the bond or the facet between them sees them.
#pragma once
#include "rotations.hpp"

namespace bondem {

template <class T> struct Ends {
    Vector3<T> branch;  // centre of j minus centre of i [m]
    Quaternion<T> i, j;  // orientations
};

}  // namespace bondem
