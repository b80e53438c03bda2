"""Kernel launches on a device for the passes by which facets of cells break."""

from bondem._device import Launch
from bondem._passes import kernels
from bondem._tables.cell_tables import ElasticFacets, FacetRelease, WallConstraints
from bondem._tables.damage_tables import Candidates, EventLog
from bondem._tables.step_tables import Moving
from bondem.dynamics.on_device import counts
from bondem.dynamics.on_device.breakage_counterparts import MARKS, RANKED, counted, marks_of
from bondem.dynamics.on_device.cell_counterparts import BY_ROW_OF_WALLS
from bondem.dynamics.on_device.translation import Counterpart, Translation, in_order, over


def _break(
    run: Translation, moving: Moving, facets: ElasticFacets, walls: WallConstraints, release: FacetRelease,
    candidates: Candidates, log: EventLog,
) -> list[Launch]:  # fmt: skip
    removed = moving, facets, walls, release, marks_of(run), candidates
    return [
        (kernels.write_facet_failure(run.span, *removed, log), run.span.m),
        (kernels.end_facets_of_cell(*removed), run.span.n),
        counted(run, candidates, log),
    ]


COUNTERPARTS: dict[str, Counterpart] = {
    "accumulate_and_mark": over(kernels.dilate_marked_facet, counts.bonds, MARKS),
    **{
        f"judge_facets_by_{name}": in_order(
            over(one, counts.bonds, MARKS), over(kernels.postpone_neighbour, counts.elements), RANKED
        )
        for name, one in kernels.JUDGE_FACET_BY.items()
    },
    "withdraw_facets": over(kernels.withdraw_facets_of_cell, counts.elements),
    "break_facets": _break,
    "restore_facets": over(kernels.restore_facets_of_cell, counts.elements),
    "renew_wall_rows": over(kernels.renew_wall_row, counts.rows, BY_ROW_OF_WALLS),
}
