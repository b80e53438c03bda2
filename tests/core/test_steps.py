"""Steps by the core: lists of passes, the physics of beams, and bits that depend on no thread and no pause."""

import numpy as np
import pytest

import bondem as bd
from bondem._core_steps import Composer
from bondem._passes import StepEntry, steps
from bondem._tables.step_tables import Moving, Rows
from bondem.dynamics import core_loop
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.explicit import integrate
from bondem.dynamics.parts.shared_tables import new_ledger
from bondem.dynamics.plan import Plan
from bondem.dynamics.timestep import critical_step
from bondem.errors import InputError
from bondem.model.state import State
from tests.bits import assert_same_bits

LAWS = {
    "Timoshenko": bd.Timoshenko(E=1e7, nu=0.2, radius_ratio=0.6),
    "Euler–Bernoulli": bd.EulerBernoulli(E=1e7, nu=0.2, radius=0.2),
    "parallel": bd.ParallelBond(E=1e7, nu=0.2, radius_ratio=0.6, radius_rule="pair_min"),
}
X_MIN, X_MAX = bd.Face("x_min", depth=0.5), bd.Face("x_max", depth=0.5)
HELD = [
    bd.Fix(X_MIN),
    bd.Drive(bd.Face("z_max", depth=0.5) - X_MIN - X_MAX, vy=bd.Ramp(0.0, 0.4, 0.05), rx=bd.Ramp(0.0, 0.1, 0.03)),
    bd.Load(X_MAX, force=(3e4, -1e4, 2e4), schedule=bd.Ramp(0.0, 1.0, 0.02)),
]
GAUGES = {"end": bd.Gauge(X_MAX, "displacement"), "grip": bd.Gauge(X_MIN, "force", "sum")}


def crooked(shape: tuple[int, int, int]) -> bd.Lattice:
    rng = np.random.default_rng(1)
    grid = np.indices(shape).reshape(3, -1).T.astype(float)
    radius = rng.uniform(0.3, 0.4, len(grid))
    return bd.connect(bd.Particles(grid + rng.uniform(-0.1, 0.1, grid.shape), radius), reach=2.0)


def moving_state(model: bd.Model) -> State:
    rng, state = np.random.default_rng(7), State(model)
    state.set_motion(velocity=rng.uniform(-0.5, 0.5, (len(state.pose), 3)))
    return state


def loop_of(model: bd.Model, plan: Plan, state: State) -> CoreLoop:
    assert plan.dt is not None
    return CoreLoop(model, plan, state, plan.dt)


def plan_of(model: bd.Model, steps: int, **options) -> Plan:
    dt = 0.5 * critical_step(model, bd.VelocityVerlet())
    return Plan(duration=steps * dt, dt=dt, gauges=GAUGES, **options)


# ---- bits


def test_threads_and_pauses_change_no_bit(monkeypatch):
    model = bd.Model(crooked((12, 10, 10)), LAWS["Timoshenko"], density=1e3, boundary=HELD)
    results = []
    for count, every in ((1, 50), (2, 50), (3, 7), (4, 0)):
        monkeypatch.setattr(core_loop, "current_threads", lambda count=count: count)
        plan = plan_of(model, 150, every=every, damping=bd.BondDamping(eta=0.1))
        results.append(integrate(model, plan, state=moving_state(model), loop_of=CoreLoop))
    for other in results[1:]:
        assert_same_bits(results[0], other)
    np.testing.assert_array_equal(results[0].history.records, results[1].history.records)


# ---- physics


@pytest.mark.parametrize("law", LAWS)
def test_forces_are_the_gradient_of_the_energy(law):
    lattice = bd.connect(bd.Particles(np.array([[0.0, 0.0, 0.0], [0.9, 0.2, 0.1]]), np.array([0.4, 0.5])), reach=2.0)
    model = bd.Model(lattice, LAWS[law], density=1e3)
    rng, h = np.random.default_rng(3), 1e-6
    shift, turn = 0.05 * rng.standard_normal((2, 3)), 0.2 * rng.standard_normal((2, 3))

    def looked_at(shift: np.ndarray, turn: np.ndarray) -> tuple[State, float]:
        state, angle = State(model), np.linalg.norm(turn, axis=1)[:, None]
        state.pose[:, :3] += shift
        state.pose[:, 4:] = np.hstack([np.cos(angle / 2), np.sin(angle / 2) * turn / angle])
        plan = plan_of(model, 1)
        loop = loop_of(model, plan, state)
        return state, float(loop.record_present()[0, 3:7].sum())

    state, _ = looked_at(shift, turn)
    force = state.acceleration[:, :3] / state.motion[:, 3:4]
    for element in range(2):
        for axis in range(3):
            step = np.zeros((2, 3))
            step[element, axis] = h
            slope = (looked_at(shift + step, turn)[1] - looked_at(shift - step, turn)[1]) / (2 * h)
            assert force[element, axis] == pytest.approx(-slope, rel=1e-6, abs=1e-6 * np.abs(force).max())
    torque = state.acceleration[:, 3:] / state.motion[:, 7:]
    arm = np.diff(state.pose[:, :3], axis=0)[0]
    np.testing.assert_allclose(force.sum(axis=0), 0.0, atol=1e-9 * np.abs(force).max())
    np.testing.assert_allclose(torque.sum(axis=0) + np.cross(arm, force[1]), 0.0, atol=1e-9 * np.abs(torque).max())


