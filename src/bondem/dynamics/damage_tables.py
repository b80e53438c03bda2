"""Tables of the damage pipeline, as `core/tables/damage_tables.hpp` declares them with types and shapes.

Bonds are beams, facets of cells, or pairs of the non-local law: the m interactions of one kind that may fail.
"""

from typing import NamedTuple

import numpy as np

from bondem._types import Floats, Ints
from bondem.damage.event_columns import BROKEN_COLUMNS
from bondem.model.state import State


class FailureBounds(NamedTuple):
    """Bounds that bonds do not reach as long as they cannot fail."""

    limit: np.ndarray  #: of of_force |F|² + of_moment |M|²; inf of bonds that cannot fail, float32, (m,)
    of_force: float  #: [1/N²]
    of_moment: float  #: [1/(N·m)²]


class Candidates(NamedTuple):
    """Bonds that are near to failure, and then those of them that fail, in the order of the bonds."""

    begin: Ints  #: first bond of each block, (blocks + 1,)
    marked: Ints  #: those of a block from begin[block] on, (m,)
    mode: Ints  #: of those that fail, (m,)
    count: Ints  #: number of each block, (blocks,)
    any: Ints  #: 1 where a bond fails in this step, (1,)


class Postponed(NamedTuple):
    """Elements that close a step with all bonds, and open the next without those that failed."""

    held: np.ndarray  #: not 0 for elements that are postponed, uint8, (n,)
    element: np.ndarray  #: lists of these elements, uint32, (n,)
    row: np.ndarray  #: rows of their sums, uint32, (n,)
    first_row: int  #: of the sums of a step that keep those of the postponed, one row per element
    kept: Floats  #: these rows, (n, 8)


class EventLog(NamedTuple):
    """Failures of one call of the core, in the order of time."""

    event: Floats  #: columns `BROKEN_…` of `bondem.damage.event_columns`, (m, 10)
    written: Ints  #: number of events, and of those before the present step, (2,)
    released: Floats  #: energy released since the start of the run [J], (1,)
    crushed: Floats  #: what bonds had released before it beyond their fracture energy [J], (1,)

    @classmethod
    def of(cls, state: State) -> "EventLog":
        """Return an empty log of a run from a state."""
        room = np.empty((len(state.integrity), BROKEN_COLUMNS))
        return cls(room, np.zeros(2, dtype=np.int64), state.released, state.crushed)


class BeamIntegrity(NamedTuple):
    """Integrity of beams, which failure changes."""

    integrity: Floats  #: 1 intact … 0 broken [-], (m,)
    hold: Floats  #: integrity over rest length of beams that share their constants [1/m], (m,), or (0,)


class SofteningBounds(NamedTuple):
    """Beams that may soften: bounds of those that have not begun, their criterion, and what softening changes."""

    limit: np.ndarray  #: as of `FailureBounds`, inf of beams that have begun, float32, (m,)
    of_force: float  #: [1/N²]
    of_moment: float  #: [1/(N·m)²]
    coefficient: Floats  #: as of `Strengths`, (m, 4)
    station: Floats  #: (m,)
    tear: Floats  #: G_f A [J], (m,)
    slide: Floats  #: G_II A [J], (m,)
    integrity: Floats  #: 1 whole … 0 broken [-], (m,)
    hold: Floats  #: integrity over rest length of beams that share their constants [1/m], (m,), or (0,)
    press: Floats  #: stiffness of the softened part of a beam in compression, (1 - s) kn [N/m], (m,)
    onset: Floats  #: openings [√J] and energies [J] of beams that begin in this step, (m, 4)


class SofteningBeams(NamedTuple):
    """Beams that soften."""

    row: Floats  #: beams in the order in which they began, columns of `bondem.damage.event_columns`, (m, 7)
    begun: Ints  #: number of rows, (1,)
    listed: Ints  #: rows that have not broken, those of a portion of bonds from its first bond on, (m,)
    number: Ints  #: number of rows of each portion
    parted: Ints  #: number of those that break in this step, behind the others
    lost: Floats  #: energy that each portion dissipates in this step [J]
