"""A record: what a study measured, in one JSON file with the command, the commit and the machine that made it."""

import datetime
import json
import shlex
import statistics
from collections.abc import Callable, Sequence
from importlib.metadata import version
from pathlib import Path
from time import perf_counter
from typing import Any

from validation.frame.machine import machine
from validation.frame.sources import REPOSITORY, commit

RESULTS = REPOSITORY / "benchmarks" / "results"
Row = dict[str, Any]


def origin(command: str) -> Row:
    """Command, machine with its load, date, version and commit, as they are when a measurement starts."""
    started = datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds")
    return {
        "command": command, "machine": machine(), "started": started, "version": version("bondem"),
        "commit": commit(),
    }  # fmt: skip


def command_line(words: list[str]) -> str:
    """A command as records name it: paths outside the repository become BUILD/NAME."""
    inside = [word.replace(f"{REPOSITORY}/", "") for word in words]
    return shlex.join(f"BUILD/{Path(word).name}" if Path(word).is_absolute() else word for word in inside)


def write(path: Path, report: Row) -> None:
    """Write a record."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(report, indent=1, ensure_ascii=False, allow_nan=False) + "\n", encoding="utf-8")


class Record:
    """What a study measures, in a file that is written after each case; cases that it has are not measured again.

    Attributes:
        path: of the file.
        origin: command, machine, date, version and commit of this measurement.
        data: what the file has, without the origin of its last measurement.
    """

    def __init__(self, path: Path, command: str = "") -> None:
        self.path, self.origin = path, origin(command)
        known = json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
        self.data: Row = {name: part for name, part in known.items() if name not in self.origin}

    def keep(self, **parts: Any) -> None:
        """Write the file: the parts given, and of others what it had."""
        self.data |= parts
        write(self.path, self.origin | self.data)

    @property
    def folder(self) -> Path:
        """Where curves and files that the record does not hold are left, `out/NAME`."""
        found = REPOSITORY / "out" / self.path.stem
        found.mkdir(parents=True, exist_ok=True)
        return found

    def beside(self, name: str) -> Path:
        """A file or folder in `folder`."""
        return self.folder / name

    def rows(self, part: str = "cases") -> list[Row]:
        """The rows of a part, of earlier measurements too."""
        return self.data.setdefault(part, [])

    def has(self, part: str = "cases", /, **case: Any) -> bool:
        """Whether a part has a row of this case."""
        return any(case.items() <= row.items() for row in self.rows(part))

    def add(self, measure: Callable[[], Row | list[Row]], part: str = "cases", /, **case: Any) -> None:
        """Measure a case that the file does not have yet, print what was found, and write the file.

        Args:
            measure: returns a row, or one of each variant.
            part: of the record that rows belong to.
            case: columns that name the case; they are added to the rows, with the commit.
        """
        if self.has(part, **case):
            return
        started = perf_counter()
        found = measure()
        rows = found if isinstance(found, list) else [found]
        self.rows(part).extend(case | row | {"commit": self.origin["commit"]} for row in rows)
        self.keep()
        words = ", ".join(f"{name} {value}" for name, value in case.items())
        plain = [{name: value for name, value in row.items() if isinstance(value, int | float | str)} for row in rows]
        print(f"{words}: {perf_counter() - started:.1f} s", *plain, sep="\n    ", flush=True)


def spread(values: Sequence[float], digits: int = 4) -> dict[str, float]:
    """Least, median and largest, to so many digits."""
    found = {"min": min(values), "median": statistics.median(values), "max": max(values)}
    return {name: float(f"{value:.{digits}g}") for name, value in found.items()}
