"""Plane faces of two bodies of cells that stand against each other give a warning, because they do not slide."""

import math

import pytest

import bondem as bd
from bondem.errors import ContactWarning
from tests.specimens import cubes

SIDE, E = 1e-3, 1e8


def lying(*, gap: float = 0.0, tilt: float = 0.0, contact: bool = True) -> bd.Model:
    """A flat block of cubes above another one."""
    base, top = cubes((5, 4, 2), SIDE), cubes((3, 3, 2), SIDE)
    top = top.rotated((0.0, 1.0, 0.0), tilt).moved((SIDE, 0.5 * SIDE, 2 * SIDE + gap + 3 * SIDE * math.sin(tilt)))
    law = bd.LinearContact(E=E, friction=0.5) if contact else None
    return bd.Model(bd.join(base, top, names=("base", "top")), bd.CellBond(E=E, nu=0.2), 2400.0, contact=law)


def test_flat_blocks_that_lie_on_each_other_are_a_warning() -> None:
    with pytest.warns(ContactWarning, match=r"plane faces .* \('base' and 'top'\).*around=bd\.Plane.*bd\.PlaneWall"):
        bd.solve_explicit(lying(), duration=1e-5)
    with pytest.warns(ContactWarning, match="plane faces"):
        bd.solve_explicit(lying(gap=0.09 * SIDE), duration=1e-5)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("scene", [{"gap": 0.11 * SIDE}, {"tilt": 0.05}, {"contact": False}])
def test_other_bodies_are_none(scene: dict) -> None:
    bd.solve_explicit(lying(**scene), duration=1e-5)


@pytest.mark.filterwarnings("error")
def test_a_collision_is_none() -> None:
    model = lying()
    state = model.state()
    state.set_velocity(bd.Body("top"), (0.0, 0.0, -0.1))
    bd.solve_explicit(model, duration=1e-5, state=state)
    state.set_velocity(bd.Body("top"), (0.1, 0.0, -0.1))
    with pytest.raises(ContactWarning, match="plane faces"):
        bd.solve_explicit(model, duration=1e-5, state=state)


@pytest.mark.filterwarnings("error")
def test_a_ball_on_a_plate_is_none() -> None:
    ball = bd.connect(bd.pack(bd.Ball(5 * SIDE), count=300, method="even", seed=1), method="laguerre")
    low = ball.cells.free.centroid[:, 2].min()
    scene = bd.join(cubes((12, 12, 2), SIDE), ball.moved((6 * SIDE, 6 * SIDE, 2 * SIDE - low)))
    law = bd.LinearContact(E=E, friction=0.5)
    bd.solve_explicit(bd.Model(scene, bd.CellBond(E=E, nu=0.2), 2400.0, contact=law), duration=1e-5)


def test_a_run_that_goes_on_does_not_warn_again() -> None:
    model = lying()
    with pytest.warns(ContactWarning, match="plane faces"):
        run = bd.solve_explicit(model, duration=1e-5)
    bd.solve_explicit(model, duration=1e-5, state=run.state)
