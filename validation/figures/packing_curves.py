"""Packings over the dispersion of their radii and over their number of spheres (André et al. 2012, figs 7 and 8)."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from bondem.report.style import BLUE, GREEN, GREY, INK, ORANGE, sheet
from validation.figures.axes import draw_means, mean_by
from validation.frame.files import column
from validation.measures.limit import Limit

Row = Mapping[str, Any]

#: What the paper asks of e, eq (11), and the largest value that e can have, all bonds in one of 320 faces.
PRINTED_THRESHOLD = 0.0032
LARGEST_POSSIBLE = 319.0 / 320.0**2

#: Targets of a packing in words.
NAMES = {"jamming": "onset of jamming", "contacts": "6.2 contacts a sphere"}

_STYLES = {"jamming": (BLUE, "o"), "contacts": (ORANGE, "s")}
# The same quantity of the spheres away from the walls, and of spheres without walls.
_DASHED, _DOTTED = (0, (4, 2)), (0, (1, 1.5))
# φ of random close packing, which the paper quotes (ref. 32), and its limit of z.
_CLOSE_PACKING, _PRINTED_CONTACTS = 0.636, 6.2


def draw_dispersion(path: Path, rows: Sequence[Row], *, verdict: float) -> None:
    """Figure 7: e against κ, beside what the paper asks; and the rms excess, on which the verdict rests.

    Args:
        path: PNG to write.
        rows: packings without error.
        verdict: rms excess of the core above which a fabric is refused, but for chance [-].
    """
    kappa = np.array([100.0 * row["spread"] for row in rows])
    with sheet(path, 8.2, 4.0, 1, 2) as (_, (left, right)):
        draw_means(left, kappa, column(rows, "isotropy_error"), BLUE, "o", "packings")
        level, chance = mean_by(kappa, column(rows, "isotropy_error_random"))
        left.plot(level, chance, color=GREEN, linestyle=_DASHED, label="random fabric of as many bonds")
        left.axhline(LARGEST_POSSIBLE, color=INK, linewidth=1.2, label="largest possible, 319/320² = 0.003115")
        left.axhline(PRINTED_THRESHOLD, color=ORANGE, linewidth=2.0, linestyle=(0, (2, 2)),
                     label="threshold in print, 0.0032")  # fmt: skip
        left.set(xlabel="dispersion κ [%]", ylabel="e, eq (11) [-]", yscale="log", title="e as the paper has it")
        left.set_ylim(top=0.01)
        left.legend(loc="center right", bbox_to_anchor=(1.0, 0.6), fontsize=8.0)
        draw_means(right, kappa, column(rows, "rms_excess"), GREY, "s", "all bonds")
        draw_means(right, kappa, column(rows, "core_rms_excess"), BLUE, "o", "away from the walls")
        refused = np.array([not row["passed"] for row in rows])
        if refused.any():
            right.plot(kappa[refused], column(rows, "core_rms_excess")[refused], "x", color=ORANGE, markersize=10,
                       markeredgewidth=2.0, zorder=5, label="refused")  # fmt: skip
        right.axhline(verdict, color=ORANGE, linewidth=1.2, label="limit of the verdict")
        right.set(xlabel="dispersion κ [%]", ylabel="rms deviation beyond chance [-]", title="rms excess")
        right.set_ylim(bottom=0.0)
        right.legend(loc="upper right", fontsize=8.0)


def draw_refinement(path: Path, rows: Sequence[Row], limits: Mapping[str, Mapping[str, Limit | None]]) -> None:
    """Figure 8: volume fraction, coordination number and isotropy against the number of spheres.

    Args:
        path: PNG to write.
        rows: packings without error.
        limits: for each target, the fit of "volume_fraction" and "coordination_number", None where there is none.
    """
    with sheet(path, 8.2, 7.6, 2, 2) as (_, axes):
        (density, contacts), (error, excess) = axes
        for target, (colour, marker) in _STYLES.items():
            own = [row for row in rows if row["target"] == target and not row["periodic"]]
            free = [row for row in rows if row["target"] == target and row["periodic"]]
            if not own:
                continue
            name, count = NAMES[target], column(own, "count")
            for ax, key in ((density, "volume_fraction"), (contacts, "coordination_number")):
                fit = limits.get(target, {}).get(key)
                digits = 4 if ax is density else 3
                ending = "" if fit is None else f"; N → ∞: {fit.value:.{digits}f} ± {fit.error:.{digits}f}"
                draw_means(ax, count, column(own, key), colour, marker, name + ending, joined=False)
                if fit is not None:
                    over = np.geomspace(fit.fewest, count.max(), 100)
                    ax.plot(over, fit.at(over), color=colour, linewidth=1.2)
                if free:
                    ax.axhline(column(free, key).mean(), color=colour, linestyle=_DOTTED, linewidth=1.5)
                ax.plot(*mean_by(count, column(own, f"core_{key}")), color=colour, linestyle=_DASHED, linewidth=1.0)
            draw_means(error, count, column(own, "isotropy_error"), colour, marker, name)
            draw_means(excess, count, column(own, "rms_excess"), colour, marker, name)
            for ax, key in ((error, "isotropy_error_random"), (excess, "core_rms_excess")):
                ax.plot(*mean_by(count, column(own, key)), color=colour, linestyle=_DASHED, linewidth=1.0)
        for ax in (density, contacts):
            ax.plot([], [], color=INK, linestyle=_DOTTED, linewidth=1.5, label="without walls, periodic cell")
            lower, upper = ax.get_ylim()
            ax.set_ylim(lower, upper + 0.25 * (upper - lower))
        for ax, value in ((density, _CLOSE_PACKING), (contacts, _PRINTED_CONTACTS)):
            ax.axhline(value, color=GREY, linewidth=0.8, zorder=0.5, label=f"in print: {value:g}")
        _named(density, "(a) volume fraction", "φ [-]", "away from the walls")
        _named(contacts, "(b) coordination number", "z [-]", "away from the walls")
        _named(error, "(c) isotropy, eq (11)", "e [-]", "random fabric of as many bonds")
        _named(excess, "(d) isotropy, rms excess", "rms deviation beyond chance [-]", "away from the walls")
        error.set_yscale("log")
        excess.set_ylim(bottom=0.0)


def _named(ax: Axes, title: str, label: str, dashed: str) -> None:
    ax.plot([], [], color=INK, linestyle=_DASHED, linewidth=1.0, label=dashed)
    ax.set(xscale="log", xlabel="number of spheres N", ylabel=label, title=title)
    ax.legend(loc="upper right", fontsize=7.5)
