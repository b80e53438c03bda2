"""Files of cells that have turned: corners go with their cells, and the orientation is there; walls are there too."""

from itertools import pairwise
from pathlib import Path

import h5py
import numpy as np
import pytest

import bondem as bd
from bondem.boundary.wall_outlines import wall_outlines
from bondem.boundary.wall_rows import wall_rows, walls_at_rest
from bondem.dynamics.plan import settled
from bondem.io.runfile import RunFile
from bondem.io.vtk_cells import Corners
from tests.io.test_run_snapshots import shown
from tests.models import grains, turned_cubes
from tests.specimens import two_spheres

HALF = np.sqrt(0.5)


def turned(model: bd.Model) -> np.ndarray:
    """Where the corners are by hand."""
    corners = Corners(model.lattice)
    place = corners.place.copy()
    second = corners.cell == 1
    x, y, z = (place[second] - [1.5, 0.5, 0.5]).T
    place[second] = np.array([1.9, 0.5, 0.5]) + np.stack([x, -z, y], axis=1)
    return place


def test_a_file_of_cells_has_them_turned(tmp_path: Path) -> None:
    pyvista = pytest.importorskip("pyvista")
    model, state = turned_cubes()
    bd.write_vtkhdf(tmp_path / "body.vtkhdf", model.lattice, state=state)
    grid = pyvista.read(tmp_path / "body.vtkhdf")
    np.testing.assert_allclose(grid.points, turned(model), atol=1e-12)
    np.testing.assert_allclose(grid.cell_data["orientation"], state.orientation)
    meshio = pytest.importorskip("meshio")
    bd.export(tmp_path / "body.vtu", model.lattice, state=state)
    np.testing.assert_allclose(meshio.read(tmp_path / "body.vtu").points, turned(model), atol=1e-12)


def test_a_file_of_spheres_has_their_orientation(tmp_path: Path) -> None:
    pyvista = pytest.importorskip("pyvista")
    lattice = two_spheres()
    state = bd.Model(lattice, bd.EulerBernoulli(E=1e9, nu=0.2, radius_ratio=0.5), 1e3).state()
    state.set_pose(orientation=[[1.0, 0.0, 0.0, 0.0], [HALF, 0.0, 0.0, HALF]])
    bd.write_vtkhdf(tmp_path / "two.vtkhdf", lattice, state=state)
    np.testing.assert_allclose(pyvista.read(tmp_path / "two.vtkhdf").point_data["orientation"], state.orientation)


def test_snapshots_have_turned_cells_and_walls(tmp_path: Path) -> None:
    model, state = turned_cubes()
    place = tmp_path / "run.h5"
    with RunFile(place, model, settled(model, bd.Plan(duration=1.0, dt=1e-9, snapshot_every=1))) as file:
        file.checkpoint(model.state(), bd.History.empty(()))
        file.snapshot(model.state())
        state.time = 1e-3
        file.snapshot(state)
    _, found = shown(place, 0)
    np.testing.assert_allclose(found["cells"].points, Corners(model.lattice).place, atol=1e-6)
    assert found["walls"].bounds[0] == pytest.approx(0.0, abs=1e-6)
    assert found["walls"].bounds[1] == pytest.approx(3.2, abs=1e-5)
    _, found = shown(place, 1)
    np.testing.assert_allclose(found["cells"].points, turned(model), atol=1e-6)
    np.testing.assert_allclose(found["cells"].cell_data["orientation"], state.orientation, atol=1e-6)
    assert found["walls"].bounds[1] == pytest.approx(2.8, abs=1e-5)
    assert set(found["walls"].cell_data["wall"]) == {0, 1}


def test_pictures_of_files_old_and_new_have_cells_turned(tmp_path: Path, monkeypatch) -> None:
    scene = pytest.importorskip("bondem.report.scene")
    model, state = turned_cubes()
    for name in ("new", "old"):
        if name == "old":  # as files were before cells moved in them
            monkeypatch.setattr(Corners, "moved", lambda corners, *_: corners.place)
        plan = settled(model, bd.Plan(duration=1.0, dt=1e-9, snapshot_every=1))
        with RunFile(tmp_path / f"{name}.h5", model, plan) as file:
            file.checkpoint(model.state(), bd.History.empty(()))
            state.time = 1e-3
            file.snapshot(state)
        drawn = scene.Scene(
            tmp_path / f"{name}.h5", field=None, show="auto", section=None, warp=2.0, camera="-y", walls=True,
            axes=True,
        )  # fmt: skip
        pieces = drawn._pieces(0)
        grid = pieces["cells"]
        if name == "old":
            del grid.cell_data["orientation"]
        place = turned(model)
        place[Corners(model.lattice).cell == 1, 0] += 0.4
        np.testing.assert_allclose(drawn._corners(grid, pieces["elements"]), place, atol=1e-5)


