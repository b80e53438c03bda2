"""Softening along two lines: its curve, its fracture energy by load factors and explicit, and what has none."""

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError, StudyError
from bondem.statics.quasistatic.sawtooth import SofteningLine, Teeth
from bondem.study.failure import read_failure
from bondem.study.keys import FAILURE
from bondem.study.toml_table import TomlTable
from tests.core.law_samples import softened
from tests.specimens import two_cubes, two_spheres

E, STRENGTH, ENERGY, SIZE = 40e9, 4e6, 50.0, 10e-3
PETERSSON = bd.Bilinear()
SOFT = bd.Rankine(tension=STRENGTH, fracture_energy=ENERGY, curve=PETERSSON)
UNIT = ENERGY / STRENGTH


def curve(opening: np.ndarray) -> np.ndarray:
    """Stress over f_t of Petersson's curve at openings over G_f / f_t, from its three points."""
    return np.interp(opening, [0.0, 0.8, 3.6], [1.0, 1.0 / 3.0, 0.0])


def test_the_curve_has_its_points_and_its_energy() -> None:
    assert PETERSSON.last == pytest.approx(3.6)
    for one in (PETERSSON, bd.Bilinear(stress=0.15, opening=0.95)):
        area = 0.5 * (1.0 + one.stress) * one.opening + 0.5 * one.stress * (one.last - one.opening)
        assert area == pytest.approx(1.0, rel=1e-12)


@pytest.mark.parametrize("share", [0.02, 0.2, 0.8])
def test_integrity_follows_the_curve(share: float) -> None:
    """s T at the opening (1 - s) T, for several lengths of elements: `share` of the longest, 1.2 E G_f / f_t²."""
    last = 3.0 / share * STRENGTH
    T = np.linspace(1.001, 0.999 * last / STRENGTH, 200) * STRENGTH
    s = softened(1.0, T, STRENGTH, last, PETERSSON.stress, PETERSSON.steep)
    np.testing.assert_allclose(s * T / STRENGTH, curve((1.0 - s) * T / last * 3.6), atol=1e-12)
    assert softened(1.0, 1.001 * last, STRENGTH, last, PETERSSON.stress, PETERSSON.steep) == 0.0
    assert softened(0.1, 1.1 * STRENGTH, STRENGTH, last, PETERSSON.stress, PETERSSON.steep) == 0.1


def test_a_kink_on_the_straight_line_is_none() -> None:
    straight = bd.Bilinear(stress=0.4, opening=1.2)
    assert (straight.last, straight.steep) == (pytest.approx(2.0), pytest.approx(1.0))
    T = np.linspace(1.01, 7.9, 20)
    one = softened(1.0, T, 1.0, 8.0, 0.0, 1.0)
    assert softened(1.0, T, 1.0, 8.0, straight.stress, straight.steep) == pytest.approx(one, rel=1e-12)


@pytest.mark.parametrize("ripple", [0.3, 0.1, 0.03, 5e-4])
def test_teeth_take_the_energy_of_the_curve(ripple: float) -> None:
    line = SofteningLine(STRENGTH, 30.0 * STRENGTH, PETERSSON.stress, PETERSSON.steep)
    teeth = Teeth.of(line, ripple)
    T, s = np.append(STRENGTH, teeth.limit), np.append(1.0, teeth.integrity)
    # within the band, the first tooth counts from the curve on
    taken = (T**2 * -np.diff(s)).sum() - STRENGTH**2 * (1.0 - s[1] / (1.0 - ripple))
    assert taken == pytest.approx(30.0 / 1.8 * STRENGTH**2, rel=1e-6)  # onset × last of a line of 2


def test_two_cells_follow_the_curve_by_load_factors() -> None:
    errors = []
    for ripple in (0.1, 0.05):
        ends = [bd.Fix(bd.Face("x_min"), translation="x", rotation=""), bd.Drive(bd.Face("x_max"), x=1e-6)]
        # of two cells nothing resists the twist, which does no work
        model = bd.Model(two_cubes(SIZE), bd.CellBond(E=E, nu=0.0), density=2500.0, failure=SOFT, boundary=ends)
        found = bd.solve_quasistatic(model, bd.Face("x_max"), ripple=ripple, together=0.0, until=0.0)
        k = E / SIZE
        line = SofteningLine(STRENGTH, k * 3.6 * UNIT, PETERSSON.stress, PETERSSON.steep)
        teeth = Teeth.of(line, ripple)
        s, T = np.append(1.0, teeth.integrity[:-1]), np.append(STRENGTH, teeth.limit)
        np.testing.assert_allclose(found.load, SIZE**2 * s * T, rtol=1e-9)
        np.testing.assert_allclose(found.displacement, s * T * 2.0 * SIZE / E + (1.0 - s) * T / k, rtol=1e-9)
        errors.append(found.work[-1] / (ENERGY * SIZE**2) - 1.0)
    assert abs(errors[1]) < 0.02
    assert abs(errors[1]) < 0.7 * abs(errors[0]) + 1e-3


