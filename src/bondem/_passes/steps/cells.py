"""Passes that steps are composed of, of `core/passes/cells`; written by `python -m tests.core.passes`."""

from bondem._passes import StepEntry
from bondem._tables.cell_tables import (
    CellDilatation,
    CellStrains,
    CorrectedMass,
    DilatationEnergy,
    DilatationGradients,
    ElasticFacets,
    FacetForces,
    FacetRelease,
    FacetsOfCells,
    FacetTractions,
    WallConstraints,
)
from bondem._tables.damage_tables import Candidates, EventLog, FailureBounds, Postponed, Strengths
from bondem._tables.step_tables import Beams, Moving, Portions, Rows, StepCut, Timeline


def accumulate_and_mark(
    moving: Moving, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation, failure_bounds: FailureBounds,
    candidates: Candidates
) -> StepEntry:
    """Adds contributions of facets to V θ of their cells, and marks facets near to failure.

    Over bonds of a block. Reads `pose`, `pose.stress` at both ends; adds `swelling` to elements.
    """
    return StepEntry("accumulate_and_mark", (moving, elastic_facets, cell_dilatation, failure_bounds, candidates))


def accumulate_dilatation(
    moving: Moving, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation
) -> StepEntry:
    """Adds contributions of the facets of a block to V θ of their cells.

    Over bonds of a block. Reads `pose` at both ends; adds `swelling` to elements.
    """
    return StepEntry("accumulate_dilatation", (moving, elastic_facets, cell_dilatation))


def accumulate_left_dilatation(
    moving: Moving, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation
) -> StepEntry:
    """Adds contributions of facets to V θ of their cells in bodies with many broken facets.

    Over bonds of a block. Reads `pose` at both ends; adds `swelling` to elements.
    """
    return StepEntry("accumulate_left_dilatation", (moving, elastic_facets, cell_dilatation))


def add_and_keep_facet_loads(
    moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces, step_cut: StepCut
) -> StepEntry:
    """Adds and stores the forces of the facets of a block, and adds up the moments V σ of their cells.

    Over bonds of a block. Reads `pose`, `pose.stress` at both ends; adds `FacetForces.sums`, `StepCut.sums` to
    elements.
    """
    return StepEntry("add_and_keep_facet_loads", (moving, elastic_facets, facet_forces, step_cut))


def add_cell_energies(
    moving: Moving, wall_constraints: WallConstraints, dilatation_energy: DilatationEnergy, portions: Portions
) -> StepEntry:
    """Adds the energy of dilatation, and that of half facets at walls, to the normal energy of the first portion
    of facets.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("add_cell_energies", (moving, wall_constraints, dilatation_energy, portions))


def add_facet_loads(moving: Moving, elastic_facets: ElasticFacets, step_cut: StepCut) -> StepEntry:
    """Adds forces and torques of the facets of a block to the sums of their cells, whose stresses are known.

    Over bonds of a block. Reads `pose`, `pose.stress` at both ends; adds `sums` to elements.
    """
    return StepEntry("add_facet_loads", (moving, elastic_facets, step_cut))


def add_gradient_energies(dilatation_gradients: DilatationGradients, portions: Portions) -> StepEntry:
    """Adds the energies of gradients to those of the facets.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("add_gradient_energies", (dilatation_gradients, portions))


def add_inertia_forces(corrected_mass: CorrectedMass, step_cut: StepCut) -> StepEntry:
    """Adds the forces of the correction to the sums of the elements.

    Over elements of a block, then shared ones. Reads `force` of an element; changes `sums` of an element.
    """
    return StepEntry("add_inertia_forces", (corrected_mass, step_cut))


def add_layer_torques(dilatation_gradients: DilatationGradients, step_cut: StepCut) -> StepEntry:
    """Adds the torques of bent layers to the sums of the cells.

    Over elements of a block, then shared ones. Reads `torque` of an element; changes `sums` of an element.
    """
    return StepEntry("add_layer_torques", (dilatation_gradients, step_cut))


