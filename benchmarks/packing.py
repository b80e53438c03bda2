"""Time, density, contacts, overlap and peak memory of packings by number of spheres, and time over spheropack's.

    pip install spheropack && python benchmarks/packing.py
    python benchmarks/packing.py --methods          # jamming by growth and by compression and 20 000 spheres, minutes

Results are left in benchmarks/results/packing.json; with --methods in packing_methods.json.

Every packing runs in a new process, so that peak memory is that of one packing; a small packing before it is not
timed. spheropack (PyPI; event-driven Lubachevsky-Stillinger in C++) takes turns with bondem on the same request.
"""

import importlib.util
import os
import resource
import statistics
import time

# Set before bondem is imported, so that timed packings do not come from the cache.
os.environ["BONDEM_PACKING_CACHE"] = "off"

import bondem as bd
from kept import Record, alone, run, variant

SHAPES = {"cylinder": bd.Cylinder(radius=5e-3, length=40e-3), "cell": bd.Cell(size=(1.0, 1.0, 1.0))}


def one(request: dict) -> dict:
    """Make a packing in this process; return its time [s], quality and peak memory [GiB]."""
    shape, count, seed = SHAPES[request["shape"]], request["count"], request["seed"]
    if request["library"] == "spheropack":
        import spheropack

        start = time.perf_counter()
        found = spheropack.pack(n=count, density=request["target"].get("volume_fraction", "max"), seed=seed)
        del found
        return {"seconds": time.perf_counter() - start}
    options = {"spread": request["spread"], "method": request["method"], **request["target"]}
    bd.pack(shape, count=2500, seed=0, **options)  # a first packing outside the timing
    start = time.perf_counter()
    particles = bd.pack(shape, count=count, seed=seed, **options)
    seconds = time.perf_counter() - start
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20
    if "volume_fraction" in request["target"]:
        return {"seconds": seconds, "peak_GiB": peak}
    quality = bd.fabric(bd.connect(particles))
    names = ("volume_fraction", "coordination_number", "backbone_coordination_number", "largest_overlap", "passed")
    return {"seconds": seconds, "peak_GiB": peak} | {name: getattr(quality, name) for name in names}


def measured(repeat: int, *requests: dict) -> list[list[dict]]:
    """Run each request `repeat` times in new processes, in turns, with the seeds 1, 2, ...; return all results."""
    runs: list[list[dict]] = [[] for _ in requests]
    for seed in range(1, repeat + 1):
        for k, request in enumerate(requests):
            runs[k].append({"seed": seed, **alone(one, {**request, "seed": seed})})
    return runs


def asked(
    shape: str, count: int, spread: float, target: dict, method: str = "quench", library: str = "bondem"
) -> dict:
    return {
        "library": library, "shape": shape, "count": count, "spread": spread, "target": target, "method": method,
    }  # fmt: skip


def row(request: dict, runs: list[dict]) -> dict:
    """Return a request with smallest and median time of its runs, and print all."""
    seconds = [run["seconds"] for run in runs]
    found = {**request, "seconds_min": min(seconds), "seconds_median": statistics.median(seconds), "runs": runs}
    print(found, flush=True)
    return found


def compared(count: int, repeat: int) -> list[dict]:
    """Times of spheropack over ours; above 1 it takes longer."""
    found = []
    for target in ({"volume_fraction": 0.60}, {"jamming": True}):
        pair = [asked("cell", count, 0.0, target, library=library) for library in ("spheropack", "bondem")]
        theirs, ours = ([run["seconds"] for run in runs] for runs in measured(repeat, *pair))
        found.append({
            "count": count, "target": target, "spheropack": theirs, "bondem": ours,
            "ratio_min": min(theirs) / min(ours), "ratio_median": statistics.median(theirs) / statistics.median(ours),
        })  # fmt: skip
        print(found[-1], flush=True)
    return found


def measure(
    record: Record, *, elements: tuple[int, ...] = (10_000, 100_000), repeat: int = 3, methods: bool = False,
    against: int = 2000,
) -> None:  # fmt: skip
    """Measure packings.

    Args:
        elements: spheres of each packing in the cylinder.
        repeat: packings a row, seeds 1, 2, ...
        methods: jamming by growth and compression and a cylinder of 20 000, once, and nothing else.
        against: spheres in the comparison with spheropack.
    """
    jammed = asked("cell", 10_000, 0.0, {"jamming": True})
    if methods:
        record, repeat = variant(record, "_methods"), 1
        plan = [{**jammed, "method": method} for method in ("growth", "compression")]
        plan.append(asked("cylinder", 20_000, 0.25, {}))
    else:
        plan = [*(asked("cylinder", count, 0.25, {}) for count in elements), jammed]
        plan.append(asked("cylinder", 10_000, 0.25, {"jamming": True}))
    print(f"{record.origin['machine']}; times: smallest, median")
    rows = []
    for request in plan:
        rows.append(row(request, measured(repeat, request)[0]))
        record.keep(packings=rows, against_spheropack=[])
    if not methods and importlib.util.find_spec("spheropack"):
        record.keep(against_spheropack=compared(against, repeat))
    elif not methods:
        print("no comparison: pip install spheropack")


if __name__ == "__main__":
    run()
