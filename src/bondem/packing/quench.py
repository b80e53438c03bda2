"""The default method: random soft spheres, far denser than they can be, pushed apart by their overlaps."""

from collections.abc import Callable

import numpy as np

from bondem._types import Floats
from bondem.packing.relaxation import SoftSpheres
from bondem.packing.start import thrown
from bondem.packing.targets import Target
from bondem.specimen.geometry import Shape

# Volume fraction at which the random spheres are let loose, far above jamming: they come to rest fast, and
# the way back down leaves a denser and more even packing than a quench near jamming.
_START_FRACTION = 0.75

_ROUGH, _STEPS = 3e-2, 10_000


def quench(
    shape: Shape,
    relative_radius: Floats,
    target: Target,
    random: np.random.Generator,
    on_step: Callable[[int], None],
) -> SoftSpheres:
    """Spheres at rest at a volume fraction of 0.75, for any target: what comes next is decompression."""
    spheres = thrown(shape, relative_radius, _START_FRACTION, random)
    spheres.on_step = on_step
    spheres.relax(1.0, tolerance=_ROUGH, steps=_STEPS)
    return spheres
