"""Wrong types, impossible numbers and shapes that do not fit: one line each, at once, and nothing wrong unsaid."""

import math
import time
import warnings

import numpy as np
import pytest

import bondem as bd
from bondem.errors import BondemError, FillingWarning, InputError, PackingError, StudyError
from bondem.specimen import materials
from bondem.study.pipeline import run_study
from bondem.study.study_file import parse_study
from tests.specimens import spheres

BOX = bd.Box((10e-3,) * 3)
LAW = bd.EulerBernoulli(E=70e9, nu=0.3, radius_ratio=0.5)
OWN = {"E": 1e9, "nu": 0.2}
MOVING = OWN | {"density": 2000.0, "rho": 1200.0}
NUMBERS = (math.nan, math.inf, -math.inf, 1e300, 1e-300, -1.0, "1", None, [1.0], True, np.zeros(2), 10**400)


@pytest.fixture(scope="module")
def packing():
    return spheres(BOX, 1000).particles


def refused(call, *, within=1.0, kind=BondemError):
    """That a call raises one clear line, and takes little of the processor for it."""
    start = time.process_time()
    with pytest.raises(kind) as caught:
        call()
    assert time.process_time() - start < within
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) > 20
    return str(caught.value)


PACK = {
    "count": (0, -1, 1.5, math.nan, math.inf, 10**12, 10**400, "100", None, [100], True),
    "seed": (None, -1, 1.5, "1", math.nan, [1], True),
    "spread": (-0.1, 2.0, math.nan, math.inf, 1e300, "0.25", [0.25], True),
    "coordination_number": (0.0, -1.0, math.nan, math.inf, 1e300, 1e-300, "6", [6], True),
    "volume_fraction": (0.0, -1.0, 0.9, math.nan, 1e300, 1e-300, "0.6", [0.6], True),
    "method": (None, "gravity", 3, ["quench"]),
    "sizes": (0.25, "uniform", bd.Uniform),
    "jamming": (1, "yes", None),
}


@pytest.mark.parametrize(("name", "value"), [(name, value) for name, values in PACK.items() for value in values])
def test_pack_refuses_what_it_cannot_do(name, value):
    assert name in refused(lambda: bd.pack(BOX, **({"count": 200} | {name: value})), kind=InputError)


@pytest.mark.parametrize("shape", [None, 3, "box", bd.Box, [1, 1, 1]])
def test_pack_fills_shapes_only(shape):
    assert "pack: shape" in refused(lambda: bd.pack(shape, count=200), kind=InputError)


MADE = {
    "Ball": lambda v: bd.Ball(v),
    "Cylinder radius": lambda v: bd.Cylinder(v, 1.0),
    "Cylinder length": lambda v: bd.Cylinder(1.0, v),
    "Box": lambda v: bd.Box(v),
    "Box edge": lambda v: bd.Box((1.0, v, 1.0)),
    "Cell edge": lambda v: bd.Cell((v, 1.0, 1.0)),
    "moved": lambda v: BOX.moved(v),
    "rotated about": lambda v: BOX.rotated(v, 1.0),
    "rotated by": lambda v: BOX.rotated("x", v),
    "and": lambda v: BOX & v,
    "or": lambda v: BOX | v,
    "minus": lambda v: BOX - v,
    "cut": lambda v: BOX.cut(v),
    "cut name": lambda v: BOX.cut(bd.Ball(1.0), name=v),
    "face": lambda v: BOX.face_depth(v, np.zeros((1, 3))),
    "contains": lambda v: BOX.contains(v),
    "Surface": lambda v: bd.Surface(v),
    "Surface of arrays": lambda v: bd.Surface(vertices=v, triangles=v),
    "Surface unit": lambda v: bd.Surface("no.stl", unit=v),
    "Uniform": lambda v: bd.Uniform(v),
    "Lognormal": lambda v: bd.Lognormal(v),
    "Lognormal cut": lambda v: bd.Lognormal(0.1, cut=v),
    "Sieve": lambda v: bd.Sieve(v, (0.0, 1.0)),
    "Sieve opening": lambda v: bd.Sieve((v, 1.0), (0.0, 1.0)),
    "Sieve mass": lambda v: bd.Sieve((1.0, 2.0), v),
    "Material E": lambda v: bd.Material("it", E=v, nu=0.2, rho=2000.0),
    "Material nu": lambda v: bd.Material("it", E=1e9, nu=v, rho=2000.0),
    "Material rho": lambda v: bd.Material("it", E=1e9, nu=0.2, rho=v),
    "Material name": lambda v: bd.Material(v, E=1e9, nu=0.2, rho=2000.0),
    "materials.get": lambda v: materials.get(v),
}
# What is possible there: by maker, the places in NUMBERS.
POSSIBLE = {"rotated by": {3, 5}, "cut name": {6}, "Material name": {6}, "Box edge": {9}, "Cell edge": {9},
            "Sieve opening": {4, 9}}  # fmt: skip


