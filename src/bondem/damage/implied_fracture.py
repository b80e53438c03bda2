"""Fracture energy and toughness implied by strengths, stiffnesses and the size of elements."""

import math
from dataclasses import dataclass

import numpy as np

from bondem._types import PerBond, PerElement
from bondem.damage.criteria.criterion import BondCriterion, Criterion, Joint
from bondem.damage.failure_assignment import FailurePart
from bondem.damage.failure_table import joint_of
from bondem.interactions.interaction import Interaction


@dataclass(frozen=True)
class ImpliedFracture:
    """Fracture properties of a lattice, as medians over its bonds or facets.

    Cells with a fracture energy have the G_c that was given, and K_Ic = √(E G_c). Brittle facets of cells have
    K_Ic = f_t √L (bars with a slit: 0.75 to 0.84 of it) and so G_c = K_Ic² / E = f_t² L / E. This is twice the
    energy f_t² L / 2E that a facet releases per area of its own; both grow with the size of the elements. Bonds
    that mean stresses break are treated as such facets.

    Brittle beams release, per area of a plane crack, the energy stored in tension by the bonds through it:
    (1/2V) Σ U L with U = N_t² / 2 k_n. For beams that soften, U = G_f A is the energy that they absorb. E is then the
    affine estimate, an upper bound.

    Attributes:
        softens: True if a fracture energy was given.
        strength: f_t, tensile strength; for a beam its largest axial force over its section [Pa].
        weakest: smallest of the median strengths of the parts that have one criterion each [Pa].
        E: Young's modulus [Pa].
        density: density of the specimen, including voids [kg/m³].
        length: L, length of bonds, or distance of cells across their facet [m].
        bond_energy: energy stored in tension by one bond or facet when it breaks, over its own area [J/m²].
        fracture_energy: G_c [J/m²].
        extent: longest edge of the specimen [m].
    """

    softens: bool
    strength: float
    weakest: float
    E: float
    density: float
    length: float
    bond_energy: float
    fracture_energy: float
    extent: float

    @property
    def toughness(self) -> float:
        """Fracture toughness K_Ic [Pa √m]."""
        return math.sqrt(self.E * self.fracture_energy)

    @property
    def irwin(self) -> float:
        """Irwin's length E G_c / f_t² [m], about the size of the process zone."""
        return self.E * self.fracture_energy / (self.strength * self.strength)


@np.errstate(all="ignore")
def implied_fracture(law: Interaction, parts: tuple[FailurePart, ...], mass: PerElement) -> ImpliedFracture | None:
    """Return the fracture properties that criteria, or the law itself, imply; None for a lattice without bonds.

    Args:
        law: bonds or facets.
        parts: criteria with their bonds; empty if the law itself breaks them.
        mass: masses of the elements [kg], shape (n,).
    """
    lattice, stiffness = law.lattice, law.bonds
    if not len(lattice.pairs):
        return None
    shapes = [lattice.envelope(k) for k in range(len(lattice.names))]
    volume = sum(shape.volume for shape in shapes)
    joint, E = joint_of(law), law.modulus(volume)
    area, length, springs = joint.area, joint.length, joint.stiffness
    pull, given = np.zeros(len(area)) if parts else law.own_strength(), np.zeros(len(area))
    for part in parts:
        pull[part.bonds] = _tensile_force(part, joint, law)
        given[part.bonds] = _given_energy(part.criterion, cells=springs is None)
    stored = 0.5 * pull**2 * (length / (E * area) if springs is None else 1.0 / stiffness.kn)
    strength, L = float(np.median(pull / area)), float(np.median(length))
    softens = bool(given.any())
    if softens and springs is not None:
        energy = float((given * area * length).sum() / (2.0 * volume))
    elif softens:
        energy = float(np.median(given))
    elif springs is None:
        energy = strength * strength * L / E
    else:
        energy = float((stored * length).sum() / (2.0 * volume))
    chosen = [part.bonds for part in parts if len(part.bonds)] or [np.arange(len(area))]
    weakest = min(float(np.median((pull / area)[bonds])) for bonds in chosen)
    return ImpliedFracture(
        softens=softens, strength=strength, weakest=weakest, E=E, density=float(mass.sum()) / volume, length=L,
        bond_energy=float(np.median(stored / area)), fracture_energy=energy,
        extent=max(float(np.max(np.subtract(upper, lower))) for lower, upper in (shape.bounds for shape in shapes)),
    )  # fmt: skip


def _given_energy(failure: Criterion, *, cells: bool) -> float:
    """Return the fracture energy in tension of a criterion [J/m²], 0 for brittle bonds or facets."""
    if cells:
        return sum((softening.fracture_energy for softening in failure._softenings), 0.0)
    energies = failure.energies if isinstance(failure, BondCriterion) else None
    return 0.0 if energies is None else energies[0]


def _tensile_force(part: FailurePart, joint: Joint, law: Interaction) -> PerBond:
    """Return the tensile force that breaks each bond of a part in pure tension [N], (c,)."""
    failure, lattice = part.criterion, law.lattice
    factor = failure.factors(joint.volume, joint.place, lattice.particles.period, lattice.volume)[part.bonds]
    joint = joint.take(part.bonds)
    if law.evaluated == "stress":
        assert failure.principal is not None
        return joint.area * factor / max(failure.principal[:2])
    if failure.softening is not None and joint.stiffness is None:
        return joint.area * failure.softening.tension * factor
    assert isinstance(failure, BondCriterion)
    return failure.pulled(joint, failure.coefficients(joint, factor))
