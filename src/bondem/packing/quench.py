"""Quench, the default method: random soft spheres with large overlaps push each other apart."""

from collections.abc import Callable

import numpy as np

from bondem._types import Floats
from bondem.geometry.elementary_shapes import Shape
from bondem.packing.soft_spheres import SoftSpheres
from bondem.packing.start import thrown
from bondem.packing.targets import Jammed, Target

# Initial volume fraction, far above jamming: spheres come to rest fast, and decompression leaves a denser and more
# even packing than a quench near jamming. Such a packing also jams at a higher density (0.643 for equal spheres). The
# second value, just above jamming, is used if jamming is the target.
_START_FRACTION, _START_JAMMED = 0.75, 0.655
# Widely spread radii jam denser: φ = φ₁ + 0.0658 δ + 0.0857 S δ², with δ the standard deviation over the mean and S
# the skewness (Desmond and Weeks, Phys. Rev. E 90, 022204, 2014). Below δ = _WIDE the difference does not matter.
_WIDE, _OF_SPREAD, _OF_SKEWNESS = 0.2, 0.0658, 0.0857

_ROUGH, _STEPS = 3e-2, 10_000


def quench(
    shape: Shape, relative_radius: Floats, target: Target, random: np.random.Generator, on_step: Callable[[int], None]
) -> SoftSpheres:
    """Relax random spheres far above jamming, or just above it if jamming is the target.

    `relative_radius` (n,) are radii up to a common factor. `Target.reach` then decompresses the spheres.

    Raises:
        InputError: The spheres are too large for the shape.
    """
    start = _just_above_jamming(relative_radius) if isinstance(target, Jammed) else _START_FRACTION
    spheres = thrown(shape, relative_radius, start, random)
    spheres.on_step = on_step
    spheres.relax(1.0, tolerance=_ROUGH, steps=_STEPS)
    return spheres


def _just_above_jamming(radius: Floats) -> float:
    mean, deviation = radius.mean(), radius.std()
    if deviation < _WIDE * mean:
        return _START_JAMMED
    skewness = float(np.mean((radius - mean) ** 3)) / deviation**3
    denser = _OF_SPREAD * deviation / mean + _OF_SKEWNESS * skewness * (deviation / mean) ** 2
    return min(_START_JAMMED + denser, _START_FRACTION)
