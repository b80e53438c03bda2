"""Passes that Python calls, of `core/passes/tessellation/measures.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.tessellation_tables import Bulk, PolygonMeasures, Solids


def measure_polygons(polygon_measures: PolygonMeasures) -> Call:
    """Computes areas, centroids and second moments of polygons."""
    return Call("measure_polygons", (polygon_measures,))


def measure_solids(solids: Solids, bulk: Bulk) -> Call:
    """Computes volumes, moments and extents of solids about the centre of the element."""
    return Call("measure_solids", (solids, bulk))
