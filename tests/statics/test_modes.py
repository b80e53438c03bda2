"""Natural modes against closed forms."""

import math

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError, PrestressWarning
from bondem.model.stiffness_matrices import mass_diagonal
from bondem.statics import modes as modes_module
from tests.specimens import cells, crooked_block, row

E, NU, RADIUS, STEP, RHO = 200e9, 0.3, 1.5e-3, 8e-3, 3000.0
LAW = bd.EulerBernoulli(E=E, nu=NU, radius=RADIUS)
STIFFNESS = E * math.pi * RADIUS**2 / STEP
MASS = RHO * 4.0 / 3.0 * math.pi * (STEP / 2.0) ** 3


@pytest.mark.parametrize("count", [10, 300])
def test_bead_chain_along_its_axis(count):
    """ω_k = 2 √(k/m) sin((2k - 1) π / (2 (2N + 1))) for N free beads behind a held one."""
    lattice = row(count + 1, STEP)
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
    found = bd.solve_modes(bd.Model(row(count, STEP), LAW, density=RHO), count=60)
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
    found = bd.solve_modes(bd.Model(row(count + 1, STEP), LAW, density=RHO, boundary=[bd.Fix(bd.Index(0))]), count=2)
    length = STEP * (count + 0.5)
    rod = math.sqrt(E * math.pi * RADIUS**4 / 4.0 * STEP / MASS) / (2.0 * math.pi)
    np.testing.assert_allclose(found.frequency, rod * (1.8751041 / length) ** 2, rtol=3e-3)


@pytest.mark.parametrize("held", [
    pytest.param(True, id="clamped"), pytest.param(False, id="free", marks=pytest.mark.validate),
])  # fmt: skip
def test_block_gradients_find_the_modes_of_inverse_lanczos(held, monkeypatch):
    boundary = [bd.Fix(bd.Face("x_min", depth=1.0))] if held else []
    block = crooked_block((18, 7, 7), edge=1e-3, jitter=0.2, radius=0.35, reach=1.6, walled=True)
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
    stiffness = np.einsum("kn,nk->k", shape, model.interaction.stiffness() @ shape.T)
    np.testing.assert_allclose(np.sqrt(stiffness) / (2.0 * np.pi), found.frequency, rtol=1e-8)


def test_more_modes_than_there_are_is_an_error():
    model = bd.Model(row(2, STEP), LAW, 1000.0, boundary=[bd.Fix(bd.Index(0))])
    assert len(bd.solve_modes(model, count=6).frequency) == 6
    with pytest.raises(InputError, match="has 6 modes"):
        bd.solve_modes(model, count=7)


@pytest.mark.validate
def test_a_block_that_ends_among_equal_frequencies_converges() -> None:
    """A free ball has modes of 2 l + 1 equal frequencies: 29 of them are 28 and one of five, and did not converge."""
    ball = cells(bd.Ball(0.05), 1000, spread=0.2, seed=2)
    model = bd.Model(ball, bd.CellBond(E=30e9, nu=0.3), 2400.0)
    found, more = (bd.solve_modes(model, count=count).frequency for count in (29, 44))
    np.testing.assert_allclose(found, more[:29], rtol=1e-6)


STEEL = bd.EulerBernoulli(E=200e9, nu=0.3, radius=0.5e-3)


def string(tension: float, *, bonds: int = 60, nonlinear: bool = False):
    """A wire that is held at one end and pulled at the other."""
    last = bd.Index(bonds)
    model = bd.Model(row(bonds + 1, 1.0 / bonds), STEEL, 7800.0, boundary=[
        bd.Fix(bd.Index(0)), bd.Fix(last, translation="yz"), bd.Load(last, force=(tension, 0.0, 0.0))])  # fmt: skip
    return model, bd.solve_static(model, nonlinear=nonlinear)


@pytest.mark.parametrize("nonlinear", [False, True])
def test_a_string_vibrates_by_its_tension(nonlinear: bool) -> None:
    """Clamped at both ends, with a little bending: f = √(T/μ) / 2 L · (1 + 2 √(EI/T) / L)."""
    tension = 300.0
    model, loaded = string(tension, nonlinear=nonlinear)
    mu = 60.0 * model.mass[0]
    EI = STEEL.E * math.pi * STEEL.radius**4 / 4.0
    wave = 0.5 * math.sqrt(tension / mu) * (1.0 + 2.0 * math.sqrt(EI / tension))
    found = across(bd.solve_modes(model, count=4, prestress=loaded))
    assert found == pytest.approx(wave, rel=5e-3)  # strains of 0.2 %, and (π / 2 N)²
    with pytest.warns(PrestressWarning, match="Load does not affect"):
        slack = across(bd.solve_modes(model, count=4))
    assert slack < 0.1 * found
    assert across(bd.solve_modes(model, count=4, prestress=False)) == pytest.approx(slack, rel=1e-9)


def across(modes: bd.ModesResult) -> float:
    """The lowest frequency of motion across a string, not of turns about its axis [Hz]."""
    return float(modes.frequency[np.abs(modes.shape[:, :, 1:3]).max(axis=(1, 2)) > 0.1][0])


def test_a_column_of_cells_loses_its_frequency_as_it_comes_to_buckle() -> None:
    """f² = f0² (1 - P / P_c) of a column clamped at the foot, to the mode that buckling has."""
    column = cells(bd.Box((0.06, 0.012, 0.012)), 500, spread=0.2, seed=3)
    law, top = bd.CellBond(E=1e9, nu=0.2), bd.Face("x_max")

    def lowest(P: float, **options) -> float:
        model = bd.Model(column, law, 2e3, boundary=[bd.Fix(bd.Face("x_min")), bd.Load(top, force=(-P, 0.0, 0.0))])
        return bd.solve_modes(model, count=1, prestress=bd.solve_static(model), **options).frequency[0] ** 2

    rest, little, more = lowest(1e-6), lowest(20.0), lowest(200.0)
    critical = math.pi**2 * 1e9 * 0.012**4 / 12.0 / (4.0 * 0.06**2)
    slope = (rest - little) / rest / 20.0 * critical
    assert slope == pytest.approx(1.0, rel=0.12)  # its EI is that of a bar of few cells, with shear
    assert (rest - more) / rest / 200.0 * critical == pytest.approx(slope, rel=0.03)
    with pytest.raises(InputError, match="unstable equilibrium"):
        lowest(3.0 * critical)


def test_prestress_of_something_else_is_refused() -> None:
    model, loaded = string(1e3)
    other, _ = string(1e3, bonds=40)
    with pytest.raises(InputError, match="has 61 elements; give a solution of this model"):
        bd.solve_modes(other, count=1, prestress=loaded)
    pulled, _ = string(5e3)
    with pytest.raises(InputError, match="is not an equilibrium of this model"):
        bd.solve_modes(pulled, count=1, prestress=loaded)
    with pytest.raises(InputError, match="prestress = 'tension'"):
        bd.solve_modes(model, count=1, prestress="tension")


def test_prestress_of_a_state_is_that_of_a_solution() -> None:
    model, loaded = string(2e3)
    state = model.state()
    half = 0.5 * loaded.rotation
    state.set_pose(
        position=state.position + loaded.displacement,
        orientation=np.column_stack([np.sqrt(1.0 - (half**2).sum(axis=1)), half]),
    )
    a, b = (bd.solve_modes(model, count=3, prestress=one).frequency for one in (loaded, state))
    np.testing.assert_allclose(a, b, rtol=1e-7)
