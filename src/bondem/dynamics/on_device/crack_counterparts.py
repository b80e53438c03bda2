"""Cracks of bodies of cells on a device: their beginning in a run, opening, rest, softening, and forces."""

import numpy as np

from bondem._device import IndexPass, Launch
from bondem._tables.cell_tables import CellDilatation, ElasticFacets, FacetForces
from bondem._tables.contact_tables import ContactPairs, NearPairs
from bondem._tables.crack_tables import (
    CellSlack,
    CohesiveCracks,
    CrackLists,
    FacetStrengths,
    PartedReach,
    StressesOfCells,
)
from bondem._tables.damage_tables import EventLog
from bondem._tables.device_tables import BondsOfElements, DeviceSpan, LossesOfCracks
from bondem._tables.step_tables import Moving, StepCut
from bondem.dynamics.cohesive_tables import BEGAN
from bondem.dynamics.on_device.translation import Counterpart, Translation, bonds, elements, over

# Facets of a portion of what cracks dissipate, and portions of a group, as in `core/gpu/cracks.hpp`.
_PORTION, _GROUP = 256, 64

_CRACKS = ElasticFacets, CohesiveCracks, CrackLists
_begin_levers = IndexPass("begin_all_levers", ElasticFacets, CohesiveCracks)
_restore_crack = IndexPass("restore_crack", ElasticFacets, FacetForces, FacetStrengths, CohesiveCracks)
_weigh_cell = IndexPass("weigh_cell", CellDilatation, CellSlack, CohesiveCracks)
_carry_cell = IndexPass("carry_cell", StressesOfCells, CohesiveCracks, CrackLists)
_link_halves = IndexPass("link_halves", CohesiveCracks, CrackLists, BondsOfElements)
_begin_base = IndexPass("begin_base", DeviceSpan, Moving, CellDilatation, CrackLists)
_measure_crack = IndexPass(
    "measure_crack", DeviceSpan, Moving, ElasticFacets, CellSlack, StressesOfCells, CohesiveCracks, CrackLists,
    LossesOfCracks,
)  # fmt: skip
_relax_cell = IndexPass("relax_cell", Moving, CellDilatation, CrackLists)
_relax_stale_cell = IndexPass("relax_stale_cell", Moving, CellDilatation, CrackLists)
_JUDGED = DeviceSpan, Moving, ElasticFacets, FacetStrengths, StressesOfCells, CohesiveCracks, CrackLists
_watch_resting_crack = IndexPass(
    "watch_resting_crack", DeviceSpan, Moving, ElasticFacets, FacetStrengths, CohesiveCracks, CrackLists
)
_wake_crack = IndexPass("wake_crack", Moving, *_CRACKS)
_CHANGED = DeviceSpan, Moving, ElasticFacets, CellDilatation, CellSlack, CohesiveCracks, CrackLists
_take_woken = IndexPass("take_woken", *_CHANGED)
_soften_crack = IndexPass("soften_crack", *_JUDGED)
_part_crack = IndexPass("part_crack", Moving, ElasticFacets, CellSlack, CohesiveCracks, CrackLists, LossesOfCracks)
_leave_crack = IndexPass("leave_crack", *_CRACKS)
_take_leaving = IndexPass("take_leaving", *_CHANGED)
_touch_parted_face = IndexPass(
    "touch_parted_face", Moving, ContactPairs, CohesiveCracks, CrackLists, PartedReach
)  # fmt: skip
_load_crack = IndexPass("load_crack", *_JUDGED, LossesOfCracks)
_sum_cell = IndexPass("sum_cracks_of_cell", StressesOfCells, CohesiveCracks, CrackLists)
_slide_crack = IndexPass("slide_crack_of", DeviceSpan, Moving, *_CRACKS)
_add_crack_load = IndexPass("add_crack_load", DeviceSpan, Moving, CrackLists, StepCut)
_sum_portion = IndexPass("sum_portion_of_losses", DeviceSpan, LossesOfCracks)
_sum_group = IndexPass("sum_group_of_losses", LossesOfCracks)
_log_cracks = IndexPass("log_all_cracks", DeviceSpan, Moving, ElasticFacets, CohesiveCracks, EventLog, LossesOfCracks)


