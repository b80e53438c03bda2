"""Which parameter of a bond law sets Poisson's ratio, and the search for its value."""

import math
from collections.abc import Callable
from dataclasses import dataclass

from bondem.errors import ConvergenceError, UnreachableTargetError
from bondem.laws.bond import BondLaw
from bondem.laws.parallel_bond import ParallelBond


@dataclass(frozen=True)
class FreeParameter:
    """A law parameter that ν depends on, monotonically, and where to look for it.

    Attributes:
        name: keyword of the law.
        low, high: ends of the search.
        first: the two values tried first, in ascending order.
    """

    name: str
    low: float
    high: float
    first: tuple[float, float]

    @classmethod
    def of(cls, law: type[BondLaw], search: tuple[float, float] | None) -> "FreeParameter":
        """κ for bonds whose shear stiffness is kn/κ, else r̃: parallel bonds barely change ν with r̃."""
        if issubclass(law, ParallelBond):
            low, high = search or (0.5, 50.0)
            return cls("kappa", low, high, (low * (high / low) ** 0.25, low * (high / low) ** 0.6))
        low, high = search or (0.1, 0.9)
        return cls("radius_ratio", low, high, (low + 0.6 * (high - low), low + 0.85 * (high - low)))

    def solve(
        self, nu_of: Callable[[float], float], target: float, *, tolerance: float, who: str
    ) -> float:
        """The value at which nu_of(value) is within `tolerance` of the target.

        Inverse interpolation through the nearest trials, kept inside a bracket: ν is smooth and monotone in
        the parameter, so five or six evaluations do.

        Raises:
            UnreachableTargetError: ν does not pass the target between `low` and `high`.
            ConvergenceError: ν is too rough for the tolerance.
        """
        trials: dict[float, float] = {}

        def miss(value: float) -> float:
            if value not in trials:
                trials[value] = nu_of(value) - target
            return trials[value]

        bracket = self._bracket(miss, target, trials, who)
        for _ in range(40):
            best = min(trials, key=lambda value: abs(trials[value]))
            if abs(trials[best]) <= tolerance:
                return best
            guess = _inverse_interpolation(trials)
            low, high = sorted(bracket)
            if not low < guess < high:
                guess = 0.5 * (low + high)
            side = 0 if math.copysign(1.0, miss(guess)) == math.copysign(1.0, miss(bracket[0])) else 1
            bracket = (guess, bracket[1]) if side == 0 else (bracket[0], guess)
        raise ConvergenceError(
            f"{self.name} for nu = {target} did not settle to within {tolerance:g}; raise tolerance="
        )

    def _bracket(
        self, miss: Callable[[float], float], target: float, trials: dict[float, float], who: str
    ) -> tuple[float, float]:
        """Two values on either side of the target; the ends of the search are tried only if they must be."""
        inner = self.first
        if miss(inner[0]) * miss(inner[1]) <= 0.0:
            return inner
        falling = trials[inner[1]] < trials[inner[0]]
        upward = falling == (trials[inner[1]] > 0.0)
        near, end = (inner[1], self.high) if upward else (inner[0], self.low)
        if miss(near) * miss(end) <= 0.0:
            return near, end
        for value in (self.low, self.high):
            miss(value)
        reach = sorted(target + error for error in trials.values())
        raise UnreachableTargetError(
            f"nu = {target:g} is outside {reach[0]:.3f} … {reach[-1]:.3f}, which {who} reach on this lattice"
            f" for {self.name} in [{self.low:g}, {self.high:g}]; choose another law, or search= wider"
        )


def _inverse_interpolation(trials: dict[float, float]) -> float:
    """Where the polynomial value(miss) through the (at most four) best trials crosses miss = 0."""
    nearest = sorted(trials.items(), key=lambda item: abs(item[1]))[:4]
    total = 0.0
    for value, error in nearest:
        weight = 1.0
        for other_value, other in nearest:
            if other_value != value:
                if other == error:
                    return math.nan
                weight *= other / (other - error)
        total += weight * value
    return total
