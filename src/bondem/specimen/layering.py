"""Layering of spheres at walls: solid fraction against the distance from each wall."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from bondem._checks import count as whole
from bondem._checks import instance, number
from bondem._types import Floats, Mask
from bondem.errors import InputError
from bondem.specimen.interior import region, samples, solid
from bondem.specimen.particles import Particles, freeze
from bondem.specimen.quasirandom import points_inside

_SAMPLES = 1 << 18
_ASIDE = 1.5  # least distance from the other walls, where there is room, in mean diameters
_FEW = 100  # least number of points per bin
_MOST_BINS = 10_000


@dataclass(frozen=True, eq=False)
class Layering:
    """Effect of one wall on the packing in front of it.

    Attributes:
        distance: distance from the wall at the middle of each bin, over the mean diameter 2R̄ [-], shape (b,).
        volume_fraction: solid fraction at that distance [-], shape (b,); NaN in bins of fewer than 100 sample points.
        amplitude: rms deviation of the solid fraction from its mean, over the mean, from two to four mean diameters
            from the wall [-]; NaN in thin bodies. A random packing, whose layers decay, has 0.04, and equal
            spheres ordered by the wall have 0.1. At a wall covered by a hundred spheres, chance gives 0.1.
    """

    distance: Floats
    volume_fraction: Floats
    amplitude: float


def wall_layering(particles: Particles, *, reach: float = 4.0, bins_per_diameter: int = 20) -> Mapping[str, Layering]:
    """Measure the solid fraction against the distance from each wall.

    Only the region 1.5 mean diameters or more from all other walls is evaluated, if there is such a region. Spheres
    and space are sampled by evenly spread points, so that the result is reproducible.

    Args:
        particles: the spheres; without a shape, the walls are the sides of their bounding box.
        reach: largest distance from the wall, in mean diameters [-].
        bins_per_diameter: number of bins per mean diameter.

    Returns:
        A mapping from face to layering; empty for a periodic cell.

    Raises:
        InputError: The reach or the number of bins is not positive, or there are too many bins.
    """
    instance("wall_layering", "particles", particles, Particles, "bd.Particles")
    reach = number("wall_layering", "reach", reach, above=0.0)
    bins_per_diameter = whole("wall_layering", "bins_per_diameter", bins_per_diameter, least=1)
    if reach * bins_per_diameter > _MOST_BINS:
        raise InputError(
            f"wall_layering: {reach:g} diameters of {bins_per_diameter} bins; give at most {_MOST_BINS} bins in all"
        )
    shape, diameter = region(particles), 2.0 * particles.mean_radius
    spheres = solid(particles, shape)
    space, share = points_inside(shape, samples(shape, _SAMPLES), 0.0)
    edge = np.linspace(0.0, reach, max(round(reach * bins_per_diameter), 1) + 1)
    # Depths in mean diameters, once per face, because those of a `Surface` take most of the time.
    of_space = {face: shape.face_depth(face, space) / diameter for face in shape.faces}
    of_solid = {face: shape.face_depth(face, spheres.position) / diameter for face in shape.faces}
    found = {}
    for face in shape.faces:
        free, full = _clear(of_space, face, len(space)), _clear(of_solid, face, len(spheres.volume))
        if np.count_nonzero(free) < _FEW * len(edge):
            free, full = np.ones_like(free), np.ones_like(full)
        room, _ = np.histogram(of_space[face][free], edge)
        filled, _ = np.histogram(of_solid[face][full], edge, weights=spheres.volume[full])
        fraction = np.where(room >= _FEW, filled / (share * np.maximum(room, 1)), np.nan)
        middle = 0.5 * (edge[1:] + edge[:-1])
        judged = fraction[(middle > 2.0) & (middle < 4.0)]
        found[face] = Layering(freeze(middle), freeze(fraction), _amplitude(judged))
    return found


def _clear(distance: Mapping[str, Floats], face: str, count: int) -> Mask:
    """Return a mask of the points at least 1.5 mean diameters from all faces but `face`, shape (count,)."""
    far = np.ones(count, dtype=bool)
    for other, away in distance.items():
        far &= (away >= _ASIDE) | (other == face)
    return far


def _amplitude(fraction: Floats) -> float:
    known = fraction[np.isfinite(fraction)]
    return float(known.std() / known.mean()) if len(known) and known.mean() > 0.0 else float("nan")
