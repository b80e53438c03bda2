"""Cracks of bodies of cells that soften, and cells that yield (`core/passes/cracks/`)."""

import numpy as np

from bondem._cache_lines import lines
from bondem._core_steps import StepPass
from bondem._tables.cell_tables import (
    CellDilatation,
    CellStrains,
    ElasticFacets,
    FacetForces,
    FacetsOfCells,
    FacetTractions,
    WallConstraints,
)
from bondem._tables.crack_tables import (
    CellSlack,
    CohesiveCracks,
    CrackEnergies,
    CrackLists,
    CrackOnset,
    FacetStrengths,
    StressesOfCells,
    YieldingCells,
)
from bondem._tables.damage_tables import EventLog
from bondem._tables.step_tables import Dashpots, HistoryRows, Moving, Portions, Rows, StepCut
from bondem.damage.crack_columns import FACET
from bondem.dynamics.cohesive_tables import (
    facet_forces,
    facet_strengths,
    keep_cracks,
    new_cohesive_cracks,
    new_crack_lists,
    yielding_of,
)
from bondem.dynamics.crack_joints import LOSS, pressed_moments
from bondem.dynamics.damage_tables import new_event_log
from bondem.dynamics.parts.cell_part import BodyOfCells, cells, constants_of
from bondem.dynamics.parts.damage_part import CrackJoints
from bondem.dynamics.parts.shared_tables import SharedTables
from bondem.dynamics.stress_onset import OnsetByStress
from bondem.interactions.beams.bond_table import with_zeros
from bondem.interactions.step_part import Part, Passes
from bondem.model.model import Model
from bondem.model.state import State

