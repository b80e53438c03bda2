"""Tests of the laboratory against closed forms: elastic stresses and stiffnesses, Mohr–Coulomb's line, energies."""

import math
import tomllib

import numpy as np
import pytest
from scipy.integrate import quad

import bondem as bd
from bondem.errors import StrengthWarning
from bondem.labtests.beam_tests import CrossSection
from bondem.labtests.failure.brazilian import flattened, splitting_strength, stamped
from bondem.labtests.failure.shear import _Core
from bondem.study.study_file import parse_study
from bondem.study.template_files import template
from tests.specimens import cells

LAW = bd.CellBond(E=40e9, nu=0.2)
ANGLE = math.radians(59.8)
CONCRETE = bd.MohrCoulomb(tension=4e6, cohesion=7.4e6, friction_angle=ANGLE, fracture_energy=20.0)
RADIUS = 25e-3


def flat_disc(half_angle: float) -> bd.Shape:
    shape: bd.Shape = bd.Cylinder(radius=RADIUS, length=20e-3)
    flat = RADIUS * math.cos(half_angle)
    block = bd.Box((60e-3, 2.0 * RADIUS, 4.0 * RADIUS))
    for name, y in (("top", flat), ("bottom", -flat - 2.0 * RADIUS)):
        shape = shape.cut(block.moved((-20e-3, y, -2.0 * RADIUS)), name=name)
    return shape


def chords(angle: float) -> float:
    """σ_zz at the centre of a disc (R = t = 1) over 2 P / (π D t), P along y at ±angle: Flamant's fields in balance.

    Each force has the radial field -2 P cos θ / (π r); on a circle two of a chord add up to an even pressure
    (2 P / π D) cos β, which is taken off.
    """
    found = 0.0
    for side in (1.0, -1.0):
        arm = -np.array([math.sin(angle), side * math.cos(angle)])  # (z, y), from the force to the centre
        cosine = arm @ np.array([0.0, -side])
        found += -2.0 * cosine / math.pi * arm[0] ** 2
    return (found + math.cos(angle) / math.pi) * math.pi


@pytest.mark.parametrize("degrees", [1.0, 5.0, 10.0])
def test_the_stress_under_a_stamp_is_that_of_its_chords(degrees: float) -> None:
    half = math.radians(degrees)
    turned = quad(lambda turn: chords(math.asin(math.sin(half) * math.cos(turn))), 0.0, math.pi)[0] / math.pi
    assert stamped(half) == pytest.approx(turned, rel=1e-9)
    assert stamped(1e-6) == pytest.approx(1.0, rel=1e-9)


def test_flats_of_twenty_degrees_have_the_published_factor() -> None:
    """Wang et al. (2004), their closed formula at 2α = 20°."""
    assert flattened(math.radians(10.0)) == pytest.approx(0.960, abs=1e-3)


def test_a_disc_that_yields_before_it_cracks_has_no_splitting_strength() -> None:
    """Published constants of concrete; those of `bondem new brazilian` crack at the tensile strength."""
    body = cells(bd.Cylinder(radius=RADIUS, length=20e-3), 150)
    with pytest.warns(StrengthWarning, match="no splitting strength: the disc yields in shear and does not split"):
        bd.labtests.brazilian(body, LAW, CONCRETE)
    found = parse_study(tomllib.loads(template("brazilian", "b.toml"))).failure
    assert isinstance(found, bd.MohrCoulomb)
    assert found.softening is not None
    assert splitting_strength(found.softening) == found.tension


def test_what_a_disc_bears_is_where_its_centre_meets_the_criterion() -> None:
    """(σ1 - σ3)/2 + (σ1 + σ3)/2 sin φ = c cos φ with σ1 = s and σ3 = -3 s; Drucker–Prager likewise."""
    softening = CONCRETE.softening
    assert softening is not None
    s = splitting_strength(softening)
    assert 2.0 * s - s * math.sin(ANGLE) == pytest.approx(7.4e6 * math.cos(ANGLE), rel=1e-12)
    strong = bd.MohrCoulomb(tension=4e6, cohesion=14.3e6, friction_angle=0.61, fracture_energy=20.0).softening
    assert strong is not None
    assert splitting_strength(strong) == 4e6
    cone = bd.DruckerPrager(tension=4e6, compression=12e6, fracture_energy=20.0)
    s = splitting_strength(cone.softening)
    stress = np.diag([0.0, -3.0 * s, s])
    deviator = stress - np.trace(stress) / 3.0 * np.eye(3)
    reached = math.sqrt(0.5 * (deviator**2).sum()) + cone.slope * np.trace(stress)
    assert reached == pytest.approx(cone.strength, rel=1e-5)


