"""Translation of the passes of a step into kernel launches on a device: functions common to all passes."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from inspect import get_annotations
from typing import Any, TypeVar

import numpy as np

from bondem._device import Launch
from bondem._indices import group_starts
from bondem._passes import Kernel
from bondem._tables.damage_tables import EventLog
from bondem._tables.device_tables import BondsOfElements, DeviceSpan, LoadsOfBonds, RowOrder
from bondem._tables.step_tables import Ledger, StepBlocks
from bondem._types import Ints, Uint32s
from bondem.specimen.ordering import Layout

_T = TypeVar("_T")


class Translation:
    """Tables of one run on a device, which the counterparts of all passes share.

    Args:
        layout: elements and bonds.
        blocks: division of a step into one block, which lists fixed, driven and loaded elements last.
        ledger: sums of energies for a record or for a check of the energy.
        rows: number of rows, one per element that is fixed, driven or loaded.
        postponed: elements that failures postpone, uint8, (n,), or (0,) where nothing fails.
        further: True if loads act on elements in addition to those of bonds; the sums are then stored in memory.

    Attributes:
        blocks: division of the step into blocks.
        ledger: sums of energies for a record or for a check of the energy.
        span: clock of the run, elements and bonds.
        bonds: bonds of each element.
        loads: loads of each bond on its ends.
        dashed: loads of the dashpots of each bond.
        further: True if loads act on elements in addition to those of bonds.
        owners: number of elements that are fixed, driven or loaded.
        logs: events of the run, whose rows are copied as far as they are filled.
        scratch: arrays of zeros that counterparts have made and only the device reads.
        before_keeping: functions that convert tables copied from the device to the form of the CPU.
    """

    def __init__(
        self, layout: Layout, blocks: StepBlocks, ledger: Ledger, rows: int, postponed: np.ndarray, *, further: bool
    ) -> None:
        n, m = len(layout.order), len(layout.i)
        self.blocks, self.ledger, self.further = blocks, ledger, further
        self.owners = n - int(blocks.first_owner[0])
        self.span = DeviceSpan(np.zeros(9, dtype=np.int64), postponed, np.zeros(1, dtype=np.int64), n, m)
        self.bonds = BondsOfElements(
            layout.in_start.astype(np.int32), layout.out_start.astype(np.int32), np.ascontiguousarray(layout.out_bond)
        )
        self.loads, self.dashed = LoadsOfBonds(np.zeros((9, m))), LoadsOfBonds(np.zeros((9, m)))
        self.logs: list[EventLog] = []
        self.scratch: list[np.ndarray] = []
        self.before_keeping: list[Callable[[], None]] = []
        self._rows = rows
        self._made: dict[int, tuple[Any, Any]] = {}

    @property
    def work_spaces(self) -> list[np.ndarray]:
        """Arrays that exist on the device only."""
        return [self.loads.load, self.dashed.load, self.blocks.sums, *self.scratch, *(log.event for log in self.logs)]

    def keep_log(self, log: EventLog) -> None:
        """Register a table of events, unless it is registered already."""
        if not any(log is known for known in self.logs):
            self.logs.append(log)

    def once(self, of: Any, make: Callable[[], _T]) -> _T:
        """Return the object that belongs to a table or array; `make` makes it at the first request."""
        if id(of) not in self._made:
            self._made[id(of)] = of, make()
        return self._made[id(of)][1]

    def dropped(self, tables: Iterable[Any]) -> list[Any]:
        """Remove and return the objects that `once` has made for tables that are out of date."""
        return [self._made.pop(id(table))[1] for table in tables if id(table) in self._made]

    def order_of(self, row: np.ndarray) -> RowOrder:
        """Return the order of loads and walls that act on rows of the boundary."""
        return self.once(row, lambda: new_row_order(row, self._rows))


def new_row_order(row: Ints | Uint32s, rows: int) -> RowOrder:
    """Return the order of loads or walls by the row on which each acts, `row`, where `rows` is the number of rows."""
    return RowOrder(group_starts(row, rows), np.argsort(row, kind="stable").astype(np.int64))


#: Function that returns a pass over an index, given its tables (`bondem._passes.kernels`).
KernelOf = Callable[..., Kernel]
#: Function that returns the launches for a pass, given its tables.
Counterpart = Callable[..., list[Launch]]
#: Tables of a pass by their classes.
Given = Mapping[type, Any]
#: Function that returns the number of indices of a launch.
Count = Callable[[Translation, Given], int]
#: Functions that return tables that only a device has, by the class of the table.
Made = Mapping[type, Callable[[Translation, Given], Any]]

_OF_RUN: Made = {
    DeviceSpan: lambda run, _: run.span,
    StepBlocks: lambda run, _: run.blocks,
    Ledger: lambda run, _: run.ledger,
    BondsOfElements: lambda run, _: run.bonds,
    LoadsOfBonds: lambda run, _: run.loads,
}


@dataclass(frozen=True)
class Launches:
    """Counterpart that launches kernels with the tables of the pass, and changes nothing else.

    Each kernel receives tables of the classes of its arguments: those of the pass or, for other classes, those that
    only the device has. No pass has two tables of one class.

    Attributes:
        parts: kernels in their order, each with its number of indices and the tables to make for it.
    """

    parts: tuple[tuple[KernelOf, Count, Made], ...] = ()

    def __call__(self, run: Translation, *tables: Any) -> list[Launch]:
        """Return the launches of a pass with these tables."""
        given = {type(table): table for table in tables}
        launches: list[Launch] = []
        for one, count, made in self.parts:
            ways = {**_OF_RUN, **made}
            found = [given[kind] if kind in given else ways[kind](run, given) for kind in tables_of(one)]
            launches.append((one(*found), count(run, given)))
        return launches


def tables_of(one: KernelOf) -> list[type]:
    """Return the classes of the tables that a kernel takes."""
    return [kind for name, kind in get_annotations(one).items() if name != "return"]


def over(one: KernelOf, count: Count, made: Made | None = None) -> Launches:
    """Return the counterpart of a pass that is one launch.

    Args:
        one: kernel, which each thread calls with an index.
        count: number of indices.
        made: tables that only a device has, in addition to those of every run.
    """
    return Launches(((one, count, {} if made is None else made),))


def in_order(*launches: Launches) -> Launches:
    """Return the counterpart of a pass that is several launches, or none."""
    return Launches(tuple(part for one in launches for part in one.parts))


def gathered_or_summed(gathered: KernelOf, summed: KernelOf, count: Count) -> Launches:
    """Return the counterpart of a pass that reads sums of loads.

    Args:
        gathered: kernel that adds up the loads of the bonds of its element.
        summed: kernel for runs with further loads on elements, whose sums are in memory.
        count: number of indices.
    """
    return in_order(
        over(gathered, lambda run, given: 0 if run.further else count(run, given)),
        over(summed, lambda run, given: count(run, given) if run.further else 0),
    )


def ordered(kind: type[_T], row: Callable[[_T], np.ndarray]) -> Made:
    """Return the rule that makes the order of loads or walls by their rows, from a column of a table of the pass."""
    return {RowOrder: lambda run, given: run.order_of(row(given[kind]))}
