"""Passes that Python calls, of `core/passes/cells/body.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.cell_tables import (
    CellDilatation,
    CellEnergies,
    CellPoses,
    DilatationGradients,
    ElasticFacets,
    WallConstraints,
    WallTime,
)
from bondem._tables.step_tables import BeamSums, Poses
from bondem._tables.stiffness_tables import BondTangents, StiffnessProduct


def differentiate_facets(poses: Poses, elastic_facets: ElasticFacets, bond_tangents: BondTangents) -> Call:
    """Sets the second derivative of the energy of each facet by the motions of its cells, at the stresses in the
    poses.
    """
    return Call("differentiate_facets", (poses, elastic_facets, bond_tangents))


def load_body(
    cell_poses: CellPoses, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation, dilatation_gradients:
    DilatationGradients, wall_constraints: WallConstraints, beam_sums: BeamSums
) -> Call:
    """Sets the stresses of all cells in given poses, and adds force and torque of facets and walls to the sums."""
    return Call("load_body", (
        cell_poses, elastic_facets, cell_dilatation, dilatation_gradients, wall_constraints, beam_sums
    ))


def measure_cell_energies(
    cell_poses: CellPoses, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation, dilatation_gradients:
    DilatationGradients, wall_constraints: WallConstraints, cell_energies: CellEnergies
) -> Call:
    """Sums the energies of all facets, cells and walls [J]; that of dilatation is part of the normal energy."""
    return Call("measure_cell_energies", (
        cell_poses, elastic_facets, cell_dilatation, dilatation_gradients, wall_constraints, cell_energies
    ))


def multiply_body(
    cell_poses: CellPoses, stiffness_product: StiffnessProduct, elastic_facets: ElasticFacets, cell_dilatation:
    CellDilatation, dilatation_gradients: DilatationGradients, wall_constraints: WallConstraints
) -> Call:
    """Multiplies small motions by the stiffness of a body."""
    return Call("multiply_body", (
        cell_poses, stiffness_product, elastic_facets, cell_dilatation, dilatation_gradients, wall_constraints
    ))


def place_walls(wall_constraints: WallConstraints, wall_time: WallTime) -> Call:
    """Moves all walls to their places at a time."""
    return Call("place_walls", (wall_constraints, wall_time))
