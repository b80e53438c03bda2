"""Assignment of contact laws: one for all contacts, or laws by region, by pair of regions, and at walls."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import get_args

import numpy as np

from bondem._checks import instance, shown
from bondem._types import Floats, Ints, Mask, PerElement
from bondem.boundary.walls import Wall
from bondem.errors import InputError
from bondem.interactions.contact.contact_law import KISSING, ContactLaw
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Region, as_region

#: Where a law of `contact=` acts: within a region and between it and walls, between two regions, between a region and
#: a wall, or at a wall.
ContactPlace = Region | Wall | tuple[Region | Wall, Region | Wall]
ContactAssignment = ContactLaw | Mapping[ContactPlace, ContactLaw]

_WANTED = "a contact law such as bd.LinearContact(...), or None"
# Largest number of kinds of elements, which one byte numbers.
_KINDS = 256


@dataclass(frozen=True, eq=False)
class ContactLaws:
    """Laws of the contacts of a model. Elements of one kind have the same laws with all others and at all walls.

    Attributes:
        laws: the different laws, all of one class.
        kind: kind of each element, user's order, uint8, (n,).
        between: number of the law of pairs of each two kinds, (kinds, kinds).
        at_walls: number of the law of each kind at each wall, (kinds, w).
        friction: μ at each wall, of the wall or else of the law [-], (kinds, w).
    """

    laws: tuple[ContactLaw, ...]
    kind: np.ndarray
    between: Ints
    at_walls: Ints
    friction: Floats

    @classmethod
    def of(cls, lattice: Lattice, contact: ContactAssignment | None, walls: Sequence[Wall]) -> "ContactLaws":
        """Return the contact laws of a model; without `contact` there are no laws and no kinds.

        In a mapping, the law of a region acts between its elements, and between them and walls. The law of a pair
        acts between the elements of two regions, or between those of a region and a wall. The law of a wall acts
        between it and all elements. Later entries override earlier ones.

        Raises:
            InputError: The laws cannot be combined, or some contacts have none.
            EmptyRegionError: A region has no elements.
        """
        if contact is None:
            of_walls = np.zeros((0, len(walls)))
            return cls((), np.zeros(0, np.uint8), np.zeros((0, 0), np.int64), of_walls.astype(np.int64), of_walls)
        laws = tuple(dict.fromkeys(_checked(contact)))
        kind = np.zeros(len(lattice.particles), dtype=np.uint8)
        between, at_walls = np.zeros((1, 1), dtype=np.int64), np.zeros((1, len(walls)), dtype=np.int64)
        if isinstance(contact, Mapping):
            by_region = _by_region(lattice, contact, walls, laws)
            if len(laws) > 1:  # a single law acts everywhere, as without regions
                kind, between, at_walls = by_region
        _check_reach(laws, lattice)
        given = np.array([math.nan if wall.friction is None else wall.friction for wall in walls], dtype=float)
        own = np.array([law.friction for law in laws])[at_walls]
        return cls(laws, kind, between, at_walls, np.where(np.isnan(given), own, given))

    @property
    def name(self) -> str:
        """Name of the class of the laws."""
        return type(self.laws[0]).__name__

    @property
    def hertzian(self) -> bool:
        """True if the stiffness is that of Hertz and Mindlin."""
        return self.laws[0].hertzian

    @property
    def stress_free(self) -> bool:
        """True if overlaps of the reference configuration carry no force."""
        return any(law.stress_free for law in self.laws)

    @property
    def stressed(self) -> bool:
        """True if overlaps of the reference configuration carry a force."""
        return any(not law.stress_free for law in self.laws)

    @property
    def parallel(self) -> bool:
        """True if contacts also act in parallel with intact bonds."""
        return any(law.parallel for law in self.laws)

    @property
    def of_beams(self) -> str:
        """Name of an option of the laws that only spheres support, "parallel" or "adhesion"; empty for none."""
        return "parallel" if self.parallel else "adhesion" if self.beyond > 0.0 else ""

    @property
    def rolls(self) -> bool:
        """True if some contacts resist rolling or twisting."""
        return any(law.rolls for law in self.laws)

    @property
    def beyond(self) -> float:
        """Largest gap at which contacts act, 0 without adhesion [m]."""
        return max((law.adhesion.reach for law in self.laws if law.adhesion is not None), default=0.0)

    @property
    def deepest(self) -> float:
        """Overlap over the smaller radius up to which all laws describe a contact [-]."""
        return min(law.deepest for law in self.laws)

    @property
    def rows(self) -> tuple[Floats, Floats]:
        """Rows `ContactLaw.parameters` of pairs, (kinds, kinds, 9), and at walls, (kinds, w, 9)."""
        rows = np.array([law.parameters for law in self.laws])
        at_walls = rows[self.at_walls]
        at_walls[:, :, 2] = self.friction
        return rows[self.between], at_walls

    def of_pairs(self, i: Ints, j: Ints) -> tuple[Floats, Floats, Floats]:
        """Return ks / kn, friction μ and damping β [-] of contacts of elements i and j, user's order, (c,) each."""
        _, soft, friction, beta, *_ = np.array([law.parameters for law in self.laws]).T
        law = self.between[self.kind[i], self.kind[j]]
        return soft[law], friction[law], beta[law]

    def stiffest(self, radius: PerElement, mass: PerElement, platens: Floats) -> tuple[tuple[float, float], ...]:
        """Return `ContactLaw.stiffest` of each law for the elements that it applies to; arguments in user's order."""
        motions: tuple[tuple[float, float], ...] = ()
        for number, law in enumerate(self.laws):
            some = self._pressed_by(self.between == number) | self._pressed_by(self.at_walls == number)
            if some.any():
                # a platen may have to carry all elements, whatever their law
                share = platens * (some.sum() / len(some))
                motions += law.stiffest(radius[some], mass[some], share)
        return motions

    def shortest(self, radius: PerElement, mass: PerElement, touching: Mask, platens: Floats) -> float:
        """Return the shortest of `ContactLaw.shortest` of all laws [s].

        Args:
            radius: radii of the elements [m], user's order, (n,).
            mass: masses of the elements [kg], (n,).
            touching: mask of the elements that may collide, (n,).
            platens: masses of the walls that a force moves [kg], (s,).
        """
        least = math.inf
        for number, law in enumerate(self.laws):
            for where, walled in ((self.between, False), (self.at_walls, True)):
                some = touching & self._pressed_by(where == number)
                if some.any():
                    least = min(least, law.shortest(radius[some], mass[some], platens, walled=walled))
        return least

    def released(self, radius: PerElement) -> float:
        """Return an upper bound of the energy [J] that adhesion releases as elements meet; radii [m], (n,)."""
        total = 0.0
        for number, law in enumerate(self.laws):
            if law.adhesion is not None:  # a well of F_c D / 2 at each contact
                some = self._pressed_by(self.between == number) | self._pressed_by(self.at_walls == number)
                total += 0.5 * KISSING * law.adhesion.reach * float(law.adhesion.pull_off(radius[some]).sum())
        return total

    def _pressed_by(self, where: np.ndarray) -> Mask:
        """Return a mask of the elements, (n,), whose kind has a True entry in its row of `where`, (kinds, others)."""
        return np.any(where, axis=1)[self.kind]


