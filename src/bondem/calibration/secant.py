"""Steps towards several targets at once, in logarithms, from few and costly evaluations: Broyden's secant method."""

from dataclasses import dataclass, replace

import numpy as np

from bondem._types import Floats

# Changes of parameters that are of the size of the noise of a test do not tell slopes, in logarithms.
_NOISE = 0.02
# Singular values of the weighted slopes below this share of the largest say nothing.
_SINGULAR = 1e-3


@dataclass(frozen=True, eq=False)
class Secant:
    """What is known of y = log(results) about a point x = log(parameters).

    Attributes:
        x, y: the best point so far, (k,), and its results, (m,).
        slopes: d y / d x, (m, k).
        target: of y, (m,).
        weight: one over the tolerance of y, (m,).
    """

    x: Floats
    y: Floats
    slopes: Floats
    target: Floats
    weight: Floats

    @property
    def miss(self) -> float:
        """Largest distance from a target over its tolerance [-]; at most 1 where all are met."""
        return self.miss_of(self.y)

    def miss_of(self, y: Floats) -> float:
        """The same of other results."""
        return float(np.abs((y - self.target) * self.weight).max())

    def step(self, most: float, low: Floats, high: Floats) -> Floats:
        """Gauss and Newton's step from the best point within bounds, none of its components longer than `most`."""
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
            found[beyond] = inside[beyond]  # held at their bounds, while the others make up for them
            free &= ~beyond
        longest = float(np.abs(found).max())
        return found if longest <= most else found * (most / longest)

    def foreseen(self, step: Floats) -> float:
        """What `miss` is expected to be after a step [-]."""
        return self.miss_of(self.y + self.slopes @ step)

    def learned(self, x: Floats, y: Floats) -> "Secant":
        """After another evaluation: Broyden's slopes, about the better of both points."""
        moved = x - self.x
        surprise = y - self.y - self.slopes @ moved
        slopes = self.slopes + np.outer(surprise, moved) / (moved @ moved + _NOISE**2)
        if self.miss_of(y) < self.miss:
            return replace(self, x=x, y=y, slopes=slopes)
        return replace(self, slopes=slopes)

    def inverse(self) -> Floats:
        """d x / d target, by the same least squares as `step`, (k, m)."""
        scaled = self.slopes * self.weight[:, None]
        return np.linalg.pinv(scaled, rcond=_SINGULAR) * self.weight[None, :]

    @property
    def separates(self) -> bool:
        """Whether the results tell all parameters apart."""
        values = np.linalg.svd(self.slopes * self.weight[:, None], compute_uv=False)
        return bool(values[-1] > _SINGULAR * values[0])
