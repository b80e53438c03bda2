// Integrity of bonds that fail or soften. No other file writes the integrity of a bond.
#pragma once
#include "../../array.hpp"

namespace bondem {

template <class Bonds> inline void put_integrity(const Bonds &bonds, Index k, double left) { bonds.integrity(k) = left; }
// Sets the integrity of a beam. Beams that share their constants also store it over their rest length.
template <class Bonds> inline void put_integrity_of_beam(const Bonds &bonds, Index k, double left, double length) {
    put_integrity(bonds, k, left);
    if (bonds.per_length.size() > 0) bonds.per_length(k) = left / length;
}

}  // namespace bondem
