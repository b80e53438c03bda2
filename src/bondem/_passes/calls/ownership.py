"""Passes that Python calls, of `core/passes/tessellation/ownership.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.tessellation_tables import Dividing, PolygonBuffer, Solids


def divide_solids(
    solids: Solids, dividing: Dividing, part: PolygonBuffer, spare: PolygonBuffer, pile: PolygonBuffer
) -> Call:
    """Divides solids among elements, each point to the element of least power x² - R²."""
    return Call("divide_solids", (solids, dividing, part, spare, pile))
