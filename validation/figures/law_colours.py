"""Colours of bond laws in figures."""

from bondem.interactions.law_catalogue import LAWS
from bondem.report.style import BLUE, GREEN, GREY, INK, ORANGE, PURPLE

# In the order of the catalogue, from the start again where there are more laws.
_COLOURS = (BLUE, PURPLE, ORANGE, GREEN, GREY, INK)


def law_colour(law: str) -> str:
    """Colour of a bond law in all figures, by the name of its class."""
    return _COLOURS[list(LAWS).index(law) % len(_COLOURS)]
