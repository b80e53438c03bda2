"""Energies that beams absorb as they soften."""

from dataclasses import dataclass

import numpy as np

from bondem._tables.columns import FailureMode, SoftColumn
from bondem._types import Floats, PerBond
from bondem.damage.cohesive_softening import SNAP
from bondem.damage.criteria.criterion import BondCriterion, Joint
from bondem.damage.failure_assignment import FailurePart
from bondem.errors import InputError
from bondem.interactions.beams.bond_law import BondStiffness
from bondem.specimen.lattice import Lattice
from bondem.specimen.ordering import Layout


@dataclass(frozen=True, eq=False)
class BeamSoftening:
    """Energies that beams absorb as they soften, in internal order.

    Attributes:
        tear: G_f A of opening [J], (m,).
        shear: G_II A of slip and twist [J], (m,).
    """

    tear: PerBond
    shear: PerBond

    def absorbed(self, softened: Floats) -> Floats:
        """Return the energy that beams which have begun to soften absorb until they break [J], (c,).

        Args:
            softened: rows of the beams, with the columns of `SoftColumn`, (c, 7); `core/laws/beam_softening.hpp`
                defines their energy.
        """
        bond = softened[:, SoftColumn.BOND].astype(np.int64)
        first, last = softened[:, SoftColumn.FIRST], softened[:, SoftColumn.LAST]
        sliding = np.isin(softened[:, SoftColumn.MODE], (FailureMode.SHEAR, FailureMode.TWISTING))
        return np.where(last > SNAP * first, first * last, np.where(sliding, self.shear[bond], self.tear[bond]))

    @classmethod
    def of(
        cls, lattice: Lattice, layout: Layout, parts: tuple[FailurePart, ...], stiffness: BondStiffness,
        at_contact: bool,
    ) -> "BeamSoftening | None":  # fmt: skip
        """Return the table of a lattice of beams, or None if they break at once.

        Args:
            lattice: bonds.
            layout: order of the bonds.
            parts: criteria of one kind with their bonds.
            stiffness: stiffnesses of the bonds, user's order.
            at_contact: True if the moment that may break a bond is that at its contact point, False for that at its
                ends.

        Raises:
            InputError: More than half of the bonds of a criterion are too long for its fracture energies.
        """
        area = np.pi * stiffness.radius**2
        tear, shear = np.zeros((2, len(area)))
        middle = lattice.centre[lattice.pairs[:, 0]] + 0.5 * lattice.branch
        joint = Joint(area, lattice.length, area * lattice.length, middle, stiffness)
        for part in parts:
            assert isinstance(part.criterion, BondCriterion)
            if part.criterion.energies is None:
                return None
            for values, energy in zip((tear, shear), part.criterion.energies, strict=True):
                values[part.bonds] = energy * area[part.bonds]
            _check_lengths(joint.take(part.bonds), part.criterion, at_contact)
        order = layout.bond_order
        return cls(tear=tear[order], shear=shear[order])


def _check_lengths(joint: Joint, criterion: BondCriterion, at_contact: bool) -> None:
    """Raise InputError for bonds that snap back, because they store more than their fracture energy at failure.

    In tension such bonds are longer than 2 E G_f / f_t². In shear they store Q² / 2 ks > G_II A. The medians over the
    bonds are compared.
    """
    assert criterion.energies is not None
    if not len(joint.length):
        return
    opening, sliding = criterion.energies
    k, one = joint.beam, np.ones_like(joint.length)
    arm = np.zeros_like(one) if at_contact else np.maximum(k.lever, joint.length - k.lever)
    pull, slip = criterion.pulled_and_sheared(joint, one, arm)
    excess = 0.5 * pull**2 / k.kn / (opening * joint.area)
    if np.median(excess) > 1.0:
        raise InputError(
            f"bonds {np.median(joint.length):.3g} m long release more energy than fracture_energy={opening:g} J/m²"
            f" absorbs: they snap back above 2 E G_f / f_t² = {np.median(joint.length / excess):.3g} m; use smaller"
            " elements, or fracture_energy=None for bonds that break at once"
        )
    stored = 0.5 * slip**2 / k.ks / joint.area
    if np.median(stored) > sliding:
        raise InputError(
            f"bonds {np.median(joint.length):.3g} m long store {np.median(stored):.3g} J/m² of their section where"
            f" shear breaks them, more than fracture_energy_shear={sliding:g} J/m² absorbs: they snap back; use"
            " smaller elements, or a larger fracture_energy_shear"
        )