def add_strain_work(
    moving: Moving, cell_strains: CellStrains, wall_constraints: WallConstraints, rows: Rows
) -> StepEntry:
    """Adds the work of strains that have changed, when the forces after that are known.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("add_strain_work", (moving, cell_strains, wall_constraints, rows))


def add_stress_differences(
    moving: Moving, cell_dilatation: CellDilatation, dilatation_gradients: DilatationGradients
) -> StepEntry:
    """Adds the forces of the springs between cells to their stresses.

    Over elements, in portions. Reads `CellDilatation.weight`, `difference` of an element; changes `pose.stress`
    of an element.
    """
    return StepEntry("add_stress_differences", (moving, cell_dilatation, dilatation_gradients))


def add_traction_work(moving: Moving, facet_tractions: FacetTractions, rows: Rows) -> StepEntry:
    """Adds half the work of tractions that change: once by the stresses before, and once by those after.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("add_traction_work", (moving, facet_tractions, rows))


def add_wall_dilatation(
    moving: Moving, wall_constraints: WallConstraints, cell_dilatation: CellDilatation
) -> StepEntry:
    """Adds contributions of walls to V θ of their cells.

    Over rows of a table, in the order of the table. Reads `arm`, `pose`, `wall` of an element; changes
    `swelling` of an element.
    """
    return StepEntry("add_wall_dilatation", (moving, wall_constraints, cell_dilatation))


def add_wall_loads(rows: Rows, step_cut: StepCut) -> StepEntry:
    """Adds the forces of walls to the sums of their cells.

    Over elements of a block, then shared ones. Reads `grip` of an element; changes `sums` of an element.
    """
    return StepEntry("add_wall_loads", (rows, step_cut))


def apply_walls(moving: Moving, wall_constraints: WallConstraints, rows: Rows) -> StepEntry:
    """Sets the forces of walls on the rows of their cells, whose stresses are known, and adds the work of walls
    that move: the trapezoid of the force over the displacement.

    Over rows of a table, in the order of the table. Reads `arm`, `pose`, `pose.stress` of an element; changes
    `base`, `load`, `loss`, `wall` of an element; writes `grip` of an element.
    """
    return StepEntry("apply_walls", (moving, wall_constraints, rows))


