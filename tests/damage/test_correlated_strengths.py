"""Strengths that are alike near each other: their distribution, their covariance, and what numbering does to them."""

import math

import numpy as np
import pytest

import bondem as bd
from bondem.damage.correlated import normal_field
from bondem.damage.counter import uniform_by_counter
from bondem.errors import InputError
from tests.specimens import bar, spheres

LENGTH = 1.0


def places(many: int, edge: float, seed: int = 1) -> np.ndarray:
    return edge * uniform_by_counter(seed, 3 * many).reshape(many, 3)


@pytest.mark.validate
def test_the_field_has_the_covariance_of_its_formula() -> None:
    """exp(-(r/l)²) at six lags along x, y, z and a diagonal: 16 fields at 500 places each, sampling error 0.014."""
    lags = np.array([0.0, 0.25, 0.5, 1.0, 1.5, 2.5])
    axes = np.array([[1.0, 0, 0], [0, 1.0, 0], [0, 0, 1.0], [1.0, 1.0, 1.0] / np.sqrt(3.0)])
    found = np.zeros((len(axes), len(lags)))
    for seed in range(16):
        x = places(500, 60.0, seed)
        one = normal_field(seed, LENGTH, x, None)
        found[:, 0] += np.mean(one * one) / 16
        for a, axis in enumerate(axes):
            moved = (x + lag * LENGTH * axis for lag in lags[1:])
            found[a, 1:] += [np.mean(one * normal_field(seed, LENGTH, there, None)) / 16 for there in moved]
    np.testing.assert_allclose(found, np.tile(np.exp(-(lags**2)), (len(axes), 1)), atol=0.04)


@pytest.mark.validate
def test_correlated_strengths_have_the_distribution_put_in() -> None:
    """Mean, deviation and shares below some strengths, of 100 fields of 1000 places far apart."""
    volume, patch = np.full(1000, 1e-3), math.pi**1.5
    weibull, normal = [], []
    for seed in range(100):
        x = places(1000, 60.0, seed)
        weibull.append(bd.Weibull(modulus=5.0, volume=patch, seed=seed, correlation=LENGTH).factors(volume, x))
        normal.append(bd.Normal(deviation=0.2, seed=seed, correlation=LENGTH).factors(volume, x))
    w, n = np.concatenate(weibull), np.concatenate(normal)
    gamma = math.gamma
    assert w.mean() == pytest.approx(gamma(1.2), rel=4e-3)
    assert w.std() == pytest.approx(math.sqrt(gamma(1.4) - gamma(1.2) ** 2), rel=0.02)
    for share in (0.05, 0.5, 0.95):
        assert (w < (-math.log(1.0 - share)) ** 0.2).mean() == pytest.approx(share, abs=0.01)
    assert n.mean() == pytest.approx(1.0, abs=4e-3)
    assert n.std() == pytest.approx(0.2, rel=0.02)
    assert abs(n - 1.0).max() <= 0.6


@pytest.mark.validate
def test_the_volume_is_that_of_a_patch_where_bonds_are_smaller() -> None:
    x = places(500, 5.0)
    fine, coarse, large = (
        bd.Weibull(modulus=4.0, volume=1.0, correlation=LENGTH).factors(np.full(500, volume), x)
        for volume in (1e-6, math.pi**1.5, 16.0 * math.pi**1.5)
    )
    np.testing.assert_allclose(fine, coarse, rtol=1e-12)
    np.testing.assert_allclose(large, coarse / 2.0, rtol=1e-12)


def test_values_hang_on_place_and_seed_alone() -> None:
    x, volume = places(3000, 20.0), np.ones(3000)
    scatter = bd.Weibull(modulus=5.0, volume=1.0, seed=7, correlation=2.0)
    found, order = scatter.factors(volume, x), np.argsort(x[:, 0])
    np.testing.assert_array_equal(scatter.factors(volume, x[order]), found[order])
    np.testing.assert_array_equal(scatter.factors(volume[:5], x[:5]), found[:5])
    other = bd.Weibull(modulus=5.0, volume=1.0, seed=8, correlation=2.0).factors(volume, x)
    assert abs(np.corrcoef(np.log(found), np.log(other))[0, 1]) < 0.2


def test_a_periodic_cell_has_a_periodic_field() -> None:
    edges, x = np.array([20.0, 25.0, 30.0]), places(2000, 20.0)
    one = normal_field(3, LENGTH, x, edges)
    np.testing.assert_allclose(normal_field(3, LENGTH, x + np.array([20.0, -25.0, 60.0]), edges), one, atol=1e-9)
    assert np.mean(one**2) == pytest.approx(1.0, abs=0.1)
    shifted = normal_field(3, LENGTH, x + np.array([0.5, 0.0, 0.0]), edges)
    assert np.mean(one * shifted) / np.mean(one**2) == pytest.approx(math.exp(-0.25), abs=0.05)


def test_facets_and_beams_take_strengths_by_their_place() -> None:
    """Facets nearer than 0.15 l differ by √(1 - exp(-0.15²)) = 0.15 of those far apart at most."""
    scatter = bd.Weibull(modulus=5.0, volume=1e-9, correlation=2e-3)
    lattice = bar(200, 4e-3)
    law = bd.CellBond(E=1e9, nu=0.2)
    table = bd.Model(lattice, law, density=1e3, failure=bd.Rankine(tension=1e6, scatter=scatter)).softening
    assert table is not None
    assert lattice.facets is not None
    model = bd.Model(lattice, law, density=1e3)
    strength = np.log(table.strength)
    centroid = lattice.facets.centroid[model.layout.bond_order]
    apart = np.linalg.norm(centroid[:, None] - centroid[None], axis=2)
    step = np.abs(strength[:, None] - strength[None])
    near, far = step[(apart > 0) & (apart < 3e-4)], step[apart > 3e-3]
    assert len(near) > 500
    assert near.mean() < 0.2 * far.mean()
    beams = bd.EulerBernoulli(E=1e9, nu=0.3, radius_ratio=0.5)
    failure = bd.PeripheralStress(tension=1e6, shear=1e6, scatter=scatter)
    breaking = bd.Model(spheres(bd.Box((4e-3, 4e-3, 4e-3)), 300), beams, density=1e3, failure=failure).breaking
    assert breaking is not None
    assert breaking.coefficient.std() > 0.0


def test_lengths_that_cannot_be_are_refused() -> None:
    for bad in (0.0, -1e-3, math.nan, "long"):
        with pytest.raises(InputError, match=r"Weibull: correlation .* give a length in m, or None"):
            bd.Weibull(modulus=5.0, volume=1.0, correlation=bad)  # type: ignore[arg-type]
        with pytest.raises(InputError, match="Normal: correlation"):
            bd.Normal(deviation=0.1, correlation=bad)  # type: ignore[arg-type]
    with pytest.raises(InputError, match="need the places"):
        bd.Normal(deviation=0.1, correlation=1.0).factors(np.ones(3))
