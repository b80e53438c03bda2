"""Loop of a strength calibration: a run at the start, runs for slopes, and runs along secants."""

import math
from dataclasses import dataclass, field

import numpy as np

from bondem._types import Floats
from bondem.calibration.secant import Secant
from bondem.calibration.strength_runs import Runs, StrengthRun
from bondem.errors import UnstableRunError

# Change of a parameter for the first slopes, and its largest change in a step, both as logarithms of factors.
_PROBE, _FARTHEST = math.log(1.25), math.log(2.0)
# Least step in logarithms, and largest predicted miss over the present one: other steps end the search without a
# run.
_SHORT, _HOPE = 1e-4, 0.95
# Most halvings of a step after runs that failed or were no better; then the search ends.
_HALVINGS = 4


@dataclass
class StrengthSearch:
    """State of the calibration loop.

    Attributes:
        made: tests that each run makes, with their stored results.
        names: names of the parameters.
        goals: target and tolerance by test [Pa].
        together: mask of the parameters that scale all strengths together, 1 or 0, (k,).
        low, high: logarithms of the bounds, (k,).
        most: largest number of runs.
        runs: finished runs, in order.
        points: logarithms of parameters and of mean strengths of successful runs, by index into `runs`.
        secant: linear model of the strengths, once slopes are known.
        reason: reason for the end.
    """

    made: Runs
    names: tuple[str, ...]
    goals: dict[str, tuple[float, float]]
    together: Floats
    low: Floats
    high: Floats
    most: int
    runs: list[StrengthRun] = field(default_factory=list)
    points: dict[int, tuple[Floats, Floats]] = field(default_factory=dict)
    secant: Secant | None = None
    reason: str = ""

    def from_start(self, values: Floats) -> "StrengthSearch":
        """Search from start values (k,) until all targets are met, no run is left, or no step improves the result.

        Raises:
            UnstableRunError: a test failed at the start.
        """
        x = np.log(values)
        y = self._visit(x, values)
        if y is None:
            raise UnstableRunError(f"calibrate_strength: at the start, {self.runs[0].failed}")
        if not self.reached:
            self._probe(x, y)
        shorter = 0
        while self.secant is not None and not self.reached and not self.reason:
            shorter = self._step(self.secant, shorter)
        return self

    @property
    def best(self) -> int:
        """Number of the run nearest to the targets, counted from 1."""
        return 1 + min(self.points, key=lambda k: self._miss(self.points[k][1]))

    @property
    def reached(self) -> bool:
        """True if the best run meets all targets."""
        return self._miss(self.points[self.best - 1][1]) <= 1.0

    @property
    def message(self) -> str:
        """Success or failure, strengths of the best run, and reason for the end, in one line."""
        best = self.runs[self.best - 1]
        found = ", ".join(
            f"{test} {best.mean(test) / 1e6:.4g} MPa for {target / 1e6:.4g} ± {tolerance / 1e6:.4g}"
            for test, (target, tolerance) in self.goals.items()
        )
        runs = f"{len(self.runs)} run{'s' if len(self.runs) > 1 else ''}"
        if self.reached:
            return f"reached after {runs}: {found}"
        reason = self.reason or "all runs are used up"
        return f"not reached after {runs}: {found} in the best, run {self.best}; {reason}"

    @property
    def _target(self) -> Floats:
        return np.log([target for target, _ in self.goals.values()])

    @property
    def _weight(self) -> Floats:
        return np.array([target / tolerance for target, tolerance in self.goals.values()])

    def _miss(self, y: Floats) -> float:
        """Largest distance of the strengths, not of their logarithms, from their targets over the tolerance."""
        target, tolerance = np.array(list(self.goals.values())).T
        return float((np.abs(np.exp(y) - target) / tolerance).max())

    def _visit(self, x: Floats, values: Floats | None = None) -> Floats | None:
        """Run the tests at a point; return the logarithms of the mean strengths, (m,), or None if a test failed."""
        given = np.exp(x) if values is None else values
        parameters = dict(zip(self.names, map(float, given), strict=True))
        done = self.made.run(len(self.runs) + 1, parameters)
        self.runs.append(done)
        if done.failed:
            return None
        y = np.log([done.mean(test) for test in self.goals])
        self.points[len(self.runs) - 1] = x, y
        return y

    def _probe(self, x: Floats, y: Floats) -> None:
        """Determine the first slopes from runs with one changed parameter each.

        Parameters in `together` multiply all strengths by a common factor, so that one of them needs no run. The runs
        are made where this factor brings the strengths closest to their targets.
        """
        slopes = np.zeros((len(y), len(x)))
        scaled = np.flatnonzero(self.together)
        shift = 0.0
        if len(scaled):
            weight = self._weight**2
            shift = float(np.clip(weight @ (self._target - y) / weight.sum(), -_FARTHEST, _FARTHEST))
        for k in range(len(x)):
            if len(scaled) and k == scaled[-1]:
                continue
            for change in (_PROBE, -_PROBE):
                if len(self.runs) >= self.most:
                    return
                moved = np.clip(x + shift * self.together, self.low, self.high)
                moved[k] = np.clip(moved[k] + change, self.low[k], self.high[k])
                alone = moved[k] - x[k] - shift * self.together[k]
                found = self._visit(moved) if abs(alone) > 0.5 * _PROBE else None
                if found is not None:
                    slopes[:, k] = (found - y - shift * bool(len(scaled))) / alone
                    break
            else:
                self.reason = f"the slope of {self.names[k]} is unknown, as tests with changed values failed"
                return
            if self.reached:
                break
        if len(scaled):
            slopes[:, scaled[-1]] = 1.0 - slopes[:, scaled[:-1]].sum(axis=1)
        near = self.points[self.best - 1]
        self.secant = Secant(*near, slopes, self._target, self._weight)

    def _step(self, secant: Secant, shorter: int) -> int:
        """Make a run at a step halved `shorter` times, or set `reason` to end; return the halvings of the next."""
        if len(self.runs) >= self.most:
            self.reason = "all runs are used up"
            return shorter
        step = secant.step(_FARTHEST, self.low, self.high)
        hopeless = secant.foreseen(step) > _HOPE * secant.miss
        step = step * 0.5**shorter
        if hopeless or float(np.abs(step).max()) < _SHORT or shorter > _HALVINGS:
            self.reason = self._obstacle(secant, shorter)
            return shorter
        x = secant.x + step
        y = self._visit(x)
        if y is None:
            return shorter + 1
        better = secant.miss_of(y) < secant.miss
        self.secant = secant.learned(x, y)
        return 0 if better else shorter + 1

    def _obstacle(self, secant: Secant, shorter: int) -> str:
        """Reason why no step improves the result."""
        if shorter > _HALVINGS:
            return "strengths scatter more than their tolerances, or tests fail nearby"
        at = [
            name for name, value, low, high in zip(self.names, secant.x, self.low, self.high, strict=True)
            if min(abs(value - low), abs(value - high)) < _SHORT
        ]  # fmt: skip
        if at:
            return f"{', '.join(at)} at a bound"
        if not secant.separates:
            return "the tests do not determine all parameters"
        return "no change of the parameters leads nearer to all targets"
