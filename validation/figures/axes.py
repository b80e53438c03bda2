"""Axes with few numbers at chosen places."""

from collections.abc import Sequence

from matplotlib.axis import Axis
from matplotlib.ticker import FixedLocator, FormatStrFormatter, NullLocator


def plain_ticks(axis: Axis, places: Sequence[float]) -> None:
    """Numbers at these places of a logarithmic axis and nowhere else, written as they are."""
    axis.set_major_locator(FixedLocator(list(places)))
    axis.set_major_formatter(FormatStrFormatter("%g"))
    axis.set_minor_locator(NullLocator())
