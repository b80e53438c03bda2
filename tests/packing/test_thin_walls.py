"""Packings between walls that are about as thick as an element is wide."""

import re

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError, PackingError

# A box with walls of 1 mm, open on one side, a wedge, and a thin plate.
OPEN_BOX = bd.Box((20e-3, 15e-3, 10e-3)).cut(bd.Box((18e-3, 13e-3, 10e-3)).moved((1e-3, 1e-3, 1e-3)))
WEDGE = bd.Box((20e-3, 10e-3, 5e-3)).cut(bd.Box((40e-3, 20e-3, 10e-3)).rotated("y", 0.23).moved((0, -5e-3, 5e-3)))
PLATE = bd.Box((10e-3, 7.5e-3, 1e-3))


@pytest.mark.parametrize(("shape", "count", "seed"), [(OPEN_BOX, 268, 1), (OPEN_BOX, 332, 2), (WEDGE, 9, 2)])
def test_pack_does_not_refuse_its_own_centres(shape, count, seed):
    """Soft spheres pushed each other out through the thin wall, or onto one place in the wedge, and stayed there."""
    particles = bd.pack(shape, count=count, method="even", seed=seed)
    body = bd.connect(particles, method="laguerre")
    assert (shape.depth(particles.position) > 0.0).all()
    assert body.cells.volume.sum() == pytest.approx(shape.volume, rel=2e-3)


@pytest.mark.parametrize(("shape", "method", "count"), [
    (OPEN_BOX, "even", 20), (PLATE, "even", 20), (PLATE, "quench", 20), (PLATE, "quench", 400),
])  # fmt: skip
def test_the_refusal_names_a_number_that_fits(shape, method, count):
    with pytest.raises((InputError, PackingError)) as refused:
        bd.pack(shape, count=count, method=method)
    message = str(refused.value)
    assert "\n" not in message
    found = re.search(r"count=(\d+) or more", message)
    assert found
    fits = int(found.group(1))
    assert count < fits < 2000
    assert len(bd.pack(shape, count=fits, method=method)) == fits


def test_stones_that_do_not_fit_are_to_be_smaller():
    with pytest.raises(InputError, match=r"do not fit into Box.*; give smaller ones, or a larger shape"):
        bd.aggregates(PLATE, sieve=bd.Sieve(diameters=(1.5e-3, 1.6e-3), mass_passing=(0, 1)), fraction=0.2, gap=1e-4)


def test_two_centres_at_one_place_are_named():
    with pytest.raises(InputError, match="elements 0 and 1 overlap"):
        bd.Particles(np.array([[0.0, 0, 0], [0, 0, 0], [1, 0, 0]]), [0.1, 0.1, 0.1])
