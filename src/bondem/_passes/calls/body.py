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
