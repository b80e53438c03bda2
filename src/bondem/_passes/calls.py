"""Passes that Python calls; written by `python -m tests.core.passes`: change the core instead."""

from bondem._passes import Call
from bondem._tables.cell_tables import (
    CellDilatation,
    CellEnergies,
    CellPoses,
    DilatationGradients,
    ElasticFacets,
    FacetRelease,
    MomentsOfForces,
    TurnedVectors,
    WallConstraints,
    WallTime,
)
from bondem._tables.contact_tables import FoundPairs, FoundWalls, PairSources, Walls, WallSources
from bondem._tables.crack_sample_tables import CrackSamples, SofteningSamples, StressBoundSamples, YieldSamples
from bondem._tables.crack_tables import FacetStrengths
from bondem._tables.damage_tables import FailureIndices, LoadedTractions, Strengths, StressCandidates, StressFunction
from bondem._tables.incremental_tables import LoadsOfEach, StoredLoads
from bondem._tables.non_local_tables import ExtraForces, NonLocalBonds, SmallPairs, SmallSprings, SmallSteps
from bondem._tables.packing_tables import (
    Flight,
    Growing,
    Near,
    NeighbourLists,
    PackingWalls,
    Relaxing,
    SphereGrid,
    Spheres,
)
from bondem._tables.quasistatic_tables import (
    ClumpCorrection,
    ConjugateGradients,
    FacetLoading,
    ScaledMatrix,
    SmallMotions,
    WeakenedFacets,
)
from bondem._tables.statics_tables import DynamicRelaxation, RelaxationSpan
from bondem._tables.step_tables import (
    AlikeBeams,
    BeamEnergies,
    Beams,
    BeamSums,
    BeamTurns,
    LaggedStresses,
    Portions,
    Poses,
    StepCut,
    StepPasses,
    StepScheme,
    StepSpan,
)
from bondem._tables.stiffness_tables import BeamRows, BlockRows, DilatationRows, FacetRows
from bondem._tables.stress_onset_tables import LoadedFacets, OnsetSearch, SofteningSearch, SofteningTeeth
from bondem._tables.surface_tables import Nearest, TriangleTree
from bondem._tables.tessellation_tables import (
    BalanceField,
    Bins,
    Bulk,
    CellBranches,
    CellRequest,
    CellRoom,
    Dividing,
    FaceGroups,
    PolygonBuffer,
    PolygonMeasures,
    Solids,
    Splitting,
    WallTree,
)


def add_moments(moments_of_forces: MomentsOfForces) -> Call:
    """Adds the moments sym b⊗f of forces about the centres of their owners, times a sign."""
    return Call("add_moments", (moments_of_forces,))


def apply_balance(cell_branches: CellBranches, balance_field: BalanceField) -> Call:
    """Computes the equation of each cell for given multipliers: its column sums of facet corrections."""
    return Call("apply_balance", (cell_branches, balance_field))


def assemble_beams(beam_rows: BeamRows, block_rows: BlockRows) -> Call:
    """Fills the block rows of beams at rest."""
    return Call("assemble_beams", (beam_rows, block_rows))


def assemble_facets(facet_rows: FacetRows, block_rows: BlockRows, dilatation_rows: DilatationRows) -> Call:
    """Fills the block rows of facets at rest, and those of the dilatation of cells."""
    return Call("assemble_facets", (facet_rows, block_rows, dilatation_rows))


def conjugate_gradients(
    scaled_matrix: ScaledMatrix, clump_correction: ClumpCorrection, conjugate_gradients: ConjugateGradients
) -> Call:
    """Solves Sᵀ K S x = f by conjugate gradients from a guess, preconditioned by the clumps; returns 0 if they
    converge, else 1.
    """
    return Call("conjugate_gradients", (scaled_matrix, clump_correction, conjugate_gradients))


def count_turned_beams(poses: Poses, beams: Beams, beam_turns: BeamTurns) -> Call:
    """Counts unbroken beams turned wide and lost among all beams in any poses."""
    return Call("count_turned_beams", (poses, beams, beam_turns))


