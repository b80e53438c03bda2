"""Crack surfaces: areas by the divergence theorem, planes and roughness where both are known, and what is refused."""

import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from tests.models import parted
from tests.specimens import cells, cubes, grid

LAW = bd.CellBond(E=1e9, nu=0.2)
BEAMS = bd.EulerBernoulli(E=1e7, nu=0.2, radius_ratio=0.5)


@pytest.mark.parametrize(
    ("shape", "section"), [(bd.Box((1.0, 1.0, 0.8)), 0.8), (bd.Cylinder(0.5, 1.0), 0.25 * math.pi)]
)
def test_a_crack_through_a_body_has_the_section_as_projected_area(shape: bd.Shape, section: float) -> None:
    """Σ A n·e over what separates two ends of a prism is its section; here every n·e has the same sign."""
    body = cells(shape, 300)
    side = body.particles.position[:, 0] > 0.5
    found = bd.cracks(body, parted(body, side))
    between = np.flatnonzero(side[body.pairs[:, 0]] != side[body.pairs[:, 1]])
    np.testing.assert_array_equal(found.facets, between)
    np.testing.assert_array_equal(found.areas, body.facets.area[between])
    assert found.projected_area((1.0, 0.0, 0.0)) == pytest.approx(section, rel=1e-9)
    assert found.area == found.areas.sum() > 1.2 * section
    assert found.surfaces.count.tolist() == [len(between)]
    assert found.surfaces.area[0] == pytest.approx(found.area)
    # its own plane is that of the largest Σ A (n·m)²
    m = found.surfaces.normal[0]
    n = found.normal
    assert (found.areas * (n @ m) ** 2).sum() >= (found.areas * n[:, 0] ** 2).sum()
    np.testing.assert_allclose(m, [1.0, 0.0, 0.0], atol=0.15)
    np.testing.assert_array_equal(found.opening, 0.0)


def test_polygons_are_the_facets() -> None:
    body = cells(bd.Cylinder(0.5, 1.0), 300)
    found = bd.cracks(body, parted(body, body.centre[:, 0] > 0.5))
    outline, after = found.polygons, np.arange(1, len(found.polygons.vertex) + 1)
    after[outline.start[1:] - 1] = outline.start[:-1]
    twice = np.add.reduceat(np.cross(outline.vertex, outline.vertex[after]), outline.start[:-1], axis=0)
    area = np.zeros((len(found), 3))
    np.add.at(area, outline.facet, 0.5 * twice)
    np.testing.assert_allclose(area, found.areas[:, None] * found.normal, atol=1e-9)


def test_an_even_crack_is_flat_and_a_tilted_one_has_its_normal() -> None:
    for angle in (0.0, 0.4):
        body = cubes((4, 3, 2), angle=angle)
        found = bd.cracks(body, parted(body, cubes((4, 3, 2)).centre[:, 0] > 2.0))
        normal = np.array([math.cos(angle), math.sin(angle), 0.0])
        plane = found.surfaces
        assert (len(found), len(plane)) == (6, 1)
        np.testing.assert_allclose(plane.normal[0], normal, atol=1e-12)
        np.testing.assert_allclose(plane.position[0], 2.0 * normal + 1.5 * np.array([-normal[1], normal[0], 0])
                                   + [0.0, 0.0, 1.0], atol=1e-12)  # fmt: skip
        assert plane.roughness[0] == pytest.approx(1.0, abs=1e-12)
        assert plane.deviation[0] == pytest.approx(0.0, abs=1e-12)
        np.testing.assert_allclose(plane.extent[0], [3.0 * normal[1], 3.0 * normal[0], 2.0], atol=1e-12)


