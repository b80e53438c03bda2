"""Packings: on target, inside the walls, reproducible, and refused where they cannot be."""

import numpy as np
import pytest
import trimesh

import bondem as bd
from bondem.errors import InputError, PackingError
from bondem.geometry.neighbours import neighbours, sphere_grid
from bondem.packing import targets
from bondem.packing.quench import _just_above_jamming
from bondem.packing.soft_spheres import SoftSpheres
from bondem.packing.wall_contacts import walls
from tests.bits import most_threads, threads

SHAPES = [
    bd.Cylinder(radius=5e-3, length=20e-3),
    bd.Box(size=(1.0, 0.8, 1.3)),
    bd.Ball(radius=2.0),
    bd.Cell(size=(1.0, 0.9, 1.2)),
]


@pytest.fixture(scope="module", params=SHAPES, ids=lambda shape: type(shape).__name__)
def packed(request):
    return bd.pack(request.param, count=1500, spread=0.25, seed=3)


def test_contacts_are_on_target_and_every_sphere_is_there(packed):
    lattice = bd.connect(packed)
    assert len(packed) == 1500
    assert abs(lattice.coordination_number - 6.2) <= 0.02
    assert lattice.rattlers < 0.03 * len(packed)


def test_spheres_lie_inside_the_walls_and_press_on_them(packed):
    if packed.shape.period is not None:
        np.testing.assert_array_equal(packed.period, packed.shape.period)
        assert (packed.position >= 0.0).all()
        assert (packed.position <= packed.period).all()
        return
    gap = (packed.shape.depth(packed.position) - packed.radius) / packed.mean_radius
    assert gap.min() > -1e-12
    assert (gap < 1e-9).mean() > 0.1


def test_radii_follow_the_size_law(packed):
    relative = packed.radius / packed.mean_radius
    assert np.ptp(relative) == pytest.approx(0.25, rel=0.02)
    # Uniform: standard deviation κ/√12, four sampling errors wide.
    assert relative.std() == pytest.approx(0.25 / np.sqrt(12.0), rel=0.05)
    neighbour_in_order = np.corrcoef(relative[1:], relative[:-1])[0, 1]
    assert abs(neighbour_in_order) < 0.15


def test_density_and_overlap_are_those_of_a_jammed_packing(packed):
    quality = bd.fabric(bd.connect(packed))
    periodic = packed.shape.period is not None
    # Random close packing, 0.64, less what walls cost; spheres at walls lack neighbours, so that the same z
    # takes more compression there.
    assert 0.61 < quality.volume_fraction < 0.66
    assert quality.largest_overlap < (0.03 if periodic else 0.15)


def test_spheres_are_at_rest(packed):
    lattice = bd.connect(packed)
    i, j = lattice.pairs.T
    deep = packed.radius[i] + packed.radius[j] - lattice.length
    push = (deep / lattice.length)[:, None] * lattice.branch
    force = np.zeros_like(packed.position)
    np.add.at(force, j, push)
    np.add.at(force, i, -push)
    inside = packed.shape.depth(packed.position) > packed.radius * (1.0 + 1e-9)
    residual = np.sqrt((force[inside] ** 2).sum(axis=1).mean())
    assert residual < 0.006 * deep.mean()


def test_monodisperse_cell_packs_at_random_close_density():
    particles = bd.pack(bd.Cell((1.0, 1.0, 1.0)), count=1500, spread=0.0, seed=1)
    assert np.ptp(particles.radius) == 0.0
    quality = bd.fabric(bd.connect(particles))
    assert quality.volume_fraction == pytest.approx(0.642, abs=0.008)
    assert quality.passed, quality.reasons


def test_target_of_contacts_can_be_chosen():
    shape = bd.Cell((1.0, 1.0, 1.0))
    dense = bd.pack(shape, count=600, spread=0.2, coordination_number=7.5)
    lattice = bd.connect(dense)
    assert lattice.coordination_number == pytest.approx(7.5, abs=0.02)
    usual = bd.pack(shape, count=600, spread=0.2)
    assert bd.fabric(lattice).largest_overlap > bd.fabric(bd.connect(usual)).largest_overlap


def test_same_seed_gives_same_bits_on_any_number_of_threads():
    def packing(seed, among, count=2500):
        with threads(among):
            return bd.pack(bd.Cylinder(1.0, 3.0), count=count, spread=0.25, seed=seed)

    one, two = packing(5, 1), packing(5, most_threads())
    np.testing.assert_array_equal(one.position, two.position)
    np.testing.assert_array_equal(one.radius, two.radius)
    assert not np.allclose(packing(5, 1, 200).position, packing(6, 1, 200).position)


def test_progress_rises_from_nothing_to_all():
    shares = []
    bd.pack(bd.Ball(1.0), count=200, spread=0.25, progress=shares.append)
    assert shares[0] < 0.1
    assert shares[-1] == 1.0
    assert (np.diff(shares) >= 0.0).all()


