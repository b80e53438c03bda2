"""The incremental formulation beside the total one, and stress-free strains of bonds."""

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from bondem.laws.damping import LocalDamping
from bondem.model.state import State
from bondem.solve.explicit import Plan, integrate


def crooked_chain(count: int = 8) -> bd.Lattice:
    rng = np.random.default_rng(0)
    x = np.arange(count)[:, None] * np.array([0.4, 0.0, 0.0]) + rng.uniform(-0.05, 0.05, (count, 3))
    pairs = np.c_[np.arange(1, count), np.arange(count - 1)]
    return bd.Lattice(bd.Particles(x, rng.uniform(0.15, 0.2, count)), pairs)


def tip_loaded(law, count: int = 8) -> bd.Model:
    ramp = bd.Ramp(0.0, 1.0, 0.01)
    load = bd.Load(bd.Index([count - 1]), force=(300.0, 200.0, 1000.0), moment=(1000.0, 0.0, 0.0), schedule=ramp)
    return bd.Model(crooked_chain(count), law, 7800.0, boundary=[bd.Fix(bd.Index([0])), load])


@pytest.mark.parametrize("law", [bd.EulerBernoulli, bd.Timoshenko, bd.ParallelBond])
def test_small_rotations_agree_with_the_total_formulation(law):
    tips = []
    for formulation in ("total", "incremental"):
        model = tip_loaded(law(E=200e9, nu=0.3, radius=0.2, formulation=formulation))
        plan = Plan(duration=0.02, every=10, gauges={"tip": bd.Gauge(bd.Index([7]), "displacement")})
        tips.append(integrate(model, plan).history["tip"])
    # rotations are about 1e-4, the difference of the formulations is of their square
    assert np.abs(tips[0] - tips[1]).max() < 1e-3 * np.abs(tips[0]).max()
    assert np.abs(tips[0] - tips[1]).max() > 0.0


def test_incremental_run_settles_at_the_static_solution():
    model = tip_loaded(bd.ParallelBond(E=200e9, nu=0.3, radius=0.2, formulation="incremental"))
    run = integrate(model, Plan(duration=1.5, every=0, damping=LocalDamping(0.3)))
    static = bd.solve_static(model).displacement
    assert np.abs(run.state.displacement - static).max() < 1e-3 * np.abs(static).max()


def test_incremental_ledger_closes_to_second_order():
    defects = []
    for safety in (0.8, 0.4):
        model = tip_loaded(bd.EulerBernoulli(E=200e9, nu=0.3, radius=0.2, formulation="incremental"))
        ledger = integrate(model, Plan(duration=0.02, every=7, safety=safety)).history.energy
        defects.append(np.abs(ledger["balance"]).max() / ledger["work"].max())
    assert defects[0] < 1e-5
    assert 3.0 < defects[0] / defects[1] < 5.0


def straight_bar(boundary=()) -> bd.Model:
    lattice = bd.connect(bd.Particles(np.arange(6)[:, None] * np.array([0.4, 0.0, 0.0]), 0.2))
    return bd.Model(lattice, bd.EulerBernoulli(E=200e9, nu=0.3, radius=0.2), 7800.0, boundary=boundary)


def settle(model: bd.Model, strain: float):
    state = State(model)
    state.set_eigenstrain(strain)
    end = bd.Gauge(bd.Index([5]), "force")
    plan = Plan(duration=0.05, every=100, damping=LocalDamping(0.5), gauges={"end": end})
    return integrate(model, plan, state=state)


def test_free_bar_takes_its_eigenstrain_without_stress():
    run = settle(straight_bar([bd.Fix(bd.Index([0]))]), 1e-4)
    # u = ε* x
    assert run.state.displacement[5, 0] == pytest.approx(1e-4 * 2.0, rel=1e-6)
    assert run.history.energy["normal"][-1] < 1e-9 * run.history.energy["normal"][0]


def test_clamped_bar_bears_minus_E_times_eigenstrain():
    run = settle(straight_bar([bd.Fix(bd.Index([0])), bd.Fix(bd.Index([5]))]), 1e-4)
    # σ = -E ε*: the support pushes back with E A ε*
    assert run.history["end"][-1, 0] == pytest.approx(-200e9 * np.pi * 0.2**2 * 1e-4, rel=1e-6)


def test_bad_eigenstrain_is_refused():
    with pytest.raises(InputError, match="above -1"):
        State(straight_bar()).set_eigenstrain(-1.0)
    law = bd.EulerBernoulli(E=1.0, nu=0.3, radius=0.2, formulation="incremental")
    with pytest.raises(InputError, match="total"):
        State(tip_loaded(law)).set_eigenstrain(0.0)
