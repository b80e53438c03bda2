"""Radial distribution function of the centres of a packing."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial import KDTree

from bondem._checks import count as whole
from bondem._checks import instance, number
from bondem._types import Floats
from bondem.errors import InputError
from bondem.geometry.elementary_shapes import Shape
from bondem.specimen.interior import core_volume, region, samples
from bondem.specimen.particles import Particles, freeze
from bondem.specimen.quasirandom import points_inside, spread_directions

_CORE_DEPTH = 3.0  # mean radii from wall to centre
_SAMPLES = 1 << 15
_CENTRES = 20_000
_MOST_BINS = 10_000
_SUPPORTS = 21  # distances between which the covariance, a smooth curve, is interpolated


@dataclass(frozen=True, eq=False)
class RadialDistribution:
    """A radial distribution function.

    Attributes:
        distance: middle of each shell, over the mean diameter 2R̄ [-], shape (b,).
        density: g, number density of centres in the shell around a centre, over the mean number density [-],
            shape (b,). It is 1 without order, and approaches 1 at large distances in a random packing.
    """

    distance: Floats
    density: Floats


def radial_distribution(particles: Particles, *, reach: float = 4.0, bins: int = 80) -> RadialDistribution:
    """Compute g(r / 2R̄) of the centres that lie three mean radii or more from every wall.

    In a periodic cell every pair counts over its nearest image. Between walls the pairs inside the core are counted
    and divided by the number expected without order. That number follows from the set covariance of the core (Ohser's
    edge correction), computed with 32 768 evenly spread points and directions to 1 %. Residual layers along walls add
    to g at all distances: 7 % in a cylinder of 3000 elements four diameters long, 5 % in one of 10 000. Above 20 000
    centres, only pairs of every k-th centre with all others are counted.

    Args:
        particles: the spheres.
        reach: largest distance, in mean diameters [-]; less if the specimen is smaller.
        bins: number of shells.

    Returns:
        Distances, over the mean diameter [-], and g [-] at them.

    Raises:
        InputError: The region away from the walls has too few centres, or `reach` or `bins` is out of range.
    """
    instance("radial_distribution", "particles", particles, Particles, "bd.Particles")
    reach = number("radial_distribution", "reach", reach, above=0.0)
    bins = whole("radial_distribution", "bins", bins, least=1)
    if bins > _MOST_BINS:
        raise InputError(f"radial_distribution: bins = {bins}; give at most {_MOST_BINS}")
    shape, diameter = region(particles), 2.0 * particles.mean_radius
    depth = _CORE_DEPTH * particles.mean_radius
    centre = particles.position[shape.depth(particles.position) >= depth]
    lower, upper = shape.bounds
    if particles.period is not None:
        farthest = 0.5 * (1.0 - 1e-9) * float(particles.period.min())
    else:
        farthest = 0.5 * float((upper - lower).max()) - depth
    farthest = min(reach * diameter, farthest)
    if len(centre) < 2 or farthest <= diameter:
        raise InputError(
            f"{len(centre)} centres lie three mean radii from every wall: too few for a radial distribution function;"
            " use more elements"
        )
    edge = np.linspace(0.0, farthest, bins + 1)
    some = centre[:: -(-len(centre) // _CENTRES)]
    tree = KDTree(centre, boxsize=particles.period)
    # Counts are cumulative from distance 0, at which every centre counts itself.
    pairs = np.diff(KDTree(some, boxsize=particles.period).count_neighbors(tree, edge).astype(float))
    density = len(centre) / core_volume(shape, depth)
    shell = 4.0 / 3.0 * np.pi * np.diff(edge**3)
    middle = 0.5 * (edge[1:] + edge[:-1])
    expected = len(some) * density * shell * _covariance(shape, depth, middle)
    g = np.divide(pairs, expected, out=np.full(bins, np.nan), where=expected > 0.0)
    return RadialDistribution(freeze(middle / diameter), freeze(g))


def _covariance(shape: Shape, depth: float, distance: Floats) -> Floats:
    """Return the probability that a point at a distance [m], (b,), from a point `depth` [m] inside is as deep too."""
    if not shape.faces:
        return np.ones(len(distance))
    points, _ = points_inside(shape, samples(shape, _SAMPLES), depth)
    direction = spread_directions(len(points))
    some = np.linspace(0.0, distance[-1], _SUPPORTS)
    return np.interp(distance, some, [(shape.depth(points + r * direction) >= depth).mean() for r in some])
