"""Time and memory of a whole study, cold and warm, and of a first result in a second process.

    python benchmarks/study.py [--repeat 3]          some five minutes on 2 cores

Cold: `bondem run examples/silica.toml` with an empty cache of compiled code and no kept packings, once; its time is
given with all compilation. Warm: the same again with the code compiled, packings made anew. A first result: a process
that imports bondem and runs a small explicit study with the code compiled, from its start to its end.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from kept import RESULTS, keep, origin, spread
from paired import ROOT

FIRST_RESULT = """
import numpy as np
import bondem as bd

position = np.indices((3, 3, 3)).reshape(3, -1).T.astype(float)
lattice = bd.connect(bd.Particles(position, np.full(27, 0.5)), tolerance=0.01)
model = bd.Model(lattice, bd.EulerBernoulli(E=1e9, nu=0.3, radius_ratio=0.7), density=1000.0)
print(bd.solve_explicit(model, duration=1e-2, every=10).steps)
"""


def process(words: list[str], environment: dict[str, str]) -> dict[str, float]:
    """Wall and processor time [s] and peak memory [bytes] of a process."""
    begun = time.perf_counter()
    child = subprocess.Popen(words, env=environment, stdout=subprocess.DEVNULL)
    _, status, used = os.wait4(child.pid, 0)
    wall = time.perf_counter() - begun
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode:
        raise RuntimeError(f"'{' '.join(words)}' ended with status {child.returncode}")
    return {"wall": wall, "cpu": used.ru_utime + used.ru_stime, "peak": used.ru_maxrss * 1024}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--repeat", type=int, default=3, help="warm studies [3]")
    parser.add_argument("--out", type=Path, default=RESULTS / "study.json")
    options = parser.parse_args()
    result: dict = {**origin(), "study": "examples/silica.toml"}
    with tempfile.TemporaryDirectory() as folder:
        bare = os.environ | {"BONDEM_CACHE_DIR": f"{folder}/code", "BONDEM_PACKING_CACHE": "off"}
        study = [sys.executable, "-m", "bondem", "run", str(ROOT / "examples" / "silica.toml"), "--out"]
        cold = process([*study, f"{folder}/cold"], bare)
        print(f"cold {cold['wall']:.1f} s", flush=True)
        warm = [process([*study, f"{folder}/warm{k}"], bare) for k in range(options.repeat)]
        first = [sys.executable, "-c", FIRST_RESULT]
        process(first, bare)
        again = [process(first, bare) for _ in range(5)]
    result |= {
        "cold": cold,
        "warm": {name: spread([run[name] for run in warm]) for name in ("wall", "cpu", "peak")},
        "first result, second process": {name: spread([run[name] for run in again]) for name in ("wall", "cpu")},
    }
    keep(options.out, result)
    print(json.dumps(result, indent=2))


if __name__ == "__main__":
    main()
