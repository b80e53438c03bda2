"""Passes of a device: for each pass that a step is composed of, the passes over an index that do the same.

The parts of a step (`bondem.solve.parts`) compose it once, for the CPU and for devices. A model runs on a device where
each of its passes has a counterpart here.
"""

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from bondem._device import IndexPass, Launch
from bondem.kernels.couples import CoupleTable
from bondem.kernels.tables import Gauges, Rows, StepCut, StepScheme, lines
from bondem.model.beam_tables import AlikeBeams, Beams
from bondem.model.layout import Layout
from bondem.solve.device_tables import (
    GROUP,
    SUM_COLUMNS,
    WORKS,
    LoadsOfBonds,
    BondsOfElements,
    DeviceSpan,
    FoldedPortions,
    GaugeParts,
    RowOrder,
    Tick,
    WorkPortions,
)
from bondem.solve.parts.part import Passes
from bondem.solve.step_tables import (
    BodyForces,
    Dashpots,
    Drives,
    HistoryRows,
    Moving,
    Portions,
    Resistance,
    RowLoads,
    Timeline,
)

# Elements of a part of a gauge about, and parts at most.
_GAUGED, _PARTS = 256, 1024
# Passes that add to the sums of elements beside the bonds.
_FURTHER = {"add_dashpot_loads", "add_body_forces"}

set_clock = IndexPass("set_clock", DeviceSpan, StepScheme, Tick)
count_record = IndexPass("count_record", DeviceSpan)
_clear_row = IndexPass("clear_row", Rows)
_follow_loads_of_row = IndexPass("follow_loads_of_row", DeviceSpan, Timeline, RowLoads, RowOrder, Moving, Rows)
_follow_all_couples = IndexPass("follow_all_couples", DeviceSpan, Timeline, CoupleTable, Moving, Rows)
_follow_drive = IndexPass("follow_drive", DeviceSpan, Timeline, Drives, Rows)
_follow_body_group = IndexPass("follow_body_group", DeviceSpan, Timeline, BodyForces)
_open_element = IndexPass("open_element", DeviceSpan, Moving)
_open_element_or_row = IndexPass("open_element_or_row", DeviceSpan, Moving, Rows)
_open_work_of_body = IndexPass("open_work_of_body", DeviceSpan, Moving, BodyForces)
_load_beam = IndexPass("load_beam", Moving, Beams, LoadsOfBonds)
_load_alike_beam = IndexPass("load_alike_beam", Moving, Beams, AlikeBeams, LoadsOfBonds)
_load_dashpot = IndexPass("load_dashpot", Moving, Beams, Dashpots, LoadsOfBonds)
_gather_loads = IndexPass("gather_loads", StepCut, BondsOfElements, LoadsOfBonds)
_gather_dashpots = IndexPass("gather_dashpots", StepCut, BondsOfElements, LoadsOfBonds, Dashpots)
_add_body_force = IndexPass("add_body_force", DeviceSpan, Moving, StepCut, BodyForces)
_add_work_of_body = IndexPass("add_work_of_body", DeviceSpan, Moving, StepCut, BodyForces)
_BY_BONDS = BondsOfElements, LoadsOfBonds
_move_gathered = IndexPass("move_gathered", DeviceSpan, Moving, StepCut, *_BY_BONDS)
_move_gathered_resisted = IndexPass("move_gathered_resisted", DeviceSpan, Moving, StepCut, *_BY_BONDS, Resistance)
_move_gathered_row = IndexPass("move_gathered_row", DeviceSpan, Moving, StepCut, Rows, *_BY_BONDS)
_move_gathered_resisted_row = IndexPass(
    "move_gathered_resisted_row", DeviceSpan, Moving, StepCut, Rows, *_BY_BONDS, Resistance
)
_move_summed = IndexPass("move_summed", DeviceSpan, Moving, StepCut)
_move_summed_resisted = IndexPass("move_summed_resisted", DeviceSpan, Moving, StepCut, Resistance)
_move_summed_row = IndexPass("move_summed_row", DeviceSpan, Moving, StepCut, Rows)
_move_summed_resisted_row = IndexPass("move_summed_resisted_row", DeviceSpan, Moving, StepCut, Rows, Resistance)
_check_portion = IndexPass("check_portion", DeviceSpan, Moving, Beams, Portions)
_sum_portion_of_beams = IndexPass("sum_portion_of_beams", DeviceSpan, Moving, Beams, Portions)
_sum_portion_of_elements = IndexPass("sum_portion_of_elements", DeviceSpan, Moving, Portions)
_sum_portion_of_works = IndexPass("sum_portion_of_works", Rows, WorkPortions)
_fold_portions = IndexPass("fold_portions", Portions, WorkPortions, FoldedPortions)
_write_sum = IndexPass("write_sum", DeviceSpan, FoldedPortions, HistoryRows)
_read_part_of_gauge = IndexPass("read_part_of_gauge", Moving, Rows, Gauges, GaugeParts)
_write_gauge = IndexPass("write_gauge", DeviceSpan, Gauges, GaugeParts, HistoryRows)


