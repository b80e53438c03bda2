"""States as users read and change them: setters that broadcast, read-only arrays, the user's order everywhere."""

import copy

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from tests import specimens

LAW = bd.EulerBernoulli(E=1e9, nu=0.25, radius_ratio=0.7)
SETTABLE = ("position", "displacement", "orientation", "velocity", "angular_velocity", "bond_eigenstrain")


def spheres() -> bd.Model:
    """Spheres whose order in the kernels is another than the user's."""
    lattice = specimens.spheres(bd.Box((3.0, 2.0, 2.0)), 120, spread=0.2, seed=3, reach=1.1)
    model = bd.Model(lattice, LAW, 1000.0)
    assert (model.layout.order != np.arange(120)).any()
    return model


@pytest.mark.parametrize("name", ["velocity", "angular_velocity", "displacement"])
def test_one_vector_is_given_to_all_elements(name):
    state = spheres().state()
    setattr(state, name, (0, 0, -5.0))
    assert getattr(state, name) == pytest.approx(np.tile([0.0, 0.0, -5.0], (120, 1)))
    assert state.stale
    setattr(state, name, 0.0)
    assert not getattr(state, name).any()


@pytest.mark.parametrize("name", SETTABLE)
def test_what_is_set_is_what_is_read_in_the_order_of_the_user(name):
    state = spheres().state()
    rng = np.random.default_rng(1)
    given = 1e-3 * rng.standard_normal(getattr(state, name).shape)
    if name == "orientation":
        given /= np.linalg.norm(given, axis=1, keepdims=True)
    setattr(state, name, given)
    assert getattr(state, name) == pytest.approx(given, abs=1e-15)


def test_every_array_of_a_state_is_read_only():
    """Assignment to a part of it would change a copy, without effect on the run."""
    model = spheres()
    state = bd.solve_explicit(model, duration=1e-3).state
    names = [name for name in dir(state) if isinstance(getattr(state, name), np.ndarray)]
    assert {*SETTABLE, "bond_integrity", "contacts", "slipped", "stress_free_strain"} <= {*names}
    for name in names:
        assert not getattr(state, name).flags.writeable, name
    with pytest.raises(ValueError, match="read-only"):
        state.velocity[:] = 1.0
    with pytest.raises(ValueError, match="read-only"):
        state.position[0] += 1.0


def test_arrays_in_the_order_of_the_kernels_are_not_listed():
    assert not {*bd.State.ARRAYS, "rest", "layout"} & {*dir(spheres().state())}


def test_dir_of_a_model_lists_no_table_of_the_solvers():
    model = spheres()
    names = {name for name in dir(model) if not name.startswith("_")}
    own = {"lattice", "bond", "density", "boundary", "contact", "walls", "failure", "mass_matrix"}
    assert own < names
    assert names - own == {
        "contact_radius", "formulation", "implied_fracture", "inertia", "mass", "plot", "state", "stiffness",
        "with_boundary",
    }  # fmt: skip
    assert model.layout is not None  # it is there, for the solvers



@pytest.mark.parametrize(
    ("name", "value", "words"),
    [
        ("velocity", (1.0, 2.0), r"give finite numbers of shape \(3,\) for all elements, or \(120, 3\)"),
        ("velocity", (np.nan, 0.0, 0.0), "not finite"),
        ("velocity", "fast", "holds no numbers"),
        ("position", (0.0, 0.0, 1.0), r"give finite numbers of shape \(120, 3\)"),
        ("orientation", (1.0, 1.0, 0.0, 0.0), "not unit quaternions"),
        ("bond_eigenstrain", -1.0, "above -1"),
        ("bond_integrity", 0.0, "cannot be set"),
        ("veloctiy", (0.0, 0.0, 1.0), "did you mean 'velocity'"),
        ("eigenstrain", 1e-3, "set a property"),
        ("time", np.nan, "time = nan s; give a finite time"),
        ("time", "later", "time = 'later'; give a finite time"),
    ],
)
def test_what_cannot_be_set_is_refused_in_one_line(name, value, words):
    state = spheres().state()
    with pytest.raises(InputError, match=words) as caught:
        setattr(state, name, value)
    assert "\n" not in str(caught.value)


def test_a_velocity_that_was_set_is_the_one_of_the_run():
    model = spheres()
    state = model.state()
    state.velocity = (0.0, 0.0, -5.0)
    moved = bd.solve_explicit(model, duration=2e-3, state=state).state
    assert moved.displacement.mean(axis=0) == pytest.approx([0.0, 0.0, -1e-2], rel=0.1, abs=1e-9)


def test_a_time_against_which_steps_are_lost_is_refused():
    model = spheres()
    state = model.state()
    state.time = np.float64(1e6)
    run = bd.solve_explicit(model, state=state, duration=5e-6, dt=1e-6, every=1)
    assert run.history.time == pytest.approx(1e6 + 1e-6 * np.arange(6), abs=1e-9)
    state.time = 1e12
    with pytest.raises(InputError, match=r"state: time = 1e\+12 s: steps of 1e-06 s are lost .* an earlier time"):
        bd.solve_explicit(model, state=state, duration=5e-6, dt=1e-6)


def test_stress_free_strains_are_in_the_order_of_the_user():
    """That of an `Eigenstrain` on a part of the bonds adds to that of the state."""
    particles, pairs = spheres().lattice.particles, spheres().lattice.pairs
    part = bd.Eigenstrain(1e-3, bd.Index(range(40)))
    model = bd.Model(bd.Lattice(particles, pairs), LAW, 1000.0, boundary=[part])
    state = model.state()
    own = np.linspace(0.0, 1e-3, len(pairs))
    state.bond_eigenstrain = own
    wanted = own + 1e-3 * (pairs < 40).mean(axis=1)
    assert state.stress_free_strain == pytest.approx(wanted, abs=1e-15)


def test_a_copy_by_the_module_copy_is_independent():
    """`copy.copy` shared the arrays, so that setting the copy set the original too."""
    state = spheres().state()
    state.velocity = (0.0, 0.0, 1.0)
    twin = copy.copy(state)
    twin.velocity = 0.0
    assert (state.velocity[:, 2] == 1.0).all()
