"""Moments on faces that turn: their forces turn with the region, so that the moment stays what it is."""

import math

import numpy as np
import pytest

import bondem as bd
from tests.specimens import cells, grid

LEFT, RIGHT = bd.Face("x_min"), bd.Face("x_max")
LONG = 60
BAR = (LONG + 1, 2, 2)  # spheres 1 mm apart


SHORT = (25, 2, 2)  # for runs whose number of steps goes with the square of the length


def model_of(*boundary, bar: tuple[int, int, int] = BAR) -> bd.Model:
    law = bd.EulerBernoulli(E=70e9, nu=0.3, radius_ratio=0.5)
    return bd.Model(grid(bar), law, 2000.0, boundary=[bd.Fix(LEFT), *boundary])


def moment_for(turn: float, axis: int = 2, bar: tuple[int, int, int] = BAR) -> tuple[float, ...]:
    """The moment that turns the end by `turn` [rad] as EI is found from a small one."""
    unit = np.eye(3)[axis]
    found = bd.solve_static(model_of(bd.Load(RIGHT, moment=tuple(1e-4 * unit)), bar=bar))
    return tuple(turn / found.rotation[RIGHT.select(grid(bar)), axis].mean() * 1e-4 * unit)


def check_circle(displacement, rotation, turn: float) -> None:
    """Elastica: a cantilever under an end moment is an arc of M / EI, to the square of strains h / 2R."""
    end = RIGHT.select(grid(BAR))
    length, strain = 1e-3 * LONG, turn / (2.0 * LONG)
    assert rotation[end, 2].mean() == pytest.approx(turn, rel=12.0 * strain**2)
    wanted = np.array([math.sin(turn) / turn - 1.0, (1.0 - math.cos(turn)) / turn, 0.0])
    np.testing.assert_allclose(displacement[end].mean(axis=0) / length, wanted, atol=12.0 * strain**2)


@pytest.mark.parametrize("turn", [1.5, pytest.param(3.0, marks=pytest.mark.validate)])
def test_a_face_under_a_moment_bends_a_bar_to_an_arc(turn: float) -> None:
    load = bd.Load(RIGHT, moment=moment_for(turn))
    static = bd.solve_static(model_of(load), nonlinear=True)
    check_circle(static.displacement, static.rotation, turn)


@pytest.mark.validate
def test_a_bar_bends_to_a_full_circle() -> None:
    turn = 2.0 * math.pi
    found = bd.solve_static(model_of(bd.Load(RIGHT, moment=moment_for(turn))), nonlinear=True)
    end = RIGHT.select(grid(BAR))
    tip = found.displacement[end].mean(axis=0) + np.array([1e-3 * LONG, 0.0, 0.0])
    assert np.linalg.norm(tip) < 0.05 * 1e-3 * LONG  # strains of 5 %
    assert abs(found.rotation[end, 2].mean()) < 0.25  # a full turn, as a rotation vector has it


@pytest.mark.validate
def test_relaxation_and_explicit_runs_bend_it_as_statics_does() -> None:
    moment, length = moment_for(1.5, bar=SHORT), 1e-3 * (SHORT[0] - 1)
    load = bd.Load(RIGHT, moment=moment)
    static = bd.solve_static(model_of(load, bar=SHORT), nonlinear=True)
    relaxed = bd.solve_relaxed(model_of(load, bar=SHORT), tolerance=1e-7)
    np.testing.assert_allclose(relaxed.displacement, static.displacement, atol=2e-4 * length)
    model = model_of(bd.Load(RIGHT, moment=moment, schedule=bd.Ramp(0.0, 1.0, 1.6e-4)), bar=SHORT)
    omega = 2.0 * math.pi * bd.solve_modes(model, count=1, prestress=False).frequency[0]
    run = bd.solve_explicit(model, duration=20.0 / omega, damping=bd.MassDamping(2.0 * omega), every=500)
    np.testing.assert_allclose(run.state.displacement, static.displacement, atol=2e-3 * length)
    assert run.residual < 1e-3  # the ledger knows the forces that turn


def test_opposite_moments_leave_a_free_bar_where_it_is() -> None:
    """Forces of a moment have no resultant, nor a moment but their own, however their region is deformed."""
    M = np.array([0.02, 0.05, -0.04])
    loads = [bd.Load(face, moment=tuple(sign * M), schedule=bd.Ramp(0.0, 1.0, 1e-4))
             for face, sign in ((LEFT, -1.0), (RIGHT, 1.0))]  # fmt: skip
    model = bd.Model(grid(BAR), bd.EulerBernoulli(E=70e9, nu=0.3, radius_ratio=0.5), 2000.0, boundary=loads)
    state = bd.solve_explicit(model, duration=2e-4).state
    speed = np.abs(state.velocity).max()
    assert speed > 0.1
    momentum = (model.mass[:, None] * state.velocity).sum(axis=0)
    assert np.abs(momentum).max() < 1e-12 * model.mass.sum() * speed
    spin = np.cross(state.position, model.mass[:, None] * state.velocity)
    spin += model.inertia[:, None] * state.angular_velocity
    assert np.abs(spin.sum(axis=0)).max() < 1e-9 * model.mass.sum() * speed * 1e-3 * LONG


@pytest.mark.validate
def test_a_face_of_cells_under_a_moment_turns_by_what_it_is() -> None:
    """A bar of cells: as far as its own EI says."""
    body = cells(bd.Box((0.06, 0.012, 0.012)), 500, spread=0.2, seed=3)
    law, end = bd.CellBond(E=1e9, nu=0.2), RIGHT.select(body)
    little = bd.Load(RIGHT, moment=(0.0, 0.0, 1e-3))
    small = bd.solve_static(bd.Model(body, law, 2e3, boundary=[bd.Fix(LEFT), little]))
    M = 1.0 / small.rotation[end, 2].mean() * 1e-3
    model = bd.Model(body, law, 2e3, boundary=[bd.Fix(LEFT), bd.Load(RIGHT, moment=(0.0, 0.0, M))])
    found = bd.solve_static(model, nonlinear=True)
    assert found.rotation[end, 2].mean() == pytest.approx(1.0, rel=0.03)  # strains of 10 %; cos θ of it before
