"""Tests of a strength calibration, each kept on disk as soon as it is done."""

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
from bondem.io.atomic import require_folder, write_text

#: A test: parameters by name → strength [Pa], or one of each of several packings; or a function for each packing.
Test = Callable[..., float | Sequence[float]] | Sequence[Callable[..., float]]
_FILE = "strength_calibration.json"


def is_series(test: object) -> bool:
    """Whether a test is a function for each packing."""
    return isinstance(test, Sequence) and not isinstance(test, str)


def functions_of(test: Any) -> list[Callable[..., object]]:
    """The functions of a test, one for all packings or one for each."""
    return list(test) if is_series(test) else [test]


@dataclass(frozen=True)
class StrengthRun:
    """All tests with one set of parameters.

    Attributes:
        parameters: by name.
        measured: of each test the strength [Pa] of each packing.
        failed: why a test gave none; empty where all did.
    """

    parameters: Mapping[str, float]
    measured: Mapping[str, tuple[float, ...]]
    failed: str = ""

    def mean(self, test: str) -> float:
        """Mean strength of all packings [Pa]."""
        return float(np.mean(self.measured[test]))


@dataclass(frozen=True)
class Runs:
    """Makes runs, or takes them from the file where they are.

    Attributes:
        tests: by name.
        about: what the tests are made of; runs of a file with another one are refused.
        folder: of the file, or None.
        progress: told what is about to be tested.
        executor: carries out all tests of a run at once; None does one after the other.
        kept: all single tests that are known: parameters, test, and strengths or why there are none.
    """

    tests: Mapping[str, Test]
    about: str
    folder: Path | None
    progress: Callable[[str], None] | None
    executor: Executor | None = None
    kept: list[dict[str, Any]] = field(default_factory=list)

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
            raise InputError(f"calibrate_strength: '{file}' holds no runs; move it away") from error
        if about != self.about:
            raise InputError(
                f"calibrate_strength: '{self.folder}' holds runs about {shown(about)}, not {shown(self.about)};"
                " choose another folder"
            )
        self.kept.extend(rows)

    def run(self, number: int, parameters: Mapping[str, float]) -> StrengthRun:
        """All tests at some parameters; none that is kept is repeated.

        Raises:
            InputError: a test gave something else than positive numbers.
        """
        names, rows = list(self.tests), dict[str, dict[str, Any]]()
        for together in [names] if self.executor is not None else [[name] for name in names]:
            missing = [name for name in together if self._found(name, parameters) is None]
            begun = {name: self._begin(number, name, parameters) for name in missing}
            for name in together:
                rows[name] = self._found(name, parameters) or self._keep(name, parameters, begun[name])
            if any(row["failed"] for row in rows.values()):
                break
        measured: dict[str, tuple[float, ...]] = {}
        for name, row in rows.items():
            if row["failed"]:
                return StrengthRun(parameters, measured, f"{name}: {row['failed']}")
            measured[name] = tuple(row["strength"])
        return StrengthRun(parameters, measured)

    def _found(self, name: str, parameters: Mapping[str, float]) -> dict[str, Any] | None:
        same = (row for row in self.kept if row["test"] == name and row["parameters"] == dict(parameters))
        return next(same, None)

    def _begin(self, number: int, name: str, parameters: Mapping[str, float]) -> list[Callable[[], object]]:
        """What gives the strengths of a test; where there is an executor all of it is under way."""
        if self.progress is not None:
            told = ", ".join(f"{key} = {value:.5g}" for key, value in parameters.items())
            self.progress(f"run {number}, {name}: {told}")
        parts = functions_of(self.tests[name])
        if self.executor is None:
            return [partial(part, **parameters) for part in parts]
        under_way: list[Future[object]] = [self.executor.submit(part, **parameters) for part in parts]
        return [one.result for one in under_way]

    def _keep(self, name: str, parameters: Mapping[str, float], parts: list[Callable[[], object]]) -> dict[str, Any]:
        """Wait for a test and keep what it gave, or why it gave nothing."""
        strength, failed = list[float](), ""
        try:
            found = [part() for part in parts]
            strength = _strengths(name, found if is_series(self.tests[name]) else found[0])
        except UnstableRunError as error:
            failed = " ".join(str(error).split())
        row = {"parameters": dict(parameters), "test": name, "strength": strength, "failed": failed}
        self.kept.append(row)
        self._save()
        return row

    def _save(self) -> None:
        if self.folder is None:
            return
        self.folder.mkdir(parents=True, exist_ok=True)
        text = json.dumps({"about": self.about, "tests": self.kept}, indent=1, allow_nan=False, ensure_ascii=False)
        write_text(self.folder / _FILE, text + "\n")


def _strengths(name: str, found: object) -> list[float]:
    try:
        values = np.atleast_1d(np.asarray(found, dtype=float))
    except (TypeError, ValueError):
        values = np.zeros(0)
    if values.ndim != 1 or not values.size or not all(0.0 < value < math.inf for value in values):
        raise InputError(
            f"calibrate_strength: test '{name}' gave {shown(found)}; let it return a positive strength in Pa, or one"
            " for each packing"
        )
    return values.tolist()
