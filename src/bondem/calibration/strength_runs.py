"""Tests of a strength calibration, each kept on disk as soon as it is done."""

import json
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from bondem._checks import shown
from bondem.errors import InputError, UnstableRunError
from bondem.io.atomic import require_folder, write_text

#: A test: parameters by name → strength [Pa], or one of each of several packings.
Test = Callable[..., float | Sequence[float]]
_FILE = "strength_calibration.json"


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
        kept: all single tests that are known: parameters, test, and strengths or why there are none.
    """

    tests: Mapping[str, Test]
    about: str
    folder: Path | None
    progress: Callable[[str], None] | None
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
        measured: dict[str, tuple[float, ...]] = {}
        for name in self.tests:
            strength, failed = self._one(number, name, parameters)
            if failed:
                return StrengthRun(parameters, measured, f"{name}: {failed}")
            measured[name] = tuple(strength)
        return StrengthRun(parameters, measured)

    def _one(self, number: int, name: str, parameters: Mapping[str, float]) -> tuple[list[float], str]:
        for row in self.kept:
            if row["test"] == name and row["parameters"] == dict(parameters):
                return row["strength"], row["failed"]
        if self.progress is not None:
            told = ", ".join(f"{key} = {value:.5g}" for key, value in parameters.items())
            self.progress(f"run {number}, {name}: {told}")
        strength, failed = list[float](), ""
        try:
            strength = _strengths(name, self.tests[name](**parameters))
        except UnstableRunError as error:
            failed = " ".join(str(error).split())
        self.kept.append({"parameters": dict(parameters), "test": name, "strength": strength, "failed": failed})
        self._save()
        return strength, failed

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
