"""What a pass of a step reads and writes of elements, found from outside: change a column, run the pass, look.

Columns of half the elements are changed. What a pass then does otherwise at the other half, or to any bond, it has
read at both ends; what it does otherwise at the changed elements alone, it has read of its own element.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from bondem._core import bound_pass, checked_fields, step_pass
from bondem._core_steps import Composer
from bondem._passes import StepEntry, calls
from bondem._tables.columns import HistoryColumn, ListCount
from bondem._tables.crack_tables import CrackLists
from bondem._tables.step_tables import HistoryRows, StepPasses, StepScheme, StepSpan
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.damping import DampingTerms
from bondem.dynamics.gauge_tables import gauge_tables
from bondem.dynamics.parts.parts_of_model import parts_of
from bondem.dynamics.plan import Plan
from bondem.interactions.step_part import FORCES, RESUME, composed
from bondem.model.domain_blocks import Blocks
from bondem.model.state import State
from tests.core.passes import kinds_of_passes
from tests.device_cases import Case

#: First axes of columns of elements; of `*` those that `_OWNERS` names.
OF_ELEMENTS = ("n", "sums", "rows", "supports", "layered", "halves")
_ROWS_OF_SUMS = {"StepBlocks.sums", "Dashpots.sums", "FacetForces.sums", "Resistance.dashed"}
_ELSE = {"CellDilatation.swelling": "n", "LaggedStresses.moment": "n", "Rows.support": "rows",
         **dict.fromkeys(_ROWS_OF_SUMS, "sums")}  # fmt: skip
_OF_BONDS = {"m", "bonds", "facets", "pairs", "places", "candidates", "strained"}
_BONDS_TOO = {"ContactPairs.joined", "PartedReach.apart", "BeamIntegrity.per_length", "SofteningBounds.per_length"}
# Columns whose numbers stand for places.
_PLACES = {"FacePairs.chosen", "SofteningBeams.row", "EventLog.event"}
_BOND_KINDS = {"bonds_of_blocks", "of_bonds", "of_cracks", "of_events"}
# Changes, over the size of a column.
_SIZES = (1e-3, 1.0)


@dataclass
class Found:
    """Columns that a pass reads of its own element, at both ends of a bond and around these, and what it changes."""

    own: set[str] = field(default_factory=set)
    ends: set[str] = field(default_factory=set)
    around: set[str] = field(default_factory=set)
    adds: set[str] = field(default_factory=set)
    writes: set[str] = field(default_factory=set)

    @property
    def columns(self) -> dict[str, tuple[str, ...]]:
        """As a declaration has them: one that is read at both ends is read of the own element too."""
        ends = self.ends - self.around
        uses = {
            "own": self.own - self.ends - self.around - self.adds, "ends": ends, "around": self.around,
            "adds": self.adds, "writes": self.writes - self.adds,
        }  # fmt: skip
        return {use: tuple(sorted(columns)) for use, columns in uses.items() if columns}


@dataclass(frozen=True, eq=False)
class Array:
    """An array of a table of a pass: its name, part of its columns, element or crack of each row, or None."""

    name: str
    values: np.ndarray
    part: tuple[slice | tuple[int, ...], ...]
    axes: tuple[str, ...]
    owner: np.ndarray | None
    written: bool
    bond: np.ndarray | None = None

    @property
    def of_bonds(self) -> bool:
        return self.name in _BONDS_TOO or bool(_OF_BONDS & set(self.axes))

    @property
    def key(self) -> int:
        return self.values.ctypes.data

    @property
    def seen(self) -> np.ndarray:
        return self.values[self.part]


class Step:
    """One step of a case, pass by pass, from a state."""

    def __init__(self, case: Case, state: State, *, goes_on: bool = True) -> None:
        model, _, _, dt, options = case
        self.goes_on = goes_on
        self.plan = Plan(duration=dt, dt=dt, **options)
        self.state, self.n, self.m = state, len(state.pose), len(model.layout.i)
        terms = DampingTerms.of(self.plan.damping)
        kept = 0 if model.breaking is None else self.n  # rows that keep the sums of postponed elements
        division = Blocks.of(model.layout, max(self.n, 1), 2, model.constraints.row_of >= 0)
        self.blocks = division.table(kept)
        self.kept = len(self.blocks.sums) - kept
        self.shared, self.parts = parts_of(model, terms, state, self.blocks, gauge_tables(model, self.plan), dt)
        self.scheme = StepScheme(dt, *self.plan.scheme.coefficients(dt), terms.gamma, state.time - state.step * dt)
        self.i, self.j = model.layout.i.astype(int), model.layout.j.astype(int)
        self.row_element = model.constraints.element.astype(int)
        x = model.lattice.particles.position[model.layout.order][:, 0]
        half = x > np.median(x)
        self._halves = half, ~half, np.random.default_rng(1).random(self.n) < 0.5
        self.change_half(0)
        self._runs: dict[tuple[int, ...], Callable[[], str]] = {}
        self._compose = Composer()
        self._live: list[Any] = []

    def change_half(self, number: int) -> None:
        """Choose the elements that are changed: those of one end of the body, of the other, or half of all."""
        self.ghost = self._halves[number % len(self._halves)]
        of_i, of_j = np.append(self.ghost[self.i], True), np.append(self.ghost[self.j], True)
        self.alien, self.inner = of_i & of_j, ~of_i & ~of_j

    @cached_property
    def changing(self) -> set[int]:
        """Addresses of the arrays that some pass of the step may write."""
        return {a.key for _, _, one in self.entries() for a in self.arrays(one) if a.written}

    @cached_property
    def row_of_sums(self) -> np.ndarray:
        """Element of each row of sums, or -1."""
        blocks, found = self.blocks, np.full(len(self.blocks.sums), -1)
        found[blocks.ready_row.astype(int)] = blocks.ready
        found[blocks.shared_row.astype(int)] = blocks.shared
        for place, element in enumerate(blocks.shared):
            found[blocks.parts + blocks.part[place] : blocks.parts + blocks.part[place + 1]] = element
        found[self.kept :] = np.arange(len(found) - self.kept)
        return found

    def call(
        self, entries: list[StepEntry], resume: list[StepEntry] | None = None, *, still: bool = False
    ) -> Callable[[], str]:
        """Return a function that calls passes in one step, or at its beginning without a step."""
        key = tuple(id(one.tables) for one in [*entries, *(resume or [])])
        if key not in self._runs:
            nothing = self._compose([])
            lists = StepPasses(*[nothing] * len(StepPasses._fields))
            lists = lists._replace(forces=self._compose(entries), resume=self._compose(resume or []))
            done = np.zeros(4, dtype=np.int64)
            span = StepSpan(self.state.step, 1 + self.goes_on, 0, still, still, True, self.n, self.m, done)
            ledger = self.shared.ledger._replace(found=np.array([0, 0, 0, 1]))
            self._live += [lists, span, ledger, entries, resume]
            self._runs[key] = bound_pass(calls.take_steps(lists, self.blocks, self.scheme, span, ledger))
        return self._runs[key]

    def entries(self) -> Iterator[tuple[str, list[StepEntry], StepEntry]]:
        """Yield stage, passes to call before, and pass, in the order of a step."""
        before: list[StepEntry] = []
        rows = HistoryRows(np.zeros((1, HistoryColumn.COUNT + 3 * len(self.plan.gauges))))
        for stage in ("begin", "present", "opening", "travel", *FORCES, *RESUME, "guard", "record"):
            found = composed(self.parts, stage)
            if stage == "record":
                found = [one for part in self.parts for one in part.record(rows)]
            for one in found:
                yield stage, list(before), one
                if one.name == "postpone_elements":
                    before = [one]
                elif kind_of(one) not in BY_BLOCKS:
                    before = []

    def arrays(self, one: StepEntry) -> Iterator[Array]:
        """Yield the arrays of the tables of a pass."""
        for table in one.tables:
            for about in checked_fields(type(table)):
                values = getattr(table, about.name)
                if about.written is None or not values.size:
                    continue
                name = f"{type(table).__name__}.{about.name}"
                if name == "StepBlocks.sums":  # the rows behind those of the step are `Postponed.sum`
                    values = values[: self.kept]
                axes = tuple(symbol for symbol, _ in about.shape)
                owner = self._owner(name, axes[0], values, one)
                if values.dtype.kind != "f" and values.dtype != np.uint8 and name not in _FACETS:
                    owner = None
                if about.name == "pose":
                    yield Array(name, values, (slice(None), (0, 1, 2, 4, 5, 6, 7)), axes, owner, about.written)
                    yield Array(f"{name}.stress", values, (slice(None), (3,)), axes, owner, about.written)
                else:
                    bond = self._cracks_of_halves(len(values)) if axes[0] == "halves" else None
                    yield Array(name, values, (slice(None),), axes, owner, about.written, bond)

    def bonds_of(self, a: Array) -> np.ndarray | None:
        """Return the bond of each row of an array, m for none; None where the rows are not those of bonds."""
        if a.name == "EventLog.event":
            bond = np.where(np.isfinite(a.values[:, 2]), a.values[:, 2], -1.0)
            return np.where((bond >= 0) & (bond < self.m), bond, self.m).astype(int)
        if a.axes[0] in ("m", "facets"):
            return np.minimum(np.arange(len(a.values)), self.m)
        return None

    def _owner(self, name: str, axis: str, values: np.ndarray, one: StepEntry) -> np.ndarray | None:
        kind, count = _ELSE.get(name, axis), len(values)
        if kind in ("n", "layered"):
            found = np.full(count, -1)
            found[: min(count, self.n)] = np.arange(min(count, self.n))
            return found
        if kind == "sums":
            return self.row_of_sums[:count] if count <= len(self.row_of_sums) else None
        if kind == "rows":
            return self.row_element
        if kind == "supports":
            walls = next((t for t in one.tables if type(t).__name__ == "WallConstraints"), None)
            return None if walls is None else walls.cell.astype(int)
        if kind == "halves":  # 2 k + 1 on cell i of facet k, and 2 k + 2 on cell j
            lists = next(table for table in one.tables if isinstance(table, CrackLists))
            facet, first = self._cracks_of_halves(count), np.arange(count) % 2 == 1
            treated = np.isin(facet, lists.treated[: int(lists.size[ListCount.TREATED])]) & (np.arange(count) > 0)
            return np.where(treated, np.where(first, self.i[facet], self.j[facet]), -1)
        return None

    def _cracks_of_halves(self, count: int) -> np.ndarray:
        return np.minimum(np.maximum(np.arange(count) - 1, 0) // 2, self.m - 1)


def kind_of(one: StepEntry) -> str:
    return kinds_of_passes()[step_pass(one.name)[0][1]]


# Numbers of facets, by cell.
_FACETS = {"CrackLists.leader"}
BY_BLOCKS = {"bonds_of_blocks", "elements_of_blocks", "parts_of_shared", "divides_elements", "postponed_of_blocks"}


def _changed(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Rows that differ."""
    return ((a != b) & ~((a != a) & (b != b))).reshape(len(a), -1).any(axis=1)