def test_a_stair_is_as_rough_as_it_is() -> None:
    """One step of height 1 in a crack of 4 × 1 and 2 × 1 cells: 6 facets across x, 1 across z between them."""
    body, x = cubes((4, 1, 6)), cubes((4, 1, 6)).centre
    found = bd.cracks(body, parted(body, np.where(x[:, 2] < 4.0, x[:, 0] > 2.0, x[:, 0] > 1.0)))
    assert found.area == 7.0
    surface = found.surfaces
    assert surface.count.tolist() == [7]
    # Σ A n⊗n is diagonal: the mean plane lies across x
    assert surface.projected_area[0] == pytest.approx(6.0)
    assert surface.roughness[0] == pytest.approx(7.0 / 6.0)
    middle = (4 * 2.0 + 2 * 1.0 + 1.5) / 7.0
    off = (4 * (2.0 - middle) ** 2 + 2 * (1.0 - middle) ** 2 + (1.5 - middle) ** 2) / 7.0
    assert surface.deviation[0] == pytest.approx(math.sqrt(off))


def test_surfaces_that_do_not_touch_are_apart_the_largest_first() -> None:
    body, x = cubes((6, 3, 2), angle=0.0), cubes((6, 3, 2)).centre
    side = (x[:, 0] > 4.0).astype(int) + 2 * (np.abs(x - [0.5, 0.5, 0.5]).max(axis=1) < 0.1)
    found = bd.cracks(body, parted(body, side))
    assert found.surfaces.area.tolist() == [6.0, 3.0]
    assert np.bincount(found.surface).tolist() == [6, 3]
    assert (found.centroid[found.surface == 0, 0] == 4.0).all()


def test_softened_facets_count_where_asked() -> None:
    body = cubes((4, 3, 2))
    state = parted(body, cubes((4, 3, 2)).centre[:, 0] > 2.0, to=0.3)
    assert len(bd.cracks(body, state)) == len(bd.cracks(body, state).surfaces) == 0
    assert bd.cracks(body, state).area == 0.0
    assert bd.cracks(body, state, integrity=0.29).area == 0.0
    assert bd.cracks(body, state, integrity=0.3).area == 6.0


@pytest.mark.parametrize("law", [LAW, BEAMS])
def test_cracks_go_and_turn_with_what_they_part(law: bd.CellBond | bd.EulerBernoulli) -> None:
    """All turns by 90° about z, then one side goes away by 0.2 along the crack's normal and slides by 0.1."""
    body, x = cubes((4, 3, 2)), cubes((4, 3, 2)).centre
    if law is BEAMS:
        body = bd.Lattice(body.particles, body.pairs)
    side = x[:, 0] > 2.0
    state = parted(body, side, law)
    place = x @ np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]) + side[:, None] * [0.0, 0.2, 0.1]
    half = math.sqrt(0.5)
    state.set_pose(position=place, orientation=np.tile([half, 0.0, 0.0, half], (len(x), 1)))
    found = bd.cracks(body, state)
    np.testing.assert_allclose(found.normal, np.tile([0.0, 1.0, 0.0], (6, 1)), atol=1e-12)
    np.testing.assert_allclose(found.opening, 0.2, atol=1e-12)
    np.testing.assert_allclose(found.sliding, 0.1, atol=1e-12)
    np.testing.assert_allclose(found.centroid[:, 1], 2.1, atol=1e-12)
    np.testing.assert_allclose(found.polygons.vertex[:, 1], 2.1, atol=1e-12)
    assert len(found.surfaces) == 1
    np.testing.assert_allclose(found.surfaces.normal[0], [0.0, 1.0, 0.0], atol=1e-12)


