// Facets of any integrity s in small motions about the reference, without friction.
//
// A facet is two halves, one per cell p. A half that opens softens in all directions. A half that presses keeps its
// stiffness along the normal n. k is the stiffness of the facet, δ its gap, and s_p its share (`laws/cell.hpp`) in
// V θ, the volume of a cell times its dilatation. F is the force of a half at full integrity, w the part of the half
// in the compliance of the facet, and σ the stress of the cell.
//
//     F = k δ + σ s_p / w       opens: s F       presses: s F + (1 - s) (F · n) n
//     V θ += s (s_p · δ)        presses: and (1 - s) (s_p · n) (δ · n)
//
// A facet that softens in a single direction e keeps the force along its crack, and its pressure along e:
//
//     opens: F - (1 - s) (F · e) e        V θ += s_p · δ - (1 - s) (s_p · e) (δ · e)
//
// The force of the facet is the mean of the forces of both halves, weighted by their parts of the compliance.
#include "../../registered.hpp"
#include "../../symmetric3.hpp"
#include "../../tables/quasistatic_tables.hpp"

namespace bondem {
namespace {

// Least part of the force of a half along the normal, as a share of its size, that closes or opens the half.
constexpr double turns = 1e-9;

Vector at(const Array<const double, 2> &rows, Index k) { return rows.row<const Vector>(k); }

// Displacement of the face of a facet on cell p.
Vector end_of(const SmallMotions &motions, Index p, Vector lever) {
    return at(motions.displacement, p) + cross(at(motions.rotation, p), lever);
}

// Integrity of a facet, and its normal or the only direction in which it softens.
struct Weakened {
    double s;  // integrity
    Vector along;
    bool in_one;

    double whole(double left) const { return in_one ? 1.0 : left; }
    // Part of the loss that concerns `along` only: none of an open half, all of one that softens in one direction.
    double apart(double left, bool closed) const { return (double(closed) - double(in_one)) * (1.0 - left); }
    // Part of a force that a half of integrity `left` transmits.
    Vector transmitted(Vector force, double left, bool closed) const {
        return plus(whole(left) * force, apart(left, closed) * dot(force, along), along);
    }
};
Weakened weakened(const WeakenedFacets &facets, Index k) {
    const Vector across = at(facets.across, k);
    const bool in_one = dot(across, across) > 0.0;
    return {facets.integrity(k), in_one ? across : at(facets.normal, k), in_one};
}

double swollen(const Weakened &facet, bool closed, Vector share, Vector gap) {
    const double along = dot(share, facet.along) * dot(gap, facet.along);
    return facet.whole(facet.s) * dot(share, gap) + facet.apart(facet.s, closed) * along;
}

struct Half {
    Vector force, opening;  // force that the half transmits, and the part of F that opens it [N]
    bool turns;  // whether it closes or opens now
};
Half half_of(Vector whole, const Weakened &facet, bool closed) {
    const double along = dot(whole, facet.along), size = turns * length(whole);
    const Vector opening = whole - facet.transmitted(whole, 0.0, closed);
    return {facet.transmitted(whole, facet.s, closed), opening, closed ? along > size : along < -size};
}

void add_moment(const Array<double, 2> &moment, Index p, Vector arm, Vector force, double sign) {
    const Symmetric3<double> m = symmetric_product(arm, force);
    for (Index c = 0; c < 6; c++) moment(p, c) += sign * m[c];
}

}  // namespace

// Finds the gaps of facets, and adds V θ to their cells.
Index open_weakened_facets(Index, const WeakenedFacets &facets, const SmallMotions &motions) {
    for (Index k = 0; k < facets.k.size(); k++) {
        const Index i = facets.i(k), j = facets.j(k);
        const Vector gap = end_of(motions, j, at(facets.lever_j, k)) - end_of(motions, i, at(facets.lever_i, k));
        const Weakened facet = weakened(facets, k);
        motions.gap.row<Vector>(k) = gap;
        motions.swelling(i) += swollen(facet, facets.closed(k, 0), at(facets.share_i, k), gap);
        motions.swelling(j) += swollen(facet, facets.closed(k, 1), at(facets.share_j, k), gap);
    }
    return 0;
}
BONDEM_CALL(open_weakened_facets, "")

// Finds the loads of facets at the stresses of their cells, and adds sym(b⊗F), F the force on a cell, to its sum.
Index load_weakened_facets(Index, const WeakenedFacets &facets, const SmallMotions &motions, const FacetLoading &loading) {
    for (Index k = 0; k < facets.k.size(); k++) {
        const Index i = facets.i(k), j = facets.j(k);
        const double w = facets.part(k), v = 1.0 - w, per_area = 1.0 / facets.area(k);
        const Weakened facet = weakened(facets, k);
        const Vector spring = facets.k(k) * motions.gap.row<Vector>(k);
        const Vector g_i = loading.stress(i) * at(facets.share_i, k), g_j = loading.stress(j) * at(facets.share_j, k);
        Vector force = spring + g_i + g_j;
        loading.opened(k) = 0.0;
        loading.turned(k, 0) = loading.turned(k, 1) = 0;
        if (facet.s < 1.0) {
            loading.opening.row<Vector>(k) = per_area * force;
            const Half one = half_of(plus(spring, 1.0 / w, g_i), facet, facets.closed(k, 0));
            const Half two = half_of(plus(spring, 1.0 / v, g_j), facet, facets.closed(k, 1));
            force = plus(w * one.force, v, two.force);
            loading.opened(k) = length(plus(w * one.opening, v, two.opening)) / facets.area(k);
            loading.turned(k, 0) = one.turns;
            loading.turned(k, 1) = two.turns;
        }
        loading.traction.row<Vector>(k) = per_area * force;
        add_moment(loading.moment, i, at(facets.lever_i, k), force, 1.0);
        add_moment(loading.moment, j, at(facets.lever_j, k), force, -1.0);
        const Vector turn = at(motions.rotation, j) - at(motions.rotation, i);
        double square = 0.0;
        for (Index r = 0; r < 3; r++)
            square += turn[r] * dot(Vector{facets.H(k, r, 0), facets.H(k, r, 1), facets.H(k, r, 2)}, turn);
        loading.bending(k) = root(facets.k(k) * most(square, 0.0)) * per_area;  // slivers are below 0 by rounding
    }
    return 0;
}
BONDEM_CALL(load_weakened_facets, "")

}  // namespace bondem
