"""Calibration of strengths: what bonds must bear so that specimens have the strengths of a material.

Celigueta et al. (2020) find two parameters by hand until uniaxial compression and the Brazilian test fit; this is
their loop. Why as it is: docs/decisions/0024-strength-calibration.md.
"""

import inspect
import math
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from bondem._checks import count, number, place, shown
from bondem._progress import staged
from bondem._types import Floats
from bondem.calibration.secant import Secant
from bondem.calibration.strength_runs import Runs, StrengthRun, Test, functions_of
from bondem.calibration.strength_search import StrengthSearch
from bondem.calibration.uncertainty import Sample
from bondem.errors import ConvergenceError, InputError

_WHO = "calibrate_strength"


@dataclass(frozen=True, eq=False)
class StrengthCalibration:
    """What a strength calibration found.

    Attributes:
        reached: whether all targets were met within their tolerances.
        message: how it ended, in one line.
        runs: every run, in order; the first one is at the start, with nothing calibrated.
        best: number of the best run, counted from 1.
        names: of the parameters.
        targets: of each test target and tolerance [Pa].
        sensitivities: d ln strength / d ln parameter, by test and parameter [-]; None after a single run,
            as where the start meets all targets.
    """

    reached: bool
    message: str
    runs: tuple[StrengthRun, ...]
    best: int
    names: tuple[str, ...]
    targets: Mapping[str, tuple[float, float]]
    sensitivities: Mapping[str, Mapping[str, float]] | None

    @property
    def nearest(self) -> StrengthRun:
        """The best run, whether or not it met the targets."""
        return self.runs[self.best - 1]

    @property
    def parameters(self) -> dict[str, float]:
        """Found parameters, by name.

        Raises:
            ConvergenceError: the targets were not reached; `.nearest` is the best run.
        """
        if not self.reached:
            raise ConvergenceError(self.message)
        return dict(self.nearest.parameters)

    def sample(self, parameter: str, measured: Mapping[str, Sequence[float]] | None = None) -> Sample:
        """The value of a parameter with which each packing would have met the targets by itself, to first order.

        Args:
            parameter: its name.
            measured: strengths of several packings at the parameters of the best run, by test [Pa]; those of
                that run itself unless given.

        Raises:
            InputError: another parameter, no slopes, other tests, or not as many packings in every test.
        """
        if parameter not in self.names:
            raise InputError(f"parameter = {shown(parameter)}; choose from {', '.join(self.names)}")
        given = self.nearest.measured if measured is None else measured
        if set(given) != set(self.targets) or len({len(values) for values in given.values()}) != 1:
            raise InputError(f"measured = {shown(given)}; give {', '.join(self.targets)} of the same packings")
        logs = np.log(np.array([given[test] for test in self.targets], dtype=float))
        goal = np.log([target for target, _ in self.targets.values()])
        shift = self._inverse()[self.names.index(parameter)] @ (goal[:, None] - logs)
        return Sample(self.nearest.parameters[parameter] * np.exp(shift))

    def interval(
        self,
        parameter: str,
        measured: Mapping[str, Sequence[float]] | None = None,
        *,
        kind: str = "confidence",
        level: float = 0.95,
    ) -> tuple[float, float]:
        """Interval of a parameter from the scatter of packings, of its logarithm; see `sample`, `Sample.interval`.

        Raises:
            InputError: fewer than two packings, or an unknown parameter or kind.
        """
        logs = Sample(np.log(self.sample(parameter, measured).values))
        low, high = logs.interval(kind=kind, level=level)
        return math.exp(low), math.exp(high)

    def tolerated(self, parameter: str) -> tuple[float, float]:
        """Values of a parameter that strengths anywhere within the tolerances of the targets would have led to."""
        if parameter not in self.names:
            raise InputError(f"parameter = {shown(parameter)}; choose from {', '.join(self.names)}")
        room = np.array([tolerance / target for target, tolerance in self.targets.values()])
        half = float(np.abs(self._inverse()[self.names.index(parameter)]) @ room)
        value = self.nearest.parameters[parameter]
        return value * math.exp(-half), value * math.exp(half)

    def _inverse(self) -> Floats:
        if self.sensitivities is None:
            raise InputError("one run tells no slopes; begin farther from the targets, or allow more runs")
        slopes = np.array([list(row.values()) for row in self.sensitivities.values()])
        size = np.array([target / tolerance for target, tolerance in self.targets.values()])
        zero = np.zeros(len(size))
        return Secant(zero[: slopes.shape[1]], zero, slopes, zero, size).inverse()

    def __str__(self) -> str:
        lines = [self.message]
        for test, (target, tolerance) in self.targets.items():
            found, first = self.nearest.mean(test), self.runs[0]
            begun = f", {first.mean(test) / 1e6:.4g} at the start" if test in first.measured else ""
            lines.append(f"  {test}: {found / 1e6:.4g} MPa for {target / 1e6:.4g} ± {tolerance / 1e6:.4g}{begun}")
        for name in self.names:
            value, told = self.nearest.parameters[name], ""
            if self.sensitivities is not None:
                slopes = ", ".join(f"d ln {test} = {row[name]:.2f}" for test, row in self.sensitivities.items())
                low, high = self.tolerated(name)
                told = f", {low:.4g} … {high:.4g} within the tolerances; per d ln {name}: {slopes}"
                if len(next(iter(self.nearest.measured.values()))) > 1:
                    low, high = self.interval(name)
                    told = f", {low:.4g} … {high:.4g} by the scatter of packings (95 %){told}"
            lines.append(f"  {name} = {value:.5g}{told}")
        return "\n".join(lines)


