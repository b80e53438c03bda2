"""Cracks of bodies of cells on a device: their beginning in a run, opening, rest, softening, and forces."""

import numpy as np

from bondem._device import Launch
from bondem._passes import kernels
from bondem._tables.cell_tables import CellDilatation, ElasticFacets, FacetForces
from bondem._tables.columns import CRACKS_OF_PORTION, PORTIONS_OF_LOSSES, CrackNumber
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
from bondem._tables.device_tables import LossesOfCracks
from bondem._tables.step_tables import Moving
from bondem.damage.cohesive_tables import BEGAN
from bondem.dynamics.on_device.translation import Counterpart, Translation, bonds, elements, over


def _losses(run: Translation, cracks: CohesiveCracks) -> LossesOfCracks:
    """Return the table of the dissipation of cracks in a step."""

    def make() -> LossesOfCracks:
        m = run.span.m
        portions = -(-m // CRACKS_OF_PORTION)
        made = LossesOfCracks(
            np.zeros(m), np.zeros(portions), np.zeros(-(-portions // PORTIONS_OF_LOSSES)),
            np.zeros(m, dtype=np.int64),
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
    """Give the cracks of the state the numbers of their facets, also as places of the lists."""
    count, m = int(cracks.size[CrackNumber.CRACKS]), run.span.m
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
        cracks.size[CrackNumber.CRACKS] = len(facet)

    run.before_keeping.append(order)
    return [
        (kernels.begin_all_levers(facets, cracks), 1),
        (kernels.restore_crack(facets, kept, strengths, cracks), m),
    ]


def _weigh(
    run: Translation, _: ElasticFacets, cells: CellDilatation, slack: CellSlack, cracks: CohesiveCracks
) -> list[Launch]:
    return [(kernels.weigh_cell(cells, slack, cracks), run.span.n)]


def _halves(run: Translation, cracks: CohesiveCracks, lists: CrackLists) -> Launch:
    return kernels.link_halves(cracks, lists, run.bonds), run.span.n


def _carry(run: Translation, stresses: StressesOfCells, cracks: CohesiveCracks, lists: CrackLists) -> list[Launch]:
    return [_halves(run, cracks, lists), (kernels.carry_cell(stresses, cracks, lists), run.span.n)]


# ---- steps


def _list(run: Translation, _: ElasticFacets, cracks: CohesiveCracks, lists: CrackLists) -> list[Launch]:
    return [_halves(run, cracks, lists)]


def _measure(
    run: Translation, moving: Moving, facets: ElasticFacets, slack: CellSlack, stresses: StressesOfCells,
    cracks: CohesiveCracks, lists: CrackLists,
) -> list[Launch]:  # fmt: skip
    losses = _losses(run, cracks)
    return [(kernels.measure_crack(run.span, moving, facets, slack, stresses, cracks, lists, losses), run.span.m)]


def _wake(
    run: Translation, moving: Moving, facets: ElasticFacets, cells: CellDilatation, slack: CellSlack,
    cracks: CohesiveCracks, lists: CrackLists,
) -> list[Launch]:  # fmt: skip
    return [
        (kernels.wake_crack(moving, facets, cracks, lists), run.span.m),
        (kernels.take_woken(run.span, moving, facets, cells, slack, cracks, lists), run.span.n),
    ]


def _leave(
    run: Translation, moving: Moving, facets: ElasticFacets, cells: CellDilatation, slack: CellSlack,
    cracks: CohesiveCracks, lists: CrackLists,
) -> list[Launch]:  # fmt: skip
    return [
        (kernels.part_crack(moving, facets, slack, cracks, lists, _losses(run, cracks)), run.span.m),
        (kernels.leave_crack(facets, cracks, lists), run.span.m),
        (kernels.take_leaving(run.span, moving, facets, cells, slack, cracks, lists), run.span.n),
    ]


def _touch(
    run: Translation, moving: Moving, pairs: ContactPairs, _: NearPairs, cracks: CohesiveCracks, lists: CrackLists,
    reach: PartedReach,
) -> list[Launch]:  # fmt: skip
    return [(kernels.touch_parted_face(moving, pairs, cracks, lists, reach), run.span.m)]


def _load(
    run: Translation, moving: Moving, facets: ElasticFacets, strengths: FacetStrengths, stresses: StressesOfCells,
    cracks: CohesiveCracks, lists: CrackLists,
) -> list[Launch]:  # fmt: skip
    losses = _losses(run, cracks)
    return [(kernels.load_crack(run.span, moving, facets, strengths, stresses, cracks, lists, losses), run.span.m)]


def _slide(
    run: Translation, moving: Moving, facets: ElasticFacets, stresses: StressesOfCells, cracks: CohesiveCracks,
    lists: CrackLists,
) -> list[Launch]:  # fmt: skip
    return [
        (kernels.sum_cracks_of_cell(stresses, cracks, lists), run.span.n),
        (kernels.slide_crack_of(run.span, moving, facets, cracks, lists), run.span.m),
    ]


def _log(
    run: Translation, moving: Moving, facets: ElasticFacets, cracks: CohesiveCracks, _: CrackLists, log: EventLog
) -> list[Launch]:
    run.keep_log(log)
    losses = _losses(run, cracks)
    return [
        (kernels.sum_portion_of_losses(run.span, losses), len(losses.portion)),
        (kernels.sum_group_of_losses(losses), len(losses.group)),
        (kernels.log_all_cracks(run.span, moving, facets, cracks, log, losses), 1),
    ]


COUNTERPARTS: dict[str, Counterpart] = {
    "link_cracks": _link,
    "weigh_cracked_cells": _weigh,
    "carry_cracks": _carry,
    "list_cracks": _list,
    "begin_bases": over(kernels.begin_base, elements),
    "measure_cracks": _measure,
    "relax_cracked_cells": over(kernels.relax_cell, elements, spans=False),
    "relax_stale_cells": over(kernels.relax_stale_cell, elements, spans=False),
    "watch_resting_cracks": over(kernels.watch_resting_crack, bonds),
    "wake_cracks": _wake,
    "soften_cracks": over(kernels.soften_crack, bonds),
    "leave_cracks": _leave,
    "touch_parted_faces": _touch,
    "load_cracks": _load,
    "slide_cracks": _slide,
    "log_cracks": _log,
    "add_crack_loads": over(kernels.add_crack_load, elements),
}
