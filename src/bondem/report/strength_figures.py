"""Figures of tests to failure: curves of all packings, and the first broken specimen."""

import math
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from matplotlib import colormaps
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure

from bondem._drawing import enveloping
from bondem._types import Floats
from bondem.labtests.failure_record import TestFigure
from bondem.labtests.failure_tests import FAILURE_TESTS
from bondem.report.crack_pictures import draw_magnified
from bondem.report.findings import Examined, Findings
from bondem.report.spheres import View
from bondem.report.style import BLUE, GREY, INK, ORANGE, SEQUENTIAL, colour_bar, for_phones, legend_columns, sheet
from bondem.specimen.lattice import Lattice

# Largest drawn displacement over the size of the specimen, and magnifications per decade.
_EXAGGERATED, _STEPS = 0.08, (1.0, 2.0, 5.0)
# Largest number of panels in a row.
_COLUMNS = 3


def draw_curves(path: Path, findings: Findings) -> None:
    """Draw the curve of every packing, with the strength of the material and the measured range of peaks."""
    names = broken_in(findings.specimens[0])
    size, margin = ((4.1, 3.2), (0.4, 0.0)) if len(names) > 1 else ((6.2, 3.7), (0.0, 0.0))
    with panels(path, len(names), size, margin=margin) as (figure, axes):
        lines: dict[str, Artist] = {}
        for ax, name in zip(axes, names, strict=True):
            style = FAILURE_TESTS[name].figure_of(findings.specimens[0].outcomes[name].curves)
            (across, along), (up, of) = style.across, style.up
            for n, one in enumerate(findings.specimens):
                outcome = one.outcomes[name]
                x, y = across * outcome.curves["strain"], up * outcome.curves["stress"]
                label = "each specimen" if n == 0 and len(findings.specimens) > 1 else None
                if (np.diff(x) < 0.0).any():  # a quasi-static path with snap-back
                    every = "every failure event" if n == 0 else None
                    ax.plot(x, y, color=BLUE, alpha=0.3, linewidth=0.6, label=every)
                    outer = enveloping(y)
                    x, y, label = x[outer], y[outer], label or "envelope"
                ax.plot(x, y, color=BLUE, alpha=0.8, linewidth=1.4, label=label)
            band = findings.peaks.get(name)
            if band is not None:
                ax.axhspan(up * band[0], up * band[1], color=GREY, alpha=0.3, linewidth=0.0,
                           label=f"peaks measured, {findings.citation}")  # fmt: skip
            theory = findings.specimens[0].outcomes[name].theory
            if math.isfinite(theory) and style.line:
                ax.axhline(up * theory, color=ORANGE, linestyle=(0, (4, 3)), label="strength of the material")
            ax.set(xlabel=f"{style.strain} [{along}]", ylabel=f"{style.stress} [{of}]", title=style.title)
            ax.set_ylim(bottom=0.0)
            lines |= {str(line.get_label()): line for line in ax.get_legend_handles_labels()[0]}
        if lines:
            beside = legend_columns(2 if len(names) > 1 else 1)
            figure.legend(lines.values(), lines.keys(), loc="outside lower center", ncols=beside)


def draw_broken(path: Path, specimen: Examined) -> None:
    """Draw the broken specimen with exaggerated motion, its elements coloured by damage or slip."""
    names = broken_in(specimen)
    with panels(path, len(names), (4.1, 3.6)) as (figure, axes):
        for ax, name in zip(axes, names, strict=True):
            draw_failed(figure, ax, specimen.lattice, specimen.outcomes[name].curves, FAILURE_TESTS[name].figure)


def draw_failed(figure: Figure, ax: Axes, body: Lattice, curves: Mapping[str, Floats], style: TestFigure) -> None:
    """Draw one broken specimen.

    Args:
        figure: figure for the colour bar.
        ax: axes to draw on.
        body: lattice of cells or of bonded spheres.
        curves: "displacement" [m], (n, 3), "orientation", (n, 4), "damage", "slip" and "piece" of elements, (n,).
        style: style of the figure.
    """
    view = view_of(style)
    slipped = style.slips and float(curves["slip"].max()) > 0.0
    value = 100.0 * curves["slip"] if slipped else curves["damage"]
    norm = Normalize(0.0, (float(value.max()) or 1.0) if slipped else 1.0)
    reach = reach_of(body, curves["displacement"])
    colour = np.asarray(colormaps[SEQUENTIAL](norm(value)))[:, :3]
    shown = None
    if style.halved:
        toward = view.axes[2] * (0.0, 1.0, 1.0)
        shown = (body.centre - np.mean(body.particles.envelope.bounds, axis=0)) @ toward < 0.0
    motion = curves["displacement"], curves["orientation"]
    draw_magnified(ax, body, colour, motion, view=view, reach=reach, shown=shown, piece=curves.get("piece"))
    ax.set_title(f"{style.title}, {magnified(reach)}", color=INK)
    damaged = f"largest damage of its {body.elements.bond_name}, 1 − s [-]"
    label = "plastic slip of the cell [%]" if slipped else damaged
    scale = ScalarMappable(norm, SEQUENTIAL)
    colour_bar(figure, scale, label, edge=GREY, ax=ax, orientation="horizontal", shrink=0.7)


def magnified(reach: float) -> str:
    """Format the magnification of motion in a picture."""
    return "true motion" if reach == 1.0 else f"motion × {reach:g}"


def view_of(style: TestFigure) -> View:
    """Return the direction of view of the figures of a test."""
    return View(azimuth=style.azimuth, elevation=style.elevation)


def reach_of(body: Lattice, moved: Floats) -> float:
    """Choose a magnification 1, 2, 5, 10, … [-] for displacements of a specimen [m], (k, 3), in pictures."""
    size, most = float(np.ptp(body.centre, axis=0).max()), float(np.ptp(moved, axis=0).max())
    most_times = _EXAGGERATED * size / most if most > 0.0 else 1.0
    if most_times <= 1.0:
        return 1.0
    decade = 10.0 ** math.floor(math.log10(most_times))
    return decade * max(step for step in _STEPS if step * decade <= most_times)


def broken_in(specimen: Examined) -> list[str]:
    """Return the names of the tests to failure of a specimen, in the order of figures."""
    return [name for name in FAILURE_TESTS if name in specimen.outcomes]


@contextmanager
def panels(
    path: Path, count: int, size: tuple[float, float], *, margin: tuple[float, float] = (0.0, 0.0)
) -> Iterator[tuple[Figure, list[Axes]]]:
    """Yield a figure of panels, up to three in a row, or one for phones, and save it at the end of the block.

    Args:
        path: PNG to write.
        count: number of panels.
        size: width and height of a panel [inch].
        margin: further width and height of the figure [inch].
    """
    columns = 1 if for_phones() else min(count, _COLUMNS)
    rows = math.ceil(count / columns)
    width, height = columns * size[0] + margin[0], rows * size[1] + margin[1]
    with sheet(path, width, height, rows, columns, squeeze=False) as (figure, axes):
        for ax in axes.flat[count:]:
            ax.axis("off")
        yield figure, axes.flat[:count].tolist()
