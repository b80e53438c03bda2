// What quasi-static loading takes: facets of any integrity in small motions, and the search for those that fail next.
// Named once more in `bondem/statics/quasistatic/facet_passes.py`.
#pragma once
#include "../array.hpp"

namespace bondem {

using Byte = uint8_t;

// Facets, m of them, about the reference; see `bondem/interactions/cells/cell_constants.py`.
struct WeakenedFacets {
    Array<const Index, 1> i, j;  // (m,)
    Array<const double, 1> k;  // [N/m]
    Array<const double, 1> area;  // [m²]
    Array<const double, 1> part;  // part of cell i in the compliance [-]
    Array<const double, 2> lever_i, lever_j;  // [m], (m, 3)
    Array<const double, 2> share_i, share_j;  // A w m [m²]
    Array<const double, 2> normal;  // [-]
    Array<const double, 3> H;  // [N·m], (m, 3, 3)
    Array<const double, 1> integrity;  // [-]
    Array<const Byte, 2> closed;  // halves that press, (m, 2)
};
// Small motions of n cells, and what follows from them.
struct SmallMotions {
    Array<const double, 2> displacement, rotation;  // [m, rad], (n, 3)
    Array<double, 2> gap;  // of the facets [m], (m, 3)
    Array<double, 1> swelling;  // V θ of the cells [m³], to which facets add, (n,)
};
// Loads of facets and cells at given stresses.
struct FacetLoading {
    Array<const double, 1> stress;  // λ θ of the cells [Pa], (n,)
    Array<double, 2> traction;  // [Pa], (m, 3)
    Array<double, 1> bending;  // T_b of each facet, as if it were whole [Pa], (m,)
    Array<double, 2> opening;  // traction of facets that have lost integrity, as if they were whole [Pa], (m, 3)
    Array<double, 1> opened;  // |F⁺| / A of these [Pa], (m,)
    Array<Byte, 2> turned;  // halves of these that close or open, (m, 2)
    Array<double, 2> moment;  // V σ of the cells, to which facets add, xx, yy, zz, xy, xz, yz [J], (n, 6)
};
// Facets and cells under a load factor of 1.
struct LoadedFacets {
    Array<const Index, 1> i, j;  // (m,)
    Array<const double, 2> normal, traction;  // [-], [Pa], (m, 3)
    Array<const double, 1> bending;  // T_b [Pa], (m,)
    Array<const double, 2> tensor;  // σ of each cell, xx, yy, zz, xy, xz, yz [Pa], (n, 6)
    Array<const double, 1> strength;  // f_t [Pa], (m,)
};
// Which whole facets begin to crack, and at what load factors.
struct OnsetSearch {
    Array<const Index, 1> whole;  // (c,)
    double below;  // factors above it do not count
    double spread;  // how far above the least of all a factor may be, over it
    Array<double, 1> factor;  // inf of facets that are passed over, (c,)
};
// Sᵀ K S = B + Fᵀ W F of n cells with six motions each. Both have the same blocks in rows.
struct ScaledMatrix {
    Array<const Index, 1> start;  // first block of each row, (n + 1,)
    Array<const Index, 1> column;  // (b,)
    Array<const Index, 1> diagonal;  // block on the diagonal of each row; those after it are above the diagonal, (n,)
    Array<const double, 3> block;  // B, symmetric, (b, 6, 6)
    Array<const double, 2> form;  // F, (b, 6)
    Array<const float, 3> rounded_block;  // B in half the memory, (b, 6, 6)
    Array<const float, 2> rounded_form;  // F, (b, 6)
    Array<const double, 1> weight;  // W, (n,)
};
// Correction P (L Lᵀ)⁻¹ Pᵀ by clumps of cells that move rigidly, without the rigid motions of the body.
struct ClumpCorrection {
    Array<const Index, 1> place;  // first coarse unknown of the clump of each cell, (n,)
    Array<const Index, 1> order;  // place of each coarse unknown in L, (c,)
    Array<const double, 3> basis;  // P, (n, 6, 6)
    Array<const double, 2> factor;  // column j of L from the diagonal down, (c, w)
    Array<const double, 2> rigid;  // rigid motions that are free, orthonormal, (r, 6 n)
    Array<double, 1> coarse;  // (c,)
};
// Conjugate gradients from a guess to a solution x of Sᵀ K S x = f.
struct ConjugateGradients {
    Array<const double, 1> limits;  // |r| and r · z at which they end, (2,)
    Index most;  // largest number of rounds
    Array<double, 1> residual;  // f before, and its residual afterwards, (6 n,)
    Array<double, 1> found;  // x, (6 n,)
    Array<double, 2> work;  // z, p, K p and f, (4, 6 n)
    Array<double, 1> stress;  // W F p, (n,)
    Array<Index, 1> rounds;  // (1,)
    Array<double, 1> first;  // r · z at the beginning, (1,)
};

}  // namespace bondem
