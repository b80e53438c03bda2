"""Parts of a step for cracks that soften between cells, and for cells that yield (`core/passes/cracks/`)."""

from typing import Protocol

import numpy as np

from bondem._cache_lines import lines
from bondem._passes import steps
from bondem._tables.cell_tables import (
    CellDilatation,
    CellStrains,
    ElasticFacets,
    FacetsOfCells,
    FacetTractions,
    WallConstraints,
)
from bondem._tables.columns import BONDS_OF_PORTION
from bondem._tables.crack_tables import CellSlack, CrackOnset, StressesOfCells
from bondem._tables.step_tables import HistoryRows
from bondem._types import Floats
from bondem.damage.cohesive_tables import facet_forces, keep_cracks, new_cohesive_cracks, new_crack_lists, yielding_of
from bondem.damage.crack_columns import FACET
from bondem.damage.damage_part import CrackJoints, keep_events, new_event_log
from bondem.damage.failing_state import FailingState, StepTables
from bondem.damage.softening_table import SofteningTable
from bondem.damage.stress_onset import OnsetByStress
from bondem.interactions.beams.bond_table import with_zeros
from bondem.interactions.cells.cell_constants import CellConstants
from bondem.interactions.step_part import Part, Passes
from bondem.specimen.ordering import Layout

# Largest share of its integrity that a brittle facet loses in the time 1/ω of its own vibration, and in a step. This
# keeps the error of the energy balance small; a shorter step reduces it.
_LOSS = 0.1
# Slip over √A from which faces of a material plane no longer face each other. Without a contact law: when they lie
# side by side. With one: when a face is as near to the next face as to its own.
_SLIDE, _SLIDE_TO_NEXT = 1.0, 0.5


class ElasticBody(Protocol):
    """Interface of the tables of the facets, cells and walls of a run."""

    @property
    def facets(self) -> ElasticFacets: ...
    @property
    def cells(self) -> CellDilatation: ...
    @property
    def walls(self) -> WallConstraints: ...
    @property
    def tractions(self) -> tuple[FacetTractions, ...]: ...
    @property
    def strains(self) -> tuple[CellStrains, ...]: ...


