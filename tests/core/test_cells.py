"""Bodies of cells by the core: the law and its gradient, walls, tractions and strains, and bits of a step."""

from functools import lru_cache

import numpy as np
import pytest

import bondem as bd
from bondem._cache_lines import lines
from bondem._tables.columns import HistoryColumn
from bondem.dynamics import core_loop
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.explicit import ExplicitResult, integrate
from bondem.dynamics.plan import Plan
from bondem.dynamics.timestep import critical_step
from bondem.interactions.cells.cell_tables import STRESS
from bondem.interactions.cells.cell_tangent import BodyTables
from bondem.model.state import State
from tests.bits import assert_same_bits
from tests.core.former_loop import FormerLoop, movement, with_former_law
from tests.specimens import crooked_cells

LAW = bd.CellBond(E=1e9, nu=0.3)
X_MIN, X_MAX, Z_MAX = bd.Face("x_min"), bd.Face("x_max"), bd.Face("z_max")
RAMP = bd.Ramp(0.0, 1.0, 0.01)
CONDITIONS = {
    "free": [],
    "held": [
        bd.Fix(X_MIN), bd.Drive(X_MAX, vx=bd.Ramp(0.0, 0.3, 0.01), y=bd.Ramp(0.0, 1e-3, 0.01)),
        bd.Pressure(Z_MAX, pressure=1e6, schedule=RAMP), bd.BodyForce((0.0, 0.0, -9.81)),
        bd.Eigenstrain(1e-3, schedule=RAMP),
    ],
}  # fmt: skip
#: A body of 2 x 1 x 1 m that no packing makes, so that its numbers can be compared with stored ones.
GRID = {"shape": (8, 4, 4), "edge": 0.25}
GAUGES = {"grip": bd.Gauge(X_MIN, "force", "sum"), "end": bd.Gauge(X_MAX, "displacement")}


@lru_cache
def body(count: int) -> bd.Lattice:
    return bd.connect(bd.pack(bd.Box(size=(2.0, 1.0, 1.0)), count=count, spread=0.3, seed=2), method="laguerre")


def model_of(conditions: str, lattice: bd.Lattice | None = None) -> bd.Model:
    return bd.Model(lattice or body(120), LAW, density=2500.0, boundary=CONDITIONS[conditions])


def run_of(model: bd.Model, steps: int, kind: type, **options) -> ExplicitResult:
    dt, rng, state = 0.5 * critical_step(model, bd.VelocityVerlet()), np.random.default_rng(7), State(model)
    state.set_motion(velocity=rng.uniform(-0.5, 0.5, (len(state.pose), 3)))
    plan = Plan(duration=steps * dt, dt=dt, gauges=GAUGES, imbalance=None, **options)
    return integrate(model, plan, state=state, loop_of=kind)


def displaced(model: bd.Model, size: float = 1e-3) -> State:
    rng, state = np.random.default_rng(3), State(model)
    state.pose[:, :3] += size * rng.standard_normal((len(state.pose), 3))
    state.pose[:, 5:] = 5.0 * size * rng.standard_normal((len(state.pose), 3))
    state.pose[:, 4] = np.sqrt(1.0 - (state.pose[:, 5:] ** 2).sum(axis=1))
    return state


# ---- against the former loop


@pytest.mark.parametrize("conditions", CONDITIONS)
def test_results_are_those_of_the_former_loop(conditions, monkeypatch):
    model = model_of(conditions, with_former_law(monkeypatch, crooked_cells(**GRID), CONDITIONS[conditions]))
    damping = None if conditions == "free" else bd.BondDamping(eta=0.01)
    result, former = run_of(model, 250, CoreLoop, every=50, damping=damping), FormerLoop("cells", conditions)
    names = ("reaction", "loss") if model.constraints.supported else ("reaction", "work", "loss")  # see decision 0068
    former.assert_close(1e-10, **movement(result.state), **{name: getattr(result.state, name) for name in names})
    # a force gauge has the force on its face only, no longer that on all facets of its cells
    columns = HistoryColumn.COUNT if conditions == "held" else None
    former.assert_records(1e-10, result.history.records[:, :columns], alike=slice(1, 9))


# ---- bits


def test_threads_and_pauses_change_no_bit(monkeypatch):
    model, results = model_of("held", body(450)), []
    assert len(model.layout.i) > 2000
    for count, every in ((1, 50), (2, 50), (3, 7), (4, 0)):
        monkeypatch.setattr(core_loop, "current_threads", lambda count=count: count)
        results.append(run_of(model, 150, CoreLoop, every=every))
    for other in results[1:]:
        assert_same_bits(results[0], other)
    np.testing.assert_array_equal(results[0].history.records, results[1].history.records)


# ---- physics


def energy_at(tables: BodyTables, state: State, pose: np.ndarray) -> float:
    return tables.energies(pose, state.rest).total


