"""Tests of a strength calibration, each stored on disk as soon as it is finished."""

import json
import math
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor, Future
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from bondem._checks import shown
from bondem.errors import InputError, UnstableRunError
from bondem.io.atomic import make_folder, require_folder, write_text

#: Test: function of the parameters that returns a strength [Pa] or one per packing; or one function per packing.
Test = Callable[..., float | Sequence[float]] | Sequence[Callable[..., float]]
_FILE = "strength_calibration.json"


def is_series(test: object) -> bool:
    """Return True if a test is a list of functions, one per packing."""
    return isinstance(test, Sequence) and not isinstance(test, str)


def functions_of(test: Any) -> list[Callable[..., object]]:
    """Return the functions of a test as a list: one for all packings or one per packing."""
    return list(test) if is_series(test) else [test]


@dataclass(frozen=True)
class StrengthRun:
    """Results of all tests with one set of parameters.

    Attributes:
        parameters: values by name.
        measured: strength of each packing by test [Pa].
        failed: reason for a failed test; empty if all succeeded.
    """

    parameters: Mapping[str, float]
    measured: Mapping[str, tuple[float, ...]]
    failed: str = ""

    def mean(self, test: str) -> float:
        """Return the mean strength of all packings in a test, by its name [Pa]."""
        return float(np.mean(self.measured[test]))


@dataclass(frozen=True)
class Runs:
    """Tests of a strength calibration, with the results that are already known.

    Attributes:
        tests: tests by name.
        about: description of the tests; a file with another description raises InputError.
        folder: folder of the stored results, or None.
        progress: callback, called with one line of text before each test.
        executor: executor for all tests of a run in parallel; None runs them in sequence.
        stored: finished tests: parameters, name of the test, and strengths [Pa] or the reason for failure.
    """

    tests: Mapping[str, Test]
    about: str
    folder: Path | None
    progress: Callable[[str], None] | None
    executor: Executor | None = None
    stored: list[dict[str, Any]] = field(default_factory=list)

    def __post_init__(self) -> None:
        if self.folder is None:
            return
        require_folder(self.folder, "calibrate_strength: out")
        file = self.folder / _FILE
        if not file.exists():
            return
        try:
            found = json.loads(file.read_text(encoding="utf-8"))
            about, rows = found["about"], list(found["tests"])
            for row in rows:
                row["parameters"], row["test"], row["strength"], row["failed"]
        except (ValueError, KeyError, TypeError, OSError) as error:
            raise InputError(f"calibrate_strength: '{file}' is not a file of runs; move or delete it") from error
        if about != self.about:
            raise InputError(
                f"calibrate_strength: out = '{self.folder}': has runs about {shown(about)}, not {shown(self.about)};"
                " choose another folder"
            )
        self.stored.extend(rows)

    def run(self, number: int, parameters: Mapping[str, float]) -> StrengthRun:
        """Run all tests of run `number`, or reuse stored results; without an executor, end after a failed test.

        Raises:
            InputError: a test returned something other than positive numbers.
        """
        names, rows = list(self.tests), dict[str, dict[str, Any]]()
        for together in [names] if self.executor is not None else [[name] for name in names]:
            missing = [name for name in together if self._found(name, parameters) is None]
            started = {name: self._begin(number, name, parameters) for name in missing}
            for name in together:
                rows[name] = self._found(name, parameters) or self._keep(name, parameters, started[name])
            if any(row["failed"] for row in rows.values()):
                break
        measured: dict[str, tuple[float, ...]] = {}
        for name, row in rows.items():
            if row["failed"]:
                return StrengthRun(parameters, measured, f"{name}: {row['failed']}")
            measured[name] = tuple(row["strength"])
        return StrengthRun(parameters, measured)

    def _found(self, name: str, parameters: Mapping[str, float]) -> dict[str, Any] | None:
        same = (row for row in self.stored if row["test"] == name and row["parameters"] == dict(parameters))
        return next(same, None)

    def _begin(self, number: int, name: str, parameters: Mapping[str, float]) -> list[Callable[[], object]]:
        """Return functions that yield the strengths of a test; only an executor starts the test here, in parallel."""
        if self.progress is not None:
            values = ", ".join(f"{key} = {value:.5g}" for key, value in parameters.items())
            self.progress(f"run {number}, {name}: {values}")
        parts = functions_of(self.tests[name])
        if self.executor is None:
            return [partial(part, **parameters) for part in parts]
        under_way: list[Future[object]] = [self.executor.submit(part, **parameters) for part in parts]
        return [one.result for one in under_way]

    def _keep(self, name: str, parameters: Mapping[str, float], parts: list[Callable[[], object]]) -> dict[str, Any]:
        """Finish a test and store its strengths, or the reason for its failure; return the stored row."""
        strength, failed = list[float](), ""
        try:
            found = [part() for part in parts]
            strength = _strengths(name, found if is_series(self.tests[name]) else found[0])
        except UnstableRunError as error:
            failed = " ".join(str(error).split())
        row = {"parameters": dict(parameters), "test": name, "strength": strength, "failed": failed}
        self.stored.append(row)
        self._save()
        return row

    def _save(self) -> None:
        if self.folder is None:
            return
        make_folder(self.folder)
        text = json.dumps({"about": self.about, "tests": self.stored}, indent=1, allow_nan=False, ensure_ascii=False)
        write_text(self.folder / _FILE, text + "\n")


def _strengths(name: str, found: object) -> list[float]:
    try:
        values = np.atleast_1d(np.asarray(found, dtype=float))
    except (TypeError, ValueError):
        values = np.zeros(0)
    if values.ndim != 1 or not values.size or not all(0.0 < value < math.inf for value in values):
        raise InputError(
            f"calibrate_strength: test '{name}' returned {shown(found)}; return a positive strength in Pa, or one"
            " for each packing"
        )
    return values.tolist()
