"""Patches of surfaces: faces of a CAD part between sharp edges, their numbers, and loads on them."""

import numpy as np
import pytest
import trimesh
from scipy.spatial import ConvexHull

import bondem as bd
from bondem.errors import InputError
from bondem.io.codec import decode, encode
from tests.scripts import scripts

STEEL = bd.CellBond(E=210e9, nu=0.3)


def of(mesh, **options):
    return bd.Surface(vertices=1e-3 * mesh.vertices, triangles=mesh.faces, **options)


@pytest.fixture(scope="module")
def bracket():
    return bd.Surface("examples/bracket.stl", unit="mm")


@pytest.fixture(scope="module")
def body(bracket):
    return bd.connect(bd.pack(bracket, count=400, method="even", seed=1), method="laguerre")


def rounded_box(radius=2.0, half=(20.0, 10.0, 6.0)):
    """Corners and triangles of a box whose edges and corners are rounded, about its middle."""
    ball = trimesh.creation.uv_sphere(radius, count=[32, 32]).vertices
    corner = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * half
    vertices = (ball[None] + corner[:, None]).reshape(-1, 3)
    hull = ConvexHull(vertices)
    a, b, c = np.moveaxis(vertices[hull.simplices], 1, 0)
    inwards = (np.cross(b - a, c - a) * hull.equations[:, :3]).sum(axis=1) < 0.0
    triangles = np.where(inwards[:, None], hull.simplices[:, ::-1], hull.simplices)
    return 1e-3 * vertices, triangles


def test_patches_end_at_sharp_edges():
    tube = of(trimesh.creation.annulus(5, 10, 30, sections=64))
    outer, bore, *ends = tube.patches
    assert [one.name for one in tube.patches] == ["patch:1", "patch:2", "patch:3", "patch:4"]
    assert outer.area == pytest.approx(2 * bore.area)
    assert [one.normal[2] for one in ends] == pytest.approx([-1.0, 1.0])
    np.testing.assert_allclose(bore.normal, 0.0, atol=1e-12)
    assert sum(one.area for one in tube.patches) == pytest.approx(tube.area)
    # the angle is the user's: the strips of the bore and of the outside, each on its own
    assert len(of(trimesh.creation.annulus(5, 10, 30, sections=64), sharp=0.09).patches) == 2 + 2 * 64


def test_planes_end_at_roundings():
    patches = bd.Surface(vertices=(rounding := rounded_box())[0], triangles=rounding[1]).patches
    assert len(patches) == 7
    flat = [one for one in patches if np.linalg.norm(one.normal) > 0.999]
    assert len(flat) == 6
    assert flat[0].area == pytest.approx(40e-3 * 20e-3, rel=1e-3)


def test_numbers_do_not_depend_on_the_order_of_triangles():
    vertices, triangles = rounded_box()
    one = bd.Surface(vertices=vertices, triangles=triangles)
    random = np.random.default_rng(0)
    order, corners = random.permutation(len(triangles)), random.permutation(len(vertices))
    back = np.argsort(corners)
    other = bd.Surface(vertices=vertices[corners], triangles=np.roll(back[triangles], 1, axis=1)[order])
    for a, b in zip(one.patches, other.patches, strict=True):
        assert a.name == b.name
        np.testing.assert_allclose(a.centre, b.centre, atol=1e-12)
        assert a.area == pytest.approx(b.area, rel=1e-12)


def test_slivers_join_no_faces_and_are_none():
    """Normals of triangles without height are rounding, which once may look smooth to two faces at an edge."""
    mesh = trimesh.creation.box((10, 10, 10))
    for height in (1e-8, 1e-12):
        a, b, c = mesh.faces[0]
        x = mesh.vertices
        corner = 0.5 * (x[a] + x[b]) + height * (x[c] - x[a])
        split = [[a, b, 8], [b, c, 8], [c, a, 8]]
        surface = bd.Surface(vertices=1e-3 * np.vstack([x, corner]), triangles=np.vstack([mesh.faces[1:], split]))
        assert [one.area for one in surface.patches] == pytest.approx([1e-4] * 6)


def test_a_patch_is_found_by_its_place_and_direction(bracket):
    up = bracket.patch(normal=(0, 0, 2))
    assert up.area == pytest.approx(32e-3 * 12e-3)  # the foot; the end of the arm is smaller
    assert bracket.patch(near=(36e-3, 6e-3, 31e-3)).name == bracket.patch(normal=(0, 0, 1), near=(0.04, 0, 0.03)).name
    assert bracket.patch(near=(36e-3, 6e-3, 31e-3)).area == pytest.approx(8e-3 * 12e-3)
    for wrong in ({}, {"normal": (1, 1, 1)}, {"normal": (0, 0, 0)}, {"near": (0, 0)}):
        with pytest.raises(InputError):
            bracket.patch(**wrong)


@pytest.mark.parametrize("cells", [True, False])
def test_pressure_on_a_patch_has_its_resultant(bracket, body, cells):
    specimen = body if cells else bd.connect(bd.pack(bracket, count=400, seed=1))
    for one in bracket.patches:
        _, load = bd.Pressure(bd.Face(one.name, depth=0.3), 2e6).nodal(specimen)
        np.testing.assert_allclose(load[:, :3].sum(axis=0), -2e6 * one.area * one.normal, atol=1e-9 * 2e6 * one.area)


