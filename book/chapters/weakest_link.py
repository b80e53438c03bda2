"""Strength over volume: Weibull's weakest link."""

from typing import Any

from book.chapter import Figure, Section
from book.forms import Form
from book.results import Measurement, study
from book.row import Row
from book.tolerances import Near

_SEEDS = ",".join(map(str, range(11, 31)))
WEIBULL = study("weibull", {"weibull": "fracture_weibull"}, options=f"--seeds {_SEEDS}")
MEASUREMENTS: tuple[Measurement, ...] = (WEIBULL,)

_RATIO = Form(style=".3f")


def section() -> Section:
    """The section of the chapter on published fracture tests."""
    bars = WEIBULL.at("bars")
    held = [one["over_weakest"] for one in bars if one["bonds"] == "cells" and one["reach"] and not one["energy"]]
    most = max(one["largest_over_weakest"] for one in bars
               if one["bonds"] == "cells" and one["reach"] and not one["energy"])  # fmt: skip
    return Section(
        title="Strength over volume",
        before=(
            "Strengths of bars scatter after Weibull by flaws that set the strength of all facets within 6 mm, two"
            " cells (`bd.Weibull(correlation=)`, [decision 0050](decisions/0050-weakest-link.md)). Mean strengths"
            " are compared with Γ(1 + 1/m) s₀ (V₀/V)^(1/m), within 5 %."
        ),
        rows=tuple(_row(one) for one in bars if one["verdict"] != "shown"),
        after=(
            f"Brittle bars fail at {min(held):.3f} to {max(held):.3f} of their weakest facet on average, {most:.2f}"
            " at most: with m = 5 a bar may stop its first crack, as strengths scatter widely. No weakest link is"
            " expected, and no verdict given, where strengths are independent, because a weak facet breaks alone, and"
            " where the process zone of cracks is longer than the flaws, which averages strengths over its width."
            " Bonds of a packing of spheres carry unequal stresses; its weakest place rarely meets the weakest flaw."
        ),
        figures=(Figure("fracture_weibull.png", "Mean strength over volume; bars are two errors of the mean"),),
    )  # fmt: skip


def _row(one: dict[str, Any]) -> Row:
    """Mean strength of a kind of bar over the weakest link's."""
    unit, factor = ("mm", 1e3) if one["bonds"] == "cells" else ("bonds", 1.0)
    kind = f"flaws reach {factor * one['reach']:g} {unit}" if one["reach"] else "independent strengths"
    soft = f", G_f = {1e-3 * one['energy']:g} kJ/m²" if one["energy"] else ""
    case = (
        f"m = {one['modulus']:g}, {kind}{soft}, {1e9 * one['bar']:.0f} mm³, {one['count']} {one['bonds']},"
        f" {one['runs']} draws: mean strength over the weakest link's"
    )
    ours = WEIBULL.of(one["ratio"], scatter=one["ratio_error"])
    return Row(case=case, paper=1.0, ours=ours, form=_RATIO, tolerance=Near(relative=WEIBULL.at("limit")))
