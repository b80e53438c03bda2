"""Calibration: what comes out has the target's E, nu and mass, or an error says what is in reach."""

import math

import numpy as np
import pytest

import bondem as bd
from bondem.calibration.free_parameter import FreeParameter
from bondem.errors import InputError, UnreachableTargetError

SILICA = bd.Material("fused silica", E=72.5e9, nu=0.17, rho=2201.0)
SHAPE = bd.Cylinder(radius=2.5e-3, length=15e-3)


@pytest.fixture(scope="module")
def lattices() -> list[bd.Lattice]:
    return [bd.connect(bd.pack(SHAPE, count=1200, spread=0.25, seed=seed)) for seed in (1, 2)]


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
    with pytest.raises(UnreachableTargetError, match=r"nu = 0\.45 is outside 0\.\d+ … 0\.\d+, which EulerBernoulli"):
        bd.calibrate(lattices[0], bd.Material("rubber", E=1e6, nu=0.45, rho=1000.0), search=(0.5, 0.8))
    # shear-flexible bonds do not come down to 0.17 below r̃ = 0.9
    with pytest.raises(UnreachableTargetError, match=r"Timoshenko bonds .* radius_ratio in \[0\.4, 0\.9\]"):
        bd.calibrate(lattices[0], SILICA, law=bd.Timoshenko, search=(0.4, 0.9))


@pytest.mark.parametrize("slope", [-1.0, 1.0])
@pytest.mark.parametrize("target", [0.12, 0.2, 0.33])
def test_the_root_is_found_wherever_it_lies(slope, target):
    free = FreeParameter("x", 0.1, 0.9, (0.5, 0.7))

    def nu(value: float) -> float:
        share = value if slope > 0 else 1.0 - value
        return 0.1 + 0.3 * share**1.7

    found = free.solve(nu, target, tolerance=1e-10, who="test bonds")
    assert nu(found) == pytest.approx(target, abs=1e-10)


def test_bad_input_says_what_to_do(lattices):
    with pytest.raises(InputError, match="at least one lattice"):
        bd.calibrate([], SILICA)
    with pytest.raises(InputError, match="not an instance"):
        bd.calibrate(lattices[0], SILICA, law=bd.EulerBernoulli(E=1e9, nu=0.3, radius_ratio=0.5))
    with pytest.raises(InputError, match="no fixed parameter 'radius_ratio'"):
        bd.calibrate(lattices[0], SILICA, radius_ratio=0.5)
    with pytest.raises(InputError, match="no fixed parameter 'kapa'"):
        bd.calibrate(lattices[0], SILICA, law=bd.ParallelBond, kapa=2.0)
    with pytest.raises(InputError, match="search"):
        bd.calibrate(lattices[0], SILICA, search=(0.9, 0.1))
    assert math.isfinite(SILICA.G)