def test_patches_of_placed_and_cut_shapes(bracket):
    """Facets of a face come first from the surface, wherever it is, and end where it is cut."""
    foot = bracket.patch(normal=(0, 0, 1)).name
    moved = bracket.rotated("x", 0.3).moved((0.1, 0, 0)).cut(bd.Box((5e-3, 0.1, 0.1)).moved((0.1, -0.05, -0.05)))
    specimen = bd.connect(bd.pack(moved, count=300, method="even", seed=1), method="laguerre")
    free, on = specimen.cells.free, specimen.on_face(foot)
    area = (free.area[on, None] * free.normal[on]).sum(axis=0)
    np.testing.assert_allclose(area, 27e-3 * 12e-3 * np.array([0, -np.sin(0.3), np.cos(0.3)]), atol=1e-12)
    assert bd.Face(foot).select(specimen).size
    joined = bracket | bracket.moved((0, 0.012, 0))
    with pytest.raises(InputError, match="no face 'patch:4'"):  # which of both?
        joined.face_centre("patch:4")


def test_patches_are_faces_of_all_conditions(bracket, body):
    foot, top = (bd.Face(bracket.patch(near=point).name) for point in ((0, 6e-3, 4e-3), (36e-3, 6e-3, 30e-3)))
    model = bd.Model(body, STEEL, density=7850.0, boundary=[bd.Fix(foot), bd.Load(top, force=(0, 10.0, 0))])
    named = bd.Model(body, STEEL, density=7850.0, boundary=[
        bd.Fix(bd.Face("x_min")), bd.Load(bd.Face("z_max"), force=(0, 10.0, 0))])  # fmt: skip
    np.testing.assert_array_equal(bd.solve_static(model).displacement, bd.solve_static(named).displacement)
    driven = bd.Model(body, STEEL, density=7850.0, boundary=[bd.Fix(foot), bd.Drive(top, vy=1.0)])
    gauges = {"patch": bd.Gauge(top, "force"), "face": bd.Gauge(bd.Face("z_max"), "force")}
    run = bd.solve_explicit(driven, duration=1e-6, every=5, gauges=gauges)
    assert run.history["face"][-1, 1] != 0.0
    np.testing.assert_array_equal(run.history["patch"], run.history["face"])
    again = decode(encode(bracket))
    assert [one.name for one in again.patches] == [one.name for one in bracket.patches]


def test_the_picture_names_the_patches(bracket, tmp_path):
    figure = bracket.plot(tmp_path / "bracket.png")
    written = {text.get_text() for axes in figure.axes for text in axes.texts}
    assert written >= {one.name for one in bracket.patches}
    assert figure.axes[0].get_title("left") == "4 of 8 patches in this view"


@pytest.mark.parametrize(("count", "accuracy"), [(400, 0.02), pytest.param(3000, 0.006, marks=pytest.mark.validate)])
def test_a_tube_under_pressure_widens_as_lame_says(count, accuracy):
    """The pressure in the bore has its resultant on one half of it, p · width · length, whatever the cells are."""
    half, widening = scripts("examples", vessel="pressure_vessel")["vessel"].main(count)
    assert half == pytest.approx(1.0, abs=1e-12)
    assert widening == pytest.approx(1.0, abs=accuracy)


def test_a_patch_that_ends_within_a_plane_says_what_its_facets_cover():
    """Cells end at planes: facets across the border of a pad on a plane belong to the pad or not."""
    corner = 1e-3 * np.array([(x, y, z) for x in (0, 10) for y in (0, 10) for z in (0, 10)])
    pad = 1e-3 * np.array([(3, 3, 10), (7, 3, 10), (7, 7, 10), (3, 7, 10)])
    ring = [1, 5, 7, 3]  # the corners of the upper side, counter-clockwise
    top = [(8, 9, 10), (8, 10, 11)]
    for k in range(4):
        a, b, c, d = ring[k], ring[(k + 1) % 4], 8 + (k + 1) % 4, 8 + k
        top += [(a, b, c), (a, c, d)]
    box = trimesh.creation.box(bounds=1e-3 * np.array([(0, 0, 0), (10, 10, 10)]))
    place = [int(np.abs(corner - one).sum(axis=1).argmin()) for one in box.vertices]
    rest = np.array(place)[box.faces[box.face_normals[:, 2] < 0.5]]
    surface = bd.Surface(vertices=np.vstack([corner, pad]), triangles=np.vstack([top, rest]), named={"pad": [0, 1]})
    assert surface.face_centre("pad")[2] == pytest.approx(10e-3)
    body = bd.connect(bd.pack(surface, count=200, method="even", seed=1), method="laguerre")
    with pytest.warns(bd.errors.FaceWarning, match=r"the facets on 'pad' cover .* m² of its 1.6e-05 m²"):
        body.on_face("pad")


def test_one_number_is_no_list_of_triangles() -> None:
    with pytest.raises(InputError, match=r"triangles \(1,\)"):
        bd.Surface(vertices=np.zeros((3, 3)), triangles=-1.0, named={"pad": [0]})
