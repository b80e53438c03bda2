"""Bodies of one cell: they have no inner facet, but mass, walls and contacts."""

import numpy as np
import pytest

import bondem as bd
from bondem.errors import UnstableStepError
from tests.specimens import cells

E, NU, RHO = 30e9, 0.2, 2500.0
LENGTH, SIDE = 2e-3, 1e-3
LAW = bd.CellBond(E=E, nu=NU)
BLOCK = cells(bd.Box((LENGTH, SIDE, SIDE)), 1)


@pytest.mark.parametrize("failure", [
    None, bd.MohrCoulomb(tension=1e6, cohesion=3e6, friction_angle=0.5),
    bd.MohrCoulomb(tension=1e6, cohesion=3e6, friction_angle=0.5, fracture_energy=10.0),
], ids=["elastic", "brittle", "softening"])  # fmt: skip
def test_a_block_falls_as_galilei_says(failure, tmp_path):
    """A body of one cell reaches g t, in its state and in its run file, without a warning of NumPy."""
    model = bd.Model(BLOCK, LAW, RHO, failure=failure, boundary=bd.Gravity())
    run = bd.solve_explicit(model, duration=1e-2, dt=1e-5, out=tmp_path / "run.h5")
    np.testing.assert_allclose(run.state.velocity, [[0.0, 0.0, -9.81e-2]], rtol=1e-9, atol=1e-15)
    np.testing.assert_array_equal(bd.read_run(tmp_path / "run.h5").state.velocity, run.state.velocity)
    assert bd.fragments(BLOCK, run.state).size.tolist() == [1]


@pytest.mark.parametrize(("shape", "inertia"), [
    (bd.Ball(1e-2), (0.4e-4,) * 3),  # 2/5 R² of a ball of unit mass
    (bd.Cylinder(radius=5e-3, length=2e-2), (1.25e-5, *((3 * 5e-3**2 + 2e-2**2) / 12,) * 2)),
], ids=["ball", "cylinder"])  # fmt: skip
def test_a_curved_body_of_one_cell_has_its_inertia(shape, inertia):
    body = cells(shape, 1)
    assert body.cells.volume == pytest.approx(shape.volume, rel=1e-12)
    middle = np.mean(shape.bounds, axis=0)
    np.testing.assert_allclose(body.centre, [middle], atol=1e-8)
    np.testing.assert_allclose(body.cells.inertia[0] / shape.volume, np.diag(inertia), rtol=1e-2, atol=1e-9)


def test_blocks_that_collide_exchange_their_velocities():
    scene = bd.join(BLOCK, BLOCK.moved((0.0, 0.0, 1.3 * SIDE)), names=("low", "high"))
    state = bd.Model(scene, LAW, RHO, contact=bd.LinearContact(E=E)).state()
    state.set_velocity(bd.Body("high"), (0.0, 0.0, -1.0))
    run = bd.solve_explicit(state.model, state=state, duration=2e-3)
    np.testing.assert_allclose(run.state.velocity, [[0.0, 0.0, -1.0], [0.0, 0.0, 0.0]], atol=1e-4)
    assert run.state.velocity[:, 2].sum() == pytest.approx(-1.0, rel=1e-12)


def test_a_block_held_by_walls_is_pulled_as_a_bar():
    """u = σ L / 2 E at its middle, and -ν σ W / 2 E across, with a default time step that the walls determine."""
    held = [bd.Fix(bd.Face(f"{axis}_min"), translation=axis, rotation="") for axis in "xyz"]
    stress = 5e6
    model = bd.Model(BLOCK, LAW, RHO, boundary=[*held, bd.Load(bd.Face("x_max"), (stress * SIDE**2, 0.0, 0.0))])
    run = bd.solve_explicit(model, duration=1e-4, damping=bd.MassDamping(alpha=1e6), imbalance=(1.0, 1.0))
    across = -NU * stress / E * SIDE / 2.0
    np.testing.assert_allclose(run.state.displacement, [[stress / E * LENGTH / 2.0, across, across]], rtol=1e-6)
    with pytest.raises(UnstableStepError, match="exceeds the critical"):
        bd.solve_explicit(model, duration=1e-4, dt=1e-6)
    with pytest.raises(UnstableStepError, match="no stiffness"):
        bd.solve_explicit(bd.Model(BLOCK, LAW, RHO), duration=1e-4)


def test_the_corrected_mass_of_a_block_is_its_mass():
    model = bd.Model(BLOCK, LAW, RHO, mass_matrix="dispersion-corrected", boundary=bd.Gravity())
    run = bd.solve_explicit(model, duration=1e-3, dt=1e-5)
    assert run.state.velocity[0, 2] == pytest.approx(-9.81e-3, rel=1e-9)
