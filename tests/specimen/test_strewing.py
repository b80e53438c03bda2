"""Bodies at random places: none outside the shape, none that touch, the same ones for a seed."""

import numpy as np
import pytest
from scipy.spatial import KDTree

import bondem as bd
from bondem.errors import InputError, PackingError
from tests.specimens import cells, spheres

ROCK = spheres(bd.Ball(radius=5e-3), 60, seed=1, reach=1.01)
ROOM = bd.Box((40e-3, 40e-3, 40e-3))


def least_gap(scene: bd.Lattice, centre: np.ndarray, radius: np.ndarray) -> float:
    """Least distance of the surfaces of spheres of different bodies [m]."""
    near = KDTree(centre).query_pairs(4.0 * radius.max(), output_type="ndarray")
    i, j = near[scene.body[near[:, 0]] != scene.body[near[:, 1]]].T
    return float((np.linalg.norm(centre[j] - centre[i], axis=1) - radius[i] - radius[j]).min())


def test_strewn_bodies_lie_apart_within_their_shape():
    gap = 3e-4
    scene = bd.strew(ROCK, ROOM, 25, seed=2, gap=gap, name="rock")
    assert scene.names == tuple(f"rock/{k}" for k in range(25))
    position, radius = scene.particles.position, scene.particles.radius
    assert (ROOM.depth(position) >= radius - 1e-15).all()
    assert gap < least_gap(scene, position, radius) < 2.0 * gap  # and some are near
    # each is the body itself, rotated: distances within it are as before
    for k in range(25):
        own = position[scene.body == k]
        apart, before = own - own[0], ROCK.particles.position - ROCK.particles.position[0]
        assert np.allclose(apart @ apart.T, before @ before.T, rtol=0.0, atol=1e-15)
    again = bd.strew(ROCK, ROOM, 25, seed=2, gap=gap, name="rock")
    np.testing.assert_array_equal(again.particles.position, position)


def test_strewn_bodies_have_random_orientations():
    scene = bd.strew(cells(bd.Box((6e-3, 2e-3, 2e-3)), 24), bd.Box((0.2, 0.2, 0.2)), 150, seed=3)
    axes = []
    for k in range(150):
        own = scene.centre[scene.body == k]
        axes.append(np.linalg.svd(own - own.mean(axis=0))[2][0])
    # of random axes the mean of n⊗n is 1/3, with a standard error of 2 / (3 √5) / √150
    assert np.abs(np.mean([np.outer(n, n) for n in axes], axis=0) - np.eye(3) / 3.0).max() < 4 * 0.298 / np.sqrt(150)


def test_strewn_cells_do_not_touch():
    brick = cells(bd.Box((8e-3, 5e-3, 3e-3)), 30)
    scene = bd.strew(brick, ROOM, 12, seed=1)
    model = bd.Model(scene, bd.CellBond(E=1e9, nu=0.2), 2500.0, contact=bd.LinearContact(E=1e9, stress_free=False))
    assert least_gap(scene, scene.centre, model.contact_radius) > 0.0
    assert bd.solve_explicit(model, duration=1e-5).history.energy["contact"].max() == 0.0


@pytest.mark.parametrize(("error", "words", "options"), [
    (PackingError, r"strew: 1 of 50 bodies fitted into Box.* in 20 attempts; give fewer", {"count": 50}),
    (InputError, "count = 0", {"count": 0}),
    (InputError, "gap = -1", {"gap": -1.0}),
    (InputError, "attempts = 0", {"attempts": 0}),
    (InputError, "not periodic", {"shape": bd.Cell((1.0, 1.0, 1.0))}),
    (InputError, "takes one body, not a scene of 2", {"body": bd.join(ROCK, ROCK.moved((0.0, 0.0, 0.1)))}),
])  # fmt: skip
def test_what_cannot_be_strewn_is_refused_in_one_line(error, words, options):
    given = {"body": ROCK, "shape": bd.Box((16e-3, 16e-3, 16e-3)), "count": 2, "attempts": 20} | options
    with pytest.raises(error, match=words) as caught:
        bd.strew(**given)
    assert "\n" not in str(caught.value)
