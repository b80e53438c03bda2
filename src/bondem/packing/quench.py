"""The default recipe: quench random soft spheres, then find the scale of radii with the wanted contacts.

Spheres thrown into the shape at random, at a density far above jamming, are brought to rest. Then all radii
are scaled by a common factor, the spheres brought to rest again, and so on until the coordination number is
on target. Above jamming the mean overlap grows in proportion to ln(scale), and so does (z - z_J)², z_J being
the coordination number at jamming (O'Hern et al., Phys. Rev. E 68, 2003): a few scales suffice.
"""

import math
from collections.abc import Callable

import numpy as np

from bondem._types import Floats
from bondem.errors import InputError, PackingError
from bondem.packing.relaxation import Rest, SoftSpheres
from bondem.packing.start import morton_order, random_centres
from bondem.specimen.geometry import Shape

# Volume fraction at which the random spheres are let loose, far above jamming: they come to rest fast, and
# the way back down leaves a denser and more even packing than a quench near jamming.
_START_FRACTION = 0.75

# Rms force over mean contact force at rest: to get near the target, and in the packing that is returned.
_ROUGH, _FINE = 3e-2, 5e-3

# Miss of the coordination number: near enough to relax finely, and in the packing that is returned (where one
# contact more or less is not a larger step).
_NEAR, _ACCEPTED = 0.25, 0.01

# First guesses: z at jamming, rattlers included, and d(mean overlap / R̄)/d ln(scale).
_Z_JAMMED, _GROWTH = 5.4, 1.5

# Radii grow by this much where the spheres turned out loose.
_TIGHTEN = 0.005

# Steps to come to rest, and in all; a usual packing takes about 2500 in all.
_STEPS, _ALL_STEPS = 10_000, 50_000

# Two spheres may overlap by this share of the smallest radius; `Particles` refuses more than half.
_LARGEST_OVERLAP = 0.45


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
        InputError: spheres too large for the shape.
        PackingError: the target was not reached.
    """
    n = len(relative_radius)
    solid = 4.0 / 3.0 * math.pi * float((relative_radius**3).sum())
    radius = relative_radius * (_START_FRACTION * shape.volume / solid) ** (1.0 / 3.0)
    if shape.period is not None and shape.period.min() < 5.2 * radius.max():
        raise InputError(
            f"{n} spheres are too large for the periodic {shape}; ask for more, or make its edges more alike"
        )
    centre = random_centres(shape, radius, random)
    order = morton_order(centre, *shape.bounds)
    spheres = SoftSpheres(shape, centre[order], radius[order])

    search = _ScaleSearch(coordination_number)
    tolerance, steps = _ROUGH, 0
    while True:
        done = steps
        rest = spheres.relax(
            search.scale,
            tolerance=tolerance,
            steps=_STEPS,
            progress=lambda taken, done=done: progress(1.0 - math.exp(-(done + taken) / 1000.0)),
        )
        steps += rest.steps
        miss = abs(rest.coordination_number - coordination_number)
        if rest.settled and tolerance == _FINE and miss <= max(_ACCEPTED, 2.0 / n):
            break
        if steps > _ALL_STEPS:
            raise PackingError(
                f"{n} spheres in {shape} came to a coordination number of {rest.coordination_number:.2f} instead of"
                f" {coordination_number:.2f}; ask for another seed=, more spheres or another coordination_number="
            )
        if rest.settled and tolerance == _ROUGH and miss < _NEAR:
            tolerance = _FINE
            search.forget()
        else:
            search.learn(rest)
    if rest.largest_overlap * spheres.mean_radius > _LARGEST_OVERLAP * spheres.sphere[:, 3].min():
        raise PackingError(
            f"{n} spheres in {shape} reach a coordination number of {coordination_number:.2f} only with overlaps of"
            f" {rest.largest_overlap:.2f} mean radii; ask for more spheres or a smaller coordination_number="
        )
    progress(1.0)
    return spheres.sphere[:, :3].copy(), spheres.sphere[:, 3].copy()


class _ScaleSearch:
    """Finds the scale of the radii at which the coordination number is on target."""

    def __init__(self, coordination_number: float) -> None:
        self._wanted = _excess(coordination_number)
        self._size = 0.0  # ln(scale)
        self.forget()

    @property
    def scale(self) -> float:
        """Factor on the first radii to try next [-]."""
        return math.exp(self._size)

    def forget(self) -> None:
        """Drop what is known: spheres brought to rest more finely have other contacts."""
        self._below: tuple[float, float] | None = None
        self._above: tuple[float, float] | None = None

    def learn(self, rest: Rest) -> None:
        """Take in what the present scale led to, and choose the next."""
        excess = _excess(rest.coordination_number) if rest.settled else 0.0
        if excess > self._wanted:
            self._above = (self._size, excess)
        else:
            self._below = (self._size, excess)
        if self._below is not None and self._above is not None:
            (s0, e0), (s1, e1) = self._below, self._above
            self._size = s0 + min(max((self._wanted - e0) / (e1 - e0), 0.1), 0.9) * (s1 - s0)
            if s1 - s0 < 1e-4:  # the packing rearranged on the way: the bracket is of another one
                self.forget()
        elif excess <= 0.0:
            self._size += _TIGHTEN
        else:
            self._size += rest.mean_overlap * (self._wanted / excess - 1.0) / _GROWTH


def _excess(coordination_number: float) -> float:
    above = coordination_number - _Z_JAMMED
    return math.copysign(above * above, above)
