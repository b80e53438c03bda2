"""What every result of a benchmark begins with, and how it is written: as records of studies."""

import sys
from collections.abc import Callable
from pathlib import Path
from time import perf_counter, process_time

ROOT = Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT))  # scripts are started by their path

from validation.frame import record  # noqa: E402
from validation.frame.record import RESULTS, Record, commit, spread  # noqa: E402

__all__ = ["RESULTS", "ROOT", "Record", "clocked", "command", "commit", "keep", "origin", "spread"]


def command() -> str:
    """How this process was started."""
    return record.command_line(["python", str(Path(sys.argv[0]).resolve()), *sys.argv[1:]])


def origin() -> dict:
    """Command, machine with its load, date, version and commit, as they are when a benchmark starts."""
    return record.origin(command())


def keep(path: Path, report: dict) -> None:
    """Write a report."""
    record.write(path, report)


def clocked(task: Callable[[], object], repeat: int) -> dict[str, dict[str, float]]:
    """Seconds of a task by the wall and of all processors: the two differ on a busy machine."""
    wall, cpu = [], []
    for _ in range(repeat):
        began, worked = perf_counter(), process_time()
        task()
        wall.append(perf_counter() - began)
        cpu.append(process_time() - worked)
    return {"wall": spread(wall), "cpu": spread(cpu)}
