// Stiffness matrix of beams at rest, assembled in blocks of 6 × 6 by rows of blocks (`block_rows.hpp`).
#include "../../registered.hpp"
#include "../../tables/stiffness_tables.hpp"
#include "../../vector3.hpp"
#include "block_rows.hpp"

namespace bondem {
namespace {

// One beam, seen from one of its ends.
struct Beam {
    Vector X;  // from this end to the other
    double kn, ks, kb, kt;
    double near, far;  // levers of the contact point from this end and from the other [m]
};

// Adds the stiffness of a beam to the diagonal block of this end, and sets the block that couples both ends.
//
// With P = ks (1 - XX) + kn XX and S = [X]×, the gap at the contact point is
// δ = u_far - u_near + S (near θ_near + far θ_far), the relative rotation ρ = θ_far - θ_near, and the energy
// ½ δ·P δ + ½ ρ·(kt XX + kb (1 - XX)) ρ.
void put_blocks(const Beam &beam, const Block &own, const Block &other) {
    const Vector X = beam.X;
    const double S[3][3] = {{0.0, -X.z, X.y}, {X.z, 0.0, -X.x}, {-X.y, X.x, 0.0}};
    const double ks = beam.ks, near = beam.near, far = beam.far;
    for (Index r = 0; r < 3; r++)
        for (Index c = 0; c < 3; c++) {
            const double xx = X[r] * X[c], across = (r == c ? 1.0 : 0.0) - xx;
            const double P = beam.kn * xx + ks * across, Q = beam.kb * across + beam.kt * xx;
            const double slip = ks * near * S[r][c];  // as P S = ks S; and Sᵀ P S = ks (1 - XX)
            own(r, c) += P;
            own(r, 3 + c) -= slip;
            own(3 + r, c) += slip;
            own(3 + r, 3 + c) += ks * near * near * across + Q;
            other(r, c) = -P;
            other(r, 3 + c) = -ks * far * S[r][c];
            other(3 + r, c) = -slip;
            other(3 + r, 3 + c) = ks * (near * far) * across - Q;
        }
}

}  // namespace

// Fills the block rows of beams at rest.
Index assemble_beams(Index threads, const BeamRows &beams, const BlockRows &rows) {
    const auto beam = [&](Index k, double sign) {
        const Vector X = {sign * beams.direction(0, k), sign * beams.direction(1, k), sign * beams.direction(2, k)};
        const double from_i = beams.lever(k), from_j = beams.length(k) - beams.lever(k);
        return Beam{X, beams.kn(k), beams.ks(k), beams.kb(k), beams.kt(k), sign > 0.0 ? from_i : from_j,
                    sign > 0.0 ? from_j : from_i};
    };
    for_each_row(
        threads, rows, beams.i, beams.j, [](Index) {},
        [&](Index k, Index diagonal, Index slot) {
            put_blocks(beam(k, -1.0), block_at(rows, diagonal), block_at(rows, slot));
        },
        [&](Index k, Index diagonal, Index slot) {
            put_blocks(beam(k, 1.0), block_at(rows, diagonal), block_at(rows, slot));
        });
    return 0;
}
BONDEM_CALL(assemble_beams, "")

}  // namespace bondem