@staged("calibration of strengths", shares=False)
def calibrate_strength(
    tests: Mapping[str, Test],
    targets: Mapping[str, tuple[float, float]],
    start: Mapping[str, float],
    *,
    strengths: Sequence[str] = (),
    bounds: Mapping[str, tuple[float, float]] | None = None,
    most: int = 15,
    out: str | Path | None = None,
    about: str = "",
    progress: Callable[[str], None] | None = None,
    executor: Executor | None = None,
) -> StrengthCalibration:
    """Find parameters of failure with which tests give strengths asked for.

    Secants in logarithms (Broyden): strengths are near powers of the parameters, and products of them are one step.
    One run at the start, one for each slope that is not known beforehand, then steps until all targets are met. Runs
    with `out` are kept there test by test, and a calibration that is called again goes on where it was.

    Args:
        tests: by name, functions of the parameters as keywords that return a strength [Pa], or one of each of
            several packings, whose mean is calibrated; or a list of functions, one for each packing.
        targets: of each test the strength and the tolerance [Pa].
        start: of each parameter a positive value to begin with.
        strengths: names of those parameters that, multiplied by one factor together, multiply all strengths by it. It
            saves a run; where a fracture energy makes it hold roughly only, the steps correct for it.
        bounds: of some parameters the least and the largest value.
        most: runs; each is all tests at one set of parameters.
        out: folder of the runs; None keeps nothing.
        about: what the tests are made of (body, law, version of a rig); runs about something else are refused.
        progress: told of each test before it begins, in a line.
        executor: carries out all tests of a run at once, those of lists one by one: a
            `concurrent.futures.ProcessPoolExecutor`, or `Client.get_executor()` of a Dask cluster. Functions and what
            they hold go to its workers by pickle. None does one test after the other.

    Returns:
        The calibration, reached or not: `.parameters` raises where it was not, and `.message` says by how much.

    Raises:
        InputError: tests, targets and start that do not fit each other, bad numbers, a folder about other tests.
        UnstableRunError: a test failed at the start.
    """
    goals = _checked(tests, targets, start)
    names = tuple(start)
    together = _scaled(names, strengths)
    low, high = _bounds(start, bounds)
    most = count(_WHO, "most", most, least=1)
    if not isinstance(about, str):
        raise InputError(f"{_WHO}: about = {shown(about)}; give a text")
    if progress is not None and not callable(progress):
        raise InputError(f"{_WHO}: progress = {shown(progress)}; give a function, or None")
    if executor is not None and not callable(getattr(executor, "submit", None)):
        raise InputError(f"{_WHO}: executor = {shown(executor)}; give one of concurrent.futures, or None")
    made = Runs(tests, about, None if out is None else place(f"{_WHO}: out", out), progress, executor)
    found = StrengthSearch(made, names, goals, together, low, high, most).from_start(np.array(list(start.values())))
    sensitivities = None
    if found.secant is not None:
        rows = zip(goals, found.secant.slopes.tolist(), strict=True)
        sensitivities = {test: dict(zip(names, row, strict=True)) for test, row in rows}
    return StrengthCalibration(
        reached=found.reached, message=found.message, runs=tuple(found.runs), best=found.best, names=names,
        targets=goals, sensitivities=sensitivities,
    )  # fmt: skip


