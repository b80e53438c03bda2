"""Assignment of failure criteria to bonds and cells: one for all, or criteria by region."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TypeGuard

import numpy as np

from bondem._checks import instance
from bondem._types import Ints
from bondem.damage.criteria.criterion import BondCriterion, Criterion
from bondem.damage.criteria.mohr_coulomb import MohrCoulomb
from bondem.errors import InputError
from bondem.interactions.beams.assignment import ends_of
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Region

FailureAssignment = Criterion | Mapping[Region | tuple[Region, Region], Criterion]

_WANTED = "a criterion such as bd.PeripheralStress(...), or None"
# Strength of a joint without cohesion over that of the body [-], and its fracture energy over its strength [m].
_NO_STRENGTH, _NO_OPENING = 1e-9, 1e-9


@dataclass(frozen=True, eq=False)
class FailurePart:
    """Bonds and elements that follow one criterion.

    Attributes:
        criterion: failure criterion, of the same kind in all parts of a model.
        bonds: bonds or facets that it applies to, user's order.
        elements: cells that yield by the criterion, user's order.
        plane: True if the facets form a material plane, evaluated by their own traction, not by the stress of cells.
        between: the two regions of a pair whose facets are not evaluated by the stress of cells; None otherwise.
        open: True for a joint without cohesion, whose facets absorb nothing.
    """

    criterion: Criterion
    bonds: Ints
    elements: Ints
    plane: bool = False
    between: tuple[Region, Region] | None = None
    open: bool = False


def criteria_of(failure: object) -> tuple[Criterion, ...]:
    """Return the criteria of an assignment, in its order; joints without cohesion have a strength that nothing feels.

    Raises:
        InputError: There is no criterion, the criteria cannot be combined, or a joint is none of two regions.
    """
    if not isinstance(failure, Mapping):
        failure = {None: instance("Model", "failure", failure, Criterion, f"{_WANTED}, or {{region: criterion}}")}
    found = {where: instance("Model", "failure", one, Criterion, _WANTED) for where, one in failure.items()}
    if not found:
        raise InputError("failure = {} has no region; give {region: criterion}, one criterion, or None")
    others = [one for one in found.values() if not _is_open(one)]
    if any(_is_open(one) and not (others and isinstance(where, tuple)) for where, one in found.items()):
        raise InputError(
            "MohrCoulomb: tension = 0 and cohesion = 0 describe a joint; give them to a pair of regions, such as"
            " failure={bd.Everything(): rock, (plane, bd.Everything() - plane): joint}"
        )
    combined = tuple(_as_weak(one, others) if _is_open(one) else one for one in found.values())
    _check_combined(combined)
    return combined


def _is_open(criterion: Criterion) -> TypeGuard[MohrCoulomb]:
    return isinstance(criterion, MohrCoulomb) and criterion.tension == 0.0


def _as_weak(joint: MohrCoulomb, others: list[Criterion]) -> Criterion:
    """Return a joint without strength as one that every load breaks, and that softens as the `others` do."""
    strength = _NO_STRENGTH * max(getattr(one, "tension", None) or 1.0 for one in others)
    soft = [getattr(one, "curve", None) for one in others if getattr(one, "fracture_energy", None)]
    energy, curve = (_NO_OPENING * strength, soft[0]) if soft else (None, None)
    return replace(
        joint, tension=strength, cohesion=strength, fracture_energy=energy, fracture_energy_shear=energy, curve=curve
    )


def _check_combined(found: tuple[Criterion, ...]) -> None:
    """Raise InputError for criteria of different kinds, because a run evaluates all of its bonds by one function."""
    first, *others = found
    if not others:
        return
    names = ", ".join(dict.fromkeys(type(one).__name__ for one in found))
    advice = "give criteria of one kind, which may differ in their strengths and energies"
    if len({isinstance(one, BondCriterion) and one.softening is None for one in found}) > 1:
        raise InputError(f"failure= has {names}, some on single bonds and some on the stress of cells; {advice}")
    soft = [softening for one in found for softening in one._softenings]
    if not soft:
        if len({type(one) for one in found}) > 1:
            raise InputError(f"failure= combines {names}; {advice}")
        if len({one.energies is None for one in found if isinstance(one, BondCriterion)}) > 1:
            raise InputError("failure= combines bonds that soften with brittle ones; give all a fracture_energy")
        return
    if any(one.surface is not None for one in soft):
        if any(one != first for one in others):
            raise InputError(
                f"failure= has {names} by region; only bd.Rankine and bd.MohrCoulomb may differ between regions"
            )
        return
    if len({one.curve for one in soft}) > 1:
        raise InputError("failure= combines cracks with different softening curves; give all regions the same curve=")
    if len({one.fracture_energy > 0.0 for one in soft}) > 1:
        raise InputError("failure= combines cracks that soften with brittle ones; give all of them a fracture_energy")


def failure_parts(lattice: Lattice, failure: FailureAssignment) -> tuple[FailurePart, ...]:
    """Return the parts of a lattice, with one criterion each.

    With a mapping, the bonds within a region follow its criterion, and bonds between two regions follow that of the
    pair. Cells follow the criterion of their region. Later entries override earlier ones.

    Raises:
        InputError: The criteria cannot be combined, or some bonds have none.
        EmptyRegionError: A region has no elements.
    """
    found = criteria_of(failure)
    i, j = lattice.pairs.T
    if not isinstance(failure, Mapping):
        whole = np.arange(len(i)), np.arange(len(lattice.particles))
        return (FailurePart(found[0], *whole, plane=_is_plane(found[0], between=False)),)
    of_bond, of_element = np.full(len(i), -1), np.full(len(lattice.particles), -1)
    for number, where in enumerate(failure):
        a, b = ends_of("failure=", where, lattice)
        of_bond[(a[i] & b[j]) | (b[i] & a[j])] = number
        if not isinstance(where, tuple):
            of_element[a] = number
    bare = np.flatnonzero((of_bond < 0) & lattice.connected[i])
    if bare.size:
        raise InputError(
            f"{bare.size} bonds have no strength, the first between elements {i[bare[0]]} and {j[bare[0]]}; add an"
            " entry for bd.Everything() before the others, or (region, region): criterion for bonds between regions"
        )
    parts = []
    for number, (one, (where, given)) in enumerate(zip(found, failure.items(), strict=True)):
        pair = where if isinstance(where, tuple) else None
        plane, own = _is_plane(one, between=pair is not None), not one._softenings
        if plane and pair and any(slip.dilation or slip.width for soft in one._softenings for slip in soft.slips):
            raise InputError(
                f"{type(one).__name__}: the plane between two regions neither dilates nor has a band width; leave out"
                " dilatancy= and band_width= for the pair"
            )
        bonds, elements = np.flatnonzero(of_bond == number), np.flatnonzero(of_element == number)
        parts.append(FailurePart(one, bonds, elements, plane, pair if plane or own else None, _is_open(given)))
    return tuple(parts)


def _is_plane(criterion: Criterion, *, between: bool) -> bool:
    """Return True if facets of a criterion are evaluated by their own traction.

    This is the default for facets `between` two regions. Functions of the stress and criteria of single
    bonds have no such choice: InputError if they have `on`.
    """
    if not any(softening.surface is None for softening in criterion._softenings):
        if criterion.on is not None:
            raise InputError(
                f"{type(criterion).__name__}: on = {criterion.on!r} applies to bd.Rankine and bd.MohrCoulomb with a"
                " fracture energy; leave out on="
            )
        return False
    return between if criterion.on is None else criterion.on == "traction"
