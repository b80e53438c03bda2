"""Processes that share a cache of compiled code: one compiles, the others wait and load it."""

import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

from bondem._lock import alone

pytest.importorskip("fcntl", reason="files are locked on POSIX systems only")

SCRIPT = """
import sys, time
from pathlib import Path
import numpy as np
from bondem._compile import kernel
from numba.core import event

class Count(event.Listener):
    made = []
    def on_start(self, event):
        self.made.append(event.data["dispatcher"].py_func.__name__)
    def on_end(self, event):
        pass

event.register("numba:compile", Count())

@kernel(parallel=False)
def inner(x):
    total = 0.0
    for k in range(len(x)):
        total += x[k] ** 3
    return total

@kernel(parallel=False)
def outer(x, more):
    return inner(x) + (0.0 if more is None else inner(more))

here = Path(sys.argv[1])
(here / f"ready{sys.argv[2]}").touch()
while len(list(here.glob("ready*"))) < int(sys.argv[3]):
    time.sleep(0.01)
x = np.arange(4.0)
assert outer(x, None) == 36.0 and outer(x, x) == 72.0
print(*(name for name in Count.made if name in ("inner", "outer")))
"""


def compiled(folder: Path, processes: int) -> list[str]:
    """What several processes together compile, started at once on one cache."""
    script = folder / "script.py"
    script.write_text(SCRIPT)
    environment = os.environ | {"BONDEM_CACHE_DIR": str(folder)}
    running = [
        subprocess.Popen([sys.executable, str(script), str(folder), str(k), str(processes)], env=environment,
                         stdout=subprocess.PIPE, text=True)
        for k in range(processes)
    ]  # fmt: skip
    told = [process.communicate(timeout=120)[0] for process in running]
    assert all(process.returncode == 0 for process in running)
    return " ".join(told).split()


def test_each_function_is_compiled_once_by_all_processes_together(tmp_path):
    # `outer` for two kinds of arguments, and what it calls once
    assert sorted(compiled(tmp_path, 3)) == ["inner", "outer", "outer"]


def test_a_process_that_is_killed_leaves_no_lock(tmp_path):
    hold = (
        "import sys, time\nfrom pathlib import Path\nfrom bondem._lock import alone\n"
        "with alone(Path(sys.argv[1]), patience=60.0):\n    print('held', flush=True)\n    time.sleep(600)\n"
    )
    place = tmp_path / "lock"
    command = [sys.executable, "-c", hold, str(place)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as holder:
        assert holder.stdout is not None
        assert holder.stdout.readline() == "held\n"
        start = time.monotonic()
        with alone(place, patience=0.3):  # in vain
            assert time.monotonic() - start >= 0.3
        holder.kill()
    start = time.monotonic()
    with alone(place, patience=60.0):
        assert time.monotonic() - start < 30.0


SMALL = """
import numba.np.ufunc.parallel as layer
import bondem as bd
lattice = bd.connect(bd.pack(bd.Box((1.0, 1.0, 1.0)), count=8, method="even", seed=1), method="laguerre")
soft = bd.Rankine(tension=1e5, fracture_energy=1e3)
model = bd.Model(lattice, bd.CellBond(E=1e7, nu=0.2), 1000.0, failure=soft)
bd.solve_explicit(model, duration=1e-4)
assert layer._is_initialized
"""


def test_threads_are_there_for_code_from_the_cache() -> None:
    """Also of a body too small to use them: its compiled code has them by name (a second process compiles none)."""
    for _ in range(2):
        done = subprocess.run([sys.executable, "-c", SMALL], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
