"""Check for bodies of a scene without sufficient supports, for which statics has no solution."""

import numpy as np

from bondem._types import Floats, Mask
from bondem.errors import FloatingBodyError
from bondem.model.model import Model
from bondem.statics.coarse_space import clump_motions

# Resistance to a rigid motion of a piece, over the largest one of the piece, below which the motion is free.
_LOOSE = 1e-12


def refuse_floating(model: Model, position: Floats, prescribed: Mask) -> None:
    """Raise an error if a piece of a scene is free to move rigidly; bodies that bonds join are one piece.

    Args:
        model: model of the scene; nothing is checked for a single body.
        position: centres [m], internal order, (n, 3).
        prescribed: mask of the degrees of freedom that are fixed or driven, internal order, (n, 6).

    Raises:
        FloatingBodyError: A body moves or turns without resistance.
    """
    lattice, layout = model.lattice, model.layout
    if len(lattice.names) == 1:
        return
    connected, piece = lattice.connected[layout.order], lattice.pieces[layout.order]
    motions, count = clump_motions(position, piece), np.bincount(piece)
    # rotations as motions at the root mean square R of the arms: u and R θ
    arms = (motions[:, :3, 3:] ** 2).sum(axis=(1, 2)) / 2.0
    R = np.maximum(np.sqrt(np.bincount(piece, arms) / count), lattice.particles.mean_radius)
    motions[:, :, 3:] /= R[piece, None, None]
    element, freedom = np.nonzero(prescribed & connected[:, None])
    constrained = motions[element, freedom] * np.where(freedom < 3, 1.0, R[piece[element]])[:, None]
    owner = piece[element]
    supports = model.interaction.supports
    constrained = np.concatenate([constrained, supports.constraint(motions[layout.rank])])
    owner = np.concatenate([owner, np.tile(np.repeat(lattice.pieces[supports.cell], 3), 2)])
    resisted = np.zeros((len(count), 6, 6))
    np.add.at(resisted, owner, constrained[:, :, None] * constrained[:, None, :])
    size = np.linalg.eigvalsh(resisted)
    floating = np.unique(lattice.body[layout.order][connected & (size[:, 0] <= _LOOSE * size[:, -1])[piece]])
    if len(floating):
        names = ", ".join(repr(lattice.names[k]) for k in floating[:5]) + ", …" * (len(floating) > 5)
        raise FloatingBodyError(
            f"nothing holds {names} of the {len(lattice.names)} bodies against all six motions; fix a face of each"
            " with bd.Fix, or use solve_explicit"
        )
