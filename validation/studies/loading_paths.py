"""Strength that does not depend on the loading path: the battery, with verdicts.

What a data sheet gives, f_t, c, φ and G_f, has to come out on any path: after a first load in another direction, with
other stresses beside the tension, on planes of a weaker material, in bars, notched bars and compact specimens, in
compression, and whatever the angle between packing and crack. Tolerances are constants of the modules in `paths/`,
stated before any run; a verdict is computed from them, on each specimen or on the mean of all as it is stated there.

`many_cycles` takes ten times as long as `cycles`, and has to be named. The table beside the record has all rows.
"""

import json
import multiprocessing
import time
from collections.abc import Sequence
from contextlib import nullcontext
from dataclasses import replace
from itertools import product
from pathlib import Path
from typing import Annotated, Any

from bondem._threads import threads
from validation.figures.loading_paths import draw_beside
from validation.frame.record import RESULTS, Record
from validation.frame.sources import commit
from validation.studies.paths import (
    beside,
    bimetal,
    compact,
    compressive_strength,
    curving,
    discs,
    equilibria,
    first_loads,
    opened,
    softening_energy,
    stress_states,
    turned_plates,
    two_cracks,
    weak_planes,
)
from validation.studies.paths.rows import CaseFunction, Row, Verdict, table, verdicts

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
    "rubbing": (opened.rubbing, (400,)),
    "turning": (stress_states.turning, (400,)),
    "inclined": (weak_planes.inclined, (400,)),
    "lateral": (weak_planes.lateral, (400,)),
    "beams": (weak_planes.beams, (400,)),
    "bimetal": (bimetal.bimetal, (400, 1000)),
    "plain": (softening_energy.plain, (200, 400, 1000)),
    "notched": (softening_energy.notched, (200, 400, 1000)),
    "compact": (compact.compact_tension, (400, 800, 1600)),
    "solvers": (softening_energy.solvers, (200,)),
    "compression": (compressive_strength.compression, (400,)),
    "splitting": (compressive_strength.splitting, (3000,)),
    "turned_axes": (curving.turned_axes, (400, 1000)),
    "offset": (curving.offset, (400, 1000)),
    "discs": (discs.discs, (1000, 2000)),
    "pressed_equilibria": (equilibria.pressed_equilibria, (400, 1000)),
    "disc_equilibria": (equilibria.disc_equilibria, (400, 1000)),
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
        "rows": [replace(row, seed=seed, count=count).as_json() for row in rows],
    }  # fmt: skip


def measure(
    record: Record, *, cases: Annotated[tuple[str, ...], tuple(CASES)] = USUAL, seeds: tuple[int, ...] = SEEDS,
    counts: tuple[int, ...] = (), quick: bool = False, processes: int = 1, before: str = "",
) -> None:  # fmt: skip
    """Measure cases that the record does not have, and evaluate all that it has.

    Args:
        cases: to measure.
        seeds: of the packings.
        counts: cells, instead of those of each case.
        quick: the first packing and size only.
        processes: how many work at once.
        before: name of a record whose numbers the table has beside these.
    """
    wanted = tasks(cases, seeds, counts, quick=quick)
    waiting = [task for task in wanted if not record.has(**dict(zip(("task", "seed", "count"), task, strict=True)))]
    with multiprocessing.get_context("spawn").Pool(processes) if processes > 1 else nullcontext() as pool:
        for found in map(done, waiting) if pool is None else pool.imap_unordered(done, waiting):
            record.rows().append(found)
            record.keep()
            words = f"{found['task']}, packing {found['seed']}, {found['count']} cells"
            print(f"{words}, {found['seconds']:.0f} s", flush=True)
            for row in (Row.from_json(one) for one in found["rows"]):
                limit = "stated" if row.tolerance is None else f"within {row.tolerance:g}"
                print(f"    {row.name}: {row.ratio:.4f} ({limit})  {row.note}", flush=True)
    sum_up(record, before)


def sum_up(record: Record, before: str = "") -> None:
    """Verdicts of all cases of a record, and the table beside it.

    Args:
        record: with all cases.
        before: name of a record whose numbers the table has beside these.
    """
    record.rows().sort(key=lambda one: (list(CASES).index(one["task"]), one["count"], one["seed"]))
    rows = [Row.from_json(row) for one in record.rows() for row in one["rows"]]
    found = verdicts(rows)
    earlier = json.loads((RESULTS / f"{before}.json").read_text(encoding="utf-8"))["verdicts"] if before else []
    text = table(found, rows, [Verdict(**one) for one in earlier])
    made: dict[str, list[str]] = {}
    for one in record.rows():
        made.setdefault(one["commit"], []).append(f"{one['task']} {one['count']}")
    text += "".join(f"- commit {commit}: {', '.join(dict.fromkeys(tasks))}\n" for commit, tasks in made.items())
    record.path.with_suffix(".md").write_text(text, encoding="utf-8")
    record.keep(verdicts=[vars(one) for one in found])
    print(text)


def draw(_: Record, folder: Path) -> None:
    """Cubes beside a pressure along the crack, now and before."""
    draw_beside(folder / "cracks_beside_pressure.png")
