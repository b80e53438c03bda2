"""The default recipe: quench random soft spheres, then find the scale of radii with the wanted contacts.

Spheres thrown into the shape at random, at a density somewhat above jamming, are brought to rest. Then all
radii are scaled by a common factor, the spheres brought to rest again, and so on until the coordination
number is on target. Above jamming (z - z_J)² grows in proportion to the logarithm of the scale (O'Hern et al., Phys. Rev. E 68,
2003), so that a secant on that square lands in a few steps.
"""

import math
from collections.abc import Callable

import numpy as np

from bondem._types import Floats
from bondem.errors import PackingError
from bondem.packing.relaxation import SoftSpheres
from bondem.packing.start import morton_order, random_centres
from bondem.specimen.geometry import Shape

# Volume fraction at which the random spheres are let loose: above jamming, so that they come to rest fast.
_START_FRACTION = 0.635

# Rms force over mean contact force at rest: to get near the target, and in the packing that is returned.
_ROUGH, _FINE = 3e-2, 5e-3

# Coordination number at jamming, rattlers included, and d(z - z_J)²/d ln(scale): only first guesses.
_Z_JAMMED, _SLOPE = 5.6, 110.0

_ACCEPTED = 0.03
_STEPS = 20_000
_ROUNDS = 25


def quench(
    shape: Shape,
    relative_radius: Floats,
    coordination_number: float,
    random: np.random.Generator,
    progress: Callable[[float], None],
) -> tuple[Floats, Floats]:
    """Pack spheres whose radii are given up to a common factor.

    Args:
        shape: what to fill.
        relative_radius: radii up to a common factor, (n,).
        coordination_number: z to reach, over all spheres [-].
        random: where the randomness comes from.
        progress: told the done share, 0 to 1.

    Returns:
        Centres [m], (n, 3), and radii [m], (n,), neighbours in space near in order.

    Raises:
        PackingError: the target is out of reach.
    """
    solid = 4.0 / 3.0 * math.pi * float((relative_radius**3).sum())
    radius = relative_radius * (_START_FRACTION * shape.volume / solid) ** (1.0 / 3.0)
    centre = random_centres(shape, radius, random)
    order = morton_order(centre, *shape.bounds)
    spheres = SoftSpheres(shape, centre[order], radius[order])
    allowed = max(_ACCEPTED, 2.0 / len(radius))

    size, slope = 0.0, _SLOPE
    last: tuple[float, float] | None = None
    tolerance = _ROUGH
    for turn in range(_ROUNDS):
        rest = spheres.relax(math.exp(size), tolerance=tolerance, steps=_STEPS)
        progress(1.0 - 0.5 ** (turn + 1))
        z = rest.coordination_number
        if abs(z - coordination_number) <= allowed:
            if tolerance == _FINE:
                progress(1.0)
                return spheres.sphere[:, :3].copy(), spheres.sphere[:, 3].copy()
            tolerance = _FINE
            continue
        excess = _signed_square(z - _Z_JAMMED)
        if last is not None and abs(size - last[0]) > 1e-5:
            slope = min(max((excess - last[1]) / (size - last[0]), 0.4 * _SLOPE), 4.0 * _SLOPE)
        last = (size, excess)
        if abs(z - coordination_number) < 0.2:
            tolerance = _FINE
        size += (_signed_square(coordination_number - _Z_JAMMED) - excess) / slope
    raise PackingError(
        f"{len(radius)} spheres in {shape} reached a coordination number of {z:.2f}, not {coordination_number:.2f};"
        " ask for more spheres, another seed= or another coordination_number="
    )


def _signed_square(value: float) -> float:
    return math.copysign(value * value, value)
