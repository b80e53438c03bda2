"""Same everywhere or not: density of the core, slices, layers, radial distribution, and the verdict on them."""

import math

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from bondem.specimen.interior import core_solid, core_volume, solid_fraction
from bondem.specimen.quasirandom import points_inside, spread_directions
from tests.specimens import crystal

# Crystals, rows and dust do not fill the shapes they are measured in.
pytestmark = pytest.mark.filterwarnings("ignore::bondem.errors.FillingWarning")


@pytest.fixture(scope="module")
def cell():
    return bd.pack(bd.Cell((1.0, 1.0, 1.6)), count=2400, spread=0.25, seed=2)


@pytest.fixture(scope="module")
def cylinder():
    return bd.pack(bd.Cylinder(5e-3, 40e-3), count=3000, spread=0.25, seed=1)


@pytest.fixture(scope="module")
def ordered():
    return bd.pack(bd.Box((4.0, 1.0, 1.0)), count=2000, spread=0.0, seed=0)


def reasons(particles, **bonding):
    quality = bd.fabric(bd.connect(particles, **bonding))
    assert quality.passed == (not quality.reasons)
    return " & ".join(quality.reasons), quality


# The verdict


@pytest.mark.parametrize("seed", [1, pytest.param(2, marks=pytest.mark.validate)])
@pytest.mark.parametrize("count", [1000, pytest.param(3000, marks=pytest.mark.validate)])
def test_the_default_cylinder_passes_at_every_size(count, seed):
    why, quality = reasons(bd.pack(bd.Cylinder(5e-3, 40e-3), count=count, spread=0.25, seed=seed))
    assert not why
    assert quality.core_volume_fraction == pytest.approx(0.655, abs=0.008)


@pytest.mark.validate
def test_a_good_cell_passes_and_a_crystal_fails_by_its_layers_too(cell):
    assert not reasons(cell)[0]
    why, quality = reasons(crystal())
    assert "centres lie in layers along" in why
    np.testing.assert_allclose(quality.strata.layers, 2.0, atol=0.15)
    # In itself a perfect crystal is the same everywhere.
    np.testing.assert_allclose([quality.strata.coordination, quality.strata.size], 0.0)
    np.testing.assert_allclose(quality.strata.density, 0.0, atol=0.01)


def test_equal_spheres_crystallised_between_walls_fail(ordered):
    why, quality = reasons(ordered)
    assert "ordered" in why
    assert "layers along" in why
    assert np.nanmax(quality.strata.layers) > 0.8


