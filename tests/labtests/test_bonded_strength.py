"""Tests to failure of bonded spheres: closed forms of crystals, equilibrium with the platens, and scaling."""

import math
from typing import Any

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError, NotQuasistaticWarning, StrengthWarning
from tests.specimens import cells, spheres

E, RADIUS = 50e9, 0.5e-3
LAW = bd.ParallelBond(E=E, nu=0.2, radius_ratio=1.0)
STRENGTH = bd.PeripheralStress(tension=20e6, shear=40e6)
PIN = bd.Cylinder(radius=3e-3, length=9e-3)
PUNCH = bd.labtests.punch_specimen(diameter=20e-3, height=10e-3, ring=8e-3, width=2e-3, depth=1.5e-3)


def crystal(nx: int, ny: int, nz: int) -> bd.Lattice:
    """Touching equal spheres on a cubic grid that fill a box."""
    centre = 2.0 * RADIUS * (np.indices((nx, ny, nz)).reshape(3, -1).T + 0.5)
    box = bd.Box((2.0 * RADIUS * nx, 2.0 * RADIUS * ny, 2.0 * RADIUS * nz))
    return bd.connect(bd.Particles(centre, RADIUS, shape=box), tolerance=1e-6)


def disc(count: int, half: float = 0.0) -> bd.Lattice:
    """Disc of 8 mm diameter, plain or with flats of half an angle [rad]."""
    radius, length = 4e-3, 3e-3
    shape: bd.Shape = bd.Cylinder(radius=radius, length=length)
    if half:
        size, at = (2.0 * length, radius, 4.0 * radius), radius * math.cos(half)
        for name, y in (("top", at), ("bottom", -at - radius)):
            shape = shape.cut(bd.Box(size).moved((-0.5 * length, y, -2.0 * radius)), name=name)
    return spheres(shape, count)


def test_a_crystal_is_torn_at_the_strength_of_its_bonds() -> None:
    """Columns along x of bonds of section π r² in a square of 4 r²: E π/4, and 20 MPa π/4."""
    test = bd.labtests.direct_tension(crystal(9, 4, 4), LAW, STRENGTH)
    assert test.peak == pytest.approx(20e6 * math.pi / 4.0, rel=0.02)
    assert pytest.approx(E * math.pi / 4.0, rel=2e-3) == test.E
    assert test.cracking.broken >= 16  # whole sections of 16 bonds
    assert test.cracking.broken % 16 == 0
    assert test.unbalance < 0.02
    assert test.residual < 5e-3


def test_a_crystal_beam_breaks_at_the_load_of_statics() -> None:
    """The first bond breaks at the load at which linear statics has an index of 1; what follows is dynamic."""
    d, rows = 2.0 * RADIUS, 4
    span, body = 16 * d, crystal(21, rows, 3)
    test = bd.labtests.three_point_bending(body, LAW, STRENGTH, span=span)
    x, height, _ = np.round(body.centre.T / d - 0.5).astype(int)
    supports = bd.Index(np.flatnonzero((height == 0) & ((x == 2) | (x == 18))))
    boundary = [
        bd.Fix(supports, translation="y", rotation=""), bd.Fix(bd.Index([0]), translation="xz", rotation="x"),
        bd.Load(bd.Index(np.flatnonzero((height == rows - 1) & (x == 10))), force=(0.0, -1.0, 0.0)),
    ]  # fmt: skip
    at_rest = bd.solve_static(bd.Model(body, LAW, 1.0, boundary=boundary))
    index = bd.failure_index(bd.Model(body, LAW, 1.0, failure=STRENGTH, boundary=boundary), at_rest)
    assert isinstance(test.path, bd.ExplicitResult)
    history, first = test.path.history, test.path.events.time.min()
    assert np.interp(first, history.time, test.load) == pytest.approx(1.0 / index.max(), rel=0.01)
    assert test.peak == pytest.approx(1.5 * test.load.max() * span / (3.0 * d * (rows * d) ** 2), rel=1e-9)
    near, far = history["near"][:, 1] + history["near 2"][:, 1], history["far"][:, 1]
    top = int(np.argmax(test.load))
    assert far[top] == pytest.approx(-near[top], rel=0.1)
    assert test.cracking.mode == "cracks once"
    assert test.cracking.pieces == 2