def count_wall_contacts(poses: Poses, walls: Walls, wall_sources: WallSources) -> Call:
    """Counts walls within the skin of each element."""
    return Call("count_wall_contacts", (poses, walls, wall_sources))


def cut_teeth(softening_teeth: SofteningTeeth) -> Call:
    """Cuts a softening curve into steps."""
    return Call("cut_teeth", (softening_teeth,))


def divide_solids(
    solids: Solids, dividing: Dividing, part: PolygonBuffer, spare: PolygonBuffer, pile: PolygonBuffer
) -> Call:
    """Divides solids among elements, each point to the one with the least power x² - R²."""
    return Call("divide_solids", (solids, dividing, part, spare, pile))


def evaluate_cracks(crack_samples: CrackSamples) -> Call:
    """Evaluates the law of cracks in samples, by single numbers or by lanes."""
    return Call("evaluate_cracks", (crack_samples,))


def evaluate_softening(softening_samples: SofteningSamples) -> Call:
    """Evaluates the softening of beams in samples, by single numbers or by lanes."""
    return Call("evaluate_softening", (softening_samples,))


def evaluate_stress_bounds(stress_bound_samples: StressBoundSamples) -> Call:
    """Evaluates bounds of principal stresses in samples, by single numbers or by lanes."""
    return Call("evaluate_stress_bounds", (stress_bound_samples,))


def evaluate_yielding(yield_samples: YieldSamples) -> Call:
    """Evaluates the flow of yielding cells in samples, by single numbers or by lanes."""
    return Call("evaluate_yielding", (yield_samples,))


def find_agreed_stresses(loaded_facets: LoadedFacets, stress_candidates: StressCandidates) -> Call:
    """Finds σ* of facets, with the opening traction of bending added to their traction."""
    return Call("find_agreed_stresses", (loaded_facets, stress_candidates))


def find_nearest_triangles(triangle_tree: TriangleTree, nearest: Nearest) -> Call:
    """Finds the nearest triangle of each point."""
    return Call("find_nearest_triangles", (triangle_tree, nearest))


def find_onset_factors(
    loaded_facets: LoadedFacets, facet_strengths: FacetStrengths, onset_search: OnsetSearch
) -> Call:
    """Finds the load factors at which whole facets begin to crack and to soften."""
    return Call("find_onset_factors", (loaded_facets, facet_strengths, onset_search))


def find_small_extra_forces(small_pairs: SmallPairs, extra_forces: ExtraForces) -> Call:
    """Finds extra forces at small strain, where frames of elements are those of space."""
    return Call("find_small_extra_forces", (small_pairs, extra_forces))


def find_softening_factors(
    loaded_facets: LoadedFacets, facet_strengths: FacetStrengths, softening_search: SofteningSearch
) -> Call:
    """Finds the load factors at which facets lose integrity along each direction."""
    return Call("find_softening_factors", (loaded_facets, facet_strengths, softening_search))


def fly_and_grow(spheres: Spheres, packing_walls: PackingWalls, near: Near, growing: Growing, flight: Flight) -> Call:
    """Lets spheres fly and grow, as far as the neighbour lists are valid; all are advanced to the end."""
    return Call("fly_and_grow", (spheres, packing_walls, near, growing, flight))


def index_beams_by_ellipse(poses: Poses, beams: Beams, strengths: Strengths, failure_indices: FailureIndices) -> Call:
    """Finds the index of every beam by a criterion, in any poses, as many at once as there are lanes."""
    return Call("index_beams_by_ellipse", (poses, beams, strengths, failure_indices))


def index_beams_by_linear_sum(
    poses: Poses, beams: Beams, strengths: Strengths, failure_indices: FailureIndices
) -> Call:
    """Finds the index of every beam by a criterion, in any poses, as many at once as there are lanes."""
    return Call("index_beams_by_linear_sum", (poses, beams, strengths, failure_indices))


