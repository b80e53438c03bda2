"""Runs that go on from a state: which model it may be of, where prescribed motion begins, what time means."""

import warnings
from dataclasses import replace

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError, StageWarning
from tests.specimens import grid, loose

LATTICE = grid((5, 3, 3))
GRID = LATTICE.centre
LAW = bd.EulerBernoulli(E=70e9, nu=0.3, radius_ratio=0.5)
RATES = replace(LAW, formulation="incremental")
LEFT, RIGHT = bd.Face("x_min"), bd.Face("x_max")
PULL = bd.Load(RIGHT, force=(50.0, 0, 0), schedule=bd.Ramp(0.0, 1.0, 1e-6))
DT = 5e-8


def model_of(*boundary, lattice=LATTICE, law=LAW, density=2000.0, **options):
    return bd.Model(lattice, law, density, boundary=boundary, **options)


MODEL = model_of(bd.Fix(LEFT), PULL)


def go(model, steps, **options):
    return bd.solve_explicit(model, duration=steps * DT, dt=DT, **options)


@pytest.fixture(scope="module")
def moved() -> bd.State:
    return go(MODEL, 40).state


# ---- which model a state may be of


def grid_of(scale=1.0, radius=0.5e-3, shift=0.0):
    return bd.connect(bd.Particles(scale * GRID + shift, scale * radius))


OTHERS = {
    "masses": ("density of the elements, 2000 and not 3000 kg/m³ .* density=", lambda: model_of(density=3000.0)),
    "masses by element": ("density", lambda: model_of(density=np.linspace(2000.0, 2100.0, 45))),
    "bonds": ("other bonds", lambda: model_of(lattice=bd.Lattice(LATTICE.particles, LATTICE.pairs[:-1]))),
    "bonds in another order": ("other bonds", lambda: model_of(
        lattice=bd.Lattice(LATTICE.particles, LATTICE.pairs[::-1]))),
    "formulation": ("formulation", lambda: model_of(law=RATES)),
    "scale": ("other elements: 1000 times", lambda: model_of(lattice=grid_of(1000.0))),
    "positions": ("other elements", lambda: model_of(lattice=grid_of(shift=1e-9))),
    "radii": ("other elements", lambda: model_of(lattice=bd.connect(bd.Particles(GRID, 0.49e-3), reach=1.1))),
    "fewer elements": ("other elements", lambda: model_of(lattice=bd.connect(bd.Particles(GRID[:-1], 0.5e-3)))),
    "period": ("another period", lambda: model_of(lattice=bd.Lattice(
        bd.Particles(GRID, 0.5e-3, period=(9e-3, 9e-3, 9e-3)), LATTICE.pairs))),
}  # fmt: skip


@pytest.mark.parametrize(("words", "make"), OTHERS.values(), ids=OTHERS)
@pytest.mark.parametrize("way", ["itself", "a copy", "from a file"])
def test_the_state_of_another_model_is_refused(tmp_path, moved, words, make, way):
    state = moved
    if way == "a copy":
        state = moved.copy()
    elif way == "from a file":
        go(MODEL, 1, out=tmp_path / "run.h5")
        state = bd.read_run(tmp_path / "run.h5").state
    with pytest.raises(InputError, match=f"state belongs to another .*{words}"):
        go(make(), 1, state=state)


def test_stored_forces_of_another_law_are_refused():
    state = go(model_of(bd.Fix(LEFT), PULL, law=RATES), 5).state
    with pytest.raises(InputError, match="bond law, whose forces it has stored"):
        go(model_of(bd.Fix(LEFT), PULL, law=replace(RATES, E=69e9)), 1, state=state)
    assert go(model_of(bd.Fix(LEFT), PULL, law=RATES), 1, state=state).steps == 1


def test_a_state_goes_on_in_models_of_the_same_bodies(tmp_path, moved):
    """Made anew, from a file, under other conditions, with other stiffness: the state is one of places and motion."""
    whole = go(MODEL, 60).state
    again = bd.Model(grid_of(), LAW, 2000.0, boundary=[bd.Fix(LEFT), PULL])
    go(MODEL, 40, out=tmp_path / "run.h5")
    kept = bd.read_run(tmp_path / "run.h5").state
    for model, state in ((MODEL, moved), (again, moved), (MODEL, moved.copy()), (MODEL, kept)):
        on = go(model, 20, state=state).state
        np.testing.assert_allclose(on.displacement, whole.displacement, rtol=1e-9, atol=1e-18)
        assert on.time == pytest.approx(60 * DT)
    free = go(MODEL.with_boundary([]), 1, state=moved)
    stiffer = go(model_of(bd.Fix(LEFT), PULL, law=replace(LAW, E=71e9)), 1, state=moved)
    assert free.state.model.boundary == ()
    total = sum(stiffer.history.energy[name][0] for name in ("normal", "shear", "bending", "twisting"))
    before = sum(free.history.energy[name][0] for name in ("normal", "shear", "bending", "twisting"))
    assert total == pytest.approx(71.0 / 70.0 * before, rel=1e-12)