def begin_strain_work(
    moving: Moving, cell_strains: CellStrains, elastic_facets: ElasticFacets, wall_constraints: WallConstraints
) -> StepEntry:
    """Finds ∂U/∂factor by the stresses in the poses, where the time of the clock was not reached by a step.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("begin_strain_work", (moving, cell_strains, elastic_facets, wall_constraints))


def bend_layers(
    moving: Moving, wall_constraints: WallConstraints, dilatation_gradients: DilatationGradients
) -> StepEntry:
    """Computes how layers one cell thick are bent at each cell.

    Over elements, in portions. Reads `base` of an element; reads `pose` at both ends; adds `bend` to elements.
    """
    return StepEntry("bend_layers", (moving, wall_constraints, dilatation_gradients))


def break_facets(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, facet_release: FacetRelease,
    candidates: Candidates, event_log: EventLog
) -> StepEntry:
    """Removes the facets that fail, and brings the stresses of their cells up to date.

    Over what begins, changes or ends in the step, in order. Reads `arm`, `given`, `wall`, `weight` at both
    ends; reads `pose` at both ends and at their neighbours; adds `pose.stress`, `weight` to elements.
    """
    return StepEntry("break_facets", (moving, elastic_facets, wall_constraints, facet_release, candidates, event_log))


def check_facets(moving: Moving, beams: Beams, elastic_facets: ElasticFacets, portions: Portions) -> StepEntry:
    """Counts unbroken facets of a portion that are turned beyond the range of their energy, and beyond its end.

    Over bonds, in portions. Reads `pose` at both ends.
    """
    return StepEntry("check_facets", (moving, beams, elastic_facets, portions))


def collect_dilatation(step_cut: StepCut, cell_dilatation: CellDilatation) -> StepEntry:
    """Adds contributions of facets of other domains to V θ of shared cells, and sets their rows to zero.

    Over elements that domains share. Changes `swelling` of an element.
    """
    return StepEntry("collect_dilatation", (step_cut, cell_dilatation))


def collect_facet_moments(step_cut: StepCut, facet_forces: FacetForces) -> StepEntry:
    """Adds moments of facets of other domains to the sums of shared cells, and sets their rows to zero.

    Over elements that domains share. Changes `FacetForces.sums` of an element.
    """
    return StepEntry("collect_facet_moments", (step_cut, facet_forces))


def find_accelerations(moving: Moving, rows: Rows, step_cut: StepCut, corrected_mass: CorrectedMass) -> StepEntry:
    """Computes the accelerations of the elements by their loads alone.

    Over elements of a block, then shared ones. Reads `Rows.force`, `motion`, `sums` of an element; writes
    `CorrectedMass.acceleration` of an element.
    """
    return StepEntry("find_accelerations", (moving, rows, step_cut, corrected_mass))


def find_dilatation_inertia(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, corrected_mass:
    CorrectedMass
) -> StepEntry:
    """Computes ρ β θ̈ of the cells by the accelerations of the elements.

    Over elements, in portions. Reads `arm` of an element; reads `CorrectedMass.acceleration`, `pose` at both
    ends; adds `inertia` to elements.
    """
    return StepEntry("find_dilatation_inertia", (moving, elastic_facets, wall_constraints, corrected_mass))


def find_inertia_forces(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, corrected_mass:
    CorrectedMass
) -> StepEntry:
    """Computes the forces of the correction on the elements.

    Over elements, in portions. Reads `arm` of an element; reads `inertia`, `pose` at both ends; adds `force` to
    elements.
    """
    return StepEntry("find_inertia_forces", (moving, elastic_facets, wall_constraints, corrected_mass))


def follow_cell_strains(
    timeline: Timeline, cell_strains: CellStrains, elastic_facets: ElasticFacets, wall_constraints:
    WallConstraints
) -> StepEntry:
    """Sets stress-free strains, and with them the levers of facets and walls, to the time of the clock.

    Over rows of a table, in the order of the table. Writes `arm` of an element.
    """
    return StepEntry("follow_cell_strains", (timeline, cell_strains, elastic_facets, wall_constraints))


def follow_tractions(
    timeline: Timeline, facet_tractions: FacetTractions, cell_dilatation: CellDilatation
) -> StepEntry:
    """Brings tractions to the time of the clock.

    Over rows of a table, in the order of the table. Writes `given` of an element.
    """
    return StepEntry("follow_tractions", (timeline, facet_tractions, cell_dilatation))


def follow_walls(moving: Moving, wall_constraints: WallConstraints, rows: Rows) -> StepEntry:
    """Brings walls to the time of the clock; at a time that no step has reached, their forces are updated as well.

    Over rows of a table, in the order of the table. Reads `base` of an element; changes `came`, `wall` of an
    element.
    """
    return StepEntry("follow_walls", (moving, wall_constraints, rows))


def judge_facets_by_mohr_coulomb(
    moving: Moving, elastic_facets: ElasticFacets, facet_release: FacetRelease, strengths: Strengths, candidates:
    Candidates, postponed: Postponed
) -> StepEntry:
    """Evaluates marked facets by a criterion at the present stresses, and postpones cells that lose facets and
    their neighbours.

    Over what begins, changes or ends in the step, in order. Reads `pose`, `pose.stress` at both ends; adds
    `held` to elements.
    """
    return StepEntry("judge_facets_by_mohr_coulomb", (
        moving, elastic_facets, facet_release, strengths, candidates, postponed
    ))


def renew_wall_rows(wall_constraints: WallConstraints, rows: Rows, candidates: Candidates) -> StepEntry:
    """Updates the forces of walls on the rows of their cells.

    Over rows of a table, in the order of the table. Reads `load` of an element; writes `grip` of an element.
    """
    return StepEntry("renew_wall_rows", (wall_constraints, rows, candidates))


def restore_facets(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, facet_release: FacetRelease,
    candidates: Candidates, postponed: Postponed
) -> StepEntry:
    """Adds the loads of the remaining facets and of walls to the kept sums.

    Over what begins, changes or ends in the step, in order. Reads `arm`, `base`, `wall` of an element; reads
    `held`, `pose.stress` at both ends; reads `pose` at both ends, of elements that are postponed; adds `kept`,
    `load` to elements.
    """
    return StepEntry("restore_facets", (
        moving, elastic_facets, wall_constraints, facet_release, candidates, postponed
    ))


def stress_cells(moving: Moving, cell_dilatation: CellDilatation) -> StepEntry:
    """Sets the stresses of cells by their complete V θ, which is set to zero.

    Over elements of a block, then shared ones. Reads `given`, `weight` of an element; changes `swelling` of an
    element; writes `pose.stress` of an element.
    """
    return StepEntry("stress_cells", (moving, cell_dilatation))


def subtract_dilatation_energies(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, corrected_mass:
    CorrectedMass, portions: Portions
) -> StepEntry:
    """Subtracts the correction of the mass from the kinetic energies of cells.

    Over elements, in portions.
    """
    return StepEntry("subtract_dilatation_energies", (
        moving, elastic_facets, wall_constraints, corrected_mass, portions
    ))


def sum_dilatation_energies(cell_dilatation: CellDilatation, dilatation_energy: DilatationEnergy) -> StepEntry:
    """Sums the energy of dilatation of a portion of cells, whose V θ is complete and is set to zero [J].

    Over elements, in portions. Writes `swelling` of an element.
    """
    return StepEntry("sum_dilatation_energies", (cell_dilatation, dilatation_energy))


def sum_facet_energies(moving: Moving, elastic_facets: ElasticFacets, portions: Portions) -> StepEntry:
    """Sums normal, shear, bending and twisting energy of the facets of a portion, without dilatation [J].

    Over bonds, in portions. Reads `pose` at both ends.
    """
    return StepEntry("sum_facet_energies", (moving, elastic_facets, portions))


def sum_gradient_energies(
    moving: Moving, cell_dilatation: CellDilatation, wall_constraints: WallConstraints, dilatation_gradients:
    DilatationGradients
) -> StepEntry:
    """Sums the energies of gradients in portions of cells, for the dilatation that facets have added up.

    Over elements, in portions. Reads `pose` at both ends; adds `bend` to elements.
    """
    return StepEntry("sum_gradient_energies", (moving, cell_dilatation, wall_constraints, dilatation_gradients))


def sum_moments(
    moving: Moving, elastic_facets: ElasticFacets, facets_of_cells: FacetsOfCells, facet_forces: FacetForces
) -> StepEntry:
    """Finds V σ of cells from stored forces at the start of a run, with the bits of the sums of a step.

    Over elements, in portions. Reads `pose` at both ends; adds `moment` to elements.
    """
    return StepEntry("sum_moments", (moving, elastic_facets, facets_of_cells, facet_forces))


def sum_strain_powers(moving: Moving, cell_strains: CellStrains, elastic_facets: ElasticFacets) -> StepEntry:
    """Sums ∂U/∂factor of the facets of a portion, where it is needed.

    Over bonds, in portions. Reads `pose`, `pose.stress` at both ends.
    """
    return StepEntry("sum_strain_powers", (moving, cell_strains, elastic_facets))


def sum_stress_differences(moving: Moving, dilatation_gradients: DilatationGradients) -> StepEntry:
    """Sums the differences between the stresses of each cell and those of its neighbours.

    Over elements, in portions. Reads `pose.stress` at both ends; adds `difference` to elements.
    """
    return StepEntry("sum_stress_differences", (moving, dilatation_gradients))


def take_moments(facet_forces: FacetForces) -> StepEntry:
    """Sets V σ and Σ `bending_square` of cells from their complete sums, which are set to zero.

    Over elements of a block, then shared ones. Changes `sums` of an element; writes `moment` of an element.
    """
    return StepEntry("take_moments", (facet_forces,))


def twist_layers(
    moving: Moving, wall_constraints: WallConstraints, dilatation_gradients: DilatationGradients
) -> StepEntry:
    """Computes the torques of bent layers on each cell.

    Over elements, in portions. Reads `base` of an element; reads `bend`, `pose` at both ends; adds `torque` to
    elements.
    """
    return StepEntry("twist_layers", (moving, wall_constraints, dilatation_gradients))


def withdraw_facets(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, facet_release: FacetRelease,
    candidates: Candidates, postponed: Postponed
) -> StepEntry:
    """Lists the cells whose loads change, and subtracts the loads of their facets and walls from the kept sums.

    Over what begins, changes or ends in the step, in order. Reads `load` of an element; reads `held`,
    `pose.stress` at both ends; reads `pose` at both ends, of elements that are postponed; adds `held`, `kept`
    to elements.
    """
    return StepEntry("withdraw_facets", (
        moving, elastic_facets, wall_constraints, facet_release, candidates, postponed
    ))


#: Passes `judge_facets_by_…` by the name of their criterion.
JUDGE_FACETS_BY = {
    "mohr_coulomb": judge_facets_by_mohr_coulomb,
}
