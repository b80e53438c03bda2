"""Kernel launches on a device for the passes of cracks between cells: start of a run, opening, softening, forces."""

import numpy as np

from bondem._device import Launch
from bondem._passes import kernels
from bondem._tables.cell_tables import ElasticFacets, FacetForces
from bondem._tables.columns import CrackNumber
from bondem._tables.crack_tables import CohesiveCracks, CrackLists, FacetStrengths
from bondem._tables.damage_tables import EventLog
from bondem._tables.device_tables import FallenCracks
from bondem._tables.step_tables import Moving
from bondem.damage.cohesive_tables import BEGAN
from bondem.dynamics.on_device import counts
from bondem.dynamics.on_device.translation import Counterpart, Made, Translation, in_order, over


def _fallen(run: Translation, cracks: CohesiveCracks) -> FallenCracks:
    """Return the table of the cracks that break in a step, the same one for all launches of a run."""

    def make() -> FallenCracks:
        made = FallenCracks(np.zeros(run.span.m, dtype=np.int64), np.zeros(1, dtype=np.int64))
        run.scratch += [made.fallen]
        return made

    return run.once(cracks, make)


def _link(
    run: Translation, facets: ElasticFacets, stored: FacetForces, strengths: FacetStrengths, cracks: CohesiveCracks,
    lists: CrackLists,
) -> list[Launch]:  # fmt: skip
    """Index the cracks of a state: on a device, the place of a crack in the lists is the number of its facet."""
    count, m = int(cracks.size[CrackNumber.CRACKS]), run.span.m
    facet = cracks.order[:count]
    cracks.listed[facet] = 1 + cracks.history[facet, 0].astype(np.uint8)
    cracks.history[facet, BEGAN] = np.arange(-count, 0)
    lists.treated[:m] = np.arange(m)
    run.scratch += [lists.half, lists.sum, lists.slip]
    run.scratch += [lists.next, lists.flag, lists.waking]

    def order() -> None:
        """Write the order in which cracks began to the table of cracks."""
        facet = np.flatnonzero(cracks.listed[:m])
        cracks.order[: len(facet)] = facet[np.argsort(cracks.history[facet, BEGAN], kind="stable")]
        cracks.size[CrackNumber.CRACKS] = len(facet)

    run.before_keeping.append(order)
    return [
        (kernels.begin_all_levers(facets, cracks), 1),
        (kernels.restore_crack(facets, stored, strengths, cracks), m),
    ]


def _log(
    run: Translation, moving: Moving, facets: ElasticFacets, cracks: CohesiveCracks, lists: CrackLists, log: EventLog
) -> list[Launch]:
    run.keep_log(log)
    return [(kernels.log_all_cracks(run.span, moving, facets, cracks, lists, log, _fallen(run, cracks)), 1)]


_FALLEN: Made = {FallenCracks: lambda run, given: _fallen(run, given[CohesiveCracks])}
_HALVES = over(kernels.link_halves, counts.elements)

COUNTERPARTS: dict[str, Counterpart] = {
    "link_cracks": _link,
    "weigh_cracked_cells": over(kernels.weigh_cell, counts.elements),
    "carry_cracks": in_order(_HALVES, over(kernels.carry_cell, counts.elements)),
    "list_cracks": _HALVES,
    "begin_bases": over(kernels.begin_base, counts.elements),
    "measure_cracks": over(kernels.measure_crack, counts.bonds),
    "relax_cracked_cells": over(kernels.relax_cell, counts.elements),
    "relax_outdated_cells": over(kernels.relax_outdated_cell, counts.elements),
    "watch_resting_cracks": over(kernels.watch_resting_crack, counts.bonds),
    "wake_cracks": in_order(over(kernels.wake_crack, counts.bonds), over(kernels.take_woken, counts.elements)),
    "soften_cracks": over(kernels.soften_crack, counts.bonds),
    "leave_cracks": in_order(
        over(kernels.part_crack, counts.bonds),
        over(kernels.leave_crack, counts.bonds),
        over(kernels.take_leaving, counts.elements),
    ),
    "touch_parted_faces": over(kernels.touch_parted_face, counts.bonds),
    "load_cracks": over(kernels.load_crack, counts.bonds, _FALLEN),
    "sum_cracks": over(kernels.sum_cracks_of_cell, counts.elements),
    "slide_cracks": over(kernels.slide_crack_of, counts.bonds),
    "log_cracks": _log,
    "add_crack_loads": over(kernels.add_crack_load, counts.elements),
}