@pytest.mark.parametrize("angle", [1e-9, 1e-4, 0.1, 0.199, 0.399, 0.401, 0.5, 1.0, 3.0, 20.0])
def test_an_element_turns_by_the_exponential_map(angle):
    lattice = bd.connect(bd.Particles(np.array([[0.0, 0.0, 0.0], [0.9, 0.0, 0.0]]), np.full(2, 0.4)), reach=2.0)
    model = bd.Model(lattice, bd.Timoshenko(E=1e-6, nu=0.2, radius=0.01), density=1e3)
    state, axis, dt = State(model), np.array([0.48, 0.6, 0.64]), 1e-3
    start = np.array([0.3, -0.5, 0.1, 0.8062257748298549])
    state.set_pose(orientation=np.tile(start, (2, 1)))
    state.set_motion(angular_velocity=np.tile(angle / dt * axis, (2, 1)))
    loop = CoreLoop(model, Plan(duration=dt, dt=dt, every=0), state, dt)
    loop.run(1)
    w, v = np.cos(angle / 2), np.sin(angle / 2) * axis
    expected = np.append(w * start[0] - v @ start[1:], w * start[1:] + start[0] * v + np.cross(v, start[1:]))
    np.testing.assert_allclose(state.pose[:, 4:], [expected, expected], rtol=0, atol=2e-14 * max(1.0, angle))
    np.testing.assert_allclose(np.linalg.norm(state.pose[:, 4:], axis=1), 1.0, rtol=0, atol=1e-15)


def test_a_number_that_is_not_finite_ends_the_run():
    model = bd.Model(crooked((3, 2, 2)), LAWS["Timoshenko"], density=1e3)
    state, plan = State(model), plan_of(model, 300)
    state.motion[3, 1] = np.nan
    records, _, lost, sick = loop_of(model, plan, state).run(300)
    assert (state.step, len(records), sick) == (100, 0, 1) or lost > 0


# ---- lists of passes


def moving_table() -> Moving:
    state = State(bd.Model(crooked((2, 2, 2)), LAWS["Timoshenko"], density=1e3))
    return Moving(state.pose, state.motion, state.acceleration, state.loss, state.rest)


def test_a_pass_of_other_tables_is_refused():
    table, rows = moving_table(), Rows(*[np.zeros(0)] * len(Rows._fields))
    with pytest.raises(ImportError, match="Rows stands for Moving"):
        Composer()([StepEntry("open_elements", (rows,))])
    with pytest.raises(ImportError, match="Moving stands for Rows"):  # a table that is known by its own name
        Composer()([steps.open_elements(table), StepEntry("clear_row_forces", (table,))])
    with pytest.raises(KeyError, match="open_nothing"):
        Composer()([StepEntry("open_nothing", (table,))])


def test_arrays_that_do_not_fit_a_list_are_refused():
    table = moving_table()
    with pytest.raises(InputError, match=r"Moving.pose = array of float32"):
        Composer()([steps.open_elements(table._replace(pose=table.pose.astype(np.float32)))])
    with pytest.raises(InputError, match=r"Moving.motion = array of shape \(7, 8\): an axis has to be 8 long"):
        Composer()([steps.open_elements(table._replace(motion=table.motion[:7]))])
    composer = Composer()
    two = composer([steps.open_elements(table), steps.sum_element_energies(table, new_ledger())])
    assert two.shape == (2, 8)
    assert composer([]).shape == (0, 8)


def test_a_table_is_filled_once():
    table = moving_table()
    entries = Composer()([steps.open_elements(table)] * 2)
    np.testing.assert_array_equal(entries[0], entries[1])
