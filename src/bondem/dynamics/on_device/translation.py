"""Translation of the passes of a step into launches: the common part of all counterparts."""

from collections.abc import Callable, Iterable
from typing import Any, TypeVar

import numpy as np

from bondem._device import Launch
from bondem._passes import Kernel, StepEntry, kernels
from bondem._tables.columns import (
    BONDS_OF_PORTION,
    DEVICE_SUMS,
    ELEMENTS_OF_PORTION,
    PORTIONS_OF_GROUP,
    WORKS_OF_PORTION,
)
from bondem._tables.damage_tables import EventLog
from bondem._tables.device_tables import (
    BondsOfElements,
    DeviceSpan,
    FoldedPortions,
    LoadsOfBonds,
    RowOrder,
    WorkPortions,
)
from bondem._tables.step_tables import Portions, Rows, StepCut
from bondem.dynamics.on_device.device_tables import new_row_order
from bondem.specimen.ordering import Layout

_T = TypeVar("_T")



class Translation:
    """Tables of one run that counterparts share.

    Args:
        layout: elements and bonds.
        cut: cut of a step into one block, whose list has the elements that own rows of the boundary last.
        rows: number of rows of the boundary.
        works: number of works.
        postponed: elements that failures postpone, uint8, (n,), or (0,) where nothing fails.
        further: whether loads act on elements beside those of their bonds; their sums are in memory then.

    Attributes:
        cut: cut of the step.
        span: clock of the run, elements and bonds.
        bonds: bonds of each element.
        loads: loads of each bond on its ends.
        dashed: loads of the dashpots of each bond.
        further: whether loads act beside those of bonds.
        held: number of elements that own rows.
        walls: motion, forces and work of walls, (w, 27), or None.
        logs: events of the run, whose rows are copied as far as they are filled.
        scratch: arrays of zeros of counterparts that only the device reads.
        before_keeping: functions that convert tables copied from the device to the form of the CPU.
    """

    def __init__(
        self, layout: Layout, cut: StepCut, rows: int, works: int, postponed: np.ndarray, *, further: bool
    ) -> None:
        n, m = len(layout.order), len(layout.i)
        self.cut, self.further = cut, further
        self.held = n - int(cut.held[0])
        self.span = DeviceSpan(np.zeros(9, dtype=np.int64), postponed, np.zeros(1, dtype=np.int64), n, m)
        self.bonds = BondsOfElements(
            layout.in_start.astype(np.int32), layout.out_start.astype(np.int32), np.ascontiguousarray(layout.out_bond)
        )
        self.loads, self.dashed = LoadsOfBonds(np.zeros((9, m))), LoadsOfBonds(np.zeros((9, m)))
        self._works = WorkPortions(np.zeros((-(-works // WORKS_OF_PORTION), 2)))
        most = max(-(-n // ELEMENTS_OF_PORTION), -(-m // BONDS_OF_PORTION), len(self._works.works), 1)
        self.folded = FoldedPortions(np.zeros((-(-most // PORTIONS_OF_GROUP), DEVICE_SUMS)))
        self.logs: list[EventLog] = []
        self.scratch: list[np.ndarray] = []
        self.before_keeping: list[Callable[[], None]] = []
        self.walls: np.ndarray | None = None
        self._rows = rows
        self._made: dict[int, tuple[Any, Any]] = {}

    @property
    def work_spaces(self) -> list[np.ndarray]:
        """Arrays that only the device reads."""
        return [self.loads.load, self.dashed.load, self.cut.sums, *self.scratch, *(log.event for log in self.logs)]

    def keep_log(self, log: EventLog) -> None:
        """Take note of a table of events."""
        if not any(log is known for known in self.logs):
            self.logs.append(log)

    def once(self, of: Any, make: Callable[[], _T]) -> _T:
        """Return the object of a table or an array, which is made at the first request."""
        if id(of) not in self._made:
            self._made[id(of)] = of, make()
        return self._made[id(of)][1]

    def dropped(self, tables: Iterable[Any]) -> list[Any]:
        """Remove and return the objects of tables that are out of date."""
        return [self._made.pop(id(table))[1] for table in tables if id(table) in self._made]

    def order_of(self, row: np.ndarray) -> RowOrder:
        """Return the order of loads and walls that act on rows of the boundary."""
        return self.once(row, lambda: new_row_order(row, self._rows))

    def fold(self, rows: Rows, portions: Portions) -> list[Launch]:
        """Return the launches that sum works, and all sums over portions."""
        return [
            (kernels.sum_portion_of_works(rows, self._works), len(self._works.works)),
            (kernels.fold_portions(portions, self._works, self.folded), self.folded.sums.size),
        ]


#: Passes over an index, of their tables (`bondem._passes.kernels`).
KernelOf = Callable[..., Kernel]
#: Launches that do what a pass does, of the tables of the pass.
Counterpart = Callable[..., list[Launch]]


def over(one: KernelOf, count: Callable[[Translation], int], *, spans: bool = True) -> Counterpart:
    """Return the counterpart of a pass that is one launch with the tables of the pass.

    Args:
        one: pass over an index.
        count: number of indices.
        spans: whether its first table is that of the clock.
    """

    def counterpart(run: Translation, *tables: Any) -> list[Launch]:
        return [(one(run.span, *tables) if spans else one(*tables), count(run))]

    return counterpart


def elements(run: Translation) -> int:
    """Return the number of elements."""
    return run.span.n


def bonds(run: Translation) -> int:
    """Return the number of bonds or facets."""
    return run.span.m


def names_of(passes: Iterable[StepEntry]) -> set[str]:
    """Return the names of passes."""
    return {one.name for one in passes}
