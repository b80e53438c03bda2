"""Shapes beyond the plain ones: surfaces, and shapes moved, turned, joined and cut; and packings inside them."""

import importlib.util
import math
from pathlib import Path

import numpy as np
import pytest
import trimesh

import bondem as bd
from bondem.errors import InputError
from bondem.geometry.face_patches import face_patches
from bondem.io.codec import decode, encode

# Surfaces of about a metre, without a unit.
pytestmark = pytest.mark.filterwarnings("ignore::bondem.errors.UnitWarning")

POINTS = np.random.default_rng(0).uniform(-1.5, 3.5, (20_000, 3))


@pytest.fixture(scope="module")
def write(tmp_path_factory):
    """Writes a mesh to a file and returns the path."""

    def to_file(mesh: trimesh.Trimesh, name: str = "part.stl") -> Path:
        path = tmp_path_factory.mktemp("mesh") / name
        mesh.export(path)
        return path

    return to_file


def box_mesh(a=1.0, b=2.0, c=3.0):
    return trimesh.creation.box(bounds=[[0, 0, 0], [a, b, c]])


# -- surfaces ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["part.stl", "part.ply"])
def test_a_box_of_triangles_is_a_box(write, name):
    surface, box = bd.Surface(write(box_mesh(), name)), bd.Box(size=(1.0, 2.0, 3.0))
    assert surface.faces == box.faces
    np.testing.assert_allclose(surface.bounds, box.bounds)
    assert surface.volume == pytest.approx(6.0, rel=1e-12)
    assert surface.area == pytest.approx(22.0, rel=1e-12)
    assert surface.section() == pytest.approx(6.0, rel=1e-12)
    # Outside too, where edges and corners are nearest and their mean normals tell the side.
    np.testing.assert_allclose(surface.depth(POINTS), box.depth(POINTS), atol=1e-12)
    for face in box.faces:
        np.testing.assert_allclose(surface.face_centre(face), box.face_centre(face), atol=1e-12)
        np.testing.assert_allclose(surface.face_depth(face, POINTS), box.face_depth(face, POINTS), atol=1e-12)


def test_a_sphere_of_triangles_is_nearly_a_ball(write):
    mesh = trimesh.creation.icosphere(subdivisions=4, radius=1.0)
    surface, ball = bd.Surface(write(mesh)), bd.Ball(radius=1.0)
    # Flat facets lie below the sphere, at most by a² / 6 for equal sides a.
    sagitta = mesh.edges_unique_length.max() ** 2 / 6.0
    error = ball.depth(POINTS) - surface.depth(POINTS)
    assert error.min() > -1e-6
    assert error.max() < sagitta
    assert surface.faces == ("side",)
    assert surface.volume == pytest.approx(ball.volume, rel=3e-3)
    assert surface.section() == pytest.approx(math.pi, rel=3e-3)


def test_distances_are_those_to_the_nearest_of_all_triangles(write):
    mesh = trimesh.creation.torus(1.0, 0.3, major_sections=24, minor_sections=12)
    points = POINTS[:200]
    corner = mesh.triangles
    # By brute force: 20 000 points spread over the surface cannot be nearer than its nearest point.
    spread = trimesh.sample.sample_surface(mesh, 20_000, seed=1)[0]
    sampled = np.linalg.norm(points[:, None] - spread, axis=2).min(axis=1)
    exact = np.abs(bd.Surface(write(mesh)).depth(points))
    assert len(corner) == 576
    assert (exact <= sampled + 1e-6).all()
    np.testing.assert_allclose(exact, sampled, atol=0.04)


