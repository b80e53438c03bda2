"""Beams that soften: two spheres against closed forms, and the ledger."""

import functools
import math
from pathlib import Path

import h5py
import numpy as np
import pytest

import bondem as bd
from bondem._tables.columns import SoftColumn
from bondem.dynamics.core_loop import CoreLoop
from bondem.errors import InputError
from tests.bits import assert_resumes_to, assert_same_bits, flying_apart, need_two_threads
from tests.models import crooked_beams, time_step
from tests.specimens import two_spheres

R, L, RADIUS = 0.5e-3, 1.05e-3, 0.35e-3
E, NU = 1e9, 0.3
AREA = math.pi * RADIUS**2
KN = E * AREA / L
FT, G_F, G_II = 1e6, 10.0, 30.0
# N_t² / 2 kn over G_f A: 0.05, so that a beam that is torn opens to 20 times where it begins.
LAW = bd.EulerBernoulli(E=E, nu=NU, radius=RADIUS)
PAIR = two_spheres(L, R)
VERLET = bd.VelocityVerlet()
CRITERION = bd.MohrCoulomb(
    tension=FT, cohesion=FT, friction_angle=0.5, fracture_energy=G_F, fracture_energy_shear=G_II
)


def pulled(direction: tuple[float, float], reach: float) -> bd.Model:
    """Two spheres, bonded, one held, the other moved by `reach` [m] without turning."""
    x, y = (bd.Ramp(0.0, reach * part, 1e-3) for part in direction)
    drive = bd.Drive(bd.Index([1]), x=x, y=y, z=0.0, rx=0.0, ry=0.0, rz=0.0)
    return bd.Model(PAIR, LAW, density=1000.0, failure=CRITERION, boundary=[bd.Fix(bd.Index([0])), drive])


def test_a_torn_beam_takes_up_its_fracture_energy(one_thread: None) -> None:
    """Peak f_t A; the force falls on a line to 2 G_f / f_t; G_f A in all, and a ledger that closes."""
    last = 2.0 * G_F / FT
    model = pulled((1.0, 0.0), 1.1 * last)
    dt = time_step(model, 0.2)
    gauges = {"grip": bd.Gauge(bd.Index([0]), "force", "sum")}
    run = bd.solve_explicit(model, duration=1e-3, dt=dt, every=1, gauges=gauges)
    energy = run.history.energy
    force = np.abs(np.asarray(run.history["grip"])[:, 0])
    opened = np.array([bd.Ramp(0.0, 1.1 * last, 1e-3).at(t) for t in run.history.time])
    first = FT * AREA / KN
    line = np.where(opened < first, KN * opened, FT * AREA * (last - opened) / (last - first)).clip(0.0)
    assert force == pytest.approx(line, abs=2e-2 * FT * AREA)
    assert run.history.released[-1] == pytest.approx(G_F * AREA, rel=1e-3)
    assert np.abs(energy["balance"]).max() < 1e-4 * G_F * AREA
    assert len(run.events) == 1
    assert run.state.integrity[0] == 0.0


def test_a_sheared_beam_takes_up_that_of_shear(one_thread: None) -> None:
    """G_II A, but for the part that the turning branch opens."""
    model = pulled((0.0, 1.0), 2.5e-4)
    dt = time_step(model, 0.2)
    run = bd.solve_explicit(model, duration=1e-3, dt=dt, every=1)
    energy = run.history.energy
    assert run.history.released[-1] == pytest.approx(G_II * AREA, rel=1e-3)
    assert np.abs(energy["balance"]).max() < 1e-4 * G_II * AREA
    assert run.state.integrity[0] == 0.0


def test_a_bond_that_snaps_back_is_refused() -> None:
    with pytest.raises(InputError, match="snap back above 2 E G_f / f_t²"):
        bd.Model(
            PAIR, LAW, density=1000.0,
            failure=bd.PeripheralStress(tension=1e8, shear=1e8, fracture_energy=G_F),
        )  # fmt: skip


#: 2 E G_f / f_t² is 3, the bonds are 1 to 2 long.
WEAK = bd.PeripheralStress(
    tension=2e5, shear=3e5, fracture_energy=600.0, fracture_energy_shear=1800.0,
    scatter=bd.Weibull(modulus=8.0, volume=0.1),
)  # fmt: skip
PULL = (bd.Fix(bd.Face("x_min", depth=0.5)), bd.Drive(bd.Face("x_max", depth=0.5), vx=bd.Ramp(0.0, 2.0, 0.02)))


