"""Bodies of cells: volumes, areas and moments are exact, whatever the shape; no facet passes a slot."""

import math
import warnings
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial import Voronoi

import bondem as bd
from bondem.errors import InputError

BRACKET = Path(__file__).resolve().parents[2] / "examples/bracket.stl"


def box(low, high) -> bd.Shape:
    return bd.Box(tuple(np.subtract(high, low))).moved(low)


PLATE = bd.Box((4.0, 2.0, 1.0))
HOLE = bd.Cylinder(0.4, 3.0).rotated("y", math.pi / 2).moved((2.0, 1.0, 2.0))

# shape, its volume and the area of its walls (None: curved)
SHAPES = {
    "box": (PLATE, 8.0, 28.0),
    "turned box": (PLATE.rotated("z", 0.3).rotated("x", 0.7).moved((5.0, 1.0, 3.0)), 8.0, 28.0),
    "periodic": (bd.Cell((4.0, 2.0, 2.0)), 16.0, 0.0),
    "notch": (PLATE - box((1.8, 1.2, -1.0), (2.2, 3.0, 2.0)), 7.68, 28.0 - 0.64 + 1.6),
    "corner": (bd.Box((4.0, 1.0, 1.0)) | bd.Box((1.0, 3.0, 1.0)), 6.0, 26.0),
    "box hole": (PLATE - box((1.5, 0.5, -1.0), (2.5, 1.5, 2.0)), 7.0, 28.0 - 2.0 + 4.0),
    "cavity": (PLATE - box((1.5, 0.5, 0.3), (2.5, 1.5, 0.7)), 7.6, 28.0 + 2.0 + 1.6),
    "bracket": (bd.Surface(BRACKET, unit="mm"), None, None),
    "cylinder": (bd.Cylinder(1.0, 3.0), 3.0 * math.pi, None),
    "ball": (bd.Ball(1.0), 4.0 / 3.0 * math.pi, None),
    "round hole": (PLATE - HOLE, 8.0 - 0.16 * math.pi, None),
}
FLAT = [name for name in SHAPES if name not in ("cylinder", "ball", "round hole")]


@cache
def body(name: str, count: int = 200) -> bd.Lattice:
    return bd.connect(bd.pack(SHAPES[name][0], count=count, volume_fraction=0.5, seed=3), method="laguerre")


