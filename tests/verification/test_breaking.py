"""Bonds that break: where the closed forms say, with a ledger that closes, and with the same bits however run."""

import functools
import math
from pathlib import Path

import numba
import numpy as np
import pytest

import bondem as bd
from bondem._compile import threads
from bondem.errors import InputError
from bondem.model.state import State
from bondem.solve.timestep import critical_step
from tests.bits import assert_resumes_to, assert_same_bits
from tests.recording import Record

R, L, RADIUS = 0.5e-3, 1.0e-3, 0.35e-3
E, NU = 1e9, 0.3
A, I = math.pi * RADIUS**2, math.pi * RADIUS**4 / 4.0
KN, KS, KB = E * A / L, 12.0 * E * I / L**3, E * I / L
KT = E / (2.0 * (1.0 + NU)) * 2.0 * I / L
LAW = bd.EulerBernoulli(E=E, nu=NU, radius=RADIUS)
STRONG = 1e30


def pair(failure: bd.Criterion, law: bd.BondLaw = LAW, boundary=()) -> bd.Model:
    """Two touching spheres along x."""
    position = np.array([[0.0, 0.0, 0.0], [L, 0.0, 0.0]])
    lattice = bd.Lattice(bd.Particles(position, R), np.array([[0, 1]]))
    return bd.Model(lattice, law, density=1000.0, failure=failure, boundary=boundary)


def turn(axis: int, angle: float) -> np.ndarray:
    q = np.zeros(4)
    q[0], q[1 + axis] = math.cos(0.5 * angle), math.sin(0.5 * angle)
    return q


def index(model: bd.Model, place: tuple[float, float, float], first: np.ndarray, second: np.ndarray) -> float:
    state = model.state()
    state.set_pose(position=np.array([[0.0, 0.0, 0.0], place]), orientation=np.stack([first, second]))
    return float(bd.failure_index(model, state)[0])


STILL = turn(0, 0.0)
TURNED = 0.02  # rad
STRETCHED = 3e-3
SIDE = KS * L**2 * math.sin(TURNED) * math.cos(TURNED)  # shear force times length, at a branch turned by it
# place of the second sphere, orientations, and N, Q, M at the ends, T of the closed form
POSES = {
    "pulled": ((L * (1 + STRETCHED), 0.0, 0.0), STILL, STILL, (KN * L * STRETCHED, 0.0, 0.0, 0.0)),
    "sheared": (
        (L * math.cos(TURNED), L * math.sin(TURNED), 0.0), STILL, STILL, (0.0, SIDE / L, 0.5 * SIDE, 0.0)
    ),
    "bent": ((L, 0.0, 0.0), turn(2, -TURNED / 2), turn(2, TURNED / 2), (0.0, 0.0, KB * math.sin(TURNED), 0.0)),
    "twisted": ((L, 0.0, 0.0), STILL, turn(0, TURNED), (0.0, 0.0, 0.0, KT * math.sin(TURNED))),
    "pulled and bent": (
        (L * (1 + STRETCHED), 0.0, 0.0), turn(2, -TURNED / 2), turn(2, TURNED / 2),
        (KN * L * STRETCHED, 0.0, KB * math.sin(TURNED), 0.0),
    ),
    "pulled and sheared": (
        (L * (1 + STRETCHED) * math.cos(TURNED), L * (1 + STRETCHED) * math.sin(TURNED), 0.0), STILL, STILL,
        (KN * L * STRETCHED, SIDE / L / (1 + STRETCHED), 0.5 * SIDE, 0.0),
    ),
    "pressed and sheared": (
        (L * (1 - STRETCHED) * math.cos(TURNED), L * (1 - STRETCHED) * math.sin(TURNED), 0.0), STILL, STILL,
        (-KN * L * STRETCHED, SIDE / L / (1 - STRETCHED), 0.5 * SIDE, 0.0),
    ),
}  # fmt: skip


def peripheral(N: float, Q: float, M: float, T: float) -> float:
    return max((N / A + 0.5 * M * RADIUS / I) / 2e6, (Q / A + T * RADIUS / (2.0 * I)) / 3e6)


def coulomb(N: float, Q: float, M: float, T: float) -> float:
    return max(N / A / 2e6, (Q / A + N / A * math.tan(0.6)) / 3e6)


