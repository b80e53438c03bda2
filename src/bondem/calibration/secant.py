"""Broyden's secant method in logarithms, towards several targets with few and costly evaluations."""

from dataclasses import dataclass, replace

import numpy as np

from bondem._types import Floats

# Change of log(parameters) whose effect is about the noise of a test, so that smaller ones hardly change slopes.
_NOISE = 0.02
# Singular values of the weighted slopes below this share of the largest are neglected.
_SINGULAR = 1e-3


@dataclass(frozen=True, eq=False)
class Secant:
    """Linear model of y = log(results) about a point x = log(parameters).

    Attributes:
        x, y: best point so far, (k,), and its results, (m,).
        slopes: derivatives d y / d x, (m, k).
        target: target of y, (m,).
        weight: inverse tolerance of y, (m,).
    """

    x: Floats
    y: Floats
    slopes: Floats
    target: Floats
    weight: Floats

    @property
    def miss(self) -> float:
        """Largest distance from a target over its tolerance [-]; at most 1 once all targets are met."""
        return self.miss_of(self.y)

    def miss_of(self, y: Floats) -> float:
        """Largest distance of given results from their targets over the tolerance [-]."""
        return float(np.abs((y - self.target) * self.weight).max())

    def step(self, most: float, low: Floats, high: Floats) -> Floats:
        """Compute the Gauss–Newton step from `x` within bounds, (k,), scaled to components of at most `most`."""
        scaled = self.slopes * self.weight[:, None]
        miss = (self.target - self.y) * self.weight
        found, free = np.zeros(len(self.x)), np.ones(len(self.x), dtype=bool)
        while free.any():
            rest = miss - scaled[:, ~free] @ found[~free]
            found[free] = np.linalg.lstsq(scaled[:, free], rest, rcond=_SINGULAR)[0]
            inside = np.clip(self.x + found, low, high) - self.x
            beyond = free & (np.abs(inside - found) > 1e-12)
            if not beyond.any():
                break
            found[beyond] = inside[beyond]  # fixed at their bounds; the other components compensate
            free &= ~beyond
        longest = float(np.abs(found).max())
        return found if longest <= most else found * (most / longest)

    def foreseen(self, step: Floats) -> float:
        """Value of `miss` predicted after a step [-]."""
        return self.miss_of(self.y + self.slopes @ step)

    def learned(self, x: Floats, y: Floats) -> "Secant":
        """Update the slopes by Broyden's formula for results y at x; return the model about the better point."""
        moved = x - self.x
        surprise = y - self.y - self.slopes @ moved
        slopes = self.slopes + np.outer(surprise, moved) / (moved @ moved + _NOISE**2)
        if self.miss_of(y) < self.miss:
            return replace(self, x=x, y=y, slopes=slopes)
        return replace(self, slopes=slopes)

    def inverse(self) -> Floats:
        """Derivatives d x / d target by the least squares of `step`, (k, m)."""
        scaled = self.slopes * self.weight[:, None]
        return np.linalg.pinv(scaled, rcond=_SINGULAR) * self.weight[None, :]

    @property
    def separates(self) -> bool:
        """True if the results determine all parameters."""
        values = np.linalg.svd(self.slopes * self.weight[:, None], compute_uv=False)
        return bool(values[-1] > _SINGULAR * values[0])
