"""Check of the side of a wall on which elements begin, because a wall touches only elements in front of it."""

from collections.abc import Iterable

import numpy as np

from bondem._types import Floats, PerElement, PerElement3
from bondem.boundary.walls import CylinderWall, PlaneWall, SphereWall, Wall

# Depth of a centre behind a wall, over its radius, from which the element does not merely press on the wall.
_BEHIND = 0.1


def doubts(walls: Iterable[tuple[int, Wall]], position: PerElement3, radius: PerElement) -> list[str]:
    """Return a warning for each wall that no element can touch or, except for discs, that has elements behind it.

    Args:
        walls: walls at their reference places, with their numbers in the model.
        position: centres of the elements [m], (n, 3).
        radius: contact radii of the elements [m], (n,).
    """
    found = []
    for k, wall in walls:
        depth = _in_front(wall, position)
        behind = depth < -_BEHIND * radius
        count, owner = int(behind.sum()), f"walls[{k}]: the {type(wall).__name__}"
        if count == len(depth):
            found.append(f"{owner} faces away from all {count} elements, which cannot touch it; {_turned(wall)}")
        elif count and not (isinstance(wall, PlaneWall) and (wall.outer is not None or wall.inner)):
            found.append(
                f"{owner} has {count} of {len(depth)} elements behind it at the start, up to {-depth.min():.3g} m"
                " deep; move the wall or the body, so that all are in front of it"
            )
    return found


def _in_front(wall: Wall, position: PerElement3) -> Floats:
    """Return the distance of points in front of a wall [m], negative behind it, (n,)."""
    if isinstance(wall, PlaneWall):
        return (position - wall.point) @ np.array(wall.normal)
    if isinstance(wall, SphereWall):
        outward = np.linalg.norm(position - wall.centre, axis=1) - wall.radius
        return -outward if wall.inside else outward
    arm = position - wall.point
    axis = np.array(wall.axis)
    outward = np.linalg.norm(arm - (arm @ axis)[:, None] * axis, axis=1) - wall.radius
    return outward if wall.outside else -outward


def _turned(wall: Wall) -> str:
    """Return advice on how to turn a wall that faces away from all elements."""
    if isinstance(wall, PlaneWall):
        a, b, c = (0.0 - one for one in wall.normal)
        return f"its normal points towards the elements: give normal=({a:.4g}, {b:.4g}, {c:.4g}), or move it"
    if isinstance(wall, CylinderWall):
        return f"give outside={not wall.outside}, or another radius or place"
    return f"give inside={not wall.inside}, or another radius or place"