class DevicePasses:
    """Translates the passes of one run.

    Args:
        layout: elements and bonds.
        cut: cut of a step into one block.
        works: number of works.
        names: names of all passes of a step, in their order.
    """

    def __init__(self, layout: Layout, cut: StepCut, works: int, names: Iterable[str]) -> None:
        n, m = len(layout.order), len(layout.i)
        self.cut = cut
        self.span = DeviceSpan(np.zeros(9, dtype=np.int64), n, m)
        self.bonds = BondsOfElements(
            layout.in_start.astype(np.int32), layout.out_start.astype(np.int32), np.ascontiguousarray(layout.out_bond)
        )
        self.loads, self.dashed = LoadsOfBonds(np.zeros((9, m))), LoadsOfBonds(np.zeros((9, m)))
        self.work_portions = WorkPortions(np.zeros((-(-works // WORKS), 2)))
        most = max(-(-n // 1024), -(-m // 2048), len(self.work_portions.works), 1)
        self.folded = FoldedPortions(np.zeros((-(-most // GROUP), len(SUM_COLUMNS))))
        self._further = not _FURTHER.isdisjoint(names)
        self._gauge_parts: dict[int, GaugeParts] = {}

    @property
    def work_spaces(self) -> list[np.ndarray]:
        """Arrays that only the device reads."""
        return [self.loads.load, self.dashed.load, self.cut.sums]

    def __call__(self, passes: Passes) -> list[Launch]:
        """Return the launches of a list of passes."""
        return [launch for one, *tables in passes for launch in _COUNTERPARTS[one.name](self, *tables)]

    def fold(self, rows: Rows, portions: Portions) -> list[Launch]:
        """Return the launches that sum works, and all sums over portions."""
        count = self.folded.sums.size
        return [
            (_sum_portion_of_works, len(self.work_portions.works), (rows, self.work_portions)),
            (_fold_portions, count, (portions, self.work_portions, self.folded)),
        ]

    # ---- counterparts, by the tables of the pass

    def _follow_loads(self, timeline: Timeline, loads: RowLoads, moving: Moving, rows: Rows) -> list[Launch]:
        order = RowOrder.of(loads.row, len(rows.force))
        return [(_follow_loads_of_row, len(rows.force), (self.span, timeline, loads, order, moving, rows))]

    def _load(self, one: IndexPass, *tables: Any) -> list[Launch]:
        return [(one, self.span.m, (*tables, self.loads))]

    def _move(self, moving: Moving, rows: Rows | None, resistance: Resistance | None) -> list[Launch]:
        held = int(self.cut.held[0])
        count = held if rows is None else self.span.n - held
        one = _MOVES[self._further, rows is not None, resistance is not None]
        tables: list[Any] = [self.span, moving, self.cut]
        if rows is not None:
            tables.append(rows)
        if not self._further:
            tables += [self.bonds, self.loads]
        if resistance is not None:
            tables.append(resistance)
        return [(one, count, tuple(tables))]

    def _write_ledger(self, rows: Rows, portions: Portions, history: HistoryRows) -> list[Launch]:
        return [*self.fold(rows, portions), (_write_sum, len(SUM_COLUMNS), (self.span, self.folded, history))]

    def _read_gauges(self, moving: Moving, rows: Rows, gauges: Gauges, history: HistoryRows) -> list[Launch]:
        count = len(gauges.quantity)
        if id(gauges) not in self._gauge_parts:
            each = min(max(int(np.diff(gauges.start).max(initial=1)) // _GAUGED, 1), _PARTS)
            self._gauge_parts[id(gauges)] = GaugeParts(each, np.zeros((count * each, 3)))
        parts = self._gauge_parts[id(gauges)]
        return [
            (_read_part_of_gauge, count * parts.each, (moving, rows, gauges, parts)),
            (_write_gauge, 3 * count, (self.span, gauges, parts, history)),
        ]


# By whether there are loads beside those of bonds, rows, and resistance.
_MOVES = {
    (False, False, False): _move_gathered,
    (False, False, True): _move_gathered_resisted,
    (False, True, False): _move_gathered_row,
    (False, True, True): _move_gathered_resisted_row,
    (True, False, False): _move_summed,
    (True, False, True): _move_summed_resisted,
    (True, True, False): _move_summed_row,
    (True, True, True): _move_summed_resisted_row,
}

_P = DevicePasses
_COUNTERPARTS: dict[str, Callable[..., list[Launch]]] = {
    "clear_row_forces": lambda run, rows: [(_clear_row, len(rows.force), (rows,))],
    "follow_loads": _P._follow_loads,
    "follow_couples": lambda run, *tables: [(_follow_all_couples, 1, (run.span, *tables))],
    "follow_drives": lambda run, timeline, drives, rows: [
        (_follow_drive, len(drives.row), (run.span, timeline, drives, rows))
    ],
    "follow_body_forces": lambda run, timeline, body: [
        (_follow_body_group, len(body.present), (run.span, timeline, body))
    ],
    "open_elements": lambda run, moving: [(_open_element, run.span.n, (run.span, moving))],
    "open_elements_and_rows": lambda run, *tables: [(_open_element_or_row, run.span.n, (run.span, *tables))],
    "open_body_work": lambda run, *tables: [(_open_work_of_body, run.span.n, (run.span, *tables))],
    "add_beam_loads": lambda run, moving, beams, cut: run._load(_load_beam, moving, beams),
    "add_alike_beam_loads": lambda run, moving, beams, alike, cut: run._load(_load_alike_beam, moving, beams, alike),
    "add_dashpot_loads": lambda run, moving, beams, dashpots, cut: [
        (_load_dashpot, run.span.m, (moving, beams, dashpots, run.dashed))
    ],
    "collect_sums": lambda run, cut: (
        [(_gather_loads, run.span.n, (cut, run.bonds, run.loads))] if run._further else []
    ),
    "collect_dashpots": lambda run, cut, dashpots: [
        (_gather_dashpots, run.span.n, (cut, run.bonds, run.dashed, dashpots))
    ],
    "add_dashpots": lambda run, cut, dashpots: [],
    "add_body_forces": lambda run, moving, cut, body: [
        (_add_body_force, run.span.n, (run.span, moving, cut, body))
    ],
    "add_body_work": lambda run, moving, body: [(_add_work_of_body, run.span.n, (run.span, moving, run.cut, body))],
    "move_elements": lambda run, moving, cut: run._move(moving, None, None),
    "move_resisted": lambda run, moving, cut, resistance: run._move(moving, None, resistance),
    "move_rows": lambda run, moving, cut, rows: run._move(moving, rows, None),
    "move_resisted_rows": lambda run, moving, cut, rows, resistance: run._move(moving, rows, resistance),
    "check_beams": lambda run, moving, beams, portions: [
        (_check_portion, len(portions.turned), (run.span, moving, beams, portions))
    ],
    "sum_beam_energies": lambda run, moving, beams, portions: [
        (_sum_portion_of_beams, len(portions.bonds), (run.span, moving, beams, portions))
    ],
    "sum_element_energies": lambda run, moving, portions: [
        (_sum_portion_of_elements, len(portions.elements), (run.span, moving, portions))
    ],
    "judge_energy": lambda run, rows, portions: run.fold(rows, portions),
    "write_ledger": _P._write_ledger,
    "read_gauges": _P._read_gauges,
}


def lacking(passes: Passes) -> list[str]:
    """Return the names of passes that have no counterpart."""
    return [one.name for one, *_ in passes if one.name not in _COUNTERPARTS]
