// Stiffness matrix of the facets of cells at rest. Also, for each cell, the row by which volume times dilatation of
// the cell follows from the motions of the cell and its neighbours.
#include "../../registered.hpp"
#include "../../tables/stiffness_tables.hpp"
#include "../../vector3.hpp"
#include "block_rows.hpp"

namespace bondem {
namespace {

// The matrix [b]×, with [b]× v = b × v.
struct Crossing {
    double entry[3][3];

    explicit Crossing(Vector b) : entry{{0.0, -b.z, b.y}, {b.z, 0.0, -b.x}, {-b.y, b.x, 0.0}} {}
    double operator()(Index r, Index c) const { return entry[r][c]; }
};

// Adds the stiffness of a facet to the diagonal block of one end, and sets the block that couples both ends.
//
// The gap of a facet is δ = Σ ±(u + φ × b) over its ends, + for j, and the energy ½ k δ² + ½ ρ·H ρ with ρ the
// relative rotation; `near` and `far` are [b]× of this end and of the other.
void put_blocks(const FacetRows &facets, Index facet, const Crossing &near, const Crossing &far, const Block &own,
                const Block &other) {
    const double k = facets.k(facet);
    for (Index r = 0; r < 3; r++)
        for (Index c = 0; c < 3; c++) {
            const double unit = r == c ? 1.0 : 0.0, H = facets.H(facet, r, c);
            double both = 0.0, mine = 0.0;  // -[near]× [far]× and -[near]× [near]×
            for (Index d = 0; d < 3; d++) {
                both -= near(r, d) * far(d, c);
                mine -= near(r, d) * near(d, c);
            }
            const double slip = k * near(r, c);
            own(r, c) += k * unit;
            own(r, 3 + c) -= slip;
            own(3 + r, c) += slip;
            own(3 + r, 3 + c) += k * mine + H;
            other(r, c) = -k * unit;
            other(r, 3 + c) = k * far(r, c);
            other(3 + r, c) = -slip;
            other(3 + r, 3 + c) = -k * both - H;
        }
}

// Adds the form by which the motion (u, φ) of an end contributes to V θ: sign · share·(u + φ × lever).
void add_form(Vector share, Vector lever, double sign, double *form) {
    const Vector moment = cross(lever, share);
    for (Index a = 0; a < 3; a++) {
        form[a] += sign * share[a];
        form[3 + a] += sign * moment[a];
    }
}

}  // namespace

// Fills the block rows of facets at rest, and those of the dilatation of cells.
Index assemble_facets(Index threads, const FacetRows &facets, const BlockRows &rows, const DilatationRows &dilatation) {
    const auto form = [&](Index slot) { return &dilatation.forms(slot, 0, 0); };
    const auto clear = [&](Index slot) {
        for (Index e = 0; e < 6; e++) form(slot)[e] = 0.0;
    };
    for_each_row(
        threads, rows, facets.i, facets.j, clear,
        [&](Index b, Index diagonal, Index slot) {
            const Vector near = facets.lever_j.row<const Vector>(b), far = facets.lever_i.row<const Vector>(b);
            const Vector share = facets.share_j.row<const Vector>(b);
            put_blocks(facets, b, Crossing(near), Crossing(far), block_at(rows, diagonal), block_at(rows, slot));
            clear(slot);
            add_form(share, near, 1.0, form(diagonal));
            add_form(share, far, -1.0, form(slot));
        },
        [&](Index b, Index diagonal, Index slot) {
            const Vector near = facets.lever_i.row<const Vector>(b), far = facets.lever_j.row<const Vector>(b);
            const Vector share = facets.share_i.row<const Vector>(b);
            put_blocks(facets, b, Crossing(near), Crossing(far), block_at(rows, diagonal), block_at(rows, slot));
            clear(slot);
            add_form(share, near, -1.0, form(diagonal));
            add_form(share, far, 1.0, form(slot));
        });
    return 0;
}
BONDEM_CALL(assemble_facets, "")

}  // namespace bondem
