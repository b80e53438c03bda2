"""Files of surfaces: formats, units, names of parts, and flaws, which are mended or refused in one line."""

import zipfile

import numpy as np
import pytest
import trimesh

import bondem as bd
from bondem.errors import InputError
from bondem.geometry.surface_files import threemf
from bondem.geometry.surface_files.polygons import ears
from bondem.io.codec import decode, encode

CUBE = 10.0 * np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)])
QUADS = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
TRIANGLES = [(a, *two) for a, b, c, d in QUADS for two in ((b, c), (c, d))]
# A star whose plane faces are not convex; a fan of triangles covers places outside of it.
ARROW = np.array([(0, 0), (4, 0), (4, 4), (2, 1), (0, 4)], dtype=float)


def obj(vertices, polygons, groups=None, *, end="\n", back=False, key="g"):
    """Text of an OBJ file; `back` counts corners from the latest one."""
    lines = ["# a part", "mtllib part.mtl", *("v {:.9g} {:.9g} {:.9g}".format(*one) for one in vertices), "vn 0 0 1"]
    for k, polygon in enumerate(polygons):
        lines += [] if groups is None else [f"{key} {groups[k]}", "usemtl steel", "s off"]
        shift = -len(vertices) if back else 1
        lines.append("f " + " ".join(f"{corner + shift}//1" for corner in polygon))
    return end.join([*lines, "l 1 2", ""])


def surface(tmp_path, text, name="part.obj", **options):
    path = tmp_path / name
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return bd.Surface(path, **{"unit": "mm"} | options)


def refused(tmp_path, text, name="part.obj", **options):
    """Message of the refusal, of one line and with the name of the file."""
    with pytest.raises(InputError) as caught:
        surface(tmp_path, text, name, **options)
    message = str(caught.value)
    assert "\n" not in message
    assert name in message
    return message


@pytest.mark.parametrize("text", [
    pytest.param(obj(CUBE, QUADS), id="plain"),
    pytest.param(obj(CUBE, QUADS, end="\r\n"), id="Windows"),
    pytest.param(obj(CUBE, QUADS, back=True), id="counted back"),
    pytest.param(obj(CUBE, QUADS).replace("f ", "f \\\n "), id="continued lines"),
])  # fmt: skip
def test_obj_of_quads_is_a_box(tmp_path, text):
    box = surface(tmp_path, text)
    assert box.faces == bd.Box((1, 1, 1)).faces
    assert box.volume == pytest.approx(1e-6, rel=1e-12)
    assert not box.named


@pytest.mark.parametrize("mesh", [
    trimesh.creation.icosphere(subdivisions=4), trimesh.creation.torus(1.0, 0.2),
    trimesh.creation.annulus(0.99, 1, 1), trimesh.creation.box((1.0, 1.0, 1e-5)),
], ids=["ball", "ring", "tube", "sheet"])  # fmt: skip
def test_sound_surfaces_do_not_intersect_themselves(mesh):
    """However they are turned and placed."""
    for k in range(4):
        turn = trimesh.transformations.random_rotation_matrix(np.random.default_rng(k).random(3))[:3, :3]
        bd.Surface(vertices=1e-2 * mesh.vertices @ turn + 10.0 ** (k - 4), triangles=mesh.faces)


