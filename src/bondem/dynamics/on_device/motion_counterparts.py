"""Sums of loads and motion of elements on a device."""

from typing import Any

from bondem._device import Launch
from bondem._passes import kernels
from bondem._tables.step_tables import Dashpots, Moving, Resistance, Rows, StepCut
from bondem.dynamics.on_device.translation import Counterpart, KernelOf, Translation, elements, over

# By whether loads act beside those of bonds, and by rows and resistance.
_MOVES: dict[tuple[bool, bool, bool], KernelOf] = {
    (False, False, False): kernels.move_gathered,
    (False, False, True): kernels.move_gathered_resisted,
    (False, True, False): kernels.move_gathered_row,
    (False, True, True): kernels.move_gathered_resisted_row,
    (True, False, False): kernels.move_summed,
    (True, False, True): kernels.move_summed_resisted,
    (True, True, False): kernels.move_summed_row,
    (True, True, True): kernels.move_summed_resisted_row,
}


def _move(run: Translation, moving: Moving, cut: StepCut, resistance: Resistance | None = None) -> list[Launch]:
    one, count = _mover(run, None, resistance)
    return [(one(run.span, moving, cut, *_given(run, resistance)), count)]


def _move_rows(
    run: Translation, moving: Moving, cut: StepCut, rows: Rows, resistance: Resistance | None = None
) -> list[Launch]:
    one, count = _mover(run, rows, resistance)
    return [(one(run.span, moving, cut, rows, *_given(run, resistance)), count)]


def _mover(run: Translation, rows: Rows | None, resistance: Resistance | None) -> tuple[KernelOf, int]:
    count = run.span.n - run.held if rows is None else run.held
    return _MOVES[run.further, rows is not None, resistance is not None], count


def _given(run: Translation, resistance: Resistance | None) -> list[Any]:
    """Return further tables of the pass that moves elements."""
    tables: list[Any] = [] if run.further else [run.bonds, run.loads]
    return tables if resistance is None else [*tables, resistance]


def _gather(run: Translation, cut: StepCut) -> list[Launch]:
    """Return the launch that adds up loads; without further loads the motion of elements does it."""
    return [(kernels.gather_loads(cut, run.bonds, run.loads), run.span.n)] if run.further else []


def _gather_dashed(run: Translation, cut: StepCut, dashpots: Dashpots) -> list[Launch]:
    return [(kernels.gather_dashpots(cut, run.bonds, run.dashed, dashpots), run.span.n)]


COUNTERPARTS: dict[str, Counterpart] = {
    "open_elements": over(kernels.open_element, elements),
    "open_elements_and_rows": over(kernels.open_element_or_row, elements),
    "collect_sums": _gather,
    "collect_dashpots": _gather_dashed,
    "add_dashpots": lambda *_: [],  # together with the sums of the dashpots
    "move_elements": _move,
    "move_resisted": _move,
    "move_rows": _move_rows,
    "move_resisted_rows": _move_rows,
}
