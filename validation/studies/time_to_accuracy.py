"""Time to a given accuracy: cells, calibrated beam bonds and quadratic finite elements on the same problems.

    beam     free beam of fused silica, 40 × 5 × 5 mm: first six frequencies, against a finer mesh
    plate    free plate of fused silica, 20 × 20 × 2.5 mm: the same
    pulse    plane P pulse in a periodic bar of a medium of ν = 0.2: velocity, against d'Alembert

Each method is refined; for each size all is made from nothing (packed, cut or bonded, calibrated where it has to be;
or meshed) and solved. Finite elements are triquadratic hexahedra, and `assembly` is the part of `cpu` that
scikit-fem spends on the matrices. Beams, in the first problem only, are calibrated on the same packing, for E, ν and
ρ (`bd.calibrate`). All is compiled beforehand. Two packings of each size. `cpu` are the seconds of all processors,
which other work on the machine changes less than `seconds` of the wall; the quickest size is the least by `cpu`.

The velocity of cells is compared in means over 32 sections, that of meshes at integration points. On a regular mesh
the pulse is uniform across the bar, so that one element across (`mesh, one across`) is as accurate as cubes.
"""

from time import perf_counter, process_time
from typing import Any

from validation.frame.record import Record
from validation.measures.accuracy_problems import PROBLEMS, Attempt

#: Largest error allowed on all packings [-].
TARGET = 0.01


def row(attempt: Attempt) -> dict[str, Any]:
    began, worked = perf_counter(), process_time()
    error, assembly = attempt.run()
    taken, cpu = perf_counter() - began, process_time() - worked
    seed = "" if attempt.seed is None else f", seed {attempt.seed}"
    part = f" (assembly {assembly:.2f} s)" if assembly else ""
    what = f"{taken:.2f} s, of processors {cpu:.2f} s{part}, error {100 * error:.2g} %"
    print(f"  {attempt.method}, {attempt.size}{seed}: {what}", flush=True)
    line = {"method": attempt.method, "size": attempt.size, "seed": attempt.seed, "seconds": taken, "cpu": cpu}
    return line | ({"assembly": assembly} if assembly else {}) | {"error": error}


def first_within(rows: list[dict[str, Any]]) -> dict[str, Any]:
    """The quickest size of each method that is within the target on all packings, and its longer time, by `cpu`."""
    first = {}
    for method in dict.fromkeys(one["method"] for one in rows):
        sizes = dict.fromkeys(one["size"] for one in rows if one["method"] == method)
        groups = [[one for one in rows if (one["method"], one["size"]) == (method, size)] for size in sizes]
        good = [group for group in groups if max(one["error"] for one in group) <= TARGET]
        slowest = [max(group, key=lambda one: one["cpu"]) for group in good]
        quick = min(slowest, key=lambda one: one["cpu"], default=None)
        keys = ("size", "seconds", "cpu", "assembly")
        first[method] = None if quick is None else {key: quick[key] for key in keys if key in quick}
    return first


def solved(name: str) -> dict[str, Any]:
    """All rows of a problem."""
    problem = PROBLEMS[name]()
    print(f"{name}: {problem.error}", flush=True)
    for attempt in problem.warm:
        attempt.run()
    rows = [row(attempt) for attempt in problem.attempts]
    first = first_within(rows)
    print("  within 1 % on all packings:", first)
    exact = {} if problem.exact is None else {"exact_Hz": problem.exact}
    return {"error": problem.error} | exact | {"within_1_percent": first, "rows": rows}


def measure(record: Record, *, problems: tuple[str, ...] = tuple(PROBLEMS)) -> None:
    """Solve problems in all ways."""
    found = record.data.get("problems", {})
    for name in problems:
        found[name] = record.origin | solved(name)
        record.keep(problems={name: found[name] for name in PROBLEMS if name in found})
