"""Sums of loads and motion of elements on a device."""

from typing import Any

from bondem._device import IndexPass, Launch
from bondem._tables.device_tables import BondsOfElements, DeviceSpan, LoadsOfBonds
from bondem._tables.step_tables import Dashpots, Moving, Resistance, Rows, StepCut
from bondem.dynamics.on_device.translation import Counterpart, Translation, elements, over

_open_element = IndexPass("open_element", DeviceSpan, Moving)
_open_element_or_row = IndexPass("open_element_or_row", DeviceSpan, Moving, Rows)
_gather_loads = IndexPass("gather_loads", StepCut, BondsOfElements, LoadsOfBonds)
_gather_dashpots = IndexPass("gather_dashpots", StepCut, BondsOfElements, LoadsOfBonds, Dashpots)

_FREE, _HELD = (DeviceSpan, Moving, StepCut), (DeviceSpan, Moving, StepCut, Rows)
_OF_BONDS = BondsOfElements, LoadsOfBonds
# By whether loads act beside those of bonds, and by rows and resistance.
_MOVES = {
    (False, False, False): IndexPass("move_gathered", *_FREE, *_OF_BONDS),
    (False, False, True): IndexPass("move_gathered_resisted", *_FREE, *_OF_BONDS, Resistance),
    (False, True, False): IndexPass("move_gathered_row", *_HELD, *_OF_BONDS),
    (False, True, True): IndexPass("move_gathered_resisted_row", *_HELD, *_OF_BONDS, Resistance),
    (True, False, False): IndexPass("move_summed", *_FREE),
    (True, False, True): IndexPass("move_summed_resisted", *_FREE, Resistance),
    (True, True, False): IndexPass("move_summed_row", *_HELD),
    (True, True, True): IndexPass("move_summed_resisted_row", *_HELD, Resistance),
}


def _move(run: Translation, moving: Moving, cut: StepCut, resistance: Resistance | None = None) -> list[Launch]:
    return [(*_mover(run, None, resistance), (run.span, moving, cut, *_given(run, resistance)))]


def _move_rows(
    run: Translation, moving: Moving, cut: StepCut, rows: Rows, resistance: Resistance | None = None
) -> list[Launch]:
    return [(*_mover(run, rows, resistance), (run.span, moving, cut, rows, *_given(run, resistance)))]


def _mover(run: Translation, rows: Rows | None, resistance: Resistance | None) -> tuple[IndexPass, int]:
    count = run.span.n - run.held if rows is None else run.held
    return _MOVES[run.further, rows is not None, resistance is not None], count


def _given(run: Translation, resistance: Resistance | None) -> list[Any]:
    """Return further tables of the pass that moves elements."""
    tables: list[Any] = [] if run.further else [run.bonds, run.loads]
    return tables if resistance is None else [*tables, resistance]


def _gather(run: Translation, cut: StepCut) -> list[Launch]:
    """Where nothing else acts on elements, they add up their loads as they move."""
    return [(_gather_loads, run.span.n, (cut, run.bonds, run.loads))] if run.further else []


def _gather_dashed(run: Translation, cut: StepCut, dashpots: Dashpots) -> list[Launch]:
    return [(_gather_dashpots, run.span.n, (cut, run.bonds, run.dashed, dashpots))]


COUNTERPARTS: dict[str, Counterpart] = {
    "open_elements": over(_open_element, elements),
    "open_elements_and_rows": over(_open_element_or_row, elements),
    "collect_sums": _gather,
    "collect_dashpots": _gather_dashed,
    "add_dashpots": lambda *_: [],  # together with the sums of the dashpots
    "move_elements": _move,
    "move_resisted": _move,
    "move_rows": _move_rows,
    "move_resisted_rows": _move_rows,
}
