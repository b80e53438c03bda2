"""Aggregates of a grading curve, cells that end on their surfaces, and what such a body is as a whole."""

from functools import cache

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError, PackingError

BOX = bd.Box((40e-3, 30e-3, 30e-3))
SIEVE = bd.Sieve(diameters=(7e-3, 10e-3, 14e-3), mass_passing=(0.0, 0.5, 1.0))
SIZE, GAP, FRACTION = 2e-3, 2.4e-3, 0.2


@cache
def stones(seed: int = 1) -> bd.Aggregates:
    return bd.aggregates(BOX, SIEVE, fraction=FRACTION, gap=GAP, seed=seed)


@cache
def body(seed: int = 1) -> bd.Lattice:
    particles = bd.pack(BOX, size=SIZE, method="even", around=stones(seed), seed=seed, cache=False)
    return bd.connect(particles, method="laguerre")


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_balls_follow_the_grading_curve_and_keep_apart(seed: int) -> None:
    found = stones(seed)
    x, R = np.array(found.position), np.array(found.radius)
    # the volume asked for to half a ball, and half of the mass passes the middle sieve to a ball
    volume = 4.0 / 3.0 * np.pi * R**3
    assert found.volume == pytest.approx(volume.sum())
    assert abs(volume.sum() - FRACTION * BOX.volume) < 0.6 * volume.max()
    assert abs(volume[2.0 * R < 10e-3].sum() - 0.5 * volume.sum()) < volume.max()
    assert 3.5e-3 <= R.min() <= R.max() <= 7e-3
    apart = np.linalg.norm(x[:, None] - x, axis=2) - R[:, None] - R
    np.fill_diagonal(apart, np.inf)
    assert found.gap == pytest.approx(apart.min(), rel=1e-9)
    assert apart.min() > 0.9 * GAP
    assert (BOX.depth(x) - R).min() > 0.4 * GAP


@pytest.mark.parametrize("seed", [pytest.param(seed, marks=pytest.mark.validate) for seed in (1, 2, 3)])
def test_cells_end_on_the_surfaces(seed: int) -> None:
    """Facets of the border lie on the spheres to a tenth of a cell, and have the area of planes that touch them."""
    part, balls = body(seed), stones(seed)
    inside = balls.mask(part)
    i, j = part.pairs.T
    border = inside[i] != inside[j]
    area, off = part.facets.area[border], balls.depth(part.facets.centroid[border])
    assert np.sqrt((area * off**2).sum() / area.sum()) < 0.12 * SIZE
    spheres = 4.0 * np.pi * (np.array(balls.radius) ** 2).sum()
    assert area.sum() == pytest.approx(spheres, rel=0.1)
    assert part.cells.volume[inside].sum() == pytest.approx(balls.volume, rel=0.05)
    assert len(part.particles) == round(BOX.volume / SIZE**3)
    # cells that know nothing of the balls are cut anywhere: far further off
    plain = bd.connect(bd.pack(BOX, size=SIZE, method="even", seed=seed, cache=False), method="laguerre")
    inside = balls.mask(plain)
    other = plain.facets.centroid[inside[plain.pairs[:, 0]] != inside[plain.pairs[:, 1]]]
    assert np.sqrt((balls.depth(other) ** 2).mean()) > 0.2 * SIZE


@pytest.mark.validate
def test_its_modulus_is_between_the_bounds_of_hashin_and_shtrikman() -> None:
    """Stones four times as stiff: E of the prism between bounds that differ by some per cent."""
    part, balls = body(), stones()
    soft, hard = bd.CellBond(E=20e9, nu=0.2), bd.CellBond(E=80e9, nu=0.2)
    found = bd.labtests.static_tension(part, {bd.Everything(): soft, balls: hard}).E
    share = part.cells.volume[balls.mask(part)].sum() / BOX.volume
    low, high = (hashin_shtrikman(one, other, share if one is soft else 1.0 - share)
                 for one, other in ((soft, hard), (hard, soft)))  # fmt: skip
    assert low < found < high
    assert high < 1.15 * low


def hashin_shtrikman(matrix: bd.CellBond, other: bd.CellBond, share: float) -> float:
    """Bound on E of spheres of `other`, of a volume fraction, in a matrix (Hashin and Shtrikman 1963)."""
    (K, G), (k, g) = ((one.lame + 2.0 * one.G / 3.0, one.G) for one in (matrix, other))
    bulk = K + share / (1.0 / (k - K) + 3.0 * (1.0 - share) / (3.0 * K + 4.0 * G))
    way = 6.0 * (1.0 - share) * (K + 2.0 * G) / (5.0 * G * (3.0 * K + 4.0 * G))
    shear = G + share / (1.0 / (g - G) + way)
    return 9.0 * bulk * shear / (3.0 * bulk + shear)


@pytest.mark.validate
def test_same_arguments_same_bits_and_another_seed_another_packing() -> None:
    again = bd.pack(BOX, size=SIZE, method="even", around=stones(), seed=1, cache=False)
    assert np.array_equal(again.position, body().particles.position)
    assert stones(1).position != stones(2).position


def test_a_single_ball_has_no_gap() -> None:
    alone = bd.Aggregates([(1.0, 2.0, 3.0)], [0.5])
    assert (len(alone), alone.gap) == (1, np.inf)
    assert alone.depth(np.array([[1.0, 2.0, 3.2], [1.0, 2.0, 4.0]])) == pytest.approx([0.3, -0.5])


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: bd.aggregates(BOX, SIEVE, fraction=0.0, gap=GAP), "fraction"),
        (lambda: bd.aggregates(BOX, SIEVE, fraction=0.2, gap=-1.0), "gap"),
        (lambda: bd.aggregates(BOX, bd.Uniform(0.2), fraction=0.2, gap=GAP), "sieve"),
        (lambda: bd.aggregates(bd.Cell((1.0, 1.0, 1.0)), SIEVE, fraction=0.2, gap=GAP), "periodic"),
        (lambda: bd.aggregates(BOX, bd.Sieve((7.0, 14.0), (0.0, 1.0)), fraction=0.2, gap=GAP), "unit of the sieves"),
        (lambda: bd.aggregates(BOX, SIEVE, fraction=0.5, gap=GAP), "fits"),
        (lambda: bd.pack(BOX, size=SIZE, method="even", around="stones"), "around"),
        (lambda: bd.pack(BOX, count=1000, around=stones()), "even"),
        (lambda: bd.pack(BOX, size=4e-3, method="even", around=stones(), cache=False), "too large for balls"),
        (lambda: bd.pack(bd.Box((20e-3, 30e-3, 30e-3)), size=SIZE, method="even", around=stones(), cache=False),
         "reach out"),
        (lambda: bd.Aggregates([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0)], [0.6, 0.6]), "overlap"),
        (lambda: bd.Aggregates([(0.0, 0.0)], [0.6]), "shape"),
        (lambda: bd.Aggregates([(0.0, 0.0, 0.0)], [-0.6]), "positive"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_refused(call, message: str) -> None:
    with pytest.raises((InputError, PackingError), match=message):
        call()