def test_beams_crack_as_discs_of_their_sections() -> None:
    body = grid((4, 3, 2), 1.0, walled=True)
    found = bd.cracks(body, parted(body, cubes((4, 3, 2)).centre[:, 0] > 2.0, BEAMS))
    np.testing.assert_allclose(found.areas, math.pi * 0.25**2)
    np.testing.assert_allclose(found.centroid[:, 0], 2.0)
    assert found.polygons.start.tolist() == [24 * k for k in range(7)]
    outline = found.polygons.vertex.reshape(6, 24, 3)
    twice = np.cross(outline, np.roll(outline, -1, axis=1)).sum(axis=1)
    np.testing.assert_allclose(0.5 * twice, found.areas[:, None] * found.normal, atol=1e-12)
    assert found.surfaces.count.tolist() == [6]
    apart = np.isin(np.arange(24), [0, 23])  # corners of the grid that lie farther than 1.5 diameters apart
    assert len(bd.cracks(body, parted(body, apart, BEAMS)).surfaces) == 2


def test_a_crack_across_the_edge_of_a_periodic_cell_is_one_plane() -> None:
    """Two walls part a slab from the rest; each goes on through the edges of the cell, as does the one at x = 0."""
    body = cells(bd.Cell((1.0, 1.0, 1.0)), 400)
    inside = body.particles.position[:, 0] < 0.4
    found = bd.cracks(body, parted(body, inside))
    assert found.projected_area((1.0, 0.0, 0.0)) == pytest.approx(2.0, rel=1e-9)
    assert len(found.surfaces) == 2
    for surface in range(2):
        own = found.surface == surface
        assert found.areas[own] @ np.abs(found.normal[own, 0]) == pytest.approx(1.0, rel=1e-9)
    # of the order of a cell's size, 0.14, though facets at x = 0 lie at both ends of the cell
    assert (found.surfaces.deviation < 0.1).all()
    x = np.sort(np.mod(found.surfaces.position[:, 0] + 0.2, 1.0)) - 0.2
    np.testing.assert_allclose(x, [0.0, 0.4], atol=0.05)


def test_paraview_reads_the_surfaces(tmp_path: Path) -> None:
    pyvista = pytest.importorskip("pyvista")
    body = cells(bd.Cylinder(0.5, 1.0), 300)
    found = bd.cracks(body, parted(body, body.centre[:, 0] > 0.5))
    found.write_vtkhdf(tmp_path / "cracks.vtkhdf")
    mesh = pyvista.read(tmp_path / "cracks.vtkhdf")
    assert mesh.n_cells == len(found.polygons)
    assert mesh.area == pytest.approx(found.area, rel=1e-6)
    row = found.polygons.facet
    np.testing.assert_array_equal(mesh.cell_data["facet"], found.facets[row])
    np.testing.assert_array_equal(mesh.cell_data["opening"], found.opening[row])
    none = bd.cracks(body, bd.Model(body, LAW, 1e3).state())
    none.write_vtkhdf(tmp_path / "none.vtkhdf")
    assert pyvista.read(tmp_path / "none.vtkhdf").n_cells == 0


REFUSED: dict[str, tuple[str, Callable[[], object]]] = {
    "another state": ("its own lattice", lambda: bd.cracks(cubes((4, 3, 2)), parted(cubes((4, 1, 6)), np.zeros(24)))),
    "no lattice": ("the lattice of the model", lambda: bd.cracks(None, None)),
    "no state": ("the state of a run", lambda: bd.cracks(cubes((4, 3, 2)), None)),
    "whole facets": (
        "integrity = 1.0", lambda: bd.cracks(cubes((4, 3, 2)), parted(cubes((4, 3, 2)), np.zeros(24)), integrity=1.0)
    ),
    "no file": (
        "give a path", lambda: bd.cracks(cubes((4, 3, 2)), parted(cubes((4, 3, 2)), np.zeros(24))).write_vtkhdf(3)
    ),
    "no direction": (
        "direction has no length",
        lambda: bd.cracks(cubes((4, 3, 2)), parted(cubes((4, 3, 2)), np.zeros(24))).projected_area((0.0, 0.0, 0.0)),
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_no_crack_is_refused_in_one_line(name: str) -> None:
    message, ask = REFUSED[name]
    with pytest.raises(InputError, match=message) as caught:
        ask()
    assert "\n" not in str(caught.value)