def test_a_mixed_mode_takes_up_what_the_linear_rule_says(one_thread: None) -> None:
    """1 / (share_I / G_f + share_II / G_II), with the shares in the energy where softening begins."""
    model = pulled((1.0, 1.0), 5e-5)
    run = bd.solve_explicit(model, duration=1e-3, dt=time_step(model, 0.1), every=1)
    energy = run.history.energy
    begun = np.flatnonzero(run.history.released > 0.0)[0] - 1
    opening = energy["normal"][begun] + energy["bending"][begun]
    sliding = energy["shear"][begun] + energy["twisting"][begun]
    share = opening / (opening + sliding)
    assert 0.1 < share < 0.9
    expected = AREA / (share / G_F + (1.0 - share) / G_II)
    assert run.history.released[-1] == pytest.approx(expected, rel=5e-3)
    assert run.state.integrity[0] == 0.0


def test_unloaded_it_dissipates_nothing_and_presses_as_whole(one_thread: None) -> None:
    """Opened to a third of its last opening, closed, pressed by as much, and opened again."""
    first, last = FT * AREA / KN, 2.0 * G_F / FT
    reach = last / 3.0
    way = bd.Table((0.0, 1e-3, 3e-3, 5e-3), (0.0, reach, -reach, 0.99 * reach))
    drive = bd.Drive(bd.Index([1]), x=way, y=0.0, z=0.0, rx=0.0, ry=0.0, rz=0.0)
    model = bd.Model(PAIR, LAW, density=1e3, failure=CRITERION, boundary=[bd.Fix(bd.Index([0])), drive])
    gauges = {"grip": bd.Gauge(bd.Index([0]), "force", "sum")}
    dt = time_step(model, 0.2)
    history = bd.solve_explicit(model, duration=5e-3, dt=dt, every=1, gauges=gauges).history
    t, lost = history.time, history.released
    torn = lost[np.searchsorted(t, 1e-3)]
    assert torn == pytest.approx((reach - first) / (last - first) * G_F * AREA, rel=2e-3)
    assert np.ptp(lost[t > 1.001e-3]) == 0.0
    assert np.abs(history["grip"][:, 0]).max() == pytest.approx(KN * reach, rel=1e-2)
    assert np.abs(history.energy["balance"]).max() < 1e-4 * KN * reach**2


@pytest.mark.parametrize("turning", [0.0, 8e5])
@pytest.mark.parametrize("steps", [0.2, 0.9, 1.6, 3.2, 9.0])
def test_energy_does_not_depend_on_the_steps_of_an_opening(steps: float, turning: float, one_thread: None) -> None:
    """Heavy spheres fly apart and twist at constant speeds, from rest or pressed: λ0 λf, and a ledger that closes."""
    model = bd.Model(PAIR, LAW, density=1e12, failure=CRITERION)
    dt = time_step(model, 1e-3)
    speed = 2.0 * G_F / FT / (steps * dt)
    for pressed in (0.0, 0.3, 0.8):  # shares of a step
        state = model.state()
        state.displacement = np.array([[0.0] * 3, [-pressed * speed * dt, 0.0, 0.0]])
        state.velocity = np.array([[0.0] * 3, [speed, 0.0, 0.0]])
        state.angular_velocity = np.array([[0.0] * 3, [turning * speed, 0.0, 0.0]]) * 1e-3
        run = bd.solve_explicit(model, duration=(3.0 * steps + 6.0) * dt, dt=dt, every=1, state=state)
        energy, row = run.history.energy, run.state.softened[0]
        assert row[SoftColumn.SPENT] == pytest.approx(row[SoftColumn.FIRST] * row[SoftColumn.LAST], rel=5e-3)
        assert run.history.released[-1] == pytest.approx(row[SoftColumn.FIRST] * row[SoftColumn.LAST], rel=5e-3)
        assert np.abs(energy["balance"]).max() < 1e-9 * energy["translation"][0]
        if turning == 0.0:
            assert row[SoftColumn.SPENT] == pytest.approx(G_F * AREA, rel=5e-3)
            assert abs(run.events.opening_steps[0] - steps) < 1.5


