"""Strength that does not depend on the loading path: the battery, with verdicts.

What a data sheet gives, f_t, c, φ and G_f, has to come out on any path: after a first load in another direction, with
other stresses beside the tension, on planes of a weaker material, in bars, notched bars and compact specimens, in
compression, and whatever the angle between packing and crack. Tolerances are constants of the modules in `paths/`,
stated before any run; a verdict is computed from them, on each specimen or on the mean of all as it is stated there.

Run: python benchmarks/loading_paths.py [--cases cross planes ...] [--seeds 1 2 3 4 5] [--counts 400] [--quick]
         [--processes 1] [--out DIR] [--anew]
     python benchmarks/loading_paths.py --summary [--name loading_paths] [--before loading_paths_before]
Each case of each packing is kept in --out as soon as it is done, so that a run goes on where it was stopped; the last
command brings all of them into benchmarks/results/loading_paths.json and loading_paths.md. `many_cycles` takes ten
times as long as `cycles`, and has to be named.
"""

import argparse
import json
import multiprocessing
import time
from collections.abc import Sequence
from itertools import product
from pathlib import Path
from typing import Any

from bondem._threads import threads
from kept import RESULTS, commit, keep, origin
from paths import (
    beside,
    bimetal,
    compressive_strength,
    curving,
    discs,
    first_loads,
    opened,
    softening_energy,
    stress_states,
    turned_plates,
    two_cracks,
    weak_planes,
)
from paths.rows import CaseFunction, Row, Verdict, table, verdicts

#: Cases by name, and the numbers of cells they are done with unless --counts says otherwise.
CASES: dict[str, tuple[CaseFunction, tuple[int, ...]]] = {
    "cross": (first_loads.cross, (400,)),
    "diagonal": (first_loads.diagonal, (400,)),
    "proportional": (stress_states.proportional, (400,)),
    "equibiaxial": (stress_states.equibiaxial, (400, 1000)),
    "held": (stress_states.held, (400,)),
    "beside": (beside.beside, (400, 1000)),
    "dead": (beside.dead, (400, 1000)),
    "wide": (beside.wide, (400,)),
    "wedged": (two_cracks.wedged, (400, 1000)),
    "pressed": (beside.pressed, (400, 1000)),
    "slide": (opened.slide, (400, 1000)),
    "flat": (opened.flat, (400,)),
    "crossing": (opened.crossing, (400, 1000)),
    "closing": (opened.closing, (400, 1000)),
    "turning": (stress_states.turning, (400,)),
    "inclined": (weak_planes.inclined, (400,)),
    "lateral": (weak_planes.lateral, (400,)),
    "beams": (weak_planes.beams, (400,)),
    "bimetal": (bimetal.bimetal, (400, 1000)),
    "plain": (softening_energy.plain, (200, 400, 1000)),
    "notched": (softening_energy.notched, (200, 400, 1000)),
    "compact": (softening_energy.compact_tension, (400, 800, 1600)),
    "solvers": (softening_energy.solvers, (200,)),
    "compression": (compressive_strength.compression, (400,)),
    "splitting": (compressive_strength.splitting, (3000,)),
    "turned_axes": (curving.turned_axes, (400, 1000)),
    "offset": (curving.offset, (400, 1000)),
    "discs": (discs.discs, (1000, 2000)),
    "cycles": (first_loads.cycles, (100,)),
    "turned": (turned_plates.turned, (500,)),
    "many_cycles": (first_loads.many_cycles, (100,)),
}
#: Cases that are done unless --cases names others.
USUAL = tuple(name for name in CASES if name != "many_cycles")
SEEDS = (1, 2, 3, 4, 5)


def tasks(
    cases: Sequence[str], seeds: Sequence[int], counts: Sequence[int], *, quick: bool
) -> list[tuple[str, int, int]]:
    """Case, packing and number of cells of what is to be done; of a quick run packing 1 and the smallest bodies."""
    found = []
    for name in cases:
        own = tuple(counts) or CASES[name][1]
        found += list(product([name], seeds[:1] if quick else seeds, own[:1] if quick else own))
    return found


