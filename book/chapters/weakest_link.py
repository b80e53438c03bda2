"""Strength over volume: Weibull's weakest link."""

from typing import Any

from book.forms import RATIO
from book.results import study
from book.row import Row, Rows
from book.tolerances import Near

_SEEDS = ",".join(map(str, range(11, 31)))
WEIBULL = study("weibull", {"weibull": "fracture_weibull"}, options=f"--seeds {_SEEDS}")
MEASUREMENTS = (WEIBULL,)


def brittle() -> list[dict[str, Any]]:
    """Brittle bars of cells whose flaws reach over several cells."""
    return [one for one in WEIBULL.at("bars") if one["bonds"] == "cells" and one["reach"] and not one["energy"]]


def rows() -> Rows:
    """Mean strengths of kinds of bars over those of the weakest link."""
    for one in WEIBULL.at("bars"):
        if one["verdict"] == "shown":
            continue
        unit, factor = ("mm", 1e3) if one["bonds"] == "cells" else ("bonds", 1.0)
        kind = f"flaws reach {factor * one['reach']:g} {unit}" if one["reach"] else "independent strengths"
        soft = f", G_f = {1e-3 * one['energy']:g} kJ/m²" if one["energy"] else ""
        yield Row(f"m = {one['modulus']:g}, {kind}{soft}, {1e9 * one['bar']:.0f} mm³, {one['count']} {one['bonds']},"
            f" {one['runs']} draws: mean strength over the weakest link's",
            WEIBULL.of(one["ratio"], scatter=one["ratio_error"]), Near(relative=WEIBULL.at("limit")), RATIO,
            paper=1.0)  # fmt: skip
