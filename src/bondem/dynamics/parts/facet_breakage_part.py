"""Breakage of facets of cells by the damage pipeline of the core."""

from bondem._passes import steps
from bondem._tables.step_tables import Dashpots
from bondem.damage.failure_passes import strengths_of
from bondem.dynamics.parts.cell_part import BodyOfCells, cells
from bondem.dynamics.parts.damage_part import BondParts, DamageTables, Joints, damage_of
from bondem.dynamics.parts.mass_part import mass_of_waves
from bondem.dynamics.parts.shared_tables import SharedTables
from bondem.interactions.cells.cell_tables import facet_release
from bondem.interactions.step_part import Part, Passes
from bondem.model.model import Model
from bondem.model.state import State


def body_of_cells(model: Model, state: State, shared: SharedTables, dashpots: Dashpots | None) -> BondParts:
    """Return the parts of a body of cells whose facets are elastic or break at once."""
    body = BodyOfCells.of(model, state, shared)
    damage = damage_of(model, state, shared.cut, len(body.facets.i))
    forces = cells(shared, model, state, body, dashpots, damage=damage)
    parts = [forces, *mass_of_waves(model, shared, body)]
    if damage is not None:
        parts.append(_breakage(model, damage, state, shared, body, dashpots))
    return BondParts(parts, Joints.of(model, state, body.facets.integrity, damage))


def _breakage(
    model: Model,
    damage: DamageTables,
    state: State,
    shared: SharedTables,
    body: BodyOfCells,
    dashpots: Dashpots | None,
) -> Part:
    """Return the part of facets that break."""
    assert model.cells is not None
    moving, candidates, postponed = shared.moving, damage.candidates, damage.postponed
    release = facet_release(model.cells, model.layout, body.facets, body.cells, body.walls)
    strengths = strengths_of(damage.table)
    judge = steps.JUDGE_FACETS_BY[damage.table.kind](
        moving, body.facets, release, strengths, candidates, postponed
    )
    exchanged = moving, body.facets, body.walls, release, candidates
    remove: Passes = []
    if dashpots is not None:
        remove.append(steps.withdraw_dashpots(moving, body.beams, dashpots, candidates, postponed))
    remove += [
        steps.withdraw_facets(*exchanged, postponed),
        steps.break_facets(*exchanged, damage.log),
        steps.restore_facets(*exchanged, postponed),
    ]
    if len(body.walls.cell):
        remove.append(steps.renew_wall_rows(body.walls, shared.rows, candidates))
    part = damage.part(shared, [], remove, dashpots)
    stages = {**part.stages, "constrain": [judge]}  # before any cell moves, as stresses change those of neighbours
    return Part(stages, part.record, lambda: damage.keep(body.facets.integrity, state))
