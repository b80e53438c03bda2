// Tables of the passes that assemble stiffness matrices.
#pragma once
#include "../array.hpp"

namespace bondem {

// Beams at rest, m of them.
struct BeamRows {
    Array<const Short, 1> i;  // elements, i < j, (m,)
    Array<const Short, 1> j;  // elements, i < j, (m,)
    Array<const double, 2> direction;  // reference direction i→j [-], (3, m)
    Array<const double, 1> length;  // at rest [m], (m,)
    Array<const double, 1> lever;  // distance of the contact point from i [m], (m,)
    Array<const double, 1> kn;  // [N/m], (m,)
    Array<const double, 1> ks;  // [N/m], (m,)
    Array<const double, 1> kb;  // [N·m], (m,)
    Array<const double, 1> kt;  // [N·m], (m,)
};

// Constants of m facets, a row each; see `bondem.interactions.cells.cell_constants`.
struct FacetRows {
    Array<const Short, 1> i;  // cells, i < j, (m,)
    Array<const Short, 1> j;  // cells, i < j, (m,)
    Array<const double, 1> k;  // [N/m], (m,)
    Array<const double, 2> lever_i;  // from the centre of cell i to the facet [m], (m, 3)
    Array<const double, 2> lever_j;  // from the centre of cell j to the facet [m], (m, 3)
    Array<const double, 3> H;  // [N·m], (m, 3, 3)
    Array<const double, 2> share_i;  // share in V θ of cell i [m²], (m, 3)
    Array<const double, 2> share_j;  // share in V θ of cell j [m²], (m, 3)
};

// Block rows of a matrix, one per element: earlier neighbours, the diagonal, later neighbours.
struct BlockRows {
    Array<const Index, 1> in_start;  // bonds in_start[p] … in_start[p + 1] - 1 end in p, (n + 1,)
    Array<const Index, 1> out_start;  // bonds that begin in p are out_bond[out_start[p]] …, (n + 1,)
    Array<const Short, 1> out_bond;  // bonds by their first elements, (m,)
    Array<const int32_t, 1> indptr;  // where the blocks of each row begin, (n + 1,)
    Array<int32_t, 1> indices;  // column of each block, (blocks,)
    Array<double, 3> data;  // blocks of (u, θ) [N/m, N, N·m], (blocks, 6, 6)
};

// A small motion of each element, and the product of a stiffness with it.
struct StiffnessProduct {
    Array<const double, 2> given;  // displacements and rotations [m, rad], (n, 6)
    Array<double, 2> found;  // forces and torques [N, N·m], (n, 6)
    Array<double, 2> motion;  // displacement, change of λ θ, rotation, 0 [m, Pa, rad], (n, 8)
    Array<double, 2> sums;  // -force, 0, -torque, 0 [N, N·m], (n, 8)
};
// The second derivative of the energy of each bond by the motions (u, θ) of its two elements.
struct BondTangents {
    Array<double, 3> tangent;  // [N/m, N, N·m], (12, 12, m)
};

// Rows of the matrix by which V θ of cells follows from motions, with the blocks of `BlockRows`.
struct DilatationRows {
    Array<double, 3> forms;  // V θ under unit motions [m², m³], (blocks, 1, 6)
};

}  // namespace bondem
