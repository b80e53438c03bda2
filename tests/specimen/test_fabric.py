"""Fabric: the geode, eq 11 of André et al. (2012), χ² with true solid angles, and a verdict that can fail."""

import math

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import bondem as bd
from bondem.specimen.direction_sphere import direction_sphere
from tests.specimens import crystal

# Crystals and handfuls of spheres stick out of the boxes they are measured in.
pytestmark = pytest.mark.filterwarnings("ignore::bondem.errors.FillingWarning")


def directions(count, seed=0):
    vector = np.random.default_rng(seed).normal(size=(count, 3))
    return vector / np.linalg.norm(vector, axis=1, keepdims=True)


def chain(direction):
    """A lattice whose bond k lies along `direction[k]`, in either sense: it never turns back on itself."""
    onward = np.where(direction[:, :1] < 0.0, -direction, direction)
    centre = np.cumsum(np.vstack([np.zeros(3), onward]), axis=0)
    k = np.arange(len(direction))
    return bd.Lattice(bd.Particles(centre, 1e-5), np.column_stack([k, k + 1]))


def test_geode_is_a_sphere_of_320_faces():
    sphere = direction_sphere()
    assert sphere.vertices.shape == (162, 3)
    assert sphere.faces.shape == (320, 3)
    np.testing.assert_allclose(np.linalg.norm(sphere.vertices, axis=1), 1.0, rtol=1e-14)
    assert sphere.solid_angle.sum() == pytest.approx(4.0 * math.pi, rel=1e-13)
    assert sphere.solid_angle.max() * 320 / (4.0 * math.pi) == pytest.approx(1.19, abs=0.005)
    # Euler: every edge belongs to two faces, in opposite senses.
    edges = np.concatenate([sphere.faces[:, [0, 1]], sphere.faces[:, [1, 2]], sphere.faces[:, [2, 0]]])
    assert len(np.unique(edges, axis=0)) == 960
    assert {tuple(e) for e in edges} == {tuple(e[::-1]) for e in edges}


def test_opposite_faces_are_mirror_images_through_the_centre():
    sphere = direction_sphere()
    centre = sphere.vertices[sphere.faces].mean(axis=1)
    np.testing.assert_allclose(centre[sphere.opposite], -centre, atol=1e-12)
    np.testing.assert_allclose(sphere.solid_angle[sphere.opposite], sphere.solid_angle, rtol=1e-12)


def test_directions_fall_into_the_face_they_cross():
    sphere = direction_sphere()
    n = directions(5000)
    corner = sphere.vertices[sphere.faces[sphere.face_of(n)]]
    for k in range(3):
        side = np.cross(corner[:, k], corner[:, (k + 1) % 3])
        assert (np.einsum("mc,mc->m", side, n) > -1e-12).all()


def test_faces_catch_their_solid_angle():
    sphere = direction_sphere()
    count = np.bincount(sphere.face_of(directions(400_000)), minlength=320)
    expected = 400_000 * sphere.solid_angle / (4.0 * math.pi)
    assert ((count - expected) ** 2 / expected).sum() / 319 == pytest.approx(1.0, abs=4.0 * math.sqrt(2.0 / 319))


def test_eq_11_against_the_sum_written_out():
    n = directions(700)
    sphere = direction_sphere()
    e = 0.0
    both = np.concatenate([sphere.face_of(n), sphere.face_of(-n)])
    for face in range(320):
        e += (np.count_nonzero(both == face) / 1400.0 - 1.0 / 320.0) ** 2 / 320.0
    quality = bd.fabric(chain(n))
    assert quality.isotropy_error == pytest.approx(e, rel=1e-12)
    assert quality.face_counts.sum() == 1400


def test_eq_11_of_a_straight_chain_shows_that_the_printed_limit_excludes_nothing():
    quality = bd.fabric(chain(np.tile([0.3, 0.1, 0.9486833], (50, 1))))
    # All bonds in one face and its antipode: 2 (1/2 - 1/320)² + 318/320², over 320.
    assert quality.isotropy_error == pytest.approx((2.0 * (0.5 - 1 / 320) ** 2 + 318 / 320**2) / 320, rel=1e-12)
    assert quality.isotropy_error < 0.0032
    assert not quality.passed


def test_chi2_counts_each_bond_once_in_160_classes():
    n = directions(3000, seed=4)
    sphere = direction_sphere()
    first = np.flatnonzero(np.arange(320) < sphere.opposite)
    face = sphere.face_of(n)
    observed = np.array([np.count_nonzero((face == f) | (face == sphere.opposite[f])) for f in first])
    expected = 3000 * sphere.solid_angle[first] / (2.0 * math.pi)
    quality = bd.fabric(chain(n))
    assert len(first) == 160
    assert quality.chi2_per_dof == pytest.approx(((observed - expected) ** 2 / expected).sum() / 159, rel=1e-12)


@pytest.mark.validate
def test_chi2_of_random_directions_is_one_and_the_excess_nothing():
    found = np.array([bd.fabric(chain(directions(2000, seed))).chi2_per_dof for seed in range(20)])
    assert found.mean() == pytest.approx(1.0, abs=4.0 * math.sqrt(2.0 / 159 / 20))
    assert bd.fabric(chain(directions(40_000))).rms_excess < 0.05


