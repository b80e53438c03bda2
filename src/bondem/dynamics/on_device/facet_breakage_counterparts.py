"""Breakage of facets of cells on a device."""

from bondem._device import Launch
from bondem._passes import kernels
from bondem._tables.cell_tables import ElasticFacets, FacetRelease, WallConstraints
from bondem._tables.damage_tables import Candidates, EventLog, Postponed, Strengths
from bondem._tables.step_tables import Moving, Rows
from bondem.dynamics.on_device.breakage_counterparts import counted, marking, marks_of, ranked
from bondem.dynamics.on_device.translation import Counterpart, KernelOf, Translation, elements, over


def _judging(one: KernelOf) -> Counterpart:
    """Return the counterpart of a pass that evaluates marked facets, and lists those that fail in their order."""

    def counterpart(
        run: Translation, moving: Moving, facets: ElasticFacets, release: FacetRelease, strengths: Strengths,
        candidates: Candidates, postponed: Postponed,
    ) -> list[Launch]:  # fmt: skip
        tables = run.span, moving, facets, strengths, marks_of(run), candidates, postponed
        return [
            (one(*tables), run.span.m),
            (kernels.postpone_neighbour(facets, release, candidates, postponed), run.span.n),
            ranked(run, candidates),
        ]

    return counterpart


def _break(
    run: Translation,
    moving: Moving,
    facets: ElasticFacets,
    walls: WallConstraints,
    release: FacetRelease,
    candidates: Candidates,
    log: EventLog,
) -> list[Launch]:
    removed = moving, facets, walls, release, marks_of(run), candidates
    return [
        (kernels.write_facet_failure(run.span, *removed, log), run.span.m),
        (kernels.end_facets_of_cell(*removed), run.span.n),
        counted(run, candidates, log),
    ]


def _renew(run: Translation, walls: WallConstraints, rows: Rows, candidates: Candidates) -> list[Launch]:
    return [(kernels.renew_wall_row(walls, run.order_of(walls.row), rows, candidates), len(rows.force))]


COUNTERPARTS: dict[str, Counterpart] = {
    "accumulate_and_mark": marking(kernels.dilate_marked_facet),
    **{f"judge_facets_by_{name}": _judging(one) for name, one in kernels.JUDGE_FACET_BY.items()},
    "withdraw_facets": over(kernels.withdraw_facets_of_cell, elements, spans=False),
    "break_facets": _break,
    "restore_facets": over(kernels.restore_facets_of_cell, elements, spans=False),
    "renew_wall_rows": _renew,
}