@pytest.mark.parametrize("contact", [None, bd.LinearContact(E=1e8, friction=0.3)])
def test_torn_and_pressed_together_it_bears_as_whole(contact: bd.LinearContact | None, one_thread: None) -> None:
    """By itself, or by the contact that takes over with the stiffness of the bond; the ledger closes through both."""
    last = 2.0 * G_F / FT
    way = bd.Table((0.0, 1e-3, 2e-3), (0.0, 1.1 * last, -0.2 * last))
    drive = bd.Drive(bd.Index([1]), x=way, y=0.0, z=0.0, rx=0.0, ry=0.0, rz=0.0)
    model = bd.Model(
        PAIR, LAW, density=1e3, failure=CRITERION, contact=contact,
        boundary=[bd.Fix(bd.Index([0])), drive],
    )  # fmt: skip
    gauges = {"grip": bd.Gauge(bd.Index([0]), "force", "sum")}
    dt = time_step(model, 0.2)
    history = bd.solve_explicit(model, duration=2e-3, dt=dt, every=1, gauges=gauges).history
    moved = np.interp(history.time, *way.table)
    pressed = history.time > 1e-3
    force = KN * np.minimum(moved[pressed], 0.0)
    assert np.abs(history["grip"][pressed, 0]) == pytest.approx(np.abs(force), abs=2e-3 * KN * 0.2 * last)
    assert np.abs(history.energy["balance"]).max() < 1e-4 * G_F * AREA


def test_a_body_that_bursts_in_few_steps_has_the_energy_of_its_beams(one_thread: None) -> None:
    """Beams that open, slide, bend and twist at once, within one or two steps: λ0 λf each, and a closed ledger."""
    model = crooked_beams(4, WEAK, E=1e8)
    rng, dt = np.random.default_rng(3), time_step(model, 0.9)
    for steps, share in ((0.5, 0.02), (1.0, 0.01)):
        state = model.state()
        length = np.median(model.bonds.length)
        speed = 2.0 * WEAK.fracture_energy / WEAK.tension / (steps * dt)
        apart = model.lattice.centre - model.lattice.centre.mean(axis=0)
        state.velocity = speed * (apart / length + 0.3 * rng.normal(size=apart.shape))
        state.angular_velocity = 0.3 * speed / length * rng.normal(size=apart.shape)
        run = bd.solve_explicit(model, duration=20.0 * steps * dt, dt=dt, every=1, state=state)
        rows, energy = run.state.softened, run.history.energy
        rows = rows[run.state.integrity[rows[:, SoftColumn.BOND].astype(int)] == 0.0]
        assert len(rows) > 100
        whole = (rows[:, SoftColumn.FIRST] * rows[:, SoftColumn.LAST]).sum()
        assert rows[:, SoftColumn.SPENT].sum() == pytest.approx(whole, rel=share)
        # the work of whole beams is exact to their strain in a step
        assert np.abs(energy["balance"]).max() < 0.5 * speed * dt / length * energy["translation"][0]


@pytest.mark.parametrize("contact", [None, bd.LinearContact(E=1e8, friction=0.3)])
def test_forces_are_the_gradient_of_one_energy(contact: bd.LinearContact | None, one_thread: None) -> None:
    """Of beams of any integrity, opened or pressed, turned and slid; beside a contact none is broken."""
    model = crooked_beams(3, WEAK, E=1e8, contact=contact)
    rng = np.random.default_rng(2)
    state, n, m = model.state(), 27, len(model.lattice.pairs)
    state.integrity[:] = rng.uniform(0.2, 1.0, m) if contact else rng.choice([0.0, 0.5, 0.9, 1.0], m)
    begun = np.flatnonzero(state.integrity < 1.0)
    state.softened = np.zeros((len(begun), SoftColumn.COUNT))
    state.softened[:, 0], state.softened[:, 1], state.softened[:, 2] = begun, 1e6, 1e7
    place = model.lattice.centre + rng.uniform(-0.03, 0.03, (n, 3))
    q = np.hstack([np.ones((n, 1)), rng.uniform(-0.02, 0.02, (n, 3))])
    q /= np.linalg.norm(q, axis=1, keepdims=True)

    def look(moved: np.ndarray) -> tuple[float, np.ndarray]:
        now = state.copy()
        now.set_pose(position=place + moved, orientation=q)
        loop = CoreLoop(model, bd.Plan(duration=1.0, dt=1e-9, every=1), now, 1e-9)
        energy = bd.History(loop.record_present()).energy
        own = sum(float(energy[part][0]) for part in ("normal", "shear", "bending", "twisting", "contact"))
        return own, (now.acceleration[:, :3] / now.motion[:, 3:4])[model.layout.rank]

    _, force = look(np.zeros((n, 3)))
    for p, d in ((0, 0), (13, 1), (13, 2), (20, 0)):
        step = np.zeros((n, 3))
        step[p, d] = 1e-5
        slope = (look(step)[0] - look(-step)[0]) / 2e-5
        assert slope == pytest.approx(-force[p, d], rel=1e-5, abs=1e-6 * np.abs(force).max())


