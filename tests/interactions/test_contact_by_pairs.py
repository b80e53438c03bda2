"""Contact laws by region, by pair of regions and at walls: closed forms, bits of one law, and what is refused."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem.dynamics import core_loop
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.explicit import integrate
from bondem.dynamics.timestep import choose_step, critical_step
from bondem.errors import EmptyRegionError, InputError
from tests.bits import assert_same_bits, assert_same_run
from tests.core.contact_cases import CASES, HERTZIAN, LINEAR, STEPS, all_walls, cloud, plan_of
from tests.models import VERLET, grains, momenta, moving
from tests.specimens import loose

E, G = 1e8, 9.81
FLOOR = bd.PlaneWall((0, 0, 0), (0, 0, 1))
# Clouds are fast and soft.
pytestmark = [
    pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning"),
    pytest.mark.filterwarnings("ignore::bondem.errors.NotQuasistaticWarning"),
]


# ---- closed forms


def test_blocks_slide_or_rest_by_the_law_of_their_body_and_the_floor(one_thread: None) -> None:
    """On a slope of tan α = 0.3: that with μ = 0.8 rests, that with 0.1 slides with g (sin α - μ cos α)."""
    slope = math.atan(0.3)
    block = bd.connect(bd.Particles([[0, 0, 1.0], [2, 0, 1], [0, 2, 1], [2, 2, 1]], 1.0), reach=1.2)
    scene = bd.join(block, block.moved((0, 6, 0)), names=("rough", "smooth"))
    smooth = bd.LinearContact(E=E, friction=0.1, damping=0.3)
    laws = {bd.Everything(): smooth, (bd.Body("rough"), FLOOR): replace(smooth, friction=0.8)}
    weight = bd.BodyForce((G * math.sin(slope), 0, -G * math.cos(slope)))
    law = bd.Timoshenko(E=E, nu=0.2, radius=0.5)
    model = bd.Model(scene, law, 1e3, contact=laws, walls=[FLOOR], boundary=[weight])
    run = bd.solve_explicit(model, duration=0.5, every=20)
    away = run.state.displacement[:, 0].reshape(2, 4).mean(axis=1)
    down = G * (math.sin(slope) - 0.1 * math.cos(slope))
    assert away[1] == pytest.approx(0.5 * down * 0.5**2, rel=1e-2)
    # the weight acts at once, and the block slips by a little until the overlap with the floor carries it
    assert abs(away[0]) < 1e-2 * away[1]
    energy = run.history.energy
    assert abs(energy["balance"]).max() < 1e-4 * energy["friction"][-1]


@pytest.mark.parametrize("mu", [0.1, 0.8])
def test_an_oblique_impact_slides_with_the_friction_of_the_pair(mu: float, one_thread: None) -> None:
    """The tangential impulse is μ times the normal one, between two bodies and at the floor."""
    low = bd.LinearContact(E=E, friction=0.1)
    places = [[0, 0, 5.0], [0, 0, 7.0 + 1e-5], [9, 0, 1.0 + 1e-5]]
    contact = {bd.Everything(): replace(low, friction=0.4), (bd.Index([0]), bd.Index([1])): replace(low, friction=mu)}
    contact[bd.Index([2]), FLOOR] = replace(low, friction=0.9 - mu)
    model = grains(places, law=contact, walls=[FLOOR])
    velocity = np.array([[0, 0, 0], [0.09, 0, -0.01], [0.09, 0, -0.01]])
    change = bd.solve_explicit(model, duration=0.03, every=0, state=moving(model, velocity)).state.velocity - velocity
    # the pair turns by a thousandth of a radian while it touches
    assert -change[1, 0] / change[1, 2] == pytest.approx(mu, rel=1e-2)
    assert -change[2, 0] / change[2, 2] == pytest.approx(0.9 - mu, rel=1e-6)


def test_collisions_last_as_long_as_the_stiffness_of_their_pair_says(one_thread: None) -> None:
    """Linear: π √(m̄ / k), k = E π R² / 2 R of two spheres and E π R at a wall, each by the modulus of its pair."""
    moduli = {"soft": 0.25 * E, "hard": E, "floor": 0.5 * E}
    places = [[0, 0, 9.0], [0, 0, 11.0], [9, 0, 9.0], [9, 0, 11.0], [0, 9, 1.0]]
    one = bd.LinearContact(E=E)
    contact = {
        bd.Everything(): replace(one, E=moduli["floor"]),
        (bd.Index([0]), bd.Index([1])): replace(one, E=moduli["soft"]),
        (bd.Index([2]), bd.Index([3])): replace(one, E=moduli["hard"]),
    }
    mass, speed = 4e3 / 3 * math.pi, 0.1
    for some, modulus, k in (
        ((0, 1), "soft", 0.5 * math.pi * moduli["soft"]), ((2, 3), "hard", 0.5 * math.pi * moduli["hard"]),
        ((4,), "floor", math.pi * moduli["floor"]),
    ):  # fmt: skip
        model = grains(places, law=contact, walls=[FLOOR])
        velocity = np.zeros((5, 3))
        velocity[some[-1], 2] = -speed
        lasts = math.pi * math.sqrt((0.5 * mass if len(some) == 2 else mass) / k)
        dt = lasts / 2000
        run = bd.solve_explicit(model, duration=1.5 * lasts, dt=dt, every=1, state=moving(model, velocity))
        steps = int((run.history.energy["contact"] > 0.0).sum())
        assert steps * dt == pytest.approx(lasts, rel=1e-3), modulus
        assert run.history.energy["contact"].max() == pytest.approx(0.5 * mass * speed**2 / len(some), rel=1e-4)


@pytest.mark.parametrize("case", ["spheres and walls by kinds", "beams break, Hertzian by kinds"])
def test_the_ledger_closes(case: str, one_thread: None) -> None:
    make, _ = CASES[case]
    model, state = make()
    run = integrate(model, plan_of(model, 2 * STEPS, share=0.25, every=20), state=state)
    assert run.history.energy["friction"][-1] > 0.0
    assert len(run.state.touching) > 10
    assert run.history.imbalance < 2e-3


def test_momentum_is_kept(one_thread: None) -> None:
    model, state = cloud(4, CONTACT := {bd.Everything(): LINEAR, bd.Index(range(20)): replace(LINEAR, friction=0.0)})
    assert len(CONTACT) == 2
    before = momenta(model, state)
    after = momenta(model, integrate(model, plan_of(model, STEPS), state=state).state)
    for now, then in zip(after, before, strict=True):
        np.testing.assert_allclose(now, then, rtol=0, atol=1e-12 * np.abs(np.asarray(before)).max() * 12.0)


# ---- bits


@pytest.mark.parametrize("law", [LINEAR, HERTZIAN], ids=["linear", "Hertzian"])
def test_laws_of_the_same_numbers_have_the_bits_of_one(law: bd.ContactLaw, one_thread: None) -> None:
    """A law that no contact has makes kinds, whose pairs are taken lane by lane."""
    walls = all_walls(9.2)
    unused = replace(law, friction=0.7, E=1e-3 * law.E)
    runs = []
    for contact in (law, {bd.Everything(): law}, {bd.Everything(): law, bd.Index([0]): unused}):
        if isinstance(contact, dict) and len(contact) == 2:
            contact |= {(bd.Index([0]), wall): law for wall in walls}
        model, state = cloud(4, contact, walls=walls)
        plan = replace(plan_of(model, STEPS), dt=plan_of(cloud(4, law, walls=walls)[0], STEPS).dt)
        runs.append(integrate(model, plan, state=state))
    assert [len(run.state.model.contact_laws.laws) for run in runs] == [1, 1, 2]
    assert len(runs[0].state.touching) > 10
    for other in runs[1:]:
        assert_same_run(runs[0], other)


def test_threads_and_pauses_change_no_bit(monkeypatch: pytest.MonkeyPatch) -> None:
    results = []
    for count, every in ((1, 40), (3, 7), (2, 0)):
        monkeypatch.setattr(core_loop, "current_threads", lambda count=count: count)
        smooth = replace(LINEAR, E=0.5 * LINEAR.E, friction=0.0)
        contact = {bd.Everything(): LINEAR, bd.Index(range(0, 2197, 2)): smooth}
        model, state = cloud(13, contact, walls=all_walls(30.0), speed=30.0)
        results.append(integrate(model, plan_of(model, 100, every=every), state=state, loop_of=CoreLoop))
    assert len(results[0].state.touching) > 100
    for other in results[1:]:
        assert_same_bits(results[0], other)


def test_a_run_file_holds_the_laws_and_a_resumed_run_goes_on_by_them(tmp_path: Path, one_thread: None) -> None:
    make, _ = CASES["spheres and walls by kinds"]
    (model, state), (_, again), path, dt = make(), make(), tmp_path / "run.h5", 1e-4
    whole = bd.solve_explicit(model, duration=300 * dt, dt=dt, every=20, state=state)
    bd.solve_explicit(model, duration=140 * dt, dt=dt, every=20, state=again, out=path, save_every=20)
    kept = bd.read_run(path)
    assert list(kept.model.contact.items()) == list(model.contact.items())
    plan = replace(kept.plan, duration=300 * dt)
    assert_same_bits(whole, integrate(kept.model, plan, state=kept.state, history=kept.history))


# ---- the time step


def test_the_step_is_that_of_the_stiffest_pair_that_can_occur() -> None:
    soft, hard = bd.LinearContact(E=E), bd.LinearContact(E=16 * E)
    lattice = loose([[0, 0, 0], [3, 0, 0], [9, 0, 0]], [1.0, 1.0, 1.0])
    whole = bd.Index([0]), bd.Index([2])

    def step(contact: object, density: object = 1e3, walls: tuple = ()) -> tuple[float, float]:
        model = bd.Model(lattice, None, density, contact=contact, walls=walls)
        return critical_step(model, VERLET), choose_step(model, VERLET, None, safety=0.9).dt

    assert step({bd.Everything(): soft, whole: hard}) == step(hard)
    assert step({bd.Everything(): hard, whole: soft}) == step(hard)
    assert step(soft) == pytest.approx([4.0 * dt for dt in step(hard)])
    # a pair of heavy elements is slower: the light ones, which are soft, decide then
    heavy = np.array([64e3, 1e3, 64e3])
    assert step({bd.Everything(): soft, whole: hard}, heavy)[0] == step(soft, heavy)[0]
    assert step({bd.Everything(): soft, FLOOR: hard}, walls=(FLOOR,))[1] == step(hard, walls=(FLOOR,))[1]
    # a law that later entries have replaced everywhere counts for nothing
    assert step({bd.Everything(): hard, bd.Index([0, 1, 2]): soft}) == step(soft)


# ---- what is named, and what is refused


def test_later_entries_win_and_walls_may_be_named() -> None:
    law = [bd.LinearContact(E=E, friction=mu) for mu in (0.1, 0.2, 0.3, 0.4, 0.5)]
    roof = bd.PlaneWall((0, 0, 9), (0, 0, -1), friction=0.7)
    contact = {
        bd.Everything(): law[0], bd.Index([0, 1]): law[1], (bd.Index([1]), bd.Index([2])): law[2], FLOOR: law[3],
        (FLOOR, bd.Index([2])): law[4],
    }  # fmt: skip
    laws = grains([[0, 0, 1], [3, 0, 1], [6, 0, 1]], law=contact, walls=[FLOOR, roof]).contact_laws
    between, at_walls = laws.rows
    friction = between[laws.kind[:, None], laws.kind[None, :], 2]
    np.testing.assert_array_equal(friction, [[0.2, 0.2, 0.1], [0.2, 0.2, 0.3], [0.1, 0.3, 0.1]])
    # friction of a wall is its own where it has one
    np.testing.assert_array_equal(at_walls[laws.kind, :, 2], [[0.4, 0.7], [0.4, 0.7], [0.5, 0.7]])


ONE, TWO = bd.LinearContact(E=E), bd.LinearContact(E=2 * E)


@pytest.mark.parametrize(
    ("contact", "words"),
    [
        ({}, r"contact = \{\} has no region"),
        ({bd.Everything(): 3}, "contact = 3"),
        ({bd.Everything(): ONE, bd.Index([0]): bd.HertzMindlin(E=E, nu=0.2)}, "LinearContact and HertzMindlin; give"),
        ({bd.Everything(): ONE, bd.Index([0]): replace(TWO, stress_free=False)}, "with and without stress_free=True"),
        ({bd.Everything(): ONE, bd.Index([0]): replace(TWO, parallel=True)}, "with and without parallel=True"),
        ({bd.Index([0]): ONE, bd.Index([1]): TWO}, "no law, such as that of elements 1 and 0; add an entry for"),
        ({(bd.Index([0]), bd.Index([1])): ONE}, "element 1 and others of its regions"),
        ({(bd.Everything(), bd.Everything()): ONE}, "element 0 with wall 0; add an entry for its region"),
        ({bd.Everything(): ONE, bd.PlaneWall((0, 0, -5), (0, 0, 1)): TWO}, "which is not in walls="),
        ({bd.Everything(): ONE, (FLOOR, FLOOR): TWO}, "names two walls"),
        ({bd.Everything(): ONE, (bd.Index([0]), bd.Index([0]), FLOOR): TWO}, "names 3 regions"),
        ({"all": ONE}, "'all' is not a region"),
    ],
)  # fmt: skip
def test_laws_that_do_not_fit_are_refused(contact: dict, words: str) -> None:
    with pytest.raises(InputError, match=words):
        grains([[0, 0, 1], [3, 0, 1]], law=contact, walls=[FLOOR])


def test_an_empty_region_is_refused() -> None:
    with pytest.raises(EmptyRegionError):
        grains([[0, 0, 1], [3, 0, 1]], law={bd.Everything(): ONE, bd.Within(bd.Ball(radius=0.1)): TWO})
