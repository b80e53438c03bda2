"""Rows of cracked facets in a state (`bondem.damage.crack_columns`)."""

import numpy as np
from scipy.spatial.transform import Rotation

from bondem._tables.columns import CrackKind
from bondem._types import ArrayLike, Floats, Ints, Mask
from bondem.damage.crack_columns import AXES, BEFORE, CRACK_COLUMNS, FACET, KIND, LEFT, ONSET, ONSET_STEP


def axes_along(normal: ArrayLike) -> Floats:
    """Return orthonormal axes as rows, (c, 3, 3): a given unit vector (c, 3), and two arbitrary ones."""
    e = np.asarray(normal, dtype=float)
    other = np.where(np.abs(e[:, :1]) < 0.6, [1.0, 0.0, 0.0], [0.0, 1.0, 0.0])
    a = other - (other * e).sum(axis=1, keepdims=True) * e
    a /= np.linalg.norm(a, axis=1, keepdims=True)
    return np.stack([e, a, np.cross(e, a)], axis=1)


def stored_axes(axes: Floats) -> Floats:
    """Return quaternions, (c, 4), of axes given as rows, (c, 3, 3); w is negative for left-handed axes."""
    side = np.where(np.linalg.det(axes) < 0.0, -1.0, 1.0)
    turned = axes.transpose(0, 2, 1).copy()
    turned[:, :, 2] *= side[:, None]
    w = Rotation.from_matrix(turned).as_quat(scalar_first=True) if len(axes) else np.zeros((0, 4))
    w[:, 0] += np.where(w[:, 0] == 0.0, 1e-200, 0.0)
    return w * (side * np.sign(w[:, 0]))[:, None]


def crack_rows(facet: Ints, strength: ArrayLike, axes: Floats, left: Floats, isotropic: Mask) -> Floats:
    """Return rows of new cracks, (c, CRACK_COLUMNS), with zero slip and zero dissipated energy.

    Args:
        facet: internal numbers of the facets, (c,).
        strength: strengths [Pa], (c,) or one for all.
        axes: e_1, e_2, e_3 in the frame of cell i, by rows, (c, 3, 3).
        left: integrities s_1, s_2, s_3 and the grip [-], (c, 4).
        isotropic: mask of cracks with one integrity for all directions, (c,).
    """
    rows = np.zeros((len(facet), CRACK_COLUMNS))
    rows[:, FACET], rows[:, ONSET], rows[:, ONSET_STEP] = facet, strength, np.nan
    of_material = np.where(left[:, 3] == 0.0, CrackKind.LET_GO, CrackKind.OF_MATERIAL)
    rows[:, KIND] = np.where(isotropic, CrackKind.ISOTROPIC, of_material)
    rows[:, AXES : AXES + 4] = stored_axes(axes)
    rows[:, LEFT : LEFT + 4] = rows[:, BEFORE : BEFORE + 4] = left
    return rows


def isotropic_left(s: Floats) -> Floats:
    """Return s_1 = s, s_2 = s_3 = 1 and the grip s, (c, 4), which mean one integrity s (c,) in all directions."""
    return np.stack([s, np.ones_like(s), np.ones_like(s), s], axis=1)
