"""Products of the stiffness with small motions, and tangents of single bonds: derivatives exact to rounding."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import bondem as bd
from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.cell_tables import CellPoses
from bondem._tables.step_tables import BeamSums
from bondem._tables.stiffness_tables import StiffnessProduct
from bondem.interactions.beams.beam_tables import beam_tables, load_beams
from bondem.interactions.cells.cell_tangent import BodyTables, CellsAtAnyPose
from bondem.interactions.stiffness_product import loads_in
from bondem.statics.nonlinear import strained
from tests.beam_theory import beam_stiffness
from tests.interactions.test_bond_energy import LAWS, cluster
from tests.models import clamped
from tests.specimens import crooked_cells, crystal, row

# Central differences of order ten: truncation and rounding are about 1e-13 of the forces.
STEP, WEIGHTS = 2e-3, {1: 5 / 6, 2: -5 / 21, 3: 5 / 84, 4: -5 / 504, 5: 1 / 1260}
BODY = crooked_cells((4, 3, 3))
FULL = bd.CellBond(E=1.0, nu=0.2, facet_rotation="full")
CASES = {
    **{name: bd.Model(cluster(), law, 1000.0) for name, law in LAWS.items()},
    "two beams": bd.Model(row(3, 1.0), LAWS["Timoshenko"], 1.0),
    "beams of a periodic cell": bd.Model(bd.connect(crystal(3), reach=1.1), LAWS["ParallelBond"], 1.0),
    "cells": bd.Model(BODY, bd.CellBond(E=1.0, nu=0.3), 1.0),
    "cells, nu < 0": bd.Model(BODY, bd.CellBond(E=1.0, nu=-0.3), 1.0),
    "cells that may fail": bd.Model(BODY, FULL, 1.0, failure=bd.Rankine(tension=1.0)),
    "cells of a periodic cell": bd.Model(crooked_cells((3, 3, 3), periodic=True), FULL, 1.0),
    "held cells": clamped(BODY, FULL),
    "layer of cells": bd.Model(crooked_cells((4, 3, 1)), bd.CellBond(E=1.0, nu=0.3), 1.0),
    "held column of cells": clamped(crooked_cells((6, 1, 1)), bd.CellBond(E=1.0, nu=0.3)),
}
PRESSED = [bd.Drive(bd.Face("x_min"), x=0.1, y=0.05, z=0.0), bd.Pressure(bd.Face("x_max"), 0.05)]
LOADED = {**CASES, "pressed cells": strained(bd.Model(BODY, FULL, 1.0, boundary=PRESSED), 1.0)}
every_case = pytest.mark.parametrize("model", CASES.values(), ids=CASES.keys())
pytestmark = pytest.mark.filterwarnings("ignore::bondem.errors.ThinBodyWarning")


def weakened(model: bd.Model, seed: int = 0) -> np.ndarray:
    """Integrity of the bonds, all different."""
    return np.random.default_rng(seed).uniform(0.2, 1.0, len(model.layout.i))


def motion_of(model: bd.Model, seed: int = 0) -> np.ndarray:
    """Displacements in bond lengths and rotations of all elements, (n, 6)."""
    motion = np.random.default_rng(seed).standard_normal((len(model.layout.order), 6))
    motion[:, :3] *= model.bonds.length.mean()
    return motion


def moved(pose: np.ndarray, motion: np.ndarray) -> np.ndarray:
    """Poses after displacements and rotations (u, θ), (n, 6)."""
    there = pose.copy()
    there[:, :3] += motion[:, :3]
    turned = Rotation.from_rotvec(motion[:, 3:]) * Rotation.from_quat(pose[:, 4:], scalar_first=True)
    there[:, 4:] = turned.as_quat(scalar_first=True)
    return there


def shaken(model: bd.Model) -> np.ndarray:
    """Poses with large relative motions, and the stresses of cells in them."""
    pose = moved(model.state().pose, 0.05 * motion_of(model, seed=5))
    model.interaction.gradient(pose)
    return pose


def forces(model: bd.Model, pose: np.ndarray, integrity: np.ndarray) -> np.ndarray:
    """Resistance of bonds and walls at rest, (n, 6)."""
    law, sums, there = model.interaction, np.zeros((len(pose), 8)), pose.copy()
    if isinstance(law, CellsAtAnyPose):
        body = BodyTables.of(law, law.constants, integrity)
        body.walls.wall[:] = 0.0
        body.load(there, model.state().rest, sums)
    else:
        beams, _ = beam_tables(model.bonds, model.layout, model.period, integrity, may_share=False)
        load_beams(there, beams, BeamSums(beams.i, beams.j, sums))
    return -loads_in(sums)


def by_differences(model: bd.Model, pose: np.ndarray, integrity: np.ndarray, motion: np.ndarray) -> np.ndarray:
    """The derivative of the forces along a motion, by central differences."""
    total = np.zeros_like(motion)
    for k, weight in WEIGHTS.items():
        for sign in (1.0, -1.0):
            total += sign * weight * forces(model, moved(pose, sign * k * STEP * motion), integrity)
    return total / STEP


def assert_close(found: np.ndarray, expected: np.ndarray, within: float) -> None:
    """Assert that forces and torques differ by at most a share of the largest of each."""
    for part in (slice(0, 3), slice(3, 6)):
        assert np.abs(found - expected)[:, part].max() <= within * np.abs(expected[:, part]).max()


@pytest.mark.parametrize("model", LOADED.values(), ids=LOADED.keys())
def test_a_product_is_the_derivative_of_the_forces_in_any_pose(model: bd.Model) -> None:
    pose, integrity, motion = shaken(model), weakened(model), motion_of(model)
    expected = by_differences(model, pose, integrity, motion)
    assert_close(model.interaction.product(pose, integrity, model.bonds)(motion), expected, 1e-12)


@every_case
def test_a_product_at_rest_is_that_of_the_assembled_matrix_which_shares_no_law_with_it(model: bd.Model) -> None:
    pose, motion = model.state().pose, motion_of(model)
    product = model.interaction.product(pose, np.ones(len(model.layout.i)), model.bonds)
    expected = (model.interaction.stiffness() @ motion.ravel()).reshape(-1, 6)
    assert_close(product(motion), expected, 3e-15)
    assert_close(product(motion), expected, 3e-15)  # a product leaves nothing for the next one


@every_case
def test_the_stiffness_at_rest_is_symmetric(model: bd.Model) -> None:
    product = model.interaction.product(model.state().pose, weakened(model), model.bonds)
    one, other = motion_of(model, seed=1), motion_of(model, seed=2)
    forth, back = one * product(other), other * product(one)
    assert abs(forth.sum() - back.sum()) <= 3e-15 * np.abs(forth).sum()


def test_the_tangent_of_a_beam_at_rest_is_the_textbook_matrix() -> None:
    E, nu, r, L = 3e6, 0.3, 0.2, 1.3
    model = bd.Model(row(2, L), bd.EulerBernoulli(E=E, nu=nu, radius=r), 1.0)
    inertia = np.pi * r**4 / 4.0
    expected = beam_stiffness(L, E * np.pi * r**2, E * inertia, E / (1.0 + nu) * inertia)
    flipped = np.r_[6:12, 0:6] if model.layout.order[0] == 1 else np.arange(12)
    found = model.interaction.bond_tangents(model.state().pose)[:, :, 0]
    assert np.abs(found - expected[np.ix_(flipped, flipped)]).max() <= 3e-16 * expected.max()


@pytest.mark.parametrize("model", [case for case in CASES.values() if not len(case.interaction.supports.cell)])
def test_tangents_of_single_bonds_sum_up_to_the_product(model: bd.Model) -> None:
    """Those of facets to the product at unchanged stresses of cells."""
    pose, motion, law, layout = shaken(model), motion_of(model), model.interaction, model.layout
    intact = np.ones(len(layout.i))
    ends = np.concatenate([motion[layout.i], motion[layout.j]], axis=1)
    loads = np.einsum("rcm,mc->mr", law.bond_tangents(pose), ends)
    found = np.zeros_like(motion)
    np.add.at(found, layout.i, loads[:, :6])
    np.add.at(found, layout.j, loads[:, 6:])
    if isinstance(law, CellsAtAnyPose):
        body, n = BodyTables.of(law, law.constants, intact), len(pose)
        cells = body.cells._replace(weight=np.zeros(n))
        gradients = body.gradients._replace(weight=np.zeros_like(body.gradients.weight))
        poses = CellPoses(pose, model.state().rest)
        by = StiffnessProduct(motion, np.zeros((n, 6)), np.zeros((n, 8)), np.zeros((n, 8)))
        run_pass(calls.multiply_body(poses, by, body.facets, cells, gradients, body.walls))
        assert_close(found, by.found, 1e-13)
    else:
        assert_close(found, law.product(pose, intact, model.bonds)(motion), 1e-13)


def test_the_product_of_the_non_local_law_is_that_of_its_springs() -> None:
    model = bd.Model(BODY, bd.NonLocal(E=1.0, nu=0.2), 1.0)
    motion, order = motion_of(model), model.layout.order
    by_user = np.empty_like(motion)
    by_user[order] = motion
    strain = model.interaction.at_rest().moved(by_user)
    product = model.interaction.product(model.state().pose, weakened(model), model.bonds)
    assert_close(product(motion), -strain.nodal(strain.force)[order], 3e-15)
