"""A pressure whose normals turn with the cells: a membrane, or a fluid about a body that moves."""

from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from tests.bits import threads
from tests.models import momenta
from tests.specimens import cells, spheres

E, NU, RHO, P = 1e9, 0.2, 1e3, 1e4
BOX = bd.Box((3.0, 2.0, 1.0))
STEADY = bd.Constant(1.0)
SIDES = "x_min", "x_max", "y_min", "y_max", "z_min", "z_max"
#: Of 90° about z.
QUARTER = np.array([np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5)])


def turned(model: bd.Model) -> bd.State:
    """The body, a quarter of a turn about z on, at rest."""
    state, x = model.state(), model.lattice.centre
    state.set_pose(position=np.column_stack([-x[:, 1], x[:, 0], x[:, 2]]), orientation=np.tile(QUARTER, (len(x), 1)))
    return state


def model_of(follows: bool, *sides: str, schedule: bd.Schedule = STEADY) -> bd.Model:
    pressures = [bd.Pressure(bd.Face(side), P, schedule=schedule, follows=follows) for side in sides]
    return bd.Model(cells(BOX, 150), bd.CellBond(E=E, nu=NU), RHO, boundary=pressures)


@pytest.mark.filterwarnings("ignore::bondem.errors.TurnedPressureWarning")
@pytest.mark.parametrize("follows", [True, False])
def test_it_pushes_along_the_normals_of_now(follows: bool) -> None:
    """On one face of a body that has turned by 90°: momentum p A t along its normal, or that of the reference."""
    model = model_of(follows, "x_max")
    run = bd.solve_explicit(model, duration=2e-3, state=turned(model))
    momentum, _ = momenta(model, run.state)
    expected = P * 2.0 * 1.0 * run.state.time
    along = momentum[1] if follows else momentum[0]
    assert along == pytest.approx(-expected, rel=1e-4)
    assert np.abs(momentum).sum() == pytest.approx(expected, rel=1e-3)


@pytest.mark.filterwarnings("ignore::bondem.errors.TurnedPressureWarning")
def test_all_around_it_turns_nothing() -> None:
    """A fluid about a body makes no moment, however it stands; pressures of the reference would, some 2 p V here."""
    spins = []
    for follows in (True, False):
        model = model_of(follows, *SIDES)
        run = bd.solve_explicit(model, duration=2e-3, state=turned(model))
        spins.append(momenta(model, run.state)[1][2])
    assert spins[1] > 1.5 * P * 3.0 * 2.0 * 1.0 * run.state.time
    assert abs(spins[0]) < 1e-6 * spins[1]


def test_ledger_of_a_body_that_it_spins() -> None:
    """A jet along the body, on one corner: it turns by more than one radian, and the energy is that of the work."""
    corner = bd.Face("y_max") & bd.Within(bd.Box((0.7, 9.0, 9.0)).moved((2.3, -3.0, -3.0)))
    jet = bd.Pressure(corner, 100.0 * P, schedule=bd.Ramp(0.0, 1.0, 5e-3), follows=True)
    model = bd.Model(cells(BOX, 150), bd.CellBond(E=E, nu=NU), RHO, boundary=[jet])
    missed = []
    for safety in (0.8, 0.4):
        run = bd.solve_explicit(model, duration=0.15, safety=safety, every=50)
        energy = run.history.energy
        missed.append(np.abs(energy["balance"]).max() / energy["work"][-1])
    x, q = run.state.position, run.state.orientation
    assert abs(2.0 * np.arctan2(q[:, 3], q[:, 0])).min() > 1.0
    assert np.isfinite(x).all()
    assert missed[0] < 1e-6
    assert missed[1] < 0.35 * missed[0]


def test_pauses_files_and_threads_leave_no_trace(tmp_path: Path) -> None:
    model = model_of(True, "y_max", schedule=bd.Ramp(0.0, 1.0, 2e-3))
    whole = bd.solve_explicit(model, duration=4e-3).state
    half = bd.solve_explicit(model, duration=2e-3, out=tmp_path / "run.h5")
    read = bd.read_run(tmp_path / "run.h5")
    assert read.model.boundary[0].follows
    with threads(1):
        rest = bd.solve_explicit(read.model, duration=whole.time - half.state.time, state=read.state).state
    np.testing.assert_array_equal(rest.pose, whole.pose)


def test_refusals() -> None:
    with pytest.raises(InputError, match="follows = 'yes'; give True or False"):
        bd.Pressure(bd.Face("x_max"), P, follows="yes")  # type: ignore[arg-type]
    law = bd.EulerBernoulli(E=E, nu=0.2, radius_ratio=0.5)
    with pytest.raises(InputError, match="rotates with facets"):
        bd.Model(spheres(BOX, 150), law, RHO, boundary=[bd.Pressure(bd.Face("x_max"), P, follows=True)])