def sums(lattice: bd.Lattice) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Σ A n, Σ A d and Σ A n⊗(c - x) over all facets of each cell, each over its value by the divergence theorem."""
    x, facets, free = lattice.particles.position, lattice.facets, lattice.cells.free
    i, j = lattice.pairs.T
    across = lattice.particles.separation(i, j)
    cell = np.concatenate([i, j, free.cell])
    outward = np.concatenate([facets.normal, -facets.normal, free.normal])
    area = np.concatenate([facets.area, facets.area, free.area])
    depth = np.concatenate([facets.depth_i, facets.depth_j, free.depth])
    lever = np.concatenate([facets.centroid - x[i], facets.centroid - x[i] - across, free.centroid - x[free.cell]])
    n, volume = len(x), lattice.cells.volume
    vector, cones, tensor = np.zeros((n, 3)), np.zeros(n), np.zeros((n, 3, 3))
    np.add.at(vector, cell, area[:, None] * outward)
    np.add.at(cones, cell, area * depth)
    np.add.at(tensor, cell, (area[:, None] * outward)[:, :, None] * lever[:, None, :])
    return (
        np.linalg.norm(vector, axis=1) / volume ** (2.0 / 3.0), cones / (3.0 * volume) - 1.0,
        np.abs(tensor / volume[:, None, None] - np.eye(3)).max(axis=(1, 2)),
    )  # fmt: skip


@pytest.mark.parametrize("name", SHAPES)
def test_volumes_add_up(name):
    volume = SHAPES[name][1] or SHAPES[name][0].volume
    cells = body(name).cells
    assert cells.volume.min() > 0.1 * cells.volume.mean()
    np.testing.assert_allclose(cells.volume.sum(), volume, rtol=1e-9)


@pytest.mark.parametrize("name", SHAPES)
def test_facets_close_around_each_cell(name):
    for error in sums(body(name)):
        assert np.abs(error).max() < 1e-9


@pytest.mark.parametrize("name", FLAT)
def test_free_facets_are_the_walls(name):
    shape, _, area = SHAPES[name]
    free = body(name).cells.free
    np.testing.assert_allclose(free.area.sum(), shape.area if area is None else area, rtol=1e-9)
    np.testing.assert_allclose(shape.depth(free.centroid) if len(free.cell) else 0.0, 0.0, atol=1e-9)
    assert (np.diff(free.cell) >= 0).all()
    np.testing.assert_allclose(body(name).cells.free_area.sum(), free.area.sum(), rtol=1e-12)


@pytest.mark.parametrize(
    ("name", "areas"),
    [
        ("box", dict(zip(("x_min", "x_max", "y_min", "y_max", "z_min", "z_max"), (2, 2, 4, 4, 8, 8), strict=True))),
        ("notch", {"x_min": 2.0, "y_max": 3.6, "z_min": 7.68, "cut": 0.4 + 1.6}),
        ("cylinder", {"x_min": math.pi, "x_max": math.pi, "side": 6.0 * math.pi}),
    ],
)
def test_free_facets_know_their_faces(name, areas):
    shape, free = SHAPES[name][0], body(name).cells.free
    found = np.bincount(free.face, weights=free.area, minlength=len(shape.faces))
    for face, area in areas.items():
        np.testing.assert_allclose(found[shape.faces.index(face)], area, rtol=2e-3)


@pytest.mark.parametrize("name", ["box", "notch", "cavity", "turned box"])
def test_moments_of_all_cells_are_those_of_the_shape(name):
    def tensor(volume, size, centre):
        second = volume * (np.diag(np.square(size)) / 12.0 + np.outer(centre, centre))
        return volume * np.asarray(centre), np.trace(second) * np.eye(3) - second

    cells = body(name).cells
    first = (cells.volume[:, None] * cells.centroid).sum(axis=0)
    r2 = (cells.centroid**2).sum(axis=1)
    parallel = r2[:, None, None] * np.eye(3) - cells.centroid[:, :, None] * cells.centroid[:, None, :]
    inertia = (cells.inertia + cells.volume[:, None, None] * parallel).sum(axis=0)
    wanted, about = tensor(8.0, (4.0, 2.0, 1.0), (2.0, 1.0, 0.5))
    if name == "notch":
        less = tensor(0.32, (0.4, 0.8, 1.0), (2.0, 1.6, 0.5))
        wanted, about = wanted - less[0], about - less[1]
    if name == "cavity":
        less = tensor(0.4, (1.0, 1.0, 0.4), (2.0, 1.0, 0.5))
        wanted, about = wanted - less[0], about - less[1]
    if name == "turned box":
        turn, by = np.array(SHAPES[name][0].turn), np.array(SHAPES[name][0].by)
        centre = turn @ [2.0, 1.0, 0.5] + by
        second = 8.0 * (turn @ np.diag([16.0, 4.0, 1.0]) @ turn.T / 12.0 + np.outer(centre, centre))
        wanted, about = 8.0 * centre, np.trace(second) * np.eye(3) - second
    np.testing.assert_allclose(first, wanted, rtol=1e-9)
    np.testing.assert_allclose(inertia, about, atol=1e-9 * np.abs(about).max())


def test_facets_of_equal_spheres_are_those_of_voronoi():
    random = np.random.default_rng(5)
    grid = np.stack(np.meshgrid(*[np.arange(6.0) + 0.5] * 3), axis=-1).reshape(-1, 3)
    x = grid + random.uniform(-0.2, 0.2, grid.shape)
    lattice = bd.connect(bd.Particles(x, 0.3, shape=bd.Box((6.0, 6.0, 6.0))), method="laguerre")
    known = Voronoi(x)
    # corners of neighbouring cells that lie inside are corners of plain Voronoi cells
    area = {}
    for (i, j), corners in zip(known.ridge_points, known.ridge_vertices, strict=True):
        if -1 in corners or not ((known.vertices[corners] > 0.0) & (known.vertices[corners] < 6.0)).all():
            continue
        p = known.vertices[corners] - known.vertices[corners[0]]
        area[min(i, j), max(i, j)] = 0.5 * np.linalg.norm(np.cross(p[1:-1], p[2:]).sum(axis=0))
    ours = {tuple(pair): a for pair, a in zip(lattice.pairs.tolist(), lattice.facets.area, strict=True)}
    assert len(area) > 500
    for pair, value in area.items():
        np.testing.assert_allclose(ours.get(pair, 0.0), value, atol=1e-9)


def test_a_facet_lies_in_the_radical_plane_and_its_moment_is_about_its_centroid():
    lattice = body("box")
    facets, r = lattice.facets, lattice.particles.radius
    i, j = lattice.pairs.T
    apart = lattice.particles.separation(i, j)  # of the generators: elements are at the centres of mass
    length = np.linalg.norm(apart, axis=1)
    np.testing.assert_allclose(facets.normal, apart / length[:, None], atol=1e-12)
    np.testing.assert_allclose(facets.span, length, rtol=1e-12)
    np.testing.assert_allclose(facets.depth_i**2 - r[i] ** 2, facets.depth_j**2 - r[j] ** 2, atol=1e-12)
    assert (lattice.pairs[:, 0] < lattice.pairs[:, 1]).all()
    np.testing.assert_allclose(np.einsum("mij,mj->mi", facets.moment, facets.normal), 0.0, atol=1e-15)
    # a square, by hand: two cells that halve a bar of 2 x 1 x 1
    pair = bd.connect(bd.Particles([[0.5, 0.5, 0.5], [1.5, 0.5, 0.5]], 0.5, shape=bd.Box((2.0, 1.0, 1.0))),
                      method="laguerre")  # fmt: skip
    np.testing.assert_allclose(pair.facets.moment[0], np.diag([0.0, 1.0, 1.0]) / 12.0, atol=1e-15)
    np.testing.assert_allclose(pair.facets.centroid[0], [1.0, 0.5, 0.5], atol=1e-15)
    np.testing.assert_allclose(pair.cells.inertia[0], np.eye(3) / 6.0, atol=1e-15)
    assert len(pair.cells.free.cell) == 10


def test_centres_on_a_grid_have_cubes():
    grid = np.stack(np.meshgrid(*[np.arange(4.0) + 0.5] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    for shape, period in ((bd.Box((4.0, 4.0, 4.0)), 3 * 16), (bd.Cell((4.0, 4.0, 4.0)), 0)):
        lattice = bd.connect(bd.Particles(grid, 0.5, shape=shape), method="laguerre")
        assert len(lattice.pairs) == (3 * 64 if period == 0 else 3 * 48)
        np.testing.assert_allclose(lattice.cells.volume, 1.0, rtol=1e-12)
        np.testing.assert_allclose(lattice.facets.area, 1.0, rtol=1e-12)
    # walls in the planes between cells
    part = bd.Box((4.0, 4.0, 4.0)) - box((1.0, 2.0, -1.0), (3.0, 5.0, 5.0))
    kept = part.contains(grid)
    lattice = bd.connect(bd.Particles(grid[kept], 0.5, shape=part), method="laguerre")
    np.testing.assert_allclose(lattice.cells.volume, 1.0, rtol=1e-9)
    np.testing.assert_allclose(lattice.facets.area, 1.0, rtol=1e-9)
    for error in sums(lattice):
        assert np.abs(error).max() < 1e-9


@pytest.mark.parametrize("width", [0.2, 0.02, 1e-4])
def test_no_facet_passes_a_slot_thinner_than_a_cell(width):
    whole = bd.pack(bd.Box((2.0, 2.0, 1.0)), count=200, seed=1)
    shape = bd.Box((2.0, 2.0, 1.0)) - box((1.0 - width / 2, 0.8, -1.0), (1.0 + width / 2, 3.0, 2.0))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", bd.errors.FillingWarning)
        kept = shape.contains(whole.position)
        lattice = bd.connect(bd.Particles(whole.position[kept], whole.radius[kept], shape=shape), method="laguerre")
    cells, x, facets = lattice.cells, lattice.particles.position, lattice.facets
    np.testing.assert_allclose(cells.volume.sum(), 4.0 - 1.2 * width, rtol=1e-9)
    np.testing.assert_allclose(cells.free.area.sum(), 16.0 - 2.4 * width + 2.4, rtol=1e-9)
    for error in sums(lattice):
        assert np.abs(error).max() < 1e-9
    i, j = lattice.pairs.T
    through = ((x[i, 0] - 1.0) * (x[j, 0] - 1.0) < 0.0) & (np.minimum(x[i, 1], x[j, 1]) > 1.1)
    assert not through.any()
    # a cell whose centre is on one side has nothing on the other
    far = (x[:, 1] > 1.1) & (np.abs(x[:, 0] - 1.0) > width / 2)
    assert ((cells.centroid[far, 0] - 1.0) * (x[far, 0] - 1.0) > 0.0).all()
    np.testing.assert_allclose(facets.span, np.linalg.norm(x[j] - x[i], axis=1), rtol=1e-9)
    assert np.minimum(facets.depth_i, facets.depth_j).min() > 0.2 * lattice.particles.mean_radius


def test_place_and_orientation_change_nothing():
    plain, turn = body("notch"), SHAPES["notch"][0]
    particles = plain.particles
    shape = turn.rotated("z", 0.4).rotated("x", -1.1).moved((10.0, -7.0, 3.0))
    x = particles.position @ np.array(shape.turn).T + np.array(shape.by)
    again = bd.connect(bd.Particles(x, particles.radius, shape=shape), method="laguerre")
    np.testing.assert_allclose(again.cells.volume, plain.cells.volume, rtol=1e-9)
    big = plain.facets.area > 1e-6
    ours = {tuple(pair): a for pair, a in zip(again.pairs.tolist(), again.facets.area, strict=True)}
    there = np.array([ours.get(tuple(pair), 0.0) for pair in plain.pairs[big].tolist()])
    np.testing.assert_allclose(there, plain.facets.area[big], rtol=1e-6)
    unit = bd.connect(bd.Particles(1e-5 * body("box").particles.position, 1e-5 * body("box").particles.radius,
                                   shape=bd.Box((4e-5, 2e-5, 1e-5))), method="laguerre")  # fmt: skip
    np.testing.assert_allclose(unit.cells.volume, 1e-15 * body("box").cells.volume, rtol=1e-9)


def test_spheres_without_a_shape_fill_the_box_around_them():
    particles = body("box").particles
    lattice = bd.connect(bd.Particles(particles.position, particles.radius), method="laguerre")
    lower, upper = lattice.particles.envelope.bounds
    np.testing.assert_allclose(lattice.cells.volume.sum(), np.prod(upper - lower), rtol=1e-12)


def test_carving_a_body_cuts_it_anew():
    part = bd.carve(body("box"), bd.Cylinder(0.45, 3.0).moved((0.5, 1.0, 0.5)))
    assert part.cells is not None
    assert len(part.cells.volume) == len(part.particles) < 100
    np.testing.assert_allclose(part.cells.volume.sum(), 3.0 * math.pi * 0.45**2, rtol=1e-9)
    assert bd.carve(bd.connect(body("box").particles), bd.Box((2.0, 2.0, 1.0))).cells is None


def test_a_part_has_no_more_volume_than_the_body_has_there():
    """One eighth of a ball about a corner: the whole ball is refused, the intersection has its volume."""
    whole, ball = body("box"), bd.Ball(0.9)
    for shape in (ball, PLATE.moved((0.1, 0.0, 0.0))):
        with pytest.raises(InputError, match=r"carve: shape = .* of its volume lies outside the body, .* & shape"):
            bd.carve(whole, shape)
    part = bd.carve(whole, whole.envelope() & ball)
    np.testing.assert_allclose(part.cells.volume.sum(), math.pi * 0.9**3 / 6.0, rtol=1e-9)
    periodic = body("periodic")
    with pytest.raises(InputError, match="one that is moved"):
        bd.carve(periodic, bd.Box(periodic.envelope().size).moved((0.2, 0.0, 0.0)))


@pytest.mark.parametrize("name", ["periodic", "notch", "round hole"])
def test_polyhedra_are_the_cells(name):
    lattice = body(name)
    made = bd.polyhedra(lattice)
    x = lattice.particles.position[made.cell]
    volume, between = np.zeros(len(made.cell)), np.zeros(len(made.cell))
    for p, (start, end) in enumerate(zip(made.start[:-1], made.start[1:], strict=True)):
        corner = made.vertex[start:end] - x[p]
        vector = 0.5 * np.cross(corner[1:-1] - corner[0], corner[2:] - corner[0]).sum(axis=0)
        volume[p], between[p] = corner[0] @ vector / 3.0, np.linalg.norm(vector)
    np.testing.assert_allclose(np.bincount(made.cell, weights=volume), lattice.cells.volume, rtol=1e-9)
    assert (np.diff(made.cell) >= 0).all()
    facet = (made.neighbour >= 0) & (made.cell < made.neighbour)
    np.testing.assert_allclose(between[facet].sum(), lattice.facets.area.sum(), rtol=1e-9)
    np.testing.assert_allclose(between[made.neighbour < 0].sum(), lattice.cells.free.area.sum(), rtol=1e-9)


def test_progress_goes_from_nothing_to_all():
    told = []
    bd.connect(body("box").particles, method="laguerre", progress=told.append)
    assert told == sorted(told)
    assert told[-1] == 1.0


def test_what_cannot_be_cut_is_refused():
    shape = bd.Box((4.0, 2.0, 2.0))
    one = [[1.0, 1.0, 1.0], [3.0, 1.0, 1.0]]
    with pytest.raises(bd.errors.InputError, match="choose from"):
        bd.connect(bd.Particles(one, 0.5), method="voronoi")
    with pytest.raises(bd.errors.InputError, match="leave out tolerance"):
        bd.connect(bd.Particles(one, 0.5), method="laguerre", tolerance=0.1)
    with pytest.raises(bd.errors.InputError, match="leave out tolerance"):
        bd.connect(bd.Particles(one, 0.5), method="laguerre", reach=1.1)
    grid = np.stack(np.meshgrid(*[np.arange(2.0) + 0.5] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    with pytest.raises(bd.errors.InputError, match="half a period"):
        bd.connect(bd.Particles(grid, 0.4, shape=bd.Cell((2.0, 2.0, 2.0))), method="laguerre")
    outside = bd.specimen.particles.filled(bd.Particles([*one, [5.0, 1.0, 1.0]], 0.5), shape)
    with pytest.raises(bd.errors.InputError, match=r"1 centres lie outside.*element 2 by 1 m"):
        bd.connect(outside, method="laguerre")
    apart = bd.Box((1.0, 1.0, 1.0)) | box((3.0, 0.0, 0.0), (4.0, 1.0, 1.0))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", bd.errors.FillingWarning)
        lonely = bd.Particles([[0.3, 0.5, 0.5], [0.7, 0.5, 0.5]], 0.2, shape=apart)
    with pytest.raises(bd.errors.InputError, match=r"1 m³ of the 2 m³ of the shape.*contains no element"):
        bd.connect(lonely, method="laguerre")
    with pytest.raises(bd.errors.InputError, match="no cells"):
        bd.polyhedra(bd.connect(body("box").particles))


@pytest.mark.parametrize("name", ["box", "periodic", "notch", "bracket", "ball", "round hole"])
def test_even_centres_have_round_cells_of_much_the_same_size(name):
    shape = SHAPES[name][0]
    particles = bd.pack(shape, count=400, method="even", seed=2)
    assert len(particles) == 400
    assert particles.shape is shape
    assert np.ptp(particles.radius) == 0.0
    if shape.faces:
        assert shape.depth(particles.position).min() >= particles.mean_radius / 3.0 * (1.0 - 1e-12)
    touching = bd.connect(particles, tolerance=0.0) if name == "periodic" else bd.connect(particles, reach=1.5)
    assert (2.0 * particles.mean_radius - touching.length).max() <= 0.2001 * particles.mean_radius
    body = bd.connect(particles, method="laguerre")
    width = body.cells.volume.mean() ** (1.0 / 3.0)
    assert body.cells.volume.std() < 0.12 * body.cells.volume.mean()
    assert np.linalg.norm(body.cells.centroid - particles.position, axis=1).max() < 0.2 * width
    assert body.facets.span.min() > 0.6 * width


def test_even_centres_follow_from_the_seed():
    shape = bd.Cylinder(1.0, 2.0)
    one, same, other = (bd.pack(shape, count=150, method="even", seed=seed) for seed in (1, 1, 2))
    np.testing.assert_array_equal(one.position, same.position)
    assert not np.allclose(one.position, other.position)
    for option in ({"spread": 0.25}, {"sizes": bd.Uniform(0.1)}, {"volume_fraction": 0.5}, {"jamming": True}):
        with pytest.raises(bd.errors.InputError, match="leave out spread="):
            bd.pack(shape, count=150, method="even", **option)


def test_walls_of_a_re_entrant_corner_belong_to_no_face():
    shape = bd.Box((40.0, 10.0, 3.0)) | bd.Box((40.0, 3.0, 10.0))
    body = bd.connect(bd.pack(shape, count=600, method="even", seed=1), method="laguerre")
    free = body.cells.free
    area = dict(zip(shape.faces, np.bincount(free.face + 1, weights=free.area)[1:], strict=True))
    assert area == pytest.approx(
        {"x_min": 51.0, "x_max": 51.0, "y_min": 400.0, "y_max": 120.0, "z_min": 400.0, "z_max": 120.0}, rel=1e-9
    )
    assert free.area[free.face < 0].sum() == pytest.approx(2 * 40.0 * 7.0, rel=1e-9)
    middle = (30.0 * 5.0 + 21.0 * 1.5) / 51.0  # of the L: a load acts through it
    assert bd.Face("x_max").anchor(body) == pytest.approx(np.array([40.0, middle, middle]), rel=1e-9)


def test_fabric_of_a_body_looks_at_the_spheres_for_their_overlap():
    """Cells have their centres elsewhere: between these, spheres would seem to overlap more."""
    particles = bd.pack(SHAPES["cylinder"][0], count=300, seed=1)
    touching, body = bd.connect(particles), bd.connect(particles, method="laguerre")
    assert np.abs(body.centre - particles.position).max() > 0.05 * particles.mean_radius
    assert bd.fabric(body).largest_overlap == pytest.approx(bd.fabric(touching).largest_overlap, rel=1e-9)


def test_a_periodic_cell_without_a_shape_is_its_own_shape():
    """Particles with a period alone can be cut into cells: their shape is no box about the spheres."""
    packed = bd.pack(bd.Cell((2.0, 2.0, 2.0)), count=100, method="even", seed=1)
    bare = bd.Particles(packed.position, packed.radius, period=packed.period)
    assert isinstance(bare.shape, bd.Cell)
    assert bare.shape.size == (2.0, 2.0, 2.0)
    body, wanted = (bd.connect(one, method="laguerre") for one in (bare, packed))
    assert body.cells.volume.sum() == pytest.approx(8.0)
    assert not len(body.cells.free.cell)
    np.testing.assert_array_equal(body.pairs, wanted.pairs)