def test_notch_of_an_l_profile_is_inside_out_nowhere(write):
    profile = np.array([[0, 0], [3, 0], [3, 1], [1, 1], [1, 3], [0, 3]], dtype=float)
    bottom = np.column_stack([np.zeros(6), profile])
    top = bottom + np.array([2.0, 0, 0])
    cap = np.array([[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]])
    k, m = np.arange(6), np.roll(np.arange(6), -1)
    triangles = np.vstack([cap[:, ::-1], cap + 6, np.column_stack([k, m, m + 6]), np.column_stack([k, m + 6, k + 6])])
    surface = bd.Surface(vertices=np.vstack([bottom, top]), triangles=triangles)
    legs = bd.Box(size=(2, 3, 1)), bd.Box(size=(2, 1, 3))
    np.testing.assert_array_equal(surface.contains(POINTS), legs[0].contains(POINTS) | legs[1].contains(POINTS))
    assert surface.volume == pytest.approx(10.0)
    assert surface.faces[-1] == "side"
    # The inner faces are the side; the inner edge (y = z = 1) is the nearest of them to (1, 0.6, 0.7).
    assert surface.face_depth("side", np.array([[1.0, 0.6, 0.7]]))[0] == pytest.approx(0.5)


def test_units_are_asked_for_and_converted(write):
    path = write(box_mesh(60.0, 16.0, 6.0))
    with pytest.raises(InputError, match="unit='mm'"):
        bd.Surface(path)
    assert bd.Surface(path, unit="mm").extent == pytest.approx(0.060)
    assert bd.Surface(path, unit="m").extent == pytest.approx(60.0)
    with pytest.raises(InputError, match="the unit of length: 'm', 'cm', 'mm'"):
        bd.Surface(path, unit="furlong")


def test_what_is_no_closed_surface_is_refused(write, tmp_path):
    with pytest.raises(InputError, match="no such file"):
        bd.Surface(tmp_path / "missing.stl")
    with pytest.raises(InputError, match="STL, OBJ, 3MF, PLY and OFF"):
        bd.Surface(tmp_path / "part.step")
    (tmp_path / "empty.stl").write_bytes(b"solid nothing\nendsolid nothing\n")
    with pytest.raises(InputError, match="empty"):
        bd.Surface(tmp_path / "empty.stl")
    box = box_mesh()
    with pytest.raises(InputError, match="3 edges"):
        bd.Surface(write(trimesh.Trimesh(box.vertices, box.faces[1:])))
    turned = np.vstack([box.faces[:1, ::-1], box.faces[1:]])
    with pytest.raises(InputError, match="face the same way"):
        bd.Surface(vertices=box.vertices, triangles=turned)
    inside_out = bd.Surface(vertices=box.vertices, triangles=box.faces[:, ::-1])
    assert inside_out.volume == pytest.approx(6.0)


def cube(low=(0.0, 0.0, 0.0), high=(1.0, 1.0, 1.0), inwards=False):
    mesh = trimesh.creation.box(bounds=[low, high])
    return mesh.vertices, mesh.faces[:, ::-1] if inwards else mesh.faces


def together(*solids):
    first = np.cumsum([0, *(len(x) for x, _ in solids)])
    return {
        "vertices": np.vstack([x for x, _ in solids]),
        "triangles": np.vstack([t + k for (_, t), k in zip(solids, first, strict=False)]),
    }


def test_an_stl_of_several_solids_is_one_closed_body(tmp_path):
    """OpenFOAM, LIGGGHTS and Ansys name the patches of a body so."""
    x, t = cube()
    text = ""
    for k, patch in enumerate(t.reshape(6, 2, 3)):
        facets = "".join(
            "facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {a:.7g} {b:.7g} {c:.7g}\n" for a, b, c in x[one])
            + "endloop\nendfacet\n" for one in patch
        )  # fmt: skip
        text += f"solid patch{k}\n{facets}endsolid patch{k}\n"
    (tmp_path / "patches.stl").write_text(text)
    surface = bd.Surface(tmp_path / "patches.stl", unit="mm")
    assert surface.volume == pytest.approx(1e-9)
    assert len(surface.triangles) == 12


