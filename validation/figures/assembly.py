"""E and ν over the number of elements, their scatter, and the specimens (André et al. 2012, figs 17 and 18)."""

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib import colormaps
from matplotlib.colors import Normalize

from bondem.report.spheres import View, render
from bondem.report.style import BLUE, GREEN, GREY, ORANGE, SEQUENTIAL, sheet
from bondem.specimen.lattice import Lattice
from validation.figures.axes import draw_means
from validation.figures.packing_curves import NAMES
from validation.frame.files import column
from validation.measures.limit import Limit

Row = Mapping[str, Any]

_STYLES = {"contacts": (BLUE, "o"), "jamming": (ORANGE, "s")}
_DOTTED = (0, (1, 1.5))
_VIEW = View(azimuth=math.radians(28.0), elevation=math.radians(24.0))
_PIXELS = 420


def draw_assembly(path: Path, rows: Sequence[Row], limits: Mapping[str, Mapping[str, Limit | None]]) -> None:
    """Figure 17: every packing, means with their scatter, the fit over N, and packings without walls.

    Args:
        path: PNG to write.
        rows: tests without error.
        limits: fits by target, of "E" and "nu".
    """
    with sheet(path, 8.8, 4.2, 1, 2) as (_, axes):
        for ax, name, factor, digits in ((axes[0], "E", 1e-9, 2), (axes[1], "nu", 1.0, 4)):
            for target, (colour, marker) in _STYLES.items():
                bars = [row for row in rows if row["target"] == target and not row["periodic"]]
                cells = [row for row in rows if row["target"] == target and row["periodic"]]
                if not bars:
                    continue
                count, value = column(bars, "count"), factor * column(bars, name)
                fit = limits[target][name]
                ending = "" if fit is None else f"; N → ∞: {factor * fit.value:.{digits}f}"
                ending += "" if fit is None else f" ± {factor * fit.error:.{digits}f}"
                draw_means(ax, count, value, colour, marker, NAMES[target] + ending, joined=False)
                if fit is not None:
                    over = np.geomspace(fit.fewest, count.max(), 100)
                    ax.plot(over, factor * fit.at(over), color=colour, linewidth=1.2)
                if cells:
                    free = factor * column(cells, name).mean()
                    ax.axhline(free, color=colour, linestyle=_DOTTED, linewidth=1.5,
                               label=f"periodic cell: {free:.{digits}f}")  # fmt: skip
            ax.set(xscale="log", xlabel="number of elements N")
            low, high = ax.get_ylim()
            ax.set_ylim(low, high + 0.35 * (high - low))
            ax.legend(loc="upper right", fontsize=7.5)
        axes[0].set(ylabel="E [GPa]", title="(a) Young's modulus")
        axes[1].set(ylabel="Poisson's ratio ν [-]", title="(b) Poisson's ratio")


def draw_scatter(
    path: Path, rows: Sequence[Row], scatter: Mapping[str, Mapping[str, Mapping[str, float | None]]],
    printed: Mapping[str, tuple[float, float]],
) -> None:  # fmt: skip
    """Left, the scatter of packings of one size over N; right, that of all large ones beside what is in print.

    Args:
        path: PNG to write.
        rows: of bars at the first target.
        scatter: by target, of "E", "nu", "E_paper" and "nu_paper": "c" and, of large packings, "std" and
            "peak_to_peak".
        printed: scatter of E and ν in print [-], by whose.
    """
    first = next(iter(scatter))
    with sheet(path, 9.2, 3.0 + 0.9 * len(scatter), 1, 2) as (_, (left, right)):
        count = column(rows, "count")
        size = np.unique(count)
        over = np.geomspace(size.min(), size.max(), 50)
        for name, label, colour, marker in (("E", "E", BLUE, "o"), ("nu", "ν", GREEN, "s")):
            value = column(rows, name)
            groups = [value[count == one] for one in size]
            sd = [100.0 * group.std(ddof=1) / abs(group.mean()) if len(group) > 1 else math.nan for group in groups]
            left.plot(size, sd, marker, color=colour, markersize=4.5, label=f"{label}, packings of one size")
            c = scatter[first][name]["c"]
            if c is not None:
                left.plot(over, 100.0 * c / np.sqrt(over), color=colour, linewidth=1.2,
                          label=rf"{c:.2f} / $\sqrt{{N}}$")  # fmt: skip
        left.set(xscale="log", yscale="log", xlabel="number of elements N", ylabel="standard deviation / mean [%]",
                 title=f"(a) {NAMES[first]}")  # fmt: skip
        low, high = left.get_ylim()
        ticks = [tick for tick in (0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0) if low <= tick <= high]
        left.set_yticks(ticks, [f"{tick:g}" for tick in ticks])
        left.set_yticks([], minor=True)
        left.legend(fontsize=8.0)
        bars = [(name, 100.0 * E, 100.0 * nu, GREY) for name, (E, nu) in reversed(list(printed.items()))]
        for target, found in scatter.items():
            for names, key, words in (
                (("E_paper", "nu_paper"), "peak_to_peak", "largest − smallest, eqs (14), (15)"),
                (("E", "nu"), "peak_to_peak", "largest − smallest, affine fit"),
                (("E", "nu"), "std", "standard deviation, affine fit"),
            ):
                E, nu = (found[name][key] for name in names)
                if E is not None and nu is not None:
                    bars.append((f"{NAMES[target]}:\n{words}", 100.0 * E, 100.0 * nu, _STYLES[target][0]))
        for row, (_, E, nu, colour) in enumerate(bars):
            for offset, value, symbol in ((-0.18, E, "E"), (0.18, nu, "ν")):
                right.barh(row + offset, value, height=0.34, color=colour, alpha=1.0 if symbol == "E" else 0.6)
                right.text(value + 0.3, row + offset, f"{symbol}  {value:.2g} %", fontsize=7.5, va="center")
        right.set_yticks(range(len(bars)), [bar[0] for bar in bars], fontsize=7.5)
        right.invert_yaxis()
        right.grid(axis="y", visible=False)
        right.set(xlabel="scatter / mean [%]", title="(b) more than 7500 elements", xlim=(0.0, 34.0))


def draw_fineness(path: Path, lattices: Sequence[Lattice]) -> None:
    """Figure 18: specimens of increasing fineness, coloured by radius over mean radius.

    Args:
        path: PNG to write.
        lattices: of bars, ever finer.
    """
    norm = Normalize(0.85, 1.15)
    with sheet(path, 5.2, 0.2 + 1.4 * math.ceil(len(lattices) / 2), math.ceil(len(lattices) / 2), 2,
               squeeze=False) as (_, axes):  # fmt: skip
        for ax in axes.flat:
            ax.axis("off")
        for ax, lattice in zip(axes.flat, lattices, strict=False):
            particles = lattice.particles
            colour = colormaps[SEQUENTIAL](norm(particles.radius / particles.mean_radius))[:, :3]
            ax.imshow(render(particles.position, particles.radius, colour, view=_VIEW, width=2 * _PIXELS),
                      interpolation="lanczos")  # fmt: skip
            ax.set_title(f"{len(particles)} elements")
