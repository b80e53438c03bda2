"""Isotropic compression without gravity: from a dilute gas of spheres to jamming, in small strains.

The method is athermal and quasi-static: after each strain, overlaps push the spheres apart until no overlap remains.
The last strain is that at which overlaps remain; it is reversed and repeated in smaller steps. Instead of shrinking
the shape, all radii grow, which is equivalent.
"""

from collections.abc import Callable

import numpy as np

from bondem._types import Floats
from bondem.geometry.elementary_shapes import Shape
from bondem.packing.soft_spheres import SoftSpheres
from bondem.packing.start import thrown
from bondem.packing.targets import Fraction, Target

# Volume fraction of the gas, its largest share of the requested volume fraction, and relative growth of the radii,
# coarse to fine.
_START_FRACTION, _START_SHARE, _STRAINS = 0.3, 0.9, (2e-2, 4e-3, 8e-4)

# Rms force over mean contact force at rest, largest number of steps, and coordination number of a jammed packing: a
# few overlaps among many free spheres have a small rms force too.
_AT_REST, _STEPS, _FIXING = 1e-2, 20_000, 4.0


def compress(
    shape: Shape, relative_radius: Floats, target: Target, random: np.random.Generator, on_step: Callable[[int], None]
) -> SoftSpheres:
    """Compress a gas of spheres of relative radii (n,) until it jams, or to a lower requested volume fraction.

    Raises:
        InputError: The spheres are too large for the shape.
    """
    wanted = target.volume_fraction if isinstance(target, Fraction) else np.inf
    spheres = thrown(shape, relative_radius, min(_START_FRACTION, _START_SHARE * wanted), random)
    spheres.on_step = on_step
    spheres.relax(1.0, tolerance=_AT_REST, steps=_STEPS)
    last = spheres.scale_for(wanted)
    for strain in _STRAINS:
        while spheres.scale * (1.0 + strain) < last:
            before, scale = spheres.sphere.copy(), spheres.scale
            rest = spheres.relax(scale * (1.0 + strain), tolerance=_AT_REST, steps=_STEPS)
            if not rest.loose and rest.coordination_number > _FIXING:
                if strain != _STRAINS[-1]:
                    spheres.sphere[:], spheres.scale = before, scale
                break
    return spheres
