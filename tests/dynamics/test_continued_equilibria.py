"""Explicit runs that continue an equilibrium: the same forces of walls and facets, of whole and of cracked bodies."""

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError, StageWarning
from bondem.observables.cell_forces import CellForces
from tests.models import pulled
from tests.specimens import cube, cubes

E, STRENGTH, ENERGY, SIDE = 40e9, 4e6, 50.0, 0.08
LAW, FAILURE = bd.CellBond(E=E, nu=0.2), bd.Rankine(tension=STRENGTH, fracture_energy=ENERGY)
LEFT, RIGHT = bd.Face("x_min"), bd.Face("x_max")
HELD, STILL = bd.Fix(LEFT), bd.Fix(RIGHT, translation="x", rotation="")
LAST = 2.0 * ENERGY / STRENGTH
PULL = bd.Drive(RIGHT, x=bd.Ramp(0.0, LAST, 1e-3))
LOAD = bd.Load(RIGHT, force=(2e4, 0.0, 0.0), schedule=bd.Ramp(0.0, 1.0, 1e-3))
PRESSURE = bd.Pressure(RIGHT, -2e6)
# Whole, past the peak, and far down: number of events at which a path stops.
EVENTS = [1, 60, 150]


@pytest.fixture(scope="module")
def body() -> bd.Lattice:
    return cube(60, SIDE)


def model_of(body: bd.Lattice, *boundary, failure=FAILURE) -> bd.Model:
    return bd.Model(body, LAW, 2400.0, boundary=boundary, failure=failure)


@pytest.fixture(scope="module")
def paths(body: bd.Lattice) -> dict[int, bd.QuasistaticResult]:
    return {most: bd.solve_quasistatic(model_of(body, HELD, PULL), RIGHT, until=0.0, most=most) for most in EVENTS}


def go(model: bd.Model, state, duration: float = 0.0):
    gauges = {"force": bd.Gauge(RIGHT, "force", "sum")}
    return bd.solve_explicit(model, duration=duration, state=state, every=1, gauges=gauges)


def unbalanced(run) -> float:
    """Largest force on a cell over the largest of a facet."""
    force = run.state.acceleration[:, :3] / run.state.motion[:, 3:4]
    return float(np.abs(force).max() / np.abs(run.state.facet_force).max())


def after(path: bd.QuasistaticResult) -> dict[str, bd.Drive | bd.Fix]:
    x = float(path.factor[-1]) * LAST
    return {
        "held": STILL, "all axes": bd.Fix(RIGHT), "velocity": bd.Drive(RIGHT, vx=bd.Ramp(0.0, 1e-3, 1e-3)),
        "displacement": bd.Drive(RIGHT, x=bd.Ramp(x, 2.0 * x, 1.0)),
    }  # fmt: skip


@pytest.mark.parametrize("most", EVENTS)
def test_a_run_begins_with_the_forces_of_the_equilibrium(body, paths, most: int) -> None:
    path = paths[most]
    state = path.state
    assert (len(state.cracks) > 20) == (most > 1)
    own = CellForces.of(state.model, state)
    right = np.isin(state.model.cell_constants.supports.cell, RIGHT.select(body))
    assert own.wall[right, 0].sum() == pytest.approx(path.load[-1], rel=1e-7)
    size = np.abs(state.facet_force).max()
    for boundary in (state.model.boundary, *((HELD, one) for one in after(path).values())):
        run = go(model_of(body, *boundary), state)
        assert run.history["force"][0, 0] == pytest.approx(path.load[-1], rel=1e-6)
        np.testing.assert_allclose(run.state.facet_force, state.facet_force, atol=1e-5 * size)
        np.testing.assert_array_equal(run.state.integrity, state.integrity)
        assert unbalanced(run) < 1e-5  # of the order of rotations
        assert run.history.energy["translation"][0] == 0.0


@pytest.mark.parametrize("most", EVENTS)
def test_an_equilibrium_whose_walls_are_held_stays(body, paths, most: int) -> None:
    """What softens by its steps is at most the band of 2 % around the curve; the ledger is closed."""
    path = paths[most]
    run = go(model_of(body, HELD, STILL), path.state, 1e-4)
    assert run.steps > 30
    force = run.history["force"][:, 0] / path.load[-1]
    assert force.min() > 0.96
    assert force.max() < 1.0 + 1e-3
    energy = run.history.energy
    stored = sum(energy[name] for name in ("normal", "shear", "bending", "twisting"))
    assert (energy["translation"] + energy["rotation"]).max() < 2e-4 * stored[0]
    assert run.history.imbalance < 2e-5