def index_beams_by_mohr_coulomb(
    poses: Poses, beams: Beams, strengths: Strengths, failure_indices: FailureIndices
) -> Call:
    """Finds the index of every beam by a criterion, in any poses, as many at once as there are lanes."""
    return Call("index_beams_by_mohr_coulomb", (poses, beams, strengths, failure_indices))


def index_beams_by_peripheral_stress(
    poses: Poses, beams: Beams, strengths: Strengths, failure_indices: FailureIndices
) -> Call:
    """Finds the index of every beam by a criterion, in any poses, as many at once as there are lanes."""
    return Call("index_beams_by_peripheral_stress", (poses, beams, strengths, failure_indices))


def index_facets_by_mohr_coulomb(
    poses: Poses, elastic_facets: ElasticFacets, strengths: Strengths, failure_indices: FailureIndices
) -> Call:
    """Finds the index of every facet by a criterion, at the stresses in the poses."""
    return Call("index_facets_by_mohr_coulomb", (poses, elastic_facets, strengths, failure_indices))


def index_pairs(
    beams: Beams, lagged_stresses: LaggedStresses, strengths: Strengths, failure_indices: FailureIndices
) -> Call:
    """Index of the criterion of every bond, by stresses in space."""
    return Call("index_pairs", (beams, lagged_stresses, strengths, failure_indices))


def index_stresses_by_cone(stress_candidates: StressCandidates, stress_function: StressFunction) -> Call:
    """Finds the index of each given stress; the counts of portions are not read."""
    return Call("index_stresses_by_cone", (stress_candidates, stress_function))


def index_stresses_by_function(stress_candidates: StressCandidates, stress_function: StressFunction) -> Call:
    """Finds the index of each given stress; the counts of portions are not read."""
    return Call("index_stresses_by_function", (stress_candidates, stress_function))


def index_stresses_by_mean_stress(stress_candidates: StressCandidates, stress_function: StressFunction) -> Call:
    """Finds the index of each given stress; the counts of portions are not read."""
    return Call("index_stresses_by_mean_stress", (stress_candidates, stress_function))


def index_tractions_by_mohr_coulomb(
    loaded_tractions: LoadedTractions, strengths: Strengths, failure_indices: FailureIndices
) -> Call:
    """Finds the index of every facet by a criterion, under tractions."""
    return Call("index_tractions_by_mohr_coulomb", (loaded_tractions, strengths, failure_indices))


def list_neighbours(sphere_grid: SphereGrid, neighbour_lists: NeighbourLists) -> Call:
    """Lists the neighbours of spheres that are sorted and counted, (start[n],)."""
    return Call("list_neighbours", (sphere_grid, neighbour_lists))


def list_pairs(sphere_grid: SphereGrid, pair_sources: PairSources, found_pairs: FoundPairs) -> Call:
    """Lists spheres of a sorted grid that are near and that no bond joins, and pairs of bonds that are wanted,
    with the memory of those that touch.
    """
    return Call("list_pairs", (sphere_grid, pair_sources, found_pairs))


def list_wall_contacts(poses: Poses, walls: Walls, wall_sources: WallSources, found_walls: FoundWalls) -> Call:
    """Lists elements near walls in their order, with the memory of those that touch."""
    return Call("list_wall_contacts", (poses, walls, wall_sources, found_walls))


def load_alike_beams(poses: Poses, beams: Beams, alike_beams: AlikeBeams, beam_sums: BeamSums) -> Call:
    """Adds forces and torques of all beams in any poses that differ in length only."""
    return Call("load_alike_beams", (poses, beams, alike_beams, beam_sums))


def load_beams(poses: Poses, beams: Beams, beam_sums: BeamSums) -> Call:
    """Adds forces and torques of all beams in any poses; rows of the sums are given."""
    return Call("load_beams", (poses, beams, beam_sums))


