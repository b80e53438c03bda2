"""Second stages of bodies of cells: walls take over a face where it is, with the force that it bears."""

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from tests.bits import assert_same_bits
from tests.elastic_energy import elastic_energy
from tests.specimens import cells

LAW = bd.CellBond(E=30e9, nu=0.2)
LEFT, RIGHT = bd.Face("x_min"), bd.Face("x_max")
T, V, DT = 1e-4, 0.05, 1e-6
HELD = bd.Fix(LEFT)
PULL = bd.Drive(RIGHT, vx=bd.Ramp(0.0, V, T))
GAUGES = {"gauges": {"force": bd.Gauge(RIGHT, "force", "sum")}, "every": 5}


@pytest.fixture(scope="module")
def body() -> bd.Lattice:
    return cells(bd.Box((0.1, 0.05, 0.05)), 300, spread=0.2)


def model_of(body: bd.Lattice, *boundary) -> bd.Model:
    return bd.Model(body, LAW, 2400.0, boundary=boundary)


def go(model: bd.Model, duration: float = T, **options):
    return bd.solve_explicit(model, duration=duration, dt=DT, **{**GAUGES, **options})


@pytest.fixture(scope="module")
def pulled(body: bd.Lattice):
    return go(model_of(body, HELD, PULL))


TAKEN = {
    "Fix": bd.Fix(RIGHT),
    "Drive at rest": bd.Drive(RIGHT, vx=0.0),
    "Drive back": bd.Drive(RIGHT, vx=bd.Ramp(V, -V, T, begin=T)),
    "the same": PULL,
    "Fix along x": bd.Fix(RIGHT, translation="x", rotation=""),
}


@pytest.mark.parametrize("condition", TAKEN.values(), ids=TAKEN)
def test_a_wall_goes_on_from_where_it_is(body, pulled, condition) -> None:
    on = go(model_of(body, HELD, condition), state=pulled.state)
    before, after = pulled.history["force"][-1, 0], on.history["force"][0, 0]
    assert abs(before) > 1e3
    assert after == pytest.approx(before, rel=1e-9)
    assert on.residual < 5e-3  # dt², and little is worked in a stage at rest; it was 0.12
    moved = on.state.displacement[RIGHT.select(body), 0].mean()
    assert moved == pytest.approx({"Drive back": 0.5, "the same": 1.5}.get(_name(condition), 0.5) * V * T, rel=0.1)


def _name(condition) -> str:
    return next(name for name, one in TAKEN.items() if one is condition)


def test_stages_that_go_on_are_one_run(body, pulled) -> None:
    whole = go(model_of(body, HELD, PULL), 2.0 * T)
    other = bd.Drive(bd.Face("x_max"), vx=bd.Ramp(0.0, V, T))  # the same made anew
    on = go(model_of(body, bd.Fix(LEFT), other), state=pulled.state)
    size = np.abs(whole.state.displacement).max()
    np.testing.assert_allclose(on.state.displacement, whole.state.displacement, rtol=0.0, atol=1e-10 * size)


def test_a_displacement_that_would_jump_is_refused_as_of_beams(body, pulled) -> None:
    drive = bd.Drive(RIGHT, x=bd.Ramp(0.0, 1e-5, T, begin=T))
    with pytest.raises(InputError, match=r"Drive\(x=\) begins at 0, but is at 2.5e-06 when .*cannot jump"):
        go(model_of(body, HELD, drive), state=pulled.state)
    on = bd.Drive(RIGHT, x=bd.Ramp(0.5 * V * T, 0.5 * V * T + 1e-6, T, begin=T))
    found = go(model_of(body, HELD, on), state=pulled.state)
    assert found.history["force"][0, 0] == pytest.approx(pulled.history["force"][-1, 0], rel=1e-6)
    assert found.residual < 5e-3


def test_a_wall_that_takes_over_a_loaded_face_bears_the_load(body) -> None:
    load = bd.Load(RIGHT, force=(5e3, 0.0, 2e2), schedule=bd.Ramp(0.0, 1.0, T))
    loaded = go(model_of(body, HELD, load))
    held = model_of(body, HELD, bd.Fix(RIGHT))
    first = go(held, 0.0, state=loaded.state).history
    np.testing.assert_allclose(first["force"][0], [5e3, 0.0, 2e2], atol=5.0)
    on = go(held, state=loaded.state)
    assert on.residual < 5e-3
    both = go(model_of(body, HELD, bd.Fix(RIGHT), load), 0.0, state=loaded.state).history
    np.testing.assert_allclose(both["force"][0], [5e3, 0.0, 2e2], atol=5.0)  # the wall bears nothing yet


def test_a_face_that_has_turned_is_held_as_it_is(body) -> None:
    """A rigid body that has turned by 1 rad and been moved: its walls exert nothing."""
    free = model_of(body)
    state, turn = free.state(), 1.0
    c, s = np.cos(turn), np.sin(turn)
    state.set_pose(
        position=state.position @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]]) + 0.3,
        orientation=np.tile([np.cos(0.5), 0.0, 0.0, np.sin(0.5)], (len(body.particles), 1)),
    )
    for condition in (bd.Fix(RIGHT), bd.Fix(RIGHT, translation="y", rotation="")):
        run = go(model_of(body, condition), state=state)
        assert np.abs(run.history["force"]).max() < 1e-2  # rounding: k times 1e-16 m
        assert run.history.energy["translation"].max() < 1e-12
    # weight along its own axis, with the wall as stiff as in the reference
    pull = 1e4
    turned = go(model_of(body, bd.Fix(RIGHT), bd.BodyForce((pull * c, pull * s, 0.0))), state=state)
    plain = go(model_of(body, bd.Fix(RIGHT), bd.BodyForce((pull, 0.0, 0.0))))
    size = np.abs(plain.state.displacement).max()
    moved = (turned.state.position - state.position) @ np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    np.testing.assert_allclose(moved, plain.state.displacement, atol=1e-6 * size)


def test_a_stage_with_taken_walls_goes_on_from_its_file_to_the_bit(body, pulled, tmp_path) -> None:
    model = model_of(body, HELD, bd.Fix(RIGHT))
    whole = go(model, state=pulled.state, out=tmp_path / "whole.h5", save_every=40)

    cut = go(model, state=pulled.state, out=tmp_path / "cut.h5", save_every=40,
             callback=lambda state, record: state.step == 40)  # fmt: skip
    assert cut.steps == 40
    assert_same_bits(whole, bd.resume(tmp_path / "cut.h5"))
    assert elastic_energy(model, whole.state).total == pytest.approx(
        sum(whole.history.energy[name][-1] for name in ("normal", "shear", "bending", "twisting")), rel=1e-9
    )
