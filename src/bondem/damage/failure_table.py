"""Tables of a failure criterion: coefficients and bounds of each bond, internal order."""

import math
from dataclasses import dataclass

import numpy as np

from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.damage_tables import FailureIndices, LoadedTractions, Strengths
from bondem._types import Floats, PerBond, PerBond3
from bondem.damage.criteria.criterion import COEFFICIENTS, BondCriterion, Criterion, Joint
from bondem.damage.criteria.mohr_coulomb import MohrCoulomb
from bondem.damage.failure_assignment import FailurePart, criteria_of
from bondem.errors import InputError
from bondem.interactions.contact.contact_assignment import ContactLaws
from bondem.interactions.interaction import Interaction
from bondem.specimen.lattice import Lattice

# Relative reduction of a bound that makes it safe against rounding.
_ROUNDING = 1e-6
# Kinds of breakage that no function of forces evaluates: by principal stresses, and by a law itself.
_OF_PRINCIPAL, _OF_LAW = "principal", "law"
# Share of the bound from which on facets are evaluated: the bound is checked with stresses of the previous step.
_MARGIN = 0.75


@dataclass(frozen=True, eq=False)
class FailureTable:
    """Breakage criteria of the bonds, internal order.

    Attributes:
        kind: name of the criterion (`BondCriterion.kind`), or "principal" or "law" (see `of_law`).
        coefficient: coefficients of the criterion for each bond, shape (m, 4).
        station: place of the moment that may break a bond, as the distance from i over its length [-]; -1 for the end
            with the larger moment, -inf where forces do not decide, (m,).
        limit: value of of_force |F|² + of_moment |M|² below which a bond cannot break [-], shape (m,).
        of_force: factor of |F|² [1/N²].
        of_moment: factor of |M|² [1/(N·m)²].
    """

    kind: str
    coefficient: Floats
    station: PerBond
    limit: PerBond
    of_force: float
    of_moment: float

    @property
    def strengths(self) -> Strengths:
        """Coefficients of the criterion in the layout of the core (`core/tables/damage_tables.hpp`)."""
        return Strengths(np.ascontiguousarray(self.coefficient), np.ascontiguousarray(self.station, dtype=float))

    @classmethod
    def of(cls, law: Interaction, parts: tuple[FailurePart, ...]) -> "FailureTable":
        """Return the table of criteria for the bonds of a law.

        Args:
            law: bonds or facets.
            parts: criteria of one kind with their bonds.
        """
        if law.evaluated == "stress":
            return cls._of_principal(law, parts)
        lattice, layout, joint = law.lattice, law.layout, joint_of(law)
        stiffness = joint.stiffness
        coefficient, a, b, kind = _judged(joint, parts, lattice)
        order, flipped = layout.bond_order, layout.flipped
        # force and moment weigh in the bound as on an average bond
        force, bent = _scale(a), np.isfinite(b) & (b > 0.0)
        moment = _scale(b[bent])
        # a |F| + b |M| <= √((a/force)² + (b/moment)²) √(force² |F|² + moment² |M|²)
        with np.errstate(divide="ignore"):
            share = (a / force) ** 2 + np.where(b > 0.0, (b / moment) ** 2, 0.0)
            limit = (_MARGIN if stiffness is None else 1.0 - _ROUNDING) / share
        station = np.full(len(order), -1.0)
        if stiffness is not None and law.moments_at_contact:
            station = stiffness.lever / lattice.length
            station = np.where(flipped, 1.0 - station[order], station[order])
        return cls(
            kind=kind,
            coefficient=np.ascontiguousarray(coefficient[order]),
            station=station,
            limit=limit[order],
            of_force=force**2,
            of_moment=moment**2 if bent.any() else 0.0,
        )

    @classmethod
    def of_law(cls, law: Interaction) -> "FailureTable":
        """Return the table of bonds that their law itself breaks: coefficients of zero, and infinite limits."""
        none = np.full(len(law.layout.i), np.inf)
        return cls(
            kind=_OF_LAW, coefficient=np.zeros((len(none), COEFFICIENTS)), station=-none, limit=none, of_force=0.0,
            of_moment=0.0,
        )  # fmt: skip

    @classmethod
    def _of_principal(cls, law: Interaction, parts: tuple[FailurePart, ...]) -> "FailureTable":
        """Return the table of bonds that mean stresses break, with coefficients of `Criterion.principal`."""
        lattice, layout, joint = law.lattice, law.layout, joint_of(law)
        middle = joint.place
        coefficient = np.zeros((len(middle), COEFFICIENTS))
        for part in parts:
            factor = part.criterion.factors(joint.volume, middle, lattice.particles.period, lattice.volume)
            assert part.criterion.principal is not None
            coefficient[part.bonds, :3] = part.criterion.principal / factor[part.bonds, None]
        none = np.full(len(middle), np.inf)
        return cls(
            kind=_OF_PRINCIPAL, coefficient=np.ascontiguousarray(coefficient[layout.bond_order]), station=-none,
            limit=none, of_force=0.0, of_moment=0.0,
        )  # fmt: skip

    def traction_indices(self, normal: PerBond3, traction: PerBond3, area: PerBond) -> PerBond:
        """Return the failure index of each facet [-], (m,), which is proportional to its traction.

        Normals [-] and tractions [Pa], (m, 3), and areas [m²], (m,), are in internal order.
        """
        found = np.zeros(len(area))
        loaded = LoadedTractions(normal, traction, area)
        run_pass(calls.INDEX_TRACTIONS_BY[self.kind](loaded, self.strengths, FailureIndices(found)))
        return found


