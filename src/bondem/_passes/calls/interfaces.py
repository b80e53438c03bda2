"""Passes that Python calls, of `core/passes/tessellation/interfaces.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.tessellation_tables import FaceGroups, PolygonBuffer, Solids


def match_faces(
    solids: Solids, groups: FaceGroups, rest: PolygonBuffer, left: PolygonBuffer, pile: PolygonBuffer
) -> Call:
    """Intersects the faces of each group: patches go to the pile, with their face as kind and the face on the
    other side, or -1, as tag.
    """
    return Call("match_faces", (solids, groups, rest, left, pile))
