"""Initial places of spheres of two very different sizes: large ones are separated first, small ones fill the rest.

If all are placed at once, small spheres are caught between large ones that overlap deeply. A large sphere touches as
many small ones as fit on its surface, a hundred at a ratio of 1 : 5. With equal masses such a sphere is too stiff for
the steps of the relaxation, and never comes to rest. Here its mass is (R / r)², with r the mean radius of the small
ones, so that all spheres are about equally fast.
"""

import math
from collections.abc import Callable

import numpy as np
from scipy.spatial import KDTree

from bondem._checks import shown
from bondem._types import Floats
from bondem.errors import PackingError
from bondem.geometry.elementary_shapes import Shape
from bondem.packing.soft_spheres import SoftSpheres
from bondem.packing.start import thrown

# Ratio of neighbouring sizes from which they divide the spheres into large and small ones.
_APART = 2.0
# Initial volume fractions of all spheres, tried in turn until the large spheres do not overlap.
_FRACTIONS = (0.72, 0.68, 0.64, 0.6)
# Overlap of large spheres, over their mean radius, that counts as none.
_BESIDE = 0.02
# Rms force over mean contact force at rest, and largest number of steps to it.
_ROUGH, _STEPS = 3e-2, 20_000
# Largest numbers of draws of large spheres at each volume fraction, and of centres of small ones.
_THROWS, _TRIES = 8, 2000


def parting(radius: Floats) -> float | None:
    """Return the radius that separates large spheres from small ones, in the widest gap of sizes.

    Args:
        radius: radii of all spheres, (n,).

    Returns:
        The radius, or None if no two successive sizes differ by a factor of two or more.
    """
    size = np.unique(radius)
    if len(size) < 2:
        return None
    gap = int(np.argmax(size[1:] / size[:-1]))
    below, above = float(size[gap]), float(size[gap + 1])
    return math.sqrt(below * above) if above >= _APART * below else None


def separated(
    shape: Shape, relative_radius: Floats, limit: float, random: np.random.Generator, on_step: Callable[[int], None]
) -> SoftSpheres:
    """Return spheres relaxed above jamming, whose large spheres hardly overlapped at the start.

    Args:
        shape: shape to fill.
        relative_radius: radii up to a common factor, (n,).
        limit: relative radius above which spheres count as large, from `parting`.
        random: random generator.
        on_step: function called repeatedly with the number of steps.

    Raises:
        InputError: The spheres are too large for the shape.
        PackingError: The large spheres cannot be placed beside each other, or leave no room for the small ones.
    """
    large = relative_radius > limit
    volume = 4.0 / 3.0 * math.pi * relative_radius**3
    share = float(volume[large].sum() / volume.sum())
    for fraction in _FRACTIONS * _THROWS:
        beside = thrown(shape, relative_radius[large], fraction * share, random)
        if beside.relax(1.0, tolerance=_ROUGH, steps=_STEPS).largest_overlap <= _BESIDE:
            break
    else:
        raise PackingError(f"the {int(large.sum())} large spheres do not fit beside each other into {shown(shape)}")
    small = relative_radius[~large] * (fraction * shape.volume / float(volume.sum())) ** (1.0 / 3.0)
    centre = np.concatenate([beside.sphere[:, :3], _between(shape, beside.sphere, small, random)])
    radius = np.concatenate([beside.sphere[:, 3], small])
    spheres = SoftSpheres(shape, centre, radius)
    spheres.on_step = on_step
    spheres.weigh(float(small.mean()))
    spheres.relax(1.0, tolerance=_ROUGH, steps=_STEPS)
    return spheres


def _between(shape: Shape, large: Floats, radius: Floats, random: np.random.Generator) -> Floats:
    """Draw random centres of small spheres that touch neither large ones nor walls [m], (k, 3)."""
    lower, upper = shape.bounds
    period = shape.period
    tree = KDTree(large[:, :3] if period is None else large[:, :3] % period, boxsize=period)
    centre = np.empty((len(radius), 3))
    missing = np.arange(len(radius))
    for _ in range(_TRIES):
        x = lower + (upper - lower) * random.random((len(missing), 3))
        distance, nearest = tree.query(x if period is None else x % period)
        centre[missing] = x
        inside = shape.depth(x) >= radius[missing]
        missing = missing[~(inside & (distance >= large[nearest, 3] + radius[missing]))]
        if not missing.size:
            return centre
    raise PackingError("the large spheres leave no room for small ones between them")
