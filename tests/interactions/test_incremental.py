"""The incremental formulation beside the total one, and stress-free strains of bonds."""

import runpy
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem.dynamics.explicit import integrate
from bondem.errors import InputError
from tests.specimens import row, two_spheres


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
        plan = bd.Plan(duration=0.02, every=10, gauges={"tip": bd.Gauge(bd.Index([7]), "displacement")})
        tips.append(integrate(model, plan).history["tip"])
    # rotations are about 1e-4, the difference of the formulations is of their square
    assert np.abs(tips[0] - tips[1]).max() < 1e-3 * np.abs(tips[0]).max()
    assert np.abs(tips[0] - tips[1]).max() > 0.0


def test_incremental_run_settles_at_the_static_solution():
    model = tip_loaded(bd.ParallelBond(E=200e9, nu=0.3, radius=0.2, formulation="incremental"))
    run = integrate(model, bd.Plan(duration=1.5, every=0, damping=bd.LocalDamping(0.3)))
    static = bd.solve_static(model).displacement
    assert np.abs(run.state.displacement - static).max() < 1e-3 * np.abs(static).max()


def test_incremental_ledger_closes_to_second_order():
    defects = []
    for safety in (0.8, 0.4):
        model = tip_loaded(bd.EulerBernoulli(E=200e9, nu=0.3, radius=0.2, formulation="incremental"))
        ledger = integrate(model, bd.Plan(duration=0.02, every=7, safety=safety)).history.energy
        defects.append(np.abs(ledger["balance"]).max() / ledger["work"].max())
    assert defects[0] < 1e-5
    assert 3.0 < defects[0] / defects[1] < 5.0


def straight_bar(boundary=()) -> bd.Model:
    return bd.Model(row(6, 0.4), bd.EulerBernoulli(E=200e9, nu=0.3, radius=0.2), 7800.0, boundary=boundary)


def settle(model: bd.Model, strain: float):
    state = model.state()
    state.set_eigenstrain(strain)
    end = bd.Gauge(bd.Index([5]), "force")
    # the bar expands at once: its shortest waves change the balance by the square of the step
    plan = bd.Plan(duration=0.05, every=100, damping=bd.LocalDamping(0.5), gauges={"end": end}, imbalance=None)
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
        bd.State(straight_bar()).set_eigenstrain(-1.0)
    law = bd.EulerBernoulli(E=1.0, nu=0.3, radius=0.2, formulation="incremental")
    with pytest.raises(InputError, match="total"):
        bd.State(tip_loaded(law)).set_eigenstrain(0.0)


# ---- paths along which every element is driven


def follow(lattice: bd.Lattice, law, legs) -> tuple[float, np.ndarray]:
    """Elastic energy and force on the last element after legs of (positions of every step, angular velocities)."""
    state, run, last = None, None, bd.Gauge(bd.Index([len(lattice.particles) - 1]), "force")
    for path, rate in legs:
        times = tuple(float(t) for t in range(len(path)))
        drives = []
        for k, places in enumerate((path - path[0]).transpose(1, 2, 0)):
            x, y, z = (bd.Table(times, tuple(values.tolist())) for values in places)
            drives.append(bd.Drive(bd.Index([k]), x=x, y=y, z=z, wx=rate[k, 0], wy=rate[k, 1], wz=rate[k, 2]))
        model = bd.Model(lattice, law, 7800.0, boundary=drives)
        if state is not None:
            state.begin(model)
            state.time = 0.0
        plan = bd.Plan(duration=times[-1], dt=1.0, every=len(path) - 1, gauges={"last": last}, imbalance=None)
        run = integrate(model, plan, state=state)
        state = run.state
    assert run is not None
    ledger = run.history.energy
    return sum(ledger[name][-1] for name in ("normal", "shear", "bending", "twisting")), run.history["last"][-1]


def deformed(strain: float, steps: int):
    """A rod that is stretched, bent and twisted in proportion: its lattice, its law, the way there."""
    lattice = row(6, 0.4)
    couple = 0.25 * np.pi * 0.2**3 * strain * 200e9
    pull = bd.Load(bd.Index([5]), force=(np.pi * 0.04 * strain * 200e9, 0.0, 0.0), moment=(couple, couple, couple))
    law = bd.EulerBernoulli(E=200e9, nu=0.3, radius=0.2)
    static = bd.solve_static(bd.Model(lattice, law, 7800.0, boundary=[bd.Fix(bd.Index([0])), pull]))
    share = np.linspace(0.0, 1.0, steps + 1)[:, None, None]
    return lattice, law, (lattice.particles.position + share * static.displacement, static.rotation / steps)


def turned(start: np.ndarray, turns: int, steps: int):
    """The way of a body turned about z by `turns` turns of `steps` steps each."""
    angle = 2.0 * np.pi / steps * np.arange(turns * steps + 1)[:, None, None]
    flat = start * [1.0, 1.0, 0.0]
    path = np.cos(angle) * flat + np.sin(angle) * np.cross([0.0, 0.0, 1.0], flat) + start * [0.0, 0.0, 1.0]
    return path, np.tile([0.0, 0.0, 2.0 * np.pi / steps], (len(start), 1))


def test_ten_turns_leave_the_total_formulation_as_it_was():
    lattice, law, way = deformed(2e-3, 50)
    energy, force = follow(lattice, law, [way])
    after, last = follow(lattice, law, [way, turned(way[0][-1], 10, 200)])
    # rounding of 2000 steps over the strain
    assert after == pytest.approx(energy, rel=1e-9)
    assert np.abs(last - force).max() < 1e-9 * np.abs(force).max()


