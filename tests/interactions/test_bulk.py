"""Bulk moduli of periodic lattices against closed forms."""

import math

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from tests.specimens import two_spheres

E, NU, RATIO, EDGE = 3e9, 0.25, 0.4, 1e-3


def periodic(basis: np.ndarray, cells: int, radius: float) -> bd.Lattice:
    corner = np.stack(np.meshgrid(*[np.arange(cells)] * 3, indexing="ij"), axis=-1).reshape(-1, 1, 3)
    position = ((corner + basis) * EDGE).reshape(-1, 3)
    return bd.connect(bd.Particles(position, radius, period=(cells * EDGE,) * 3))


def stiffness(length: float) -> tuple[float, float]:
    """EA/L and 12 EI/L³ of bonds of radius RATIO · L/2."""
    r = RATIO * length / 2.0
    return E * math.pi * r**2 / length, 12.0 * E * math.pi * r**4 / 4.0 / length**3


def cubic(C11: float, C12: float, C44: float) -> np.ndarray:
    C = np.diag([C11 - C12] * 3 + [C44] * 3)
    C[:3, :3] += C12
    return C


def test_simple_cubic():
    """A cubic frame: bonds along an axis stretch, C11 = kn/a; sheared, they bend in an S, C44 = ks/2a."""
    kn, ks = stiffness(EDGE)
    law = bd.EulerBernoulli(E=E, nu=NU, radius_ratio=RATIO)
    moduli = bd.bulk_moduli(periodic(np.zeros((1, 3)), 4, EDGE / 2.0), law)
    np.testing.assert_allclose(moduli.stiffness, cubic(kn / EDGE, 0.0, 0.5 * ks / EDGE), rtol=1e-9, atol=1e-3)


@pytest.mark.parametrize("cells", [3, 9], ids=["elimination", "iteration"])
def test_face_centred_cubic(cells):
    """Affine by symmetry and without rotations; twelve bonds an element, four elements a cube of edge a."""
    basis = np.array([[0, 0, 0], [0.5, 0.5, 0], [0.5, 0, 0.5], [0, 0.5, 0.5]])
    length = EDGE / math.sqrt(2.0)
    kn, ks = stiffness(length)
    moduli = bd.bulk_moduli(periodic(basis, cells, length / 2.0), bd.EulerBernoulli(E=E, nu=NU, radius_ratio=RATIO))
    expected = cubic((2.0 * kn + 2.0 * ks) / EDGE, (kn - ks) / EDGE, (kn + ks) / EDGE)
    np.testing.assert_allclose(moduli.stiffness, expected, rtol=1e-8, atol=1e-6 * kn / EDGE)
    C11, C12, C44 = expected[0, 0], expected[0, 1], expected[3, 3]
    assert pytest.approx((C11 + 2.0 * C12) / 3.0, rel=1e-8) == moduli.K
    assert pytest.approx((C11 - C12 + 3.0 * C44) / 5.0, rel=1e-8) == moduli.G
    assert pytest.approx(9.0 * moduli.K * moduli.G / (3.0 * moduli.K + moduli.G), rel=1e-12) == moduli.E
    assert pytest.approx(moduli.E / (2.0 * moduli.G) - 1.0, rel=1e-9) == moduli.nu


def test_moduli_of_a_random_cell_are_symmetric_and_do_not_depend_on_its_place():
    rng = np.random.default_rng(2)
    grid = np.stack(np.meshgrid(*[np.arange(8)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    position = (grid + rng.uniform(-0.2, 0.2, grid.shape)) * EDGE
    law = bd.Timoshenko(E=E, nu=NU, radius_ratio=0.7)
    cells = [
        bd.Particles(position + shift, 0.35 * EDGE, period=(8 * EDGE,) * 3)
        for shift in (0.0, np.array([2.3, 3.1, 0.6]) * EDGE)
    ]
    first, second = (bd.bulk_moduli(bd.connect(cell, reach=1.7), law) for cell in cells)
    np.testing.assert_allclose(first.stiffness, second.stiffness, rtol=1e-7, atol=1e-7 * first.E)
    assert np.linalg.eigvalsh(first.stiffness).min() > 0.0
    assert 0.0 < first.nu < 0.5


def test_a_specimen_with_walls_has_no_bulk():
    lattice = two_spheres()
    with pytest.raises(InputError, match="not periodic"):
        bd.bulk_moduli(lattice, bd.EulerBernoulli(E=E, nu=NU, radius_ratio=0.5))
