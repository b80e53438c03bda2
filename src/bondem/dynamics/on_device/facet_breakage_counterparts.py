"""Breakage of facets of cells on a device."""

from bondem._device import IndexPass, Launch
from bondem._tables.cell_tables import ElasticFacets, FacetRelease, WallConstraints
from bondem._tables.damage_tables import Candidates, EventLog, FailureBounds, Postponed, Strengths
from bondem._tables.device_tables import BondMarks, DeviceSpan, LoadsOfBonds, RowOrder
from bondem._tables.step_tables import Moving, Rows
from bondem.damage.failure_passes import FACET_CRITERIA
from bondem.dynamics.on_device.breakage_counterparts import counted, marking, marks_of, ranked
from bondem.dynamics.on_device.translation import Counterpart, Translation, elements, over

_dilate_marked_facet = IndexPass("dilate_marked_facet", Moving, ElasticFacets, LoadsOfBonds, FailureBounds, BondMarks)
_JUDGED = DeviceSpan, Moving, ElasticFacets, Strengths, BondMarks, Candidates, Postponed
_JUDGES = {name: IndexPass(f"judge_facet_by_{name}", *_JUDGED) for name in FACET_CRITERIA}
_postpone_neighbour = IndexPass("postpone_neighbour", ElasticFacets, FacetRelease, Candidates, Postponed)
_EXCHANGED = Moving, ElasticFacets, WallConstraints, FacetRelease, Candidates
_withdraw_of_cell = IndexPass("withdraw_facets_of_cell", *_EXCHANGED, Postponed)
_REMOVED = Moving, ElasticFacets, WallConstraints, FacetRelease, BondMarks, Candidates
_write_failure = IndexPass("write_facet_failure", DeviceSpan, *_REMOVED, EventLog)
_end_of_cell = IndexPass("end_facets_of_cell", *_REMOVED)
_restore_of_cell = IndexPass("restore_facets_of_cell", *_EXCHANGED, Postponed)
_renew_wall_row = IndexPass("renew_wall_row", WallConstraints, RowOrder, Rows, Candidates)


def _judging(one: IndexPass) -> Counterpart:
    """Return the counterpart of a pass that evaluates marked facets, and lists those that fail in their order."""

    def counterpart(
        run: Translation, moving: Moving, facets: ElasticFacets, release: FacetRelease, strengths: Strengths,
        candidates: Candidates, postponed: Postponed,
    ) -> list[Launch]:  # fmt: skip
        tables = run.span, moving, facets, strengths, marks_of(run), candidates, postponed
        return [
            (one, run.span.m, tables),
            (_postpone_neighbour, run.span.n, (facets, release, candidates, postponed)),
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
        (_write_failure, run.span.m, (run.span, *removed, log)),
        (_end_of_cell, run.span.n, removed),
        counted(run, candidates, log),
    ]


def _renew(run: Translation, walls: WallConstraints, rows: Rows, candidates: Candidates) -> list[Launch]:
    return [(_renew_wall_row, len(rows.force), (walls, run.order_of(walls.row), rows, candidates))]


COUNTERPARTS: dict[str, Counterpart] = {
    "accumulate_and_mark": marking(_dilate_marked_facet),
    **{f"judge_facets_by_{name}": _judging(one) for name, one in _JUDGES.items()},
    "withdraw_facets": over(_withdraw_of_cell, elements, spans=False),
    "break_facets": _break,
    "restore_facets": over(_restore_of_cell, elements, spans=False),
    "renew_wall_rows": _renew,
}