@pytest.mark.filterwarnings("ignore:.*the disc yields in shear:bondem.errors.StrengthWarning")
@pytest.mark.parametrize("shape", [
    bd.Cylinder(radius=RADIUS, length=20e-3), pytest.param(flat_disc(math.radians(10.0)), marks=pytest.mark.validate),
])  # fmt: skip
def test_a_disc_has_the_elastic_stress_of_theory_at_its_centre(shape: bd.Shape) -> None:
    """Within 3 % of the stress under strips or flats, and E within 2 %, with nothing calibrated."""
    test = bd.labtests.brazilian(cells(shape, 800), LAW, CONCRETE)
    assert test.centre == pytest.approx(test.factor, rel=0.03)
    assert pytest.approx(LAW.E, rel=0.02) == test.E
    assert 0.8 < test.peak / 4e6 < 1.05
    assert test.tension == pytest.approx(test.factor * test.peak)
    assert test.test.residual < 2e-3
    assert test.curve[-1, 1] < 0.9 * test.peak


def test_a_triaxial_test_is_on_the_line_of_mohr_and_coulomb() -> None:
    sine = math.sin(ANGLE)
    test = bd.labtests.triaxial(cells(bd.Box((20e-3, 10e-3, 10e-3)), 250), LAW, CONCRETE, pressure=5e6, reach=1.5)
    line = (2.0 * 7.4e6 * math.cos(ANGLE) + 5e6 * (1.0 + sine)) / (1.0 - sine)
    assert test.peak == pytest.approx(line, rel=0.05)
    assert test.deviator == pytest.approx(test.peak - 5e6)
    assert pytest.approx(LAW.E, rel=0.02) == test.E


def bent(size: tuple[float, float, float], count: int, *, notch: float = 0.0, **more) -> bd.labtests.BendingTest:
    shape: bd.Shape = bd.Box(size)
    if notch:
        slot = bd.Box((3e-3, notch, 2.0 * size[2])).moved((0.5 * size[0] - 1.5e-3, 0.0, -0.5 * size[2]))
        shape = shape.cut(slot, name="notch")
    failure = bd.Rankine(tension=4e6, fracture_energy=20.0)
    return bd.labtests.three_point_bending(cells(shape, count), LAW, failure, **more)


def test_a_slender_beam_is_as_stiff_as_timoshenko_has_it() -> None:
    size, span = (140e-3, 20e-3, 20e-3), 120e-3
    test = bent(size, 1200, span=span, most=1)
    assert pytest.approx(LAW.E, rel=0.02) == test.E
    deflection, stress = test.curve[1]
    section = CrossSection.of(bd.Box(size))
    P = stress * 2.0 * 20e-3 * 20e-3**2 / (3.0 * span)
    G = LAW.E / (2.0 * (1.0 + LAW.nu))
    beam = P * span**3 / (48.0 * LAW.E * section.second_moment)
    beam += P * span / (4.0 * section.shear_coefficient(LAW.nu) * G * section.area)
    assert deflection * span == pytest.approx(beam, rel=0.03)


def test_the_strength_of_a_beam_is_that_of_its_outer_fibre() -> None:
    """The first crack, until which the beam is elastic: Navier's stress, less what the roller takes off."""
    test = bent((140e-3, 20e-3, 20e-3), 1200, span=120e-3, most=1)
    assert test.peak == pytest.approx(4e6, rel=0.15)
    short = bent((140e-3, 20e-3, 20e-3), 1200, span=60e-3, most=1)
    assert short.path.load[0] / test.path.load[0] == pytest.approx(2.0, rel=0.1)


