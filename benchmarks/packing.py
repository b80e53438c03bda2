"""Packings: time, density, contacts, overlap and peak memory by number of spheres, and time against spheropack.

    pip install spheropack && python benchmarks/packing.py
    python benchmarks/packing.py --methods          # jamming by growth and by compression and 20 000 spheres, minutes

Results are left in benchmarks/results/packing.json; with --methods in packing_methods.json.

Every packing is made in a process of its own, which compiles first, so that peak memory is that of one packing.
spheropack (PyPI; event-driven Lubachevsky-Stillinger in C++) takes turns with ours on the same request.
"""

import argparse
import importlib.util
import json
import os
import resource
import statistics
import subprocess
import sys
import time

# Before bondem: what is timed here must not come from the cache of packings.
os.environ["BONDEM_PACKING_CACHE"] = "off"

import bondem as bd
from kept import RESULTS, keep, origin

SHAPES = {"cylinder": bd.Cylinder(radius=5e-3, length=40e-3), "cell": bd.Cell(size=(1.0, 1.0, 1.0))}


def one(request: dict) -> dict:
    """Time, quality and memory of one packing, made here and now."""
    shape, count, seed = SHAPES[request["shape"]], request["count"], request["seed"]
    if request["library"] == "spheropack":
        import spheropack

        start = time.perf_counter()
        found = spheropack.pack(n=count, density=request["target"].get("volume_fraction", "max"), seed=seed)
        del found
        return {"seconds": time.perf_counter() - start}
    options = {"spread": request["spread"], "method": request["method"], **request["target"]}
    bd.pack(shape, count=2500, seed=0, **options)  # compile outside the timing
    start = time.perf_counter()
    particles = bd.pack(shape, count=count, seed=seed, **options)
    seconds = time.perf_counter() - start
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20
    if "volume_fraction" in request["target"]:
        return {"seconds": seconds, "peak_GiB": peak}
    quality = bd.fabric(bd.connect(particles))
    return {
        "seconds": seconds,
        "peak_GiB": peak,
        "volume_fraction": quality.volume_fraction,
        "coordination_number": quality.coordination_number,
        "backbone_coordination_number": quality.backbone_coordination_number,
        "largest_overlap": quality.largest_overlap,
        "passed": quality.passed,
    }


def measured(repeat: int, *requests: dict) -> list[list[dict]]:
    """`repeat` runs of each request, which take turns; seeds 1, 2, ..."""
    runs: list[list[dict]] = [[] for _ in requests]
    for seed in range(1, repeat + 1):
        for k, request in enumerate(requests):
            command = [sys.executable, __file__, "--one", json.dumps({**request, "seed": seed})]
            answer = subprocess.run(command, check=True, capture_output=True, text=True).stdout
            runs[k].append({"seed": seed, **json.loads(answer.splitlines()[-1])})
    return runs


def asked(
    shape: str, count: int, spread: float, target: dict, method: str = "quench", library: str = "bondem"
) -> dict:
    return {
        "library": library, "shape": shape, "count": count, "spread": spread, "target": target, "method": method,
    }  # fmt: skip


def row(request: dict, runs: list[dict]) -> dict:
    """Smallest and median time of the runs, range of what they came to; printed as one line."""
    seconds = [run["seconds"] for run in runs]
    print(
        f"{request['shape']:>8} {request['count']:>8} {request['method']:>11} {json.dumps(request['target']):>18}"
        f" {min(seconds):8.2f} {statistics.median(seconds):8.2f} s"
        f"  phi {_range(runs, 'volume_fraction', 4)}  z {_range(runs, 'coordination_number', 3)}"
        f"  z backbone {_range(runs, 'backbone_coordination_number', 3)}"
        f"  overlap {max(run['largest_overlap'] for run in runs):.1e}"
        f"  {max(run['peak_GiB'] for run in runs):.2f} GiB"
        f"  {'good' if all(run['passed'] for run in runs) else 'NOT GOOD'}",
        flush=True,
    )
    return {**request, "seconds_min": min(seconds), "seconds_median": statistics.median(seconds), "runs": runs}


def _range(runs: list[dict], name: str, digits: int) -> str:
    values = [run[name] for run in runs]
    return f"{min(values):.{digits}f}-{max(values):.{digits}f}"


def against(count: int, repeat: int) -> list[dict]:
    """Times of spheropack over ours; above 1 it takes longer."""
    found = []
    for target in ({"volume_fraction": 0.60}, {"jamming": True}):
        pair = [asked("cell", count, 0.0, target, library=library) for library in ("spheropack", "bondem")]
        theirs, ours = ([run["seconds"] for run in runs] for runs in measured(repeat, *pair))
        ratio = min(theirs) / min(ours)
        middle = statistics.median(theirs) / statistics.median(ours)
        print(
            f"{count} equal spheres in a cell, {json.dumps(target)}: spheropack {min(theirs):.2f} s,"
            f" bondem {min(ours):.2f} s, ratio {ratio:.1f} of smallest, {middle:.1f} of median times",
            flush=True,
        )
        found.append(
            {"count": count, "target": target, "spheropack": theirs, "bondem": ours, "ratio_min": ratio,
             "ratio_median": middle}
        )  # fmt: skip
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--elements", type=int, nargs="+", default=[10_000, 100_000])
    parser.add_argument("--repeat", type=int, default=3, help="packings a row, seeds 1, 2, ... [3]")
    said = "jamming by growth and compression and a cylinder of 20 000, once, and nothing else"
    parser.add_argument("--methods", action="store_true", help=said)
    parser.add_argument("--against", type=int, default=2000, help="spheres in the comparison with spheropack [2000]")
    parser.add_argument("--one", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.one:
        print(json.dumps(one(json.loads(options.one))))
        return

    name, plan, compared = _plan(options)
    here = origin()
    print(f"{here['machine']}; times: smallest, median")
    report = {**here, "packings": [], "against_spheropack": []}
    for request, repeat in plan:
        report["packings"].append(row(request, measured(repeat, request)[0]))
        keep(RESULTS / f"{name}.json", report)
    if compared and importlib.util.find_spec("spheropack"):
        report["against_spheropack"] = against(options.against, options.repeat)
    elif compared:
        print("no comparison: pip install spheropack")
    keep(RESULTS / f"{name}.json", report)


def _plan(options: argparse.Namespace) -> tuple[str, list[tuple[dict, int]], bool]:
    """Name of the results, requests with their repeats, and whether spheropack is compared."""
    jammed = asked("cell", 10_000, 0.0, {"jamming": True})
    if options.methods:
        plan = [({**jammed, "method": method}, 1) for method in ("growth", "compression")]
        return "packing_methods", [*plan, (asked("cylinder", 20_000, 0.25, {}), 1)], False
    plan = [(asked("cylinder", count, 0.25, {}), options.repeat) for count in options.elements]
    jammed_cylinder = asked("cylinder", 10_000, 0.25, {"jamming": True})
    return "packing", [*plan, (jammed, options.repeat), (jammed_cylinder, options.repeat)], True


if __name__ == "__main__":
    main()