class CrackingBody:
    """Tables of a body of cells whose facets soften and whose cells may yield.

    Args:
        table: strengths of facets and cells.
        body: tables of the elastic body.
        constants: constants of the cells, internal order.
        layout: internal order of cells and facets.
        state: state of the run; its arrays are shared.
        shared: tables that all parts of a step use.
        dt: time step [s].
        touches: True if cells touch after their facets have parted.
        pressed: contributions of loads on free facets to V σ at full load [J], (l, n, 6).
    """

    def __init__(
        self, table: SofteningTable, body: ElasticBody, constants: CellConstants, layout: Layout,
        state: FailingState, shared: StepTables, dt: float, *, touches: bool, pressed: Floats,
    ) -> None:  # fmt: skip
        n, m, adjacency = len(state.pose), len(state.integrity), layout.adjacency
        self.shared, self.state, self.body = shared, state, body
        self.stored = facet_forces(state, body.facets, table.area, len(shared.blocks.sums))
        swing = np.sqrt(constants.k * (state.motion[layout.i, 3] + state.motion[layout.j, 3]))
        self.strengths = table.strengths(_LOSS * np.minimum(dt * swing, 1.0), with_zeros)
        listed = np.zeros(len(body.facets.k), dtype=np.uint8)
        listed[m:] = 1  # padding to a group of vector lanes, not facets
        portions = -(-m // BONDS_OF_PORTION)
        self.by_stress = OnsetByStress.of(table, self.strengths, portions)
        self.cracks = new_cohesive_cracks(state, listed, _SLIDE_TO_NEXT if touches else _SLIDE)
        cracked, facet = np.zeros(n, dtype=np.uint8), state.cracks[:, FACET].astype(np.int64)
        cracked[layout.i[facet]] = cracked[layout.j[facet]] = 1
        self.onset = CrackOnset(
            cracked, np.zeros(n, dtype=np.uint8), np.zeros(len(listed), dtype=np.uint8), listed,
            np.zeros(portions + 1, dtype=np.int64),
        )  # fmt: skip
        self.stresses = StressesOfCells(constants.volume, lines(n), np.zeros((n, 12)), pressed)
        slack_i, slack_j = map(with_zeros, constants.slack())
        self.slack = CellSlack(
            adjacency.in_start, adjacency.out_start, adjacency.out_bond, slack_i, slack_j, constants.weight,
        )  # fmt: skip
        self.of_cells = FacetsOfCells(*adjacency)
        self.lists = new_crack_lists(n, m)
        self.yielding = yielding_of(state, table, body.facets, body.walls, constants)
        self.log = new_event_log(state)
        none = np.zeros(0, dtype=np.int64)
        self.tractions, *_ = *body.tractions, FacetTractions(np.zeros((0, n)), none, np.zeros(0), np.zeros(0))

    @property
    def joints(self) -> CrackJoints:
        """Cracked facets that still join their cells: cells cannot touch before the faces of their facet separate."""
        return CrackJoints(self.cracks, self.lists, self.body.facets, self.of_cells, self.strengths, self.log)

    def parts(self, elastic: Part) -> list[Part]:
        """Return the parts of the body: yielding and crack initiation, `elastic`, and cracks."""
        return [Part({"prepare": self._onset()}), elastic, self._cracks(self.straining()[2])]

    def straining(self) -> tuple[Passes, Passes, Passes]:
        """Return the passes by which strains that change in time act on cracks.

        The three lists change levers, and compute the power of each strain as a run begins and in each step.
        """
        body, stretch = self.body, []
        for strains in body.strains:
            whole = strains, body.facets, self.of_cells, body.walls
            stretch += [steps.stretch_anew(*whole, yielding) for yielding in self.yielding]
        powers = [(self.shared.moving, strains, body.facets, self.cracks) for strains in body.strains]
        begin: Passes = [steps.begin_crack_powers(*one) for one in powers]
        return stretch, begin, [steps.sum_crack_powers(*one) for one in powers]

    def _begin(self) -> Passes:
        """Return the passes that begin a run: they set levers, lists, weights and stresses from the state."""
        moving, body, cracks = self.shared.moving, self.body, self.cracks
        return [
            *(steps.stretch_all_cells(body.facets, self.of_cells, yielding) for yielding in self.yielding),
            steps.link_cracks(body.facets, self.stored, self.strengths, cracks, self.lists),
            steps.weigh_cracked_cells(body.facets, body.cells, self.slack, cracks),
            *(steps.stretch_walls_and_cracks(body.facets, body.walls, one, cracks) for one in self.yielding),
            steps.carry_cracks(self.stresses, cracks, self.lists),
            steps.sum_moments(moving, body.facets, self.of_cells, self.stored),
            steps.find_cell_stresses(moving, self.stored, self.stresses),
            steps.add_surface_stresses(moving, body.walls, self.tractions, self.stresses),
        ]  # fmt: skip

    def _onset(self) -> Passes:
        """Return the passes by which cells yield and facets begin to crack, from the forces of the previous step."""
        moving, body, onset, stresses = self.shared.moving, self.body, self.onset, self.stresses
        by, strengths = self.by_stress, self.strengths
        passes: Passes = [
            steps.find_cell_stresses(moving, self.stored, stresses),
            steps.add_surface_stresses(moving, body.walls, self.tractions, stresses),
            steps.judge_cells(self.strengths, stresses, onset) if by is None else by.judge(stresses, onset),
        ]
        for yielding in self.yielding:
            passes += [
                steps.yield_cells(moving, self.strengths, stresses, yielding, onset),
                steps.stretch_cells(body.facets, self.of_cells, yielding),
                steps.add_yielding_work(self.tractions, stresses, yielding, self.shared.rows),
                steps.stretch_walls_and_cracks(body.facets, body.walls, yielding, self.cracks),
            ]
        if by is None:
            passes.append(steps.mark_cracking_facets(moving, body.facets, self.stored, strengths, stresses, onset))
        else:
            passes += by.mark(moving, body.facets, self.stored, stresses, onset)
            strengths = by.strengths
        if len(self.strengths.planes):
            passes.append(steps.mark_cracking_planes(moving, body.facets, self.stored, self.strengths, onset))
        return [*passes, steps.begin_cracks(body.facets, self.stored, strengths, onset, self.cracks)]

    def _cracks(self, powers: Passes) -> Part:
        """Return the part of a step in which cracks open, close, soften and separate, and apply their forces."""
        moving, body, cracks, lists = self.shared.moving, self.body, self.cracks, self.lists
        strengths, stresses = self.strengths, self.stresses
        again = steps.relax_outdated_cells(moving, body.cells, cracks, lists)
        crack: Passes = [
            steps.list_cracks(body.facets, cracks, lists),
            steps.begin_bases(moving, body.cells, lists),
            steps.measure_cracks(moving, body.facets, self.slack, stresses, cracks, lists),
            steps.relax_cracked_cells(moving, body.cells, lists),
            steps.watch_resting_cracks(moving, body.facets, strengths, cracks, lists),
            steps.wake_cracks(moving, body.facets, body.cells, self.slack, cracks, lists),
            again,
            steps.soften_cracks(moving, body.facets, strengths, stresses, cracks, lists),
            steps.leave_cracks(moving, body.facets, body.cells, self.slack, cracks, lists),
            again,
            steps.load_cracks(moving, body.facets, strengths, stresses, cracks, lists),
            steps.sum_cracks(stresses, cracks, lists),
            steps.slide_cracks(moving, body.facets, cracks, lists),
            steps.log_cracks(moving, body.facets, cracks, lists, self.log),
            *powers,
        ]
        still: Passes = []
        if self.yielding:  # the dissipation of yielding cells follows from their stresses
            still = [
                steps.find_still_stresses(moving, self.stored, stresses),
                steps.add_still_surface_stresses(moving, body.walls, self.tractions, stresses),
            ]
        return Part(
            {
                "begin": self._begin(),
                "present": [steps.follow_levers(strains, body.facets, cracks) for strains in body.strains],
                "prepare": crack,
                "add": [steps.add_crack_loads(moving, lists, self.shared.blocks)],
                "settle": still,
            },
            record=self._record,
            keep=self.keep,
        )  # fmt: skip

    def _record(self, history: HistoryRows) -> Passes:
        moving, body, ledger = self.shared.moving, self.body, self.shared.ledger
        return [
            steps.sum_stressed_dilatation(moving, body.cells, ledger),
            *(steps.sum_heat(self.stresses, yielding, ledger) for yielding in self.yielding),
            steps.sum_crack_energies(moving, body.facets, self.cracks, ledger),
            steps.write_released(self.log, history),
            steps.write_crushing_of_facets(self.strengths, self.cracks, self.log, history),
        ]  # fmt: skip

    def keep(self) -> None:
        """Write cracks, forces and events of the last call into the state."""
        if self.by_stress is not None:
            self.by_stress.passes.check()
        keep_cracks(self.cracks, self.stored, self.state)
        keep_events(self.log, self.state)
