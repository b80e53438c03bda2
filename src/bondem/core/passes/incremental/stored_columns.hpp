// Access of passes to the stored forces and moments of beams of the incremental formulation, for one beam or for one
// beam per SIMD lane.
#pragma once
#include "../../laws/incremental.hpp"
#include "../../tables/incremental_tables.hpp"
#include "../beams/bonds.hpp"

namespace bondem {

// Columns of the stored loads of beams.
template <class T> class StoredColumns {
  public:
    explicit StoredColumns(const StoredLoads &stored) : first(stored.history.data), m(stored.history.shape[1]) {}

    BONDEM_INLINE StoredLoad<T> operator()(Index k) const {
        return {vector_at<T>(first, m, 0, k), vector_at<T>(first, m, 3, k)};
    }
    // Writes to one bond, or to those of a group that have not advanced with the previous group.
    template <class Place> BONDEM_INLINE void keep(Place place, const StoredLoad<T> &load) const {
        keep_vector(first, m, 0, place, load.force);
        keep_vector(first, m, 3, place, load.moment);
    }

  private:
    double *const first;
    const Index m;
};

template <class T>
BONDEM_INLINE StoredStiffness<T> stored_stiffness(const Beams &beams, const StoredLoads &stored, Index k) {
    return {number<T>(beams.kn.data, k), number<T>(beams.ks.data, k), number<T>(beams.kt.data, k),
            number<T>(stored.kb.data, k)};
}
template <class T> BONDEM_INLINE StoredShape<T> stored_shape(const Beams &beams, Index k) {
    return {number<T>(beams.length.data, k), number<T>(beams.lever.data, k)};
}

// Sums normal, shear, bending and twisting energy of the beams of a portion, by their stored loads [J].
void sum_stored_energies(const Range &range, const Moving &all, const Beams &beams, const StoredLoads &stored,
                         const Ledger &ledger);

}  // namespace bondem