def test_corners_apart_by_the_digits_of_a_file_are_one():
    x, t = cube((10.0, 10.0, 10.0), (11.0, 11.0, 11.0))
    each = x[t].reshape(-1, 3) + np.random.default_rng(1).uniform(-2e-7, 2e-7, (36, 3))
    surface = bd.Surface(vertices=each, triangles=np.arange(36).reshape(12, 3))
    assert surface.volume == pytest.approx(1.0, rel=1e-5)


def test_triangles_that_are_there_twice_are_left_out():
    x, t = cube()
    surface = bd.Surface(vertices=x, triangles=np.vstack([t, t[:2], np.roll(t[:1], 1, axis=1)]))
    assert surface.volume == pytest.approx(1.0)
    assert len(surface.triangles) == 12
    mirrored = x * [-1.0, 1.0, 1.0] + [2.0, 0.0, 0.0], t[:, ::-1]  # the face between them has the same diagonal
    shared = bd.Surface(**together(cube(), mirrored))
    assert shared.volume == pytest.approx(2.0)
    assert shared.depth([[1.0, 0.5, 0.5]])[0] == pytest.approx(0.5)  # no wall between the two
    doubled = bd.Surface(**together(cube(), cube()))
    assert doubled.volume == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("solids", "message"),
    [
        ((cube(), cube((0.5, 0.5, 0.5), (2.0, 2.0, 2.0))), "two of its 2 solids overlap or touch; unite"),
        ((cube(), cube((0.9, 0.9, 0.9), (2.0, 2.0, 2.0))), "overlap or touch"),
        ((cube(), cube((0.4, 0.4, -1.0), (0.6, 0.6, 2.0))), "overlap or touch"),
        ((cube(), cube((1.0, 0.2, 0.2), (2.0, 0.8, 0.8))), "overlap or touch"),
        ((cube(), cube((3.0, 0.0, 0.0), (4.0, 1.0, 1.0)), cube((0.2,) * 3, (0.8,) * 3)), "lies within another"),
    ],
)
def test_solids_that_overlap_are_refused(solids, message):
    """What lay in both counted as outside, silently: of crossing surfaces the nearest has the wrong normal."""
    with pytest.raises(InputError, match=message):
        bd.Surface(**together(*solids))


def test_cavities_and_separate_solids_are_no_overlap():
    hollow = bd.Surface(**together(cube(), cube((0.2,) * 3, (0.8,) * 3, inwards=True)))
    assert hollow.volume == pytest.approx(1.0 - 0.6**3)
    island = together(cube(), cube((0.2,) * 3, (0.8,) * 3, inwards=True), cube((0.4,) * 3, (0.6,) * 3))
    assert bd.Surface(**island).volume == pytest.approx(1.0 - 0.6**3 + 0.2**3)
    apart = bd.Surface(**together(cube(), cube((2.0, 0.0, 0.0), (3.0, 1.0, 1.0), inwards=True)))
    assert apart.volume == pytest.approx(2.0)  # the second is turned
    assert (apart.depth([[0.5, 0.5, 0.5], [2.5, 0.5, 0.5]]) > 0.0).all()
    edge = bd.Surface(**together(cube(), cube((1.0, 1.0, 0.0), (2.0, 2.0, 1.0))))  # an edge of four triangles
    assert edge.volume == pytest.approx(2.0)


def test_edges_of_three_triangles_are_named():
    x, t = cube()
    wall = [[0, 3, 7]] if len({*t[0]} & {0, 3, 7}) < 3 else [[0, 1, 7]]
    with pytest.raises(InputError, match=r"edges have three triangles or more, an odd number: walls inside"):
        bd.Surface(vertices=x, triangles=np.vstack([t, wall]))



# -- shapes of shapes -------------------------------------------------------------------------------------------

PLATE = bd.Box(size=(1.0, 2.0, 3.0))
HOLE = bd.Cylinder(radius=0.3, length=4.0).rotated("y", -math.pi / 2).moved((0.5, 1.0, -0.5))


