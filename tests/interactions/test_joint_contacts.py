"""Cells that touch by the faces of facets that have parted: joints slide, and whatever they do costs no energy."""

import functools
import math
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem._tables.columns import CrackStatus
from bondem.damage.crack_columns import STATUS
from bondem.errors import ContactWarning
from bondem.interactions.contact.contact_columns import KIND
from tests.bits import EnoughError, assert_same_bits, digest, threads
from tests.models import momenta, moving
from tests.specimens import cubes, two_cubes

pytestmark = pytest.mark.filterwarnings("ignore::bondem.errors.StrengthWarning")

E, RHO, SIDE, MU, PRESSURE = 20e9, 2400.0, 1e-3, 0.5, 4e6
LAWS = {
    "LinearContact": bd.LinearContact(E=E, friction=MU),
    "HertzMindlin": bd.HertzMindlin(E=E, nu=0.2, friction=MU),
}
STRONG = bd.MohrCoulomb(tension=80e6, cohesion=300e6, friction_angle=math.atan(MU), fracture_energy=1e4)
WEAK = bd.MohrCoulomb(
    tension=1e5, cohesion=2e5, friction_angle=math.atan(MU), fracture_energy=1.0, fracture_energy_shear=2.0
)


def slid(
    press: str, contact: bd.ContactLaw | None, edges: float = 1.3, *, body: bd.Lattice | None = None, **more: object
) -> bd.ExplicitResult:
    """Two layers of cubes with a joint between them, or another body of this size, whose upper half slides."""
    length, height = 6 * SIDE, 2 * SIDE
    body = cubes((6, 2, 2), SIDE) if body is None else body
    low, up = (bd.Within(bd.Box((length, 2 * SIDE, SIDE)).moved((0, 0, z))) for z in (0.0, SIDE))
    rise, top = 100 * height / math.sqrt(E / RHO), bd.Face("z_max")
    duration = 60 * edges * rise
    slide = bd.Ramp(0, edges * SIDE / (duration - 1.7 * rise), 0.5 * rise, begin=1.2 * rise)
    pressing = [bd.Drive(top, vx=slide, vy=0.0), bd.Pressure(top, PRESSURE, schedule=bd.Ramp(0, 1, rise))]
    if press == "held":
        pressing = [bd.Drive(top, z=bd.Ramp(0, -PRESSURE / E * height, rise), vx=slide, vy=0.0)]
    model = bd.Model(
        body, bd.CellBond(E=E, nu=0.0), density=RHO, contact=contact,
        failure={bd.Everything(): STRONG, (low, up): WEAK}, boundary=[bd.Fix(bd.Face("z_min")), *pressing],
    )  # fmt: skip
    gauges = {"force": bd.Gauge(bd.Face("z_min"), "force"), "moved": bd.Gauge(top, "displacement")}
    options = {"every": 50, "gauges": gauges} | more
    damping = bd.MassDamping(math.pi * math.sqrt(E / RHO) / length)
    return bd.solve_explicit(model, duration=duration, damping=damping, **options)


@pytest.mark.parametrize(("press", "law"), [("held", "LinearContact"), ("dead", "HertzMindlin")])
def test_a_joint_slides_with_its_friction(press: str, law: str, one_thread: None) -> None:
    """T = p tan φ of what overlaps, past the next cells: faces slide on faces, not spheres over spheres."""
    run = slid(press, LAWS[law])
    assert (run.state.cracks[:, STATUS] == CrackStatus.PARTED).sum() == 12
    stress = run.history["force"] / (12 * SIDE**2) / PRESSURE
    slip = run.history["moved"][:, 0] / SIDE
    sliding = slip > 0.6
    carried = 1.0 - slip[sliding] / 6.0 if press == "held" else 1.0
    assert -stress[sliding, 0] / MU / carried == pytest.approx(1.0, abs=0.1)
    np.testing.assert_allclose(-stress[sliding, 0], MU * stress[sliding, 2], rtol=0.03)
    within = run.state.bond_integrity == 1.0
    assert within.sum() == len(within) - 12
    energy = run.history.energy
    assert np.ptp(energy["balance"]) < 1e-4 * energy["work"].max()


def test_a_held_joint_of_irregular_cells_presses_where_faces_overlap(one_thread: None) -> None:
    """Centroids of irregular faces lie beside the centres of their cells; the faces overlap further than of cubes."""
    joint = bd.Plane(point=(0, 0, SIDE), normal=(0, 0, 1))
    packing = bd.pack(bd.Box((6 * SIDE, 2 * SIDE, 2 * SIDE)), count=96, method="even", seed=1, around=joint)
    run = slid("held", LAWS["LinearContact"], 1.3, body=bd.connect(packing, method="laguerre"))
    slip = run.history["moved"][:, 0] / SIDE
    pressed = run.history["force"][:, 2] / (12 * SIDE**2) / PRESSURE / (1.0 - slip / 6.0)
    assert pressed[slip > 0.9].mean() == pytest.approx(1.0, abs=0.05)


def test_without_contact_a_joint_says_that_it_carries_nothing() -> None:
    said = "joint slid off each other .*12 facets.*pass contact=bd.LinearContact"
    with pytest.warns(ContactWarning, match=said):
        run = slid("held", None)
    assert abs(run.history["force"][-1, 2]) < 1e-3 * PRESSURE * 12 * SIDE**2


