// Tables of quasi-static loading: facets of any integrity in small motions, and the search for their equilibrium.
#pragma once
#include "../array.hpp"

namespace bondem {

// Constants and states of m facets; see `bondem.interactions.cells.cell_constants`.
struct WeakenedFacets {
    Array<const Index, 1> i;  // (m,)
    Array<const Index, 1> j;  // (m,)
    Array<const double, 1> k;  // [N/m], (m,)
    Array<const double, 1> area;  // [m²], (m,)
    Array<const double, 1> part;  // part of cell i in the compliance [-], (m,)
    Array<const double, 2> lever_i;  // [m], (m, 3)
    Array<const double, 2> lever_j;  // [m], (m, 3)
    Array<const double, 2> share_i;  // A w m [m²], (m, 3)
    Array<const double, 2> share_j;  // A w m [m²], (m, 3)
    Array<const double, 2> normal;  // [-], (m, 3)
    Array<const double, 3> H;  // [N·m], (m, 3, 3)
    Array<const double, 1> integrity;  // [-], (m,)
    Array<const Byte, 2> closed;  // 1 for halves that press, (m, 2)
    Array<const double, 2> across;  // direction in which a facet softens alone, zero for all directions [-], (m, 3)
};
// Small motions of n cells, and their gaps and dilatations.
struct SmallMotions {
    Array<const double, 2> displacement;  // [m], (n, 3)
    Array<const double, 2> rotation;  // [rad], (n, 3)
    Array<double, 2> gap;  // of the facets [m], (m, 3)
    Array<double, 1> swelling;  // V θ of the cells [m³], to which facets add, (n,)
};
// Loads of facets and cells at given stresses.
struct FacetLoading {
    Array<const double, 1> stress;  // λ θ of the cells [Pa], (n,)
    Array<double, 2> traction;  // [Pa], (m, 3)
    Array<double, 1> bending;  // T_b of each facet, as if it were whole [Pa], (m,)
    Array<double, 2> opening;  // traction of facets that have lost integrity, as if they were whole [Pa], (m, 3)
    Array<double, 1> opened;  // |F⁺| / A of these facets [Pa], (m,)
    Array<Byte, 2> turned;  // 1 for halves of these facets that close or open, (m, 2)
    Array<double, 2> moment;  // V σ of the cells, to which facets add, xx, yy, zz, xy, xz, yz [J], (n, 6)
};
// Sᵀ K S = B + Fᵀ W F of n cells, in b blocks.
struct ScaledMatrix {
    Array<const Index, 1> start;  // first block of each row, (n + 1,)
    Array<const Index, 1> column;  // (b,)
    Array<const Index, 1> diagonal;  // block on the diagonal of each row; those after it are above the diagonal, (n,)
    Array<const double, 3> block;  // B, (b, 6, 6)
    Array<const double, 2> form;  // F, (b, 6)
    Array<const float, 3> rounded_block;  // B in half the memory, (b, 6, 6)
    Array<const float, 2> rounded_form;  // F in half the memory, (b, 6)
    Array<const double, 1> weight;  // W, (n,)
};
// Coarse correction by clumps of cells that move rigidly: c unknowns, and a factor L of half-width w - 1.
struct ClumpCorrection {
    Array<const Index, 1> place;  // first coarse unknown of the clump of each cell, (n,)
    Array<const Index, 1> order;  // place of each coarse unknown in L, (c,)
    Array<const double, 3> basis;  // motion of each cell per motion of its clump, (n, 6, 6)
    Array<const double, 2> factor;  // columns of L from the diagonal down, (c, w)
    Array<const double, 2> rigid;  // rigid motions that are free, orthonormal, (r, x)
    Array<double, 1> coarse;  // values of the coarse unknowns, (c,)
};
// State of conjugate gradients in 6 n unknowns.
struct ConjugateGradients {
    Array<const double, 1> limits;  // |r| and r·z at which the search ends, (2,)
    Index most;  // largest number of rounds
    Array<double, 1> residual;  // right-hand side before, residual afterwards, (x,)
    Array<double, 1> found;  // guess before, solution afterwards, (x,)
    Array<double, 2> work;  // z, p, K p and f, (4, x)
    Array<double, 1> stress;  // W F p, (n,)
    Array<Index, 1> rounds;  // number of rounds, (1,)
    Array<double, 1> first;  // r·z at the beginning, (1,)
};

}  // namespace bondem
