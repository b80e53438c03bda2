"""Homogeneity of a packing: strata, gradients and layers along x, y and z, away from the walls.

Gravity has three effects: density and contacts that vary with height, segregated sizes, and centres in horizontal
layers. All are measured as effect sizes beyond chance, which do not depend on the number of elements.
"""

from dataclasses import dataclass

import numpy as np

from bondem._types import Floats, Ints, PerElement, PerElement3, Vector
from bondem.geometry.elementary_shapes import Shape
from bondem.specimen.interior import Solid, samples
from bondem.specimen.particles import freeze
from bondem.specimen.quasirandom import points_inside

_SAMPLES = 1 << 16
_THICKNESS = 2.0  # least thickness of a slice, in mean diameters
_MOST = 12  # largest number of slices along an axis
_CHANCE_DENSITY = 0.20  # σ(φ)/φ of n spheres between planes, times n^(2/3): measured on random packings
_WAVES = (0.65, 1.25)  # wavelengths of layers, in mean diameters
_SURE = 2.0  # standard deviations by which chance may exceed its mean
_SHORTEST = 4.0  # least extent for layers that differ from those at walls, in mean diameters
_WINDOW = 100.0  # largest extent in which layers are detected, in mean diameters
_STRUCTURE = 3.0  # structure factor of a jammed packing at its first peak, the ratio of chance to Poisson's
_LISTENED = 20_000  # largest number of centres from which layers are computed


@dataclass(frozen=True, eq=False)
class Strata:
    """Differences between slices of the core across x, y and z, beyond those of chance.

    A value is NaN along an axis shorter than two slices of two mean diameters, or four diameters for layers. The
    squares of the first three are reduced by the mean and two standard deviations of those by chance. The square of
    `layers` is reduced by that of the largest wave expected by chance. Gradients are not reduced.

    Attributes:
        density: relative rms deviation of the solid fraction of slices from their mean [-], (3,).
        coordination: relative rms deviation of the mean number of bonds per element in slices [-], (3,).
        size: rms deviation of the mean radius in slices, over the standard deviation of all radii [-], (3,). This
            correlation ratio is 1 if elements are sorted by size, and 0 if all radii are equal.
        density_gradient: change of the solid fraction along a fitted line, from end to end, over its mean [-], (3,).
        coordination_gradient: change of the bonds per element along a fitted line, over their mean [-], (3,).
        layers: largest amplitude of waves of 0.65 to 1.25 mean diameters in the density of centres, over its mean
            [-], (3,): 0 in a random packing, up to 2 in plane layers.
    """

    density: Vector
    coordination: Vector
    size: Vector
    density_gradient: Vector
    coordination_gradient: Vector
    layers: Vector


def strata(shape: Shape, position: PerElement3, radius: PerElement, bonds: Ints, core: Solid, depth: float) -> Strata:
    """Measure differences between slices of the core across x, y and z.

    Args:
        shape: shape filled by the elements.
        position: centres [m], shape (n, 3).
        radius: radii [m], shape (n,).
        bonds: number of bonds of each element, shape (n,).
        core: points that represent the solid of the elements in the core.
        depth: distance of the core from the walls [m].

    Returns:
        The differences beyond chance.
    """
    found = np.full((6, 3), np.nan)
    inside = shape.depth(position) >= depth
    diameter = 2.0 * radius.mean()
    lower, upper = shape.bounds
    if shape.faces:
        lower, upper = lower + depth, upper - depth
    if inside.sum() < 2:
        return Strata(*found)
    space, share = points_inside(shape, samples(shape, _SAMPLES), depth)
    centre, r, z = position[inside], radius[inside], bonds[inside].astype(float)
    full, volume = core.position, core.volume
    for axis in range(3):
        found[5, axis] = _layers(centre[:, axis], diameter, not shape.faces, upper[axis] - lower[axis])
        count = min(int((upper[axis] - lower[axis]) / (_THICKNESS * diameter)), _MOST)
        if count < 2:
            continue
        edge = np.linspace(lower[axis], upper[axis], count + 1)
        place = np.clip(np.searchsorted(edge, centre[:, axis], side="right") - 1, 0, count - 1)
        here = np.bincount(place, minlength=count).astype(float)
        room = np.histogram(space[:, axis], edge)[0] * share
        fraction = np.histogram(full[:, axis], edge, weights=volume)[0] / np.maximum(room, share)
        used = here > 1
        if used.sum() < 2:
            continue
        chance = _CHANCE_DENSITY**2 * here[used] ** (-4.0 / 3.0)
        found[0, axis], found[3, axis] = _spread(fraction[used], here[used], chance, edge[:-1][used])
        means = np.bincount(place, weights=z, minlength=count)[used] / here[used]
        noise = z.var() / max(z.mean(), 1e-300) ** 2 / here[used]
        found[1, axis], found[4, axis] = _spread(means, here[used], noise, edge[:-1][used])
        sizes = np.bincount(place, weights=r, minlength=count)[used] / here[used]
        variation = r.std() / r.mean()
        if variation > 1e-9:
            found[2, axis] = _spread(sizes, here[used], variation**2 / here[used], edge[:-1][used])[0] / variation
        else:
            found[2, axis] = 0.0
    return Strata(*(freeze(row) for row in found))


def _spread(value: Floats, weight: Floats, chance: Floats, place: Floats) -> tuple[float, float]:
    """Return the relative rms deviation beyond chance, and the relative change of a fitted line from end to end."""
    share = weight / weight.sum()
    mean = max(float(share @ value), 1e-300)
    deviation = value / mean - 1.0
    expected = share @ ((1.0 - share) * chance) + _SURE * np.sqrt(2.0 * ((share * chance) ** 2).sum())
    beyond = float(share @ deviation**2 - expected)
    s = place - share @ place
    slope = float(share @ (s * deviation) / (share @ s**2))
    return float(np.sqrt(max(beyond, 0.0))), slope * float(np.ptp(place))


def _layers(along: Floats, diameter: float, periodic: bool, extent: float) -> float:
    middle = 0.5 * (along.max() + along.min())
    if extent > _WINDOW * diameter:
        extent, periodic = _WINDOW * diameter, False
        along = along[np.abs(along - middle) < 0.5 * extent]
    if len(along) > _LISTENED:
        along = along[:: -(-len(along) // _LISTENED)]
    shortest, longest = (wave * diameter for wave in _WAVES)
    if extent < _SHORTEST * diameter or len(along) < 2:
        return float("nan")
    # Waves that fit into a periodic cell; between walls wave numbers half as far apart, under a smooth window.
    step = 1.0 / extent if periodic else 0.5 / extent
    number = np.arange(np.ceil(1.0 / (longest * step)), np.floor(1.0 / (shortest * step)) + 1.0)
    weight = np.ones(len(along)) if periodic else np.cos(np.pi * (along - middle) / extent) ** 2
    weight /= weight.sum()
    turn = np.exp(2j * np.pi * step * (along - middle))
    wave = turn ** number[0]
    power = np.empty(len(number))
    for k in range(len(number)):
        power[k] = abs(weight @ wave) ** 2
        wave = wave * turn
    chance = _STRUCTURE * np.log(len(number) + 1.0) * float(weight @ weight)
    return float(2.0 * np.sqrt(max(power.max() - chance, 0.0)))
