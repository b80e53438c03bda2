"""What bondem costs in time and memory, beside its peers."""

from collections.abc import Sequence
from typing import Any

from book.chapter import Chapter, Section
from book.chapters.calibration import TIMES
from book.dates import date, is_older
from book.forms import PERCENT, SECONDS, Form
from book.results import Measurement
from book.row import Row
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
MEASUREMENTS = (PEERS, KRATOS, AGAINST, FIRST, CALLBACK, TIMES, FAILING, TOUCHING, TOUCHING_CELLS)

RATE = Form("M/s", 1e6, ".0f")
RATIO = Form(style=".1f")
#: Elements, and bond-steps a second that one core is asked for.
SIZES = {10_000: None, 100_000: 60e6, 1_000_000: 45e6}
NAMES = {"lammps": "LAMMPS bpm/rotational", "yade": "Yade CohFrictMat, bonds only"}


def chapter() -> Chapter:
    """The chapter."""
    sections = (_starting(), _step(), _failing(), _peers())
    return Chapter(
        name="cost",
        title="Cost: time, memory, peers",
        summary=(
            "Times were measured on 2 shared cores, which other programs use as well: medians, and processor time "
            "where stated. Variants of the step that were tried are in [decision 0001](decisions/0001-state.md)."
        ),
        misses=" ".join(words for begin, words in _FAILED.items() if _is_missed(sections, begin)),
        sections=sections,
    )


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


def _is_missed(sections: Sequence[Section], begin: str) -> bool:
    rows = [row for section in sections for row in section.rows if row.case.startswith(begin)]
    return any(row.verdict.is_miss for row in rows)


def _starting() -> Section:
    words = {
        "beams": "beams that break and touch", "cells": "cells that soften and touch",
        "non-local": "the non-local law with breakage and contact", "compression": "uniaxial compression of cells",
    }  # fmt: skip
    return Section(
        title="Calibration, and starting",
        rows=(
            Row(case="calibration on a static tension test, 10 000 elements", form=SECONDS, tolerance=AtMost(10.0),
                ours=TIMES.number("warm", "1 cylinder", "median")),
            *(
                Row(case=f"first use of a fresh installation less the second: {words[kind]}",
                    form=Form("s", style=".2f"), tolerance=AtMost(3.0), ours=FIRST.of(found["difference"]))
                for kind, found in FIRST.at("kinds").items()
            ),
        ),
        after=(
            "Nothing is compiled at run time; the two uses differ by the cache of packings and by chance. Times of "
            "packing are in the chapter on [packings](validation/packings.md). `python benchmarks/static_solve.py` "
            "measures the times of statics and modes, and `python benchmarks/highest_frequency.py` the time of the "
            "critical step."
        ),
    )  # fmt: skip


def _machine() -> dict[str, Any]:
    """What was measured on the processor whose rates the chapter quotes: the last one."""
    return dict(AGAINST.made)


def _many(elements: int) -> str:
    return f"{elements:,}".replace(",", " ")


def _rate(elements: int, threads: int) -> dict[str, Any]:
    size = {"elements": elements, "threads": threads}
    return next(one for one in _machine()["rates"] if size.items() <= one.items())


def _busy(found: dict[str, Any]) -> str:
    return f"other programs used up to {100.0 * found['others']:.0f} % of a core"


def _then(record: Measurement) -> str:
    """That a record is older than the compiled core, if it is."""
    return ", before the compiled core replaced the loops" if is_older(record, "the compiled core") else ""


def _step() -> Section:
    here = _machine()["machine"]
    rows = []
    for elements, asked in SIZES.items():
        for threads, words in ((1, "one core"), (2, "two cores")):
            found = _rate(elements, threads)
            spread = f"{found['now']['min']:.0f}–{found['now']['max']:.0f} M/s; {_busy(found)}"
            rows.append(
                Row(case=f"{words}, {_many(elements)} elements", ours=AGAINST.of(1e6 * found["now"]["median"]),
                    form=RATE, tolerance=AtLeast(asked) if asked and threads == 1 else None, note=spread)
            )  # fmt: skip
    for elements in SIZES:
        gain = _rate(elements, 2)["now"]["median"] / _rate(elements, 1)["now"]["median"]
        rows.append(Row(case=f"two cores over one, {_many(elements)} elements", ours=AGAINST.of(gain),
                        form=Form(style=".2f"), tolerance=AtLeast(1.9), note=_busy(_rate(elements, 2))))  # fmt: skip
    rows.append(
        Row(case="a Python callback each 100 steps, 10 000 elements", form=PERCENT, tolerance=AtMost(0.01),
            ours=CALLBACK.number("share of an output in the steps between two"),
            note="processor time of a call, with few elements, over that of the steps between two")
    )  # fmt: skip
    return Section(
        title="Bond-steps",
        before=f"The rows are medians on {here['processor']}, {here['vector']}, {_machine()['started'][:10]}"
        f"{_then(AGAINST)}.",
        rows=tuple(rows),
    )


