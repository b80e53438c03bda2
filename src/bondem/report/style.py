"""Common style of all figures: colours for colour-blind readers and units on every axis."""

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.cm import ScalarMappable
from matplotlib.figure import Figure
from matplotlib.ticker import ScalarFormatter
from PIL import Image, ImageChops

from bondem._types import Floats
from bondem.io.atomic import replacing

INK = "#1f2933"
GREY = "#8a96a3"
PALE = "#e4e9ee"
BLUE = "#0b6fa4"
ORANGE = "#d55e00"
AMBER = "#e0a30b"
GREEN = "#00896b"
PURPLE = "#8a5a9c"
#: Two-sided colour scale about a neutral value.
DIVERGING = "RdBu_r"
#: One-sided colour scale.
SEQUENTIAL = "cividis"


#: Settings of matplotlib in which every figure is drawn.
SETTINGS: Any = {
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
_DOTS_PER_INCH = 220
# Empty rows above and below a figure [pixels].
_MARGIN = 12
# Width of a figure for a phone, and the least height of its panels [inch].
_NARROW, _LOW = 4.2, 3.4
_for_phones: ContextVar[bool] = ContextVar("for_phones", default=False)


@contextmanager
def narrow() -> Iterator[None]:
    """Draw the figures of this block for phones, with their panels in one column."""
    token = _for_phones.set(True)
    try:
        yield
    finally:
        _for_phones.reset(token)


def for_phones() -> bool:
    """Return True while figures are drawn for phones."""
    return _for_phones.get()


def legend_columns(wide: int, phone: int = 1) -> int:
    """Return the number of columns of a legend below a figure: `phone` for phones, else `wide`."""
    return phone if for_phones() else wide


@contextmanager
def sheet(
    path: Path, width: float, height: float, rows: int = 1, columns: int = 1, **options: Any
) -> Iterator[tuple[Figure, Any]]:
    """Yield a figure in the common style and its axes, and save the figure to `path` at the end of the block.

    Within `narrow()` a wider figure is 4.2 inches wide, with its panels in one column; the array of axes keeps its
    shape.

    Args:
        path: PNG to write.
        width, height: size of the figure [inch].
        rows, columns: shape of the grid of axes; a figure with 0 columns has no axes at first.
        options: options of `Figure.subplots`.
    """
    with rc_context(SETTINGS):
        slim = _for_phones.get() and width > _NARROW
        if slim:
            low = min(height / rows, _LOW) if columns else 0.0
            least = max(height / rows * _NARROW * max(columns, 1) / width, low)
            width, height = _NARROW, least * rows * max(columns, 1)
        figure = Figure(figsize=(width, height), dpi=_DOTS_PER_INCH, layout="constrained")
        axes = None
        if columns:
            axes = _column(figure, rows, columns, options) if slim else figure.subplots(rows, columns, **options)
        yield figure, axes
        _set_plain_ticks(figure)
        canvas = FigureCanvasAgg(figure)
        canvas.draw()
        image = Image.fromarray(np.asarray(canvas.buffer_rgba())[..., :3])
        with replacing(path) as aside:
            _trimmed(image).save(aside, dpi=(_DOTS_PER_INCH, _DOTS_PER_INCH))


def colour_bar(figure: Figure, scale: ScalarMappable, label: str, *, edge: str = "none", **options: Any) -> None:
    """Add a colour bar with a label and an outline of colour `edge`; `options` are those of `Figure.colorbar`."""
    given: dict[str, Any] = {"aspect": 30, "pad": 0.02} | options
    bar = figure.colorbar(scale, **given)
    bar.set_label(label)
    bar.outline.set_edgecolor(edge)


def fit_axes(ax: Axes, drawn: Floats) -> None:
    """Set equal scales, and limits a little beyond drawn points, (k, 2)."""
    margin = 0.02 * np.ptp(drawn, axis=0).max()
    lower, upper = drawn.min(axis=0) - margin, drawn.max(axis=0) + margin
    ax.set(xlim=(lower[0], upper[0]), ylim=(lower[1], upper[1]), aspect="equal")


class _PlainNumbers(ScalarFormatter):
    """Formatter of the numbers of an axis as plain text, where only their common factor is a formula.

    With `axes.formatter.use_mathtext` every number is a formula that looks the same. Parsing formulas takes a third
    of the time of a figure.
    """

    def __call__(self, x: float, pos: int | None = None) -> str:
        return super().__call__(x, pos).removeprefix(r"$\mathdefault{").removesuffix("}$")


def _set_plain_ticks(figure: Figure) -> None:
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            found = axis.get_major_formatter()
            if type(found) is ScalarFormatter:
                plain = _PlainNumbers()
                vars(plain).update(vars(found))
                axis.set_major_formatter(plain)


def _trimmed(image: Image.Image) -> Image.Image:
    """Remove the empty rows at the top and the bottom of a figure, which wide bodies leave."""
    drawn = ImageChops.difference(image, Image.new("RGB", image.size, "white")).getbbox()
    if drawn is None:
        return image
    top, bottom = max(drawn[1] - _MARGIN, 0), min(drawn[3] + _MARGIN, image.height)
    return image.crop((0, top, image.width, bottom))


def _column(figure: Figure, rows: int, columns: int, options: dict[str, Any]) -> Any:
    """Create the axes of a grid in one column; the result has the shape of the grid."""
    passed = {key: value for key, value in options.items() if key not in ("squeeze", "width_ratios", "height_ratios")}
    if columns == 1 and "height_ratios" in options:
        passed["height_ratios"] = options["height_ratios"]
    axes = figure.subplots(rows * columns, 1, squeeze=False, **passed).reshape(rows, columns)
    if not options.get("squeeze", True):
        return axes
    return axes.item() if axes.size == 1 else axes.squeeze()