def joint_of(law: Interaction) -> Joint:
    """Return geometry and stiffness of all bonds or facets of a law, as input of criteria; user's order."""
    area, length, place = law.joints()
    return Joint(area, length, area * length, place, law.bonds if law.evaluated == "force" else None)


def _judged(joint: Joint, parts: tuple[FailurePart, ...], lattice: Lattice) -> tuple[Floats, PerBond, PerBond, str]:
    """Return coefficients (m, 4) and both bounds (m,), and the kind of criteria; zeros without a criterion."""
    m, kind = len(joint.length), ""
    coefficient, a, b = np.zeros((m, COEFFICIENTS)), np.zeros(m), np.zeros(m)
    for part in parts:
        criterion, own = part.criterion, joint.take(part.bonds)
        assert isinstance(criterion, BondCriterion)
        kind = type(criterion).kind
        factor = criterion.factors(joint.volume, joint.place, lattice.particles.period, lattice.volume)[part.bonds]
        coefficient[part.bonds] = criterion.coefficients(own, factor)
        a[part.bonds], b[part.bonds] = criterion.bounds(own, coefficient[part.bonds])
    return coefficient, a, b, kind


def check_failure(failure: object, law: Interaction, contact: ContactLaws) -> None:
    """Check the criteria of `failure=` for a law of bonds and the contact laws of a model.

    Raises:
        InputError: There is no criterion, it applies to other bonds, or the model has features that exclude breakage.
    """
    if np.isfinite(law.own_strength()).any():
        raise InputError(f"bonds of {law.name} break by a strength of their own; leave out failure=")
    if law.evaluated == "stress":
        for criterion in criteria_of(failure):
            _check_principal(criterion, law.name)
        return
    if law.formulation != "total":
        raise InputError("failure= needs bonds of the total formulation; use formulation='total'")
    cells = law.evaluated == "traction"
    for criterion in criteria_of(failure):
        _check_criterion(criterion, cells, contact)
    if cells and contact.stressed:
        raise InputError("failure= of cells beside contact= needs stress_free=True, as cells touch where they parted")
    law.moments_at_contact  # noqa: B018  raises for laws that differ


def _check_criterion(failure: Criterion, cells: bool, contact: ContactLaws) -> None:
    """Raise InputError for a criterion that does not apply to these bonds, which are facets of `cells` or beams."""
    name, soft = type(failure).__name__, isinstance(failure, BondCriterion) and failure.energies is not None
    if soft and not cells:
        _check_soft(failure, contact)
    if isinstance(failure, BondCriterion) and cells and type(failure).needs_beams:
        raise InputError(f"{name} applies to beams, not to facets of cells; use bd.MohrCoulomb(...)")
    if failure.softening is not None and not cells and not soft:
        raise InputError(f"{name} with softening or stresses of the material needs a body of cells; use bd.CellBond")


def _check_principal(failure: Criterion, law: str) -> None:
    """Raise InputError for options unsupported by bonds of the law named `law`, which mean stresses break."""
    name = type(failure).__name__
    if failure.principal is None:
        raise InputError(
            f"{name} is not a criterion on principal stresses, as {law} needs; use bd.Rankine(tension=)"
            " or bd.MohrCoulomb(...)"
        )
    for softening in failure._softenings:
        if softening.fracture_energy > 0.0:
            raise InputError(f"{name}: {law} bonds break at once; leave out fracture_energy=, or use bd.CellBond")
        if softening.friction > 0.0:
            raise InputError(f"{name}: friction= of {law} bonds is that of contact=bd.LinearContact(..., friction=)")


def _check_soft(failure: Criterion, contact: ContactLaws) -> None:
    """Raise InputError for options unsupported by softening beams."""
    if isinstance(failure, MohrCoulomb):
        if failure.dilatancy != 0.0 or failure.band_width is not None:
            name = "dilatancy" if failure.dilatancy != 0.0 else "band_width"
            raise InputError(f"MohrCoulomb: {name} applies to cells that yield; leave it out for beams that soften")
        if failure.fracture_energy_shear == math.inf:
            raise InputError("MohrCoulomb: fracture_energy_shear = inf is for cells that yield; give beams a number")
        if failure.curve is not None:
            raise InputError("MohrCoulomb: curve applies to cracks between cells; leave it out for beams")
    if contact.parallel:
        raise InputError(
            "contact= with parallel=True acts beside bonds, and beams that soften carry pressure themselves until"
            " they have broken; leave out parallel=, or fracture_energy="
        )
    if contact.stressed:
        raise InputError(
            "failure= of beams that soften beside contact= needs stress_free=True, as they carry pressure until they"
            " touch"
        )


def _scale(values: Floats) -> float:
    """Return the geometric mean of the positive values, 1 without any."""
    there = values[values > 0.0]
    return float(np.exp(np.log(there).mean())) if len(there) else 1.0