def _checked(contact: object) -> tuple[ContactLaw, ...]:
    """Return the laws of an assignment in its order; raise InputError for others, or laws that do not combine."""
    if not isinstance(contact, Mapping):
        return (instance("Model", "contact", contact, ContactLaw, _WANTED),)
    found = tuple(instance("Model", "contact", law, ContactLaw, _WANTED) for law in contact.values())
    if not found:
        raise InputError("contact = {} has no region; give {bd.Everything(): law}, one law, or None")
    if len({type(law) for law in found}) > 1:
        names = " and ".join(dict.fromkeys(type(law).__name__ for law in found))
        raise InputError(f"contact= combines {names}; give laws of one class, which may differ in their numbers")
    for name in ("stress_free", "parallel"):
        if len({getattr(law, name) for law in found}) > 1:
            raise InputError(f"contact= has laws with and without {name}=True; give all laws the same {name}=")
    return found


def _check_reach(laws: tuple[ContactLaw, ...], lattice: Lattice) -> None:
    """Raise InputError for adhesion across gaps in which other elements may lie."""
    least = float(lattice.particles.radius.min())
    for law in laws:
        if law.adhesion is not None and law.adhesion.reach > least:
            raise InputError(
                f"Adhesion: reach = {law.adhesion.reach:.4g} m is more than the smallest radius, {least:.4g} m; give"
                " less, as elements beyond that stand between"
            )


