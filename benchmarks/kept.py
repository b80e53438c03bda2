"""Records of benchmarks: the origin with which each begins, and the file format, which is that of studies."""

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
    """Return the command by which this process was started."""
    return record.command_line(["python", str(Path(sys.argv[0]).resolve()), *sys.argv[1:]])


def origin() -> dict:
    """Return command, machine with its load, date, version and commit, at the start of a benchmark."""
    return record.origin(command())


def keep(path: Path, report: dict) -> None:
    """Write a report to a file."""
    record.write(path, report)


def clocked(task: Callable[[], object], repeat: int) -> dict[str, dict[str, float]]:
    """Return wall and processor seconds of a task, which differ on a busy machine, with their spread."""
    wall, cpu = [], []
    for _ in range(repeat):
        began, worked = perf_counter(), process_time()
        task()
        wall.append(perf_counter() - began)
        cpu.append(process_time() - worked)
    return {"wall": spread(wall), "cpu": spread(cpu)}