#: What was measured, its place in the results, how rows call it, and how many elastic steps it may cost.
FAILURES = (
    (FAILING, "MohrCoulomb", "cells, Mohr–Coulomb on the traction of facets, brittle", 1.25),
    (FAILING, "Rankine", "cells, Rankine on the stress of cells", 1.6),
    (FAILING, "MohrCoulomb, softening", "cells that yield, facets that soften", 1.6),
    (TOUCHING, "whole", "beams that may break and touch, whole", None),
    (TOUCHING, "in pieces", "beams that may break and touch, in pieces", 2.0),
    (TOUCHING_CELLS, "whole", "cells that yield, soften and touch, whole", None),
    (TOUCHING_CELLS, "in pieces", "cells that yield, soften and touch, in pieces", 2.0),
    (TOUCHING_CELLS, "in dust", "cells that yield, soften and touch, in dust", None),
)


def _least(data: dict[str, Any], found: dict[str, Any]) -> str:
    """The ratio of the least times, and what was broken and touched as the first step was timed."""
    words = f"least over least {found['ratio_of_least']:.2f}"
    if "broken" in found:
        words += f"; of {_many(data['bonds'])} bonds {_many(found['broken'])} broken, {_many(found['cracked'])}"
        words += f" cracked or broken, {_many(found['contacts'])} contacts"
    return words


def _failing() -> Section:
    rows = [
        Row(case=words, ours=measured.number(name, "median_ratio"), form=Form(style=".2f"),
            tolerance=None if asked is None else AtMost(asked),
            note=_least(measured.data, measured.data[name]))
        for measured, name, words, asked in FAILURES
    ]  # fmt: skip
    return Section(
        title="Failure and contact, in elastic steps",
        before=(
            f"The bodies have {_many(FAILING.at('elements'))} elements, those of cells that touch "
            f"{_many(TOUCHING_CELLS.at('elements'))}, on one thread. The processor time of their steps, measured "
            "alternately with steps of the elastic body, is given in elastic steps; nothing breaks in the first "
            "three."
        ),
        rows=tuple(rows),
        after=(
            "A crack that is closed or softens is computed separately, at many times the cost of a facet: the cost "
            "of a body of cells depends on the number of such cracks."
        ),
    )


def _peers() -> Section:
    rows = []
    for code, factor in (("lammps", 12.0), ("yade", 25.0)):
        for elements in (10_000, 100_000):
            found = PEERS.at("specimens", {"elements": elements}, "codes", code)
            many = _many(elements)
            rows.append(
                Row(case=f"bondem over {NAMES[code]}, one thread each, {many} elements", form=RATIO,
                    tolerance=AtLeast(factor), ours=PEERS.of(found["ratio_median"]))
            )  # fmt: skip
    found = KRATOS.at("specimens", 0, "codes", "kratos")
    own = KRATOS.at("specimens", 0, "codes", "non-local")
    rows += [
        Row(case="bondem over Kratos DEM_KDEM, one thread each, 12 000 elements", form=RATIO, tolerance=AtLeast(20.0),
            ours=KRATOS.of(found["ratio_median"])),
        Row(case="bondem with the non-local law and Rankine over Kratos DEM_KDEM, the same run", form=RATIO,
            tolerance=AtLeast(20.0), ours=KRATOS.of(found["ratio_median"] / own["ratio_median"])),
    ]  # fmt: skip
    return Section(
        title="Peers",
        rows=tuple(rows),
        after=(
            f"The numbers are medians of {date(PEERS)}{_then(PEERS)}; those with Kratos are of "
            f"{date(KRATOS)}{_then(KRATOS)}. The motion of all codes is compared before any ratio, except that of "
            "Kratos, whose bonds differ (normal and tangential springs; stresses and the effect of ν are switched "
            "off)."
        ),
    )