def test_ten_turns_change_the_incremental_formulation_by_the_square_of_the_step():
    lattice, law, way = deformed(2e-3, 50)
    law = replace(law, formulation="incremental")
    force = follow(lattice, law, [way])[1]
    errors = []
    for steps in (400, 800):
        last = follow(lattice, law, [way, *10 * [turned(way[0][-1], 1, steps)]])[1]
        errors.append(np.linalg.norm(last - force) / np.linalg.norm(force))
    # (2π)³ N / 12 S² of shear strain, over 2e-3 of stretch
    assert errors[1] < 0.2
    assert 3.8 < errors[0] / errors[1] < 4.2


def test_a_lattice_that_spins_freely_keeps_its_angular_momentum_length_and_energy():
    grid = np.stack(np.meshgrid(range(4), range(2), range(2), indexing="ij"), axis=-1).reshape(-1, 3)
    lattice = bd.connect(bd.Particles(0.4 * grid, 0.2), reach=1.45)
    for formulation in ("total", "incremental"):
        law = bd.ParallelBond(E=200e9, nu=0.3, radius=0.1, formulation=formulation)
        model = bd.Model(lattice, law, 7800.0)
        state = model.state()
        around = lattice.particles.position - lattice.particles.position.mean(axis=0)
        spin = np.array([0.0, 0.0, 80.0])
        state.set_motion(velocity=np.cross(spin, around), angular_velocity=np.tile(spin, (len(grid), 1)))

        def angular(state: bd.State, model: bd.Model = model) -> np.ndarray:
            orbital = np.cross(state.position, model.mass[:, None] * state.velocity)
            return (orbital + model.inertia[:, None] * state.angular_velocity).sum(axis=0)

        before, size = angular(state), np.linalg.norm(around, axis=1).max()
        run = integrate(model, bd.Plan(duration=10.0 * 2.0 * np.pi / 80.0, every=200), state=state)
        assert np.abs(angular(run.state) - before).max() < 1e-11 * np.abs(before).max()
        where = run.state.position - run.state.position.mean(axis=0)
        # centrifugal strain: (ω l)²/c² = 1e-4
        assert np.linalg.norm(where, axis=1).max() == pytest.approx(size, rel=2e-4)
        ledger = run.history.energy
        assert np.abs(ledger["balance"]).max() < 1e-4 * ledger["translation"][0]


def test_both_formulations_differ_by_the_square_of_the_amplitude():
    differences = []
    for strain in (1e-5, 1e-4):
        lattice, law, way = deformed(strain, 1000)
        total = follow(lattice, law, [way])[1]
        rates = follow(lattice, replace(law, formulation="incremental"), [way])[1]
        differences.append(np.linalg.norm(rates - total) / np.linalg.norm(total))
    # of the force itself: the first power
    assert differences[1] < 1e-3
    assert 9.0 < differences[1] / differences[0] < 11.0


@pytest.mark.parametrize("angle", [0.1, 0.3])
def test_a_closed_cycle_leaves_what_the_rates_say_and_nothing_in_the_total_formulation(angle: float):
    """Element 1 of a bond is bent about y, twisted, unbent, untwisted, by rotations Ry(β) Rx(τ); both centres stay.

    With m = My + i Mz over kb, and the bond spinning at half the twist rate: bending adds the angle, twisting is
    m' = ½ i cos α m - i sin α, unbending takes the angle away, untwisting turns m back by half the angle. Shear
    forces go the same way with ks b instead of kb.
    """
    lattice = two_spheres(0.4)
    law = bd.Timoshenko(E=200e9, nu=0.3, radius=0.2)
    steps = 2000
    still = np.repeat(lattice.particles.position[None], steps + 1, axis=0)
    y, x = np.array([[0.0, 0, 0], [0.0, 1, 0]]), np.array([[0.0, 0, 0], [1.0, 0, 0]])
    tilted = np.array([[0.0, 0, 0], [np.cos(angle), 0.0, -np.sin(angle)]])
    legs = [(still, angle / steps * rate) for rate in (y, tilted, -y, -x)]
    peak = follow(lattice, law, legs[:2])[0]
    assert follow(lattice, law, legs)[0] < 1e-20 * peak

    c = 0.5 * np.cos(angle)
    turn = np.exp(1j * c * angle)
    left = abs(angle * turn - np.sin(angle) / c * (turn - 1.0) - angle)
    k = bd.Model(lattice, law, 7800.0).stiffness
    across = k.kb[0] + k.ks[0] * (0.4 - k.lever[0]) ** 2
    expected = 0.5 * across * left**2 + 0.5 * k.kt[0] * (angle * (1.0 - np.cos(angle))) ** 2
    # what is left is of the second order in the angle, and does not depend on the steps
    found = follow(lattice, replace(law, formulation="incremental"), legs)[0]
    assert found == pytest.approx(expected, rel=5e-3)
    assert np.sqrt(expected / peak) > 0.3 * angle


def test_the_example_of_ten_closed_cycles():
    example = runpy.run_path(str(Path(__file__).parents[2] / "examples/closed_cycle.py"))
    left = example["main"]()
    # ten times α²/2, over √(α² + (10 α²/2)²) after the last twist, and terms of a higher order in α = 0.05
    assert left["total"] < 1e-9
    assert left["incremental"] == pytest.approx(0.25 / np.hypot(1.0, 0.25), rel=5e-3)
