"""Part of a step for the dispersion-corrected mass of cells: its inertia forces and kinetic energy."""

import numpy as np

from bondem._indices import group_starts
from bondem._passes import steps
from bondem._tables.cell_tables import CorrectedMass
from bondem.dynamics.parts.cell_part import BodyOfCells
from bondem.dynamics.parts.shared_tables import SharedTables
from bondem.interactions.step_part import Part
from bondem.model.model import Model


def mass_of_waves(model: Model, shared: SharedTables, body: BodyOfCells) -> list[Part]:
    """Return the part of the dispersion-corrected mass in a list, which is empty for lumped masses."""
    if model.correction is None:
        return []
    layout, n = model.layout, len(model.layout.order)
    cell = body.walls.cell
    mass = CorrectedMass(
        *layout.adjacency, model.correction[layout.order], group_starts(cell, n),
        np.argsort(cell, kind="stable").astype(np.int64), np.zeros((n, 6)), np.zeros(n), np.zeros((n, 6)),
    )  # fmt: skip
    of_cells = shared.moving, body.facets, body.walls, mass
    return [
        Part(
            {
                "correct": [
                    steps.find_accelerations(shared.moving, shared.rows, shared.blocks, mass),
                    steps.find_dilatation_inertia(*of_cells), steps.find_inertia_forces(*of_cells),
                    steps.add_inertia_forces(mass, shared.blocks),
                ],
            },
            kinetic=[steps.subtract_dilatation_energies(*of_cells, shared.ledger)],
        )
    ]  # fmt: skip
