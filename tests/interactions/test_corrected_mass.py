"""The dispersion-corrected mass matrix: celerity of waves of pressure, modes, momentum, files and bad input."""

from functools import cache

import numpy as np
import pytest
from scipy.linalg import eigh
from scipy.sparse import diags_array

import bondem as bd
from bondem.model.highest_frequency import highest_frequency
from bondem.model.stiffness_matrices import mass_diagonal
from bondem.statics.linear import System, solver
from bondem.statics.modes import mass_matrix
from tests.bits import threads
from tests.models import clamped
from tests.specimens import crooked_cells

LAW = bd.CellBond(E=1.0, nu=0.3)
CORRECTED = {"mass_matrix": "dispersion-corrected"}


@cache
def torus() -> bd.Lattice:
    """A periodic bar of 8 × 1 × 1 with 600 cells."""
    return bd.connect(bd.pack(bd.Cell((8.0, 1.0, 1.0)), count=600, spread=0.25, seed=1), method="laguerre")


def celerity(axis: int, **options) -> float:
    """ω / k of a standing wave 11 elements long by Rayleigh's quotient, over √((λ + 2G)/ρ) or √(G/ρ)."""
    body, k = torus(), 2.0 * np.pi * 3 / 8.0
    model = bd.Model(body, LAW, 1.0, **options)
    system = System.of(model)
    mass = diags_array(mass_diagonal(model))
    M = mass if options == {} else mass_matrix(model, system)
    x, square = body.centre[model.layout.order, 0], []
    for phase in (0.0, 0.5 * np.pi):
        wave = np.zeros((len(x), 6))
        wave[:, axis] = np.sin(k * x + phase)
        wave[:, 5] = 0.5 * k * np.cos(k * x + phase) * (axis == 1)
        u = solver(system).solve(system.balanced(M @ wave.ravel()))[0]  # takes out what is not of the wave
        square.append(u @ (system.matrix @ u) / (u @ (M @ u)))
    exact = np.sqrt(LAW.lame + 2.0 * LAW.G if axis == 0 else LAW.G)
    return float(np.sqrt(np.mean(square)) / k / exact)


def test_waves_of_pressure_have_the_celerity_of_the_material():
    """At 11 elements per wave: 1.8 % too slow with lumped masses; waves of shear do not change."""
    assert celerity(0) == pytest.approx(0.982, abs=1e-3)
    assert celerity(0, **CORRECTED) == pytest.approx(1.0, abs=5e-3)
    assert celerity(1, **CORRECTED) == pytest.approx(celerity(1), abs=3e-4)
    assert celerity(1) == pytest.approx(1.0, abs=5e-3)


@pytest.mark.parametrize("held", [False, True], ids=["free", "clamped"])
def test_modes_are_those_of_the_whole_matrices(held):
    body = crooked_cells((6, 3, 3))
    model = bd.Model(body, LAW, 1.0, boundary=[bd.Fix(bd.Face("x_min"))] if held else [], **CORRECTED)
    system = System.of(model)
    M = mass_matrix(model, system).toarray()
    square = eigh(system.matrix.tocsc().toarray(), M, eigvals_only=True)[0 if held else 6 :][:5]
    found = bd.solve_modes(model, count=5)
    np.testing.assert_allclose(found.frequency, np.sqrt(square) / (2.0 * np.pi), rtol=1e-7)
    phi = found.shape[:, model.layout.order].reshape(5, -1)
    np.testing.assert_allclose(phi @ M @ phi.T, np.eye(5), atol=1e-7)


@pytest.mark.filterwarnings("ignore:Model. density = :bondem.errors.UnitWarning")  # in units of its own
def test_rigid_motion_has_its_mass_and_the_matrix_is_positive():
    model = bd.Model(crooked_cells((5, 3, 3)), bd.CellBond(E=1.0, nu=0.45), 2.0, **CORRECTED)
    system = System.of(model)
    M, lumped = mass_matrix(model, system), mass_diagonal(model)
    np.testing.assert_allclose(M @ system.loose, lumped[:, None] * system.loose, atol=1e-12 * lumped.max())
    assert eigh(M.toarray(), np.diag(lumped), eigvals_only=True)[0] > 0.3


