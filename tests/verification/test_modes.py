"""Natural modes against closed forms."""

import math

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from bondem.model.matrices import mass_diagonal, stiffness_matrix
from bondem.solve import modal as modes_module

E, NU, RADIUS, STEP, RHO = 200e9, 0.3, 1.5e-3, 8e-3, 3000.0
LAW = bd.EulerBernoulli(E=E, nu=NU, radius=RADIUS)
STIFFNESS = E * math.pi * RADIUS**2 / STEP
MASS = RHO * 4.0 / 3.0 * math.pi * (STEP / 2.0) ** 3


def beads(count: int) -> bd.Lattice:
    position = np.zeros((count, 3))
    position[:, 0] = STEP * np.arange(count)
    return bd.Lattice(bd.Particles(position, STEP / 2.0), [(k, k + 1) for k in range(count - 1)])


def cloud(side: int, length: float) -> bd.Lattice:
    rng = np.random.default_rng(1)
    shape = np.array([int(side * length), side, side])
    grid = np.stack(np.meshgrid(*map(np.arange, shape), indexing="ij"), axis=-1).reshape(-1, 3) + 0.5
    position = (grid + rng.uniform(-0.2, 0.2, grid.shape)) * 1e-3
    return bd.connect(bd.Particles(position, 0.35e-3, shape=bd.Box(size=tuple(shape * 1e-3))), reach=1.6)


@pytest.mark.parametrize("count", [10, 300])
def test_bead_chain_along_its_axis(count):
    """ω_k = 2 √(k/m) sin((2k - 1) π / (2 (2N + 1))) for N free beads behind a held one."""
    lattice = beads(count + 1)
    guide = bd.Fix(bd.Everything() - bd.Index(0), translation="yz")
    found = bd.solve_modes(bd.Model(lattice, LAW, density=RHO, boundary=[bd.Fix(bd.Index(0)), guide]), count=6)
    k = np.arange(1, 7)
    expected = 2.0 * math.sqrt(STIFFNESS / MASS) * np.sin((2 * k - 1) * np.pi / (2 * (2 * count + 1))) / (2.0 * np.pi)
    np.testing.assert_allclose(found.frequency, expected, rtol=1e-8)
    shape = np.sin((2 * k[:, None] - 1) * np.pi * np.arange(count + 1) / (2 * count + 1))
    along = found.shape[:, :, 0]
    cosine = (along * shape).sum(axis=1) ** 2 / ((along**2).sum(axis=1) * (shape**2).sum(axis=1))
    np.testing.assert_allclose(cosine, 1.0, atol=1e-9)


def test_a_free_chain_has_no_mode_of_zero_frequency():
    """ω_k = 2 √(k/m) sin(k π / (2 N)) along the axis; bending comes first and is soft, but not zero."""
    count = 200
    found = bd.solve_modes(bd.Model(beads(count), LAW, density=RHO), count=60)
    rod = math.sqrt(E * math.pi * RADIUS**4 / 4.0 * STEP / MASS) / (2.0 * math.pi)
    slender = rod * (4.730041 / (STEP * count)) ** 2  # m per length, free ends half a step beyond the beads
    assert found.frequency[0] == pytest.approx(slender, rel=0.02)
    assert found.frequency[1] == pytest.approx(found.frequency[0], rel=1e-6)
    axial = (found.shape[:, :, 0] ** 2).sum(axis=1) * MASS > 0.5
    expected = 2.0 * math.sqrt(STIFFNESS / MASS) * math.sin(math.pi / (2 * count)) / (2.0 * math.pi)
    assert found.frequency[axial][0] == pytest.approx(expected, rel=1e-8)


def test_clamped_rod_in_bending():
    """Euler-Bernoulli cantilever, (1.875104)² √(EI/μ)/L²; lumped masses, so first order in the bond length."""
    count = 240
    found = bd.solve_modes(bd.Model(beads(count + 1), LAW, density=RHO, boundary=[bd.Fix(bd.Index(0))]), count=2)
    length = STEP * (count + 0.5)
    rod = math.sqrt(E * math.pi * RADIUS**4 / 4.0 * STEP / MASS) / (2.0 * math.pi)
    np.testing.assert_allclose(found.frequency, rod * (1.8751041 / length) ** 2, rtol=3e-3)


@pytest.fixture(scope="module")
def block() -> bd.Lattice:
    return cloud(9, 3.0)


@pytest.mark.parametrize("held", [True, False], ids=["clamped", "free"])
def test_block_gradients_find_the_modes_of_inverse_lanczos(block, held, monkeypatch):
    boundary = [bd.Fix(bd.Face("x_min", depth=1.0))] if held else []
    model = bd.Model(block, bd.EulerBernoulli(E=E, nu=NU, radius_ratio=0.6), density=RHO, boundary=boundary)
    found = bd.solve_modes(model, count=8)
    again = bd.solve_modes(model, count=8)
    np.testing.assert_array_equal(found.shape, again.shape)
    monkeypatch.setattr(modes_module, "prefers_elimination", lambda system: True)
    np.testing.assert_allclose(found.frequency, bd.solve_modes(model, count=8).frequency, rtol=3e-7)

    order = model.layout.order
    shape = found.shape[:, order].reshape(8, -1)
    mass = mass_diagonal(model)
    np.testing.assert_allclose(shape @ (mass[:, None] * shape.T), np.eye(8), atol=1e-6)
    stiffness = np.einsum("kn,nk->k", shape, stiffness_matrix(model) @ shape.T)
    np.testing.assert_allclose(np.sqrt(stiffness) / (2.0 * np.pi), found.frequency, rtol=1e-8)


def test_more_modes_than_there_are_is_an_error():
    model = bd.Model(beads(2), LAW, 1000.0, boundary=[bd.Fix(bd.Index(0))])
    assert len(bd.solve_modes(model, count=6).frequency) == 6
    with pytest.raises(InputError, match="has 6 modes"):
        bd.solve_modes(model, count=7)
