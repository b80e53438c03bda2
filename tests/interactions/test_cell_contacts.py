"""Pieces of cells that touch: they meet where they parted, with a ledger that closes, bit by bit."""

import functools
import math
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem._tables.columns import CrackStatus
from bondem.damage.crack_columns import FACET, STATUS, TOP
from bondem.errors import InputError
from tests.bits import assert_resumes_to, digest, threads
from tests.models import moving, time_step
from tests.scripts import python
from tests.specimens import ball, bar, two_cubes

E, NU, RHO = 30e9, 0.2, 2400.0
SIDE = 1e-3
CONTACT = bd.LinearContact(E=E, friction=0.4)
FAILURES = {
    "brittle": bd.MohrCoulomb(tension=4e6, cohesion=14e6, friction_angle=0.61),
    "softening": bd.MohrCoulomb(tension=4e6, cohesion=14e6, friction_angle=0.61, fracture_energy=100.0),
}


def impact(failure: bd.Criterion, speed: float, count: int = 1000):
    """A ball that is about to meet a plane."""
    wall = bd.PlaneWall(point=(-0.05, 0.0, 0.0), normal=(1.0, 0.0, 0.0))
    law = bd.CellBond(E=E, nu=NU)
    model = bd.Model(ball(count, 0.05), law, density=RHO, failure=failure, contact=CONTACT, walls=[wall])
    return model, moving(model, np.tile([-speed, 0.0, 0.0], (count, 1)))


@pytest.mark.parametrize("failure", FAILURES)
def test_two_cells_that_parted_collide_as_a_spring_of_their_facet(failure: str, one_thread: None) -> None:
    """They meet at their rest length with the spring k of the facet, and part as fast: half a period of it."""
    criterion = FAILURES["brittle"] if failure == "brittle" else bd.Rankine(tension=4e6, fracture_energy=100.0)
    model = bd.Model(two_cubes(SIDE), bd.CellBond(E=E, nu=NU), density=RHO, failure=criterion, contact=CONTACT)
    state = moving(model, [[-20.0, 0.0, 0.0], [20.0, 0.0, 0.0]])
    apart = bd.solve_explicit(model, duration=1.5 * SIDE / 20.0, state=state)
    assert len(apart.events) == 1
    gap = apart.state.position[1, 0] - apart.state.position[0, 0] - SIDE
    assert gap > SIDE
    assert not len(apart.state.touching)
    back = apart.state
    back.set_motion(velocity=[[10.0, 0.0, 0.0], [-10.0, 0.0, 0.0]])
    if failure == "softening":  # else the faces of the crack would meet as such
        half = 0.25 * math.pi
        back.set_pose(orientation=np.array([[1.0, 0.0, 0.0, 0.0], [math.cos(half), 0.0, 0.0, math.sin(half)]]))
    k, mass = float(model.bonds.kn[0]), float(model.mass[0])
    contact = math.pi * math.sqrt(mass / (2.0 * k))
    dt = contact / 200.0
    assert dt < time_step(model, 1.0)
    meeting = gap / 20.0
    run = bd.solve_explicit(model, duration=1.02 * meeting + contact, dt=dt, every=1, state=back)
    touching = run.history.time[run.history.energy["contact"] > 0.0] - back.time
    assert touching[0] == pytest.approx(meeting, abs=2 * dt)
    assert touching[-1] - touching[0] == pytest.approx(contact, rel=0.01)
    deepest = run.history.energy["contact"].max()
    assert deepest == pytest.approx(2 * 0.5 * mass * 10.0**2, rel=1e-4)
    np.testing.assert_allclose(run.state.velocity[:, 0], [-10.0, 10.0], rtol=1e-4)
    assert run.residual < (math.pi / 200.0) ** 2 / 4.0  # (ω dt)²/8 of the energy, and as much for the edges


@pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")
@pytest.mark.parametrize(
    ("failure", "speed", "closes"), [
        ("softening", 20.0, 3e-4),
        pytest.param("brittle", 20.0, 1e-3, marks=pytest.mark.validate),
        pytest.param("softening", 100.0, 1e-3, marks=pytest.mark.validate),
    ],
)
def test_the_ledger_closes_through_an_impact(failure: str, speed: float, closes: float) -> None:
    """Hundreds of pieces or dust, more friction than fracture: what there was is there."""
    model, state = impact(FAILURES[failure], speed)
    run = bd.solve_explicit(model, duration=4e-4, state=state, safety=0.45)
    energy = run.history.energy
    there = energy["translation"][0]
    assert np.ptp(energy["balance"]) < closes * there
    assert energy["friction"][-1] > 0.02 * there
    assert len(bd.fragments(model.lattice, run.state)) > 50


@pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")
def test_pieces_that_parted_under_pressure_touch_without_a_jump() -> None:
    """From where they are, if that is nearer than at rest."""
    model, state = impact(FAILURES["softening"], 100.0)
    run = bd.solve_explicit(model, duration=2e-4, state=state)
    parted = run.state.cracks[run.state.cracks[:, STATUS] == CrackStatus.PARTED]
    assert len(parted) > 100
    rest = model.bonds.length[parted[:, FACET].astype(int)]
    assert (parted[:, TOP] <= rest).all()
    assert (parted[:, TOP] < 0.99 * rest).sum() > 10
    assert (parted[:, TOP] == rest).sum() > 10


def shattered(failure: str, **more: object) -> bd.ExplicitResult:
    """A ball that shatters on a wall at 30 m/s."""
    model, state = impact(FAILURES[failure], 30.0)
    return bd.solve_explicit(model, duration=2e-4, state=state, **more)


ON_FOUR = """
from tests.bits import threads
from tests.bits import digest
from tests.interactions.test_cell_contacts import FAILURES, shattered

for failure in FAILURES:
    with threads(4):
        print(digest(shattered(failure, every=25)))
"""


@pytest.mark.validate
def test_bits_do_not_depend_on_threads_pauses_or_restarts(tmp_path: Path) -> None:
    """On 1 and 4 threads, the latter in a process of their own."""
    expected: list[str] = []
    with threads(1):
        for failure in FAILURES:
            whole = shattered(failure, every=40, out=tmp_path / f"{failure}.h5")
            assert len(whole.state.touching) or (whole.history.energy["contact"] > 0.0).any()
            assert len(whole.events) > 1000
            run = functools.partial(shattered, failure, every=40, save_every=40)
            assert_resumes_to(whole, run, tmp_path / f"{failure} cut.h5", share=0.5)
            expected.append(digest(whole))
    assert python(ON_FOUR) == expected


def test_cells_touch_where_they_parted_and_not_as_spheres() -> None:
    loose = bd.LinearContact(E=E, stress_free=False)
    with pytest.raises(InputError, match="stress_free=True"):
        bd.Model(two_cubes(SIDE), bd.CellBond(E=E, nu=NU), density=RHO, failure=FAILURES["brittle"], contact=loose)


@pytest.mark.validate
def test_platens_in_contact_crush_a_specimen_at_its_strength() -> None:
    """Compression between smooth walls: the strength of a Mohr–Coulomb material, 7 % less at most."""
    failure, length = bd.MohrCoulomb(tension=4e6, cohesion=14e6, friction_angle=0.61, fracture_energy=50.0), 0.1
    strength = 2.0 * 14e6 * math.cos(0.61) / (1.0 - math.sin(0.61))
    sound = math.sqrt(E / RHO)
    rise = 60.0 * length / sound
    pushed = bd.Driven(vx=bd.Ramp(0.0, -1.6 * strength / E * length / rise, 0.2 * rise))
    walls = [bd.PlaneWall((0, 0, 0), (1, 0, 0)), bd.PlaneWall((length, 0, 0), (-1, 0, 0), motion=pushed)]
    contact = bd.LinearContact(E=4.0 * E)
    model = bd.Model(bar(1000, length), bd.CellBond(E=E, nu=NU), RHO, failure=failure, contact=contact, walls=walls)
    run = bd.solve_explicit(
        model, duration=1.5 * rise, every=200, damping=bd.MassDamping(alpha=0.2 * math.pi * sound / length),
        gauges={"far": bd.WallGauge(1, "force"), "near": bd.WallGauge(0, "force")},
    )  # fmt: skip
    for wall in ("far", "near"):
        stress = np.abs(run.history[wall][:, 0]) / (0.5 * length) ** 2
        assert 0.93 * strength < stress.max() < 1.02 * strength
        assert stress[-1] < 0.9 * stress.max()
    assert np.ptp(run.history.energy["balance"]) < 1e-3 * run.history.energy["work"].max()


def test_dashpots_leave_a_step_that_does_not_go_by_the_smallest_facet() -> None:
    """A ball of 300 brittle cells: facets differ a thousandfold in area, and the step is as long as it has to be."""
    steps, model = [], None
    for damping in (0.0, 0.1):
        law = bd.LinearContact(E=E, friction=0.4, damping=damping)
        model = bd.Model(
            ball(300, 0.05), bd.CellBond(E=E, nu=NU), density=RHO, failure=FAILURES["brittle"], contact=law,
            walls=[bd.PlaneWall(point=(-0.05, 0.0, 0.0), normal=(1.0, 0.0, 0.0))],
        )  # fmt: skip
        steps.append(time_step(model, 1.0))
    assert 0.2 * steps[0] < steps[1] < steps[0]
    assert model is not None
    state = moving(model, np.tile([-20.0, 0.0, 0.0], (300, 1)))
    run = bd.solve_explicit(model, duration=2000 * 0.9 * steps[1], dt=0.9 * steps[1], every=100, state=state)
    assert len(run.events) > 100  # it comes to pieces, which touch
    energy = run.history.energy
    there = energy["translation"][0]
    assert energy["loss"][-1] > 0.01 * there
    assert np.ptp(energy["balance"]) < 1e-3 * there