def work_of_rollers(test: bd.labtests.BendingTest) -> float:
    """∫ P dw [J]: along elastic stretches, and at a constant load in events, where w changes with the damage.

    w is that of the centres of the cells at the rollers, which misses the dents above them: 2.5 % here.
    """
    path = test.path
    way = -0.5 * (path.gauge["left"] + path.gauge["right"])[:, 1]
    force, unit = path.load[0] / path.factor[0], way / path.factor
    before = np.concatenate([[0.0], path.factor[:-1]])
    elastic = 0.5 * force * unit * (path.factor**2 - before**2)
    return float(elastic.sum() + (force * path.factor[:-1] ** 2 * np.diff(unit)).sum())


@pytest.mark.validate
def test_a_notched_beam_takes_the_fracture_energy_of_its_ligament() -> None:
    test = bent((80e-3, 20e-3, 20e-3), 400, notch=8e-3, span=60e-3, together=0.03)
    assert test.ligament == pytest.approx(12e-3, rel=1e-6)
    assert test.work == pytest.approx(20.0, rel=0.1)
    assert test.work * 12e-3 * 20e-3 == pytest.approx(work_of_rollers(test), rel=0.04)
    assert test.curve[-1, 1] < 0.06 * test.peak


@pytest.mark.validate
def test_a_core_is_pushed_out_of_its_ring() -> None:
    body = cells(bd.labtests.punch_specimen(), 1000)
    core = _Core.of(body)
    assert core.ring == pytest.approx(45e-3, rel=1e-9)
    assert core.height == pytest.approx(60e-3, rel=1e-9)
    test = bd.labtests.shear(body, LAW, CONCRETE)
    assert pytest.approx(LAW.E, rel=0.03) == test.E
    assert test.asymmetry < 0.05
    assert test.residual < 2e-3
    moved = test.state.displacement[:, 0]
    assert moved[core.piston.select(body)].mean() < 3.0 * moved[core.plate.select(body)].mean() < 0.0


def test_the_mouth_of_a_notch_opens_as_the_beam_turns_about_the_ligament() -> None:
    """CMOD at the first event, and its figure.

    Tada's 4 σ a V(a/h) / E is that of a sharp crack. A notch as wide as half of its depth opens 1.236 times as far,
    by quadratic elements in plane stress (as in `validation/studies/cmod.py`). Cells are a tenth of the depth of the
    beam high, and the place of the tip is off by a share of that: 5 %.
    """
    depth, notch = 20e-3, 6e-3
    place = bd.Within(bd.Box((40e-3, 30e-3, 30e-3)).moved((0.0, -1e-3, -1e-3)))
    other = bd.Within(bd.Box((60e-3, 30e-3, 30e-3)).moved((60e-3, -1e-3, -1e-3)))
    test = bent((100e-3, depth, 20e-3), 1000, notch=notch, span=80e-3, most=3, gauges={"halves": (place, other)})
    assert test.cmod is not None
    assert test.cmod.shape == test.load.shape == test.deflection.shape == (4,)
    assert test.cmod[0] == test.load[0] == 0.0
    stress = 1.5 * test.load[1] * 80e-3 / (20e-3 * depth**2)
    ratio = notch / depth
    shape = 0.76 - 2.28 * ratio + 3.87 * ratio**2 - 2.04 * ratio**3 + 0.66 / (1.0 - ratio) ** 2
    wanted = 4.0 * stress * notch / LAW.E * shape
    assert test.cmod[1] == pytest.approx(1.236 * wanted, rel=0.05)
    assert test.plot().axes[0].get_xlabel().startswith("CMOD")
    assert test.path.gauge["halves"].shape == (3, 3)
    assert 0.0 < test.path.gauge["halves"][0, 0] < test.cmod[1]


def test_a_plain_beam_has_no_mouth_and_names_of_gauges_are_not_taken_twice() -> None:
    assert bent((60e-3, 20e-3, 20e-3), 300, span=40e-3, most=1).cmod is None
    with pytest.raises(bd.errors.InputError, match="gauge 'left' is one of its own"):
        bent((60e-3, 20e-3, 20e-3), 300, span=40e-3, most=1, gauges={"left": (bd.Everything(), bd.Everything())})
