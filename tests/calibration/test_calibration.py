"""Calibration: what comes out has the target's E, nu and mass, or an error says what is in reach."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import t as student

import bondem as bd
from bondem.calibration.reach import reach, recommend
from bondem.calibration.search import Search
from bondem.calibration.surface_correction import SurfaceCorrection
from bondem.errors import InputError, UnreachableTargetError
from tests.specimens import spheres

SILICA = bd.Material("fused silica", E=72.5e9, nu=0.17, rho=2201.0)
SHAPE = bd.Cylinder(radius=2.5e-3, length=15e-3)


@pytest.fixture(scope="module")
def lattices() -> list[bd.Lattice]:
    return [spheres(SHAPE, 1200, seed=seed) for seed in (1, 2)]


@pytest.fixture(scope="module")
def fit(lattices):
    return bd.calibrate(lattices[0], SILICA)


def test_the_calibrated_specimen_has_the_target_moduli(lattices, fit):
    tension = bd.labtests.static_tension(lattices[0], fit.law)
    assert pytest.approx(72.5e9, rel=1e-6) == tension.E
    assert tension.nu == pytest.approx(0.17, abs=2e-5)
    assert pytest.approx(tension.E, rel=1e-6) == fit.E
    assert fit.nu == pytest.approx(tension.nu, abs=1e-7)
    assert fit.law.nu == 0.3
    assert fit.E_std == fit.nu_std == 0.0


def test_the_search_is_short_and_its_table_falls(fit):
    assert fit.parameter == "radius_ratio"
    assert len(fit.table) <= 6
    value = [trial.value for trial in fit.table]
    assert value == sorted(value)
    assert np.all(np.diff([trial.nu for trial in fit.table]) < 0.0)
    assert np.all(np.diff([trial.stiffness_ratio for trial in fit.table]) > 0.0)


def test_mass_equality_holds_for_what_moves(lattices, fit):
    # eq (19): Σ ρ_μ V_μ over connected elements is ρ_M V_M
    lattice = lattices[0]
    mass = bd.Model(lattice, fit.law, density=fit.density).mass
    assert mass[lattice.connected].sum() == pytest.approx(2201.0 * SHAPE.volume, rel=1e-12)


@pytest.mark.validate
def test_several_packings_are_calibrated_on_their_mean(lattices):
    fit = bd.calibrate(lattices, SILICA)
    E, nu = np.array([(t.E, t.nu) for t in (bd.labtests.static_tension(x, fit.law) for x in lattices)]).T
    assert E.mean() == pytest.approx(72.5e9, rel=1e-6)
    assert nu.mean() == pytest.approx(0.17, abs=2e-5)
    assert fit.E_std == pytest.approx(E.std(ddof=1), rel=1e-4)
    assert fit.nu_std == pytest.approx(nu.std(ddof=1), rel=1e-3)
    assert fit.E_std > 0.0


def test_parallel_bonds_are_calibrated_by_kappa(lattices):
    fit = bd.calibrate(lattices[0], SILICA, law=bd.ParallelBond, radius_ratio=0.5)
    assert fit.parameter == "kappa"
    assert fit.law.radius_ratio == 0.5
    tension = bd.labtests.static_tension(lattices[0], fit.law)
    assert pytest.approx(72.5e9, rel=1e-6) == tension.E
    assert tension.nu == pytest.approx(0.17, abs=2e-5)


def test_a_target_out_of_reach_names_the_reach(lattices):
    with pytest.raises(UnreachableTargetError, match=r"nu = 0\.45: outside 0\.\d+ … 0\.\d+, the range of Euler"):
        bd.calibrate(
            lattices[0], bd.Material("rubber", E=1e6, nu=0.45, rho=1000.0), law=bd.EulerBernoulli, search=(0.5, 0.8)
        )
    # shear-flexible bonds do not come down to 0.17 below r̃ = 0.9
    with pytest.raises(UnreachableTargetError, match=r"Timoshenko bonds .* radius_ratio in \[0\.4, 0\.9\]"):
        bd.calibrate(lattices[0], SILICA, law=bd.Timoshenko, search=(0.4, 0.9))


@pytest.mark.parametrize("rising", [False, True])
@pytest.mark.parametrize("target", [0.12, 0.2, 0.33])
@pytest.mark.parametrize("start", [None, 0.15, 0.85])
def test_the_root_is_found_wherever_it_lies(rising, target, start):
    free = Search("x", 0.1, 0.9)
    seen = []

    def nu(value: float) -> tuple[float, float]:
        seen.append(value)
        share, way = (value, 1.0) if rising else (1.0 - value, -1.0)
        return 0.1 + 0.3 * share**1.7, way * 0.51 * share**0.7

    found = free.solve(nu, target, start=start, tolerance=1e-10, who="test bonds")
    assert nu(found)[0] == pytest.approx(target, abs=1e-10)
    assert len(seen) <= 9
    assert all(0.1 <= value <= 0.9 for value in seen)


@pytest.mark.parametrize("start", [None, 0.1, 0.9])
@pytest.mark.parametrize("target", [0.05, 0.39])
def test_a_root_beyond_the_ends_is_refused_with_the_reach(start, target):
    free = Search("x", 0.1, 0.9)
    with pytest.raises(UnreachableTargetError, match=r"outside 0\.106 … 0\.351"):
        free.solve(
            lambda x: (0.1 + 0.3 * x**1.7, 0.51 * x**0.7), target, start=start, tolerance=1e-10, who="test bonds"
        )


@pytest.mark.validate
def test_bonds_of_obermayr_are_calibrated_by_alpha_s(lattices):
    fit = bd.calibrate(lattices[0], SILICA, law=bd.Obermayr)
    assert fit.parameter == "alpha_s"
    assert fit.law.radius_ratio == 1.0
    assert fit.nu == pytest.approx(0.17, abs=2e-5)
    # its shear stiffness is that of a parallel bond with κ = 2 (1 + ν_μ) / α_s, which hardly differs otherwise
    twin = bd.calibrate(lattices[0], SILICA, law=bd.ParallelBond)
    assert 2.6 / fit.law.alpha_s == pytest.approx(twin.law.kappa, rel=2e-3)


def test_a_periodic_cell_is_calibrated_by_its_bulk_moduli():
    cell = spheres(bd.Cell((1e-2, 1e-2, 1e-2)), 600, seed=1)
    fit = bd.calibrate(cell, SILICA, law=bd.EulerBernoulli)
    moduli = bd.bulk_moduli(cell, fit.law)
    assert pytest.approx(72.5e9, rel=1e-9) == moduli.E
    assert moduli.nu == pytest.approx(0.17, abs=1e-5)
    assert fit.tensions == ()


def test_without_a_law_one_that_reaches_the_material_is_taken(lattices):
    fit = bd.calibrate(lattices[0], SILICA)
    assert isinstance(fit.law, bd.EulerBernoulli)
    assert "EulerBernoulli bonds reach" in fit.reason
    stiff = recommend(0.05)
    assert stiff.law is not bd.EulerBernoulli
    assert "not reached by EulerBernoulli" in stiff.reason
    with pytest.raises(UnreachableTargetError, match=r"nu = 0\.49: no bond law reaches"):
        recommend(0.49)


def test_what_a_law_reaches_is_computed(lattices):
    found = reach(lattices[0], bd.ParallelBond, points=3)
    assert found.parameter == "kappa"
    assert found.values == pytest.approx((0.5, 5.0, 50.0))
    tension = bd.labtests.static_tension(lattices[0], bd.ParallelBond(E=1e9, nu=0.3, radius_ratio=1.0, kappa=5.0))
    assert found.nu[1] == pytest.approx(tension.nu, rel=1e-9)
    assert found.smallest == found.nu[0] < found.nu[1] < found.nu[2] == found.largest


def test_a_reach_has_two_points_or_more(lattices):
    with pytest.raises(InputError, match="points = 1; give a whole number of at least 2"):
        reach(lattices[0], bd.ParallelBond, points=1)


LAWS = {
    "radius_ratio": bd.EulerBernoulli(E=2e9, nu=0.3, radius_ratio=0.7),
    "nu": bd.Timoshenko(E=2e9, nu=0.25, radius_ratio=0.6),
    "kappa": bd.ParallelBond(E=2e9, nu=0.3, radius_ratio=0.9, kappa=3.0),
    "alpha_s": bd.Obermayr(E=2e9, nu=0.3, radius_ratio=0.9),
}


@pytest.mark.parametrize("parameter", LAWS)
@pytest.mark.parametrize("periodic", [False, True])
def test_slopes_of_the_adjoint_are_those_of_differences(lattices, parameter, periodic):
    lattice = lattices[0]
    if periodic:
        lattice = spheres(bd.Cell((1e-2, 1e-2, 1e-2)), 400, seed=1)
    law = LAWS[parameter]
    value = getattr(law, parameter)
    step = 1e-4 * value
    above, below = (bd.Response(lattice, replace(law, **{parameter: value + s * step})) for s in (1.0, -1.0))
    slope = bd.Response(lattice, law).slope(parameter)
    # differences are right to the square of the step and to the solver's 1e-10 over it
    assert slope.log_E == pytest.approx(math.log(above.E / below.E) / (2.0 * step), rel=1e-6)
    assert slope.nu == pytest.approx((above.nu - below.nu) / (2.0 * step), rel=1e-6)


@pytest.mark.validate
def test_each_packing_would_have_these_bonds_by_itself(lattices):
    fit = bd.calibrate(lattices, SILICA, law=bd.EulerBernoulli)
    alone = [bd.calibrate(one, SILICA, law=bd.EulerBernoulli) for one in lattices]
    value, E_mu = fit.sample("value").values, fit.sample("E_mu").values
    shift = max(abs(one.value - fit.value) for one in alone)
    # first order: what is left is of the square of the shift
    assert value == pytest.approx([one.value for one in alone], abs=3.0 * shift**2)
    assert E_mu == pytest.approx([one.law.E for one in alone], rel=10.0 * shift**2)
    assert np.ptp(E_mu) > 1e-3 * fit.law.E
    low, high = fit.interval("E_mu")
    assert low < fit.law.E < high


@pytest.mark.validate
@pytest.mark.parametrize("material", [bd.materials.fused_silica, bd.materials.steel])
def test_a_law_from_the_bulk_is_carried_to_a_body(material):
    cell = spheres(bd.Cell((1e-2, 1e-2, 1e-2)), 2000, seed=1)
    body = spheres(bd.Cylinder(5e-3, 40e-3), 2000, seed=2)
    fit = bd.calibrate(cell, material, law=bd.EulerBernoulli)
    raw = bd.labtests.static_tension(body, fit.law)
    law = fit.law_for(body)
    carried = bd.labtests.static_tension(body, law)
    assert raw.E / material.E - 1.0 > 0.10
    # twice the standard error that the correction states for bodies of this size
    error = SurfaceCorrection.default(law).E_error(body)
    assert error < 0.04
    assert pytest.approx(1.0, abs=2.0 * error) == carried.E / material.E
    assert carried.nu / material.nu == pytest.approx(1.0, abs=2.0 * SurfaceCorrection.default(law).nu_error(body))
    # what it is calibrated on it leaves as it is
    same = fit.law_for(cell)
    assert pytest.approx(fit.law.E, rel=1e-4) == same.E
    assert same.radius_ratio == pytest.approx(fit.value, rel=1e-4)
    assert fit.density_for(cell) == pytest.approx(fit.density)
    mass = fit.density_for(body, balanced=True) * body.particles.volume
    assert mass[body.connected].sum() == pytest.approx(material.rho * body.particles.shape.volume)


def test_what_a_body_has_too_much_its_bonds_get_less(monkeypatch):
    cells = [spheres(bd.Cell((1e-2, 1e-2, 1e-2)), 400, seed=seed) for seed in (1, 2)]
    fit = bd.calibrate(cells[0], SILICA, law=bd.EulerBernoulli)
    monkeypatch.setattr(SurfaceCorrection, "E", lambda _, where: 1.10 if where is cells[1] else 1.0)
    monkeypatch.setattr(SurfaceCorrection, "nu", lambda _, where: 0.96 if where is cells[1] else 1.0)
    moduli = bd.bulk_moduli(cells[0], fit.law_for(cells[1]))
    # first order in a ν off by 4 %
    assert pytest.approx(1.0 / 1.10, rel=2e-3) == moduli.E / SILICA.E
    assert moduli.nu / SILICA.nu == pytest.approx(1.0 / 0.96, rel=2e-3)


def test_intervals_are_those_of_student():
    # n = 4, mean 10, s = 2; t(0.975, 3) = 3.182446
    sample = bd.Sample(np.array([10.0 - 2.0, 10.0 - 2.0 / math.sqrt(2.0), 10.0 + 2.0 / math.sqrt(2.0), 12.0]))
    assert sample.std == pytest.approx(2.0)
    assert sample.interval() == pytest.approx((10.0 - 3.182446, 10.0 + 3.182446), rel=1e-6)
    half = 3.182446 * 2.0 * math.sqrt(1.25)
    assert sample.interval(kind="prediction") == pytest.approx((10.0 - half, 10.0 + half), rel=1e-6)


@pytest.mark.parametrize("kind", ["confidence", "prediction"])
def test_intervals_cover_what_they_say(kind):
    rng = np.random.default_rng(7)
    draws = 4000
    hits = 0
    for _ in range(draws):
        low, high = bd.Sample(rng.normal(3.0, 0.5, 4)).interval(kind=kind, level=0.9)
        hits += low <= (3.0 if kind == "confidence" else rng.normal(3.0, 0.5)) <= high
    # binomial: three standard deviations
    assert hits / draws == pytest.approx(0.9, abs=3.0 * math.sqrt(0.9 * 0.1 / draws))


def test_packings_for_a_precision_are_as_few_as_can_be():
    rng = np.random.default_rng(1)
    values = rng.normal(0.0, 1.0, 6)
    sample = bd.Sample(100.0 + (values - values.mean()) / values.std(ddof=1))  # 1 %
    n = sample.packings_for(0.01)

    def half(count: int) -> float:
        return student.ppf(0.975, count - 1) * sample.std / math.sqrt(count) / sample.mean

    assert half(n) <= 0.01 < half(n - 1)
    assert n == 7


def test_sensitivities_are_those_of_the_search(lattices, fit):
    found = fit.sensitivity("radius_ratio")
    assert found.nu == pytest.approx(fit.slopes[0].nu, rel=1e-6)
    assert found.log_E == pytest.approx(fit.slopes[0].log_E, rel=1e-6)
    # ν_μ hardly matters to Euler–Bernoulli bonds
    assert abs(fit.sensitivity("nu").nu) < 0.02 * abs(found.nu)


def test_one_packing_has_no_interval(fit):
    with pytest.raises(InputError, match="two or more"):
        fit.interval("E")
    with pytest.raises(InputError, match="two or more"):
        fit.packings_for(0.01)
    with pytest.raises(InputError, match="quantity = 'G'"):
        fit.interval("G")
    with pytest.raises(InputError, match="kind = 'sure'"):
        bd.Sample(np.array([1.0, 2.0])).interval(kind="sure")


def test_bad_input_says_what_to_do(lattices):
    with pytest.raises(InputError, match="at least one lattice"):
        bd.calibrate([], SILICA)
    with pytest.raises(InputError, match="not an instance"):
        bd.calibrate(lattices[0], SILICA, law=bd.EulerBernoulli(E=1e9, nu=0.3, radius_ratio=0.5))
    with pytest.raises(InputError, match="no fixed parameter 'radius_ratio'"):
        bd.calibrate(lattices[0], SILICA, law=bd.EulerBernoulli, radius_ratio=0.5)
    with pytest.raises(InputError, match="no fixed parameter 'kapa'"):
        bd.calibrate(lattices[0], SILICA, law=bd.ParallelBond, kapa=2.0)
    with pytest.raises(InputError, match="search"):
        bd.calibrate(lattices[0], SILICA, search=(0.9, 0.1))
    assert math.isfinite(SILICA.G)


@pytest.mark.parametrize(
    ("shape", "words"),
    [
        (bd.Cylinder(radius=12.5e-3, length=20e-3), r"0.02 m long along x and 0.025 m wide, too short"),
        (bd.Box((10e-3, 20e-3, 10e-3)), "too short for a tension test"),
        (bd.Ball(10e-3), "a Ball has no faces x_min and x_max"),
    ],
)
def test_a_specimen_that_a_tension_test_does_not_measure_is_refused_in_one_line(shape, words):
    """Its ν is 10 % off at a length of 0.8 widths, and the bonds many times too stiff."""
    short = spheres(shape, 300)
    with pytest.raises(InputError, match=words) as caught:
        bd.calibrate(short, SILICA)
    assert "bd.Cell" in str(caught.value)
    assert "\n" not in str(caught.value)
