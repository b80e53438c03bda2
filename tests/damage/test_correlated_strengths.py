"""Strengths that are alike near each other: their distribution, their covariance, and what numbering does to them."""

import math

import numpy as np
import pytest

import bondem as bd
from bondem.damage.correlated import normal_field
from bondem.damage.counter_random import uniform_by_counter
from bondem.damage.flaws import weakest_flaw
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
    """Mean and deviation of 100 fields of 1000 places far apart, and their bounds."""
    volume, normal = np.full(1000, 1e-3), []
    for seed in range(100):
        x = places(1000, 60.0, seed)
        normal.append(bd.Normal(deviation=0.2, seed=seed, correlation=LENGTH).factors(volume, x))
    n = np.concatenate(normal)
    assert n.mean() == pytest.approx(1.0, abs=4e-3)
    assert n.std() == pytest.approx(0.2, rel=0.02)
    assert abs(n - 1.0).max() <= 0.6


@pytest.mark.parametrize(("edge", "many"), [(4.0, 300), (4.0, 1200), (8.0, 600)])
def test_the_smallest_strength_of_a_body_is_that_of_a_weakest_link(edge: float, many: int) -> None:
    """Γ(1 + 1/m) (V₀/V)^(1/m), whatever the volumes of bonds; m = 20, 60 seeds: sampling error 0.8 %."""
    volume = 0.1 + uniform_by_counter(2, many)
    smallest = [
        bd.Weibull(modulus=20.0, volume=1.0, seed=seed, correlation=LENGTH)
        .factors(volume, places(many, edge), None, edge**3).min()
        for seed in range(60)
    ]  # fmt: skip
    assert np.mean(smallest) == pytest.approx(math.gamma(1.05) * edge**-0.15, rel=0.025)


def test_a_flaw_sets_the_strength_of_all_bonds_within_its_reach() -> None:
    """The weakest bond shares its strength with all within a sphere about a point, and with none beyond 2 l of it."""
    x = places(4000, 6.0)
    found = weakest_flaw(5, LENGTH, np.full(4000, 1.0), x, None)
    same = x[found == found.min()]
    middle = 0.5 * (same.min(axis=0) + same.max(axis=0))
    assert len(same) > 4000 * 0.5 * LENGTH**3 / 6.0**3
    assert np.linalg.norm(same - middle, axis=1).max() < 1.1 * LENGTH
    inside = np.linalg.norm(x - middle, axis=1) < 0.8 * LENGTH
    assert (found[inside] == found.min()).all()


def test_finer_elements_keep_the_field() -> None:
    """Strengths at 100 places in grids of 20³ and 27³ bonds: the same flaws, but for their share of the volume."""
    probe, edge, both = places(100, 5.0, 9), 5.0, []
    for many in (20, 27):
        along = edge * (np.arange(many) + 0.5) / many
        grid = np.stack(np.meshgrid(along, along, along), axis=-1).reshape(-1, 3)
        volume = np.concatenate([np.full(100, 1e-9), np.full(many**3, (edge / many) ** 3)])
        strength = bd.Weibull(modulus=5.0, volume=1.0, seed=6, correlation=LENGTH)
        both.append(np.log(strength.factors(volume, np.vstack([probe, grid]), None, edge**3)[:100]))
    assert np.corrcoef(both)[0, 1] > 0.95
    assert np.abs(both[0] - both[1]).mean() < 0.3 * np.std(both[0])


def test_values_hang_on_place_and_seed_alone() -> None:
    x, volume = places(3000, 20.0), np.ones(3000)
    scatter = bd.Weibull(modulus=5.0, volume=1.0, seed=7, correlation=2.0)
    found, order = scatter.factors(volume, x), np.argsort(x[:, 0])
    np.testing.assert_allclose(scatter.factors(volume, x[order]), found[order], rtol=1e-12)
    other = bd.Weibull(modulus=5.0, volume=1.0, seed=8, correlation=2.0).factors(volume, x)
    assert abs(np.corrcoef(np.log(found), np.log(other))[0, 1]) < 0.2


def test_a_periodic_cell_has_a_periodic_field() -> None:
    edges, x = np.array([20.0, 25.0, 30.0]), places(2000, 20.0)
    one = normal_field(3, LENGTH, x, edges)
    np.testing.assert_allclose(normal_field(3, LENGTH, x + np.array([20.0, -25.0, 60.0]), edges), one, atol=1e-9)
    assert np.mean(one**2) == pytest.approx(1.0, abs=0.1)
    flaws = weakest_flaw(3, 4.0, np.ones(2000), x, edges)
    np.testing.assert_array_equal(weakest_flaw(3, 4.0, np.ones(2000), x + 2.0 * edges, edges), flaws)
    shifted = normal_field(3, LENGTH, x + np.array([0.5, 0.0, 0.0]), edges)
    assert np.mean(one * shifted) / np.mean(one**2) == pytest.approx(math.exp(-0.25), abs=0.05)


def test_facets_and_beams_take_strengths_by_their_place() -> None:
    """Facets nearer than 0.15 l mostly have the same weakest flaw."""
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
