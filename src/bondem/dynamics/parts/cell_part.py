"""Part of a step for elastic cells: dilatation, facets, walls that fix facets, tractions, changing strains."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from bondem._cache_lines import exact_sums
from bondem._passes import StepEntry, steps
from bondem._tables.cell_tables import (
    CellDilatation,
    CellStrains,
    DilatationGradients,
    ElasticFacets,
    FacetForces,
    FacetTractions,
    WallConstraints,
)
from bondem._tables.step_tables import Beams, Dashpots
from bondem.damage.damage_part import DamageTables
from bondem.dynamics.parts.shared_tables import SharedTables
from bondem.interactions.beams.beam_tables import beam_tables
from bondem.interactions.cells.cell_constants import CellConstants
from bondem.interactions.cells.cell_tables import cell_tables, gradient_tables
from bondem.interactions.row_sums import rows_of_ends
from bondem.interactions.step_part import Part, Passes
from bondem.model.model import Model
from bondem.model.state import State


class BodyOfCells(NamedTuple):
    """Tables of the facets, cells and walls of a run."""

    dashed: tuple[tuple[Dashpots, Beams], ...]  #: dashpots of facets, on beams about as stiff; one pair or none
    facets: ElasticFacets
    cells: CellDilatation
    gradients: DilatationGradients
    walls: WallConstraints
    tractions: tuple[FacetTractions, ...]  #: one where tractions act on free facets
    strains: tuple[CellStrains, ...]  #: one where stress-free strains change

    @classmethod
    def of(
        cls, model: Model, constants: CellConstants, state: State, shared: SharedTables, dashpots: Dashpots | None
    ) -> "BodyOfCells":
        """Return the tables of a run from a state, whose arrays they share, with dashpots of facets or None."""
        layout, period = model.layout, model.period
        to_i = rows_of_ends(shared.blocks, layout)
        facets, cells = cell_tables(constants, layout, period, state.integrity, to_i)
        dashed: tuple[tuple[Dashpots, Beams], ...] = ()
        if dashpots is not None:
            bonds = model.bonds.stretched(state.eigenstrain)
            beams, _ = beam_tables(bonds, layout, period, state.integrity, may_share=False)
            dashed = ((dashpots, beams._replace(integrity=facets.integrity)),)
        constraints = model.constraints
        walls = constants.supports.table(layout, constraints.row_of, state.grips)
        if len(constraints.strain_part) or len(state.plastic):  # cells that grow or yield change levers
            facets = facets._replace(lever_i=facets.lever_i.copy(), lever_j=facets.lever_j.copy())
        return cls(
            dashed, facets, cells, gradient_tables(constants.gradients, len(layout.order), walls), walls,
            _tractions(model),
            _strains(model, state),
        )  # fmt: skip


def cells(
    shared: SharedTables, model: Model, state: State, body: BodyOfCells, stored: FacetForces | None = None,
    damage: DamageTables | None = None, stretch: Sequence[StepEntry] = (), powers: Sequence[StepEntry] = (),
) -> Part:  # fmt: skip
    """Return the part of an elastic body of cells.

    Args:
        shared: tables of the run.
        model: model of the body.
        state: state from which the run begins.
        body: tables of the body.
        stored: forces of facets and moments of cells, for a body with cracks, or None. With cracks another part
            records the energy of dilatation, which depends on their stresses.
        damage: tables of facets that break at once, or None.
        stretch: passes to call after stress-free strains have changed levers.
        powers: passes that compute the derivative of the energy at cracks by the factors of these strains.
    """
    moving, blocks, rows, ledger = shared.moving, shared.blocks, shared.rows, shared.ledger
    walls, walled = body.walls, len(body.walls.cell) > 0
    before: Passes = [steps.add_wall_dilatation(moving, walls, body.cells)] if walled else []
    dilate: Passes = [steps.accumulate_dilatation(moving, body.facets, body.cells)]
    mark = dilate
    if damage is not None:
        mark = [steps.accumulate_and_mark(moving, body.facets, body.cells, damage.bounds, damage.candidates)]
    collect: Passes = [steps.collect_dilatation(blocks, body.cells)]
    loads: Passes = [steps.add_facet_loads(moving, body.facets, blocks)]
    gather: Passes = []
    if stored is not None:
        mark = [steps.accumulate_left_dilatation(moving, body.facets, body.cells)]
        loads = [steps.add_and_keep_facet_loads(moving, body.facets, stored, blocks)]
        gather = [steps.collect_facet_moments(blocks, stored), steps.take_moments(stored)]
    loads += [steps.add_dashpot_loads(moving, beams, dashpots, blocks) for dashpots, beams in body.dashed]
    present, beside, behind = _changing(shared, body, stretch, powers)
    constrain: Passes = [*beside, steps.apply_walls(moving, walls, rows)] if walled else [*beside]
    gradients, torques, sums = _of_gradients(shared, body)
    facets = steps.sum_facet_energies(moving, body.facets, ledger)
    energies: Passes = [
        *before, *dilate, *collect, *sums, steps.sum_dilatation_energies(body.cells, ledger), facets
    ]  # fmt: skip
    supports: Passes = [steps.sum_energies_of_supports(moving, walls, ledger)] if walled else []
    return Part(
        {
            "present": present,
            "prepare": [*beside, *before, *mark, *collect, steps.stress_cells(moving, body.cells)],
            "stress": gradients,
            "constrain": [*constrain, *behind], "loads": loads, "gather": gather,
            "add": [*([steps.add_wall_loads(rows, blocks)] if walled else []), *torques],
            "guard": [steps.check_facets(moving, body.facets, ledger)],
        },
        record=lambda _: [*(energies if stored is None else [facets]), *supports],
    )  # fmt: skip


def _of_gradients(shared: SharedTables, body: BodyOfCells) -> tuple[Passes, Passes, Passes]:
    """Return the passes of gradients of the dilatation: those of stresses, of torques, and of energies."""
    moving, gradients = shared.moving, body.gradients
    stresses: Passes = []
    torques: Passes = []
    if len(gradients.spring):
        stresses.append(steps.sum_stress_differences(moving, gradients))
        stresses.append(steps.add_stress_differences(moving, body.cells, gradients))
    if len(gradients.weight):
        stresses.append(steps.bend_layers(moving, body.walls, gradients))
        stresses.append(steps.twist_layers(moving, body.walls, gradients))
        torques.append(steps.add_layer_torques(gradients, shared.blocks))
    if not stresses:
        return [], [], []
    energies = steps.sum_gradient_energies(moving, body.cells, body.walls, gradients, shared.ledger)
    return stresses, torques, [energies]


def _changing(
    shared: SharedTables, body: BodyOfCells, stretch: Sequence[StepEntry], powers: Sequence[StepEntry]
) -> tuple[Passes, Passes, Passes]:
    """Return passes of changing tractions, strains and walls: at stage "present", before the walls act, and after."""
    moving, timeline, rows, walls = shared.moving, shared.timeline, shared.rows, body.walls
    present: Passes = []
    beside: Passes = []
    behind: Passes = []
    for tractions in body.tractions:
        present.append(steps.follow_tractions(timeline, tractions, body.cells))
        beside.append(steps.add_traction_work(moving, tractions, rows))
    for strains in body.strains:
        present += [steps.follow_cell_strains(timeline, strains, body.facets, walls), *stretch]
        behind.append(steps.sum_strain_powers(moving, strains, body.facets))
        behind.append(steps.add_strain_work(moving, strains, walls, rows))
    if len(walls.cell):
        present.append(steps.follow_walls(moving, walls, rows))
    for strains in body.strains:
        present += [*powers, steps.begin_strain_work(moving, strains, body.facets, walls)]
    return present, beside, behind


def _tractions(model: Model) -> tuple[FacetTractions, ...]:
    """Return the table of tractions on free facets, or an empty tuple without any."""
    constraints = model.constraints
    count = len(constraints.press_schedule)
    if count == 0:
        return ()
    return (FacetTractions(constraints.press_value, constraints.press_schedule, np.zeros(count), np.zeros(count)),)


def _strains(model: Model, state: State) -> tuple[CellStrains, ...]:
    """Return the table of strains that conditions add to those of the state, or an empty tuple without any."""
    constraints, cells, layout = model.constraints, model.cell_law.constants, model.layout
    if not len(constraints.strain_part):
        return ()
    count, own = len(constraints.strain_part), state.eigenstrain
    still = own if own.size else np.zeros(len(layout.i))
    wall = cells.supports.cell
    return (CellStrains(
        schedule=constraints.strain_schedule, base_i=np.ascontiguousarray(cells.lever_i.T),
        base_j=np.ascontiguousarray(cells.lever_j.T), still=1.0 + still, part=constraints.strain_part,
        wall_base=cells.supports.lever, wall_still=1.0 + layout.of_elements(still)[wall],
        wall_part=np.array([layout.of_elements(part)[wall] for part in constraints.strain_part]),
        place=constraints.works[1], factor=np.zeros((4, count)),
        power=exact_sums(count), due=np.zeros(2, dtype=np.uint8),
    ),)  # fmt: skip