def test_the_state_one_gives_stays_as_it_is(moved):
    before = moved.copy()
    end = go(MODEL, 30, state=moved).state
    assert end is not moved
    for name in bd.State.ARRAYS:
        np.testing.assert_array_equal(getattr(moved, name), getattr(before, name), err_msg=name)
    assert (moved.step, moved.time, moved.stale) == (before.step, before.time, before.stale)
    assert np.abs(end.displacement - moved.displacement).max() > 0.0
    # so that two futures of one past can be told apart by their loads alone
    np.testing.assert_array_equal(go(MODEL, 30, state=moved).state.pose, end.pose)


# ---- where prescribed motion begins


JUMPS = {
    "a constant": bd.Drive(RIGHT, x=1e-6),
    "a ramp from elsewhere": bd.Drive(RIGHT, x=bd.Ramp(1e-6, 2e-6, 1e-6)),
    "a ramp that began before": bd.Drive(RIGHT, x=bd.Ramp(0.0, 1e-6, 1e-6, begin=-5e-7)),
    "a jump at once": bd.Drive(RIGHT, x=bd.Table((0.0, 0.0), (0.0, 1e-6))),
    "a small one": bd.Drive(RIGHT, y=1e-15),
    "a turn": bd.Drive(RIGHT, rz=1e-3),
}


@pytest.mark.parametrize("drive", JUMPS.values(), ids=JUMPS)
def test_a_displacement_that_would_have_to_jump_is_refused(drive):
    with pytest.raises(InputError, match=r"is at 0 when the run begins .* cannot jump: .* as by bd.Ramp\(0, "):
        go(model_of(bd.Fix(LEFT), drive), 10)


def test_the_wall_that_would_have_to_jump_is_refused():
    wall = bd.PlaneWall((1.0, 0, 0), (-1, 0, 0), motion=bd.Driven(x=-1e-3))
    with pytest.raises(InputError, match=r"Driven\(x=\) begins at -0.001, but is at 0"):
        go(model_of(contact=bd.LinearContact(E=1e6), walls=[wall]), 10)


TIMES, VALUES = (0.0, 4 * DT, 4 * DT), (0.0, 0.0, 1e-6)
TABLE = bd.Table(TIMES, VALUES)


@pytest.mark.parametrize("options", [
    {"boundary": [bd.Fix(LEFT), bd.Drive(RIGHT, x=TABLE)]},
    {"walls": [bd.PlaneWall((1.0, 0, 0), (-1, 0, 0), motion=bd.Driven(x=TABLE))], "contact": bd.LinearContact(E=1e6)},
    {"walls": [bd.PlaneWall((1.0, 0, 0), (-1, 0, 0), motion=bd.Driven(angle=TABLE))],
     "contact": bd.LinearContact(E=1e6)},
], ids=["a drive", "a wall", "a turning wall"])  # fmt: skip
def test_a_displacement_that_jumps_later_is_refused(options):
    model = bd.Model(LATTICE, LAW, 2000.0, **options)
    with pytest.raises(InputError, match=r"jumps from 0 to 1e-06 at t = 2e-07 s.*cannot jump: give different times"):
        go(model, 10)


def test_jumps_of_velocities_and_of_equal_values_are_none():
    steady = bd.Table(TIMES, (0.0, 1e-6, 1e-6 + 1e-20))
    end = go(model_of(bd.Fix(LEFT), bd.Drive(RIGHT, x=steady, vy=TABLE)), 10).state
    moved = end.displacement[RIGHT.select(LATTICE)]
    np.testing.assert_allclose(moved[:, 0], 1e-6, rtol=1e-9)
    np.testing.assert_allclose(moved[:, 1], 6 * DT * 1e-6, rtol=0.1)


