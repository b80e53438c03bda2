"""Breakage of facets of cells by the damage pipeline of the core."""

from bondem._core_steps import StepPass
from bondem.kernels.tables import Rows
from bondem.model.beam_tables import Beams
from bondem.model.cell_tables import ElasticFacets, FacetRelease, WallConstraints
from bondem.model.failure_passes import CRITERION_NAMES, Strengths, strengths_of
from bondem.model.state import State
from bondem.solve.damage_tables import Candidates, EventLog, Postponed
from bondem.solve.parts.damage import DamageTables
from bondem.solve.parts.part import Part, Passes
from bondem.solve.parts.shared_tables import SharedTables
from bondem.solve.step_tables import Dashpots, Moving

_judge_facets = [
    StepPass(f"judge_facets_by_{name}", Moving, ElasticFacets, FacetRelease, Strengths, Candidates, Postponed)
    for name in CRITERION_NAMES
]
_EXCHANGED = Moving, ElasticFacets, WallConstraints, FacetRelease, Candidates
_withdraw_facets = StepPass("withdraw_facets", *_EXCHANGED, Postponed)
_break_facets = StepPass("break_facets", *_EXCHANGED, EventLog)
_restore_facets = StepPass("restore_facets", *_EXCHANGED, Postponed)
_renew_wall_rows = StepPass("renew_wall_rows", WallConstraints, Rows, Candidates)
_withdraw_dashpots = StepPass("withdraw_dashpots", Moving, Beams, Dashpots, Candidates, Postponed)


def judging(damage: DamageTables, shared: SharedTables, facets: ElasticFacets, release: FacetRelease) -> Passes:
    """Return the passes that find which facets fail, between dilatation and forces."""
    strengths, judge = strengths_of(damage.table), _judge_facets[damage.table.kind]
    return [(judge, shared.moving, facets, release, strengths, damage.candidates, damage.postponed)]


def facet_breakage(
    damage: DamageTables,
    state: State,
    shared: SharedTables,
    beams: Beams,
    facets: ElasticFacets,
    walls: WallConstraints,
    release: FacetRelease,
    dashpots: Dashpots | None,
) -> Part:
    """Return the part of facets that break."""
    exchanged = shared.moving, facets, walls, release, damage.candidates
    remove: Passes = []
    if dashpots is not None:
        remove.append((_withdraw_dashpots, shared.moving, beams, dashpots, damage.candidates, damage.postponed))
    remove += [
        (_withdraw_facets, *exchanged, damage.postponed),
        (_break_facets, *exchanged, damage.log),
        (_restore_facets, *exchanged, damage.postponed),
    ]
    if len(walls.cell):
        remove.append((_renew_wall_rows, walls, shared.rows, damage.candidates))
    part = damage.part(shared, [], remove, dashpots)
    return Part(part.stages, part.record, lambda: damage.keep(facets.integrity, state))
