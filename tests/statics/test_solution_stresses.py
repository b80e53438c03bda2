"""Stresses of a static solution: principal ones, von Mises, failure index, and the file for ParaView."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from tests.specimens import bar, row

STRENGTH = 4e6


def stretched() -> tuple[bd.Model, bd.StaticResult]:
    """Model of a bar under a uniform stress of 1 MPa along x with a criterion, and its solution."""
    body = bar(100)
    pull = [bd.Pressure(bd.Face(face), -1e6) for face in ("x_min", "x_max")]
    failing = bd.Model(
        body, bd.CellBond(E=40e9, nu=0.2), 2400.0, failure=bd.Rankine(tension=STRENGTH, fracture_energy=50.0),
        boundary=pull,
    )  # fmt: skip
    return failing, bd.solve_static(replace(failing, failure=None))


def test_a_uniform_stress_is_found_in_every_cell() -> None:
    failing, found = stretched()
    np.testing.assert_allclose(found.stress, np.diag([1e6, 0.0, 0.0])[None].repeat(100, axis=0), atol=1.0)
    np.testing.assert_allclose(found.principal_stresses[:, 0], 1e6, rtol=1e-6)
    np.testing.assert_allclose(found.von_mises_stress, 1e6, rtol=1e-6)
    np.testing.assert_allclose(bd.failure_index(failing, found).max(), 1e6 / STRENGTH, rtol=1e-6)


def test_a_nonlinear_solution_has_the_stress_of_its_pose() -> None:
    """A pull that turns nothing by much: both solutions have the same stress, to the order of the strain."""
    ends = [bd.Fix(bd.Face("x_min")), bd.Load(bd.Face("x_max"), force=(100.0, 0.0, 0.0))]
    model = bd.Model(bar(100), bd.CellBond(E=40e9, nu=0.2), 2400.0, boundary=ends)
    small, large = bd.solve_static(model), bd.solve_static(model, nonlinear=True)
    assert large.nonlinear
    strain = np.abs(small.stress).max() / 40e9
    np.testing.assert_allclose(large.stress, small.stress, atol=10.0 * strain * np.abs(small.stress).max())


def test_stresses_of_tensors_are_those_of_text_books() -> None:
    shear = np.array([[0.0, 2.0, 0.0], [2.0, 0.0, 0.0], [0.0, 0.0, -5.0]])
    np.testing.assert_allclose(bd.principal_stresses(shear), [2.0, -2.0, -5.0], atol=1e-15)
    # √(½ ((σ1-σ2)² + (σ2-σ3)² + (σ3-σ1)²))
    assert bd.von_mises_stress(shear) == pytest.approx(np.sqrt(0.5 * (16.0 + 9.0 + 49.0)))
    assert bd.von_mises_stress(np.eye(3)[None]) == pytest.approx(0.0)
    with pytest.raises(InputError, match="not symmetric"):
        bd.von_mises_stress(np.triu(np.ones((3, 3))))
    with pytest.raises(InputError, match=r"shape \(2,\)"):
        bd.principal_stresses([1.0, 2.0])
    with pytest.raises(InputError, match="not finite"):
        bd.principal_stresses(np.full((3, 3), np.nan))


def test_an_index_of_another_solution_is_refused() -> None:
    failing, found = stretched()
    other = replace(failing, lattice=bar(60))
    with pytest.raises(InputError, match="another lattice"):
        bd.failure_index(other, found)


def test_a_linear_index_is_exact_where_cells_turn() -> None:
    """Rotations of 0.01 rad do not strain: the index of the motion is that of its stress."""
    failing, found = stretched()
    arm = failing.lattice.centre - failing.lattice.centre.mean(axis=0)
    spin = np.broadcast_to([0.0, 0.0, 0.01], arm.shape)
    turned = replace(found, displacement=found.displacement + np.cross(spin, arm), rotation=found.rotation + spin)
    np.testing.assert_allclose(
        bd.failure_index(failing, turned), bd.failure_index(failing, found), rtol=1e-6, atol=1e-9
    )


def test_a_solution_goes_to_paraview_with_its_stresses(tmp_path: Path) -> None:
    pyvista = pytest.importorskip("pyvista")
    _, found = stretched()
    bd.write_vtkhdf(tmp_path / "solution.vtkhdf", found.model.lattice, state=found)
    mesh = pyvista.read(tmp_path / "solution.vtkhdf")
    for name, values in (
        ("displacement", found.displacement), ("rotation", found.rotation), ("stress", found.stress.reshape(-1, 9)),
        ("principal_stresses", found.principal_stresses), ("von_mises_stress", found.von_mises_stress),
        ("reaction", found.reaction[:, :3]), ("reaction_moment", found.reaction[:, 3:]),
    ):  # fmt: skip
        np.testing.assert_array_equal(mesh.cell_data[name], values)
    assert np.ptp(mesh.points[:, 0]) > np.ptp(pyvista.read(_at_rest(tmp_path)).points[:, 0])


def _at_rest(folder: Path) -> Path:
    bd.write_vtkhdf(folder / "rest.vtkhdf", bar(100))
    return folder / "rest.vtkhdf"


def test_beams_go_to_paraview_too(tmp_path: Path) -> None:
    pyvista = pytest.importorskip("pyvista")
    ends = [bd.Fix(bd.Index([0])), bd.Load(bd.Index([3]), force=(1.0, 0.0, 0.0))]
    model = bd.Model(row(4), bd.EulerBernoulli(E=1e9, nu=0.2, radius_ratio=0.5), 1e3, boundary=ends)
    found = bd.solve_static(model)
    bd.write_vtkhdf(tmp_path / "row.vtkhdf", model.lattice, state=found)
    mesh = pyvista.read(tmp_path / "row.vtkhdf")
    np.testing.assert_array_equal(mesh.point_data["von_mises_stress"], found.von_mises_stress)
    np.testing.assert_allclose(mesh.points, model.lattice.particles.position + found.displacement)
