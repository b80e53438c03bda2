"""Steps by the core of bonds that store something: beams of the incremental formulation, and the non-local law."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem._tables.columns import EventColumn
from bondem.dynamics import core_loop
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.explicit import integrate
from bondem.dynamics.plan import Plan
from bondem.interactions.non_local.non_local_interaction import NON_LOCAL_WORK
from bondem.model.state import State
from tests.bits import EnoughError, assert_same_bits
from tests.core.former_loop import FormerLoop, movement
from tests.core.lagged_cases import (
    CASES,
    PULLED,
    SHEARED,
    WEAK,
    non_local_cells,
    non_local_spheres,
    plan_and_state,
    stored,
    touching_spheres,
)
from tests.core.test_steps import HELD, LAWS, crooked

STORED = replace(LAWS["Timoshenko"], formulation="incremental")
LAGGED = bd.NonLocal(E=1e7, nu=0.1, areas="weighted")


# ---- numbers of the former loop


@pytest.mark.parametrize("case", ["stored, Timoshenko", "non-local, cells that break"])
def test_numbers_are_those_of_the_former_loop(case):
    make, damping = CASES[case]
    model, former = make(), FormerLoop("lagged_steps", case)
    plan, state = plan_and_state(model, damping)
    result = integrate(model, plan, state=state, loop_of=CoreLoop)
    former.assert_same(integrity=result.state.integrity)
    assert (len(result.events) > 50) == ("break" in case)
    found = {name: getattr(result.state, name) for name in ("history", "stress", "work", "released")}
    broken = result.state.broken[:, :EventColumn.OPENING_STEPS]  # which the former loop did not have
    former.assert_close(1e-10, **movement(result.state), **found, broken=broken)
    former.assert_records(1e-10, result.history.records, alike=slice(0))


# ---- bits


OPTIONS = {
    "stored": (STORED, {}),
    "non-local": (LAGGED, {}),
    "breaking": (LAGGED, {"failure": PULLED}),
    "touching": (LAGGED, {
        "contact": bd.LinearContact(E=1e7, friction=0.4, damping=0.1),
        "walls": [bd.PlaneWall((0, 0, -0.35), (0, 0, 1)), bd.PlaneWall((0, -0.35, 0), (0, 1, 0))],
    }),
}  # fmt: skip


@pytest.mark.parametrize("name", OPTIONS)
def test_threads_and_pauses_change_no_bit(name, monkeypatch):
    law, options = OPTIONS[name]
    model = bd.Model(crooked((12, 10, 10)), law, density=1e3, boundary=HELD, **options)
    results = []
    for count, every in ((1, 25), (2, 25), (3, 7), (4, 0)):
        monkeypatch.setattr(core_loop, "current_threads", lambda count=count: count)
        plan, state = plan_and_state(model, bd.BondDamping(eta=0.1), steps=75, every=every)
        results.append(integrate(model, plan, state=state, loop_of=CoreLoop))
    assert (len(results[0].events) > 10) == (name == "breaking")
    assert (len(results[0].state.wall_touching) > 10) == (name == "touching")
    for other in results[1:]:
        assert_same_bits(results[0], other)
    np.testing.assert_array_equal(results[0].history.records, results[1].history.records)


@pytest.mark.parametrize("threads", [1, 3])
def test_bonds_that_cannot_fail_move_as_those_that_do_not(threads, monkeypatch):
    """To the bit: forces that are added up at once, and forces that wait for the stresses of all elements."""
    monkeypatch.setattr(core_loop, "current_threads", lambda: threads)
    monkeypatch.setattr(core_loop, "BLOCK", 200)
    results = []
    for failure in (None, bd.MohrCoulomb(tension=1e15, cohesion=1e15, friction_angle=0.6)):
        model = bd.Model(crooked((12, 10, 10)), LAGGED, density=1e3, boundary=HELD, failure=failure)
        plan, state = plan_and_state(model, bd.BondDamping(eta=0.1), steps=75, every=25)
        results.append(integrate(model, plan, state=state, loop_of=CoreLoop))
    lasting, whole = results
    assert len(whole.events) == 0
    assert np.abs(whole.state.stress).max() > 0.0
    for array in ("history", "stress", "acceleration", "pose", "motion"):
        np.testing.assert_array_equal(getattr(lasting.state, array), getattr(whole.state, array), err_msg=array)


def pair(law) -> bd.Model:
    """Two elements and a bond, fewer than a group of lanes."""
    lattice = bd.connect(bd.Particles(np.array([[0.0, 0.0, 0.0], [0.9, 0.2, 0.1]]), np.array([0.4, 0.5])), reach=2.0)
    return bd.Model(lattice, law, density=1e3)


MODELS = {
    "stored": lambda: stored("Timoshenko"),
    "stored, one bond": lambda: pair(STORED),
    "cells": non_local_cells,
    "spheres": non_local_spheres,
    "spheres, one bond": lambda: pair(LAGGED),
}


@pytest.mark.parametrize("name", MODELS)
def test_forces_of_an_unchanged_state_are_found_again(name):
    """To the bit: force, moment, gap, extra force and stress are what they were."""
    model = MODELS[name]()
    plan, state = plan_and_state(model, None, steps=5, share=0.05)  # a single bond of this law is unstable
    state = integrate(model, plan, state=state, loop_of=CoreLoop).state
    assert np.abs(state.history).max() > 0.0
    again = state.copy()
    again.stale = True
    assert plan.dt is not None
    CoreLoop(model, plan, again, plan.dt).record_present()
    for array in ("history", "stress", "acceleration", "reaction", "pose", "motion"):
        np.testing.assert_array_equal(getattr(again, array), getattr(state, array), err_msg=array)


@pytest.mark.parametrize("name", ["stored", "stored, one bond", "cells", "spheres"])
@pytest.mark.filterwarnings("ignore::bondem.errors.StepWarning")
@pytest.mark.filterwarnings("ignore::bondem.errors.NotQuasistaticWarning")
def test_a_run_resumed_has_the_bits_of_a_whole_one(name, tmp_path: Path):
    model = MODELS[name]()
    plan, start = plan_and_state(model, None, steps=200, share=0.05)

    def run(**options) -> bd.ExplicitResult:
        return bd.solve_explicit(
            model, duration=plan.duration, dt=plan.dt, every=10, damping=bd.LocalDamping(0.1), save_every=50,
            state=start.copy(), **options,
        )  # fmt: skip

    whole = run(out=tmp_path / "whole")

    def stop(done: float) -> None:
        if done > 0.6:
            raise EnoughError

    with pytest.raises(EnoughError):
        run(out=tmp_path / "cut", progress=stop)
    assert 0 < bd.read_run(tmp_path / "cut").state.step < 200
    assert_same_bits(whole, bd.resume(tmp_path / "cut"))


# ---- physics


def moved(law, steps: int = 40) -> State:
    """A free lattice in motion, and where it has got to."""
    model = bd.Model(crooked((4, 3, 3)), law, density=1e3)
    plan, state = plan_and_state(model, None, steps=steps, every=0)
    return integrate(model, plan, state=state, loop_of=CoreLoop).state


@pytest.mark.parametrize("law", [STORED, LAGGED], ids=["stored", "non-local"])
def test_forces_have_no_resultant_and_no_moment(law):
    state = moved(law)
    force = state.acceleration[:, :3] / state.motion[:, 3:4]
    torque = state.acceleration[:, 3:] / state.motion[:, 7:8]
    assert np.abs(force).max() > 1.0
    np.testing.assert_allclose(force.sum(axis=0), 0.0, atol=1e-10 * np.abs(force).max())
    about = np.cross(state.pose[:, :3], force) + torque
    np.testing.assert_allclose(about.sum(axis=0), 0.0, atol=1e-10 * np.abs(about).max())


def test_stored_loads_of_a_driven_beam():
    """Stretch and twist at constant rates: F = kn v t, M = kt ω t, and half of their work is stored in each mode."""
    law = bd.ParallelBond(E=1e7, nu=0.2, radius=0.3, formulation="incremental")
    lattice = bd.connect(bd.Particles(np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]), np.full(2, 0.5)), reach=1.1)
    drive = bd.Drive(bd.Index([1]), vx=1e-3, wx=2e-3)
    model = bd.Model(lattice, law, density=1e3, boundary=[bd.Fix(bd.Index([0])), drive])
    dt, steps = 1e-4, 100
    done = integrate(model, Plan(duration=steps * dt, dt=dt, every=steps), loop_of=CoreLoop)
    kn, kt, t = float(model.stiffness.kn[0]), float(model.stiffness.kt[0]), steps * dt
    expected = [kn * 1e-3 * t, 0.0, 0.0, kt * 2e-3 * t, 0.0, 0.0]
    np.testing.assert_allclose(done.state.history[:, 0], expected, rtol=1e-12, atol=1e-9)
    ledger = done.history.energy
    assert ledger["normal"][-1] == pytest.approx(0.5 * kn * (1e-3 * t) ** 2, rel=1e-12)
    assert ledger["twisting"][-1] == pytest.approx(0.5 * kt * (2e-3 * t) ** 2, rel=1e-12)
    assert abs(ledger["shear"][-1]) + abs(ledger["bending"][-1]) < 1e-12 * ledger["normal"][-1]


def test_a_stored_force_turns_with_its_bond():
    """A pair that turns by 60 degrees, stretched so far that its force holds it on its circle."""
    law = bd.ParallelBond(E=1e6, nu=0.2, radius=0.3, formulation="incremental")
    lattice = bd.connect(bd.Particles(np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]), np.full(2, 0.5)), reach=1.1)
    model = bd.Model(lattice, law, density=1e3)
    state, spin, dt, kn = State(model), 5.0, 1e-4, float(model.stiffness.kn[0])
    pull = 0.5 * model.mass[0] * spin**2  # m ω² L / 2 = kn (L - 1)
    stretch = pull / (kn - pull)
    state.pose[:, 0] += [-0.5 * stretch, 0.5 * stretch]
    state.history[0, 0] = kn * stretch
    velocity = 0.5 * spin * (1.0 + stretch) * np.array([[0.0, -1.0, 0.0], [0.0, 1.0, 0.0]])
    state.set_motion(velocity=velocity, angular_velocity=np.tile([0.0, 0.0, spin], (2, 1)))
    steps = round(np.pi / 3.0 / spin / dt)
    state = integrate(model, Plan(duration=steps * dt, dt=dt, every=0), state=state, loop_of=CoreLoop).state
    angle = spin * steps * dt
    expected = [np.cos(angle), np.sin(angle), 0.0, 0.0, 0.0, 0.0]
    np.testing.assert_allclose(state.history[:, 0] / (kn * stretch), expected, rtol=0, atol=1e-5)


def test_extra_forces_have_an_entry_of_their_own():
    """Springs, motion, work and extra forces: their sum closes to second order in the step."""
    missed = []
    for share in (1.0, 0.5):
        model = non_local_spheres()
        plan, state = plan_and_state(model, None, every=10)
        assert plan.dt is not None
        plan = replace(plan, dt=0.1 * share * plan.dt, duration=0.1 * plan.dt * 100)
        done = integrate(model, plan, state=state, loop_of=CoreLoop)
        ledger = done.history.energy
        assert ledger["non-local work"][-1] == pytest.approx(done.state.history[NON_LOCAL_WORK].sum(), rel=1e-12)
        assert np.abs(ledger["non-local work"]).max() > 20.0 * np.abs(ledger["balance"]).max()
        missed.append(np.abs(ledger["balance"]).max())
    assert missed[1] < 0.6 * missed[0]


def test_bonds_break_by_the_mean_stress_of_their_elements():
    """Their indices are those of its eigenvalues, and none above 1 is left."""
    model = non_local_cells(SHEARED)
    plan, state = plan_and_state(model, bd.BondDamping(eta=0.1))
    done = integrate(model, plan, state=state, loop_of=CoreLoop)
    w, x, y, z = done.state.pose[:, 4:].T
    turned = np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]).transpose(2, 0, 1)  # fmt: skip
    own = done.state.stress[:, [0, 3, 4, 3, 1, 5, 4, 5, 2]].reshape(-1, 3, 3)
    stress = np.empty_like(own)
    stress[model.layout.order] = turned @ own @ turned.transpose(0, 2, 1)
    principal = np.linalg.eigvalsh(0.5 * (stress[model.lattice.pairs[:, 0]] + stress[model.lattice.pairs[:, 1]]))
    low, high, angle, c = principal[:, 0], principal[:, 2], SHEARED.friction_angle, SHEARED.cohesion
    sheared = (0.5 * (high - low) + 0.5 * (high + low) * np.sin(angle)) / (c * np.cos(angle))
    index, broken = bd.failure_index(model, done.state), np.zeros(len(principal), dtype=bool)
    broken[done.events.bond] = True
    assert broken.sum() > 100
    assert index[broken].max() == 0.0
    assert 0.9 < index.max() < 1.0
    expected = np.maximum(sheared, high / SHEARED.tension)
    np.testing.assert_allclose(index[~broken], expected[~broken], rtol=0, atol=1e-12)


def test_contacts_count_in_the_stress_of_an_element():
    """A loose sphere that touches one other has σ = sym l⊗F / V, with F that accelerates it."""
    model = touching_spheres()
    plan, state = plan_and_state(model, None, every=0, steps=120)
    state = integrate(model, plan, state=state, loop_of=CoreLoop).state
    order, radius = model.layout.order, model.lattice.particles.radius
    touching, weight, found = state.touching, np.array([5.0, 0.0, -100.0]), 0
    for p in np.flatnonzero(order >= 48):
        pairs = touching[(touching == p).any(axis=1)]
        if len(pairs) != 1 or p in state.wall_touching[:, 0]:
            continue
        q = pairs[0].sum() - p
        own, other = radius[order[[p, q]]]
        lever = own / (own + other) * (state.pose[q, :3] - state.pose[p, :3])
        force = (state.acceleration[p, :3] - weight) / state.motion[p, 3]
        dyad = np.outer(lever, force) / (4.0 / 3.0 * np.pi * own**3)
        stress = state.stress[p, [0, 3, 4, 3, 1, 5, 4, 5, 2]].reshape(3, 3)
        expected = np.linalg.eigvalsh(0.5 * (dyad + dyad.T))
        np.testing.assert_allclose(np.linalg.eigvalsh(stress), expected, rtol=0, atol=1e-10 * np.abs(expected).max())
        found += 1
    assert found > 0


@pytest.mark.parametrize("touching", [False, True], ids=["alone", "with contact"])
@pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")
def test_stresses_after_a_failure_are_those_of_the_state(touching):
    """Stresses without the bonds, and with contacts without dashpots behind them, are found again from the poses."""
    model = touching_spheres(WEAK, weight=400.0, damping=0.0) if touching else non_local_cells(SHEARED)
    plan, state = plan_and_state(model, None, every=0)
    assert plan.dt is not None
    loop, found = CoreLoop(model, plan, state, plan.dt), 0
    for _ in range(120):
        before = len(state.broken)
        loop.run(1)
        if len(state.broken) == before:
            continue
        again = state.copy()
        again.stale = True
        CoreLoop(model, plan, again, plan.dt).record_present()
        size = np.abs(state.stress).max()
        np.testing.assert_allclose(again.stress, state.stress, rtol=0, atol=1e-10 * size)
        assert len(again.broken) == len(state.broken)
        found += 1
    assert found > 5
    assert not touching or (len(state.touching) > 3 and (state.broken[:, EventColumn.GAP] < 0.0).any())


def test_a_failure_releases_the_energy_of_the_springs_between_two_steps():
    """What the ledger misses does not jump with the number of failures; it falls with the step."""
    missed = []
    for share in (0.1, 0.05):
        model = non_local_spheres(bd.Rankine(tension=2e4))
        plan, state = plan_and_state(model, None, every=1)
        assert plan.dt is not None
        dt = share / 0.3 * plan.dt
        done = integrate(model, replace(plan, dt=dt, duration=60 * plan.dt), state=state, loop_of=CoreLoop)
        ledger = done.history.energy
        assert len(done.events) > 10
        assert ledger["fracture"][-1] == pytest.approx(done.events.energy.sum(), rel=1e-12)
        assert np.abs(ledger["balance"]).max() < 0.05 * ledger["fracture"][-1]
        missed.append(np.abs(ledger["balance"]).max())
    assert missed[1] < 0.7 * missed[0]


def test_a_broken_bond_of_the_non_local_law_keeps_what_it_stores():
    model = non_local_spheres()
    plan, state = plan_and_state(model, None, steps=30, every=0)
    state = integrate(model, plan, state=state, loop_of=CoreLoop).state
    state.integrity[5] = 0.0
    before = state.history[:, 5].copy()
    assert plan.dt is not None
    CoreLoop(model, plan, state, plan.dt).run(10)
    np.testing.assert_array_equal(state.history[:, 5], before)
    forces = bd.bond_forces(model, state)
    assert np.abs(forces.force[model.layout.bond_order[5]]).max() == 0.0
