"""Campaign of a hundred specimens on a local cluster: speed-up, and survival of killed workers and coordinator.

The specimens are small bars of cells in tension, those of examples/campaign.toml. The speed-up is that of a few bars
of 1000 cells on two workers over one, including the start of the cluster. Then all bars, of 200 cells each, run on
two workers. SIGKILL ends one worker every few seconds, and halfway the coordinator, which is started again.

Run: python benchmarks/campaign.py [--specimens 100] [--few 12] [--cells 1000] [--every 8]
It writes benchmarks/results/campaign.json.
"""

import contextlib
import json
import os
import random
import re
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import bondem as bd
from kept import ROOT, Record, run

EXAMPLE = ROOT / "examples" / "campaign.toml"


def write_study(folder: Path, seeds: int, cells: int) -> Path:
    """Write the example with other numbers of seeds and cells, and one value of each key; return its path."""
    text = EXAMPLE.read_text(encoding="utf-8").partition("[campaign.vary]")[0]
    for key, value in (("count", cells), ("seeds", seeds)):
        text = re.sub(rf"^{key} = \d+", f"{key} = {value}", text, flags=re.MULTILINE)
    study = folder / "study.toml"
    study.write_text(text, encoding="utf-8")
    return study


def started(study: Path, out: Path, workers: int) -> subprocess.Popen[bytes]:
    """Start the coordinator of a campaign in a new process, and return the process."""
    command = [sys.executable, "-m", "bondem", "campaign", str(study), "--out", str(out), "--workers", str(workers)]
    return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def finished(out: Path) -> dict[str, float]:
    """Return the time at which each finished specimen was written [s], by the name of its folder."""
    return {path.parent.name: path.stat().st_mtime for path in out.glob("specimens/*/specimen.json")}


def busy(out: Path) -> list[int]:
    """Return the process ids of the workers that compute a specimen, from the names of lock files."""
    names = [path.name for path in out.glob("specimens/.*.unfinished.lock")]
    pids = [int(name.split("-")[-2]) for name in names]
    return [pid for pid in pids if Path(f"/proc/{pid}").exists()]


def timed(folder: Path, specimens: int, workers: int, cells: int) -> float:
    """Return the wall time of a whole campaign, including the start of the cluster [s]."""
    study, out = write_study(folder, specimens, cells), folder / f"{workers}"
    begun = time.perf_counter()
    assert started(study, out, workers).wait() == 0
    return time.perf_counter() - begun


def killed(folder: Path, specimens: int, every: float) -> dict[str, object]:
    """Run a campaign, kill a worker every few seconds and the coordinator once; return counts of the outcome."""
    study, out, chance = write_study(folder, specimens, 200), folder / "killed", random.Random(1)
    deaths, coordinators = 0, 0
    before: dict[str, float] = {}
    process = started(study, out, 2)
    while process.poll() is None:
        time.sleep(every * chance.uniform(0.5, 1.5))
        done = finished(out)
        if coordinators == 0 and len(done) >= specimens // 2:
            process.kill()
            process.wait()
            time.sleep(3.0)  # its workers end after it
            before, coordinators = finished(out), 1
            process = started(study, out, 2)
        elif pids := busy(out):
            with contextlib.suppress(ProcessLookupError):
                os.kill(chance.choice(pids), signal.SIGKILL)
                deaths += 1
    after, table = finished(out), bd.campaign_table(out)
    results = json.loads((out / "results.json").read_text())
    left = [path.name for path in (out / "specimens").iterdir() if path.name not in after]
    return {
        "specimens": specimens, "arrived": len(after), "rows": len(table),
        "twice": len(table) - table["seed"].nunique(), "failed": len(results["failed"]), "workers killed": deaths,
        "coordinators killed": coordinators, "finished before": len(before),
        "done again": sum(after[name] != when for name, when in before.items()), "unfinished folders": len(left),
    }  # fmt: skip


def measure(
    record: Record, *, specimens: int = 100, few: int = 12, cells: int = 1000, every: float = 8.0
) -> None:
    """Measure the speed-up, and the campaign that is killed.

    Args:
        specimens: of the campaign that is killed.
        few: specimens of the speed-up.
        cells: of a specimen, where the speed-up is measured.
        every: seconds between two kills.
    """
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "warm").mkdir()
        timed(folder / "warm", 2, 1, 200)  # compiled once
        one, two = (timed(folder, few, workers, cells) for workers in (1, 2))
        print(f"{few} specimens: {one:.1f} s on one worker, {two:.1f} s on two", flush=True)
        found = killed(folder, specimens, every)
    result = {
        "few": few, "cells": cells, "one worker": one, "two workers": two, "speed-up": one / two, "killed": found,
    }  # fmt: skip
    record.keep(**result)
    print(json.dumps(result, indent=1))


if __name__ == "__main__":
    run()