def test_compression_has_the_modulus_and_the_stress_of_the_specimen() -> None:
    """E is that of static tension, and before anything breaks the mean stress is that of the platens."""
    body = spheres(PIN, 300)
    test = bd.labtests.uniaxial_compression(body, LAW, STRENGTH)
    assert pytest.approx(bd.labtests.static_tension(body, LAW).E, rel=0.03) == test.E
    assert 20e6 < test.peak < 100e6
    assert test.curve[-1, 1] < 0.5 * test.peak
    assert test.cracking.broken == len(test.cracking.found) > 50
    assert test.unbalance < 0.02
    assert test.residual < 5e-3
    with pytest.warns(StrengthWarning, match="still rises"):
        slow = bd.labtests.uniaxial_compression(body, LAW, STRENGTH, reach=0.2)
    lattice = test.state.model.lattice
    stress = bd.element_stress(slow.state.model, slow.state)
    virial = float((stress.volume * stress.stress[:, 0, 0]).sum())
    reach = lattice.centre[:, 0]
    arm = reach.max() - reach.min()  # platens press on the outermost spheres
    force = slow.curve[-1, 1] * body.particles.envelope.section()
    assert -virial == pytest.approx(force * arm, rel=0.05)


def test_strengths_scale_with_those_of_the_bonds_and_not_with_the_density() -> None:
    """A brittle lattice has no length of its own: strengths and speed twice as large, but for rotations of 1e-3."""
    body = spheres(PIN, 300)
    twice = bd.PeripheralStress(tension=40e6, shear=80e6)
    usual, strong, heavy = (
        bd.labtests.direct_tension(body, LAW, one, density=rho)
        for one, rho in ((STRENGTH, None), (twice, None), (STRENGTH, 9e3))
    )
    assert strong.peak == pytest.approx(2.0 * usual.peak, rel=0.02)
    assert heavy.peak == pytest.approx(usual.peak, rel=1e-3)


@pytest.mark.validate
def test_rough_platens_and_pressure_strengthen() -> None:
    squat = spheres(bd.Cylinder(radius=3e-3, length=4e-3), 200)
    smooth, rough = (
        bd.labtests.uniaxial_compression(squat, LAW, STRENGTH, platen_friction=mu).peak for mu in (0.0, 1.0)
    )
    assert rough > 1.1 * smooth
    confined = bd.labtests.triaxial(squat, LAW, STRENGTH, pressure=10e6)
    assert confined.peak > smooth + 10e6
    assert confined.deviator == confined.peak - 10e6
    run = confined.test.run
    ((_, wanted),) = run.quasistatic.servo.values()
    assert wanted == pytest.approx(10e6 * math.pi * 6e-3 * 4e-3, rel=1e-12)


def test_confining_walls_press_with_the_pressure() -> None:
    pressure = 4e6
    body = spheres(bd.Box((6e-3, 4e-3, 4e-3)), 200)
    strong = bd.PeripheralStress(tension=2e8, shear=4e8)
    with pytest.warns((NotQuasistaticWarning, StrengthWarning)):  # the load of so short a test is small, and rises
        test = bd.labtests.triaxial(body, LAW, strong, pressure=pressure, reach=0.3, traverses=30.0)
    for force, wanted in test.test.run.quasistatic.servo.values():
        assert wanted == pytest.approx(pressure * 24e-6, rel=1e-12)
        assert force == pytest.approx(wanted, rel=0.05)


@pytest.mark.parametrize("flats", [pytest.param(0.0, marks=pytest.mark.validate), 15.0])
def test_a_disc_is_split_between_strips_and_between_flats(flats: float) -> None:
    test = bd.labtests.brazilian(disc(300, math.radians(flats)), LAW, STRENGTH)
    assert test.half_angle == pytest.approx(math.radians(flats or 10.0), rel=0.02 if flats else 0.7)
    assert 4e6 < test.tension < 14e6
    assert test.test.residual < 5e-3
    lost = np.abs(test.cracking.found.normal[:, 2])
    assert (lost > 0.5).mean() > 0.4  # cracks open across the load


@pytest.mark.validate
def test_the_centre_of_a_disc_has_the_stress_of_stamps() -> None:
    """Mean of three packings of 700 spheres; single ones differ by up to a fifth."""
    shape = bd.Cylinder(radius=10e-3, length=8e-3)
    found = [
        bd.labtests.brazilian(spheres(shape, 700, seed=seed), LAW, STRENGTH, traverses=200.0) for seed in (1, 2, 3)
    ]
    assert np.mean([one.centre for one in found]) == pytest.approx(found[0].factor, rel=0.1)
    for one in found:
        assert pytest.approx(37e9, rel=0.05) == one.E  # that of static tension of a bar of the same packing method


