"""The variant of Mka3D beside the cell law, on the same bodies."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from book.chapter import Chapter, Section
from book.forms import SIGNED, Form
from book.results import Measurement
from book.row import Row
from book.tolerances import AtMost

FOUND = Measurement("mka3d", "python benchmarks/mka3d.py --counts 300", "20 min")
MEASUREMENTS = (FOUND,)

#: What is asked of bondem's own law [-].
E_LIMIT, NU_LIMIT = 3e-3, 2e-3
OURS = "bondem"
DIFFERENCE = Form(style="+.5f")
SIZE = Form("%", 1e-2, ".2f")

#: A column of a table: its title, how it is printed, and its number in a result.
Column = tuple[str, Form, Callable[[dict[str, Any]], float]]


def chapter() -> Chapter:
    """The chapter."""
    return Chapter(
        name="mka3d",
        title="The cell law beside Mka3D",
        summary=(
            "For M = 1 the elastic cell law is that of Mka3D (Mariotti 2007; Monasse and Mariotti 2012), whose "
            "facets bend with E I/L and twist with G I_p/L ([relation to other models](cell_law.md)). Both variants, "
            "and two between them, were run on the same bodies with the same solvers. This compares formulas inside "
            "bondem; the code Mka3D itself was not run."
        ),
        misses=MISSES,
        sections=(_moduli(), _thin(), *_waves(), *_bodies()),
    )


#: What failed, in words.
MISSES = ""


def _table(
    found: Sequence[dict[str, Any]], keys: Sequence[str], heads: Sequence[str], columns: Sequence[Column]
) -> str:
    """Means over seeds, a line for each variant and values of `keys`, as a Markdown table."""
    by = (*keys, "variant")
    lines = [[*heads, "variant", *(title for title, _, _ in columns)], ["---"] * (len(by) + len(columns))]
    groups = dict.fromkeys(tuple(one[key] for key in by) for one in found)
    for group in sorted(groups, key=lambda group: group[:-1]):
        mine = [one for one in found if tuple(one[key] for key in by) == group]
        numbers = [form.text(float(np.mean([value(one) for one in mine]))) for _, form, value in columns]
        lines.append([*(part if isinstance(part, str) else f"{part:.3g}" for part in group), *numbers])
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def _seeds(found: Sequence[dict[str, Any]]) -> str:
    """The seeds in words."""
    seeds = sorted({one["seed"] for one in found})
    return f"seed {seeds[0]}" if len(seeds) == 1 else f"the mean of seeds {', '.join(map(str, seeds))}"


def _moduli() -> Section:
    found = FOUND.at("moduli")
    rows = []
    for nu in sorted({one["nu"] for one in found}):
        mine = [one for one in found if one["nu"] == nu and one["variant"] == OURS]
        for part, words in (("bulk", "periodic cell"), ("bar", "bar")):
            where = f"bondem, {words}, ν = {nu:g}"
            rows += [
                Row(case=f"{where}: error of E", form=Form("%", 1e-2, "+.3f"), tolerance=AtMost(E_LIMIT),
                    ours=FOUND.of(*(one[part]["E"] - 1.0 for one in mine))),
                Row(case=f"{where}: ν less that put in", form=DIFFERENCE, tolerance=AtMost(NU_LIMIT),
                    ours=FOUND.of(*(one[part]["nu"] - nu for one in mine))),
            ]  # fmt: skip
    columns: list[Column] = []
    for part, words in (("bulk", "periodic cell"), ("bar", "bar")):
        columns += [
            (f"{words}: error of E", Form("%", 1e-2, "+.3f"), lambda one, part=part: one[part]["E"] - 1.0),
            (f"{words}: ν less that put in", DIFFERENCE, lambda one, part=part: one[part]["nu"] - one["nu"]),
        ]
    columns += [
        ("bar: tractions off σ n", SIZE, lambda one: one["bar"]["traction"]),
        ("bar: scatter of the stress of cells", SIZE, lambda one: one["bar"]["stress"]),
    ]
    return Section(
        title="E and ν",
        before="A periodic cell, and a free bar 4 × 1 × 1 between smooth platens. Packings have κ = 25 %.",
        rows=tuple(rows),
        after=f"All variants, {_seeds(found)}:\n\n" + _table(found, ("nu",), ("ν",), columns),
    )


def _thin() -> Section:
    found = FOUND.at("thin")
    return Section(
        title="Thin strips",
        before=(
            "The first bending frequency of a clamped strip of unequal cells, 12 times as long as thick, less that of"
            f" triquadratic finite elements; {_seeds(found)}. A layer one cell thick bends by its facets alone, so"
            " that E I/L is right there, and 2G I/L gives frequencies that are too low by the factor 1/√(1 + ν).\n\n"
            + _table(found, ("thick", "nu"), ("cells thick", "ν"), [("error", SIGNED, lambda one: one["error"])])
        ),
    )


def _waves() -> tuple[Section, ...]:
    found = FOUND.at("waves")
    if not found:
        return ()
    return (Section(
        title="Dispersion",
        before=(
            f"Plane waves in a periodic cell, error of the celerity; {_seeds(found)}.\n\n"
            + _table(found, ("wave", "nu", "elements"), ("wave", "ν", "elements per wave"),
                     [("error", SIGNED, lambda one: one["ratio"] - 1.0)])
        ),
    ),)  # fmt: skip


def _bodies() -> tuple[Section, ...]:
    found = FOUND.at("bodies")
    if not found:
        return ()
    return (Section(
        title="Free frequencies",
        before=(
            "The first six free frequencies of a beam of 40 × 5 × 5 mm and a plate of 24 × 16 × 2.5 mm against "
            f"triquadratic finite elements; {_seeds(found)}.\n\n"
            + _table(found, ("shape", "nu"), ("body", "ν"), [
                ("mean error", SIGNED, lambda one: float(np.mean(one["errors"]))),
                ("largest error", SIZE, lambda one: float(np.abs(one["errors"]).max())),
            ])
        ),
    ),)  # fmt: skip