def load_body(
    cell_poses: CellPoses, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation, dilatation_gradients:
    DilatationGradients, wall_constraints: WallConstraints, beam_sums: BeamSums
) -> Call:
    """Sets the stresses of all cells in any poses, and adds force and torque of facets and walls to the sums."""
    return Call("load_body", (
        cell_poses, elastic_facets, cell_dilatation, dilatation_gradients, wall_constraints, beam_sums
    ))


def load_facets(poses: Poses, elastic_facets: ElasticFacets, beam_sums: BeamSums) -> Call:
    """Adds force and torque of all facets at the stresses in the poses; rows of the sums are given."""
    return Call("load_facets", (poses, elastic_facets, beam_sums))


def load_non_local_bonds(poses: Poses, beams: Beams, non_local_bonds: NonLocalBonds) -> Call:
    """Finds forces and torques of all bonds in any poses from their stored values."""
    return Call("load_non_local_bonds", (poses, beams, non_local_bonds))


def load_stored_beams(poses: Poses, beams: Beams, stored_loads: StoredLoads, loads_of_each: LoadsOfEach) -> Call:
    """Finds the loads of each beam on its elements in any poses."""
    return Call("load_stored_beams", (poses, beams, stored_loads, loads_of_each))


def load_weakened_facets(
    weakened_facets: WeakenedFacets, small_motions: SmallMotions, facet_loading: FacetLoading
) -> Call:
    """Finds the loads of facets at the stresses of their cells, and adds their moments to those of the cells."""
    return Call("load_weakened_facets", (weakened_facets, small_motions, facet_loading))


def make_cells(bins: Bins, cell_request: CellRequest, cell_room: CellRoom, polygon_buffer: PolygonBuffer) -> Call:
    """Cuts the cells of the chosen elements out of boxes about their centres: faces go to the pile, with the
    element behind each face as its tag.
    """
    return Call("make_cells", (bins, cell_request, cell_room, polygon_buffer))


def match_faces(
    solids: Solids, groups: FaceGroups, rest: PolygonBuffer, left: PolygonBuffer, pile: PolygonBuffer
) -> Call:
    """Lays the faces of each group over each other: patches go to the pile, with their face as kind and the face
    on the other side, or -1, as tag.
    """
    return Call("match_faces", (solids, groups, rest, left, pile))


def measure_beam_energies(poses: Poses, beams: Beams, beam_energies: BeamEnergies) -> Call:
    """Measures normal, shear, bending and twisting energy of all beams in any poses [J]."""
    return Call("measure_beam_energies", (poses, beams, beam_energies))


def measure_cell_energies(
    cell_poses: CellPoses, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation, dilatation_gradients:
    DilatationGradients, wall_constraints: WallConstraints, cell_energies: CellEnergies
) -> Call:
    """Sums the energies of all facets, cells and walls [J]; that of dilatation is part of the normal energy."""
    return Call("measure_cell_energies", (
        cell_poses, elastic_facets, cell_dilatation, dilatation_gradients, wall_constraints, cell_energies
    ))


def measure_polygons(polygon_measures: PolygonMeasures) -> Call:
    """Areas, centroids and second moments of polygons."""
    return Call("measure_polygons", (polygon_measures,))


def measure_solids(solids: Solids, bulk: Bulk) -> Call:
    """Volumes and moments of solids."""
    return Call("measure_solids", (solids, bulk))


def open_weakened_facets(weakened_facets: WeakenedFacets, small_motions: SmallMotions) -> Call:
    """Finds the gaps of facets, and adds V θ to their cells."""
    return Call("open_weakened_facets", (weakened_facets, small_motions))


def place_walls(wall_constraints: WallConstraints, wall_time: WallTime) -> Call:
    """Brings walls to a time."""
    return Call("place_walls", (wall_constraints, wall_time))


def relax_alike_beams(
    beams: Beams, alike_beams: AlikeBeams, beam_sums: BeamSums, dynamic_relaxation: DynamicRelaxation,
    relaxation_span: RelaxationSpan
) -> Call:
    """Takes steps until the forces of beams that differ in length only balance the loads."""
    return Call("relax_alike_beams", (beams, alike_beams, beam_sums, dynamic_relaxation, relaxation_span))