def test_static_and_explicit_mean_the_same_displacement():
    ramp = model_of(bd.Fix(LEFT), bd.Drive(RIGHT, x=bd.Ramp(0.0, 1e-6, 20 * DT)))
    end = RIGHT.select(LATTICE)
    still = bd.solve_static(ramp).displacement[end, 0]
    gone = go(ramp, 25).state.displacement[end, 0]
    np.testing.assert_allclose(still, 1e-6, rtol=1e-12)
    np.testing.assert_allclose(gone, still, rtol=1e-9)


def test_a_constant_displacement_holds_what_is_there():
    """From the static solution a run may go on under the very same constant Drive; so may one that ends a ramp."""
    model = model_of(bd.Fix(LEFT), bd.Drive(RIGHT, x=1e-6))
    static = bd.solve_static(model)
    state = model.state()
    state.set_pose(position=state.position + static.displacement)
    end = RIGHT.select(LATTICE)
    np.testing.assert_allclose(go(model, 20, state=state).state.displacement[end, 0], 1e-6, rtol=1e-9)

    pulled = go(model_of(bd.Fix(LEFT), bd.Drive(RIGHT, x=bd.Ramp(0.0, 1e-6, 20 * DT))), 30).state
    np.testing.assert_allclose(go(model, 20, state=pulled).state.displacement[end, 0], 1e-6, rtol=1e-9)
    with pytest.raises(InputError, match="is at 1e-06 when"):
        go(model_of(bd.Fix(LEFT), bd.Drive(RIGHT, x=0.0)), 5, state=pulled)


def test_a_turn_about_two_axes_goes_on_in_its_own_model():
    """The rotation vector is then not the schedules' values, and need not be."""
    ramp = bd.Ramp(0.0, 0.2, 40 * DT)
    model = model_of(bd.Fix(LEFT), bd.Drive(bd.Index([44]), rx=ramp, ry=bd.Ramp(0.0, 0.2, 20 * DT), rz=ramp))
    whole = go(model, 40).state
    on = go(model, 10, state=go(model, 30).state).state
    np.testing.assert_allclose(on.orientation, whole.orientation, rtol=1e-9, atol=1e-12)
    with pytest.raises(InputError, match=r"Drive\(r.=\) begins at .* give a velocity"):
        go(model_of(bd.Drive(bd.Index([44]), rx=ramp, ry=0.2, rz=ramp)), 10, state=whole)


# ---- time goes on


def test_a_ramp_of_a_second_stage_that_is_over_is_warned_of(moved):
    late = bd.Load(RIGHT, force=(50.0, 0, 0), schedule=bd.Ramp(1.0, 2.0, 1e-6))
    with pytest.warns(StageWarning, match=r"Ramp.* is over .*\(t = 2e-06 s\): its first value is 2, not 1; .*=2e"):
        go(model_of(bd.Fix(LEFT), late), 1, state=moved)
    half = bd.Load(RIGHT, force=(50.0, 0, 0), schedule=bd.Ramp(1.0, 2.0, 4e-6))
    with pytest.warns(StageWarning, match="is under way .* first value is 1.5, not 1"):
        go(model_of(bd.Fix(LEFT), half), 1, state=moved)


def test_schedules_that_go_on_or_begin_in_time_are_not_warned_of(moved):
    """Two stages with a ramp each are one run with both."""
    both = bd.Load(RIGHT, force=(50.0, 0, 0), schedule=bd.Table((0.0, 1e-6, 2e-6, 3e-6), (0.0, 1.0, 1.0, 2.0)))
    whole = go(model_of(bd.Fix(LEFT), both), 70).state
    second = bd.Load(RIGHT, force=(50.0, 0, 0), schedule=bd.Ramp(1.0, 2.0, 1e-6, begin=moved.time))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        go(MODEL, 1, state=moved)
        go(model_of(bd.Fix(LEFT), replace(PULL, force=(0, 50.0, 0))), 1, state=moved)
        on = go(model_of(bd.Fix(LEFT), second), 30, state=moved).state
    np.testing.assert_allclose(on.displacement, whole.displacement, rtol=1e-6, atol=1e-14)


# ---- walls and contacts


