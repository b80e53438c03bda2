"""Adhesion against closed forms of its potential well, conservation laws, and what is refused."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem.dynamics import core_loop
from bondem.dynamics import neighbour_list as lists
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.explicit import integrate
from bondem.errors import InputError
from tests.bits import assert_same_bits
from tests.core.contact_cases import CASES, STICKY, all_walls, cloud, plan_of
from tests.models import grains, moving
from tests.specimens import loose

E, STRENGTH, REACH = 1e8, 1e5, 0.02
STUCK = bd.Adhesion(strength=STRENGTH, reach=REACH)
LAWS = {
    "linear": bd.LinearContact(E=E, adhesion=STUCK),
    "Hertzian": bd.HertzMindlin(E=E, nu=0.25, adhesion=STUCK),
}
FLOOR = bd.PlaneWall((0, 0, 0), (0, 0, 1))
# Clouds are fast and soft, and have servos.
pytestmark = [
    pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning"),
    pytest.mark.filterwarnings("ignore::bondem.errors.NotQuasistaticWarning"),
]
MASS = 4e3 / 3 * math.pi  # of a sphere of unit radius and 1000 kg/m³


def met(law: bd.ContactLaw, speed: float, where: str, *, gap: float = 0.0, **options) -> bd.ExplicitResult:
    """Return a run of a sphere of unit radius that meets another one, or the floor, from a gap at a speed."""
    at_floor = where == "wall"
    places = [[0, 0, 1.0 + gap], [9, 9, 50]] if at_floor else [[0, 0, 20.0 + gap], [0, 0, 18.0]]
    model = grains(places, law=law, walls=[FLOOR] if at_floor else [])
    return bd.solve_explicit(model, state=moving(model, [[0, 0, -speed], [0, 0, 0]]), **options)


def depth(where: str) -> tuple[float, float]:
    """Return the depth of the well [J] and the mass that meets [kg]."""
    return 0.5 * STRENGTH * math.pi * REACH, MASS if where == "wall" else 0.5 * MASS


@pytest.mark.parametrize("kind", LAWS)
@pytest.mark.parametrize("where", ["pair", "wall"])
def test_a_sphere_sticks_with_less_energy_than_the_well_and_leaves_with_the_difference(
    kind: str, where: str, one_thread: None
) -> None:
    """From the gap 0, where it is as deep as F_c D / 2, and from beyond the reach, which it leaves as it came."""
    well, mass = depth(where)
    escape = math.sqrt(2.0 * well / mass)

    def leaving(run: bd.ExplicitResult) -> float:
        return run.state.velocity[0, 2] - (0.0 if where == "wall" else run.state.velocity[1, 2])

    for share in (1.05, 1.5):
        run = met(LAWS[kind], share * escape, where, duration=0.4, dt=5e-5, every=10)
        assert leaving(run) == pytest.approx(escape * math.sqrt(share**2 - 1.0), rel=1e-3)
        assert run.history.energy["contact"][0] == pytest.approx(-well, rel=1e-12)
        assert run.history.energy["contact"][-1] == 0.0
    run = met(LAWS[kind], 0.95 * escape, where, duration=0.4, dt=5e-5, every=10)
    assert run.history.energy["contact"].max() < 0.0
    away = run.state.position[0, 2] - (1.0 if where == "wall" else run.state.position[1, 2] + 2.0)
    assert away < REACH
    run = met(LAWS[kind], 0.5 * escape, where, gap=1.1 * REACH, duration=0.4, dt=5e-5, every=10)
    assert leaving(run) == pytest.approx(0.5 * escape, rel=2e-3)
    assert run.history.energy["contact"].min() < -well


@pytest.mark.parametrize("kind", LAWS)
@pytest.mark.parametrize("where", ["pair", "wall"])
def test_the_ledger_is_of_second_order_in_the_step(kind: str, where: str, one_thread: None) -> None:
    well, mass = depth(where)
    escape = math.sqrt(2.0 * well / mass)
    missed = []
    for dt in (2e-4, 1e-4, 5e-5):
        run = met(LAWS[kind], 2.0 * escape, where, gap=1.1 * REACH, duration=0.2, dt=dt, every=1)
        assert run.state.velocity[0, 2] > (-1e-3 if where == "pair" else 0.0)
        missed.append(np.abs(run.history.energy["balance"]).max())
    assert missed[0] < 1e-2 * well
    assert missed[0] / missed[2] == pytest.approx(16.0, rel=0.4)


@pytest.mark.parametrize("kind", LAWS)
@pytest.mark.parametrize("where", ["pair", "wall"])
@pytest.mark.parametrize(("share", "stays"), [(0.98, True), (1.02, False)])
def test_the_pull_off_force_is_strength_times_area(
    kind: str, where: str, share: float, stays: bool, one_thread: None
) -> None:
    """A slow pull below F_c is held at the overlap of the spring, one above it parts the two."""
    pull = bd.Ramp(0.0, share * STRENGTH * math.pi, 0.4)
    load = [bd.Load(bd.Index([0]), force=(0, 0, 1.0), schedule=pull), bd.Fix(bd.Index([1]))]
    law = replace(LAWS[kind], **({"damping": 0.5} if kind == "linear" else {"restitution": 0.2}))
    at_floor = where == "wall"
    places = [[0, 0, 1.0], [9, 9, 50]] if at_floor else [[0, 0, 20.0], [0, 0, 18.0]]
    model = grains(places, law=law, walls=[FLOOR] if at_floor else [], boundary=load)
    gauges = {"F": bd.WallGauge(0, "force")} if at_floor else {}
    run = bd.solve_explicit(model, duration=1.0, every=50, gauges=gauges)
    away = run.state.displacement[0, 2]
    assert (away < 0.0) == stays
    if not stays:
        assert away > REACH
        return
    left = (1.0 - share) * STRENGTH * math.pi  # what the spring holds
    k = {"linear": 0.5 * math.pi * E, "Hertzian": 2.0 / 3.0 * E / (1.0 - 0.25**2) * math.sqrt(0.5)}[kind]
    stiff = {"pair": 1.0, "wall": 2.0 if kind == "linear" else 2.0 * math.sqrt(2.0)}[where]
    sunk = (left / (stiff * k)) ** (1.0 if kind == "linear" else 2.0 / 3.0)
    assert -away == pytest.approx(sunk, rel=2e-2)
    if at_floor:
        assert run.history["F"][-1, 2] == pytest.approx(share * STRENGTH * math.pi, rel=1e-3)


def test_adhesion_presses_the_spring_that_friction_has(one_thread: None) -> None:
    """Without any load a sphere on the floor resists a push along it of up to μ F_c."""
    mu, most = 0.4, STRENGTH * math.pi
    for share in (0.9, 1.1):
        push = bd.Load(bd.Index([0]), force=(share * mu * most, 0, 0), schedule=bd.Ramp(0.0, 1.0, 0.2))
        law = replace(LAWS["linear"], friction=mu, damping=0.5)
        held = bd.Fix(bd.Index([0]), "", "xyz")
        model = grains([[0, 0, 1.0]], law=law, walls=[FLOOR], boundary=[push, held])
        away = bd.solve_explicit(model, duration=0.4, every=0).state.displacement[0, 0]
        assert (away > 1e-2) == (share > 1.0)


@pytest.mark.parametrize("kind", LAWS)
def test_unequal_spheres_adhere_by_the_smaller_one(kind: str, one_thread: None) -> None:
    model = grains([[0, 0, 0], [0, 0, 1.6 + 0.5 * REACH]], [1.0, 0.6], law=LAWS[kind])
    energy = bd.solve_explicit(model, duration=1e-7, dt=1e-8, every=1).history.energy
    expected = -0.5 * STRENGTH * math.pi * 0.36 * (0.5 * REACH) ** 2 / REACH
    assert energy["contact"][0] == pytest.approx(expected, rel=1e-9)


def test_grains_at_rest_gather(one_thread: None) -> None:
    """No guard takes what adhesion releases for a run that is unstable: its energy becomes motion."""
    grid = (2.0 + 0.999 * REACH) * np.indices((3, 3, 3)).reshape(3, -1).T
    model = grains(grid, 1.0, law=replace(LAWS["linear"], damping=0.3))
    run = bd.solve_explicit(model, duration=0.5, every=20)
    assert run.status.value == "completed"
    energy = run.history.energy
    assert energy["translation"].max() > 1e4 * abs(energy["contact"][0]) > 0.0
    assert np.ptp(run.state.position[:, 0]) < np.ptp(grid[:, 0]) - REACH
    assert abs(energy["balance"]).max() < 1e-2 * abs(energy["contact"]).max()


def test_the_work_of_walls_that_turn_is_counted(one_thread: None) -> None:
    """Driven and free ones, which adhesion pulls and turns too."""
    make, _ = CASES["sticky spheres and walls that turn"]
    model, state = make()
    run = integrate(model, plan_of(model, 800, share=0.2, every=20), state=state)
    energy = run.history.energy
    assert energy["contact"].min() < -1.0
    assert abs(energy["balance"]).max() < 1e-5 * abs(energy["work"]).max()


def test_threads_pauses_lists_and_files_change_no_bit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    results = []
    for count, every, skin in ((1, 40, 0.1), (3, 7, 0.1), (2, 0, 0.4)):
        monkeypatch.setattr(core_loop, "current_threads", lambda count=count: count)
        monkeypatch.setattr(lists, "_SKIN_LEAST", skin)
        model, state = cloud(9, STICKY, walls=all_walls(21.0), speed=30.0)
        results.append(integrate(model, plan_of(model, 120, every=every), state=state, loop_of=CoreLoop))
    for other in results[1:]:
        assert_same_bits(results[0], other)
    without, state = cloud(9, replace(STICKY, adhesion=None), walls=all_walls(21.0), speed=30.0)
    other = integrate(without, plan_of(model, 120, every=0), state=state)
    assert np.abs(other.state.pose - results[0].state.pose).max() > 1e-6

    make, _ = CASES["sticky spheres and walls"]
    (model, state), (_, again), path, dt = make(), make(), tmp_path / "run.h5", 1e-4
    whole = bd.solve_explicit(model, duration=300 * dt, dt=dt, every=20, state=state)
    bd.solve_explicit(model, duration=140 * dt, dt=dt, every=20, state=again, out=path, save_every=20)
    kept = bd.read_run(path)
    assert kept.model.contact == STICKY
    plan = replace(kept.plan, duration=300 * dt)
    assert_same_bits(whole, integrate(kept.model, plan, state=kept.state, history=kept.history))


def test_a_pair_whose_bond_breaks_does_not_adhere(one_thread: None) -> None:
    """Torn apart it is free, and other pairs of the same body adhere as before."""
    particles = bd.Particles([[0, 0, 0], [2.0, 0, 0], [0, 9, 0], [2.0 + 0.5 * REACH, 9, 0]], 1.0)
    lattice = bd.Lattice(particles, [[0, 1]])
    law, failure = bd.Timoshenko(E=E, nu=0.2, radius=0.5), bd.PeripheralStress(tension=1e3, shear=1e3)
    model = bd.Model(lattice, law, 1e3, contact=LAWS["linear"], failure=failure)
    state = moving(model, [[-0.1, 0, 0], [0.1, 0, 0], [0, 0, 0], [0, 0, 0]])
    run = bd.solve_explicit(model, duration=0.02, every=0, state=state)
    assert len(run.state.broken) == 1
    apart = np.diff(run.state.velocity[:2, 0])[0]
    assert apart == pytest.approx(0.2, rel=1e-2)
    assert np.diff(run.state.velocity[2:, 0])[0] < -1e-3


def test_the_default_step_resolves_the_reach() -> None:
    """As it resolves a collision: with 20 steps of π √(m̄ D / F_c)."""
    soft = bd.LinearContact(E=E, adhesion=bd.Adhesion(strength=1e4, reach=REACH))
    hard = bd.LinearContact(E=1e4 * math.pi, adhesion=bd.Adhesion(strength=1e7, reach=REACH))
    slope = 1e7 * math.pi / REACH
    steps = []
    for law in (soft, replace(soft, adhesion=None), hard):
        model = bd.Model(loose([[0, 0, 0], [3, 0, 0]], [1.0, 1.0]), None, 1e3, contact=law)
        steps.append(bd.solve_explicit(model, duration=0.1, every=0).dt)
    assert steps[0] == steps[1]
    assert steps[2] == pytest.approx(math.pi * math.sqrt(0.5 * MASS / slope) / 20, rel=0.1)


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: bd.Adhesion(strength=0.0, reach=1e-3), "strength = 0.0"),
        (lambda: bd.Adhesion(strength=1e4, reach=0.0), "reach = 0.0"),
        (lambda: bd.Adhesion(strength=1e4, reach=-1e-3), "reach = -0.001"),
        (lambda: bd.LinearContact(E=E, adhesion=1e4), r"adhesion = 10000.0; give bd.Adhesion\(strength=, reach=\)"),
        (lambda: bd.HertzMindlin(E=E, nu=0.2, adhesion="strong"), "adhesion = 'strong'"),
        (lambda: grains([[0, 0, 0], [3, 0, 0]], [1.0, 0.01], law=LAWS["linear"]), "than the smallest radius, 0.01 m"),
    ],
)  # fmt: skip
def test_bad_input_is_refused(make, words: str) -> None:
    with pytest.raises(InputError, match=words):
        make()


def test_cells_do_not_adhere() -> None:
    body = bd.connect(bd.pack(bd.Box((1, 1, 1)), count=8, method="even", seed=1), method="laguerre")
    with pytest.raises(InputError, match="contact= with adhesion= applies to beams; leave out adhesion= for cells"):
        bd.Model(body, bd.CellBond(E=E, nu=0.2), 1e3, contact=LAWS["linear"])
