"""Columns of results as curves or bars, with units that suit their values."""

import math
from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes

from bondem._drawing import unit_of
from bondem._types import Floats, Mask
from bondem.report.style import BLUE, GREEN, GREY, ORANGE, PURPLE

# Units that take prefixes, and the prefixes by powers of ten.
_PREFIXED = ("m", "s", "N", "Pa", "J", "Hz", "m/s", "N·m")
_PREFIX = {-12: "p", -9: "n", -6: "µ", -3: "m", 3: "k", 6: "M", 9: "G"}
# Name of an axis of several quantities, by their unit.
_KIND = {"J": "energy", "m": "displacement", "m/s": "velocity"}
# Least number of points of a curve that is drawn as a line; shorter ones are drawn as points.
_FEW = 20


def draw_columns(ax: Axes, drawn: Mapping[str, Floats], outer: Mask | None = None) -> None:
    """Draw columns, named like "load [N]", as curves over the first one, or a single row as bars.

    Where the first column goes back, the rows of `outer` are drawn, above a thin line through all.
    """
    names, values = list(drawn), [np.asarray(one, dtype=float) for one in drawn.values()]
    if len(values[0]) == 1:
        label, factor = _scaled(names[0], np.concatenate(values))
        ax.barh([_quantity(name) for name in names], [factor * one[0] for one in values], color=BLUE)
        ax.set_xlabel(label.removeprefix(_quantity(names[0])).strip())
        return
    colours = (BLUE, ORANGE, GREEN, PURPLE, GREY, "#1f2933", "#b5a400")
    across, by = _scaled(names[0], values[0])
    label, up = _scaled(names[1], np.concatenate(values[1:]))
    marker, line = ("o", "none") if len(values[0]) < _FEW else ("", "-")
    back = outer is not None and bool((np.diff(values[0]) < 0.0).any())
    if back:
        ax.plot(by * values[0], up * values[1], color=BLUE, alpha=0.3, linewidth=0.6, label="every failure event")
        values = [one[outer] for one in values]
    for name, one, colour in zip(names[1:], values[1:], colours, strict=False):
        words = "envelope" if back else _quantity(name)
        ax.plot(by * values[0], up * one, color=colour, label=words, marker=marker, linestyle=line)
    if back:
        ax.legend(loc="best")
    if len(names) > 2:
        label = f"{_KIND.get(unit_of(names[1]), '')} {label.removeprefix(_quantity(names[1])).strip()}".strip()
        ax.legend(loc="best")
    ax.set(xlabel=across, ylabel=label)


def _quantity(column: str) -> str:
    return column.rpartition("[")[0].strip()


def _scaled(column: str, values: Floats) -> tuple[str, float]:
    """Return the name of a column with a unit that suits its values, and the factor of the values."""
    unit, size = unit_of(column), float(np.abs(values[np.isfinite(values)]).max(initial=0.0))
    power = 3 * math.floor(math.log10(size) / 3.0 + 1e-9) if size > 0.0 else 0
    if unit in _PREFIXED and -12 <= power <= 9 and power:
        return f"{_quantity(column)} [{_PREFIX[power]}{unit}]", 10.0**-power
    if unit == "-" and power < -1:
        return f"{_quantity(column)} [10$^{{{power}}}$]", 10.0**-power
    return column, 1.0