@pytest.mark.parametrize(
    ("name", "place"),
    [(name, place) for name in MADE for place in range(len(NUMBERS)) if place not in POSSIBLE.get(name, set())],
)
def test_shapes_sizes_and_materials_refuse_what_they_cannot_be(name, place):
    refused(lambda: MADE[name](NUMBERS[place]), kind=InputError)


@pytest.mark.parametrize("size", [1e-25, 1e25])
def test_a_packing_does_not_care_for_its_size(size):
    small, usual = (bd.pack(bd.Ball(edge), count=100, volume_fraction=0.5) for edge in (size, 1.0))
    np.testing.assert_allclose(small.radius / size, usual.radius, rtol=1e-9)


@pytest.mark.parametrize(
    ("shape", "z"), [(BOX, 4.0), (BOX, 3.0), (bd.Cylinder(5e-3, 30e-3), 4.0), (bd.Ball(1.0), 2.0)]
)
def test_a_coordination_number_below_jamming_ends_with_a_message(shape, z):
    asked = {"count": 300, "spread": 0.25, "coordination_number": z}
    told = refused(lambda: bd.pack(shape, **asked), within=20.0, kind=PackingError)
    assert f"instead of {z:.2f}" in told
    assert "volume_fraction= or jamming=True" in told


def test_fabric_of_next_to_nothing():
    one = bd.Lattice(bd.Particles([[0.0, 0.0, 0.0]], 1.0), [])
    assert "no bonds" in refused(lambda: bd.fabric(one), kind=InputError)
    assert "no bonds" in refused(lambda: bd.fabric(bd.Lattice(bd.Particles([[0.0] * 3, [3.0, 0, 0]], 1.0), [])))
    assert "fabric: lattice" in refused(lambda: bd.fabric(one.particles), kind=InputError)
    pair = bd.fabric(bd.connect(bd.Particles([[0.0, 0.0, 0.0], [2.0, 0.0, 0.0]], 1.0)))
    assert pair.coordination_number == 1.0
    assert pair.volume_fraction == pytest.approx(math.pi / 6.0)
    np.testing.assert_allclose(pair.fabric_tensor, np.diag([1.0, 0.0, 0.0]), atol=1e-15)
    assert not pair.passed


@pytest.mark.parametrize("place", range(len(NUMBERS)))
def test_measures_of_packings_refuse_what_they_cannot_use(packing, place):
    value = NUMBERS[place]
    refused(lambda: bd.radial_distribution(value), kind=InputError)
    refused(lambda: bd.radial_distribution(packing, bins=value), kind=InputError)
    refused(lambda: bd.wall_layering(packing, bins_per_diameter=value), kind=InputError)
    if place != 3:  # 1e300 is as far as the specimen goes
        refused(lambda: bd.radial_distribution(packing, reach=value), kind=InputError)
    refused(lambda: bd.wall_layering(packing, reach=value), kind=InputError)


LAB = [
    *((name, OWN, key) for name in ("clamped_tension", "static_bending", "static_torsion")
      for key in ("E", "nu", "stress", "depth")),
    *((name, MOVING, key) for name in ("dynamic_tension", "dynamic_bending", "dynamic_torsion", "free_vibration")
      for key in ("density", "E", "nu", "rho", "depth")),
    *(("impact", MOVING, key) for key in ("density", "E", "rho", "velocity", "depth")),
    ("static_tension", {}, "stress"), ("static_tension", {}, "depth"), ("uniform_stress", {}, "depth"),
    ("natural_frequencies", {"density": 1e3}, "density"), ("free_vibration", MOVING, "periods"),
]  # fmt: skip
NEGATIVE = 5  # of NUMBERS