def _by_region(
    lattice: Lattice, contact: Mapping[ContactPlace, ContactLaw], walls: Sequence[Wall], laws: tuple[ContactLaw, ...]
) -> tuple[np.ndarray, Ints, Ints]:
    """Return `kind`, `between` and `at_walls` of `ContactLaws` for laws by region."""
    ends = [_ends(lattice, where, walls) for where in contact]
    masks = np.array([mask for pair in ends for mask, _ in pair])
    combinations, kind = np.unique(masks, axis=1, return_inverse=True)
    kind, count = kind.ravel(), combinations.shape[1]
    if count > _KINDS:
        raise InputError(f"contact= divides the elements into {count} kinds; give regions of at most {_KINDS} kinds")
    between, at_walls = np.full((count, count), -1), np.full((count, len(walls)), -1)
    for entry, (where, law) in enumerate(contact.items()):
        number, (a, b) = laws.index(law), combinations[2 * entry : 2 * entry + 2]
        (_, first), (_, second) = ends[entry]
        on = first | second
        if on.any():
            at_walls[np.ix_(a | b, on)] = number
        else:
            between[np.outer(a, b) | np.outer(b, a)] = number
            if not isinstance(where, tuple):
                at_walls[a] = number
    _require_laws(kind, between, at_walls)
    return kind.astype(np.uint8), between, at_walls


def _ends(lattice: Lattice, where: object, walls: Sequence[Wall]) -> tuple[tuple[Mask, Mask], ...]:
    """Return, for both sides of an entry of `contact=`, masks of its elements (n,) and of its walls (w,)."""
    pair = where if isinstance(where, tuple) else (where, where)
    if len(pair) != 2:
        raise InputError(f"contact= names {len(pair)} regions for one contact; give (region, region): law")
    kinds = get_args(Wall)
    if isinstance(where, tuple) and all(isinstance(side, kinds) for side in pair):
        raise InputError("contact= names two walls for one contact; give (region, wall): law, or wall: law")
    sides = []
    for side in pair:
        mask, of_walls = np.zeros(len(lattice.particles), dtype=bool), np.zeros(len(walls), dtype=bool)
        if isinstance(side, kinds):
            of_walls[:] = [wall == side for wall in walls]
            if not of_walls.any():
                raise InputError(f"contact= names {shown(side)}, which is not in walls=; give the same wall there")
            mask[:] = not isinstance(where, tuple)
        else:
            mask = as_region("contact=", side).with_rattlers(lattice)
        sides.append((mask, of_walls))
    return tuple(sides)


def _require_laws(kind: Ints, between: Ints, at_walls: Ints) -> None:
    """Raise InputError for contacts without a law."""
    bare = np.argwhere(between < 0)
    advice = "add an entry for bd.Everything() before the others, or (region, region): law for two regions"
    if bare.size:
        a, b = (int(np.flatnonzero(kind == one)[0]) for one in bare[0])
        who = f"elements {a} and {b}" if a != b else f"element {a} and others of its regions"
        raise InputError(f"some contacts follow no law, such as that of {who}; {advice}")
    bare = np.argwhere(at_walls < 0)
    if bare.size:
        element = int(np.flatnonzero(kind == bare[0][0])[0])
        raise InputError(
            f"some contacts follow no law, such as that of element {element} with wall {bare[0][1]}; add an entry for"
            " its region, or (region, wall): law"
        )
