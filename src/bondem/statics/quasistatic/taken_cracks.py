"""Conversion of cracks of an equilibrium, with one integrity each, to those of a run (`core/laws/crack.hpp`)."""

from dataclasses import dataclass

import numpy as np

from bondem._tables.stress_onset_tables import SofteningSearch
from bondem._types import Floats, Ints, PerBond
from bondem.damage.crack_columns import ROOT
from bondem.damage.crack_rows import axes_along, crack_rows, isotropic_left
from bondem.damage.softening_table import SofteningTable


@dataclass(frozen=True, eq=False)
class CrackedHalves:
    """Halves of cracked facets in an equilibrium.

    Attributes:
        facet: internal numbers of the facets, (c,).
        k: stiffnesses of the facets [N/m], (c,).
        part: share of cell i in the compliance of each facet [-], (c,).
        normal: normals in the reference [-], (c, 3).
        across: unit vector of the only direction in which each facet softens, zero if it softens in all, (c, 3).
        left: integrities, 0 for broken facets [-], (c,).
        force: forces that the halves on cells i and j would have at full integrity [N], (2, c, 3).
    """

    facet: Ints
    k: Floats
    part: Floats
    normal: Floats
    across: Floats
    left: PerBond
    force: Floats


def taken_cracks(table: SofteningTable, halves: CrackedHalves, opened: SofteningSearch) -> Floats:
    """Return the table of cracks of a run, (c, CRACK_COLUMNS), that begins with the forces of an equilibrium.

    A crack keeps its integrity s along its first axis and in its grip, and has 1 along the other two. Its first axis
    is the direction in which it softens next. If a half is in compression, or not in tension along that direction,
    the first axis is the normal of the facet, along which pressure remains. Both choices give the force of the
    equilibrium. A facet that softens in one direction has that axis, and its grip stays 1.

    Args:
        table: strengths of the facets.
        halves: the cracked facets.
        opened: openings of the cracked facets along the principal directions of stress.
    """
    force, left = halves.force, halves.left
    first = opened.direction[np.arange(len(left)), opened.factor.argmin(axis=1)]
    sign = np.sign((force.sum(axis=0) * first).sum(axis=1))
    first = sign[:, None] * first
    pulled = ((force * first).sum(axis=2) > 0.0).all(axis=0) & ((force * halves.normal).sum(axis=2) > 0.0).all(axis=0)
    plane, one = table.plane[halves.facet], (halves.across != 0.0).any(axis=1)
    first = np.where((pulled & ~plane)[:, None], first, halves.normal)
    axes = axes_along(np.where(one[:, None], halves.across, first))
    of_axes = isotropic_left(left)
    of_axes[one, 3] = 1.0
    rows = crack_rows(halves.facet, table.strength[halves.facet], axes, of_axes, plane)
    rows[:, ROOT : ROOT + 3] = _roots(halves, axes)
    return rows


def _roots(halves: CrackedHalves, axes: Floats) -> Floats:
    """Return roots of the energies of intact facets along three axes, negative in compression [√J], (c, 3)."""
    share = np.stack([halves.part, 1.0 - halves.part])[:, :, None]
    along = np.einsum("hcx,cdx->hcd", halves.force, axes)
    energy = (share * along**2).sum(axis=0) / (2.0 * halves.k[:, None])
    return np.copysign(np.sqrt(energy), (share * along).sum(axis=0))
