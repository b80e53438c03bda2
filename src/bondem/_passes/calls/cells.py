"""Passes that Python calls, of `core/passes/cells`; written by `python -m tests.core.passes`."""

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
from bondem._tables.damage_tables import FailureIndices, LoadedTractions, Strengths
from bondem._tables.step_tables import BeamSums, Poses


def add_moments(moments_of_forces: MomentsOfForces) -> Call:
    """Adds the moments sym b⊗f of forces about the centres of their owners, times a sign."""
    return Call("add_moments", (moments_of_forces,))


def index_facets_by_mohr_coulomb(
    poses: Poses, elastic_facets: ElasticFacets, strengths: Strengths, failure_indices: FailureIndices
) -> Call:
    """Finds the index of every facet by a criterion, at the stresses in the poses."""
    return Call("index_facets_by_mohr_coulomb", (poses, elastic_facets, strengths, failure_indices))


def index_tractions_by_mohr_coulomb(
    loaded_tractions: LoadedTractions, strengths: Strengths, failure_indices: FailureIndices
) -> Call:
    """Finds the index of every facet by a criterion, under tractions."""
    return Call("index_tractions_by_mohr_coulomb", (loaded_tractions, strengths, failure_indices))


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


def measure_cell_energies(
    cell_poses: CellPoses, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation, dilatation_gradients:
    DilatationGradients, wall_constraints: WallConstraints, cell_energies: CellEnergies
) -> Call:
    """Sums the energies of all facets, cells and walls [J]; that of dilatation is part of the normal energy."""
    return Call("measure_cell_energies", (
        cell_poses, elastic_facets, cell_dilatation, dilatation_gradients, wall_constraints, cell_energies
    ))


def place_walls(wall_constraints: WallConstraints, wall_time: WallTime) -> Call:
    """Brings walls to a time."""
    return Call("place_walls", (wall_constraints, wall_time))


def turn_vectors(turned_vectors: TurnedVectors) -> Call:
    """Turns vectors with their elements."""
    return Call("turn_vectors", (turned_vectors,))


def weigh_cells(elastic_facets: ElasticFacets, facet_release: FacetRelease) -> Call:
    """Computes the weights of all cells from their unbroken facets at the start of a run."""
    return Call("weigh_cells", (elastic_facets, facet_release))


#: Passes `index_facets_by_…` by the name of their criterion.
INDEX_FACETS_BY = {
    "mohr_coulomb": index_facets_by_mohr_coulomb,
}
#: Passes `index_tractions_by_…` by the name of their criterion.
INDEX_TRACTIONS_BY = {
    "mohr_coulomb": index_tractions_by_mohr_coulomb,
}
