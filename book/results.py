"""Where numbers come from: JSON that commands leave. A number that is not there is an error."""

import json
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from book.errors import BookError
from book.row import Measured, Origin

ROOT = Path(__file__).resolve().parents[1]
RESULTS = ROOT / "benchmarks" / "results"

#: A key, a position, or what the wanted member of a list has: {"case": "1", "law": "TBBM"}.
Step = str | int | Mapping[str, Any]


@dataclass(frozen=True)
class Measurement:
    """A command whose results are kept as `benchmarks/results/NAME.json`.

    Attributes:
        name: of the results.
        command: BUILD in it stands for the folder of builds.
        takes: how long, in words.
        condense: what to keep of the folder BUILD/NAME that the command leaves; None where the command
            writes `benchmarks/results/NAME.json` itself.
        figures: those to keep: path in BUILD/NAME → name in `docs/figures`.
        file: the JSON, where it is not that of the name.
        goes_on: whether the command leaves out cases that the JSON has already; to measure anew it is removed first.
    """

    name: str
    command: str
    takes: str = ""
    condense: Callable[[Path], dict[str, Any]] | None = None
    figures: Mapping[str, str] = field(default_factory=dict)
    file: Path | None = None
    goes_on: bool = False

    @property
    def path(self) -> Path:
        return self.file or RESULTS / f"{self.name}.json"

    @property
    def origin(self) -> Origin:
        kept = self.path.relative_to(ROOT) if self.path.is_relative_to(ROOT) else Path(self.path.name)
        return Origin(self.command, str(kept), takes=self.takes)

    @property
    def _remedy(self) -> str:
        return f"measure it: python -m book --measure {self.name}"

    @property
    def data(self) -> Any:
        """All that was kept."""
        try:
            return _read(self.path)
        except FileNotFoundError:
            raise BookError(f"{self.origin.kept} is not there; {self._remedy}") from None

    @property
    def made(self) -> Mapping[str, Any]:
        """What names command, day and commit: the record, or that of the machine which measured last."""
        found = self.data
        return found if "command" in found else max(found.values(), key=lambda entry: entry["started"])

    def at(self, *steps: Step) -> Any:
        """What stands at a place, whatever it is."""
        found = self.data
        for k, step in enumerate(steps):
            where = f"{self.origin.kept}: {' → '.join(map(str, steps[: k + 1]))}"
            if isinstance(step, Mapping):
                fitting = [one for one in found if all(one.get(key) == value for key, value in step.items())]
                if len(fitting) != 1:
                    raise BookError(f"{where}: {len(fitting)} members have this instead of one")
                found = fitting[0]
                continue
            try:
                found = found[step]
            except (KeyError, IndexError, TypeError):
                raise BookError(f"{where} is not there; {self._remedy}") from None
        return found

    def number(self, *steps: Step, scatter: tuple[Step, ...] | None = None, factor: float = 1.0) -> Measured:
        """A number at a place, with the scatter at another; `factor` on both."""
        spread = None if scatter is None else factor * self._float(*scatter)
        return Measured((factor * self._float(*steps),), self.origin, spread)

    def of(self, *values: float | None, scatter: float | None = None) -> Measured:
        """Numbers that were worked out from what is kept."""
        if any(value is None for value in values):
            raise BookError(f"{self.origin.kept}: a number is missing; {self._remedy}")
        return Measured(tuple(float(value) for value in values if value is not None), self.origin, scatter)

    def each(self, found: Iterable[Mapping[str, Any]], key: str) -> Measured:
        """Numbers that several results have at a key."""
        return self.of(*(one[key] for one in found))

    def summary(self, *steps: Step) -> Measured:
        """Mean and scatter at a place of the summary; the scatter of a single one is not there."""
        found = self.at("summary", *steps)
        return self.of(found["mean"], scatter=found["std"])

    def mean(self, values: list[float]) -> Measured:
        """Mean and standard deviation of a sample."""
        return Measured((float(np.mean(values)),), self.origin, float(np.std(values, ddof=1)))

    def _float(self, *steps: Step) -> float:
        found = self.at(*steps)
        if isinstance(found, str) or not isinstance(found, float | int):
            raise BookError(f"{self.origin.kept}: {' → '.join(map(str, steps))} is {found!r}, not a number")
        return float(found)


def study(
    name: str, figures: Mapping[str, str], *, options: str = "", kept: str = "", without: Sequence[str] = (),
    takes: str = "",
) -> Measurement:  # fmt: skip
    """A study of `validation`: its results without curves and rows, and some of its figures.

    Args:
        name: of the study.
        figures: name in the folder that the study leaves → name in `docs/figures`, both without ending.
        options: of its command.
        kept: name of what is kept, where it is not that of the study.
        without: what else of its results is not kept.
        takes: how long, in words.
    """

    def keep(folder: Path) -> dict[str, Any]:
        results = json.loads((folder / "results.json").read_text(encoding="utf-8"))
        # as it was called, but for the folder of the day
        results["command"] = re.sub(r"--out \S+", f"--out BUILD/{kept or name}", results["command"])
        return {key: found for key, found in results.items() if key not in ("curves", "profile", "rows", *without)}

    drawn = {f"figures/{one}.png": f"{target}.png" for one, target in figures.items()}
    command = f"python -m validation {name} --out BUILD/{kept or name} {options}".rstrip()
    return Measurement(kept or name, command, takes, keep, drawn)


def record(study: str, *runs: str, kept: str = "", drawn: bool = False, takes: str = "") -> Measurement:
    """A study of `validation` that writes its record itself.

    Args:
        study: its name.
        runs: options of its runs, which all add to the record; one run without options unless given.
        kept: name of the record, where it is not that of the study.
        drawn: whether it draws figures of the pages from the record.
        takes: how long, in words.
    """
    out = f"--out benchmarks/results/{kept}.json" if kept else ""
    words = [*(f"{run} {out}" for run in runs or ("",)), *(["--figures docs/figures"] if drawn else [])]
    command = " && ".join(f"python -m validation {study} {' '.join(one.split())}".rstrip() for one in words)
    return Measurement(kept or study, command, takes, goes_on=True)


def grouped(found: Iterable[Any], *keys: str) -> dict[tuple[Any, ...], list[Any]]:
    """Members of a list by what stands at some keys, in their order."""
    groups: dict[tuple[Any, ...], list[Any]] = {}
    for one in found:
        groups.setdefault(tuple(one[key] for key in keys), []).append(one)
    return groups


@cache
def _read(path: Path) -> Any:
    return json.loads(path.read_text(encoding="utf-8"))