@pytest.mark.parametrize("law", [bd.LinearContact(E=E), LAWS["LinearContact"]], ids=["smooth", "rough"])
def test_faces_that_meet_beside_each_other_conserve_what_they_must(law: bd.ContactLaw, one_thread: None) -> None:
    """Two cubes whose faces have parted meet again, shifted by 0.6 edges and turned: an exact gradient."""
    model = bd.Model(
        two_cubes(SIDE), bd.CellBond(E=E, nu=0.0), density=RHO, contact=law,
        failure={bd.Everything(): STRONG, (bd.Index(0), bd.Index(1)): WEAK},
    )  # fmt: skip
    thrown = moving(model, [[-20.0, 0.0, 0.0], [20.0, 0.0, 0.0]])
    state = bd.solve_explicit(model, duration=1.5 * SIDE / 20.0, dt=4e-9, state=thrown).state  # the crack opens fully
    centre = model.lattice.centre + np.array([[0.0, 0.0, 0.0], [0.02 * SIDE, 0.6 * SIDE, 0.1 * SIDE]])
    half = 0.05
    turned = [[math.cos(half), math.sin(half), 0.0, 0.0], [math.cos(half), 0.0, 0.0, math.sin(half)]]
    state.set_pose(position=centre, orientation=np.array(turned))
    spin = [[0.0, 900.0, 0.0], [0.0, 0.0, -400.0]]
    state.set_motion(velocity=[[3.0, 1.0, 0.0], [-3.0, 0.0, 0.5]], angular_velocity=spin)
    before = momenta(model, state)
    run = bd.solve_explicit(model, duration=2e-5, dt=4e-9, every=1, state=state)
    assert run.state.cracks[0, STATUS] == CrackStatus.PARTED
    energy, after = run.history.energy, momenta(model, run.state)
    assert energy["contact"].max() > 0.1 * energy["translation"][0]
    assert energy["contact"][-1] == 0.0
    for one, other in zip(before, after, strict=True):
        np.testing.assert_allclose(other, one, atol=1e-9 * np.abs(one).max())
    assert np.abs(run.state.angular_velocity - spin).max() > 100.0
    swings = 2.0 * float(model.bonds.kn[0] / model.mass[0])  # ω² of the two cells on the spring of their facet
    assert np.ptp(energy["balance"]) < swings * 4e-9**2 / 4.0 * energy["translation"][0]


@pytest.mark.validate
def test_bits_of_a_joint_do_not_depend_on_threads_pauses_or_lists(tmp_path: Path) -> None:
    """Pairs that touch by faces continue from a file."""
    run = functools.partial(slid, "dead", LAWS["LinearContact"], every=500)

    def stop(done: float) -> None:
        if done > 0.8:
            raise EnoughError

    with threads(1):
        whole = run(out=tmp_path / "whole.h5")
        with pytest.raises(EnoughError):
            run(out=tmp_path / "cut.h5", save_every=500, progress=stop)
        assert (bd.read_run(tmp_path / "cut.h5").state.stretch[:, KIND] > 0.0).sum() > 10
        assert_same_bits(whole, bd.resume(tmp_path / "cut.h5"))
    with threads(4):
        assert digest(run()) == digest(whole)


@pytest.mark.parametrize(
    "seed", [1, pytest.param(2, marks=pytest.mark.validate), pytest.param(3, marks=pytest.mark.validate)]
)
def test_an_oblique_joint_slides_at_jaegers_strength(seed: int, one_thread: None) -> None:
    """Jaeger (1960): σ = c / (sin β cos β - tan φ cos² β), and nothing once c is gone, as β > φ."""
    length, width, beta, phi, cohesion = 30e-3, 12e-3, math.radians(60), math.radians(30), 2e6
    plane = bd.Plane(point=(length / 2, width / 2, width / 2), normal=(math.cos(beta), 0.0, math.sin(beta)))
    box = bd.Box((length, width, width))
    packing = bd.pack(box, count=200, method="even", seed=seed, around=plane, cache=False)
    rock = bd.MohrCoulomb(tension=10e6, cohesion=40e6, friction_angle=0.6, fracture_energy=500.0)
    weak = bd.MohrCoulomb(tension=1e6, cohesion=cohesion, friction_angle=phi, fracture_energy=1.5)
    press = bd.Table([0.0, 1.5e-3], [0.0, -2e-3 * length])
    model = bd.Model(
        bd.connect(packing, method="laguerre"), bd.CellBond(E=E, nu=0.2), RHO,
        boundary=[bd.Fix(bd.Face("x_min"), "x", ""), bd.Drive(bd.Face("x_max"), x=press)],
        failure={bd.Everything(): rock, (plane, bd.Everything() - plane): weak},
        contact=bd.LinearContact(E=E, friction=math.tan(phi)),
    )  # fmt: skip
    gauges = {"force": bd.Gauge(bd.Face("x_max"), "force")}
    run = bd.solve_explicit(model, duration=1.5e-3, every=50, damping=bd.MassDamping(2e4), gauges=gauges)
    stress = -run.history["force"][:, 0] / width**2
    strength = cohesion / (math.sin(beta) * math.cos(beta) - math.tan(phi) * math.cos(beta) ** 2)
    assert stress.max() == pytest.approx(strength, rel=0.05)
    assert abs(stress[-1]) < 0.02 * strength  # it locked at twice the strength