def shaken(**options) -> bd.ExplicitResult:
    """A free body that vibrates along its length, from velocities."""
    body = crooked_cells((12, 4, 4))
    model = bd.Model(body, LAW, 1.0, **options)
    state = model.state()
    state.set_motion(velocity=1e-4 * np.cos(np.pi * body.centre[:, :1] / 12.0) * [1.0, 0.0, 0.0])
    return bd.solve_explicit(model, duration=60.0, state=state, every=20)


def test_a_run_keeps_its_energy_and_momentum():
    """The correction is applied once, M⁻¹ (F + C M⁻¹ F), so that the energy of M' differs at fourth order in k."""
    lumped, corrected = shaken(), shaken(**CORRECTED)
    for result in (lumped, corrected):
        total = sum(result.history.energy[name] for name in ("translation", "rotation", "normal", "shear", "bending"))
        assert np.abs(total / total[0] - 1.0).max() < 0.01
        momentum = (result.state.model.mass[:, None] * result.state.velocity).sum(axis=0)
        mass = result.state.model.mass
        start = 1e-4 * (mass * np.cos(np.pi * result.state.model.lattice.centre[:, 0] / 12.0)).sum()
        np.testing.assert_allclose(momentum, [start, 0.0, 0.0], atol=1e-13)
    assert not np.array_equal(lumped.state.velocity, corrected.state.velocity)


def test_bits_do_not_depend_on_threads():
    results = []
    for count in (1, 2):
        with threads(count):
            results.append(shaken(**CORRECTED).state)
    np.testing.assert_array_equal(results[0].pose, results[1].pose)


def test_blocks_of_a_step_change_nothing(monkeypatch):
    expected = shaken(**CORRECTED).state
    monkeypatch.setattr("bondem.dynamics.core_loop.BLOCK", 16)
    np.testing.assert_array_equal(shaken(**CORRECTED).state.pose, expected.pose)


def test_files_and_bad_input(tmp_path):
    body = crooked_cells((4, 3, 3))
    model = bd.Model(body, LAW, 1.0, **CORRECTED)
    bd.solve_explicit(model, duration=1.0, out=tmp_path / "run.h5")
    assert bd.read_run(tmp_path / "run.h5").model.mass_matrix == "dispersion-corrected"
    with pytest.raises(bd.errors.InputError, match="mass_matrix"):
        bd.Model(body, LAW, 1.0, mass_matrix="consistent")
    with pytest.raises(bd.errors.InputError, match="without failure= and contact="):
        bd.Model(body, LAW, 1.0, failure=bd.Rankine(tension=1.0), **CORRECTED)
    assert clamped(body, LAW).correction is None


@pytest.mark.parametrize("nu", [0.2, 0.45])
def test_the_usual_step_is_stable_between_rollers(nu):
    """The correction raises frequencies the most at cells that walls hold."""
    body = bd.connect(bd.pack(bd.Box((3.0, 1.0, 1.0)), count=150, method="even", seed=1), method="laguerre")
    faces = ("y_min", "y_max", "z_min", "z_max")
    sides = [bd.Fix(bd.Face(face), translation=face[0], rotation="") for face in faces]
    model = bd.Model(body, bd.CellBond(E=1.0, nu=nu), 1.0, boundary=sides, **CORRECTED)
    system = System.of(model)
    M, lumped = mass_matrix(model, system).toarray(), mass_diagonal(model)
    K = system.matrix.tocsc().toarray() / lumped[:, None]
    steps = K + (np.eye(len(K)) - M / lumped[:, None]) @ K
    largest = np.sqrt(np.linalg.eigvals(steps).real.max())
    assert largest < highest_frequency(model) < 1.3 * largest
    state = model.state()
    state.set_motion(velocity=1e-6 * np.random.default_rng(0).standard_normal((150, 3)))
    # noise has the shortest waves, whose energy varies by a fifth at this step
    energy = bd.solve_explicit(model, duration=40.0, state=state, every=50, imbalance=None).history.energy
    assert energy["translation"].max() < 1.25 * energy["translation"][0]
