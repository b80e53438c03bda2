"""Parts of a step by which beams, and facets of cells, break at once."""

import numpy as np

from bondem._passes import steps
from bondem._tables.cell_tables import ElasticFacets, FacetRelease, WallConstraints
from bondem._tables.damage_tables import BeamIntegrity
from bondem._tables.step_tables import Beams, Dashpots, UniformBeams
from bondem.damage.damage_part import DamageTables
from bondem.damage.failing_state import FailingState, StepTables
from bondem.interactions.step_part import Part, Passes


def breakage(
    damage: DamageTables, state: FailingState, shared: StepTables, beams: Beams, uniform: UniformBeams | None,
    dashpots: Dashpots | None,
) -> Part:  # fmt: skip
    """Return the part of a step by which beams break at once, with their dashpots if given."""
    moving, candidates, postponed = shared.moving, damage.candidates, damage.postponed
    per_length = np.zeros(0) if uniform is None else uniform.per_length
    integrity = BeamIntegrity(beams.integrity, per_length)
    judge = [steps.JUDGE_BEAMS_BY[damage.table.kind](moving, beams, damage.strengths, candidates, postponed)]
    remove: Passes = []
    if dashpots is not None:
        remove.append(steps.withdraw_dashpots(moving, beams, dashpots, candidates, postponed))
    remove.append(steps.break_beams(moving, beams, integrity, candidates, postponed, damage.log))
    part = damage.part(shared, judge, remove, dashpots)
    return Part(part.stages, part.record, lambda: damage.keep(beams.integrity, state))


def facet_breakage(
    damage: DamageTables, state: FailingState, shared: StepTables, facets: ElasticFacets, walls: WallConstraints,
    release: FacetRelease, dashed: tuple[tuple[Dashpots, Beams], ...],
) -> Part:  # fmt: skip
    """Return the part of a step by which facets break at once; `dashed` are dashpots with the beams they act on."""
    moving, candidates, postponed = shared.moving, damage.candidates, damage.postponed
    by_kind = steps.JUDGE_FACETS_BY[damage.table.kind]
    judge = by_kind(moving, facets, release, damage.strengths, candidates, postponed)
    exchanged = moving, facets, walls, release, candidates
    remove: Passes = [
        *(steps.withdraw_dashpots(moving, beams, dashpots, candidates, postponed) for dashpots, beams in dashed),
        steps.withdraw_facets(*exchanged, postponed),
        steps.break_facets(*exchanged, damage.log),
        steps.restore_facets(*exchanged, postponed),
    ]
    if len(walls.cell):
        remove.append(steps.renew_wall_rows(walls, shared.rows, candidates))
    part = damage.part(shared, [], remove, dashed[0][0] if dashed else None)
    stages = {**part.stages, "constrain": [judge]}  # before any cell moves, as failure changes stresses of neighbours
    return Part(stages, part.record, lambda: damage.keep(facets.integrity, state))
