"""Tables of a failure criterion: coefficients and bounds of each bond, internal order."""

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from bondem._types import Floats, PerBond
from bondem.damage.criteria.criterion import COEFFICIENTS, BondCriterion, Criterion, Joint
from bondem.damage.criteria.mohr_coulomb import MohrCoulomb
from bondem.damage.failure_assignment import FailurePart, criteria_of
from bondem.errors import InputError
from bondem.interactions.beams.bond_law import BondLaw, BondStiffness
from bondem.interactions.cells.cell_body import body_of
from bondem.interactions.cells.cell_bond import CellBond
from bondem.interactions.contact.contact_assignment import ContactLaws
from bondem.interactions.non_local.non_local_constants import NonLocalConstants
from bondem.interactions.non_local.non_local_law import NonLocal
from bondem.specimen.lattice import Lattice
from bondem.specimen.ordering import Layout

# What rounding may take off a bound.
_ROUNDING = 1e-6
# Kind of criteria on principal stresses, which no function of forces judges.
_OF_PRINCIPAL = "principal"
# Share of the bound of facets at which they are looked at: it is held against stresses of cells a step ago.
_MARGIN = 0.75


@dataclass(frozen=True, eq=False)
class FailureTable:
    """Breakage criteria of the bonds, internal order.

    Attributes:
        kind: name of the criterion (`BondCriterion.kind`).
        coefficient: coefficients of the criterion for each bond, shape (m, 4).
        station: place along a bond where its moment counts, from i over its length; -1 for the larger end, (m,).
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

    @classmethod
    def of(
        cls,
        lattice: Lattice,
        layout: Layout,
        parts: tuple[FailurePart, ...],
        stiffness: BondStiffness | None,
        at_contact: bool,
    ) -> "FailureTable":
        """Return the table of a lattice.

        Args:
            lattice: bonds or facets.
            layout: order of the bonds.
            parts: criteria of one kind with their bonds.
            stiffness: stiffnesses of the bonds, user's order; None for facets of cells.
            at_contact: True if moments count at the contact point.
        """
        if stiffness is None:
            facets, _ = body_of(lattice)
            joint = Joint(facets.area, facets.span, facets.area * facets.span, facets.centroid, None)
        else:
            area = np.pi * stiffness.radius**2
            middle = lattice.centre[lattice.pairs[:, 0]] + 0.5 * lattice.branch
            joint = Joint(area, lattice.length, area * lattice.length, middle, stiffness)
        coefficient, a, b, kind = _judged(joint, parts, lattice)
        order, flipped = layout.bond_order, layout.flipped
        # each part of the bound weighs as on an average bond
        force, bent = _scale(a), np.isfinite(b) & (b > 0.0)
        moment = _scale(b[bent])
        # a |F| + b |M| <= √((a/force)² + (b/moment)²) √(force² |F|² + moment² |M|²)
        with np.errstate(divide="ignore"):
            share = (a / force) ** 2 + np.where(b > 0.0, (b / moment) ** 2, 0.0)
            limit = (_MARGIN if stiffness is None else 1.0 - _ROUNDING) / share
        station = np.full(len(order), -1.0)
        if at_contact and stiffness is not None:
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
    def of_principal(
        cls, lattice: Lattice, layout: Layout, parts: tuple[FailurePart, ...], constants: NonLocalConstants
    ) -> "FailureTable":
        """Return the table of bonds of the non-local law, with the coefficients of `laws.failure.principal`.

        Args:
            lattice: elements and bonds.
            layout: order of the bonds.
            parts: criteria on principal stresses with their bonds.
            constants: constants of the bonds, user's order.
        """
        middle = lattice.centre[lattice.pairs[:, 0]] + constants.lever_i
        coefficient = np.zeros((len(middle), COEFFICIENTS))
        for part in parts:
            factor = part.criterion.factors(
                constants.area * lattice.length, middle, lattice.particles.period, lattice.volume
            )
            assert part.criterion.principal is not None
            coefficient[part.bonds, :3] = part.criterion.principal / factor[part.bonds, None]
        none = np.full(len(middle), np.inf)
        return cls(
            kind=_OF_PRINCIPAL, coefficient=np.ascontiguousarray(coefficient[layout.bond_order]), station=-none,
            limit=none, of_force=0.0, of_moment=0.0,
        )  # fmt: skip


def _judged(
    joint: Joint, parts: tuple[FailurePart, ...], lattice: Lattice
) -> tuple[Floats, PerBond, PerBond, str]:
    """Return coefficients and bounds of all bonds, and the kind of criteria; a bond without one never breaks."""
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


def check_failure(failure: object, bond: object, contact: ContactLaws | None, formulation: str) -> bool:
    """Check a criterion for a model; return True if moments count at the contact point.

    Raises:
        InputError: There is no criterion, it applies to other bonds, or the model has features that exclude breakage.
    """
    laws = tuple(bond.values()) if isinstance(bond, Mapping) else (bond,)
    if any(isinstance(law, NonLocal) for law in laws):
        for criterion in criteria_of(failure):
            _check_non_local(criterion)
        return False
    if formulation != "total":
        raise InputError("failure= needs bonds of the total formulation; use formulation='total'")
    cells = any(isinstance(law, CellBond) for law in laws)
    for criterion in criteria_of(failure):
        _check_criterion(criterion, cells, contact)
    if cells and contact is not None and not contact.stress_free:
        raise InputError("failure= of cells beside contact= needs stress_free=True, as cells touch where they parted")
    at_contact = {law.moments_at_contact for law in laws if isinstance(law, BondLaw)}
    if len(at_contact) > 1:
        raise InputError("failure= counts moments either at the ends or at contact points; give bonds of one kind")
    return True in at_contact


def _check_criterion(failure: Criterion, cells: bool, contact: ContactLaws | None) -> None:
    """Reject a criterion for other bonds."""
    name, soft = type(failure).__name__, isinstance(failure, BondCriterion) and failure.energies is not None
    if soft and not cells:
        _check_soft(failure, contact)
    if isinstance(failure, BondCriterion) and cells and type(failure).needs_beams:
        raise InputError(f"{name} applies to beams, not to facets of cells; use bd.MohrCoulomb(...)")
    if failure.softening is not None and not cells and not soft:
        raise InputError(f"{name} with softening or stresses of the material needs a body of cells; use bd.CellBond")


def _check_non_local(failure: Criterion) -> None:
    """Reject options unsupported by bonds of the non-local law."""
    name = type(failure).__name__
    if failure.principal is None:
        raise InputError(
            f"{name} is not a criterion on principal stresses, as NonLocal needs; use bd.Rankine(tension=)"
            " or bd.MohrCoulomb(...)"
        )
    softening = failure.softening
    if softening is not None and softening.fracture_energy > 0.0:
        raise InputError(f"{name}: NonLocal bonds break at once; leave out fracture_energy=, or use bd.CellBond")
    if softening is not None and softening.friction > 0.0:
        raise InputError(f"{name}: friction= of NonLocal bonds is that of contact=bd.LinearContact(..., friction=)")


def _check_soft(failure: Criterion, contact: ContactLaws | None) -> None:
    """Reject options unsupported by softening beams."""
    if isinstance(failure, MohrCoulomb):
        if failure.dilatancy != 0.0 or failure.band_width is not None:
            name = "dilatancy" if failure.dilatancy != 0.0 else "band_width"
            raise InputError(f"MohrCoulomb: {name} applies to cells that yield; leave it out for beams that soften")
        if failure.fracture_energy_shear == math.inf:
            raise InputError("MohrCoulomb: fracture_energy_shear = inf is for cells that yield; give beams a number")
        if failure.curve is not None:
            raise InputError("MohrCoulomb: curve applies to cracks between cells; leave it out for beams")
    if contact is not None and contact.parallel:
        raise InputError(
            "contact= with parallel=True acts beside bonds, and beams that soften carry pressure themselves until"
            " they have broken; leave out parallel=, or fracture_energy="
        )
    if contact is not None and not contact.stress_free:
        raise InputError(
            "failure= of beams that soften beside contact= needs stress_free=True, as they carry pressure until they"
            " touch"
        )


def _scale(values: Floats) -> float:
    """Return a number of the magnitude of the values, 1 without values."""
    there = values[values > 0.0]
    return float(np.exp(np.log(there).mean())) if len(there) else 1.0
