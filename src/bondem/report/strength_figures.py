"""Tests to failure: curves of all packings, and the first specimen as it broke."""

import math
from pathlib import Path

import numpy as np
from matplotlib import colormaps
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from bondem.observe.turned_vectors import turned_vectors
from bondem.report.cell_pictures import draw_cells
from bondem.report.findings import Examined, Findings
from bondem.report.spheres import View
from bondem.report.style import BLUE, GREY, INK, ORANGE, SEQUENTIAL, sheet
from bondem.specimen.cells.polyhedra import polyhedra

TITLES = {"direct_tension": "Direct tension", "ucs": "Uniaxial compression"}
_VIEW = View(azimuth=math.radians(28.0), elevation=math.radians(24.0))
# Largest opening drawn, over the length of the specimen.
_EXAGGERATED = 0.08


def draw_curves(path: Path, findings: Findings) -> None:
    """Stress over strain of every packing, with the strength that was put in."""
    names = [name for name in TITLES if name in findings.specimens[0].outcomes]
    with sheet(path, 4.1 * len(names) + 0.4, 3.2, 1, len(names), squeeze=False) as (_, axes):
        for ax, name in zip(axes[0], names, strict=True):
            for n, one in enumerate(findings.specimens):
                outcome = one.outcomes[name]
                ax.plot(1e3 * outcome.curves["strain"], outcome.curves["stress"] / 1e6, color=BLUE, alpha=0.8,
                        linewidth=1.2, label="each packing" if n == 0 else None)  # fmt: skip
            theory = findings.specimens[0].outcomes[name].theory
            ax.axhline(theory / 1e6, color=ORANGE, linestyle=(0, (4, 3)), label="put in")
            ax.set(xlabel="strain [10$^{-3}$]", ylabel="stress [MPa]", title=TITLES[name])
            ax.set_ylim(bottom=0.0)
            ax.legend(loc="best")


def draw_broken(path: Path, specimen: Examined) -> None:
    """The broken specimen, its motion exaggerated: cells by what their facets have lost, or by their slip."""
    body = specimen.lattice
    solid = polyhedra(body)
    owner = np.repeat(solid.cell, np.diff(solid.start))
    names = [name for name in TITLES if name in specimen.outcomes]
    with sheet(path, 4.1 * len(names), 3.6, 1, len(names), squeeze=False) as (figure, axes):
        for ax, name in zip(axes[0], names, strict=True):
            curves = specimen.outcomes[name].curves
            slipped = name == "ucs" and float(curves["slip"].max()) > 0.0
            value = 100.0 * curves["slip"] if slipped else curves["damage"]
            norm = Normalize(0.0, float(np.quantile(value, 0.995)) or 1.0)
            arm = solid.vertex - body.centre[owner]
            moved = curves["displacement"][owner] + turned_vectors(curves["orientation"][owner], arm) - arm
            moved -= moved.mean(axis=0)
            reach = max(1.0, _EXAGGERATED * float(np.ptp(body.centre[:, 0])) / float(np.ptp(moved[:, 0])))
            colour = np.asarray(colormaps[SEQUENTIAL](norm(value)))[:, :3]
            draw_cells(ax, solid, colour, view=_VIEW, moved=reach * moved)
            ax.set_title(f"{TITLES[name]}, motion × {reach:.0f}", color=INK)
            bar = figure.colorbar(
                ScalarMappable(norm, SEQUENTIAL), ax=ax, orientation="horizontal", shrink=0.7, aspect=30, pad=0.02
            )
            bar.set_label("plastic slip of the cell [%]" if slipped else "largest damage of its facets, 1 − s [-]")
            bar.outline.set_edgecolor(GREY)  # type: ignore[operator]