_find_cell_stresses = StepPass("find_cell_stresses", Moving, FacetForces, StressesOfCells)
_add_surface_stresses = StepPass(
    "add_surface_stresses", Moving, WallConstraints, FacetTractions, StressesOfCells
)  # fmt: skip
_find_still_stresses = StepPass("find_still_stresses", Moving, FacetForces, StressesOfCells)
_add_still_surface_stresses = StepPass(
    "add_still_surface_stresses", Moving, WallConstraints, FacetTractions, StressesOfCells
)  # fmt: skip
_judge_cells = StepPass("judge_cells", FacetStrengths, StressesOfCells, CrackOnset)
_yield_cells = StepPass("yield_cells", Moving, FacetStrengths, StressesOfCells, YieldingCells, CrackOnset)
_stretch_cells = StepPass("stretch_cells", ElasticFacets, FacetsOfCells, YieldingCells)
_stretch_all_cells = StepPass("stretch_all_cells", ElasticFacets, FacetsOfCells, YieldingCells)
_stretch_walls_and_cracks = StepPass(
    "stretch_walls_and_cracks", ElasticFacets, WallConstraints, YieldingCells, CohesiveCracks
)
_stretch_anew = StepPass(
    "stretch_anew", CellStrains, ElasticFacets, FacetsOfCells, WallConstraints, YieldingCells
)  # fmt: skip
_sum_crack_powers = StepPass("sum_crack_powers", Moving, CellStrains, ElasticFacets, CohesiveCracks)
_begin_crack_powers = StepPass("begin_crack_powers", Moving, CellStrains, ElasticFacets, CohesiveCracks)
_add_yielding_work = StepPass("add_yielding_work", FacetTractions, StressesOfCells, YieldingCells, Rows)
_mark_cracking_facets = StepPass(
    "mark_cracking_facets", Moving, ElasticFacets, FacetForces, FacetStrengths, StressesOfCells, CrackOnset
)
_mark_cracking_planes = StepPass(
    "mark_cracking_planes", Moving, ElasticFacets, FacetForces, FacetStrengths, CrackOnset
)  # fmt: skip
_begin_cracks = StepPass("begin_cracks", ElasticFacets, FacetForces, FacetStrengths, CrackOnset, CohesiveCracks)
_link_cracks = StepPass("link_cracks", ElasticFacets, FacetForces, FacetStrengths, CohesiveCracks, CrackLists)
_weigh_cracked_cells = StepPass("weigh_cracked_cells", ElasticFacets, CellDilatation, CellSlack, CohesiveCracks)
_follow_levers = StepPass("follow_levers", CellStrains, ElasticFacets, CohesiveCracks)
_list_cracks = StepPass("list_cracks", ElasticFacets, CohesiveCracks, CrackLists)
_carry_cracks = StepPass("carry_cracks", StressesOfCells, CohesiveCracks, CrackLists)
_sum_moments = StepPass("sum_moments", Moving, ElasticFacets, FacetsOfCells, FacetForces)
_begin_bases = StepPass("begin_bases", Moving, CellDilatation, CrackLists)
_measure_cracks = StepPass(
    "measure_cracks", Moving, ElasticFacets, CellSlack, StressesOfCells, CohesiveCracks, CrackLists
)  # fmt: skip
_relax_cracked_cells = StepPass("relax_cracked_cells", Moving, CellDilatation, CrackLists)
_relax_stale_cells = StepPass("relax_stale_cells", Moving, CellDilatation, CrackLists)
_watch_resting_cracks = StepPass(
    "watch_resting_cracks", Moving, ElasticFacets, FacetStrengths, CohesiveCracks, CrackLists
)  # fmt: skip
_wake_cracks = StepPass("wake_cracks", Moving, ElasticFacets, CellDilatation, CellSlack, CohesiveCracks, CrackLists)
_soften_cracks = StepPass(
    "soften_cracks", Moving, ElasticFacets, FacetStrengths, StressesOfCells, CohesiveCracks, CrackLists
)
_leave_cracks = StepPass("leave_cracks", Moving, ElasticFacets, CellDilatation, CellSlack, CohesiveCracks, CrackLists)
_load_cracks = StepPass(
    "load_cracks", Moving, ElasticFacets, FacetStrengths, StressesOfCells, CohesiveCracks, CrackLists
)  # fmt: skip
_slide_cracks = StepPass("slide_cracks", Moving, ElasticFacets, StressesOfCells, CohesiveCracks, CrackLists)
_log_cracks = StepPass("log_cracks", Moving, ElasticFacets, CohesiveCracks, CrackLists, EventLog)
_add_crack_loads = StepPass("add_crack_loads", Moving, CrackLists, StepCut)
_sum_stressed_dilatation = StepPass("sum_stressed_dilatation", Moving, CellDilatation, CrackEnergies)
_sum_heat = StepPass("sum_heat", StressesOfCells, YieldingCells, CrackEnergies)
_sum_crack_energies = StepPass("sum_crack_energies", Moving, ElasticFacets, CohesiveCracks, CrackEnergies)
_add_crack_energies = StepPass("add_crack_energies", Moving, WallConstraints, CrackEnergies, Portions)
_write_released = StepPass("write_released", EventLog, HistoryRows)
_write_heat = StepPass("write_heat", CrackEnergies, HistoryRows)
_write_crushing = StepPass("write_crushing_of_facets", FacetStrengths, CohesiveCracks, EventLog, HistoryRows)

# Slip over √A from which faces of a material plane no longer face each other: where no contact follows, when they are
# beside each other; where it does, when a face is as near to the next one as to its own.
_SLIDE, _SLIDE_TO_NEXT = 1.0, 0.5


