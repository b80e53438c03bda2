"""Cracks of an equilibrium, which have one integrity, converted to those of a run (`core/laws/crack.hpp`)."""

from dataclasses import dataclass

import numpy as np

from bondem._tables.stress_onset_tables import SofteningSearch
from bondem._types import Floats, Ints, PerBond
from bondem.damage.crack_columns import RATE
from bondem.damage.crack_rows import axes_along, crack_rows, isotropic_left
from bondem.damage.softening_table import SofteningTable


@dataclass(frozen=True, eq=False)
class CrackedHalves:
    """Halves of cracked facets in an equilibrium.

    Attributes:
        facet: internal numbers of the facets, (c,).
        k: stiffnesses of the facets [N/m], (c,).
        part: parts of cell i in their compliance [-], (c,).
        normal: normals in the reference [-], (c, 3).
        left: integrities, 0 for broken ones, (c,).
        force: forces of the halves on cells i and j as if they were whole [N], (2, c, 3).
    """

    facet: Ints
    k: Floats
    part: Floats
    normal: Floats
    left: PerBond
    force: Floats


def taken_cracks(table: SofteningTable, halves: CrackedHalves, opened: SofteningSearch) -> Floats:
    """Return the rows of cracks (`bondem.damage.crack_columns`), which carry the same forces in a run.

    A crack keeps one integrity s for all directions: s_1 = γ = s, and s_2 = s_3 = 1. Its first direction is that by
    which it softens next. Where a half is pressed, or is not pulled along that direction, it is the normal of the
    facet, along which pressure stays. Both give the force of the equilibrium.

    Args:
        table: strengths.
        halves: the cracked facets.
        opened: openings of these along the principal directions of stress.
    """
    force, left = halves.force, halves.left
    first = opened.direction[np.arange(len(left)), opened.factor.argmin(axis=1)]
    sign = np.sign((force.sum(axis=0) * first).sum(axis=1))
    first = sign[:, None] * first
    pulled = ((force * first).sum(axis=2) > 0.0).all(axis=0) & ((force * halves.normal).sum(axis=2) > 0.0).all(axis=0)
    plane = table.plane[halves.facet]
    axes = axes_along(np.where((pulled & ~plane)[:, None], first, halves.normal))
    rows = crack_rows(halves.facet, table.strength[halves.facet], axes, isotropic_left(left), plane)
    rows[:, RATE : RATE + 4] = _rates(halves, axes)
    return rows


def _rates(halves: CrackedHalves, axes: Floats) -> Floats:
    """Return -∂U/∂s of three directions and of the grip [J], (c, 4)."""
    share = np.stack([halves.part, 1.0 - halves.part])[:, :, None] / (2.0 * halves.k[:, None])
    along = np.einsum("hcx,cdx->hcd", halves.force, axes)
    pull, press = (share * np.maximum(sign * along, 0.0) ** 2 for sign in (1.0, -1.0))
    of = pull.sum(axis=0)
    of_grip = (pull + press)[:, :, 1:].sum(axis=(0, 2))
    of[:, 1:] *= halves.left[:, None]
    return np.column_stack([of, of_grip])