@pytest.mark.parametrize("method", ["quench", "growth"])
def test_a_moved_box_is_packed_as_one_at_the_origin(method):
    box = bd.Box((10.0, 5.0, 5.0))
    there = box.rotated("z", 0.3).moved((1.0, 2.0, 3.0))
    here, moved = (bd.pack(one, count=200, seed=1, method=method) for one in (box, there))
    np.testing.assert_array_equal(moved.radius, here.radius)
    np.testing.assert_allclose(moved.position, there.place(here.position), rtol=1e-14)
    assert moved.shape == there


def walled(name):
    """A box of 10 x 5 x 5 in other words, and what it is worth."""
    box = bd.Box((10.0, 5.0, 5.0))
    mesh = trimesh.creation.box(bounds=[[0, 0, 0], [10, 5, 5]])
    return {
        "surface": bd.Surface(vertices=mesh.vertices, triangles=mesh.faces),
        "cut": box.cut(bd.Ball(radius=0.5).moved((5.0, 2.5, 2.5))),
        "common": box & bd.Ball(radius=8.0).moved((5.0, 2.5, 2.5)),
        "moved": (box.moved((0.0, 0.0, 1.0)) & bd.Box((10.0, 5.0, 6.0))).moved((1.0, 2.0, 3.0)),
        "notched": box.cut(bd.Box((0.5, 1.0, 9.0)).moved((4.75, 4.0, -2.0))),
    }[name]


@pytest.mark.parametrize("name", ["surface", "cut", "common", "moved", "notched"])
def test_spheres_reach_into_the_edges_of_shapes_that_are_made_of_others(name):
    """Walls from a grid of depths are rounded at edges: no sphere touched two, and ends had a third fewer."""
    shape, box = walled(name), bd.Box((10.0, 5.0, 5.0))
    number = {}
    for kind, one in (("box", box), ("other", shape)):
        spheres = bd.pack(one, count=500, seed=1)
        walls = (one.face_depth(face, spheres.position) for face in ("x_min", "x_max", "y_min", "z_min"))
        on = [wall < spheres.radius * (1.0 + 1e-3) for wall in walls]
        number[kind] = on[0].sum() + on[1].sum(), (on[2] & on[3]).sum()
        assert (one.depth(spheres.position) > 0.9 * spheres.radius).all()
    assert number["other"][0] > 0.75 * number["box"][0]
    assert number["other"][1] > 0.4 * number["box"][1]


@pytest.mark.parametrize("centre", [(0.0, 0.0, 0.0), (0.5, 0.0, 0.0), (0.5, 0.5, -0.35)])
def test_spheres_come_to_rest_in_wedges_between_flat_and_round_walls(centre):
    shape = bd.Box((1.0, 1.0, 1.0)).cut(bd.Ball(radius=0.5).moved(centre))
    spheres = bd.pack(shape, count=300, spread=0.3, seed=2)
    assert (shape.depth(spheres.position) > 0.98 * spheres.radius).all()


def test_near_neighbours_in_space_are_near_in_order(packed):
    pairs = bd.connect(packed).pairs
    shuffled = np.random.default_rng(0).permutation(len(packed))[pairs]
    apart = np.median(np.abs(np.diff(pairs, axis=1)))
    assert apart < 0.2 * np.median(np.abs(np.diff(shuffled, axis=1)))


@pytest.mark.parametrize("edges", [(1.0, 1.0, 1.0), (0.75, 1.0, 3.0)])
@pytest.mark.parametrize("periodic", [(True, True, True), (False, False, False), (True, False, True)])
def test_neighbour_list_is_that_of_all_pairs(edges, periodic):
    random = np.random.default_rng(1)
    edges = np.array(edges)
    sphere = np.column_stack([edges * random.random((300, 3)), random.uniform(0.05, 0.1, 300)])
    period = np.where(periodic, edges, 0.0)
    start, neighbour = neighbours(sphere, np.zeros(3), edges, period, 0.06)
    d = sphere[None, :, :3] - sphere[:, None, :3]
    d -= period * np.rint(d / edges)
    near = np.linalg.norm(d, axis=2) <= sphere[:, None, 3] + sphere[None, :, 3] + 0.06
    np.fill_diagonal(near, val=False)
    for i in range(300):
        assert sorted(neighbour[start[i] : start[i + 1]]) == np.flatnonzero(near[i]).tolist()


