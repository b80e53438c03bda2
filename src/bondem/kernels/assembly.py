"""The stiffness matrix at rest, straight into block-sparse rows."""

import numpy as np

from bondem._compile import device, kernel, prange
from bondem.kernels.tables import Adjacency, Bonds


@device
def _blocks(x, y, z, kn, ks, kb, kt, near, far, own, other):
    """Diagonal block of one end and the off-diagonal block towards the other end, for bond direction (x, y, z).

    With P = ks (1 - XX) + kn XX and S = [X]×, the slip at the contact point is δ = u_far - u_near +
    S (near θ_near + far θ_far) and the relative rotation ρ = θ_far - θ_near; the energy is ½ δ·P δ plus
    ½ ρ·(kt XX + kb (1 - XX)) ρ. X points from this end to the other.
    """
    for r in range(3):
        for c in range(3):
            xx = (x if r == 0 else (y if r == 1 else z)) * (x if c == 0 else (y if c == 1 else z))
            unit = 1.0 if r == c else 0.0
            P = ks * (unit - xx) + kn * xx
            Q = kb * (unit - xx) + kt * xx
            # ks S, as P S = ks S; and Sᵀ P S = ks (1 - XX)
            S = 0.0
            if r == 0 and c == 1:
                S = -z
            elif r == 0 and c == 2:
                S = y
            elif r == 1 and c == 0:
                S = z
            elif r == 1 and c == 2:
                S = -x
            elif r == 2 and c == 0:
                S = -y
            elif r == 2 and c == 1:
                S = x
            own[r, c] += P
            own[r, 3 + c] -= ks * near * S
            own[3 + r, c] += ks * near * S
            own[3 + r, 3 + c] += ks * near * near * (unit - xx) + Q
            other[r, c] = -P
            other[r, 3 + c] = -ks * far * S
            other[3 + r, c] = -ks * near * S
            other[3 + r, 3 + c] = ks * (near * far) * (unit - xx) - Q


@kernel(parallel=True)
def assemble(bonds, adjacency, indptr, indices, data):
    """Fill a block-sparse matrix of 6×6 blocks, degrees of freedom (u, θ) an element; rows own their blocks."""
    in_start, out_start = adjacency.in_start, adjacency.out_start
    for p in prange(len(out_start) - 1):
        slot = indptr[p]
        diagonal = slot + in_start[p + 1] - in_start[p]
        indices[diagonal] = p
        data[diagonal] = 0.0
        for k in range(in_start[p], in_start[p + 1]):
            indices[slot] = bonds.i[k]
            _blocks(
                -bonds.X0[k], -bonds.Y0[k], -bonds.Z0[k], bonds.kn[k], bonds.ks[k], bonds.kb[k], bonds.kt[k],
                bonds.length[k] - bonds.lever[k], bonds.lever[k], data[diagonal], data[slot],
            )  # fmt: skip
            slot += 1
        slot += 1
        for e in range(out_start[p], out_start[p + 1]):
            k = adjacency.out_bond[e]
            indices[slot] = bonds.j[k]
            _blocks(
                bonds.X0[k], bonds.Y0[k], bonds.Z0[k], bonds.kn[k], bonds.ks[k], bonds.kb[k], bonds.kt[k],
                bonds.lever[k], bonds.length[k] - bonds.lever[k], data[diagonal], data[slot],
            )  # fmt: skip
            slot += 1


def block_matrix_arrays(bonds: Bonds, adjacency: Adjacency) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Row pointers, column indices and blocks (…, 6, 6) of the stiffness matrix [N/m, N, N·m]."""
    n = len(adjacency.out_start) - 1
    indptr = (adjacency.in_start + adjacency.out_start + np.arange(n + 1)).astype(np.int32)
    indices = np.empty(indptr[-1], dtype=np.int32)
    data = np.empty((indptr[-1], 6, 6))
    assemble(bonds, adjacency, indptr, indices, data)
    return indptr, indices, data