@pytest.mark.parametrize(("field", "title", "value"), [
    ("stress", "von Mises stress", 5.0), ("von_mises_stress", "von Mises stress", 5.0), ("s1", "stress s1", 4.0),
])  # fmt: skip
def test_a_stress_is_drawn_as_a_scalar_of_no_axes(field: str, title: str, value: float) -> None:
    """Principal stresses 4, 4 and -1 Pa, and the same turned about y."""
    scene, pyvista = pytest.importorskip("bondem.report.scene"), pytest.importorskip("pyvista")
    turned = np.array([[0.6, 0.0, 0.8], [0.0, 1.0, 0.0], [-0.8, 0.0, 0.6]])
    both = [np.diag([4.0, 4.0, -1.0]), turned @ np.diag([4.0, 4.0, -1.0]) @ turned.T]
    mesh = pyvista.PolyData(np.zeros((2, 3)))
    mesh.point_data["stress"] = np.array([one[[0, 1, 2, 0, 1, 0], [0, 1, 2, 1, 2, 2]] for one in both])
    drawn = scene.Scene.__new__(scene.Scene)
    drawn._field = field
    assert drawn._coloured(mesh) == title
    np.testing.assert_allclose(mesh.point_data[title], value)


def test_walls_have_their_sizes() -> None:
    """Areas of polygons against those of discs, rings, tubes and spheres; a growing radius moves corners outwards."""
    low, high = np.zeros(3), np.ones(3)
    walls = (
        bd.PlaneWall((0, 0, 0), (0, 0, 1), outer=1.0), bd.PlaneWall((0, 0, 0), (0, 1, 0), outer=2.0, inner=1.0),
        bd.CylinderWall(1.0, axis=(0, 0, 1)), bd.SphereWall(1.0),
    )  # fmt: skip
    beyond = 1.0 + 2.0 * 0.08 * np.sqrt(3.0)
    for wall, area in zip(walls, (np.pi, 3.0 * np.pi, 2.0 * np.pi * beyond, 4.0 * np.pi), strict=True):
        found = wall_outlines([wall], low, high)
        assert _area(found.vertex, found.start) == pytest.approx(area, rel=0.02)
    larger = walls_at_rest(1)
    wall_rows(larger)["growth"] = 1.0
    grown = wall_outlines(walls[3:], low, high).moved(larger)
    np.testing.assert_allclose(np.linalg.norm(grown, axis=1), 2.0)
    plane = wall_outlines([bd.PlaneWall((0, 0, 0), (1, 0, 0))], low, high)
    assert np.ptp(plane.vertex, axis=0) == pytest.approx([0.0, beyond, beyond])


def test_walls_of_files_turn_about_their_points(tmp_path: Path) -> None:
    """By a quarter turn in a run: corners of a disc and of a rod in the snapshots of its file."""
    turn = bd.Driven(angle=bd.Ramp(0.0, 0.5 * np.pi, 0.01), axis=(0, 0, 1), about=(1, 0, 0), vz=100.0)
    walls = [bd.PlaneWall((6, 0, 5), (-1, 0, 0), outer=1.0, motion=turn),
             bd.CylinderWall(0.5, (6, 0, 5), (1, 0, 0), outside=True, motion=turn)]  # fmt: skip
    model = grains([[0, 0, 0]], law=bd.LinearContact(E=1e7), walls=walls)
    bd.solve_explicit(model, duration=0.01, dt=1e-4, snapshot_every=100, out=tmp_path / "run.h5")
    with h5py.File(tmp_path / "run.h5") as file:
        point = file["VTKHDF/walls/Points"][()]
    first, last = point[: len(point) // 2], point[len(point) // 2 :]
    arm = first - [1, 0, 0]
    np.testing.assert_allclose(last, np.stack([1.0 - arm[:, 1], arm[:, 0], first[:, 2] + 1.0], axis=1), atol=1e-5)
    assert np.abs(last - first).max() > 5.0


def _area(vertex: np.ndarray, start: np.ndarray) -> float:
    total = 0.0
    for begin, end in pairwise(start):
        arm = vertex[begin:end] - vertex[begin]
        total += 0.5 * np.linalg.norm(np.cross(arm, np.roll(arm, -1, axis=0)).sum(axis=0))
    return total
