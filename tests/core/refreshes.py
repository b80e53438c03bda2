"""Which columns of ghosts need the numbers of their owners in a step, and where, from what its passes declare.

A rank has its own elements, their bonds, and elements around these as ghosts. So

    what bonds add to a ghost is incomplete;
    what an element writes from something incomplete is incomplete;
    a pass that reads something incomplete at its ends needs it refreshed before.

A refresh stands behind the pass that left a column incomplete. Passes that add come first, and the earliest of them,
as their refresh may complete what others write. A step begins with what the last one left: the walk goes round the
list twice.
Energies of events need no refresh: a pass that finds one from all bonds of a ghost needs these bonds (`layers`).
"""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from bondem._passes import StepEntry
from bondem.interactions.step_part import FORCES, RESUME, Part, composed
from tests.core.pass_columns import columns_of

# Stages of a step that follows a pause, in their order, by the name of the list that has them.
_STAGES = (
    ("opening", ("opening",)), ("travel", ("travel",)), ("present", ("present",)), ("forces", tuple(FORCES)),
    *((name, (name,)) for name in RESUME),
)  # fmt: skip
#: Numbers of cracks, one a cell. A pass that reads them reads these cracks, and the orientations of their cells i.
LEADER = "CrackLists.leader"
#: All of these.
STEP = tuple(stage for _, some in _STAGES for stage in some)


class Refresh(NamedTuple):
    """A column of ghosts that takes the numbers of its owners: behind a pass, for the first pass that needs it.

    Its place is that of the pass in its stage, or among those of all stages of forces.
    """

    column: str
    behind: str
    before: str
    stage: str = ""
    place: int = -1


class _Pass(NamedTuple):
    """A pass with its columns in memory: what it reads of an element and at both ends, what it adds and writes."""

    name: str
    own: set[str]
    ends: set[str]
    adds: set[str]
    writes: set[str]


def refreshes(parts: Iterable[Part]) -> list[Refresh]:
    """Return the refreshes of a step, in the order of the passes that they stand behind."""
    parts = list(parts)
    entries = composed(parts, *STEP)
    stages = [(name, place) for name, some in _STAGES for place in range(len(composed(parts, *some)))]
    names = _names(entries)
    passes: list[_Pass | str] = [_with_memory(one, names) for one in entries]
    found = []
    while (need := _first_need(passes)) is not None:
        behind, column, before = need
        cause, reader = passes[behind], passes[before]
        assert isinstance(cause, _Pass)
        assert isinstance(reader, _Pass)
        if cause is reader:
            raise ValueError(f"{cause.name} reads at its ends {column} that it adds itself: divide it")
        stage, place = stages[behind - sum(isinstance(one, str) for one in passes[:behind])]
        found.append(Refresh(column, cause.name, reader.name, stage, place))
        passes.insert(behind + 1, column)
    order = [stage for stage, _ in _STAGES]
    return sorted(found, key=lambda one: (order.index(one.stage), one.place))


def layers(parts: Iterable[Part], *, energies: bool = False) -> tuple[int, int]:
    """Return how many layers of ghosts a step needs, and of how many all bonds, for motions or for energies too.

    Neighbours of the ends of an own bond are two away, and the cells of their cracks three. A pass that reads
    which faces of a cell have parted, or an energy by all of its cracks, needs all bonds of the ghosts beside own
    elements, and so one layer more.
    """
    passes = [columns_of(one.name) for one in composed(parts, *STEP)]
    around = {column for one in passes for column in one.get("around", ())}
    bonds = any("FacePairs.faced" in one.get("ends", ()) or (energies and "energy" in one) for one in passes)
    return 1 + (len(around) > 0) + (LEADER in around) + bonds, int(bonds)


def _first_need(passes: list[_Pass | str]) -> tuple[int, str, int] | None:
    """Return the place of the first pass that leaves a column incomplete, the column, and where it is needed."""
    incomplete: dict[str, tuple[bool, int]] = {}  # whether by what it reads, and the place of the pass
    needs = []
    for turn in range(2):
        for place, one in enumerate(passes):
            if isinstance(one, str):
                incomplete.pop(one, None)
                continue
            needs += [(*incomplete[column], column, place) for column in one.ends if column in incomplete if turn]
            spoiled = any(column in incomplete for column in one.own | one.ends)
            incomplete |= dict.fromkeys(one.adds, (False, place))
            for column in one.writes:
                incomplete.pop(column, None)
            incomplete |= dict.fromkeys(one.writes if spoiled else (), (True, place))
    return min(needs)[1:] if needs else None


def _with_memory(one: StepEntry, names: dict[tuple[int, str], str]) -> _Pass:
    columns = columns_of(one.name)

    def named(*uses: str) -> set[str]:
        places = [_place(one, column) for use in uses for column in columns.get(use, ())]
        return {names[place] for place in places if place in names}

    return _Pass(one.name, named("own"), named("ends", "around"), named("adds"), named("writes"))


def _names(entries: list[StepEntry]) -> dict[tuple[int, str], str]:
    """Return a name for each column in memory that has rows: two tables may have the same array."""
    names: dict[tuple[int, str], str] = {}
    for one in entries:
        for columns in columns_of(one.name).values():
            for column in columns:
                if values_of(one, column).size:
                    names.setdefault(_place(one, column), column)
    return names


def _place(one: StepEntry, column: str) -> tuple[int, str]:
    """Return where a column of a pass is in memory, and which part of its array it is."""
    return values_of(one, column).ctypes.data, column.partition(".")[2].partition(".")[2]


def values_of(one: StepEntry, column: str) -> np.ndarray:
    """Return the array that a column of a pass is in."""
    table, field, *_ = column.split(".")
    return getattr(next(given for given in one.tables if type(given).__name__ == table), field)
