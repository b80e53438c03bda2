"""Figure of the comparison with Mka3D's variant, from its record: thin bodies, and the stress of cells."""

from pathlib import Path
from typing import Any

import numpy as np

from bondem.report.style import BLUE, GREEN, GREY, INK, ORANGE, sheet

#: Colour, mark, and label of each variant.
VARIANTS = {
    "bondem": (BLUE, "o", "bondem"),
    "bondem, facets with twist": (GREEN, "^", 'bondem, facet_rotation="full"'),
    "balanced shares with facets of Mka3D": (ORANGE, "s", "balanced shares with facets of Mka3D"),
    "Mka3D": (INK, "x", "Mka3D's variant"),
}
#: Filled marks are for the smaller Poisson's ratio.
FILLS = {0.2: "full", 0.4: "none"}


def thin(axis: Any, rows: list[dict[str, Any]], body: str, which: int, title: str) -> None:
    """Mean error of a frequency of unequal cells over the thickness in cells."""
    mine = [one for one in rows if one["body"] == body and one["cells"] == "unequal"]
    for k, (name, (colour, mark, label)) in enumerate(VARIANTS.items()):
        for nu, fill in FILLS.items():
            own = [one for one in mine if (one["variant"], one["nu"]) == (name, nu)]
            thick = sorted({one["thick"] for one in own})
            error = [100.0 * np.mean([one["errors"][which] for one in own if one["thick"] == t]) for t in thick]
            axis.plot(np.array(thick) * 1.03 ** (k - 1.5), error, mark, color=colour, fillstyle=fill, ms=5,
                      ls="-" if nu == 0.2 else ":", lw=0.9, label=label if nu == 0.2 else None)  # fmt: skip
    axis.axhline(0.0, color=GREY, lw=0.8)
    axis.set_xscale("log")
    axis.set_xticks([1, 2, 4], ["1", "2", "4"])
    axis.set_xticks([], minor=True)
    axis.set_xlabel("thickness [cells]")
    axis.set_ylabel("error of the frequency [%]")
    axis.set_title(title)


def scatter(axis: Any, rows: list[dict[str, Any]]) -> None:
    """Scatter of the stress of cells of a pulled bar."""
    count = max(one["count"] for one in rows)
    for k, (name, (colour, mark, _)) in enumerate(VARIANTS.items()):
        for nu, fill in FILLS.items():
            own = [
                one["bar"]["stress"] for one in rows
                if (one["variant"], one["nu"], one["count"], one["cells"]) == (name, nu, count, "Laguerre")
            ]  # fmt: skip
            axis.plot(nu + 0.008 * (k - 1.5) + np.zeros(len(own)), 100.0 * np.array(own), mark, color=colour,
                      fillstyle=fill, ms=5)  # fmt: skip
    axis.set_xticks(list(FILLS), [f"{nu:g}" for nu in FILLS])
    axis.set_xlim(0.1, 0.5)
    axis.set_ylim(0.0, None)
    axis.set_xlabel("ν [-]")
    axis.set_ylabel("scatter over the mean [%]")
    axis.set_title("Stress of cells in a pulled bar")


def draw_variants(kept: dict[str, Any], path: Path) -> None:
    """Thin bodies, and the stress of cells, of a record."""
    with sheet(path, 11.0, 4.0, 1, 3) as (figure, (bending, twist, stress)):
        thin(bending, kept["thin"], "strip", 0, "First bending of a strip")
        thin(twist, kept["thin"], "sheet", 0, "First twist of a sheet")
        scatter(stress, kept["moduli"])
        figure.legend(*bending.get_legend_handles_labels(), loc="outside lower center", ncols=4)