def linear(N: float, Q: float, M: float, T: float) -> float:
    return N / 2.0 + Q / 3.0 + M / 2e-3 + T / 3e-3


CRITERIA = {
    "peripheral": (bd.PeripheralStress(tension=2e6, shear=3e6, beta=0.5), peripheral),
    "Mohr-Coulomb": (bd.MohrCoulomb(tension=2e6, cohesion=3e6, friction_angle=0.6), coulomb),
    "linear": (bd.LinearSum(force=2.0, shear=3.0, bending=2e-3, twisting=3e-3), linear),
}


@pytest.mark.parametrize("pose", POSES)
@pytest.mark.parametrize("criterion", CRITERIA)
def test_index_is_that_of_the_closed_form(criterion: str, pose: str, record: Record) -> None:
    failure, formula = CRITERIA[criterion]
    place, first, second, load = POSES[pose]
    found = index(pair(failure), place, first, second)
    assert found == pytest.approx(formula(*load), rel=1e-9)
    record("closed form", True)


def test_index_of_elongation_and_rotation() -> None:
    model = pair(bd.Elliptic(elongation=0.01, rotation=0.1))
    for pose, angle in (("pulled", 0.0), ("pulled and bent", TURNED / 2), ("pulled and sheared", TURNED)):
        place, first, second, _ = POSES[pose]
        expected = (STRETCHED / 0.01) ** 2 + angle / 0.1
        assert index(model, place, first, second) == pytest.approx(expected, rel=1e-9)
    place, first, second, _ = POSES["pressed and sheared"]
    assert index(model, place, first, second) == pytest.approx(TURNED / 0.1, rel=1e-9)


def test_parallel_bonds_are_judged_at_the_contact_point() -> None:
    """A sheared one has no moment there, where a beam has the largest at its ends."""
    law = bd.ParallelBond(E=E, nu=NU, radius=RADIUS)
    failure = bd.PeripheralStress(tension=2e6, shear=STRONG)
    for pose, moment in (("sheared", 0.0), ("bent", KN * RADIUS**2 / 4.0 * math.sin(TURNED))):
        place, first, second, _ = POSES[pose]
        found = index(pair(failure, law), place, first, second)
        assert found == pytest.approx(moment * RADIUS / I / 2e6, rel=1e-9, abs=1e-12)


RATES = {"pulled": "vx", "sheared": "vy", "bent": "wz", "twisted": "wx"}


@pytest.mark.parametrize("way", RATES)
@pytest.mark.parametrize("criterion", [*CRITERIA, "elliptic"])
def test_a_pair_breaks_within_one_increment(criterion: str, way: str, one_thread: None) -> None:
    """Driven at a constant rate, a pair breaks in the first step in which its index is 1 or more."""
    failure = bd.Elliptic(elongation=0.004, rotation=0.02) if criterion == "elliptic" else CRITERIA[criterion][0]
    model = pair(failure)
    rates = dict.fromkeys(("vx", "vy", "vz", "wx", "wy", "wz"), 0.0)
    dt = 0.5 * critical_step(model, bd.VelocityVerlet())
    rates[RATES[way]] = 1.0123 * (0.02 * L if way in ("pulled", "sheared") else 0.1) / (500 * dt)
    model = pair(failure, boundary=[bd.Fix(bd.Index([0])), bd.Drive(bd.Index([1]), **rates)])
    run = bd.solve_explicit(model, duration=500 * dt, dt=dt, every=1)

    def at(step: int) -> float:
        place, angle = np.array([L, 0.0, 0.0]), 0.0
        if way in ("pulled", "sheared"):
            place["xy".index(RATES[way][1])] += rates[RATES[way]] * step * dt
        else:
            angle = rates[RATES[way]] * step * dt
        return index(pair(failure), tuple(place), STILL, turn(2 if way == "bent" else 0, angle))

    if max(at(500), at(250)) < 1.0:  # pure moments break no bond of Mohr-Coulomb
        assert len(run.events) == 0
        return
    step = int(run.events.step[0])
    assert at(step - 1) < 1.0 <= at(step)
    assert run.state.bond_integrity[0] == 0.0
    if way in ("pulled", "twisted") and criterion in ("peripheral", "Mohr-Coulomb"):
        assert run.events.mode[0] == {"pulled": "tension", "twisted": "shear"}[way]
    # what it stored is what it released
    stored = sum(run.history.energy[part] for part in ("normal", "shear", "bending", "twisting"))
    assert stored[step] == 0.0
    assert run.history.energy["fracture"][-1] == run.events.energy[0]
    assert run.events.energy[0] == pytest.approx(stored[step - 1], rel=4.0 / step)
    # work is a trapezoid in steps of 1/500 of a turn of 0.1 rad, of moments that are not linear in the angle
    assert run.residual < (0.1 / 500) ** 2