class Look:
    """A pass in a state, which is carried out with columns that have been changed, and with none."""

    def __init__(
        self, step: Step, before: list[StepEntry], one: StepEntry, found: Found, rng: np.random.Generator
    ) -> None:
        self.step, self.found, self.kind = step, found, kind_of(one)
        if one.name == "list_postponed":
            self.carry_out = step.call([], [one])
        elif "still" in one.name:
            self.carry_out = step.call([one], still=True)
        else:
            self.carry_out = step.call([*before, one] if self.kind in BY_BLOCKS else [one])
        self.works, self.one, self.rng = False, one, rng

    def look(self, half: int) -> None:
        """Change columns of one half of the elements after the other."""
        step, rng = self.step, self.rng
        step.change_half(half)
        self.arrays = list(step.arrays(self.one))
        self.memory = {a.key: a.values for a in self.arrays if a.written}
        self.start = {key: values.copy() for key, values in self.memory.items()}
        self.plain = self.outcome()
        self.restore()
        self.compare({key: values.tobytes() for key, values in self.start.items()}, None)
        for c in self.arrays:
            if c.owner is not None and c.key in step.changing:
                rows = (c.owner >= 0) & step.ghost[np.maximum(c.owner, 0)]
                self.change(c, rows & step.alien[c.bond] if c.bond is not None else rows, rng)
            elif c.of_bonds and c.values.dtype.kind == "f" and self.kind not in _BOND_KINDS and c.name not in _PLACES:
                self.change(c, np.ones(len(c.values), dtype=bool), rng)
        self.works = any(self.plain[key].tobytes() != self.start[key].tobytes() for key in self.start)

    def outcome(self) -> dict[int, np.ndarray]:
        assert self.carry_out() in ("sound", "out_of_date")
        return {key: values.copy() for key, values in self.memory.items()}

    def restore(self) -> None:
        for key, values in self.memory.items():
            values[...] = self.start[key]

    def change(self, c: Array, rows: np.ndarray, rng: np.random.Generator) -> None:
        """Carry the pass out with other numbers in rows of a column."""
        whole, seen = c.values.copy(), c.seen
        flags = c.values.dtype.kind != "f"
        size = 1.0 if flags else np.abs(np.where(np.isfinite(seen), seen, 0.0)).max() or 1.0
        for share in (1.0,) if flags else _SIZES if c.owner is not None else _SIZES[:1]:
            new = seen.copy()
            with np.errstate(all="ignore"):  # what a pass has not written yet may be any number
                more = share * size * rng.standard_normal(new[rows].shape)
                new[rows] = new[rows] == 0 if flags else new[rows] + more
            c.values[c.part] = new
            given = {key: values.tobytes() for key, values in self.memory.items()}
            assert self.carry_out() in ("sound", "out_of_date")
            self.compare(given, c)
            c.values[...] = whole
            self.restore()

    def compare(self, given: dict[int, bytes], c: Array | None) -> None:
        """Compare what a pass has made of given arrays with what it makes of those of the state."""
        after = self.memory if c is not None else self.plain
        bonds, step, found = self.kind in _BOND_KINDS, self.step, self.found
        for d in self.arrays:
            if not d.written:
                continue
            made, own = after[d.key], c is not None and (d.key, d.part) == (c.key, c.part)
            wrote = False
            if made.tobytes() != given[d.key]:
                before = np.frombuffer(given[d.key], dtype=made.dtype).reshape(made.shape)
                wrote = _changed(before[d.part], made[d.part]).any()
            if wrote and d.owner is not None:
                (found.adds if bonds else found.writes).add(d.name)
            if c is None or (own and not wrote) or made.tobytes() == self.plain[d.key].tobytes():
                continue
            differ = _changed(self.plain[d.key][d.part], made[d.part])
            if not differ.any():
                continue
            if c.owner is None:
                found.adds |= {d.name} if d.owner is not None else set()
            elif d.owner is not None:
                ghost = step.ghost[d.owner[(d.owner >= 0) & differ]]
                if ghost.any():
                    found.own.add(c.name)
                if not ghost.all():
                    found.ends.add(c.name)
                    found.adds |= set() if bonds else {d.name}
            elif d.of_bonds:
                bond = step.bonds_of(d)
                # a crack reads its own halves anyway
                if c.axes[0] != "halves" or (bond is not None and (~step.alien[bond[differ]]).any()):
                    found.ends.add(c.name)
                if bond is not None and (step.inner[bond[differ]]).any():
                    found.around.add(c.name)
            elif self.kind in ("of_bonds", "of_cracks"):  # a sum over bonds
                found.ends.add(c.name)


def states(case: Case, steps: list[int]) -> Iterator[State]:
    """Yield the states of a case after numbers of steps."""
    model, start, _, dt, options = case
    loop = CoreLoop(model, Plan(duration=1.0, dt=dt, **{**options, "every": 0}), start(model), dt)
    loop.record_present()
    for step in steps:
        if step > loop.state.step:
            loop.run(step - loop.state.step)
        yield loop.state.copy()
