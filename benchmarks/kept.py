"""Benchmarks as studies that write one record: the options of a script are the arguments of its `measure`."""

import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from time import perf_counter, process_time
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT))  # scripts are started by their path

from validation.frame import record  # noqa: E402
from validation.frame.command import recording  # noqa: E402
from validation.frame.record import RESULTS, Record, commit, spread  # noqa: E402

__all__ = [
    "RESULTS", "ROOT", "Record", "alone", "child", "clocked", "command", "commit", "keep", "origin", "run", "spread",
    "variant",
]  # fmt: skip


def run(name: str = "") -> None:
    """Carry out the script that was started: its measurement, or one function of it that `child` asks for.

    Args:
        name: of the record, where it is not that of the script.
    """
    script = sys.modules["__main__"]
    if sys.argv[1:2] == ["--alone"]:
        print(json.dumps(getattr(script, sys.argv[2])(*json.loads(sys.argv[3]))))
        return
    path = Path(sys.argv[0]).resolve()
    recording(str(path), name or path.stem, script)()


def variant(record: Record, ending: str) -> Record:
    """Make a record the one of NAME with an ending, unless the command names another one."""
    own = RESULTS / f"{Path(sys.argv[0]).stem}.json"
    if ending and record.path == own:
        other = Record(own.with_stem(own.stem + ending), command())
        record.path, record.data = other.path, other.data
    return record


def child(task: Callable[..., Any], *arguments: Any) -> list[str]:
    """Command of a process of its own that calls a function of this script and prints its answer as JSON."""
    return [sys.executable, "-W", "ignore", sys.argv[0], "--alone", task.__name__, json.dumps(arguments)]


def alone(task: Callable[..., Any], *arguments: Any, **environment: str) -> Any:
    """The answer of a function of this script in a process of its own, with some variables of its environment."""
    words = child(task, *arguments)
    done = subprocess.run(words, check=True, stdout=subprocess.PIPE, text=True, env=os.environ | environment)
    return json.loads(done.stdout.splitlines()[-1])


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