def _losses(run: Translation, cracks: CohesiveCracks) -> LossesOfCracks:
    """Return what the cracks of a run dissipate in a step."""

    def make() -> LossesOfCracks:
        m = run.span.m
        portions = -(-m // _PORTION)
        made = LossesOfCracks(
            np.zeros(m), np.zeros(portions), np.zeros(-(-portions // _GROUP)), np.zeros(m, dtype=np.int64),
            np.zeros(1, dtype=np.int64),
        )  # fmt: skip
        run.scratch += [made.lost, made.portion, made.group, made.fallen]
        return made

    return run.once(cracks, make)


# ---- the beginning of a run


def _link(
    run: Translation, facets: ElasticFacets, kept: FacetForces, strengths: FacetStrengths, cracks: CohesiveCracks,
    lists: CrackLists,
) -> list[Launch]:  # fmt: skip
    """Cracks of the state are named by their facets, and places of lists are facets."""
    count, m = int(cracks.size[0]), run.span.m
    facet = cracks.order[:count]
    cracks.listed[facet] = 1 + cracks.history[facet, 0].astype(np.uint8)
    cracks.history[facet, BEGAN] = np.arange(-count, 0)
    lists.treated[:m] = np.arange(m)
    lists.number[:m] = np.arange(1, 2 * m + 1).reshape(m, 2)
    run.scratch += [lists.half, lists.sum, lists.slip]
    run.scratch += [lists.node, lists.side, lists.flag, lists.waking]

    def order() -> None:
        """Write the order in which cracks began."""
        facet = np.flatnonzero(cracks.listed[:m])
        cracks.order[: len(facet)] = facet[np.argsort(cracks.history[facet, BEGAN], kind="stable")]
        cracks.size[0] = len(facet)

    run.before_keeping.append(order)
    return [
        (_begin_levers, 1, (facets, cracks)),
        (_restore_crack, m, (facets, kept, strengths, cracks)),
    ]


def _weigh(
    run: Translation, _: ElasticFacets, cells: CellDilatation, slack: CellSlack, cracks: CohesiveCracks
) -> list[Launch]:
    return [(_weigh_cell, run.span.n, (cells, slack, cracks))]


def _halves(run: Translation, cracks: CohesiveCracks, lists: CrackLists) -> Launch:
    return _link_halves, run.span.n, (cracks, lists, run.bonds)


def _carry(run: Translation, stresses: StressesOfCells, cracks: CohesiveCracks, lists: CrackLists) -> list[Launch]:
    return [_halves(run, cracks, lists), (_carry_cell, run.span.n, (stresses, cracks, lists))]


# ---- steps


def _list(run: Translation, _: ElasticFacets, cracks: CohesiveCracks, lists: CrackLists) -> list[Launch]:
    return [_halves(run, cracks, lists)]


def _measure(
    run: Translation, moving: Moving, facets: ElasticFacets, slack: CellSlack, stresses: StressesOfCells,
    cracks: CohesiveCracks, lists: CrackLists,
) -> list[Launch]:  # fmt: skip
    losses = _losses(run, cracks)
    return [(_measure_crack, run.span.m, (run.span, moving, facets, slack, stresses, cracks, lists, losses))]


def _wake(
    run: Translation, moving: Moving, facets: ElasticFacets, cells: CellDilatation, slack: CellSlack,
    cracks: CohesiveCracks, lists: CrackLists,
) -> list[Launch]:  # fmt: skip
    return [
        (_wake_crack, run.span.m, (moving, facets, cracks, lists)),
        (_take_woken, run.span.n, (run.span, moving, facets, cells, slack, cracks, lists)),
    ]


def _leave(
    run: Translation, moving: Moving, facets: ElasticFacets, cells: CellDilatation, slack: CellSlack,
    cracks: CohesiveCracks, lists: CrackLists,
) -> list[Launch]:  # fmt: skip
    return [
        (_part_crack, run.span.m, (moving, facets, slack, cracks, lists, _losses(run, cracks))),
        (_leave_crack, run.span.m, (facets, cracks, lists)),
        (_take_leaving, run.span.n, (run.span, moving, facets, cells, slack, cracks, lists)),
    ]


def _touch(
    run: Translation, moving: Moving, pairs: ContactPairs, _: NearPairs, cracks: CohesiveCracks, lists: CrackLists,
    reach: PartedReach,
) -> list[Launch]:  # fmt: skip
    return [(_touch_parted_face, run.span.m, (moving, pairs, cracks, lists, reach))]


def _load(
    run: Translation, moving: Moving, facets: ElasticFacets, strengths: FacetStrengths, stresses: StressesOfCells,
    cracks: CohesiveCracks, lists: CrackLists,
) -> list[Launch]:  # fmt: skip
    losses = _losses(run, cracks)
    return [(_load_crack, run.span.m, (run.span, moving, facets, strengths, stresses, cracks, lists, losses))]


def _slide(
    run: Translation, moving: Moving, facets: ElasticFacets, stresses: StressesOfCells, cracks: CohesiveCracks,
    lists: CrackLists,
) -> list[Launch]:  # fmt: skip
    return [
        (_sum_cell, run.span.n, (stresses, cracks, lists)),
        (_slide_crack, run.span.m, (run.span, moving, facets, cracks, lists)),
    ]


def _log(
    run: Translation, moving: Moving, facets: ElasticFacets, cracks: CohesiveCracks, _: CrackLists, log: EventLog
) -> list[Launch]:
    run.keep_log(log)
    losses = _losses(run, cracks)
    return [
        (_sum_portion, len(losses.portion), (run.span, losses)),
        (_sum_group, len(losses.group), (losses,)),
        (_log_cracks, 1, (run.span, moving, facets, cracks, log, losses)),
    ]


COUNTERPARTS: dict[str, Counterpart] = {
    "link_cracks": _link,
    "weigh_cracked_cells": _weigh,
    "carry_cracks": _carry,
    "list_cracks": _list,
    "begin_bases": over(_begin_base, elements),
    "measure_cracks": _measure,
    "relax_cracked_cells": over(_relax_cell, elements, spans=False),
    "relax_stale_cells": over(_relax_stale_cell, elements, spans=False),
    "watch_resting_cracks": over(_watch_resting_crack, bonds),
    "wake_cracks": _wake,
    "soften_cracks": over(_soften_crack, bonds),
    "leave_cracks": _leave,
    "touch_parted_faces": _touch,
    "load_cracks": _load,
    "slide_cracks": _slide,
    "log_cracks": _log,
    "add_crack_loads": over(_add_crack_load, elements),
}
