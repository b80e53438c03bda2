// Integrity of bonds that fail or soften. No other place writes an integrity.
#pragma once
#include "../../array.hpp"

namespace bondem {

template <class Bonds> inline void put_integrity(const Bonds &bonds, Index k, double left) { bonds.integrity(k) = left; }
// Beams that share their constants have their integrity over the rest length, too.
template <class Bonds> inline void put_integrity_of_beam(const Bonds &bonds, Index k, double left, double length) {
    put_integrity(bonds, k, left);
    if (bonds.per_length.size() > 0) bonds.per_length(k) = left / length;
}

}  // namespace bondem
