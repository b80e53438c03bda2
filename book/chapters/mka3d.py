"""The variant of Mka3D beside the cell law, on the same bodies."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from book.forms import PERCENT, SIGNED, Form, grid, seeds
from book.results import grouped, record
from book.row import Row, Rows
from book.tolerances import AtMost

FOUND = record("mka3d", drawn=True, takes="30 min")
MEASUREMENTS = (FOUND,)

#: What is asked of bondem's own law [-]: of E and ν as for other bodies of cells, of frequencies as for bodies that
#: are four elements thick.
E_LIMIT, NU_LIMIT, FREQUENCY_LIMIT = 3e-3, 2e-3, 2e-2
OURS = "bondem"
#: Variants and the headings of their columns.
VARIANTS = {
    OURS: "bondem", "bondem, facets with twist": "full",
    "balanced shares with facets of Mka3D": "balanced, facets of Mka3D", "Mka3D": "Mka3D",
}  # fmt: skip
HEADS = {"nu": "ν", "thick": "layers", "shape": "body", "count": "cells"}
FINE = Form("%", 1e-2, "+.3f")
DIFFERENCE = Form(style="+.5f")

#: A quantity: what it is, how it is printed, and its number in a result.
Quantity = tuple[str, Form, Callable[[dict[str, Any]], float]]


def compared(found: Sequence[dict[str, Any]], *keys: str, quantities: Sequence[Quantity]) -> str:
    """A table of each quantity: means over seeds, a line for values of `keys` and a column for each variant."""
    parts, heads = [], [*(HEADS.get(key, key) for key in keys), *VARIANTS.values()]
    for what, form, value in quantities:
        lines = []
        for group, some in sorted(grouped(found, *keys).items()):
            means = [float(np.mean([value(one) for one in some if one["variant"] == name])) for name in VARIANTS]
            lines.append(
                [part if isinstance(part, str) else f"{part:g}" for part in group] + list(map(form.bare, means))
            )
        parts += [f"{what} [{form.unit or '-'}]:", grid(heads, lines, " --- |")]
    return "\n\n".join(parts)


def mean_of(found: Sequence[dict[str, Any]]) -> str:
    """The seeds in words."""
    known = sorted({one["seed"] for one in found if one["seed"] is not None})
    return seeds(known) if len(known) == 1 else f"means of {seeds(known)}"


def finest(part: str) -> list[dict[str, Any]]:
    """Results of a part for the most cells; numbers of elements a wave to one digit."""
    found = FOUND.at(part)
    some = [one for one in found if one["count"] == max(one["count"] for one in found)]
    return [one | {"elements": round(one["elements"], 1)} if "elements" in one else one for one in some]


def thin_bodies(body: str) -> list[dict[str, Any]]:
    return [one for one in FOUND.at("thin") if one["body"] == body]


def moduli() -> Rows:
    ours = [one for one in FOUND.at("moduli") if one["variant"] == OURS]
    for (count, nu), mine in sorted(grouped(ours, "count", "nu").items()):
        for part, words in (("bulk", "periodic cell"), ("bar", "bar")):
            where = f"{words}, {count} cells, ν = {nu:g}"
            yield Row(f"{where}: error of E", FOUND.of(*(one[part]["E"] - 1.0 for one in mine)), AtMost(E_LIMIT),
                FINE)  # fmt: skip
            yield Row(f"{where}: ν less that entered", FOUND.of(*(one[part]["nu"] - nu for one in mine)),
                AtMost(NU_LIMIT), DIFFERENCE)  # fmt: skip


def thin() -> Rows:
    ours = [one for one in FOUND.at("thin") if one["variant"] == OURS]
    for (body, thick, nu), mine in grouped(ours, "body", "thick", "nu").items():
        yield Row(f"{body}, {thick} cell{'s' * (thick > 1)} thick, ν = {nu:g}: errors of frequencies",
            FOUND.of(*(error for one in mine for error in one["errors"])), AtMost(FREQUENCY_LIMIT),
            SIGNED)  # fmt: skip


MODULI: tuple[Quantity, ...] = (
    ("Periodic cell: error of E", FINE, lambda one: one["bulk"]["E"] - 1.0),
    ("Periodic cell: error of ν", DIFFERENCE, lambda one: one["bulk"]["nu"] - one["nu"]),
    ("Bar: error of E", FINE, lambda one: one["bar"]["E"] - 1.0),
    ("Bar: error of ν", DIFFERENCE, lambda one: one["bar"]["nu"] - one["nu"]),
    ("Bar: tractions off σ n", PERCENT, lambda one: one["bar"]["traction"]),
    ("Bar: scatter of the stress of cells", PERCENT, lambda one: one["bar"]["stress"]),
)
STRIP: tuple[Quantity, ...] = (("First bending of the strip", SIGNED, lambda one: one["errors"][0]),)
SHEET: tuple[Quantity, ...] = (
    ("Twist of the sheet", SIGNED, lambda one: one["errors"][0]),
    ("First bending of the sheet", SIGNED, lambda one: one["errors"][1]),
    ("Second bending of the sheet", SIGNED, lambda one: one["errors"][2]),
)
FREE: tuple[Quantity, ...] = (
    ("Mean error", SIGNED, lambda one: float(np.mean(one["errors"]))),
    ("Largest error", PERCENT, lambda one: float(np.abs(one["errors"]).max())),
)
WAVES: tuple[Quantity, ...] = (
    ("Error of the celerity, by elements per wave", SIGNED, lambda one: one["ratio"] - 1.0),
)