def block(count: int, failure: bd.Criterion | None, boundary=(), seed: int = 1) -> bd.Model:
    """A crooked block of count³ elements."""
    rng = np.random.default_rng(seed)
    grid = np.indices((count, count, count)).reshape(3, -1).T.astype(float)
    radius = rng.uniform(0.3, 0.4, len(grid))
    particles = bd.Particles(grid + rng.uniform(-0.1, 0.1, grid.shape), radius)
    law = bd.Timoshenko(E=1e7, nu=0.2, radius_ratio=0.6)
    return bd.Model(bd.connect(particles, reach=2.0), law, density=1000.0, failure=failure, boundary=boundary)


WEAK = bd.PeripheralStress(tension=2e5, shear=3e5, scatter=bd.Weibull(modulus=5.0, volume=0.1))
PULL = (bd.Fix(bd.Face("x_min", depth=0.5)), bd.Drive(bd.Face("x_max", depth=0.5), vx=bd.Ramp(0.0, 5.0, 0.02)))


def test_the_ledger_is_second_order_through_breakage(one_thread: None, record: Record) -> None:
    """Halving the step quarters what the ledger misses, though a hundred bonds break."""
    model = block(5, WEAK, PULL)
    dt = 0.4 * critical_step(model, bd.VelocityVerlet())
    missed, broken = [], []
    for halvings in range(4):
        count = 2**halvings
        run = bd.solve_explicit(model, duration=600 * dt, dt=dt / count, every=count)
        missed.append(np.sqrt((run.history.energy["balance"] ** 2).mean()))
        broken.append(len(run.events))
        assert run.history.energy["fracture"][-1] == pytest.approx(run.events.energy.sum(), rel=1e-12)
        assert (run.events.energy > 0.0).all()
    assert min(broken) > 50
    order = np.log2(missed[0] / missed[-1]) / 3.0
    assert order > 1.7
    record("order", order)


def test_momentum_is_kept_through_breakage(one_thread: None) -> None:
    model = block(5, WEAK)
    lattice, mass = model.lattice, model.mass[:, None]
    state = model.state()
    centre = lattice.particles.position.mean(axis=0)
    outwards = lattice.particles.position - centre
    state.set_motion(velocity=8.0 * outwards + np.cross((0.0, 0.0, 5.0), outwards))
    dt = 0.3 * critical_step(model, bd.VelocityVerlet())

    def momenta(state: State) -> np.ndarray:
        v, w, x = state.velocity, state.angular_velocity, state.position
        spin = np.cross(x, mass * v) + model.inertia[:, None] * w
        return np.concatenate([(mass * v).sum(axis=0), spin.sum(axis=0)])

    scale = np.abs(mass * state.velocity).sum() * 5.0
    run = bd.solve_explicit(model, duration=800 * dt, dt=dt, state=state)
    assert len(run.events) > 100
    assert np.abs(momenta(run.state) - momenta(state)).max() < 1e-13 * scale