def test_a_path_continued_to_its_end_dissipates_the_fracture_energy(body, paths) -> None:
    path = paths[60]
    boundary = HELD, bd.Drive(RIGHT, vx=4e-3)
    run = go(model_of(body, *boundary), path.state, 8e-3)
    energy = run.history.energy
    spent = path.energy[:-1].sum() + sum(energy[name][-1] for name in ("fracture", "crushing", "friction"))
    assert abs(run.history["force"][-1, 0]) < 0.03 * STRENGTH * SIDE**2
    assert spent == pytest.approx(ENERGY * SIDE**2, rel=0.08)


@pytest.mark.parametrize("load", [LOAD, PRESSURE], ids=["Load", "Pressure"])
def test_a_loaded_face_is_continued_or_taken_over_by_a_wall(body, load) -> None:
    path = bd.solve_quasistatic(model_of(body, HELD, load), RIGHT, until=0.0, most=15)
    state = path.state
    run = go(state.model, state)
    assert run.history["force"][0, 0] == pytest.approx(path.load[-1], rel=1e-5)
    assert unbalanced(run) < 2e-4
    run = go(model_of(body, HELD, bd.Fix(RIGHT)), state)
    assert run.history["force"][0, 0] == pytest.approx(path.load[-1], rel=1e-4)
    with pytest.warns(StageWarning, match=rf"{type(load).__name__}: its factor is \d.* in the equilibrium"):
        go(model_of(body, HELD, load), state)


def test_walls_that_would_jump_are_refused(body, paths) -> None:
    with pytest.raises(InputError, match=r"Drive\(x=\) begins at 0, but is at .* cannot jump: begin there"):
        go(model_of(body, HELD, PULL), paths[60].state)
    elastic = model_of(body, HELD, PULL, failure=None)
    with pytest.raises(InputError, match=r"Drive\(x=\) begins at 0, but is at 2.5e-05"):
        go(elastic, bd.solve_static(elastic).state)


@pytest.mark.parametrize("nonlinear", [False, True])
def test_a_run_begins_with_the_walls_of_a_static_solution(body, nonlinear: bool) -> None:
    found = bd.solve_static(model_of(body, HELD, PULL, failure=None), nonlinear=nonlinear)
    wanted = found.reaction[RIGHT.select(body), 0].sum()
    for boundary in (found.state.model.boundary, (HELD, STILL)):
        run = go(model_of(body, *boundary, failure=None), found.state)
        assert run.history["force"][0, 0] == pytest.approx(wanted, rel=1e-4 if not nonlinear else 1e-8)


def test_a_velocity_is_given_to_an_equilibrium_with_cracks(body, paths) -> None:
    state = paths[60].state.copy()
    state.velocity = (0.0, 0.0, 0.1)
    run = go(model_of(body, HELD, bd.Fix(RIGHT)), state)
    assert run.history["force"][0, 0] == pytest.approx(paths[60].load[-1], rel=1e-6)
    state.displacement = state.displacement + 1e-6
    with pytest.raises(InputError, match="run a step first"):
        go(model_of(body, HELD, bd.Fix(RIGHT)), state)


def test_a_body_in_two_parts_is_continued_where_its_walls_are() -> None:
    model = pulled(cubes((4, 1, 1), 1e-3), nu=0.0)
    path = bd.solve_quasistatic(model, RIGHT, until=0.0, together=0.0)
    assert path.end == "parted"
    np.testing.assert_array_equal(path.state.bond_integrity, path.bond_integrity)
    still = bd.Model(model.lattice, model.bond, 2500.0, boundary=[model.boundary[0], STILL], failure=model.failure)
    run = go(still, path.state)
    assert run.state.displacement[3, 0] == pytest.approx(path.displacement[-1], rel=1e-3)
    assert abs(run.history["force"][0, 0]) < 0.2 * path.peak


def test_a_velocity_of_a_face_has_no_equilibrium(body) -> None:
    rate = model_of(body, HELD, bd.Drive(RIGHT, vx=1.0), failure=None)
    with pytest.raises(InputError, match=r"replace vx= … wz= of Drive by x="):
        bd.solve_static(rate)
