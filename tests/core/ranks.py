"""A run by several ranks in one process: each moves its own elements, and has the others as ghosts.

A rank has all tables of the body, but bonds and pairs that it would lack do not act: those without an end that is
own, or among the ghosts of which it has all bonds. So forces and sums of ghosts are wrong, until a refresh copies
columns from their owners. Elements beyond the ghosts are never refreshed, and go wrong at once.
"""

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from bondem._core import bound_pass
from bondem._core_steps import Composer
from bondem._passes import StepEntry, calls
from bondem._tables.step_tables import StepPasses, StepScheme, StepSpan
from bondem.dynamics.damping import DampingTerms
from bondem.dynamics.gauge_tables import gauge_tables
from bondem.dynamics.parts.parts_of_model import parts_of
from bondem.dynamics.plan import Plan
from bondem.interactions.step_part import FORCES, Part, composed
from bondem.model.domain_blocks import Blocks
from bondem.model.state import State
from tests.core.refreshes import LEADER, Refresh, values_of
from tests.device_cases import Case

_GUARDED = 100  # steps between two passes of the guard, behind which elements open the next step by themselves
_OUT_OF_DATE = 3
# Columns that are 0 of bonds that do not act, and the byte of facets that do not crack, that of a parted crack.
_HOLD = {"Beams.integrity", "ElasticFacets.integrity", "BeamIntegrity.per_length", "SofteningBounds.per_length",
         "UniformBeams.per_length"}  # fmt: skip
_PARTED = 3


class Rank:
    """The tables and parts of a rank.

    Args:
        case: model, state, time step and options of all ranks.
        state: state from which the run begins.
        own: own elements, internal order.
        layers: layers of ghosts, and of ghosts of which the rank has all bonds.
    """

    def __init__(self, case: Case, state: State, own: np.ndarray, layers: tuple[int, int]) -> None:
        model, _, _, dt, options = case
        plan = Plan(duration=dt, dt=dt, **options)
        self.state, self.own, self.model = state, own, model
        self.n, self.m = len(state.pose), len(model.layout.i)
        terms = DampingTerms.of(plan.damping)
        division = Blocks.of(model.layout, max(self.n, 1), 1, model.constraints.row_of >= 0)
        self.blocks = division.table(0 if model.breaking is None else self.n)
        self.shared, self.parts = parts_of(model, terms, state, self.blocks, gauge_tables(model, plan), dt)
        self.scheme = StepScheme(dt, *plan.scheme.coefficients(dt), terms.gamma, state.time - state.step * dt)
        self.i, self.j = model.layout.i.astype(int), model.layout.j.astype(int)
        self._live: list[Any] = []
        self.compose = Composer()
        self._bonded, self.known = self._within(layers[0]), self._within(layers[1])
        self.call(0, present=composed(self.parts, "present"), looks=True)
        if first := composed(self.parts, "begin"):
            self.call(0, present=[*composed(self.parts, "present"), *first], looks=True)
        self._leave_out()

    def _within(self, layers: int) -> np.ndarray:
        """Own elements and layers of ghosts."""
        found = self.own.copy()
        for _ in range(layers):
            one, other = found[self.j], found[self.i]
            found[self.i[one]] = found[self.j[other]] = True
        return found

    def _leave_out(self) -> None:
        """Let bonds and pairs that the rank lacks do nothing, and find its ghosts."""
        self.ghosts = self._bonded.copy()
        lacks = np.flatnonzero(~self.known[self.i] & ~self.known[self.j])
        for stage in ("present", *FORCES):
            for one in composed(self.parts, stage):
                for table in one.tables:
                    for name, values in zip(table._fields, table, strict=True):
                        full = f"{type(table).__name__}.{name}"
                        if full in _HOLD and len(values):
                            values[lacks] = 0.0
                        elif full in ("CohesiveCracks.listed", "CrackOnset.listed"):
                            values[lacks] = np.where(values[lacks] == 0, _PARTED, values[lacks])
                    if type(table).__name__ == "ContactPairs":
                        first, second = table.first.astype(int), table.second.astype(int)
                        has = self.known[first] | self.known[second]
                        table.reach[~has] = 0.0
                        self.ghosts[np.r_[first[has], second[has]]] = True
        self.ghosts &= ~self.own

    def call(self, before: int, *, looks: bool = False, pauses: bool = False, **lists: list[StepEntry]) -> None:
        """Carry out lists of passes; those of forces in the step behind a number of steps, the last one or not."""
        nothing = self.compose([])
        made = StepPasses(*[nothing] * len(StepPasses._fields))._replace(
            **{name: self.compose(entries) for name, entries in lists.items()}
        )
        done = np.zeros(4, dtype=np.int64)
        span = StepSpan(before, 0 if looks else 2 - pauses, 0, looks, False, not looks, self.n, self.m, done)
        ledger = self.shared.ledger._replace(found=np.array([0, 0, 0, 1]))
        ending = bound_pass(calls.take_steps(made, self.blocks, self.scheme, span, ledger))()
        assert ending in ("sound", "out_of_date")

    @property
    def is_out_of_date(self) -> bool:
        return bool(self.shared.ledger.found[_OUT_OF_DATE])

    def renew(self) -> None:
        """Renew the lists of contacts."""
        for part in self.parts:
            part.keep()
        parts: list[Part | None] = [part if part.renewed is None else part.renewed() for part in self.parts]
        assert None not in parts
        self.parts, self.compose = [part for part in parts if part is not None], Composer()
        self._leave_out()