def test_same_bits_after_thousands_of_breaks(tmp_path: Path, record: Record) -> None:
    """On one and two threads, recorded often or never, and saved and resumed, with damping and dashpots."""
    if numba.config.NUMBA_NUM_THREADS < 2:
        pytest.skip("numba may use one thread only (NUMBA_NUM_THREADS)")
    failure = bd.PeripheralStress(tension=4e5, shear=6.4e5, scatter=bd.Weibull(modulus=5.0, volume=0.1))
    drive = bd.Drive(bd.Face("x_max", depth=0.5), vx=bd.Ramp(0.0, 20.0, 0.02), wx=2.0)
    model = block(14, failure, (PULL[0], drive))
    state = model.state()
    state.set_motion(velocity=1.0 * (model.lattice.particles.position - 6.5))
    dt = 0.5 * critical_step(model, bd.VelocityVerlet(), bd.LocalDamping(0.05))

    def run(count: int, every: int, steps: int = 1200, **options) -> bd.ExplicitResult:
        with threads(count):
            damping = bd.LocalDamping(0.05)
            return bd.solve_explicit(
                model, duration=steps * dt, dt=dt, every=every, damping=damping, state=state, **options
            )

    whole = run(1, 100)
    assert len(whole.events) > 2000
    for count, every in ((2, 100), (1, 1), (2, 7), (2, 0)):
        assert_same_bits(whole, run(count, every))
    assert_resumes_to(whole, functools.partial(run, 2, 100, save_every=7), tmp_path / "run.h5", 20 / 1200)
    record("same bits", True)


def test_events_name_what_broke(one_thread: None) -> None:
    model = block(5, WEAK, PULL)
    dt = 0.4 * critical_step(model, bd.VelocityVerlet())
    run = bd.solve_explicit(model, duration=600 * dt, dt=dt)
    events = run.events
    assert sorted(events.bond) == np.flatnonzero(run.state.bond_integrity == 0.0).tolist()
    assert (np.diff(events.step) >= 0).all()
    np.testing.assert_allclose(events.time, events.step * dt, rtol=1e-12)
    middle = model.lattice.particles.position[model.lattice.pairs[events.bond]].mean(axis=1)
    assert np.linalg.norm(events.position - middle, axis=1)[:20].max() < 0.1  # before pieces fly
    assert set(events.mode) <= {"tension", "shear"}
    # a second stage brings them along, and counts its energies anew
    more = bd.solve_explicit(model, duration=10 * dt, dt=dt, state=run.state, every=1)
    np.testing.assert_array_equal(more.events.bond[: len(events)], events.bond)
    assert more.history.energy["fracture"][0] == 0.0


def test_strength_scatters_as_it_should() -> None:
    volume = np.full(200_000, 3e-6)
    weibull = bd.Weibull(modulus=8.0, volume=1e-6, seed=3)
    found = weibull.factors(volume)
    assert found.mean() == pytest.approx(3.0 ** (-1 / 8) * math.gamma(1 + 1 / 8), rel=2e-3)
    assert (found < 3.0 ** (-1 / 8)).mean() == pytest.approx(1 - math.exp(-1), abs=5e-3)
    normal = bd.Normal(deviation=0.2, seed=4).factors(volume)
    assert normal.mean() == pytest.approx(1.0, abs=2e-3)
    assert normal.std() == pytest.approx(0.2, rel=0.02)
    # by the number of the bond, whatever comes after it
    np.testing.assert_array_equal(weibull.factors(volume[:10]), found[:10])
    assert (weibull.factors(volume[:10]) != bd.Weibull(modulus=8.0, volume=1e-6, seed=4).factors(volume[:10])).all()


@pytest.mark.parametrize(
    ("words", "call"),
    [
        ("tension = -1", lambda: bd.PeripheralStress(tension=-1.0, shear=1.0)),
        ("beta", lambda: bd.PeripheralStress(tension=1.0, shear=1.0, beta=1.5)),
        ("friction_angle", lambda: bd.MohrCoulomb(tension=1.0, cohesion=1.0, friction_angle=35.0)),
        ("scatter", lambda: bd.MohrCoulomb(tension=1.0, cohesion=1.0, friction_angle=0.5, scatter=0.1)),
        ("modulus", lambda: bd.Weibull(modulus=0.0, volume=1.0)),
        ("deviation", lambda: bd.Normal(deviation=0.5)),
        ("failure", lambda: pair(4e6)),
        (
            "total formulation",
            lambda: pair(WEAK, bd.EulerBernoulli(E=E, nu=NU, radius=RADIUS, formulation="incremental")),
        ),
        ("explicit runs only", lambda: bd.solve_static(pair(WEAK, boundary=[bd.Fix(bd.Index([0]))]))),
    ],
)  # fmt: skip
def test_what_cannot_be_is_refused_in_a_line(words: str, call) -> None:
    with pytest.raises(InputError, match=words) as refused:
        call()
    assert "\n" not in str(refused.value)
