"""Packings: spheres that fill a shape, dense, random and isotropic."""

from collections.abc import Callable

import numpy as np

from bondem.errors import InputError
from bondem.packing.quench import quench
from bondem.packing.start import uniform_radii
from bondem.specimen.geometry import Shape
from bondem.specimen.particles import Particles

__all__ = ["pack"]


def pack(
    shape: Shape,
    *,
    count: int,
    spread: float = 0.0,
    seed: int = 0,
    coordination_number: float = 6.2,
    progress: Callable[[float], None] | None = None,
) -> Particles:
    """Fill a shape with spheres, dense, random and isotropic.

    Random spheres are quenched between rigid walls and compressed slightly beyond jamming, until every sphere
    touches `coordination_number` others on average (as `bd.connect` counts them with tolerance 0, over all
    spheres, those at walls and rattlers included). What z costs beyond jamming is overlap: at 6.2 on average 0.2 %
    of the mean radius in a periodic cell and, as spheres at walls have fewer neighbours, 0.8 % between the walls of
    a cylinder of 10 000, with 5 % for the worst pair; `bd.fabric(lattice).largest_overlap` reports it.
    Spheres lie inside the walls to rounding. The radii follow from count, shape and target. Same arguments,
    same bits, whatever the number of threads.

    Args:
        shape: Cylinder, Box, Ball or the periodic Cell.
        count: number of spheres.
        spread: κ = (R_max - R_min) / R̄ [-], radii uniform in R̄ (1 ± κ/2) (André et al. 2012, eq 10).
        seed: which of the random packings.
        coordination_number: z = 2 contacts / spheres to reach [-], ± 0.01.
        progress: called now and then with the done share, from 0 to 1, never less than before.

    Returns:
        Exactly `count` spheres, with their `shape`.

    Raises:
        InputError: an argument out of range.
        PackingError: the target was not reached.
    """
    if isinstance(count, bool) or not isinstance(count, int | np.integer) or count < 1:
        raise InputError(f"count = {count!r}; give a whole number of spheres, at least 1")
    if not 0.0 <= spread < 2.0:
        raise InputError(f"spread = {spread}; give the range of radii over their mean, from 0 up to below 2")
    if not 0.0 < coordination_number < count:
        raise InputError(
            f"{count} spheres cannot touch {coordination_number} others each; give a positive coordination_number="
            " and more spheres"
        )
    if seed < 0:
        raise InputError(f"seed = {seed}; give a whole number from 0 up")
    random = np.random.Generator(np.random.Philox(seed))
    centre, radius = quench(
        shape, uniform_radii(count, spread, random), coordination_number, random, progress or (lambda share: None)
    )
    return Particles(centre, radius, shape=shape)
