"""Size laws: distributions of the radii of a packing.

The radii are the quantiles of the law at the middles of `count` equal shares, shuffled. These radii follow the law
for any number of spheres, without the scatter of random draws.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np
from scipy.special import ndtr, ndtri

from bondem._checks import array, number
from bondem._types import Floats
from bondem.errors import InputError

__all__ = ["SPREAD", "Lognormal", "Sieve", "SizeLaw", "Uniform"]

#: Default κ of a packing [-], that of André et al. (2012); equal spheres would order at walls.
SPREAD = 0.25


class SizeLaw(ABC):
    """A distribution of radii, weighted by number of spheres, not by mass."""

    @abstractmethod
    def quantile(self, share: Floats) -> Floats:
        """Return the radii below which given shares of the spheres lie, up to a common factor, (n,).

        Args:
            share: shares of the number of spheres, in (0, 1) [-], (n,).
        """

    def radii(self, count: int, random: np.random.Generator) -> Floats:
        """Return `count` radii of this distribution over their mean [-], in random order, (count,)."""
        radius = self.quantile((np.arange(count) + 0.5) / count)
        radius /= radius.mean()
        random.shuffle(radius)
        return radius


@dataclass(frozen=True)
class Uniform(SizeLaw):
    """Radii distributed uniformly in R̄ (1 ± κ/2) (André et al. 2012, eq 10).

    Args:
        spread: κ = (R_max - R_min) / R̄ [-], in [0, 2); other values raise InputError.
    """

    spread: float = SPREAD

    def __post_init__(self) -> None:
        wanted = "the range of radii over their mean, from 0 up to below 2"
        spread = number("", "spread", self.spread, least=-1e-12, below=2.0, advice=wanted)
        object.__setattr__(self, "spread", max(spread, 0.0))

    def quantile(self, share: Floats) -> Floats:
        return 1.0 + self.spread * (share - 0.5)


@dataclass(frozen=True)
class Lognormal(SizeLaw):
    """Radii distributed log-normally.

    Args:
        cv: standard deviation over mean before truncation [-], in (0, 1]; other values raise InputError.
        cut: truncation of both tails, in standard deviations of the logarithm [-], in (0, 4]; other values raise
            InputError. A sphere far larger than the others would make every neighbour list long.
    """

    cv: float
    cut: float = 2.5

    def __post_init__(self) -> None:
        for name, most, what in (
            ("cv", 1.0, "standard deviation over mean of the radii, above 0 up to 1"),
            ("cut", 4.0, "standard deviations, above 0 up to 4"),
        ):
            value = number("", name, getattr(self, name), above=0.0, advice=what)
            if value > most:
                raise InputError(f"{name} = {value}; give {what}")
            object.__setattr__(self, name, value)

    def quantile(self, share: Floats) -> Floats:
        tail = ndtr(-self.cut)
        return np.exp(np.sqrt(np.log1p(self.cv**2)) * ndtri(tail + share * (1.0 - 2.0 * tail)))


@dataclass(frozen=True)
class Sieve(SizeLaw):
    """Radii of a grading curve. Between two sieves mass is distributed uniformly over the logarithm of the diameter.

    Args:
        diameters: sieve openings [m or any other unit, because the packing sets the scale], ascending.
        mass_passing: share of the mass that passes each sieve [-], rising from 0 to 1. Other lists raise InputError.
    """

    diameters: tuple[float, ...]
    mass_passing: tuple[float, ...]

    def __post_init__(self) -> None:
        wanted = "one number for each sieve"
        given = [array("Sieve", name, getattr(self, name), wanted=wanted) for name in ("diameters", "mass_passing")]
        if any(one.ndim != 1 for one in given):
            raise InputError(f"Sieve: diameters= and mass_passing= are lists; give {wanted}")
        diameters, passing = (tuple(one.tolist()) for one in given)
        object.__setattr__(self, "diameters", diameters)
        object.__setattr__(self, "mass_passing", passing)
        if len(diameters) != len(passing) or len(diameters) < 2:
            raise InputError(
                f"{len(diameters)} diameters= and {len(passing)} mass_passing=; give one share for each of at"
                " least two sieves"
            )
        if not (np.isfinite(diameters).all() and diameters[0] > 0.0 and (np.diff(diameters) > 0.0).all()):
            raise InputError(f"diameters = {diameters}; give positive openings, each wider than the one before")
        if passing[0] != 0.0 or passing[-1] != 1.0 or not (np.diff(passing) >= 0.0).all():
            raise InputError(
                f"mass_passing = {passing}; give shares that rise from 0 at the first sieve to 1 at the last"
            )

    def quantile(self, share: Floats) -> Floats:
        edge = np.log(np.asarray(self.diameters))
        mass = np.diff(self.mass_passing)
        # Number within a class: mass over d³; its share below a diameter goes as d1⁻³ - d⁻³.
        cube = np.exp(-3.0 * edge)
        number = mass / np.diff(edge) * (cube[:-1] - cube[1:])
        below = np.concatenate([[0.0], np.cumsum(number)]) / number.sum()
        used = np.flatnonzero(number > 0.0)
        k = used[np.clip(np.searchsorted(below[used + 1], share), 0, len(used) - 1)]
        within = (share - below[k]) / (below[k + 1] - below[k])
        return 0.5 * (cube[k] - within * (cube[k] - cube[k + 1])) ** (-1.0 / 3.0)