def test_forces_are_the_gradient_of_the_energy():
    model = model_of("held")
    state, h = displaced(model), 1e-6
    tables = BodyTables.of(model.interaction, model.interaction.constants, state.integrity)
    sums = lines(len(state.pose))
    tables.load(state.pose, state.rest, sums)
    held = int(tables.walls.cell[0])
    for cell in (held, (held + 5) % len(state.pose)):
        for axis in range(3):
            ends = []
            for sign in (1.0, -1.0):
                pose = state.pose.copy()
                pose[cell, axis] += sign * h
                ends.append(energy_at(tables, state, pose))
            slope = (ends[0] - ends[1]) / (2.0 * h)
            assert sums[cell, axis] == pytest.approx(-slope, rel=1e-6, abs=1e-7 * np.abs(sums[:, :3]).max())
            for place, sign in ((0, 1.0), (1, -1.0)):
                pose, (w, x, y, z) = state.pose.copy(), state.pose[cell, 4:]
                turned = [(-x, w, -z, y), (-y, z, w, -x), (-z, -y, x, w)][axis]  # e q of a unit vector e
                pose[cell, 4:] += sign * 0.5 * h * np.array(turned)
                ends[place] = energy_at(tables, state, pose)
            slope = (ends[0] - ends[1]) / (2.0 * h)
            assert sums[cell, 4 + axis] == pytest.approx(-slope, rel=1e-5, abs=1e-6 * np.abs(sums[:, 4:]).max())


def test_rigid_motion_has_no_energy_and_forces_balance():
    model = model_of("free")
    state, far = displaced(model), State(model)
    tables = BodyTables.of(model.interaction, model.interaction.constants, state.integrity)
    sums = lines(len(state.pose))
    tables.load(state.pose, state.rest, sums)
    moment = sums[:, 4:7] + np.cross(state.pose[:, :3], sums[:, :3])
    np.testing.assert_allclose(sums[:, :3].sum(axis=0), 0.0, atol=1e-11 * np.abs(sums[:, :3]).sum())
    np.testing.assert_allclose(moment.sum(axis=0), 0.0, atol=1e-11 * np.abs(moment).sum())
    half, axis = 0.7, np.array([0.48, 0.6, 0.64])
    u = np.cross(np.broadcast_to(axis, (len(far.pose), 3)), far.pose[:, :3])
    far.pose[:, :3] += np.sin(2 * half) * u + (1.0 - np.cos(2 * half)) * np.cross(axis, u) + (3.0, 1.0, -2.0)
    far.pose[:, 4:] = [np.cos(half), *(np.sin(half) * axis)]
    assert energy_at(tables, far, far.pose) < 1e-18 * energy_at(tables, state, state.pose)


def test_dilatation_is_exact_under_uniform_strain_and_cells_have_the_stress_of_the_law():
    model = model_of("free", body(450))
    state, strain = State(model), 1e-6 * np.array([[2.0, 0.5, 0.3], [0.5, -1.0, 0.2], [0.3, 0.2, 0.7]])
    rest = model.lattice.particles.position[model.layout.order]  # the centres at which the tessellation is exact
    state.pose[:, :3] += rest @ strain
    tables, sums = BodyTables.of(model.interaction, model.interaction.constants, state.integrity), lines(len(rest))
    tables.load(state.pose, state.rest, sums)
    cells = model.lattice.cells
    assert cells is not None
    wall = np.zeros(len(rest), dtype=bool)
    wall[cells.free.cell] = True
    beside = wall.copy()
    for one, other in ((0, 1), (1, 0)):
        beside[model.lattice.pairs[wall[model.lattice.pairs[:, other]], one]] = True
    inside = ~beside[model.layout.order]
    assert inside.sum() > 20
    np.testing.assert_allclose(state.pose[inside, STRESS], LAW.lame * np.trace(strain), rtol=1e-6)


def test_a_bar_stretched_by_walls_has_the_modulus_and_takes_the_work():
    length = bd.Ramp(0.0, 2e-4, 0.05)
    model = bd.Model(body(120), LAW, density=2500.0, boundary=[
        bd.Fix(X_MIN, translation="x", rotation=""), bd.Drive(X_MAX, x=length),
    ])  # fmt: skip
    run = bd.solve_explicit(model, duration=0.1, every=50, damping=bd.LocalDamping(0.3), gauges=GAUGES)
    assert abs(run.history["grip"][-1, 0]) == pytest.approx(LAW.E * 1e-4, rel=0.02)
    assert run.history.records[-1, 3:7].sum() == pytest.approx(0.5 * LAW.E * 1e-8 * 2.0, rel=0.03)


def test_facets_turned_too_far_are_counted_but_not_for_a_twist_that_they_do_not_resist():
    model = model_of("free")
    state, dt = State(model), 1e-7
    loop = CoreLoop(model, Plan(duration=dt, dt=dt, every=0), state, dt)
    of_first = (model.layout.i == 0) | (model.layout.j == 0)
    state.pose[0, 4:] = [np.cos(0.6), 0.0, 0.0, np.sin(0.6)]
    _, wide, lost, _ = loop.run(1)
    assert 1 < wide <= of_first.sum()
    assert lost == 0
    state.pose[0, 4:] = [np.cos(1.3), 0.0, 0.0, np.sin(1.3)]
    assert loop.run(1)[2] > 0
