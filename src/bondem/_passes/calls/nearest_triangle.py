"""Passes that Python calls, of `core/passes/surface/nearest_triangle.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.surface_tables import Nearest, TriangleTree


def find_nearest_triangles(triangle_tree: TriangleTree, nearest: Nearest) -> Call:
    """Finds the nearest triangle of each point."""
    return Call("find_nearest_triangles", (triangle_tree, nearest))
