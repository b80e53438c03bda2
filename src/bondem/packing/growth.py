"""Growth of moving hard spheres to jamming (Lubachevsky, Stillinger, J. Stat. Phys. 60, 1990).

The spheres never overlap. As free space shrinks the spheres collide ever more often. The pressure measures the
distance from jamming, because it grows like the inverse of the gaps.
"""

from collections.abc import Callable

import numpy as np

from bondem._checks import shown
from bondem._core import run_pass
from bondem._passes import calls
from bondem._types import Floats
from bondem.errors import InputError, PackingError
from bondem.geometry.elementary_shapes import Ball, Box, Cell, Cylinder, Shape
from bondem.packing.packing_tables import new_flight, new_growing
from bondem.packing.soft_spheres import SoftSpheres
from bondem.packing.start import thrown
from bondem.packing.targets import Fraction, Target

# Initial volume fraction, and its largest share of the requested volume fraction.
_START_FRACTION, _START_SHARE = 0.45, 0.9

# Growth rate of a radius over the mean speed: slower growth orders equal spheres; faster growth jams them looser.
_RATE = 0.02

# Reduced pressure p V / N kT at which spheres count as jammed: gaps are about its inverse, in diameters.
_JAMMED = 1e3

# Gaps up to which spheres are neighbours, over the mean radius: below and above the reduced pressure `_CAGED`.
_SKIN_FLYING, _SKIN_CAGED, _CAGED = 0.5, 0.15, 30.0

# Share of the neighbour gap reserved for growth; the rest is for flight.
_GROWTH_SHARE = 0.2

_COLLISIONS = 20_000  # largest number of collisions per sphere; some 800 are usual


def grow(
    shape: Shape, relative_radius: Floats, target: Target, random: np.random.Generator, on_step: Callable[[int], None]
) -> SoftSpheres:
    """Grow spheres of relative radii (n,) until they jam, or to the requested volume fraction if that comes first.

    Raises:
        InputError: The shape is not Box, Cylinder, Ball or Cell, or the spheres are too large for it.
        PackingError: The spheres are too crowded to move, or do not jam.
    """
    if not isinstance(shape, Box | Cylinder | Ball | Cell):
        raise InputError(
            f"method='growth' fills Box, Cylinder, Ball and Cell, not {shown(shape)}; use method='quench' or"
            " 'compression'"
        )
    wanted = target.volume_fraction if isinstance(target, Fraction) else np.inf
    spheres = thrown(shape, relative_radius, min(_START_FRACTION, _START_SHARE * wanted), random)
    spheres.on_step = on_step
    rest = spheres.relax(1.0, tolerance=1e-2, steps=20_000)
    if not rest.loose:
        raise PackingError(f"{spheres} are too crowded to move; ask for more spheres or use method='quench'")
    n, mean = len(relative_radius), spheres.mean_radius
    # Shrink the spheres to remove remaining overlaps, because hard spheres have none.
    spheres.scale = 1.0 - 1.001 * rest.largest_overlap * mean / float(spheres.unit.min())
    spheres.sphere[:, 3] = spheres.scale * spheres.unit
    velocity = spheres.table.velocity
    velocity[:] = random.standard_normal((n, 3))
    last = spheres.scale_for(wanted)
    pressure, collisions = 0.0, 0.0
    while spheres.scale < last and pressure < _JAMMED:
        if collisions > _COLLISIONS * n:
            raise PackingError(
                f"{spheres} did not jam in {_COLLISIONS} collisions each; ask for another seed="
                " or use method='quench'"
            )
        velocity *= mean * np.sqrt(n / (velocity**2).sum())
        skin = (_SKIN_CAGED if pressure > _CAGED else _SKIN_FLYING) * spheres.mean_radius
        near = spheres.near(skin, 0.5 * (1.0 - _GROWTH_SHARE) * 0.999)
        # Largest growth before spheres that are not neighbours can touch.
        gain = min(0.5 * _GROWTH_SHARE * skin / float(spheres.unit.max()), last - spheres.scale)
        heat = float((velocity**2).sum())
        growing = new_growing(spheres.scale, _RATE, gain / _RATE, 20 * n)
        run_pass(calls.fly_and_grow(spheres.table, spheres.walls, near, growing, new_flight(n)))
        elapsed, virial, met = growing.report.tolist()
        spheres.scale += _RATE * elapsed
        if last - spheres.scale < 1e-12:
            spheres.scale = last
        collisions += met
        heat = 0.5 * (heat + float((velocity**2).sum()))
        if met > n:
            pressure = 1.0 + virial / (heat * elapsed)
        spheres.steps += 1
        spheres.on_step(spheres.steps)
    return spheres
