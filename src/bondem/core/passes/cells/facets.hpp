// Access of passes to the facets of a table, for one facet or for one facet per SIMD lane.
#pragma once
#include "../../laws/cell.hpp"
#include "../../select.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/columns.hpp"
#include "../beams/bonds.hpp"

namespace bondem {

BONDEM_INLINE double widened(const int32_t *from, double) { return double(*from); }
BONDEM_INLINE double widened(const float *from, double) { return double(*from); }
#if defined(BONDEM_LANES)
BONDEM_INLINE Lanes widened(const int32_t *from, Lanes) { return load(from); }
BONDEM_INLINE Lanes widened(const float *from, Lanes) { return load(from); }
template <class Number> BONDEM_INLINE Dual<Lanes> widened(const Number *from, Dual<Lanes>) { return load(from); }
#endif

// Vector k, or vectors from k on, of a table with one row per axis.
template <class T, class Number> BONDEM_INLINE Vector3<T> three_rows(const Number *table, Index m, Index k) {
    return {widened(table + k, T{}), widened(table + m + k, T{}), widened(table + 2 * m + k, T{})};
}
template <class T> BONDEM_INLINE Vector3<T> lever_of(const int32_t *lever, Index m, const double *pitch, Index k) {
    const Vector3<T> whole = three_rows<T>(lever, m, k);
    return {pitch[0] * whole.x, pitch[1] * whole.y, pitch[2] * whole.z};
}

// Columns of the table of facets, read once before a loop.
struct FacetColumns {
    const int32_t *lever_i, *lever_j;
    const float *share_i, *share_j, *H;
    const double *integrity, *k;
    double pitch[3], period[6];
    Index m;

    explicit FacetColumns(const ElasticFacets &facets)
        : lever_i(facets.lever_i.data), lever_j(facets.lever_j.data), share_i(facets.share_i.data),
          share_j(facets.share_j.data), H(facets.H.data), integrity(facets.integrity.data), k(facets.k.data),
          m(facets.k.size()) {
        for (Index c = 0; c < 3; c++) pitch[c] = facets.pitch(c);
        for (Index c = 0; c < 6; c++) period[c] = facets.period(c);
    }
    template <class T> BONDEM_INLINE FacetShape<T> shape(Index at) const {
        return {lever_of<T>(lever_i, m, pitch, at), lever_of<T>(lever_j, m, pitch, at), three_rows<T>(share_i, m, at),
                three_rows<T>(share_j, m, at)};
    }
    // Constants of the energy times a factor, such as the integrity.
    template <class T> BONDEM_INLINE FacetStiffness<T> stiffness(Index at, T share) const {
        const float *h = H + at;
        const Symmetric3<T> whole = {widened(h, T{}),         widened(h + m, T{}),     widened(h + 2 * m, T{}),
                                     widened(h + 3 * m, T{}), widened(h + 4 * m, T{}), widened(h + 5 * m, T{})};
        return {share * number<T>(k, at), share * whole};
    }
};

// Stresses of the cells of a facet [Pa], times a factor, such as the integrity.
template <class T> BONDEM_INLINE OfCells<T> stresses_of(const Row<T> &i, const Row<T> &j, T share) {
    return {share * i.column[stress_column], share * j.column[stress_column]};
}

// The square of the force of a facet, which its bound limits [N²].
template <class T>
BONDEM_INLINE T pull_squared(const Row<T> &i, const Row<T> &j, const Ends<T> &ends, const FacetColumns &columns, Index k) {
    const T s = number<T>(columns.integrity, k);
    const Vector3<T> f = facet_pull(ends, columns.shape<T>(k), number<T>(columns.k, k), stresses_of(i, j, T{} + 1.0));
    return s * s * dot(f, f);
}

// The normal of a facet in the reference.
inline Vector normal_of(const ElasticFacets &facets, Index k) {
    return vector_at<double>(facets.normal.data, facets.normal.shape[1], 0, k);
}

#if defined(BONDEM_LANES)

// Calls on(k, known, i, j, ends) for each group of the facets first … last - 1 for which counts(k) is true, with the
// poses of their cells; later rows are prefetched.
template <class Pose, class Counts, class On>
BONDEM_INLINE void for_each_facets(Index first, const Index last, const Pose pose, const ElasticFacets &facets,
                                   const double *const period, Counts counts, On on) {
    constexpr Index ahead = 32;
    const Short *const i = facets.i.data, *const j = facets.j.data;
    const bool periodic = period[3] != 0.0 || period[4] != 0.0 || period[5] != 0.0;
    for_each_group(first, last, [&](Group group) __attribute__((always_inline)) {
        const Index k = group.first;
        prefetch(pose, i + least(k + ahead, most(last - lanes, Index(0))));
        if (!counts(k)) return;
        const auto rows = gather(pose, i + k, j + k);
        const auto &a = rows.first, &b = rows.second;
        Ends<LanesOf<Pose>> ends = {{b.column[0] - a.column[0], b.column[1] - a.column[1], b.column[2] - a.column[2]},
                                     orientation(a), orientation(b)};
        if (periodic) ends.branch = over_nearest_image(ends.branch, period);
        on(k, group.known, a, b, ends);
    });
}
template <class Pose, class On>
BONDEM_INLINE void for_each_facets(Index first, const Index last, const Pose pose, const ElasticFacets &facets,
                                   const double *const period, On on) {
    for_each_facets(first, last, pose, facets, period, [](Index) { return true; }, on);
}
// True if a facet of a group has a positive integrity.
BONDEM_INLINE bool any_left(const FacetColumns &columns, Index k) {
    return any(load(columns.integrity + k) != Lanes{});
}
// Adds the loads of the facets first … last - 1, in their order.
template <class Pose>
BONDEM_INLINE void add_loads_of_facets(Index first, Index last, Pose pose, const ElasticFacets &facets,
                                       const Short *row_i, const Short *row_j, double *const __restrict sums) {
    const FacetColumns columns(facets);
    for_each_facets(first, last, pose, facets, columns.period,
                    [&](Index k, int known, const auto &a, const auto &b, const auto &ends) __attribute__((always_inline)) {
        using T = LanesOf<Pose>;
        const T s = number<T>(columns.integrity, k);
        const auto loads = facet_loads(ends, columns.shape<T>(k), columns.stiffness<T>(k, s), stresses_of(a, b, s));
        add_loads_of(sums, row_i + k, row_j + k, loads, known);
    });
}

#endif

}  // namespace bondem