def test_excess_is_the_size_of_the_anisotropy_at_every_sample_size():
    # Density 1 + a (3 cos² - 1)/2: its rms deviation is a/√5.
    a = 0.6
    for count in (4000, 40_000):
        n = directions(4 * count, seed=7)
        keep = np.random.default_rng(1).random(len(n)) < (1.0 + a * (1.5 * n[:, 2] ** 2 - 0.5)) / (1.0 + a)
        quality = bd.fabric(chain(n[keep]))
        assert quality.rms_excess == pytest.approx(a / math.sqrt(5.0), abs=0.03)
        # ... and its fabric tensor 1/3 + 2a/15 along the axis.
        assert quality.fabric_tensor[2, 2] == pytest.approx(1.0 / 3.0 + 2.0 * a / 15.0, abs=0.02)


def test_fabric_tensor_turns_with_the_lattice_and_measures_do_not_depend_on_size_or_order():
    particles = bd.pack(bd.Ball(1.0), count=300, spread=0.25)
    lattice = bd.connect(particles)
    turn = Rotation.from_euler("xyz", [0.3, 0.7, -0.4])
    quality = bd.fabric(lattice)
    R = turn.as_matrix()
    turned = bd.fabric(bd.Lattice(bd.Particles(particles.position @ R.T, particles.radius), lattice.pairs))
    np.testing.assert_allclose(turned.fabric_tensor, R @ quality.fabric_tensor @ R.T, atol=1e-14)
    np.testing.assert_allclose(turned.eigenvalues, quality.eigenvalues, atol=1e-14)
    assert np.trace(quality.fabric_tensor) == pytest.approx(1.0, rel=1e-14)

    order = np.random.default_rng(0).permutation(300)
    number = np.argsort(order)
    shape = bd.Ball(7.0)
    other = bd.Particles(7.0 * particles.position[order], 7.0 * particles.radius[order], shape=shape)
    again = bd.fabric(bd.Lattice(other, number[lattice.pairs][::-1, ::-1]))
    for name in ("volume_fraction", "largest_overlap", "isotropy_error", "chi2_per_dof", "rms_excess"):
        assert getattr(again, name) == pytest.approx(getattr(quality, name), rel=1e-9)
    np.testing.assert_array_equal(again.coordination_histogram, quality.coordination_histogram)


def test_counts_of_a_lattice_known_by_hand():
    centre = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [2, 1, 0], [5, 5, 5]]
    particles = bd.Particles(centre, [0.5, 0.6, 0.5, 0.5, 0.4], shape=bd.Box((10, 10, 10)))
    lattice = bd.Lattice(particles, [[0, 1], [1, 2], [2, 3]])
    quality = bd.fabric(lattice)
    assert quality.coordination_number == pytest.approx(6 / 5)
    np.testing.assert_array_equal(quality.coordination_histogram, [1, 2, 2])
    assert quality.rattlers == 1
    assert quality.largest_overlap == pytest.approx(0.1 / 0.5)
    solid = 4.0 / 3.0 * math.pi * (3 * 0.5**3 + 0.6**3 + 0.4**3)
    assert quality.volume_fraction == pytest.approx(solid / 1000.0)
    np.testing.assert_allclose(quality.fabric_tensor, np.diag([2 / 3, 1 / 3, 0.0]))


@pytest.mark.parametrize("seed", [1, pytest.param(2, marks=pytest.mark.validate)])
@pytest.mark.parametrize("shape", [bd.Cylinder(1.0, 8.0), bd.Ball(1.0), bd.Cell((1.0, 1.0, 1.0))], ids=repr)
def test_good_packings_pass(shape, seed):
    quality = bd.fabric(bd.connect(bd.pack(shape, count=1500, spread=0.25, seed=seed)))
    assert quality.passed, quality.reasons


@pytest.mark.parametrize("period", [True, False])
def test_cubic_crystal_fails_in_any_orientation(period, record):
    particles = crystal(periodic=period)
    if not period:
        turn = Rotation.from_euler("xyz", [0.4, 1.1, -0.3])
        particles = bd.Particles(particles.position @ turn.as_matrix().T, particles.radius)
    quality = bd.fabric(bd.connect(particles))
    assert quality.rms_excess > 3.0
    np.testing.assert_allclose(quality.eigenvalues, 1.0 / 3.0, atol=0.02)  # the tensor alone does not see it
    assert not quality.passed
    assert "ordered" in quality.reasons[0]
    record("FCC crystal is rejected", not quality.passed)


def test_density_and_contacts_of_the_cubic_crystal_are_exact():
    quality = bd.fabric(bd.connect(crystal()))
    assert quality.volume_fraction == pytest.approx(math.pi / math.sqrt(18.0), rel=1e-12)
    assert quality.coordination_number == 12.0
    assert quality.largest_overlap == pytest.approx(0.0, abs=1e-12)


def test_equal_spheres_that_crystallised_between_flat_walls_fail():
    quality = bd.fabric(bd.connect(bd.pack(bd.Box((4.0, 1.0, 1.0)), count=2000, spread=0.0)))
    assert not quality.passed
    assert "ordered" in quality.reasons[0]


def test_a_stretched_packing_fails_by_its_fabric_tensor():
    particles = bd.pack(bd.Cell((1.0, 1.0, 1.0)), count=1500, spread=0.25)
    pairs = bd.connect(particles).pairs
    stretch = np.array([1.0, 1.0, 1.25])
    stretched = bd.Particles(stretch * particles.position, 0.9 * particles.radius, period=stretch)
    quality = bd.fabric(bd.Lattice(stretched, pairs))
    assert any("prefer a direction" in reason for reason in quality.reasons)


def test_a_lattice_too_small_to_judge_says_so():
    quality = bd.fabric(bd.connect(bd.pack(bd.Ball(1.0), count=60, spread=0.25)))
    assert "too few to judge" in quality.reasons[0]
