"""What every result file begins with, and how it is written."""

import argparse
import datetime
import json
import statistics
import subprocess
import sys
from collections.abc import Callable, Sequence
from importlib.metadata import version
from pathlib import Path
from time import perf_counter, process_time
from typing import Any

from paired import ROOT, machine

RESULTS = ROOT / "benchmarks" / "results"


def origin() -> dict:
    """Command, machine with its load, date, version and commit, as they are when a benchmark starts."""
    started = datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds")
    return {
        "command": command(), "machine": machine(), "started": started, "version": version("bondem"),
        "commit": commit(),
    }  # fmt: skip


def command() -> str:
    """How this process was started; paths outside the repository become BUILD/name, as in commands of studies."""
    words = [word.replace(f"{ROOT}/", "") for word in (str(Path(sys.argv[0]).resolve()), *sys.argv[1:])]
    return " ".join(["python", *(f"BUILD/{Path(word).name}" if Path(word).is_absolute() else word for word in words)])


def commit() -> str:
    """The commit of the repository, with "+" where files differ from it."""
    head, changed = (
        subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True, check=True).stdout.strip()
        for words in (["rev-parse", "--short=12", "HEAD"], ["status", "--porcelain", "--untracked-files=no"])
    )
    return head + ("+" if changed else "")


def place(description: str | None, usual: Path, arguments: Sequence[str] | None) -> Path:
    """Where a benchmark that has no other option writes: --out, or the usual file."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, default=usual)
    return parser.parse_args(arguments).out


def keep(path: Path, report: dict) -> None:
    """Write a report."""
    path.write_text(json.dumps(report, indent=1, ensure_ascii=False, allow_nan=False) + "\n", encoding="utf-8")


class Report:
    """Rows of several parts in a file: cases that it has already are not measured again."""

    def __init__(self, path: Path, parts: Sequence[str]) -> None:
        begun = origin()
        self.path, self.commit = path, begun["commit"]
        kept = json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
        self.all: dict[str, Any] = begun | {part: kept.get(part, []) for part in parts}

    def add(self, part: str, measure: Callable[[], list[dict[str, Any]]], **case: Any) -> None:
        """Measure a case, one row for each variant, and write the file."""
        if any(case.items() <= row.items() for row in self.all[part]):
            return
        started = perf_counter()
        self.all[part] += [case | row | {"commit": self.commit} for row in measure()]
        keep(self.path, self.all)
        print(part, case, f"{perf_counter() - started:.1f} s", flush=True)


def spread(values: Sequence[float], digits: int = 4) -> dict[str, float]:
    """Least, median and largest, to so many digits."""
    found = {"min": min(values), "median": statistics.median(values), "max": max(values)}
    return {name: float(f"{value:.{digits}g}") for name, value in found.items()}


def clocked(task: Callable[[], object], repeat: int) -> dict[str, dict[str, float]]:
    """Seconds of a task by the wall and of all processors: the two differ on a busy machine."""
    wall, cpu = [], []
    for _ in range(repeat):
        began, worked = perf_counter(), process_time()
        task()
        wall.append(perf_counter() - began)
        cpu.append(process_time() - worked)
    return {"wall": spread(wall), "cpu": spread(cpu)}
