"""Which criterion judges which bond and which cell: one for all, or criteria by region."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from bondem._checks import instance
from bondem._types import Ints
from bondem.errors import InputError
from bondem.laws.failure.criterion import BondCriterion, Criterion
from bondem.model.assignment import ends_of
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Region

FailureAssignment = Criterion | Mapping[Region | tuple[Region, Region], Criterion]

_WANTED = "a criterion such as bd.PeripheralStress(...), or None"


@dataclass(frozen=True, eq=False)
class FailurePart:
    """A criterion and what it judges.

    Attributes:
        criterion: of a kind with those of the other parts.
        bonds: bonds or facets whose strength it is, user's order.
        elements: elements that yield by it, user's order.
        plane: whether the facets are a material plane, judged by their own traction and not by the stress of cells.
    """

    criterion: Criterion
    bonds: Ints
    elements: Ints
    plane: bool = False


def criteria_of(failure: object) -> tuple[Criterion, ...]:
    """The criteria of an assignment, in its order.

    Raises:
        InputError: no criterion, or criteria that cannot stand beside each other.
    """
    if not isinstance(failure, Mapping):
        return (instance("Model", "failure", failure, Criterion, f"{_WANTED}, or {{region: criterion}}"),)
    found = tuple(instance("Model", "failure", one, Criterion, _WANTED) for one in failure.values())
    if not found:
        raise InputError("failure= names no region; give {region: criterion}, one criterion, or None")
    _check_alike(found)
    return found


def _check_alike(found: tuple[Criterion, ...]) -> None:
    """Refuse criteria of different kinds: a run judges all of its bonds by one function.

    Raises:
        InputError: such criteria.
    """
    first, *others = found
    if not others:
        return
    names = ", ".join(dict.fromkeys(type(one).__name__ for one in found))
    advice = "give criteria of one kind, which may differ in their strengths and energies"
    if len({isinstance(one, BondCriterion) and one.softening is None for one in found}) > 1:
        raise InputError(f"failure= has {names}, some on single bonds and some on the stress of cells; {advice}")
    soft = [one.softening for one in found if one.softening is not None]
    if not soft:
        if len({type(one) for one in found}) > 1:
            raise InputError(f"failure= judges bonds by {names}; {advice}")
        if len({one.energies is None for one in found if isinstance(one, BondCriterion)}) > 1:
            raise InputError("failure= has bonds that soften beside brittle ones; give all of them a fracture_energy")
        return
    if any(one.surface is not None for one in soft):
        if any(one != first for one in others):
            raise InputError(
                f"failure= has {names} by region; only bd.Rankine and bd.MohrCoulomb may differ between regions"
            )
        return
    if len({one.curve for one in soft}) > 1:
        raise InputError("failure= has cracks that soften along different curves; give all regions the same curve=")
    if len({one.fracture_energy > 0.0 for one in soft}) > 1:
        raise InputError("failure= has cracks that soften beside brittle ones; give all of them a fracture_energy")


def failure_parts(lattice: Lattice, failure: FailureAssignment) -> tuple[FailurePart, ...]:
    """The parts of a lattice that have a criterion each.

    With a mapping, the bonds within a region follow its criterion, those between two regions that of the pair, and
    cells that of their region; later entries overrule earlier ones.

    Raises:
        InputError: criteria that cannot stand beside each other, or bonds that none of them covers.
        EmptyRegionError: a region without elements.
    """
    found = criteria_of(failure)
    i, j = lattice.pairs.T
    if not isinstance(failure, Mapping):
        whole = np.arange(len(i)), np.arange(len(lattice.particles))
        return (FailurePart(found[0], *whole, plane=_is_plane(found[0], between=False)),)
    of_bond, of_element = np.full(len(i), -1), np.full(len(lattice.particles), -1)
    for number, where in enumerate(failure):
        first, second = ends_of("failure=", where)
        a, b = np.zeros((2, len(of_element)), dtype=bool)
        a[first.select(lattice)] = True
        b[second.select(lattice)] = True
        of_bond[(a[i] & b[j]) | (b[i] & a[j])] = number
        if not isinstance(where, tuple):
            of_element[a] = number
    bare = np.flatnonzero((of_bond < 0) & lattice.connected[i])
    if bare.size:
        raise InputError(
            f"{bare.size} bonds have no strength, the first between elements {i[bare[0]]} and {j[bare[0]]}; add an"
            " entry for bd.Everything() before the others, or (region, region): criterion for those between two"
        )
    return tuple(
        FailurePart(
            one, np.flatnonzero(of_bond == number), np.flatnonzero(of_element == number),
            plane=_is_plane(one, between=isinstance(where, tuple)),
        )
        for number, (one, where) in enumerate(zip(found, failure, strict=True))
    )  # fmt: skip


def _is_plane(criterion: Criterion, *, between: bool) -> bool:
    """Whether facets of a criterion are judged by their own traction; `between` two regions they are unless told.

    Functions of the stress have no traction to judge by.
    """
    softening = criterion.softening
    if softening is None or softening.surface is not None:
        if criterion.on is not None:
            raise InputError(
                f"{type(criterion).__name__}: on = {criterion.on!r} is of bd.Rankine and of bd.MohrCoulomb with a"
                " fracture energy; leave on= out"
            )
        return False
    return between if criterion.on is None else criterion.on == "traction"
