"""Specimens of the benchmarks: a periodic lattice repeated."""

import numpy as np
import pytest

import bondem as bd
from tests.scripts import scripts


@pytest.fixture(scope="module")
def benchmarks():
    """The module beside the scripts."""
    return scripts("benchmarks", tiled="tiled")


@pytest.fixture(scope="module")
def base(benchmarks):
    return benchmarks["tiled"].specimen(500)


def test_copies_are_bonded_where_they_touch(benchmarks, base):
    large = benchmarks["tiled"].tiled(base, 3)
    np.testing.assert_array_equal(np.unique(large.pairs, axis=0), bd.connect(large.particles).pairs)
    assert len(large.pairs) == 27 * len(base.pairs)
    np.testing.assert_allclose(large.particles.period, 3 * base.particles.period)
    np.testing.assert_allclose(large.length.reshape(27, -1), np.tile(base.length, (27, 1)), rtol=1e-9)


def test_copies_of_cells_are_the_cells_of_the_copies(benchmarks):
    base = benchmarks["tiled"].specimen(120, method="laguerre")
    large = benchmarks["tiled"].tiled(base, 2)
    whole = bd.connect(large.particles, method="laguerre")
    order, other = (np.lexsort(np.sort(body.pairs, axis=1).T) for body in (large, whole))
    np.testing.assert_array_equal(np.sort(large.pairs, axis=1)[order], np.sort(whole.pairs, axis=1)[other])
    np.testing.assert_allclose(large.facets.area[order], whole.facets.area[other], rtol=0.0, atol=1e-9 * 1e-6)
    np.testing.assert_allclose(large.cells.volume, whole.cells.volume, rtol=1e-9)
    # levers of both sides, to within whole periods
    arm = large.facets.centroid - large.centre[large.pairs[:, 0]]
    assert np.linalg.norm(arm, axis=1).max() < 5e-3
    flipped = large.pairs[order, 0] != whole.pairs[other, 0]
    own = whole.facets.centroid - whole.centre[whole.pairs[:, 0]]
    own[other[flipped]] -= whole.branch[other[flipped]]
    np.testing.assert_allclose(arm[order], own[other], rtol=0.0, atol=1e-9 * 1e-3)


def test_a_large_specimen_is_made_of_small_packings(benchmarks):
    large = benchmarks["tiled"].specimen(3000, largest=400)
    assert len(large.particles) == 8 * 375