def test_strata_of_alternating_density_fail(cell):
    layer = (cell.position[:, 2] // 0.4).astype(int) % 2 == 0
    keep = ~(layer & (np.arange(len(cell)) % 7 == 0))
    why, quality = reasons(bd.Particles(cell.position[keep], cell.radius[keep], shape=cell.shape))
    assert "the solid fraction differs" in why
    assert "along z" in why
    # One in seven is missing from half the height: ± 1/14 about the mean, 1/13 of it.
    assert quality.strata.density[2] == pytest.approx(1 / 13, abs=0.015)
    assert quality.strata.density[:2].max() < 0.02


def test_density_that_grows_downwards_fails_and_its_gradient_is_measured(cell):
    # Every length along z times 1 + a s, s from -1 at the bottom to 1 at the top: density over 1 + a s.
    a, height = 0.1, 1.6
    s = 2.0 * cell.position[:, 2] / height - 1.0
    z = 0.5 * height * (s + 0.5 * a * s**2)
    position = np.column_stack([cell.position[:, :2], z - z.min() + 0.1])
    particles = bd.Particles(position, cell.radius, shape=bd.Box((1.0, 1.0, float(np.ptp(z)) + 0.2)))
    why, quality = reasons(particles, tolerance=0.1)
    assert "the solid fraction differs" in why
    # The slices that count begin three mean radii from the wall.
    assert quality.strata.density_gradient[2] == pytest.approx(-2.0 * a, abs=0.06)


def test_sizes_that_have_parted_fail(cell):
    # Two packings, coarse below and fine above.
    coarse = bd.pack(bd.Box((1.0, 1.0, 1.0)), count=500, spread=0.25, seed=1)
    fine = bd.pack(bd.Box((1.0, 1.0, 1.0)), count=900, spread=0.25, seed=1)
    position = np.concatenate([coarse.position, fine.position + np.array([0.0, 0.0, 1.0])])
    both = bd.Particles(position, np.concatenate([coarse.radius, fine.radius]), shape=bd.Box((1.0, 1.0, 2.0)))
    why, quality = reasons(both, tolerance=0.1)
    assert "the mean radius differs" in why
    assert "parted" in why
    assert quality.strata.size[2] > 0.5
    # The same radii in any place: nothing.
    assert np.nanmax(bd.fabric(bd.connect(cell)).strata.size) < 0.15


def test_contacts_that_grow_in_number_downwards_fail(cell):
    lattice = bd.connect(cell)
    height = cell.position[lattice.pairs[:, 0], 2] / 1.6
    missing = np.random.default_rng(0).random(len(height)) < 0.4 * height
    quality = bd.fabric(bd.Lattice(cell, lattice.pairs[~missing]))
    assert any("the coordination number differs" in reason for reason in quality.reasons)
    # 1 - 0.4 h: from 0.98 to 0.62 between the middles of the first and the last slice, about a mean of 0.8.
    assert quality.strata.coordination_gradient[2] == pytest.approx(-0.45, abs=0.08)


@pytest.mark.validate
def test_centres_deposited_in_layers_fail_at_any_size(record):
    for count in (600, 2400):
        cell = bd.pack(bd.Cell((1.0, 1.0, 1.6)), count=count, spread=0.25, seed=2)
        waves = round(1.6 / (1.8 * cell.mean_radius))
        wave = 1.6 / waves
        z = cell.position[:, 2] + 0.13 * wave * np.sin(2.0 * np.pi * cell.position[:, 2] / wave)
        layered = bd.Particles(np.column_stack([cell.position[:, :2], z]), 0.9 * cell.radius, shape=cell.shape)
        why, quality = reasons(layered, tolerance=0.3)
        assert "centres lie in layers along z" in why
        # Twice the first coefficient of a density under x + b sin(x): 2 J1(b), b = 0.13 · 2π.
        assert quality.strata.layers[2] == pytest.approx(2.0 * 0.3756, abs=0.12)
        record("layered packing is rejected", not quality.passed)


# Measures with a known answer


def test_core_volume_by_points_is_that_by_formula():
    for shape in (bd.Cylinder(1.0, 8.0), bd.Ball(1.0), bd.Box((1.0, 2.0, 3.0))):
        points, share = points_inside(shape, 1 << 16, 0.2)
        assert len(points) * share == pytest.approx(core_volume(shape, 0.2), rel=3e-3)
    assert core_volume(bd.Box((1.0, 2.0, 3.0)), 0.2) == pytest.approx(0.6 * 1.6 * 2.6)
    assert core_volume(bd.Ball(0.1), 0.2) == 0.0


def test_spheres_cut_by_the_border_of_the_core_are_shared_out():
    r, depth, side = 0.5, 3.0, 60.0
    random = np.random.default_rng(3)
    grid = np.stack(np.meshgrid(np.arange(10.0, 50.0, 2.0), np.arange(10.0, 50.0, 2.0)), axis=-1).reshape(-1, 2)
    x = depth + random.uniform(-r, r, len(grid))
    shape = bd.Box((side, side, side))
    spheres = core_solid(bd.Particles(np.column_stack([x, grid]), r), shape, depth)
    inside = r - (depth - x)  # height of the cap beyond the border
    exact = (math.pi * inside**2 * (3.0 * r - inside) / 3.0).sum()
    assert solid_fraction(shape, spheres, depth) * core_volume(shape, depth) == pytest.approx(exact, rel=3e-3)
    assert math.isnan(solid_fraction(shape, spheres, 31.0))


def test_core_is_the_whole_of_a_periodic_cell(cell):
    quality = bd.fabric(bd.connect(cell))
    assert quality.core_volume_fraction == pytest.approx(quality.volume_fraction, rel=1e-12)


def test_fineness_and_backbone_of_the_crystal():
    quality = bd.fabric(bd.connect(crystal()))
    assert quality.fineness == pytest.approx(8.0 * math.sqrt(2.0))
    assert quality.smallest_extent == pytest.approx(8.0 * math.sqrt(2.0))
    assert quality.loose == 0
    assert quality.backbone_coordination_number == 12.0
    assert quality.backbone_histogram[12] == 2048


def test_backbone_loses_what_hangs_on_three_and_then_what_hung_on_that(cell):
    lattice = bd.connect(cell)
    quality = bd.fabric(lattice)
    assert 0 < quality.loose < 0.05 * len(cell)
    assert quality.backbone_histogram[:4].sum() == 0
    assert quality.backbone_histogram.sum() == len(cell) - quality.loose
    assert quality.backbone_coordination_number > quality.coordination_number
    # A row of spheres, one contact at each end: nothing is held.
    k = np.arange(20)
    row = bd.Particles(np.column_stack([k, 0.0 * k, 0.0 * k]) + 5.0, 0.5, shape=bd.Box((30.0, 10.0, 10.0)))
    quality = bd.fabric(bd.connect(row))
    assert quality.loose == 20
    assert math.isnan(quality.backbone_coordination_number)


def test_radial_distribution_of_the_crystal_counts_its_shells():
    particles = crystal()
    found = bd.radial_distribution(particles, reach=1.8, bins=180)
    r, step = found.distance, found.distance[1] - found.distance[0]
    density = math.sqrt(2.0)  # centres per cubed diameter, touching
    shell = density * found.density * 4.0 / 3.0 * np.pi * ((r + step / 2) ** 3 - (r - step / 2) ** 3)
    near = [shell[np.abs(r - at) < 0.05].sum() for at in (1.0, math.sqrt(2.0), math.sqrt(3.0))]
    np.testing.assert_allclose(near, [12.0, 6.0, 24.0], rtol=1e-9)
    assert shell.sum() == pytest.approx(42.0, rel=1e-9)


@pytest.mark.parametrize("shape", [
    bd.Cylinder(1.0, 6.0), bd.Ball(1.0), pytest.param(bd.Cell((1.0, 1.0, 1.0)), marks=pytest.mark.validate)
], ids=repr)  # fmt: skip
def test_radial_distribution_of_points_without_order_is_one_up_to_the_walls(shape):
    points, _ = points_inside(shape, 1 << 15, 0.0)
    random = np.random.default_rng(5)
    lower, upper = shape.bounds
    points = lower + (upper - lower) * random.random((12_000, 3))
    particles = bd.Particles(points[shape.contains(points)], 1e-7, shape=shape)
    reach = (0.45 if shape.period is not None else 0.9) / 2e-7
    found = bd.radial_distribution(particles, reach=reach, bins=9)
    np.testing.assert_allclose(found.density[1:], 1.0, atol=0.04)


@pytest.mark.validate
def test_radial_distribution_between_walls_is_that_without(cell, cylinder):
    cell, walled = bd.radial_distribution(cell, bins=40), bd.radial_distribution(cylinder, bins=40)
    np.testing.assert_allclose(cell.distance, walled.distance)
    assert (cell.density[cell.distance < 0.8] == 0.0).all()
    assert walled.density[(walled.distance > 1.0) & (walled.distance < 1.1)].max() > 2.5
    far = walled.distance > 1.1
    assert np.corrcoef(walled.density[far], cell.density[far])[0, 1] > 0.95
    # Layers along the walls add to it at all distances.
    assert walled.density[far].mean() == pytest.approx(cell.density[far].mean(), abs=0.1)
    with pytest.raises(InputError, match="too few for a radial distribution"):
        bd.radial_distribution(bd.Particles([[0, 0, 0], [0.5, 0, 0]], 0.2, shape=bd.Ball(1.0)))


def test_layering_of_one_layer_of_touching_spheres_is_exact():
    side = np.arange(20) + 0.5
    grid = np.stack(np.meshgrid(side, side), axis=-1).reshape(-1, 2)
    layer = bd.Particles(np.column_stack([np.full(400, 0.5), grid]), 0.5, shape=bd.Box((8.0, 20.0, 20.0)))
    found = bd.wall_layering(layer, bins_per_diameter=10)
    assert set(found) == {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"}
    one = found["x_min"]
    t = one.distance[:10]
    np.testing.assert_allclose(one.volume_fraction[:10], np.pi / 4.0 * (1.0 - (2.0 * t - 1.0) ** 2), atol=0.03)
    np.testing.assert_allclose(one.volume_fraction[10:], 0.0)


@pytest.mark.validate
def test_layers_at_walls_die_out_in_a_random_packing_and_not_in_a_crystal(cylinder, ordered):
    random = bd.wall_layering(cylinder)
    assert set(random) == {"x_min", "x_max", "side"}
    for layering in random.values():
        assert layering.volume_fraction[layering.distance < 0.1].max() < 0.45
        assert 0.01 < layering.amplitude < 0.11
    sides = ("y_min", "y_max", "z_min", "z_max")
    random = bd.wall_layering(bd.pack(bd.Box((4.0, 1.0, 1.0)), count=2000, spread=0.25))
    layered = bd.wall_layering(ordered)
    assert sum(layered[side].amplitude for side in sides) > 1.5 * sum(random[side].amplitude for side in sides)
    assert bd.wall_layering(bd.pack(bd.Cell((1.0, 1.0, 1.0)), count=100)) == {}


def test_directions_are_isotropic():
    n = spread_directions(4096)
    np.testing.assert_allclose(np.linalg.norm(n, axis=1), 1.0)
    np.testing.assert_allclose(n.T @ n / len(n), np.eye(3) / 3.0, atol=2e-3)