@pytest.mark.parametrize("scheme", [bd.VelocityVerlet(), bd.TchamwaWielgosz()])
def test_the_ledger_is_second_order(scheme: bd.Scheme, one_thread: None) -> None:
    """A block that is torn: a hundred beams soften, some part."""
    model = crooked_beams(5, WEAK, E=1e8, boundary=PULL)
    dt = time_step(model, 0.4)
    missed = []
    for count in (1, 2, 4):
        run = bd.solve_explicit(model, duration=1000 * dt, dt=dt / count, every=count, scheme=scheme)
        missed.append(np.sqrt((run.history.energy["balance"] ** 2).mean()) / run.history.energy["work"].max())
    assert len(run.state.softened) > 50
    assert 0 < len(run.events) < len(run.state.softened)
    if isinstance(scheme, bd.VelocityVerlet):
        assert missed[0] < 5e-4
        assert np.log2(missed[0] / missed[2]) / 2.0 > 1.7


@pytest.mark.validate
@pytest.mark.filterwarnings("ignore::bondem.errors.NotQuasistaticWarning")
def test_the_same_bits_however_it_is_run(tmp_path: Path) -> None:
    """On one and two threads, with pauses, resumed from a file, with contacts between what has parted."""
    need_two_threads()
    drive = bd.Drive(bd.Face("x_max", depth=0.5), vx=bd.Ramp(0.0, 20.0, 0.02), wx=2.0)
    model = crooked_beams(14, WEAK, E=1e8, boundary=(PULL[0], drive), contact=bd.LinearContact(E=1e8, friction=0.3))
    run = flying_apart(model)
    whole = run(1, 100)
    assert len(whole.state.softened) > 2000
    assert len(whole.events) > 500
    assert_same_bits(whole, run(2, 7))
    assert_resumes_to(whole, functools.partial(run, 2, 100, save_every=97), tmp_path / "run.h5", 0.5)


@pytest.mark.parametrize(
    ("what", "options", "line"),
    [
        (bd.PeripheralStress, {"tension": 1.0, "shear": 1.0, "fracture_energy": -1.0}, "positive energy"),
        (bd.PeripheralStress, {"tension": 1.0, "shear": 1.0, "fracture_energy_shear": 1.0}, "fracture_energy too"),
        (bd.PeripheralStress, {"tension": 1.0, "shear": 1.0, "fracture_energy": math.nan}, "positive energy"),
    ],
)
def test_energies_that_cannot_be_are_refused(what: type, options: dict, line: str) -> None:
    with pytest.raises(InputError, match=line):
        what(**options)


@pytest.mark.parametrize(
    ("failure", "options", "line"),
    [
        ({"dilatancy": 0.1}, {}, "dilatancy applies to cells"),
        ({"fracture_energy_shear": math.inf}, {}, "give beams a number"),
        ({}, {"contact": bd.LinearContact(E=1e7, stress_free=False)}, "stress_free=True"),
        ({}, {"contact": bd.LinearContact(E=1e7, parallel=True)}, "leave out parallel="),
        ({}, {"boundary": [bd.Eigenstrain(1e-3)]}, "Eigenstrain does not apply to beams that soften"),
        ({"fracture_energy_shear": 1e-6}, {}, "fracture_energy_shear"),
    ],
)
def test_what_beams_that_soften_cannot_have_is_refused(failure: dict, options: dict, line: str) -> None:
    own = {"tension": FT, "cohesion": FT, "friction_angle": 0.5, "fracture_energy": G_F} | failure
    with pytest.raises(InputError, match=line):
        bd.Model(PAIR, LAW, density=1e3, failure=bd.MohrCoulomb(**own), **options)


def test_a_run_file_of_before_is_read(tmp_path: Path) -> None:
    """Schema 5 knows no beams that soften: none had begun."""
    model = pulled((1.0, 0.0), 1e-6)
    bd.solve_explicit(model, duration=1e-5, out=tmp_path / "run.h5")
    with h5py.File(tmp_path / "run.h5", "a") as file:
        assert file.attrs["schema"] > 5
        file.attrs["schema"] = 5
        for name in ("softened", "broken", "cracks", "stretch", "walls"):
            del file[f"state/{name}"]
        file["state/broken"], file["state/cracks"] = np.zeros((0, 9)), np.zeros((0, 13))
        file["state/stretch"], file["state/walls"] = np.zeros((0, 6)), np.zeros((0, 14))
    read = bd.read_run(tmp_path / "run.h5")
    assert read.state.softened.shape == (0, SoftColumn.COUNT)
    assert read.model.failure == CRITERION
