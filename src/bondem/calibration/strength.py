"""Calibration of strengths: failure parameters for given strengths of specimens.

Celigueta et al. (2020) adjust two parameters by hand until uniaxial compression and the Brazilian test fit. This
module automates this adjustment; docs/decisions/0024-strength-calibration.md has the reasons.
"""

import inspect
import math
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from bondem._checks import count, instance, number, place, shown
from bondem._progress import staged
from bondem._types import Floats
from bondem.calibration.secant import Secant
from bondem.calibration.strength_runs import Runs, StrengthRun, Test, functions_of
from bondem.calibration.strength_search import StrengthSearch
from bondem.calibration.uncertainty import Kind, Sample
from bondem.errors import ConvergenceError, InputError

_WHO = "calibrate_strength"


@dataclass(frozen=True, eq=False)
class StrengthCalibration:
    """Result of a strength calibration.

    Attributes:
        reached: True if all targets were met within their tolerances.
        message: outcome, strengths of the best run and, if a target was missed, the reason, in one line.
        runs: all runs, in order; the first one uses the start values.
        best: number of the best run, counted from 1.
        names: names of the parameters.
        targets: target and tolerance of each test [Pa].
        sensitivities: derivatives d ln strength / d ln parameter, by test and parameter [-]; None if unknown, as when
            the start meets all targets.
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
        """Best run, also if it missed the targets."""
        return self.runs[self.best - 1]

    @property
    def parameters(self) -> dict[str, float]:
        """Calibrated parameters by name.

        Raises:
            ConvergenceError: the targets were not reached; `.nearest` is the best run.
        """
        if not self.reached:
            raise ConvergenceError(self.message)
        return dict(self.nearest.parameters)

    def sample(self, parameter: str, measured: Mapping[str, Sequence[float]] | None = None) -> Sample:
        """Compute the values of a parameter with which each packing alone would have met the targets, to first order.

        Args:
            parameter: name of the parameter.
            measured: strengths of several packings at the parameters of the best run, by test [Pa]; None for those of
                the best run.

        Raises:
            InputError: unknown parameter or sensitivities, other tests, or unequal numbers of packings in the tests.
        """
        inverse = self._inverse(parameter)
        given = self.nearest.measured if measured is None else measured
        if set(given) != set(self.targets) or len({len(values) for values in given.values()}) != 1:
            raise InputError(
                f"measured = {shown(given)}: other tests or packings; give {', '.join(self.targets)} of the same"
                " packings"
            )
        logs = np.log(np.array([given[test] for test in self.targets], dtype=float))
        goal = np.log([target for target, _ in self.targets.values()])
        shift = inverse @ (goal[:, None] - logs)
        return Sample(self.nearest.parameters[parameter] * np.exp(shift))

    def interval(
        self, parameter: str, measured: Mapping[str, Sequence[float]] | None = None, *, kind: Kind = "confidence",
        level: float = 0.95,
    ) -> tuple[float, float]:  # fmt: skip
        """Compute an interval of a parameter from the scatter of packings.

        The logarithms of the values of `sample` are taken as normally distributed; see `Sample.interval`.

        Args:
            parameter: name of the parameter.
            measured: strengths of several packings, as for `sample`.
            kind: kind of interval, "confidence" or "prediction".
            level: probability that the interval contains the value [-].

        Raises:
            InputError: fewer than two packings, unknown sensitivities, or an unknown parameter or kind.
        """
        logs = Sample(np.log(self.sample(parameter, measured).values))
        low, high = logs.interval(kind=kind, level=level)
        return math.exp(low), math.exp(high)

    def strengths(self, test: str) -> Sample:
        """Return the strengths of the packings in the best run [Pa]; `Sample.interval` predicts that of a new one.

        Raises:
            InputError: an unknown test.
        """
        if test not in self.targets:
            raise InputError(f"test = {shown(test)}: unknown test; choose from {', '.join(self.targets)}")
        return Sample(np.array(self.nearest.measured[test]))

    def tolerated(self, parameter: str) -> tuple[float, float]:
        """Return the range of a parameter for strengths within the tolerances of all targets, to first order.

        Raises:
            InputError: an unknown parameter, or unknown sensitivities.
        """
        room = np.array([tolerance / target for target, tolerance in self.targets.values()])
        half = float(np.abs(self._inverse(parameter)) @ room)
        value = self.nearest.parameters[parameter]
        return value * math.exp(-half), value * math.exp(half)

    def _inverse(self, parameter: str) -> Floats:
        """Return the derivatives d ln parameter / d ln target [-], one per test, (m,)."""
        if parameter not in self.names:
            raise InputError(
                f"parameter = {shown(parameter)}: unknown parameter; choose from {', '.join(self.names)}"
            )
        if self.sensitivities is None:
            raise InputError("these runs have no slopes; start farther from the targets, or allow more runs")
        slopes = np.array([list(row.values()) for row in self.sensitivities.values()])
        size = np.array([target / tolerance for target, tolerance in self.targets.values()])
        zero = np.zeros(len(size))
        secant = Secant(zero[: slopes.shape[1]], zero, slopes, zero, size)
        return secant.inverse()[self.names.index(parameter)]

    def __str__(self) -> str:
        lines = [self.message]
        for test, (target, tolerance) in self.targets.items():
            found, first = self.nearest.mean(test), self.runs[0]
            initial = f", {first.mean(test) / 1e6:.4g} at the start" if test in first.measured else ""
            lines.append(f"  {test}: {found / 1e6:.4g} MPa for {target / 1e6:.4g} ± {tolerance / 1e6:.4g}{initial}")
        for name in self.names:
            value, limits = self.nearest.parameters[name], ""
            if self.sensitivities is not None:
                slopes = ", ".join(f"d ln {test} = {row[name]:.2f}" for test, row in self.sensitivities.items())
                low, high = self.tolerated(name)
                limits = f", {low:.4g} … {high:.4g} within the tolerances; per d ln {name}: {slopes}"
                if len(next(iter(self.nearest.measured.values()))) > 1:
                    low, high = self.interval(name)
                    limits = f", {low:.4g} … {high:.4g} by the scatter of packings (95 %){limits}"
            lines.append(f"  {name} = {value:.5g}{limits}")
        return "\n".join(lines)


@staged("calibration of strengths", shares=False)
def calibrate_strength(
    tests: Mapping[str, Test], targets: Mapping[str, tuple[float, float]], start: Mapping[str, float], *,
    strengths: Sequence[str] = (), bounds: Mapping[str, tuple[float, float]] | None = None, most: int = 15,
    out: str | Path | None = None, about: str = "", progress: Callable[[str], None] | None = None,
    executor: Executor | None = None,
) -> StrengthCalibration:  # fmt: skip
    """Calibrate failure parameters so that tests give target strengths.

    The method is Broyden's secant method in logarithms, in which products of powers of the parameters are linear. The
    search makes a run at the start and one for each parameter whose slopes are unknown. Steps follow until all
    targets are met or no step helps. With `out`, each finished test is stored; a repeated call continues from the
    stored tests.

    Args:
        tests: functions by name, which take the parameters as keywords and return a strength [Pa], or one strength
            per packing, whose mean is calibrated; or lists of functions, one per packing.
        targets: target strength and tolerance of each test [Pa].
        start: positive start value of each parameter.
        strengths: names of the parameters that scale all strengths by a common factor if multiplied by that factor
            together. Naming them saves a run. If a fracture energy makes the scaling approximate, steps correct it.
        bounds: lowest and highest value of some parameters.
        most: largest number of runs; a run is all tests at one set of parameters.
        out: folder of the runs; None stores nothing.
        about: description of the tests (body, law, version of a rig); stored runs must have the same description.
        progress: callback, called with one line of text before each test.
        executor: executor for all tests of a run in parallel, with a task per function of a list: a
            `concurrent.futures.ProcessPoolExecutor`, or `Client.get_executor()` of a Dask cluster. Functions are sent
            to its workers by pickle. None runs the tests in sequence.

    Returns:
        The calibration, reached or not: if not, `.parameters` raises an error and `.message` states the miss.

    Raises:
        InputError: inconsistent tests, targets and start, numbers out of range, or a folder of other tests.
        UnstableRunError: a test failed at the start.
    """
    goals = _checked(tests, targets, start)
    names = tuple(start)
    together = _scaled(names, strengths)
    low, high = _bounds(start, bounds)
    most = count(_WHO, "most", most, least=1)
    instance(_WHO, "about", about, str, "a text")
    if progress is not None and not callable(progress):
        raise InputError(f"{_WHO}: progress = {shown(progress)}: not callable; give a function, or None")
    if executor is not None and not callable(getattr(executor, "submit", None)):
        raise InputError(
            f"{_WHO}: executor = {shown(executor)}: not an executor; give one of concurrent.futures, or None"
        )
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
    """Check that tests, targets and start are consistent; return target and tolerance by test [Pa]."""
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
            f"{_WHO}: tests {', '.join(tests)} do not match targets {', '.join(targets)}; give a target for each test"
        )
    if len(start) > len(tests):
        raise InputError(f"{_WHO}: start has {len(start)} parameters for {len(tests)} tests; fix some, or add tests")
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
        _check_keywords(name, test, start)
    return goals


def _check_keywords(name: str, test: object, start: Mapping[str, float]) -> None:
    """Check that a test takes the parameters as keywords."""
    parts = functions_of(test)
    if not parts or not all(callable(part) for part in parts):
        raise InputError(
            f"{_WHO}: tests['{name}'] = {shown(test)}; give a function of the parameters, or a list of functions"
        )
    for part in parts:
        try:
            inspect.signature(part).bind(**start)
        except (TypeError, ValueError):
            raise InputError(
                f"{_WHO}: test '{name}' does not take {', '.join(start)} as keywords; name its arguments as in start"
            ) from None


def _scaled(names: tuple[str, ...], strengths: object) -> Floats:
    """Check `strengths`; return the mask of the parameters that scale all strengths together, 1 or 0, (k,)."""
    given = list(strengths) if isinstance(strengths, Sequence) and not isinstance(strengths, str) else [strengths]
    if not all(isinstance(name, str) and name in names for name in given):
        raise InputError(f"{_WHO}: strengths = {shown(strengths)}; give names out of {', '.join(names)}, as a tuple")
    return np.array([float(name in given) for name in names])


def _bounds(start: Mapping[str, float], bounds: object) -> tuple[Floats, Floats]:
    """Check `bounds`; return logarithms of the lowest and highest value of each parameter, (k,) each."""
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