class Ranks:
    """All ranks of a run.

    Args:
        case: model, state, time step and options.
        state: state of all elements, with their present acceleration.
        owner: rank of each element, internal order.
        wanted: refreshes of each step.
        layers: as `Rank` has them.
    """

    def __init__(
        self, case: Case, state: State, owner: np.ndarray, wanted: Sequence[Refresh], layers: tuple[int, int]
    ) -> None:
        self.owner, self.wanted = owner, wanted
        self.ranks = [Rank(case, state.copy(), owner == rank, layers) for rank in range(owner.max() + 1)]

    def run(self, steps: int) -> None:
        """Take steps."""
        paused = True
        for left in reversed(range(steps)):
            before, last = self.ranks[0].state.step, left == 0
            if paused:
                self._through(before - 1, "opening")
            self._refresh("opening")
            self._through(before - 1, "travel")
            self._refresh("travel")
            if any(rank.is_out_of_date for rank in self.ranks):
                self._renew()
            self._through(before, "present")
            self._forces(before, last)
            for rank in self.ranks:
                resume, reopening = composed(rank.parts, "resume"), composed(rank.parts, "reopening")
                rank.call(before, pauses=last, resume=resume, reopening=reopening)
                rank.state.step += 1
                rank.state.time = rank.scheme.origin + rank.state.step * rank.scheme.dt
            paused = (before + 1) % _GUARDED == 0
        for rank in self.ranks:
            for part in rank.parts:
                part.keep()

    def _renew(self) -> None:
        """Renew the lists of contacts, by the places and velocities of all elements."""
        for name in ("pose", "motion"):
            found = [getattr(rank.state, name) for rank in self.ranks]
            whole = np.array(found)[self.owner, np.arange(len(self.owner))]
            for values in found:
                values[...] = whole
        for rank in self.ranks:
            rank.renew()

    def _through(self, before: int, stage: str) -> None:
        for rank in self.ranks:
            rank.call(before, forces=composed(rank.parts, stage))

    def _forces(self, before: int, last_step: bool) -> None:
        """Carry out the passes of forces, with refreshes between them."""
        lists = [composed(rank.parts, *FORCES) for rank in self.ranks]
        summed = [place for place, entry in enumerate(lists[0]) if entry.name == "load_walls"]
        places = {one.place for one in self.wanted if one.stage == "forces"} | {place - 1 for place in summed}
        for first, last in pairwise([-1, *sorted(places), len(lists[0]) - 1]):
            for rank, entries in zip(self.ranks, lists, strict=True):
                if entries[first + 1 : last + 1]:
                    rank.call(before, pauses=last_step, forces=entries[first + 1 : last + 1])
            self._refresh("forces", last)
            if last + 1 in summed:
                self.share_wall_loads([entries[last + 1] for entries in lists])

    def share_wall_loads(self, entries: Sequence[StepEntry]) -> None:
        """Give all ranks the loads of all elements on walls, of which each rank then takes the same exact sums."""
        tables = [next(one for one in entry.tables if type(one).__name__ == "WallContacts") for entry in entries]
        whole = np.array([table.output for table in tables])
        owner = self.owner[tables[0].element.astype(int)]
        for table in tables:
            assert np.array_equal(table.element, tables[0].element)
            table.output[...] = whole[owner, np.arange(len(owner))]

    def _refresh(self, stage: str, place: int | None = None) -> None:
        """Copy columns of ghosts from their owners; with the number of a crack its integrities and axes."""
        for one in self.wanted:
            if one.stage == stage and place in (None, one.place):
                stages = FORCES if stage == "forces" else (stage,)
                entries = [composed(rank.parts, *stages)[one.place] for rank in self.ranks]
                found = [values_of(entry, one.column) for entry in entries]
                part = [3] if one.column.endswith(".stress") else [0, 1, 2, 4, 5, 6, 7]
                for rank, values in enumerate(found):
                    for other, source in enumerate(found):
                        rows = np.flatnonzero((self.owner == other) & self.ranks[rank].ghosts)
                        if other != rank and ".pose" in one.column:
                            values[np.ix_(rows, part)] = source[np.ix_(rows, part)]
                        elif other != rank:
                            values[rows] = source[rows]
                        if one.column == LEADER:
                            cracks = source[rows][source[rows] >= 0]
                            frames = [values_of(entries[at], "CohesiveCracks.frame") for at in (rank, other)]
                            frames[0][cracks] = frames[1][cracks]
