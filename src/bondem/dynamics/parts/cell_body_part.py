"""Parts of a step for bodies of cells: elastic, with facets that break at once, or with cracks."""

import numpy as np

from bondem._tables.step_tables import Dashpots
from bondem._types import Floats
from bondem.boundary.conditions import Load
from bondem.boundary.loads import Pressure, is_face
from bondem.damage.breakage_part import facet_breakage
from bondem.damage.crack_part import CrackingBody
from bondem.damage.damage_part import BondParts, DamageTables, Joints
from bondem.dynamics.parts.cell_part import BodyOfCells, cells
from bondem.dynamics.parts.mass_part import mass_of_waves
from bondem.dynamics.parts.shared_tables import SharedTables, apart
from bondem.interactions.cells.cell_body import body_of
from bondem.interactions.cells.cell_interaction import CellInteraction
from bondem.interactions.cells.cell_tables import facet_release
from bondem.interactions.row_sums import row_sums, symmetric_products
from bondem.model.model import Model
from bondem.model.state import State


def body_of_cells(
    law: CellInteraction, model: Model, state: State, shared: SharedTables, dashpots: Dashpots | None, dt: float
) -> BondParts:
    """Return the parts of a step of `dt` [s] for a body of cells and its cracks, and facets as joints of cells."""
    layout, table = model.layout, model.softening
    constants = law.constants.stretched(state.eigenstrain, layout)
    if table is not None:  # cracks change the integrity that facets have here
        body = BodyOfCells.of(model, constants, state, shared, dashpots)
        body = body._replace(facets=body.facets._replace(integrity=body.facets.integrity.copy()))
        cracking = CrackingBody(
            table, body, constants, layout, state, shared, dt,
            touches=model.contact is not None, pressed=_pressed_moments(model),
        )  # fmt: skip
        stretch, powers, _ = cracking.straining()
        elastic = cells(shared, model, state, body, cracking.stored, stretch=stretch, powers=powers)
        return BondParts(cracking.parts(elastic), Joints.of_cracks(apart(model, state), state, cracking.joints))
    left = constants.damaged(state.integrity, layout.i, layout.j)
    body = BodyOfCells.of(model, left, state, shared, dashpots)
    damage = DamageTables.of(model.breaking, state, shared.blocks, len(body.facets.i))
    forces = cells(shared, model, state, body, damage=damage)
    parts = [forces, *mass_of_waves(model, shared, body)]
    if damage is not None:
        release = facet_release(law.constants, layout, body.facets, body.cells, body.walls)
        parts.append(facet_breakage(damage, state, shared, body.facets, body.walls, release, body.dashed))
    return BondParts(parts, Joints(body.facets.integrity, apart(model, state), damage))


def _pressed_moments(model: Model) -> Floats:
    """Return the symmetric part of b⊗F per load and cell [J], (l, n, 6), of forces F at arms b; internal order."""
    _, cells = body_of(model.lattice)
    free, found = cells.free, []
    for condition in model.boundary:
        if isinstance(condition, Load | Pressure) and is_face(condition.region):
            numbers, force = condition.on_facets(model.lattice)
            cell = free.cell[numbers]
            arm = free.centroid[numbers] - cells.centroid[cell]
            moment = row_sums(cell, symmetric_products(arm, force), len(cells.volume))
            found.append(moment[model.layout.order])
    return np.array(found).reshape(len(found), len(cells.volume), 6)
