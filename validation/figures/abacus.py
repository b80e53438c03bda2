"""Calibration curves (André et al. 2012, figs 15 and 16), for every law."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from bondem.calibration.abacus import Curve
from bondem.interactions.law_catalogue import DEFAULT, LAWS, PARAMETERS, named
from bondem.report.style import BLUE, GREY, INK, ORANGE, sheet
from validation.figures.law_colours import law_colour

_MARKS = ("o", "s")
# ν of materials that the reach is held against.
_MATERIALS = (
    ("fused silica", 0.17), ("concrete", 0.20), ("soda-lime glass", 0.23), ("granite", 0.25), ("steel", 0.29),
)  # fmt: skip


def draw_abacus(path: Path, curves: Mapping[str, Mapping[str, Curve]], silica: Mapping[str, float]) -> None:
    """Figures 15 and 16 of each law: ν above, E/E_μ below, over the parameter that sets ν.

    Args:
        path: PNG to write.
        curves: by shape, then by law.
        silica: the paper's "nu", "radius_ratio", "E" and "E_mu".
    """
    laws = list(next(iter(curves.values())))
    shared: dict[str, Any] = {"squeeze": False, "sharey": "row", "sharex": "col"}
    with sheet(path, 1.2 + 2.7 * len(laws), 5.8, 2, len(laws), **shared) as (_, axes):
        for column, law in enumerate(laws):
            top, bottom = axes[:, column]
            for (shape, found), marker in zip(curves.items(), _MARKS, strict=False):
                if law in found:
                    own, filled = found[law], marker == _MARKS[0]
                    face = law_colour(law) if filled else "white"
                    for ax, mean, std in (
                        (top, own.nu, own.nu_std), (bottom, own.stiffness_ratio, own.stiffness_ratio_std)
                    ):  # fmt: skip
                        ax.errorbar(own.values, mean, yerr=np.nan_to_num(std), color=law_colour(law), marker=marker,
                                    markersize=4.0, markerfacecolor=face, capsize=2.0, elinewidth=0.9, linewidth=1.2,
                                    linestyle="-" if filled else (0, (3, 2)), label=shape)  # fmt: skip
            first = next(found[law] for found in curves.values() if law in found)
            fixed = ", ".join(f"{PARAMETERS[name].tex} = {value:g}" for name, value in first.fixed.items())
            top.set_title(named(law) + (f" ({fixed})" if fixed else ""))
            top.axhline(silica["nu"], color=INK, linewidth=0.9, linestyle=(0, (1, 1.5)), label="silica, ν = 0.17")
            if law == DEFAULT.__name__:
                _mark_paper(top, silica["radius_ratio"], silica["nu"], "the paper, r̃ = 0.71")
                _mark_paper(bottom, silica["radius_ratio"], silica["E"] / silica["E_mu"], "72.5 / 265 GPa")
            free = LAWS[law].free
            bottom.set(xlabel=free.label, xscale=free.scale, yscale="log")
            top.legend(fontsize=7.0, loc="lower right" if first.nu[-1] > first.nu[0] else "upper right")
        axes[0, 0].set_ylabel("Poisson's ratio ν [-]")
        axes[1, 0].set_ylabel(r"$E\,/\,E_\mu$ [-]")


def _mark_paper(ax: Axes, x: float, y: float, label: str) -> None:
    ax.plot([x], [y], "*", color=INK, markersize=11, markeredgecolor="white", zorder=5, linestyle="none", label=label)


def draw_reach(path: Path, curves: Mapping[str, Mapping[str, Curve]]) -> None:
    """Which ν each law reaches, and what E/E_μ it then has.

    Args:
        path: PNG to write.
        curves: by shape, then by law.
    """
    with sheet(path, 9.0, 4.2, 1, 2) as (_, (left, right)):
        laws = list(next(iter(curves.values())))
        for name, nu in _MATERIALS:
            left.plot([nu, nu], [-0.6, len(laws)], color=GREY, linewidth=0.9, linestyle=(0, (1, 1.5)))
            left.text(nu, -0.7, name, rotation=90, fontsize=7.0, color=INK, ha="center", va="bottom")
        for row, law in enumerate(laws):
            for found, marker in zip(curves.values(), _MARKS, strict=False):
                if law not in found:
                    continue
                own, filled = found[law], marker == _MARKS[0]
                low, high = own.reach
                left.barh(row + (-0.17 if filled else 0.17), high - low, left=low, height=0.3,
                          color=law_colour(law), alpha=1.0 if filled else 0.45)  # fmt: skip
                for value, side in ((low, "right"), (high, "left")) if filled else ():
                    left.text(value + (0.006 if side == "left" else -0.006), row - 0.17,
                              f"{value:.3f}".replace("-", "−"), fontsize=7.5, va="center", ha=side)  # fmt: skip
                right.plot(own.nu, own.stiffness_ratio, color=law_colour(law), marker=marker, markersize=3.5,
                           linestyle="-" if filled else (0, (3, 2)), linewidth=1.3,
                           markerfacecolor=law_colour(law) if filled else "white",
                           label=named(law) if filled else None)  # fmt: skip
        left.set_yticks(range(len(laws)), [named(law) for law in laws])
        lowest = min(own.reach[0] for found in curves.values() for own in found.values())
        left.set_xlim(min(lowest - 0.08, 0.0), 0.5)
        left.set_ylim(len(laws) - 0.4, -0.75 - 0.5 * len(laws))
        left.grid(axis="y", visible=False)
        left.set(xlabel="Poisson's ratio ν [-]", title="what a law reaches")
        right.set(xlabel="Poisson's ratio ν [-]", ylabel=r"$E\,/\,E_\mu$ [-]", yscale="log", title="how stiff it is")
        if len(curves) > 1:
            right.plot([], [], color=INK, linestyle=(0, (3, 2)), marker="s", markersize=3.5, markerfacecolor="white",
                       label=list(curves)[1])  # fmt: skip
        right.legend(fontsize=8.0, loc="lower left")


def draw_silica(path: Path, curves: Mapping[str, Curve], silica: Mapping[str, float]) -> None:
    """Figures 15 and 16 as the paper has them: r̃ from ν of fused silica, then E_μ from its E.

    Args:
        path: PNG to write.
        curves: of Euler–Bernoulli bonds, by shape.
        silica: the paper's "nu", "radius_ratio", "E" [Pa] and "E_mu" [Pa].
    """
    with sheet(path, 8.6, 3.9, 1, 2) as (_, (left, right)):
        for (shape, own), colour, marker in zip(curves.items(), (BLUE, ORANGE), _MARKS, strict=False):
            value = own.value_for(silica["nu"])
            ratio = None if value is None else own.stiffness_ratio_at(value)
            ours = "" if value is None else f": r̃ = {value:.3f}"
            left.plot(own.values, own.nu, color=colour, marker=marker, markersize=4.0, label=shape + ours)
            if value is None or ratio is None:
                continue
            left.plot([value, value], [0.0, silica["nu"]], color=colour, linewidth=0.9, linestyle=(0, (3, 2)))
            E_mu = np.array([0.0, 400e9])
            right.plot(E_mu / 1e9, ratio * E_mu / 1e9, color=colour,
                       label=f"{shape}: $E_\\mu$ = {silica['E'] / ratio / 1e9:.0f} GPa")  # fmt: skip
            right.plot(silica["E"] / ratio / 1e9, silica["E"] / 1e9, marker, color=colour, markersize=5.0)
        left.axhline(silica["nu"], color=GREY, linewidth=0.9)
        right.axhline(silica["E"] / 1e9, color=GREY, linewidth=0.9)
        _mark_paper(left, silica["radius_ratio"], silica["nu"], "the paper: r̃ = 0.71")
        _mark_paper(right, silica["E_mu"] / 1e9, silica["E"] / 1e9, r"the paper: $E_\mu$ = 265 GPa")
        left.set(xlabel="r̃ [-]", ylabel="Poisson's ratio ν [-]", title="figure 15: r̃ from ν = 0.17", xlim=(0.0, 1.05))
        left.set_ylim(bottom=0.0)
        right.set(xlabel=r"$E_\mu$ [GPa]", ylabel="E [GPa]", title="figure 16: bond modulus from E = 72.5 GPa",
                  xlim=(0.0, 400.0))  # fmt: skip
        right.set_ylim(bottom=0.0)
        left.legend(fontsize=8.0)
        right.legend(fontsize=8.0, loc="upper left")
