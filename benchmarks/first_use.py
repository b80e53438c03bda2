"""First and second use of packing, cutting and assembly with empty caches, of this tree and of another one.

    python benchmarks/first_use.py --against ../other-tree --rounds 3

Each round starts a process for each tree in turn, with this interpreter and an empty cache of compiled
code. The core of a tree has to be compiled before. Results are left in benchmarks/results/first_use.json: seconds of
a processor (`cpu`, of all threads) and of a clock (`wall`) by tree and task, and the ratio of medians.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from kept import RESULTS, keep, origin, spread
from paired import ROOT

# Prints the seconds of each task of one process as JSON.
SCRIPT = """
import json, sys
from time import perf_counter, process_time
seconds = {}
def timed(name, task):
    wall, cpu = perf_counter(), process_time()
    made = task()
    seconds[name] = {"wall": perf_counter() - wall, "cpu": process_time() - cpu}
    return made
timed("import", lambda: __import__("bondem"))
import bondem as bd
shape, count = bd.Cylinder(radius=5e-3, length=40e-3), int(sys.argv[1])
few, many = (lambda: bd.pack(shape, count=400, seed=1)), (lambda: bd.pack(shape, count=count, seed=1))
timed("pack 400, first", few)
timed("pack 400, second", few)
particles = timed(f"pack {count}", many)
small = bd.pack(shape, count=400, seed=1, method="even")
timed("cells 400, first", lambda: bd.connect(small, method="laguerre"))
timed("cells 400, second", lambda: bd.connect(small, method="laguerre"))
timed(f"cells {count}", lambda: bd.connect(particles, method="laguerre"))
print(json.dumps(seconds))
"""


def once(tree: Path, count: int) -> dict[str, dict[str, float]]:
    """Seconds of each task in a process of its own with empty caches."""
    with tempfile.TemporaryDirectory() as cache:
        environment = os.environ | {
            "PYTHONPATH": os.pathsep.join([str(tree / "src"), os.environ.get("PYTHONPATH", "")]),
            "BONDEM_CACHE_DIR": cache, "BONDEM_PACKING_CACHE": "off", "BONDEM_PROGRESS": "off",
        }  # fmt: skip
        done = subprocess.run(
            [sys.executable, "-c", SCRIPT, str(count)], env=environment, capture_output=True, text=True, check=True
        )
    return json.loads(done.stdout.splitlines()[-1])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--against", type=Path, required=True, help="root of another source tree")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--count", type=int, default=10_000)
    parser.add_argument("--out", type=Path, default=RESULTS / "first_use.json")
    given = parser.parse_args()
    report = origin()
    trees = {"here": ROOT, "there": given.against.resolve()}
    found: dict[str, list[dict[str, dict[str, float]]]] = {name: [] for name in trees}
    for _ in range(given.rounds):
        for name, tree in trees.items():
            found[name].append(once(tree, given.count))
    report["tasks"] = {}
    for task in found["here"][0]:
        row = {
            name: {clock: spread([one[task][clock] for one in rounds]) for clock in ("cpu", "wall")}
            for name, rounds in found.items()
        }
        row["ratio"] = {c: row["there"][c]["median"] / row["here"][c]["median"] for c in ("cpu", "wall")}
        report["tasks"][task] = row
        print(f"{task:18s} " + "  ".join(
            f"{name} {row[name]['cpu']['median']:8.3f} s cpu {row[name]['wall']['median']:8.2f} s" for name in trees
        ) + f"  ratio {row['ratio']['cpu']:.2f}", flush=True)  # fmt: skip
    keep(given.out, report)


if __name__ == "__main__":
    main()
