"""Common style of all figures: colours for colour-blind readers and units on every axis."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from matplotlib import rc_context
from matplotlib.figure import Figure

from bondem.laws.catalogue import LAWS

INK = "#1f2933"
GREY = "#8a96a3"
PALE = "#e4e9ee"
BLUE = "#0b6fa4"
ORANGE = "#d55e00"
GREEN = "#00896b"
PURPLE = "#8a5a9c"
#: Two-sided colour scale about a neutral value.
DIVERGING = "RdBu_r"
#: One-sided colour scale.
SEQUENTIAL = "cividis"

# Of the laws in the order of the catalogue, from the start again where there are more.
_LAW_COLOURS = (BLUE, PURPLE, ORANGE, GREEN, GREY, INK)

_SETTINGS: Any = {
    "font.family": "DejaVu Sans",
    "font.size": 9.5,
    "axes.titlesize": 10.5,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.titlepad": 8.0,
    "axes.labelcolor": INK,
    "axes.edgecolor": GREY,
    "axes.linewidth": 0.8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.formatter.use_mathtext": True,
    "axes.formatter.limits": (-3, 4),
    "grid.color": PALE,
    "grid.linewidth": 0.8,
    "text.color": INK,
    "xtick.color": INK,
    "ytick.color": INK,
    "xtick.major.width": 0.8,
    "ytick.major.width": 0.8,
    "legend.frameon": False,
    "legend.fontsize": 9.0,
    "lines.linewidth": 1.6,
    "figure.facecolor": "white",
    "savefig.facecolor": "white",
    "mathtext.fontset": "dejavusans",
}
_DOTS_PER_INCH = 160


def law_colour(law: str) -> str:
    """Colour of a bond law in all figures, by the name of its class."""
    return _LAW_COLOURS[list(LAWS).index(law) % len(_LAW_COLOURS)]


@contextmanager
def sheet(
    path: Path, width: float, height: float, rows: int = 1, columns: int = 1, **options: Any
) -> Iterator[tuple[Figure, Any]]:
    """Create a figure in the common style and save it to `path` at the end of the block, without global state.

    Args:
        path: PNG to write.
        width, height: size of the figure [inch].
        rows, columns: shape of the grid of axes; a figure with 0 columns has no axes at first.
        options: options of `Figure.subplots`.
    """
    with rc_context(_SETTINGS):
        figure = Figure(figsize=(width, height), dpi=_DOTS_PER_INCH, layout="constrained")
        yield figure, figure.subplots(rows, columns, **options) if columns else None
        figure.savefig(path, dpi=_DOTS_PER_INCH)