def test_walls_that_go_on_stay_where_they_are_and_new_ones_are_where_they_are_defined():
    ball = loose([[0.0, 0, 0]])
    law = bd.LinearContact(E=1e7, friction=0.3)
    floor = bd.PlaneWall((0, 0, -0.999), (0, 0, 1), motion=bd.Driven(vx=0.01))
    lid = bd.PlaneWall((0, 0, 1.5), (0, 0, -1), motion=bd.Driven(vz=-0.02))
    side = bd.PlaneWall((-3.0, 0, 0), (1, 0, 0))
    weight = bd.BodyForce((0, 0, -1.0))
    first = bd.Model(ball, None, 1000.0, boundary=weight, contact=law, walls=[floor, lid])
    state = bd.solve_explicit(first, duration=0.2, every=0).state
    assert len(state.wall_touching) == 1
    assert np.abs(state.wall_stretch).max() > 0.0
    walls = [side, lid, replace(floor, friction=0.3)]
    second = bd.Model(ball, None, 1000.0, boundary=weight, contact=law, walls=walls)
    begun = state.copy()
    begun.begin(second)
    np.testing.assert_array_equal(begun.wall_displacement[[1, 2]], state.wall_displacement[[1, 0]])
    np.testing.assert_array_equal(begun.wall_displacement[0], 0.0)
    np.testing.assert_array_equal(begun.wall_touching, [[0, 2]])
    np.testing.assert_array_equal(begun.wall_stretch, state.wall_stretch)
    whole = bd.solve_explicit(first, duration=0.3, every=0)
    on = bd.solve_explicit(second, duration=0.1, every=0, dt=whole.dt, state=state)
    np.testing.assert_allclose(on.state.position, whole.state.position, rtol=1e-4, atol=1e-7)


def test_a_state_without_contacts_forgets_them():
    apart = loose([[0.0, 0, 0], [1.99, 0, 0]])
    touching = bd.Model(apart, None, 1000.0, contact=bd.LinearContact(E=1e6, stress_free=False))
    state = bd.solve_explicit(touching, duration=1e-3, dt=1e-4, every=0).state
    assert len(state.contacts) == 1
    begun = state.copy()
    begun.begin(bd.Model(apart, None, 1000.0))
    assert len(begun.contacts) == 0
    assert begun.stretch.shape == (0, 9)


# ---- one shape of results


def test_every_solution_has_a_status_iterations_and_a_residual():
    held = model_of(bd.Fix(LEFT), bd.Load(RIGHT, force=(50.0, 5.0, 0)))
    found = {
        "linear": bd.solve_static(held),
        "nonlinear": bd.solve_static(held, nonlinear=True),
        "relaxed": bd.solve_relaxed(held, tolerance=1e-5),
        "modes": bd.solve_modes(held, count=3, prestress=False),
        "explicit": go(held, 100, every=10),
    }
    assert all(isinstance(result, bd.Solution) and result.status is bd.Status.COMPLETED for result in found.values())
    assert found["linear"].iterations == 1
    assert found["nonlinear"].iterations >= 1
    assert found["relaxed"].iterations > 10
    assert found["explicit"].iterations == found["explicit"].steps == 100
    assert 0.0 < found["linear"].residual < 1e-12
    assert 0.0 < found["nonlinear"].residual < 1e-9
    assert 1e-7 < found["relaxed"].residual <= 1e-5
    assert 0.0 < found["modes"].residual < 1e-9


def test_the_residual_of_a_run_falls_with_the_square_of_the_step():
    held = model_of(bd.Fix(LEFT), bd.Load(RIGHT, force=(50.0, 5.0, 0), schedule=bd.Ramp(0.0, 1.0, 4e-6)))
    coarse, fine = (bd.solve_explicit(held, duration=8e-6, dt=DT / k, every=4 * k) for k in (1, 2))
    assert coarse.residual / fine.residual == pytest.approx(4.0, rel=0.3)
    assert np.isnan(bd.solve_explicit(held, duration=1e-6, every=0).residual)


def test_iterations_of_conjugate_gradients_are_counted_and_a_guess_saves_some():
    random = np.random.default_rng(2)
    grid = np.stack(np.meshgrid(*[np.arange(12)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    position = 1e-3 * grid + 4e-5 * random.standard_normal(grid.shape)
    lattice = bd.connect(bd.Particles(position, 0.45e-3), reach=1.5)
    ends = bd.Face("x_min", depth=1.0), bd.Face("x_max", depth=1.0)
    model = model_of(bd.Fix(ends[0]), bd.Load(ends[1], force=(9.0, 0, 0)), lattice=lattice)
    cold = bd.solve_static(model)
    warm = bd.solve_static(model, guess=cold)
    assert cold.iterations > 5
    assert warm.iterations < cold.iterations / 2
    assert cold.residual < 1e-6
