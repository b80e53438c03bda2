"""Pressures that keep their direction while their face turns."""

import math
import warnings

import numpy as np
import pytest

import bondem as bd
from bondem.errors import TurnedPressureWarning
from tests.specimens import cells

STEP = 1e-9


def turned(model: bd.Model, angle: float) -> bd.State:
    """State of a body that has turned about x, without strain."""
    state, (y, z) = model.state(), model.lattice.centre[:, 1:].T
    c, s = math.cos(angle), math.sin(angle)
    place = np.stack([model.lattice.centre[:, 0], c * y - s * z, s * y + c * z], axis=1)
    axis = [math.cos(0.5 * angle), math.sin(0.5 * angle), 0.0, 0.0]
    state.set_pose(position=place, orientation=np.tile(axis, (len(y), 1)))
    return state


@pytest.mark.parametrize(("angle", "follows", "count"), [(0.11, False, 1), (0.09, False, 0), (3.0, True, 0)])
def test_a_run_warns_once_of_a_turned_face(angle: float, follows: bool, count: int) -> None:
    face = bd.Pressure(bd.Face("side"), 1e3, follows=follows)
    body = cells(bd.Cylinder(radius=3e-3, length=9e-3), 60)
    model = bd.Model(body, bd.CellBond(E=30e9, nu=0.2), 2500.0, boundary=[face])
    with warnings.catch_warnings(record=True, action="always") as caught:
        bd.solve_explicit(model, duration=20 * STEP, dt=STEP, every=1, state=turned(model, angle))
    assert [one.category for one in caught] == [TurnedPressureWarning] * count


def test_a_body_free_to_turn_is_spun_up_by_a_pressure_that_does_not_follow() -> None:
    """From rest, by rounding errors alone; turned by a straight angle the pressure would pull."""
    ends = [bd.Fix(bd.Face(f"x_{side}"), "x", "") for side in ("min", "max")]
    body = cells(bd.Cylinder(radius=3e-3, length=20e-3), 150)
    for follows in (False, True):
        side = bd.Pressure(bd.Face("side"), 9e6, schedule=bd.Ramp(0.0, 1.0, 3e-4), follows=follows)
        model = bd.Model(body, bd.CellBond(E=30e9, nu=0.2), 2500.0, boundary=[*ends, side])
        with warnings.catch_warnings(record=True, action="always") as caught:
            run = bd.solve_explicit(model, duration=2e-3, damping=bd.MassDamping(3e4))
        still = np.abs(run.state.orientation[:, 0]).min()
        assert (still < 0.1, len(caught)) == ((True, 1) if not follows else (False, 0))
