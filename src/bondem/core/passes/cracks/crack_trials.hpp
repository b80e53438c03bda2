// Cracks that are evaluated along the principal directions of the mean stress of their cells. Few of a list are, and
// finding directions is most of what evaluation costs: they are collected until there are as many as lanes.
#pragma once
#include "crack_places.hpp"

namespace bondem {

template <class T> BONDEM_INLINE T mask_number(Mask<T> a) { return select(a, all<T>(1.0), T{}); }

// The loads of a crack of integrity s, and how it softens.
template <class T> struct CrackTrial {
    T s;
    FacetTraction<T> load;
    Softening<T> tension;
    PlaneStrength<T> plane;
    T on_plane, fastest, open;  // open: 1 for a crack that may rest

    BONDEM_INLINE CrackStrength<T> by() const { return {tension, plane, on_plane > T{}}; }
};

// Whether loads soften a facet along no direction e. Its traction along e is at most |t_n| |n·e| + |t_s| √(1 - (n·e)²),
// with √3 b |n·e| of bending, and the strength along e is that of the facet times max(|n·e|, 0.2). Over the latter,
// all are largest at |n·e| = 1 or 0.2; numbers are rounded up.
template <class T> BONDEM_INLINE Mask<T> never_softens(const CrackTrial<T> &of, const FacetStrengths &strengths) {
    static_assert(least_slope == 0.2);
    const T across = dot(of.load.t, of.load.normal), along = root(positive(T(dot(of.load.t, of.load.t) - across * across)));
    const T most_traction = 1.000001 * absolute(across) + 4.9 * along + 1.7321 * of.load.bent;
    const T least = softens_at(of.s, of.tension.strength, of.tension.brittleness,
                               CurveShape{strengths.kink, strengths.steep});
    return (most_traction < least) & opposite(of.on_plane > T{});
}

// A crack is evaluated at once.
struct SingleTrials {
    template <class On>
    BONDEM_INLINE void add(const OneCrack &one, bool where, const CrackTrial<double> &trial, On on) const {
        if (where) on(one, true, trial);
    }
};

#if defined(BONDEM_LANES)

// Cracks of a portion that have been collected, a lane each.
struct CrackTrials {
    using Number = Lanes;
    static constexpr int columns = sizeof(CrackTrial<double>) / sizeof(double);
    Index count = 0;
    Index crack[lanes], place[lanes];
    Short i[lanes], j[lanes];
    CrackTrial<Lanes> trial;

    // Collects the cracks of a group that a mask names; calls on(*this, which, trials) whenever all lanes are used.
    template <class On>
    BONDEM_INLINE void add(const CrackGroup &group, Mask<Lanes> where, const CrackTrial<Lanes> &trials, On on) {
        if (!any(where)) return;
        const double *const from = reinterpret_cast<const double *>(&trials);
        group.where(where, [&](Index k, Index e, int n) {
            put(k, e, group.i[n], group.j[n], from + n);
            if (count == lanes) finish(on);
        });
    }
    template <class On> void finish(On on) {
        if (count == 0) return;
        const int known = int(count);
        const double *const first = reinterpret_cast<const double *>(&trial);
        while (count < lanes) put(crack[0], place[0], i[0], j[0], first);
        Lanes number;
        for (int n = 0; n < lanes; n++) number[n] = n;
        on(*this, number < all<Lanes>(known), trial);
        count = 0;
    }

    void flag(const Array<Byte, 1> &to, const Array<Index, 1> &of_portions, Index portion, Mask<Lanes> which,
              Byte value) const {
        if (!any(which)) return;
        where(which, [&](Index, Index e, int) { to(e) = value; });
        of_portions(portion) = 1;
    }
    template <class On> BONDEM_INLINE void where(Mask<Lanes> mask, On on) const {
        for (int n = 0; n < lanes; n++)
            if (mask[n] != 0) on(crack[n], place[n], n);
    }
    static BONDEM_INLINE double lane(Lanes a, int n) { return a[n]; }

  private:
    BONDEM_INLINE void put(Index k, Index e, Short at_i, Short at_j, const double *from) {
        double *const to = reinterpret_cast<double *>(&trial) + count;
        for (int c = 0; c < columns; c++) to[c * lanes] = from[c * lanes];
        crack[count] = k, place[count] = e, i[count] = at_i, j[count] = at_j;
        count++;
    }
};

#endif

}  // namespace bondem