def _checked(tests: object, targets: object, start: object) -> dict[str, tuple[float, float]]:
    """Targets and tolerances by test, once everything fits each other."""
    for name, given, wanted in (
        ("tests", tests, "functions by name, such as {'ucs': press}"),
        ("targets", targets, "target and tolerance by test, such as {'ucs': (55e6, 2e6)}"),
        ("start", start, "a first value of each parameter, such as {'tension': 4e6}"),
    ):
        if not isinstance(given, Mapping) or not given or not all(isinstance(key, str) for key in given):
            raise InputError(f"{_WHO}: {name} = {shown(given)}; give {wanted}")
    assert isinstance(tests, Mapping)
    assert isinstance(targets, Mapping)
    assert isinstance(start, Mapping)
    if set(tests) != set(targets):
        raise InputError(
            f"{_WHO}: tests {', '.join(tests)} and targets {', '.join(targets)}; give a target for each test"
        )
    if len(start) > len(tests):
        raise InputError(f"{_WHO}: {len(start)} parameters for {len(tests)} tests; fix some, or add tests")
    for name, value in start.items():
        number(_WHO, f"start['{name}']", value, above=0.0)
    goals: dict[str, tuple[float, float]] = {}
    for name, test in tests.items():
        pair = targets[name]
        if not isinstance(pair, tuple | list) or len(pair) != 2:
            raise InputError(f"{_WHO}: targets['{name}'] = {shown(pair)}; give target and tolerance [Pa]")
        target = number(_WHO, f"target of {name}", pair[0], above=0.0, unit="Pa")
        tolerance = number(_WHO, f"tolerance of {name}", pair[1], above=0.0, below=target, unit="Pa")
        goals[name] = target, tolerance
        _takes(name, test, start)
    return goals


def _takes(name: str, test: object, start: Mapping[str, float]) -> None:
    """Make sure that a test takes the parameters as keywords."""
    parts = functions_of(test)
    if not parts or not all(callable(part) for part in parts):
        raise InputError(
            f"{_WHO}: tests['{name}'] = {shown(test)}; give a function of the parameters, or a list of some"
        )
    for part in parts:
        try:
            inspect.signature(part).bind(**start)
        except (TypeError, ValueError):
            raise InputError(
                f"{_WHO}: test '{name}' does not take {', '.join(start)} as keywords; name its arguments as in start"
            ) from None


def _scaled(names: tuple[str, ...], strengths: object) -> Floats:
    """1 for parameters that scale all strengths together, 0 for others, (k,)."""
    given = list(strengths) if isinstance(strengths, Sequence) and not isinstance(strengths, str) else [strengths]
    if not all(isinstance(name, str) and name in names for name in given):
        raise InputError(f"{_WHO}: strengths = {shown(strengths)}; give names out of {', '.join(names)}, as a tuple")
    return np.array([float(name in given) for name in names])


def _bounds(start: Mapping[str, float], bounds: object) -> tuple[Floats, Floats]:
    """Logarithms of the least and largest values, (k,) each."""
    low, high = np.full(len(start), -np.inf), np.full(len(start), np.inf)
    if bounds is None:
        return low, high
    if not isinstance(bounds, Mapping) or not set(bounds) <= set(start):
        raise InputError(f"{_WHO}: bounds = {shown(bounds)}; give two values for some of {', '.join(start)}")
    for k, (name, value) in enumerate(start.items()):
        if name not in bounds:
            continue
        pair = bounds[name]
        if not isinstance(pair, tuple | list) or len(pair) != 2:
            raise InputError(f"{_WHO}: bounds['{name}'] = {shown(pair)}; give the least and the largest value")
        least = number(_WHO, f"least {name}", pair[0], above=0.0)
        largest = number(_WHO, f"largest {name}", pair[1], above=0.0)
        if not least <= value <= largest or least == largest:
            raise InputError(f"{_WHO}: {name} = {value:g} is not in {shown(pair)}; start between its bounds")
        low[k], high[k] = math.log(least), math.log(largest)
    return low, high