def test_polygons_of_obj_need_not_be_convex(tmp_path):
    count = len(ARROW)
    vertices = np.vstack([np.column_stack([ARROW, np.full(count, z)]) for z in (0.0, 2.0)])
    sides = [(k, (k + 1) % count, (k + 1) % count + count, k + count) for k in range(count)]
    ends = [tuple(range(count))[::-1], tuple(range(count, 2 * count))]
    arrow = surface(tmp_path, obj(vertices, [*ends, *sides], ["low", "high"] + ["round"] * count))
    a, b = ARROW, np.roll(ARROW, -1, axis=0)
    outline = 0.5 * abs((a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum())
    area = {one.name: one.area for one in arrow.patches}
    assert area["low"] == pytest.approx(outline * 1e-6)
    assert area["high"] == pytest.approx(outline * 1e-6)
    assert arrow.volume == pytest.approx(2.0 * outline * 1e-9)
    assert not arrow.contains([2e-3, 2.5e-3, 1e-3])[0]  # in the notch
    # a square with a hole, joined to the outline by a seam that is named twice
    ring = np.array([(0, 0), (3, 0), (3, 3), (0, 3), (0, 0), (1, 1), (1, 2), (2, 2), (2, 1), (1, 1)], dtype=float)
    a, b, c = np.moveaxis(ring[ears(np.column_stack([ring, 0 * ring[:, :1]]))], 1, 0)
    parts = 0.5 * ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
    assert (parts >= 0.0).all()
    assert parts.sum() == pytest.approx(8.0)


def test_groups_and_objects_are_faces(tmp_path):
    names = ["inlet", "outlet", "wall", "wall", "side", "patch:1"]
    for key in "go":
        box = surface(tmp_path, obj(CUBE, QUADS, names, key=key))
        own = {one.name: one for one in box.patches}
        # names that bondem uses itself do not hide its faces
        assert list(own)[:5] == ["inlet", "outlet", "wall", "group:side", "group:patch:1"]
        np.testing.assert_allclose(own["inlet"].normal, [-1, 0, 0], atol=1e-12)
        assert own["wall"].area == pytest.approx(2e-4)
        np.testing.assert_allclose(own["wall"].normal, 0.0, atol=1e-12)
        np.testing.assert_allclose(box.face_centre("outlet"), [10e-3, 5e-3, 5e-3])
        np.testing.assert_allclose(box.face_depth("inlet", [[2e-3, 5e-3, 5e-3]]), 2e-3)
    again = decode(encode(box))
    assert {name: list(rows) for name, rows in again.named.items()} == {
        name: list(rows) for name, rows in box.named.items()
    }
    with pytest.raises(InputError, match="and patches: inlet, outlet, wall, group:side"):
        box.face_depth("outflow", np.zeros((1, 3)))


def test_solids_of_stl_are_faces_in_any_encoding(tmp_path):
    text = ""
    for name, quad in zip(["Körper", "Deckel", "Deckel", "c", "", "e"], QUADS, strict=True):
        text += f"solid {name}\r\n"
        for corners in (quad[:3], (quad[0], *quad[2:])):
            text += "facet normal 0 0 0\r\n outer loop\r\n"
            text += "".join("  vertex {:g} {:g} {:g}\r\n".format(*CUBE[k]) for k in corners)
            text += " endloop\r\nendfacet\r\n"
        text += f"endsolid {name}\r\n"
    for encoding in ("utf-8", "latin-1"):
        box = surface(tmp_path, text.encode(encoding), "part.stl")
        assert list(box.named) == ["Körper", "Deckel", "c", "e"]
        assert [one.area for one in box.patches[:2]] == pytest.approx([1e-4, 2e-4])
    assert "35 corners, not three for each" in refused(tmp_path, text[: text.rfind("vertex")], "cut.stl")
    assert "no number" in refused(tmp_path, text.replace("vertex 10 ", "vertex 1,0 "), "comma.stl")


def test_binary_stl_that_was_cut_is_refused_with_its_numbers(tmp_path):
    data = trimesh.creation.box((10, 10, 10)).export(file_type="stl")
    assert surface(tmp_path, data, "part.stl").volume == pytest.approx(1e-6)
    assert "announces 12 triangles and holds 11" in refused(tmp_path, data[:-30], "cut.stl")
    assert "no STL file" in refused(tmp_path, b"\xff\xd8" + bytes(range(256)), "photo.stl")


def test_trimesh_objects_are_read_with_their_unit():
    mesh = trimesh.creation.box((10.0, 20.0, 30.0))
    assert bd.Surface(mesh, unit="mm").volume == pytest.approx(6e-6)
    with pytest.raises(InputError, match="the Trimesh is 30 long and has no unit"):
        bd.Surface(mesh)
    mesh.units = "mm"
    assert bd.Surface(mesh).volume == pytest.approx(6e-6)
    with pytest.raises(InputError, match=r"scene.to_mesh\(\) of a Scene"):
        bd.Surface(trimesh.Scene([mesh]))
    with pytest.raises(InputError, match="either a file, or vertices="):
        bd.Surface(mesh, named={"foot": [0]})
    with pytest.raises(InputError, match="not watertight"):
        bd.Surface(trimesh.Trimesh(mesh.vertices, mesh.faces[1:]), unit="mm")


# -- 3MF --------------------------------------------------------------------------------------------------------


def model(body, attributes=""):
    core = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
    return f'<?xml version="1.0"?><model {attributes} xmlns="{core}">{body}</model>'


def mesh_of(box):
    vertices = "".join('<vertex x="{:g}" y="{:g}" z="{:g}"/>'.format(*one) for one in box.vertices)
    triangles = "".join('<triangle v1="{}" v2="{}" v3="{}"/>'.format(*one) for one in box.faces)
    return f"<mesh><vertices>{vertices}</vertices><triangles>{triangles}</triangles></mesh>"


BOX = mesh_of(trimesh.creation.box((10, 10, 10)))
ONE = f'<resources><object id="1" name="bolt">{BOX}</object></resources><build><item objectid="1"/></build>'
TWO = (
    f'<resources><object id="1" name="bolt">{BOX}</object><object id="9" type="support">{BOX}</object>'
    '<object id="2" name="nut"><components>'  # mirrored and moved
    '<component objectid="1" transform="-1 0 0 0 1 0 0 0 1 30 0 0"/></components></object></resources><build>'
    '<item objectid="1"/><item objectid="9"/><item objectid="2" transform="2 0 0 0 2 0 0 0 2 0 0 50"/></build>'
)
CYCLE = '<resources><object id="1"><components><component objectid="1"/></components></object></resources>'
LEVELS = "".join(
    f'<object id="{k}"><components>{2 * f"""<component objectid="{k - 1}"/>"""}</components></object>'
    for k in range(2, 45)
)
DOUBLING = f'<resources><object id="1"/>{LEVELS}</resources><build><item objectid="44"/></build>'
ENTITIES = '<!DOCTYPE m [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;">]><model>&b;</model>'


def archive(tmp_path, files, name="part.3mf"):
    with zipfile.ZipFile(tmp_path / name, "w", zipfile.ZIP_DEFLATED) as file:
        for entry, text in files.items():
            file.writestr(entry, text)
    return (tmp_path / name).read_bytes()


@pytest.mark.parametrize(
    ("unit", "metres"), [("", 1e-3), ('unit="inch"', 0.0254), ('unit="micron"', 1e-6), ('unit="meter"', 1.0)]
)
def test_3mf_states_its_unit(tmp_path, unit, metres):
    archive(tmp_path, {"3D/3dmodel.model": model(ONE, unit)})
    part = bd.Surface(tmp_path / "part.3mf")
    assert part.volume == pytest.approx((10 * metres) ** 3)
    assert bd.Surface(tmp_path / "part.3mf", unit="cm").volume == pytest.approx(1e-3)  # the user knows better


def test_objects_and_components_of_3mf_are_placed_and_named(tmp_path):
    archive(tmp_path, {"3D/3dmodel.model": model(TWO)})
    both = bd.Surface(tmp_path / "part.3mf")
    assert both.volume == pytest.approx(9e-6)
    own = {one.name: one for one in both.patches}
    np.testing.assert_allclose(own["nut"].centre, [60e-3, 0, 50e-3], atol=1e-12)
    assert own["nut"].area == pytest.approx(4 * own["bolt"].area)


@pytest.mark.parametrize(("files", "says"), [
    ({"3D/3dmodel.model": model(CYCLE + '<build><item objectid="1"/></build>')}, "is part of itself"),
    ({"3D/3dmodel.model": model(DOUBLING)}, "more than 1000 objects"),
    ({"3D/3dmodel.model": ENTITIES}, "document type"),
    ({"3D/3dmodel.model": model(ONE)[:-200]}, "unclosed token"),
    ({"3D/3dmodel.model": model(ONE.replace('objectid="1"', 'objectid="7"'))}, "object 7 does not exist"),
    ({"3D/3dmodel.model": model(ONE.replace('v1="0"', 'v1="99"'))}, "a corner that does not exist"),
    ({"3D/3dmodel.model": model(ONE.replace('x="5"', 'x="nan"'))}, "not finite"),
    ({"3D/3dmodel.model": model(ONE, 'unit="parsec"')}, "unit 'parsec'"),
    ({"3D/other.txt": "no model"}, "no model"),
])  # fmt: skip
def test_hostile_3mf_is_refused(tmp_path, monkeypatch, files, says):
    monkeypatch.setattr(threemf, "_MOST_OBJECTS", 1000)
    assert says in refused(tmp_path, archive(tmp_path, files), "part.3mf", unit=None)


def test_archives_that_unpack_to_very_much_are_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(threemf, "_MOST_BYTES", 1 << 20)
    bomb = archive(tmp_path, {"3D/3dmodel.model": "<model>" + (2 << 20) * " " + "</model>"})
    assert len(bomb) < 1 << 14
    assert "unpacks to more than" in refused(tmp_path, bomb, "part.3mf")
    whole = archive(tmp_path, {"3D/3dmodel.model": model(ONE)})
    assert "cannot be read as 3MF" in refused(tmp_path, whole[: len(whole) // 2], "part.3mf")


# -- flaws ------------------------------------------------------------------------------------------------------

BESIDE, ON_AN_EDGE, FAR = (np.vstack([CUBE, CUBE + np.array(by)]) for by in ((10, 0, 0), (10, 10, 0), (50, 50, 50)))
SECOND = [tuple(k + 8 for k in quad) for quad in QUADS]


@pytest.mark.parametrize(("text", "cubes", "sides"), [
    pytest.param(obj(np.repeat(CUBE, 2, axis=0), [tuple(2 * k + j % 2 for j, k in enumerate(q)) for q in QUADS]),
                 1, 6, id="each corner twice"),
    pytest.param(obj(CUBE, [quad[::-1] for quad in QUADS]), 1, 6, id="inside out"),
    pytest.param(obj(CUBE, [*QUADS, QUADS[2]]), 1, 6, id="a face twice"),
    pytest.param(obj(CUBE + 1e-6 * np.arange(24).reshape(8, 3) % 3e-6, QUADS), 1, 6, id="seven digits"),
    pytest.param(obj(BESIDE, QUADS + SECOND), 2, 6, id="two bodies share a face"),
    pytest.param(obj(FAR, QUADS + SECOND, ["left"] * 6 + ["right"] * 6), 2, 12, id="two bodies"),
])  # fmt: skip
def test_flaws_with_one_remedy_are_mended(tmp_path, text, cubes, sides):
    part = surface(tmp_path, text)
    assert part.volume == pytest.approx(cubes * 1e-6, rel=1e-5)
    assert len(part.patch_names) - len(part.named) == sides


@pytest.mark.parametrize(("text", "says"), [
    pytest.param(obj(CUBE, QUADS[1:]), "not watertight: 4 edges", id="open"),
    pytest.param(obj(CUBE, [QUADS[0][::-1], *QUADS[1:]]), "face the same way", id="one normal"),
    pytest.param(obj(ON_AN_EDGE, QUADS + SECOND), "overlap or touch", id="edge"),
    pytest.param(obj(np.vstack([CUBE, CUBE + 5.0]), QUADS + SECOND), "overlap or touch", id="overlap"),
    pytest.param(obj(np.where((CUBE == 10.0).all(axis=1)[:, None], [10, 10, -1], CUBE), TRIANGLES),
                 "intersects itself", id="corner through the far side"),
    pytest.param(obj(np.vstack([CUBE, [[10, 5, 10]]]), [*QUADS[:1], (4, 6, 7, 8, 5), *QUADS[2:]]),
                 "corners within the side of another triangle", id="T junction"),
    pytest.param(obj(np.where(CUBE > 5, np.nan, CUBE), QUADS), "not finite", id="nan"),
    pytest.param(obj(CUBE, [*QUADS[:5], (1, 5, 7, 30)]), "corner 31 of 8", id="corner"),
    pytest.param(obj(CUBE, QUADS).replace("v 0 0 0", "v 0 zero 0"), "line 3: 'v 0 zero 0'", id="word"),
    pytest.param(obj(CUBE, [*QUADS[:5], (1, 5, 7, -1)]), "no vertex of three numbers or polygon", id="corner 0"),
    pytest.param(bytes(range(256)) * 20, "no polygon", id="noise"),
])  # fmt: skip
def test_other_flaws_are_refused_with_what_to_do(tmp_path, text, says):
    message = refused(tmp_path, text)
    assert says in message
    assert any(word in message for word in ("export", "unite", "close"))