@pytest.mark.parametrize("spread", [(1.0, 1.0, 1.0), (1e3, 1e3, 1e3), (1.0, 1.0, 1e6), (1e-3, 1e3, 1e3)])
def test_a_grid_of_spheres_that_fly_apart_stays_small(spread):
    random = np.random.default_rng(2)
    place = np.array(spread) * random.random((300, 3))
    place[1::2] = place[::2] + 0.1  # pairs that touch
    sphere = np.column_stack([place, random.uniform(0.1, 0.15, 300)])
    lower, upper = sphere[:, :3].min(axis=0), sphere[:, :3].max(axis=0)
    grid = sphere_grid(sphere, lower, upper, np.zeros(3), 0.01)
    assert grid.cells.prod() <= 8 * 300
    assert grid.edge * grid.cells == pytest.approx(upper - lower)
    start, neighbour = neighbours(sphere, lower, upper, np.zeros(3), 0.01)
    near = np.linalg.norm(place[:, None] - place, axis=2) <= sphere[:, None, 3] + sphere[None, :, 3] + 0.01
    np.fill_diagonal(near, val=False)
    for i in range(300):
        assert sorted(neighbour[start[i] : start[i + 1]]) == np.flatnonzero(near[i]).tolist()


@pytest.mark.parametrize(
    ("error", "shape", "options", "says"),
    [
        (InputError, bd.Ball(1.0), {"count": 0}, "count = 0"),
        (InputError, bd.Ball(1.0), {"count": 10.5}, "whole number"),
        (InputError, bd.Ball(1.0), {"count": 100, "spread": 2.0}, "spread = 2"),
        (InputError, bd.Ball(1.0), {"count": 100, "spread": -0.1}, "spread = -0.1"),
        (InputError, bd.Ball(1.0), {"count": 100, "spread": float("nan")}, "spread = nan"),
        (InputError, bd.Ball(1.0), {"count": 100, "seed": -1}, "seed = -1"),
        (InputError, bd.Ball(1.0), {"count": 5}, "more spheres"),
        (InputError, bd.Ball(1.0), {"count": 100, "coordination_number": 0.0}, "positive coordination_number="),
        (InputError, bd.Box((1.0, 1.0, 0.01)), {"count": 100}, "do not fit"),
        (InputError, bd.Cell((1.0, 1.0, 1.0)), {"count": 10}, "too large for the periodic"),
        (PackingError, bd.Ball(1.0), {"count": 20}, "ask for more spheres"),
    ],
)
def test_bad_requests_are_refused_with_advice(error, shape, options, says):
    with pytest.raises(error, match=says):
        bd.pack(shape, **options)


def test_a_shape_with_too_many_spheres_for_its_walls_is_refused():
    shape = bd.Box(size=(1.0, 1.0, 1.0)) - bd.Ball(0.2)
    with pytest.raises(InputError, match="carve"):
        walls(shape, np.full(3_000_000, np.cbrt(0.64 / 3e6 * 0.75 / np.pi)))


def test_wide_sizes_may_overlap_by_a_share_of_the_smaller_of_a_pair():
    """Overlaps of large spheres were compared with the radius of the smallest one anywhere."""
    centre = np.array([[0.2, 0.5, 0.5], [0.55, 0.5, 0.5], [0.95, 0.9, 0.9]])
    spheres = SoftSpheres(bd.Box((1.0, 1.0, 1.0)), centre, np.array([0.2, 0.2, 0.04]))
    assert spheres.deepest() == pytest.approx(0.25)
    targets._check_overlap(spheres, "a target", "option=")
    spheres.sphere[2, :3] = 0.755, 0.5, 0.5  # 0.035 deep, of a radius of 0.04
    with pytest.raises(PackingError, match=r"overlaps of 0\.88 of the smaller radius of a pair"):
        targets._check_overlap(spheres, "a target", "option=")


@pytest.mark.parametrize(("target", "other"), [
    ({}, False), ({"jamming": True}, True), ({"volume_fraction": 0.66}, True), ({"coordination_number": 5.0}, True),
])  # fmt: skip
def test_advice_for_wide_sizes_does_not_go_in_a_circle(monkeypatch, target, other):
    """Each target recommended the others, which sizes of 1 : 5 do not reach either."""
    for limit in ("_SCALES", "_STEPS", "_ALL_STEPS", "_JAMMED_STEPS", "_ALL_JAMMED_STEPS"):
        monkeypatch.setattr(targets, limit, 2)
    two = bd.Sieve((1e-3, 1.001e-3, 5e-3, 5.001e-3), (0.0, 0.5, 0.5, 1.0))
    with pytest.raises(PackingError, match=r"radii differ by a factor of 5\.0 and") as raised:
        bd.pack(bd.Box((2.0, 1.0, 1.0)), count=300, sizes=two, **target)
    assert ("the coordination_number=6.2 of packings without a target" in str(raised.value)) == other
    assert not any(name in str(raised.value) for name in ("jamming=", "volume_fraction=", "seed="))


def test_jamming_of_wide_sizes_begins_above_it():
    """Spheres let loose below jamming never press, and came to rest after minutes, if at all."""
    wide = _just_above_jamming(np.append(np.ones(125), 5.0))
    assert 0.7 < wide <= 0.75
    assert _just_above_jamming(np.linspace(0.875, 1.125, 100)) == 0.655