def relax_beams(
    beams: Beams, beam_sums: BeamSums, dynamic_relaxation: DynamicRelaxation, relaxation_span: RelaxationSpan
) -> Call:
    """Takes steps until the forces of beams balance the loads; rows of the sums are those of the elements, and
    zero.
    """
    return Call("relax_beams", (beams, beam_sums, dynamic_relaxation, relaxation_span))


def relax_spheres(spheres: Spheres, packing_walls: PackingWalls, near: Near, relaxing: Relaxing) -> Call:
    """Minimises the overlap energy, as far as the neighbour lists are valid."""
    return Call("relax_spheres", (spheres, packing_walls, near, relaxing))


def sort_and_count_neighbours(sphere_grid: SphereGrid) -> Call:
    """Sorts spheres into the cells of their grid, and counts the neighbours of each, whose surfaces are at most
    `skin` apart: fills `start`, too.
    """
    return Call("sort_and_count_neighbours", (sphere_grid,))


def sort_into_cells(sphere_grid: SphereGrid) -> Call:
    """Sorts spheres into the cells of their grid: fills `cell`, `first`, `member` and `place`."""
    return Call("sort_into_cells", (sphere_grid,))


def split_by_walls(
    solids: Solids, walls: WallTree, splitting: Splitting, stack: PolygonBuffer, piece: PolygonBuffer, pile:
    PolygonBuffer
) -> Call:
    """Splits cells by walls: the faces of their pieces go to the pile."""
    return Call("split_by_walls", (solids, walls, splitting, stack, piece, pile))


def take_small_steps(small_pairs: SmallPairs, small_springs: SmallSprings, small_steps: SmallSteps) -> Call:
    """Takes steps of small motions with extra forces that lag a step behind, until their energy is beyond 1e30 of
    the first.
    """
    return Call("take_small_steps", (small_pairs, small_springs, small_steps))


def take_steps(
    step_passes: StepPasses, step_cut: StepCut, step_scheme: StepScheme, step_span: StepSpan, portions: Portions
) -> Call:
    """Carries out the steps of a span."""
    return Call("take_steps", (step_passes, step_cut, step_scheme, step_span, portions))


def turn_all_stresses(poses: Poses, lagged_stresses: LaggedStresses) -> Call:
    """Turns the stresses of all elements in any poses."""
    return Call("turn_all_stresses", (poses, lagged_stresses))


def turn_vectors(turned_vectors: TurnedVectors) -> Call:
    """Turns vectors with their elements."""
    return Call("turn_vectors", (turned_vectors,))


def weigh_cells(elastic_facets: ElasticFacets, facet_release: FacetRelease) -> Call:
    """Computes the weights of all cells from their unbroken facets at the start of a run."""
    return Call("weigh_cells", (elastic_facets, facet_release))


#: Passes `index_beams_by_…` by the name of their criterion.
INDEX_BEAMS_BY = {
    "ellipse": index_beams_by_ellipse,
    "linear_sum": index_beams_by_linear_sum,
    "mohr_coulomb": index_beams_by_mohr_coulomb,
    "peripheral_stress": index_beams_by_peripheral_stress,
}
#: Passes `index_facets_by_…` by the name of their criterion.
INDEX_FACETS_BY = {
    "mohr_coulomb": index_facets_by_mohr_coulomb,
}
#: Passes `index_stresses_by_…` by the name of their criterion.
INDEX_STRESSES_BY = {
    "cone": index_stresses_by_cone,
    "function": index_stresses_by_function,
    "mean_stress": index_stresses_by_mean_stress,
}
#: Passes `index_tractions_by_…` by the name of their criterion.
INDEX_TRACTIONS_BY = {
    "mohr_coulomb": index_tractions_by_mohr_coulomb,
}