def done(task: tuple[str, int, int]) -> dict[str, Any]:
    """The rows of one case on one packing, and how long they took."""
    name, seed, count = task
    begun = time.perf_counter()
    with threads(1):  # bodies are small: a second thread costs more than it brings, and cases run beside each other
        rows = CASES[name][0](seed, count)
    return {
        "task": name, "seed": seed, "count": count, "seconds": time.perf_counter() - begun, "commit": commit(),
        "rows": [row.as_json() for row in rows],
    }  # fmt: skip


def main(arguments: list[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cases", nargs="+", default=USUAL, choices=list(CASES))
    parser.add_argument("--seeds", type=int, nargs="+", default=SEEDS)
    parser.add_argument("--counts", type=int, nargs="+", default=(), help="cells, instead of those of each case")
    parser.add_argument("--quick", action="store_true", help="the first packing and size only")
    parser.add_argument("--processes", type=int, default=1)
    parser.add_argument("--out", type=Path, default=Path("out/loading_paths"))
    parser.add_argument("--anew", action="store_true", help="cases that are in --out too")
    parser.add_argument("--summary", action="store_true", help="bring what is in --out into the results")
    parser.add_argument("--name", default="loading_paths", help="of the result file and of the table")
    parser.add_argument("--before", default="", help="name of a result file whose numbers the table has beside them")
    given = parser.parse_args(arguments)
    given.out.mkdir(parents=True, exist_ok=True)
    if given.summary:
        sum_up(given.out, name=given.name, before=given.before)
        return
    begun = origin()
    (given.out / "origin.json").write_text(json.dumps(begun))
    wanted = tasks(given.cases, given.seeds, given.counts, quick=given.quick)
    waiting = [task for task in wanted if given.anew or not file_of(given.out, task).exists()]
    if given.processes > 1:
        with multiprocessing.get_context("spawn").Pool(given.processes) as pool:
            for found in pool.imap_unordered(done, waiting):
                _take(given.out, found)
    else:
        for task in waiting:
            _take(given.out, done(task))


def file_of(folder: Path, task: tuple[str, int, int]) -> Path:
    """Where a case of a packing is kept."""
    name, seed, count = task
    return folder / f"{name}-{count}-seed{seed}.json"


def _take(folder: Path, found: dict[str, Any]) -> None:
    name, seed, count = found["task"], found["seed"], found["count"]
    file_of(folder, (name, seed, count)).write_text(json.dumps(found))
    print(f"{name}, packing {seed}, {count} cells, {found['seconds']:.0f} s", flush=True)
    for row in (Row.from_json(one) for one in found["rows"]):
        limit = "stated" if row.tolerance is None else f"within {row.tolerance:g}"
        print(f"    {row.name}: {row.ratio:.4f} ({limit})  {row.note}", flush=True)


def sum_up(folder: Path, results: Path = RESULTS, name: str = "loading_paths", before: str = "") -> None:
    """All that was done as one result file and one table.

    Args:
        folder: where cases are kept.
        results: folder of the result file and of the table.
        name: of both.
        before: name of a result file whose numbers the table has beside them.
    """
    began = json.loads((folder / "origin.json").read_text())
    cases = [json.loads(file.read_text()) for file in folder.glob("*-seed*.json")]
    cases.sort(key=lambda one: (list(CASES).index(one["task"]), one["count"], one["seed"]))
    rows = [Row.from_json(row) for one in cases for row in one["rows"]]
    found = verdicts(rows)
    earlier = json.loads((results / f"{before}.json").read_text())["verdicts"] if before else []
    text = table(found, rows, [Verdict(**one) for one in earlier])
    made: dict[str, list[str]] = {}
    for one in cases:
        made.setdefault(one["commit"], []).append(f"{one['task']} {one['count']}")
    text += "".join(f"- commit {commit}: {', '.join(dict.fromkeys(tasks))}\n" for commit, tasks in made.items())
    (results / f"{name}.md").write_text(text, encoding="utf-8")
    verdict = [vars(one) for one in found]
    keep(results / f"{name}.json", began | {"verdicts": verdict, "cases": cases})
    print(text)


if __name__ == "__main__":
    main()
