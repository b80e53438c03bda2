"""Functions of upper layers that objects of lower layers call; `bondem/__init__.py` sets them."""

from collections.abc import Callable
from typing import Any


class Outlets:
    """Functions that draw and write, as attributes; each loads its module at the first call."""

    bars: Callable[..., Any]
    draw_lattice: Callable[..., Any]
    draw_model: Callable[..., Any]
    draw_result: Callable[..., Any]
    draw_surface: Callable[..., Any]
    write_csv: Callable[..., Any]


OUTLETS = Outlets()
