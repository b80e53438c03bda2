"""Formatting of numbers, units and counts for reports."""

import math
from collections.abc import Sequence

from bondem.geometry.elementary_shapes import Ball, Cylinder, Shape
from bondem.labtests.cracking import Cracking

_PREFIXES = {9: "G", 6: "M", 3: "k", 0: "", -3: "m", -6: "µ", -9: "n"}
# Units that take a prefix; values in others, such as kg/m³, are printed with powers of ten if necessary.
_SCALED = ("Pa", "m", "s", "Hz", "m/s", "N", "J", "rad")


def with_unit(value: float | None, unit: str = "", digits: int = 4) -> str:
    """Format a value with a unit: 72.5e9, "Pa" becomes 72.50 GPa; None and nan become a dash."""
    if value is None or not math.isfinite(value):
        return "–"
    if unit in ("-", ""):
        return _significant(value, digits)
    if unit not in _SCALED or value == 0.0:
        return f"{_significant(value, digits)} {unit}"
    exponent = 3 * math.floor(math.log10(abs(value)) / 3.0 + 1e-12)
    exponent = min(max(exponent, -9), 9)
    if unit == "m/s" and 0 <= exponent <= 3:
        exponent = 0
    return f"{_significant(value / 10.0**exponent, digits)} {_PREFIXES[exponent]}{unit}"


def _significant(value: float, digits: int) -> str:
    if value == 0.0:
        return "0"
    if value < 0.0:
        return f"−{_significant(-value, digits)}"
    places = digits - 1 - math.floor(math.log10(abs(value)))
    if -3 <= places <= digits + 2:
        return f"{value:.{max(places, 0)}f}"
    mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
    return f"{mantissa}·10{str(int(exponent)).translate(str.maketrans('-0123456789', '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'))}"


def between(low: float, high: float, unit: str) -> str:
    """Format a range with one unit: "0.933 to 1.114 kN"."""
    shown, _, name = with_unit(high, unit).rpartition(" ")
    factor = float(shown.replace("−", "-")) / high
    return f"{low * factor:.4g} to {high * factor:.4g} {name}"


def off_between(interval: Sequence[float] | None, target: float) -> str:
    """Format an interval as signed percentages off a target: "−0.4 to +1.1 %"; a dash for None."""
    if interval is None:
        return "–"
    low, high = (signed(100.0 * (one / target - 1.0), 2) for one in interval)
    return f"{low} to {high} %"


def area(value: float) -> str:
    """Format an area, given in m², in mm²."""
    return f"{_significant(1e6 * value, 4)} mm²"


def many(count: int, what: str) -> str:
    """Format a count with its noun: "1 piece", "2 pieces"."""
    return f"{count} {what}" if count == 1 else f"{count} {what}s"


def pieces_and_crumbs(cracking: Cracking) -> str:
    """Format the numbers of pieces and crumbs (smaller fragments, see `Cracking`) of a broken specimen."""
    crumbs = f" and {many(cracking.crumbs, 'crumb')}" if cracking.crumbs else ""
    return f"{many(cracking.pieces, 'piece')}{crumbs}"


def in_unit(name: str, value: float | None) -> tuple[str, str]:
    """Split a name such as "peak load [N]" and format its value with the unit: ("peak load", "1.237 kN")."""
    words, _, unit = name.rpartition(" [")
    unit = unit.removesuffix("]")
    return words, with_unit(value, unit, 3 if unit == "%" else 4)


def percent(value: float) -> str:
    """Format a share as a percentage: 0.0663 becomes 6.63 %."""
    return f"{100.0 * value:.2f} %"


def signed_percent(value: float | None, digits: int = 2) -> str:
    """Format a share as a signed percentage: 0.0663 becomes +6.63 %, with a true minus sign; None becomes a dash."""
    return "–" if value is None else f"{signed(100.0 * value, digits)} %"


def signed(value: float, digits: int = 4) -> str:
    """Format a number with its sign: 0.00012 becomes +0.0001; a value that rounds to zero has no sign."""
    text = f"{value:+.{digits}f}"
    return text[1:] if float(text) == 0.0 else text.replace("-", "−")


def measures(shape: Shape) -> str:
    """Format the dimensions of a shape, such as Ø 10 × 40 mm."""
    lower, upper = shape.bounds
    edges = [f"{1e3 * edge:.4g}" for edge in upper - lower]
    if isinstance(shape, Cylinder):
        return f"Ø {edges[1]} × {edges[0]} mm"
    if isinstance(shape, Ball):
        return f"Ø {edges[0]} mm"
    return " × ".join(edges) + " mm"