@pytest.mark.parametrize("place", range(len(NUMBERS)))
def test_lab_tests_refuse_what_they_cannot_use(place):
    lattice = spheres(BOX, 1000)
    value = NUMBERS[place]
    for name, usual, key in LAB:
        if place == NEGATIVE and key == "stress":  # compression
            continue
        test = getattr(bd.labtests, name)
        assert key in refused(lambda test=test, given=usual | {key: value}: test(lattice, LAW, **given))
    for name, usual in {name: usual for name, usual, _ in LAB}.items():
        test = getattr(bd.labtests, name)
        refused(lambda test=test, usual=usual: test(value, LAW, **usual), kind=InputError)
    refused(lambda: bd.bulk_moduli(value, LAW), kind=InputError)
    refused(lambda: bd.bulk_moduli(lattice, LAW), kind=InputError)


FILES = {
    "no file": lambda path: bd.read_particles(path / "nothing.csv"),
    "no such long name": lambda path: bd.read_particles(path / f"{'x' * 1000}.csv"),
    "no particle file of a long name": lambda path: bd.load_particles(path / f"{'x' * 1000}.h5"),
    "no path": lambda path: bd.read_particles(None),
    "a number": lambda path: bd.read_lattice(3),
    "unit": lambda path: bd.read_particles(path / "two.csv", unit=[]),
    "unit 0": lambda path: bd.read_particles(path / "two.csv", unit=0),
    "shape": lambda path: bd.read_particles(path / "two.csv", shape="box"),
    "period": lambda path: bd.read_particles(path / "two.csv", period=3.0),
    "period NaN": lambda path: bd.read_particles(path / "two.csv", period=(1.0, math.nan, 1.0)),
    "columns": lambda path: bd.read_particles(path / "two.csv", columns=3),
    "columns of others": lambda path: bd.read_particles(path / "two.csv", columns=(0, 1, 2, None)),
    "a column before the first": lambda path: bd.read_particles(path / "two.csv", columns=(0, 1, 2, -9)),
    "radius": lambda path: bd.read_particles(path / "two.csv", radius=3),
    "periodic": lambda path: bd.read_particles(path / "two.csv", periodic="yes"),
    "not HDF5": lambda path: bd.read_particles(path / "text.h5"),
    "not VTKHDF": lambda path: bd.read_particles(path / "text.vtkhdf"),
    "no bonds": lambda path: bd.read_lattice(path / "two.csv"),
    "own file, unit": lambda path: bd.read_particles(path / "own.h5", unit="mm"),
    "save what": lambda path: bd.save_particles(path / "new.h5", "spheres"),
    "save where": lambda path: bd.save_particles(None, bd.load_particles(path / "own.h5")),
    "save from where": lambda path: bd.save_particles(
        path / "n.h5", bd.load_particles(path / "own.h5"), provenance=3),
    "save into nothing": lambda path: bd.save_particles(path / "no" / "n.h5", bd.load_particles(path / "own.h5")),
    "load": lambda path: bd.load_particles(path / "two.csv"),
    "load nothing": lambda path: bd.load_particles(3.0),
    "provenance": lambda path: bd.read_provenance([]),
    "vtk of what": lambda path: bd.write_vtkhdf(path / "n.vtkhdf", bd.load_particles(path / "own.h5")),
    "vtk where": lambda path: bd.write_vtkhdf(3, bd.Lattice(bd.load_particles(path / "own.h5"), [])),
    "vtk field": lambda path: bd.write_vtkhdf(
        path / "n.vtkhdf", bd.Lattice(bd.load_particles(path / "own.h5"), []), elements={"a": [1.0]}),
    "vtk no numbers": lambda path: bd.write_vtkhdf(
        path / "n.vtkhdf", bd.Lattice(bd.load_particles(path / "own.h5"), []), elements={"a": ["x", "y"]}),
    "vtk fields": lambda path: bd.write_vtkhdf(
        path / "n.vtkhdf", bd.Lattice(bd.load_particles(path / "own.h5"), []), bonds=[1.0]),
    "vtk state": lambda path: bd.write_vtkhdf(
        path / "n.vtkhdf", bd.Lattice(bd.load_particles(path / "own.h5"), []), state={}),
}  # fmt: skip