@pytest.mark.parametrize("shape", [
    bd.Cylinder(radius=1.0, length=3.0), bd.Ball(radius=1.0), PLATE, bd.Surface(vertices=[
        [0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], triangles=[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]),
    bd.Cylinder(radius=1.0, length=3.0).cut(HOLE), PLATE.rotated("x", 0.4) | bd.Ball(radius=1.0),
    PLATE & bd.Ball(radius=9.0),
], ids=lambda shape: type(shape).__name__)  # fmt: skip
def test_bounds_of_turned_shapes_touch_their_walls(shape):
    """All sides of the box are within the distance of sample points of walls that lie in it, and none beyond."""
    placed = shape.rotated("x", 0.7).rotated("z", 0.5).rotated("y", 0.3).moved((5.0, -2.0, 1.0))
    wall = np.vstack([face_patches(placed, face, 0.05)[0] for face in placed.faces])
    lower, upper = placed.bounds
    assert ((wall > lower - 1e-9) & (wall < upper + 1e-9)).all()
    np.testing.assert_allclose(wall.min(axis=0), lower, atol=0.08)
    np.testing.assert_allclose(wall.max(axis=0), upper, atol=0.08)


def test_a_cylinder_turned_about_its_axis_keeps_bounds_and_section():
    cylinder = bd.Cylinder(radius=0.3, length=4.0)
    turned = cylinder.rotated("x", 0.3)
    np.testing.assert_allclose(turned.bounds, cylinder.bounds, atol=1e-15)
    assert turned.section() == cylinder.section()


def test_moved_and_rotated_shapes_are_where_they_should_be():
    centre = np.array([[0.5, 1.0, 1.5]])
    assert HOLE.face_depth("side", centre)[0] == pytest.approx(0.3)
    np.testing.assert_allclose(HOLE.bounds, ([0.2, 0.7, -0.5], [0.8, 1.3, 3.5]))
    np.testing.assert_allclose(HOLE.face_centre("x_max"), [0.5, 1.0, 3.5], atol=1e-12)
    assert HOLE.section() == pytest.approx(0.6 * 4.0, rel=1e-3)
    back = HOLE.moved((-0.5, -1.0, 0.5)).rotated("y", math.pi / 2)
    np.testing.assert_allclose(back.depth(POINTS), bd.Cylinder(radius=0.3, length=4.0).depth(POINTS), atol=1e-12)


def test_a_hole_takes_its_volume_and_names_its_wall():
    plate = PLATE - HOLE
    assert plate.faces == (*PLATE.faces, "cut")
    assert PLATE.cut(HOLE, name="bore").faces[-1] == "bore"
    assert plate.volume == pytest.approx(6.0 - math.pi * 0.09 * 3.0, rel=1e-3)
    assert plate.area == pytest.approx(22.0 + 2.0 * math.pi * (0.3 * 3.0 - 0.09), rel=1e-2)
    assert plate.section() == pytest.approx(6.0 - 0.6 * 3.0, rel=1e-3)
    points = np.array([[0.5, 1.0, 1.5], [0.5, 1.5, 1.5], [0.5, 1.9, 1.5]])
    np.testing.assert_allclose(plate.depth(points), [-0.3, 0.2, 0.1], atol=1e-12)
    np.testing.assert_allclose(plate.face_depth("cut", points), [-0.3, 0.2, 0.6], atol=1e-12)
    np.testing.assert_allclose(plate.face_centre("cut"), [0.5, 1.0, 1.5])


def test_overlap_and_joined():
    corner = bd.Box(size=(1.0, 1.0, 1.0)) & bd.Ball(radius=1.0)
    assert corner.volume == pytest.approx(math.pi / 6.0, rel=1e-3)
    assert corner.area == pytest.approx(5.0 * math.pi / 4.0, rel=1e-2)
    with pytest.raises(InputError, match="do not intersect"):
        _ = PLATE & bd.Ball(radius=0.1).moved((9, 9, 9))
    beside, corner = bd.Ball(radius=0.5).moved((9, 9, 9)), bd.Box(size=(1.0, 1.0, 1.0)).moved(PLATE.size)
    for miss in (beside, corner, PLATE.moved((0.0, 0.0, PLATE.size[2] * (1.0 - 1e-15)))):
        with pytest.raises(InputError, match="do not intersect"):
            PLATE.cut(miss, name="notch")
    with pytest.raises(InputError, match="do not intersect"):  # although the boxes around them do
        bd.Ball(radius=1.0).cut(bd.Box((0.3, 0.3, 0.3)).moved((0.75, 0.75, 0.0)))
    grip, gauge = bd.Box(size=(1.0, 1.0, 1.0)), bd.Box(size=(3.0, 0.5, 0.5)).moved((0.5, 0.25, 0.25))
    bar = grip | gauge | grip.moved((3.0, 0.0, 0.0))
    assert bar.volume == pytest.approx(2.5, rel=1e-3)
    assert bar.section() == pytest.approx(0.25, rel=1e-3)
    # The shoulders face +x and -x too, but only the ends are faces.
    shoulder, end = np.array([[0.95, 0.05, 0.05]]), np.array([[3.95, 0.5, 0.5]])
    assert bar.face_depth("x_max", end)[0] == pytest.approx(0.05)
    assert np.isinf(bar.face_depth("x_max", shoulder)[0])
    assert bar.depth(shoulder)[0] == pytest.approx(0.05)


def test_periodic_cells_cannot_be_cut():
    with pytest.raises(InputError, match="Box of the same size"):
        _ = bd.Cell(size=(1.0, 1.0, 1.0)) - HOLE


def test_every_shape_survives_the_run_file():
    surface = bd.Surface(vertices=box_mesh().vertices, triangles=box_mesh().faces)
    shape = ((PLATE | surface.moved((0.2, 0.1, 0.0))) - HOLE) & bd.Ball(radius=2.5)
    again = decode(encode(shape))
    np.testing.assert_array_equal(again.depth(POINTS), shape.depth(POINTS))
    assert again.faces == shape.faces


# -- packings and carvings --------------------------------------------------------------------------------------

NOTCHED = bd.Box(size=(4.0, 1.0, 1.0)).cut(bd.Box(size=(0.2, 0.6, 2.0)).moved((1.9, 0.6, -0.5)), name="notch")


@pytest.mark.parametrize(
    "shape",
    [
        NOTCHED,
        bd.Box(size=(1.4, 2.0, 3.0)) - HOLE.moved((0.2, 0.0, 0.0)),
        bd.Cylinder(radius=1.0, length=4.0).rotated("z", 0.3),
        bd.Surface(vertices=box_mesh().vertices, triangles=box_mesh().faces),
    ],
    ids=["notch", "hole", "rotated", "surface"],
)
def test_any_shape_is_packed_to_its_walls(shape):
    packed = bd.pack(shape, count=1000, spread=0.25, seed=1)
    lattice = bd.connect(packed)
    assert len(packed) == 1000
    assert lattice.coordination_number == pytest.approx(6.2, abs=0.02)
    assert bd.fabric(lattice).volume_fraction == pytest.approx(0.615, abs=0.02)
    gap = (shape.depth(packed.position) - packed.radius) / packed.mean_radius
    assert gap.min() > -0.05
    assert (np.abs(gap) < 0.02).mean() > 0.25
    for face in shape.faces:
        assert len(bd.Face(face).select(lattice)) > 10


def test_faces_survive_carving():
    block = bd.connect(bd.pack(bd.Box(size=(4.0, 1.0, 1.0)), count=1500, spread=0.25, seed=1))
    beam = bd.carve(block, NOTCHED)
    x, y, _ = block.particles.position.T
    gone = (np.abs(x - 2.0) < 0.1) & (y > 0.6)
    np.testing.assert_array_equal(beam.particles.position, block.particles.position[~gone])
    assert gone.mean() == pytest.approx(0.02, abs=0.01)  # of the volume
    at_end, at_notch = bd.Face("x_min").select(beam), bd.Face("notch").select(beam)
    off = beam.particles.position[at_end, 0] - beam.particles.radius[at_end]
    assert np.abs(off).max() <= 0.0201 * beam.particles.mean_radius
    assert len(at_end) == len(bd.Face("x_min").select(block))
    # A carved wall is rough: spheres it runs through belong to it, centres inside.
    reach = NOTCHED.face_depth("notch", beam.particles.position[at_notch])
    assert (reach >= 0.0).all()
    assert (reach <= beam.particles.radius[at_notch] + 0.03 * beam.particles.mean_radius).all()


@pytest.mark.validate
def test_the_dog_bone_strains_in_its_gauge():
    path = Path(__file__).parents[2] / "examples" / "dog_bone.py"
    spec = importlib.util.spec_from_file_location("dog_bone", path)
    example = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(example)
    lattice, measured, by_sections = example.main(2500)
    assert by_sections == pytest.approx(1.267, abs=1e-3)
    assert measured == pytest.approx(by_sections, rel=0.06)
    assert lattice.particles.envelope.volume == pytest.approx(4.01e-6, rel=2e-3)


@pytest.mark.parametrize("thickness", [0.1e-3, 0.3e-3, 1e-3])
def test_thin_rings_have_their_volume(thickness: float) -> None:
    """Of a section as high as wide, about a bore of 16 mm: discs much flatter than wide are measured as well."""
    radius = 8e-3
    bore = bd.Cylinder(radius=radius - 0.5 * thickness, length=3.0 * thickness).moved((-thickness, 0.0, 0.0))
    ring = bd.Cylinder(radius=radius + 0.5 * thickness, length=thickness).cut(bore, name="bore")
    assert ring.volume == pytest.approx(2.0 * np.pi * radius * thickness**2, rel=0.02)


def test_a_ring_whose_ends_lie_in_one_plane_leaves_no_wall_in_the_core() -> None:
    """A slot around a bar: in its ligament the nearest wall is that of the slot, and packings fill it."""
    ring = bd.Cylinder(radius=2.0, length=0.2).cut(bd.Cylinder(radius=0.6, length=0.2))
    bar = bd.Cylinder(radius=1.0, length=4.0).cut(ring.moved((1.9, 0.0, 0.0)), name="notch")
    x = np.linspace(1.7, 2.3, 61)
    r = np.linspace(0.0, 0.55, 12)
    points = np.array([(a, b, 0.0) for a in x for b in r])
    # towards the edge of the slot the distance along the bar or across it, whichever is longer
    beside = np.maximum(np.abs(points[:, 0] - 2.0) - 0.1, 0.6 - points[:, 1])
    np.testing.assert_allclose(bar.depth(points), np.minimum(beside, 1.0 - points[:, 1]), atol=1e-12)
    np.testing.assert_allclose(bar.face_depth("notch", points), beside, atol=1e-12)
    # the same turned, and with boxes
    turned = bar.rotated("z", 0.3).moved((0.1, 0.2, 0.3))
    moved = np.array([[math.cos(0.3), -math.sin(0.3), 0.0], [math.sin(0.3), math.cos(0.3), 0.0], [0.0, 0.0, 1.0]])
    np.testing.assert_allclose(turned.depth(points @ moved.T + (0.1, 0.2, 0.3)), bar.depth(points), atol=1e-12)
    frame = bd.Box((4.0, 4.0, 1.0)).cut(bd.Box((2.0, 2.0, 1.0)).moved((1.0, 1.0, 0.0)))
    plate = bd.Box((4.0, 4.0, 3.0)).cut(frame.moved((0.0, 0.0, 1.0)))
    assert plate.depth([[2.0, 2.0, 1.0]]) == pytest.approx([1.0])


def test_a_cut_by_all_of_a_shape_leaves_nothing() -> None:
    box = bd.Box((1.0, 1.0, 1.0))
    assert (box.cut(box).depth(np.random.default_rng(0).uniform(-0.5, 1.5, (200, 3))) <= 0.0).all()