class CrackingBody:
    """Tables of a body of cells whose facets soften and whose cells may yield."""

    def __init__(self, model: Model, state: State, shared: SharedTables, dt: float) -> None:
        table = model.softening
        assert table is not None
        n, m = len(state.pose), len(state.integrity)
        constants, adjacency, layout = constants_of(model, state), model.layout.adjacency, model.layout
        self.shared, self.state = shared, state
        self.body = body = BodyOfCells.of(model, state, shared)
        self.kept = facet_forces(state, body.facets, table.area, len(shared.cut.sums))
        swing = np.sqrt(constants.k * (state.motion[layout.i, 3] + state.motion[layout.j, 3]))
        self.strengths = facet_strengths(table, LOSS * np.minimum(dt * swing, 1.0))
        listed = np.zeros(len(body.facets.k), dtype=np.uint8)
        listed[m:] = 1  # no facets: they fill a group of lanes
        self.by_stress = OnsetByStress.of(model, self.strengths, len(shared.portions.bonds))
        self.cracks = new_cohesive_cracks(state, listed, _SLIDE if model.contacts is None else _SLIDE_TO_NEXT)
        cracked, facet = np.zeros(n, dtype=np.uint8), state.cracks[:, FACET].astype(np.int64)
        cracked[layout.i[facet]] = cracked[layout.j[facet]] = 1
        self.onset = CrackOnset(
            cracked, np.zeros(n, dtype=np.uint8), np.zeros(len(listed), dtype=np.uint8), listed,
            np.zeros(len(shared.portions.bonds) + 1, dtype=np.int64),
        )  # fmt: skip
        self.stresses = StressesOfCells(constants.volume, lines(n), np.zeros((n, 12)), pressed_moments(model))
        self.slack = CellSlack(
            adjacency.in_start, adjacency.out_start, adjacency.out_bond, with_zeros(constants.slack_i),
            with_zeros(constants.slack_j), constants.weight,
        )  # fmt: skip
        self.of_cells = FacetsOfCells(*adjacency)
        self.lists = new_crack_lists(n, m)
        self.yielding = yielding_of(model, state, table, body.facets, body.walls, constants)
        portions = len(shared.portions.elements)
        self.energies = CrackEnergies(np.zeros(portions), np.zeros(portions), np.zeros(3))
        self.log = new_event_log(state)
        none = np.zeros(0, dtype=np.int64)
        self.tractions = body.tractions or FacetTractions(np.zeros((0, n)), none, 0, np.zeros(0), np.zeros(0))

    @property
    def joints(self) -> CrackJoints:
        """The cracked facets as joints of their cells."""
        return CrackJoints(
            self.cracks, self.lists, self.body.facets, self.of_cells, self.strengths, self.log
        )  # fmt: skip

    def parts(self, model: Model, dashpots: Dashpots | None) -> list[Part]:
        """Return the parts of the body: what its stresses lead to, the elastic body, and its cracks."""
        stretch, begin, behind = self._straining()
        elastic = cells(
            self.shared, model, self.state, self.body, dashpots, self.kept, stretch=stretch, powers=begin
        )  # fmt: skip
        return [Part({"prepare": self._onset()}), elastic, self._cracks(behind)]

    def _straining(self) -> tuple[Passes, Passes, Passes]:
        """Return passes of strains that change: of levers, and of powers at cracks as a run begins and in a step."""
        strains, body = self.body.strains, self.body
        if strains is None:
            return [], [], []
        powers = self.shared.moving, strains, body.facets, self.cracks
        stretch: Passes = []
        if self.yielding is not None:
            stretch.append((_stretch_anew, strains, body.facets, self.of_cells, body.walls, self.yielding))
        return stretch, [(_begin_crack_powers, *powers)], [(_sum_crack_powers, *powers)]

    def _begin(self) -> Passes:
        """A run begins: levers, lists, weights and stresses from what the state has."""
        moving, body, cracks = self.shared.moving, self.body, self.cracks
        passes: Passes = []
        if self.yielding is not None:
            passes.append((_stretch_all_cells, body.facets, self.of_cells, self.yielding))
        passes += [
            (_link_cracks, body.facets, self.kept, self.strengths, cracks, self.lists),
            (_weigh_cracked_cells, body.facets, body.cells, self.slack, cracks),
        ]
        if self.yielding is not None:
            passes.append((_stretch_walls_and_cracks, body.facets, body.walls, self.yielding, cracks))
        return [
            *passes, (_carry_cracks, self.stresses, cracks, self.lists),
            (_sum_moments, moving, body.facets, self.of_cells, self.kept),
            (_find_cell_stresses, moving, self.kept, self.stresses),
            (_add_surface_stresses, moving, body.walls, self.tractions, self.stresses),
        ]  # fmt: skip

    def _onset(self) -> Passes:
        """A step begins: cells yield, and facets begin to crack, by the forces of the step before."""
        moving, body, onset, stresses = self.shared.moving, self.body, self.onset, self.stresses
        by, strengths = self.by_stress, self.strengths
        passes: Passes = [
            (_find_cell_stresses, moving, self.kept, stresses),
            (_add_surface_stresses, moving, body.walls, self.tractions, stresses),
            (_judge_cells, self.strengths, stresses, onset) if by is None else by.judge(stresses, onset),
        ]
        if self.yielding is not None:
            passes += [
                (_yield_cells, moving, self.strengths, stresses, self.yielding, onset),
                (_stretch_cells, body.facets, self.of_cells, self.yielding),
                (_add_yielding_work, self.tractions, stresses, self.yielding, self.shared.rows),
                (_stretch_walls_and_cracks, body.facets, body.walls, self.yielding, self.cracks),
            ]
        if by is None:
            passes.append((_mark_cracking_facets, moving, body.facets, self.kept, strengths, stresses, onset))
        else:
            passes += by.mark(moving, body.facets, self.kept, stresses, onset)
            strengths = by.strengths
        if len(self.strengths.planes):
            passes.append((_mark_cracking_planes, moving, body.facets, self.kept, self.strengths, onset))
        return [*passes, (_begin_cracks, body.facets, self.kept, strengths, onset, self.cracks)]

    def _cracks(self, powers: Passes) -> Part:
        """Cracks open, close, soften, rest and part, and bear forces."""
        moving, body, cracks, lists = self.shared.moving, self.body, self.cracks, self.lists
        strengths, stresses = self.strengths, self.stresses
        again = (_relax_stale_cells, moving, body.cells, lists)
        crack: Passes = [
            (_list_cracks, body.facets, cracks, lists),
            (_begin_bases, moving, body.cells, lists),
            (_measure_cracks, moving, body.facets, self.slack, stresses, cracks, lists),
            (_relax_cracked_cells, moving, body.cells, lists),
            (_watch_resting_cracks, moving, body.facets, strengths, cracks, lists),
            (_wake_cracks, moving, body.facets, body.cells, self.slack, cracks, lists),
            again,
            (_soften_cracks, moving, body.facets, strengths, stresses, cracks, lists),
            (_leave_cracks, moving, body.facets, body.cells, self.slack, cracks, lists),
            again,
            (_load_cracks, moving, body.facets, strengths, stresses, cracks, lists),
            (_slide_cracks, moving, body.facets, stresses, cracks, lists),
            (_log_cracks, moving, body.facets, cracks, lists, self.log),
            *powers,
        ]
        still: Passes = []
        if self.yielding is not None:  # what cells dissipate is found by their stresses
            still = [
                (_find_still_stresses, moving, self.kept, stresses),
                (_add_still_surface_stresses, moving, body.walls, self.tractions, stresses),
            ]
        return Part(
            {
                "begin": self._begin(),
                "present": [] if body.strains is None else [(_follow_levers, body.strains, body.facets, cracks)],
                "prepare": crack,
                "add": [(_add_crack_loads, moving, lists, self.shared.cut)],
                "settle": still,
            },
            record=self._record,
            keep=self.keep,
        )  # fmt: skip

    def _record(self, history: HistoryRows) -> Passes:
        moving, body, energies = self.shared.moving, self.body, self.energies
        passes: Passes = [(_sum_stressed_dilatation, moving, body.cells, energies)]
        if self.yielding is not None:
            passes.append((_sum_heat, self.stresses, self.yielding, energies))
        return [
            *passes, (_sum_crack_energies, moving, body.facets, self.cracks, energies),
            (_add_crack_energies, moving, body.walls, energies, self.shared.portions),
            (_write_released, self.log, history), (_write_heat, energies, history),
            (_write_crushing, self.strengths, self.cracks, self.log, history),
        ]  # fmt: skip

    def keep(self) -> None:
        """Write cracks, forces and events of the last call into the state."""
        if self.by_stress is not None:
            self.by_stress.passes.check()
        keep_cracks(self.cracks, self.kept, self.state)
        count = int(self.log.written[0])
        if count:
            self.state.broken = np.concatenate([self.state.broken, self.log.event[:count]])
            self.log.written[:] = 0
