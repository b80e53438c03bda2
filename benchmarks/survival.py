"""Survival of run files: runs that are killed while they write, and single bits that are flipped.

A block of brittle cells is torn apart, with contact between the pieces, in a new process that writes a checkpoint and
a snapshot every few steps. SIGKILL ends it at a random moment after the first. The script records whether bondem and
VTK's own reader open the file, how many steps are lost, and whether the resumed run ends with the bits of an
uninterrupted one.

Run: python benchmarks/survival.py [--cells 1500] [--kills 200] [--flips 200]
     python benchmarks/survival.py --cells 100000 --kills 10 --flips 0 --steps 120 --every 20 --out FILE
It writes benchmarks/results/survival.json.
"""

import functools
import json
import os
import signal
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np

import bondem as bd
from bondem.errors import RunFileError
from kept import Record, child, run

SAFE = ("state.pose", "state.motion", "state.integrity", "state.broken", "history.records")


@functools.cache
def model_of(count: int) -> bd.Model:
    """Return the model of a block whose end is pulled so fast that pieces detach within a thousand steps."""
    particles = bd.pack(bd.Box((4e-2, 2e-2, 2e-2)), count=count, method="even", seed=1)
    body = bd.connect(particles, method="laguerre")
    failure = bd.MohrCoulomb(tension=2e6, cohesion=6e6, friction_angle=0.6)
    ends = [bd.Fix(bd.Face("x_min")), bd.Drive(bd.Face("x_max"), vx=2.0)]
    contact = bd.LinearContact(E=30e9, friction=0.3)
    return bd.Model(body, bd.CellBond(E=30e9, nu=0.2), 2500.0, failure=failure, boundary=ends, contact=contact)


def carry_out(count: int, steps: int, every: int, out: Path, progress=None) -> bd.ExplicitResult:
    model = model_of(count)
    dt = bd.solve_explicit(model, duration=0.0).dt
    return bd.solve_explicit(
        model, duration=steps * dt, dt=dt, every=every, save_every=every, snapshot_every=every, out=out,
        progress=progress,
    )  # fmt: skip


def worker(count: int, steps: int, every: int, out: str) -> None:
    """The run that is killed; it tells how far it has come."""
    carry_out(count, steps, every, Path(out), progress=lambda share: print(round(share * steps), flush=True))


def steps_for_vtk(path: Path) -> int:
    """Return the number of steps that VTK's own reader finds, or 0 if it cannot read the last one."""
    from vtkmodules.vtkIOHDF import vtkHDFReader

    reader = vtkHDFReader()
    reader.SetFileName(str(path))
    reader.UpdateInformation()
    count = int(reader.GetNumberOfSteps())
    reader.SetStep(count - 1)
    reader.Update()
    if reader.GetErrorCode() or not reader.GetOutputDataObject(0).GetNumberOfPartitionedDataSets():
        return 0
    parts = reader.GetOutputDataObject(0).GetPartitionedDataSet(0)
    return count if parts.GetNumberOfPartitions() and parts.GetPartition(0).GetNumberOfPoints() else 0


def same(one: bd.ExplicitResult, other: bd.ExplicitResult) -> bool:
    def of(run: bd.ExplicitResult, name: str) -> np.ndarray:
        return functools.reduce(getattr, name.split("."), run)

    return all(np.array_equal(of(one, name), of(other, name)) for name in SAFE)


def killed(whole: bd.ExplicitResult, seconds: float, sizes: tuple[int, int, int], folder: Path, number: int) -> dict:
    """One run that is killed, and what becomes of it."""
    path, random = folder / f"{number}.h5", np.random.default_rng(number)
    _, steps, every = sizes
    with subprocess.Popen(child(worker, *sizes, str(path)), stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        first = process.stdout.readline()  # the first interval is done
        time.sleep(0.001)
        while not path.exists():
            time.sleep(0.001)
        time.sleep(float(random.uniform(0.0, seconds)))
        process.send_signal(signal.SIGKILL)
        told = [first, *process.stdout.read().split("\n")]
    reached = max(int(line) for line in told if line.strip().isdigit())
    found = {"number": number, "reached": reached, "journal": (folder / f".{path.name}.journal").exists()}
    try:
        found["kept"] = bd.read_run(path).state.step
        found["vtk as left"] = steps_for_vtk(path)
        bd.read_contents(path)  # completes an interrupted commit, as `bondem info` does
        found["vtk"] = steps_for_vtk(path)
        assert found["vtk"], "VTK does not read it"
        found["same"] = same(whole, bd.resume(path))
        found["vtk after"] = steps_for_vtk(path)
        assert found["vtk after"] == 1 + steps // every, "snapshots are missing"
    except (RunFileError, AssertionError) as error:
        found["error"] = str(error)
    path.unlink(missing_ok=True)
    return found


def flipped(path: Path, count: int) -> dict:
    """Flip single bits of a run file; count those that raise an error, change nothing, or give other numbers."""
    whole, data = bd.read_run(path), path.read_bytes()
    used, random = np.flatnonzero(np.frombuffer(data, dtype=np.uint8)), np.random.default_rng(7)
    found = {"flips": count, "refused": 0, "harmless": 0, "other numbers": 0}
    harmed = path.with_name("harmed.h5")
    for _ in range(count):
        bit = 8 * int(random.choice(used)) + int(random.integers(8))
        changed = bytearray(data)
        changed[bit // 8] ^= 1 << bit % 8
        harmed.write_bytes(changed)
        try:
            read = bd.read_run(harmed)
        except RunFileError:
            found["refused"] += 1
            continue
        equal = all(
            np.array_equal(getattr(read.state, name), getattr(whole.state, name)) for name in type(read.state).ARRAYS
        ) and np.array_equal(read.history.records, whole.history.records)
        equal = equal and np.array_equal(read.model.mass, whole.model.mass)
        found["harmless" if equal else "other numbers"] += 1
    harmed.unlink()
    return found


def measure(
    record: Record, *, cells: int = 1500, steps: int = 2000, every: int = 50, kills: int = 200, flips: int = 200
) -> None:
    with tempfile.TemporaryDirectory(dir=os.environ.get("BONDEM_SURVIVAL_DIR")) as name:
        folder = Path(name)
        carry_out(cells, every, every, folder / "warm.h5")
        told: list[float] = []
        whole = carry_out(
            cells, steps, every, folder / "whole.h5", progress=lambda share: told.append(time.perf_counter())
        )
        seconds = told[-1] - told[0]
        flipped_bits = flipped(folder / "whole.h5", flips) if flips else {}
        found = []
        for number in range(kills):
            found.append(killed(whole, seconds, (cells, steps, every), folder, number))
            print(json.dumps(found[-1]), flush=True)
    good = [one for one in found if "error" not in one]
    result = {
        "cells": cells, "steps": steps, "every": every, "broken": len(whole.events),
        "seconds": seconds, "kills": len(found), "opened by both": len(good),
        "same bits": sum(one["same"] for one in good),
        "lost at most": max((one["reached"] - one["kept"] for one in good), default=None),
        "with a journal": sum(one["journal"] for one in found),
        "not read by VTK as left": sum("vtk as left" in one and not one["vtk as left"] for one in found),
        "errors": [one["error"] for one in found if "error" in one], "flipped": flipped_bits,
    }  # fmt: skip
    record.keep(**result)
    print(json.dumps(result, indent=1))


if __name__ == "__main__":
    run()
