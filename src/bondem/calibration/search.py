"""Search for the parameter value at which a specimen has a given Poisson's ratio."""

import math
from collections.abc import Callable
from dataclasses import dataclass

from bondem.errors import ConvergenceError, UnreachableTargetError


@dataclass(frozen=True)
class Search:
    """Search range of a positive law parameter on which ν depends monotonically.

    Attributes:
        name: name of the parameter.
        low, high: ends of the range [-].
    """

    name: str
    low: float
    high: float

    def solve(
        self, measure: Callable[[float], tuple[float, float]], target: float, *, start: float | None = None,
        tolerance: float, who: str,
    ) -> float:  # fmt: skip
        """Find the parameter value at which ν is within `tolerance` of the target.

        Newton's method is applied to the logarithm of the value. From the second step on the method uses the cubic
        through two values and their slopes, limited to the known bracket. Two or three evaluations usually suffice.

        Args:
            measure: function of the value that returns ν and its derivative.
            target: target value of ν [-].
            start: first value, from curves of similar specimens, limited to the range [-]; None for the geometric
                mean of its ends.
            tolerance: tolerance of ν [-].
            who: name of the bonds in messages.

        Raises:
            UnreachableTargetError: ν does not reach the target between `low` and `high`.
            ConvergenceError: ν is not within the tolerance after more than 30 evaluations.
        """
        points: list[_Point] = []
        ends = math.log(self.low), math.log(self.high)

        def visit(x: float) -> _Point:
            nu, slope = measure(self._value(x))
            points.append(_Point(x, nu - target, slope * self._value(x)))
            return points[-1]

        first = math.sqrt(self.low * self.high) if start is None else start
        here = visit(math.log(min(max(first, self.low), self.high)))
        while abs(here.miss) > tolerance:
            if len(points) > 30:
                raise ConvergenceError(
                    f"{self.name} for nu = {target} did not settle to within {tolerance:g}; raise tolerance="
                )
            low = max((p.x for p in points if p.miss * _rising(points) < 0.0), default=ends[0])
            high = min((p.x for p in points if p.miss * _rising(points) > 0.0), default=ends[1])
            here = visit(self._next(points, low, high, ends))
            if here.x in ends and abs(here.miss) > tolerance and _beyond(here, points, ends):
                visit(ends[0] if here.x == ends[1] else ends[1])
                reach = sorted(target + point.miss for point in points)
                raise UnreachableTargetError(
                    f"nu = {target:g}: outside {reach[0]:.3f} … {reach[-1]:.3f}, the range of {who} on this"
                    f" lattice for {self.name} in [{self.low:g}, {self.high:g}]; choose another law, or a wider"
                    " search="
                )
        return self._value(here.x)

    def _value(self, x: float) -> float:
        # rounding of exp(log) must not pass the ends
        return min(max(math.exp(x), self.low), self.high)

    @staticmethod
    def _next(points: list["_Point"], low: float, high: float, ends: tuple[float, float]) -> float:
        best = sorted(points, key=lambda point: abs(point.miss))[:2]
        guess = best[0].x - best[0].miss / best[0].slope if best[0].slope else math.nan
        if len(best) == 2 and best[0].slope * best[1].slope > 0.0 and best[0].miss != best[1].miss:
            guess = _through(*best)
        seen = {point.x for point in points}
        if not low < guess < high:
            # an end of the range that was not evaluated yet, else the middle
            end = low if guess <= low else high
            return end if end in ends and end not in seen else 0.5 * (low + high)
        return guess


@dataclass(frozen=True)
class _Point:
    """Evaluated point: x is the logarithm of the value, miss the error of ν, slope the derivative of ν in x."""

    x: float
    miss: float
    slope: float


def _rising(points: list[_Point]) -> float:
    """Return +1 if ν increases with the parameter, -1 if it decreases, from the points or else from the slope."""
    left, right = min(points, key=lambda point: point.x), max(points, key=lambda point: point.x)
    return math.copysign(1.0, right.miss - left.miss if right.x > left.x else left.slope)


def _beyond(here: _Point, points: list[_Point], ends: tuple[float, float]) -> bool:
    """Return True if the target lies beyond the end of the range at which the point `here` lies."""
    outward = 1.0 if here.x == ends[1] else -1.0
    return here.miss * _rising(points) * outward < 0.0


def _through(a: _Point, b: _Point) -> float:
    """Return the value at error 0 of the cubic x(error) through two points with their slopes."""
    width = b.miss - a.miss
    t = -a.miss / width
    start, end = width / a.slope, width / b.slope
    return (
        (1.0 + 2.0 * t) * (1.0 - t) ** 2 * a.x
        + t * (1.0 - t) ** 2 * start
        + t * t * (3.0 - 2.0 * t) * b.x
        + t * t * (t - 1.0) * end
    )
