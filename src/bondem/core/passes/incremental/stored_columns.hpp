// Access of passes to the stored loads of beams of the incremental formulation: one, or as many as there are lanes.
#pragma once
#include "../../laws/incremental.hpp"
#include "../../tables/incremental_tables.hpp"
#include "../beams/bonds.hpp"

namespace bondem {

// Columns of the stored loads of beams.
template <class T> class StoredColumns {
  public:
    explicit StoredColumns(const StoredLoads &stored) : first(stored.history.data), m(stored.history.shape[1]) {}

    BONDEM_INLINE StoredLoad<T> operator()(Index k) const { return {vector_at(0, k), vector_at(3, k)}; }
    BONDEM_INLINE void keep(Index k, const StoredLoad<T> &load) const {
        for (Index c = 0; c < 3; c++) {
            first[c * m + k] = load.force[c];
            first[(3 + c) * m + k] = load.moment[c];
        }
    }
#if defined(BONDEM_LANES)
    // Writes to the bonds of a group, except those of the previous group, which have advanced already.
    BONDEM_INLINE void keep(Group group, const StoredLoad<T> &load) const {
        for (Index c = 0; c < 3; c++) {
            store_behind(first + c * m + group.first, load.force[c], group.known);
            store_behind(first + (3 + c) * m + group.first, load.moment[c], group.known);
        }
    }
#endif

  private:
    BONDEM_INLINE Vector3<T> vector_at(Index c, Index k) const {
        const double *column = first + c * m + k;
        return {number<T>(column, 0), number<T>(column + m, 0), number<T>(column + 2 * m, 0)};
    }

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

}  // namespace bondem
