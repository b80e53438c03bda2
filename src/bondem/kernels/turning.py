"""Loops over vectors that turn with elements, and over the moments of forces about their centres."""

import numpy as np

from bondem._compile import kernel
from bondem.laws.rotations import rotate


@kernel(parallel=False)
def turn_vectors(quaternion, vectors):
    """Vectors (k, 3), each turned by its unit quaternion (w, x, y, z), (k, 4)."""
    out = np.empty((len(vectors), 3))
    for e in range(len(vectors)):
        w, x, y, z = quaternion[e, 0], quaternion[e, 1], quaternion[e, 2], quaternion[e, 3]
        out[e, 0], out[e, 1], out[e, 2] = rotate(w, x, y, z, vectors[e, 0], vectors[e, 1], vectors[e, 2])
    return out


@kernel(parallel=False)
def add_moments(moment, owner, arm, force, sign):
    """Add sign · sym Σ b⊗f to the moments (n, 6) of the owners: xx, yy, zz, xy, yz, zx."""
    for e in range(len(owner)):
        row = moment[owner[e]]
        bx, by, bz = sign * arm[e, 0], sign * arm[e, 1], sign * arm[e, 2]
        x, y, z = force[e, 0], force[e, 1], force[e, 2]
        row[0] += bx * x
        row[1] += by * y
        row[2] += bz * z
        row[3] += 0.5 * (bx * y + by * x)
        row[4] += 0.5 * (by * z + bz * y)
        row[5] += 0.5 * (bz * x + bx * z)
