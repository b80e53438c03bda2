"""What bondem costs in time and memory, beside its peers."""

from typing import Any

from book.chapters.calibration import TIMES
from book.dates import is_older
from book.forms import PERCENT, SECONDS, Form, spaced
from book.results import Measurement
from book.row import Row, Rows
from book.tolerances import AtLeast, AtMost

PEERS = Measurement("peers", "python benchmarks/peers/compare.py --elements 10000 100000", "20 min")
KRATOS = Measurement(
    "peers_kratos",
    "python benchmarks/peers/compare.py --elements 12000 --codes bondem non-local lammps kratos --repeat 5"
    " --output benchmarks/results/peers_kratos.json",
    "9 min",
)
AGAINST = Measurement("against", "python benchmarks/against.py speed", "20 min")
FIRST = Measurement("first_runs", "python benchmarks/first_runs.py", "3 min")
CALLBACK = Measurement("callback", "python benchmarks/callback.py", "1 min")
FAILING = Measurement("breaking_cells", "python benchmarks/breaking.py --cells", "2 min")
TOUCHING = Measurement("breaking_contact", "python benchmarks/breaking.py --contact", "2 min")
TOUCHING_CELLS = Measurement(
    "breaking_cells_contact", "python benchmarks/breaking.py --cells --contact --elements 5000", "4 min"
)
GPU = Measurement("gpu_device", "python benchmarks/gpu_device.py", "8 min, and a GPU")
MEASUREMENTS = (PEERS, KRATOS, AGAINST, FIRST, CALLBACK, TIMES, FAILING, TOUCHING, TOUCHING_CELLS, GPU)

RATE = Form("M/s", 1e6, ".0f")
RATIO = Form(style=".1f")
#: Elements, and bond-steps a second that one core is asked for.
SIZES = {10_000: None, 100_000: 60e6, 1_000_000: 45e6}


#: How the case of a row begins, and what failed where it is missed.
_FAILED = {
    "one core": "Bond-steps per second on one core at the larger sizes are below the requirements.",
    "two cores": "The gain from a second core is below the requirement.",
    "cells, ": "Cells that break at once cost more than required.",
    "cells that yield, facets": "Yielding cells whose facets soften cost slightly more than required.",
    "beams that": "Beams in pieces cost more than required.",
    "cells that yield, soften and touch": "Bodies of cells in pieces cost several times the elastic step.",
    "bondem over LAMMPS": "The lead over LAMMPS is smaller than required.",
    "bondem over Yade": "The lead over Yade is smaller than required.",
    "bondem over Kratos": "The lead over Kratos is smaller than required.",
}


def failed() -> str:
    """What failed, in words."""
    missed = [row.case for rows in (step(), failing(), peers()) for row in rows if row.verdict.is_miss]
    return "\n".join(words for begin, words in _FAILED.items() if any(case.startswith(begin) for case in missed))


def starting() -> Rows:
    yield Row("calibration on a static tension test, 10 000 elements", TIMES.number("warm", "1 cylinder", "median"),
        AtMost(10.0), SECONDS)  # fmt: skip
    words = {
        "beams": "beams that break and touch", "cells": "cells that soften and touch",
        "non-local": "the non-local law with breakage and contact", "compression": "uniaxial compression of cells",
    }  # fmt: skip
    for kind, found in FIRST.at("kinds").items():
        yield Row(f"first use of a fresh installation less the second: {words[kind]}", FIRST.of(found["difference"]),
            AtMost(3.0), Form("s", style=".2f"))  # fmt: skip


def _rate(elements: int, threads: int) -> dict[str, Any]:
    size = {"elements": elements, "threads": threads}
    return next(one for one in AGAINST.made["rates"] if size.items() <= one.items())


def _busy(found: dict[str, Any]) -> str:
    return f"other programs used up to {100.0 * found['others']:.0f} % of a core"


def then(record: Measurement) -> str:
    """That a record is older than the compiled core, if it is."""
    return ", before the compiled core replaced the loops" if is_older(record, "the compiled core") else ""


def step() -> Rows:
    for elements, asked in SIZES.items():
        found = _rate(elements, 1)
        if asked:
            yield Row(f"one core, {spaced(elements)} elements", AGAINST.of(1e6 * found["now"]["median"]),
                AtLeast(asked), RATE,
                note=f"{found['now']['min']:.0f}–{found['now']['max']:.0f} M/s; {_busy(found)}")  # fmt: skip
    for elements in SIZES:
        gain = _rate(elements, 2)["now"]["median"] / _rate(elements, 1)["now"]["median"]
        yield Row(f"two cores over one, {spaced(elements)} elements", AGAINST.of(gain), AtLeast(1.9),
            Form(style=".2f"), note=_busy(_rate(elements, 2)))  # fmt: skip
    yield Row("a Python callback each 100 steps, 10 000 elements",
        CALLBACK.number("share of an output in the steps between two"), AtMost(0.01), PERCENT,
        note="processor time of a call, with few elements, over that of the steps between two")  # fmt: skip


#: What was measured, its place in the results, how rows call it, and how many elastic steps it may cost.
FAILURES = (
    (FAILING, "MohrCoulomb", "cells, Mohr–Coulomb on the traction of facets, brittle", 1.25),
    (FAILING, "Rankine", "cells, Rankine on the stress of cells", 1.6),
    (FAILING, "MohrCoulomb, softening", "cells that yield, facets that soften", 1.6),
    (TOUCHING, "in pieces", "beams that may break and touch, in pieces", 2.0),
    (TOUCHING_CELLS, "in pieces", "cells that yield, soften and touch, in pieces", 2.0),
)


def _least(data: dict[str, Any], found: dict[str, Any]) -> str:
    """The ratio of the least times, and what was broken and touched as the first step was timed."""
    words = f"least over least {found['ratio_of_least']:.2f}"
    if "broken" in found:
        words += f"; of {spaced(data['bonds'])} bonds {spaced(found['broken'])} broken, {spaced(found['cracked'])}"
        words += f" cracked or broken, {spaced(found['contacts'])} contacts"
    return words


def failing() -> Rows:
    for measured, name, words, asked in FAILURES:
        yield Row(words, measured.number(name, "median_ratio"), AtMost(asked), Form(style=".2f"),
            note=_least(measured.data, measured.data[name]))  # fmt: skip


def peers() -> Rows:
    for code, words, factor in (
        ("lammps", "LAMMPS bpm/rotational", 12.0),
        ("yade", "Yade CohFrictMat, bonds only", 25.0),
    ):
        for elements in (10_000, 100_000):
            found = PEERS.at("specimens", {"elements": elements}, "codes", code)
            yield Row(f"bondem over {words}, one thread each, {spaced(elements)} elements",
                PEERS.of(found["ratio_median"]), AtLeast(factor), RATIO)  # fmt: skip
    found, own = (KRATOS.at("specimens", 0, "codes", code)["ratio_median"] for code in ("kratos", "non-local"))
    yield Row("bondem over Kratos DEM_KDEM, one thread each, 12 000 elements", KRATOS.of(found), AtLeast(20.0), RATIO)
    yield Row("bondem with the non-local law and Rankine over Kratos DEM_KDEM, the same run", KRATOS.of(found / own),
        AtLeast(20.0), RATIO)  # fmt: skip
