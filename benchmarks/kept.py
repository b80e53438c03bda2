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