def test_a_core_is_pushed_out_of_its_ring() -> None:
    test = bd.labtests.shear(spheres(PUNCH, 300), LAW, STRENGTH)
    assert 1e6 < test.peak < 40e6
    assert math.isnan(test.E)
    near, far = (test.run.history[name][:, 0] for name in ("near", "far"))
    top = int(np.argmax(far))
    assert far[top] == pytest.approx(-near[top], rel=0.15)


def test_the_non_local_law_has_the_strength_of_its_material() -> None:
    body = cells(PIN, 150)
    law = bd.NonLocal(E=E, nu=0.2)
    test = bd.labtests.direct_tension(body, law, bd.Rankine(tension=10e6), traverses=25.0)
    assert pytest.approx(E, rel=0.02) == test.E
    assert test.peak == pytest.approx(10e6, rel=0.15)


WRONG: dict[str, tuple[str, str, dict[str, Any]]] = {
    "no criterion": ("direct_tension", "failure = None", {"failure": None}),
    "a criterion of cells": ("uniaxial_compression", "needs a body of cells", {"failure": bd.Rankine(tension=1e6)}),
    "a periodic cell": ("uniaxial_compression", "no face 'x_min'", {"body": "cell"}),
    "a ball": ("direct_tension", "no face 'x_min'", {"body": "ball"}),
    "a ball under pressure": ("triaxial", "no face 'x_min'", {"body": "ball", "pressure": 1e6}),
    "a prism as a disc": ("brazilian", "not a cylinder along x", {"body": "box"}),
    "friction on strips": ("brazilian", "flats", {"platen_friction": 0.3, "body": "disc"}),
    "strips of nothing": ("brazilian", "contains no element", {"half_angle": 1e-6, "body": "disc"}),
    "no borings": ("shear", "punch_specimen", {}),
    "a cylinder as a beam": ("three_point_bending", "not a beam", {}),
    "strips of a beam": ("three_point_bending", "options of cells", {"strip": 1e-3, "body": "box"}),
    "negative friction": ("uniaxial_compression", "platen_friction = -1", {"platen_friction": -1.0}),
    "too fast": ("direct_tension", "traverses = 0.5", {"traverses": 0.5}),
    "a law of cells": ("uniaxial_compression", "method='laguerre'", {"law": bd.CellBond(E=1e9, nu=0.2)}),
}  # fmt: skip
BODIES = {
    "pin": PIN, "ball": bd.Ball(4e-3), "cell": bd.Cell((6e-3, 6e-3, 6e-3)), "box": bd.Box((8e-3, 4e-3, 4e-3)),
    "disc": bd.Cylinder(radius=4e-3, length=3e-3),
}  # fmt: skip


@pytest.mark.parametrize("case", WRONG)
def test_what_is_wrong_is_refused_in_a_line(case: str) -> None:
    name, message, given = WRONG[case]
    asked = {"law": LAW, "failure": STRENGTH} | given
    body = spheres(BODIES[asked.pop("body", "pin")], 200)
    with pytest.raises(InputError, match=message) as caught:
        getattr(bd.labtests, name)(body, asked.pop("law"), asked.pop("failure"), **asked)
    assert "\n" not in str(caught.value)


def test_options_of_bonded_spheres_are_refused_for_cells() -> None:
    contact = bd.LinearContact(E=1e9)
    material = bd.CellBond(E=1e9, nu=0.2), bd.MohrCoulomb(
        tension=1e6, cohesion=3e6, friction_angle=0.5, fracture_energy=5.0
    )
    for name in ("uniaxial_compression", "direct_tension", "brazilian"):
        with pytest.raises(InputError, match="applies to bonded spheres"):
            getattr(bd.labtests, name)(cells(PIN, 150), *material, contact=contact)
    with pytest.raises(InputError, match="options of bonded spheres"):
        bd.labtests.three_point_bending(cells(BODIES["box"], 150), *material, traverses=10.0)
    law = bd.NonLocal(E=E, nu=0.2)
    with pytest.raises(InputError, match="are smooth"):
        bd.labtests.uniaxial_compression(cells(PIN, 150), law, bd.Rankine(tension=1e6), platen_friction=0.3)


def test_a_test_that_is_too_fast_says_so() -> None:
    with pytest.warns(NotQuasistaticWarning, match="more traverses"):
        bd.labtests.direct_tension(spheres(PIN, 300), LAW, STRENGTH, traverses=1.5)