@pytest.mark.parametrize("call", FILES.values(), ids=FILES)
def test_files_refuse_what_they_cannot_be(tmp_path, call):
    (tmp_path / "two.csv").write_text("x,y,z,r\n0,0,0,0.1\n0.2,0,0,0.1\n")
    for name in ("text.h5", "text.vtkhdf"):
        (tmp_path / name).write_text("text")
    bd.save_particles(tmp_path / "own.h5", bd.Particles([[0.0, 0, 0], [0.2, 0, 0]], 0.1))
    refused(lambda: call(tmp_path))
    assert sorted(path.name for path in tmp_path.iterdir()) == ["own.h5", "text.h5", "text.vtkhdf", "two.csv"]


def box(edge):
    return bd.Box((edge,) * 3)


def test_particles_with_a_shape_they_do_not_fill(packing, tmp_path):
    rows = np.column_stack([packing.position, packing.radius]).tolist()
    (tmp_path / "spheres.csv").write_text("\n".join(["x,y,z,r", *(",".join(map(repr, row)) for row in rows)]))

    def given(shape):
        return bd.Particles(packing.position, packing.radius, shape=shape)

    def from_file(shape):
        return bd.read_particles(tmp_path / "spheres.csv", shape=shape)

    def study(edge):
        table = {"particles": "spheres.csv", "shape": "box", "size": [f"{edge} mm"] * 3}
        return parse_study({"name": "s", "specimen": table, "output": {"figures": False}}, folder=tmp_path)

    for make in (given, from_file):
        told = refused(lambda make=make: make(box(8e-3)), kind=InputError)
        assert "centres lie outside the given shape, a Box" in told
        with pytest.warns(FillingWarning, match="stick out of the given shape, a Box"):
            make(box(9.9e-3))
        with pytest.warns(FillingWarning, match=r"larger than the body of spheres \(and 2 more such\)"):
            make(box(12e-3))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for fits in (box(10e-3), box(10.01e-3)):
                make(fits)
    told = refused(lambda: run_study(study(8), tmp_path / "out"), within=20.0, kind=StudyError)
    assert told.startswith("'specimen.particles': ")
    assert "centres lie outside the given shape, a Box" in told
    with pytest.warns(FillingWarning, match="larger than the body of spheres"):
        results = run_study(study(12), tmp_path / "out")
    reasons = " ".join(results["packings"][0]["fabric_reasons"])
    assert "the shape is larger than the body of spheres" in reasons
    assert "strata" not in reasons


def test_a_cell_wider_than_its_packing():
    cell = bd.pack(bd.Cell((10e-3,) * 3), count=500)
    with pytest.warns(FillingWarning, match=r"of the periodic cell are empty along [xyz]"):
        bd.Particles(cell.position, cell.radius, shape=bd.Cell((12e-3,) * 3))


def test_what_is_packed_carved_or_kept_in_a_file_is_not_doubted(tmp_path):
    lattice = spheres(BOX, 1000)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        part = bd.carve(lattice, bd.Ball(4e-3).moved((5e-3,) * 3))
        bd.save_particles(tmp_path / "part.h5", part)
        again = bd.read_lattice(tmp_path / "part.h5")
    assert again.particles.shape == part.particles.shape
    # and it does stick out: a shape given with it is doubted
    with pytest.warns(FillingWarning, match="stick out"):
        bd.Particles(part.particles.position, part.particles.radius, shape=part.particles.shape)


def test_centres_of_cells_bonded_as_spheres_are_doubted() -> None:
    box = bd.Box((4e-2, 1e-2, 1e-2))
    centres = bd.pack(box, count=300, method="even", seed=1)
    with pytest.warns(FillingWarning, match='300 equal spheres touch in only .* give method="laguerre"'):
        bd.connect(centres)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        bd.connect(centres, reach=1.5)
        bd.connect(centres, method="laguerre")
        bd.connect(bd.pack(box, count=300, sizes=None, seed=1))