def test_two_cells_follow_the_curve_in_an_explicit_run(one_thread: None) -> None:
    last, speed, rise = 3.6 * UNIT, 0.008, 2e-4
    ends = ("x_min", -0.5 * speed), ("x_max", 0.5 * speed)
    pull = [bd.Drive(bd.Face(face), vx=bd.Ramp(0.0, end, rise)) for face, end in ends]
    law = bd.CellBond(E=E, nu=0.0, facet_rotation="full")
    run = bd.solve_explicit(
        bd.Model(two_cubes(SIZE), law, density=2500.0, failure=SOFT, boundary=pull), duration=1.1 * last / speed,
        dt=5e-7, every=2, damping=bd.MassDamping(alpha=2e4), gauges={"pull": bd.Gauge(bd.Face("x_max"), "force")},
    )  # fmt: skip
    stress = run.history["pull"][:, 0] / SIZE**2
    crack = speed * np.maximum(run.history.time - 0.5 * rise, 0.0) - stress * 2.0 * SIZE / E
    falling = (crack > 0.02 * last) & (crack < 0.95 * last)
    np.testing.assert_allclose(stress[falling] / STRENGTH, curve(crack[falling] / UNIT), atol=0.01)
    assert run.history.released[-1] == pytest.approx(ENERGY * SIZE**2, rel=2e-3)
    assert run.residual < 1e-5


@pytest.mark.parametrize(
    ("given", "said"),
    [({"stress": 0.0}, "stress"), ({"stress": 1.0}, "stress"), ({"opening": 0.0}, "opening"),
     ({"stress": 0.5, "opening": 1.1}, "above the straight line"), ({"opening": float("nan")}, "opening")],
)  # fmt: skip
def test_curves_that_are_none_are_refused(given: dict[str, float], said: str) -> None:
    with pytest.raises(InputError, match=said):
        bd.Bilinear(**given)


def test_a_curve_is_of_what_softens() -> None:
    with pytest.raises(InputError, match="give fracture_energy too"):
        bd.Rankine(tension=STRENGTH, curve=PETERSSON)
    with pytest.raises(InputError, match=r"bd\.Bilinear"):
        bd.Rankine(tension=STRENGTH, fracture_energy=ENERGY, curve="bilinear")  # type: ignore[arg-type]
    beams = bd.MohrCoulomb(tension=1e6, cohesion=1e6, friction_angle=0.5, fracture_energy=50.0, curve=PETERSSON)
    lattice = two_spheres(SIZE)
    with pytest.raises(InputError, match="leave it out for beams"):
        bd.Model(lattice, bd.EulerBernoulli(E=E, nu=0.2, radius_ratio=0.5), density=2500.0, failure=beams)


def test_long_elements_are_refused_by_the_first_line() -> None:
    """1.2 E G_f / f_t² in place of 2: here 3.6 and 6 mm, where cells are 5 mm long."""
    law, energy = bd.CellBond(E=E, nu=0.0), 1.2
    body = two_cubes(0.5 * SIZE)
    failure = bd.Rankine(tension=STRENGTH, fracture_energy=energy)
    bd.Model(body, law, density=2500.0, failure=failure).softening  # noqa: B018
    with pytest.raises(InputError, match=r"1\.2 E G_f / f_t² = 0\.0036 m"):
        bd.Model(body, law, density=2500.0, failure=bd.Rankine(tension=STRENGTH, fracture_energy=energy,
                                                               curve=PETERSSON))  # fmt: skip


def test_studies_read_curves() -> None:
    given = {"criterion": "Rankine", "tension": "4 MPa", "fracture_energy": "50 J/m²"}
    assert read_failure(TomlTable(given, FAILURE)) == bd.Rankine(tension=STRENGTH, fracture_energy=ENERGY)
    assert read_failure(TomlTable(given | {"curve": "bilinear"}, FAILURE)) == SOFT
    bent = given | {"curve": "bilinear", "kink_stress": 0.15, "kink_opening": 0.95}
    kinked = read_failure(TomlTable(bent, FAILURE))
    assert isinstance(kinked, bd.Rankine)
    assert kinked.curve == bd.Bilinear(stress=0.15, opening=0.95)
    for wrong in ({"curve": "round"}, {"curve": "bilinear", "kink_opening": 1.9}, {"kink_stress": 0.2}):
        with pytest.raises(StudyError):
            read_failure(TomlTable(given | wrong, FAILURE))
