"""Check that spheres fill the shape that is given with them.

Sections, volumes and walls are taken from the shape. If the spheres fill another shape, stresses, densities and
moduli are wrong without any sign of it.
"""

import math

import numpy as np

from bondem._checks import shown
from bondem._names import warn_user
from bondem._types import PerElement, PerElement3
from bondem.errors import FillingWarning, InputError
from bondem.geometry.elementary_shapes import BoundingBox, Box, Shape

# Distances over the mean radius: of a centre outside; by which a sphere sticks out, as it does from soft walls; of
# the nearest sphere from a face; and between neighbours along an axis of a periodic cell.
_OUTSIDE, _OUT, _AWAY, _APART = 0.1, 0.1, 0.5, 2.5
# Gap that is tolerated over the extent of the shape, as in fine dust, and times n, as in a gas of n spheres.
_SHARE, _DILUTE = 0.005, 4.0
# Largest share of centres, or of the volume of a part, outside; and number of spheres that stick out over n^(2/3).
_STRAY, _MANY = 0.01, 0.4
_POINTS = 32  # along each edge of a part, of a grid that measures how much of it lies outside


def check_filling(shape: Shape, position: PerElement3, radius: PerElement) -> None:
    """Check that spheres with centres (n, 3) and radii (n,) [m] fill a shape.

    A `FillingWarning` is given for spheres that stick out of the shape or leave parts of it empty.

    Raises:
        InputError: More than 1 % of the centres lie outside the shape.
    """
    if isinstance(shape, BoundingBox):
        return
    mean = float(radius.mean())
    if shape.faces:
        depth = shape.depth(position)
        outside = int((depth < -_OUTSIDE * mean).sum())
        if outside > _STRAY * len(radius):
            raise InputError(
                f"{outside} of {len(radius)} centres lie outside the given shape, a {type(shape).__name__}, by"
                f" up to {-depth.min():.3g} m; {_extents(shape, position, radius)}: check its size, place and units"
                " (metres), or leave out shape="
            )
        out = radius - depth
        sticking = int((out > _OUT * mean).sum())
        if sticking > _MANY * len(radius) ** (2.0 / 3.0):
            _warn(
                f"{sticking} of {len(radius)} spheres stick out of the given shape, a {type(shape).__name__},"
                f" by up to {out.max():.3g} m, {out.max() / mean:.2g} mean radii; {_extents(shape, position, radius)}"
            )
    empty = unfilled(shape, position, radius)
    if empty:
        more = f" (and {len(empty) - 1} more such)" if len(empty) > 1 else ""
        _warn(f"{empty[0]}{more}; {_extents(shape, position, radius)}")


def check_within(part: Shape, whole: Shape, radius: PerElement) -> None:
    """Raise InputError if more than 1 % of a shape to carve lies outside the shape of a body with radii (n,) [m]."""
    lower, upper = part.bounds
    x = lower + (upper - lower) * (np.indices((_POINTS,) * 3).reshape(3, -1).T + 0.5) / _POINTS
    walled = whole if whole.period is None else Box(tuple(whole.period))
    outside = walled.depth(x[part.depth(x) > 0.0]) < -_OUTSIDE * radius.mean()
    if outside.sum() > _STRAY * len(outside):
        advice = "lattice.envelope() & shape" if walled is whole else "a smaller shape, or one that is moved"
        raise InputError(
            f"carve: shape = {shown(part)}: {100.0 * outside.mean():.2g} % of its volume lies outside the body,"
            f" {shown(whole)}; give the part within it, {advice}"
        )


def unfilled(shape: Shape, position: PerElement3, radius: PerElement, *, away: float = _AWAY) -> list[str]:
    """Describe the empty parts of a shape, at faces or across a periodic cell, one sentence each, the widest first.

    Args:
        shape: shape to be filled.
        position: centres [m], shape (n, 3).
        radius: radii [m], shape (n,).
        away: largest distance of a face from the nearest sphere, in mean radii [-].
    """
    mean, found, n = float(radius.mean()), dict[str, float](), len(radius)
    lower, upper = shape.bounds
    least = max(_SHARE, _DILUTE / n) * float((upper - lower).max())
    for face in shape.faces:
        gap = float((shape.face_depth(face, position) - radius).min())
        if gap > max(away * mean, least):
            found[
                f"no sphere is nearer to the face '{face}' of the {type(shape).__name__} than {gap:.3g} m,"
                f" {gap / mean:.2g} mean radii: the shape is larger than the body of spheres"
            ] = gap
    if shape.period is not None:
        for axis, edge in enumerate(shape.period):
            along = np.sort(np.mod(position[:, axis], edge))
            gap = float(np.diff(along, append=along[0] + edge).max())
            if gap > max(_APART * mean, least * (1.0 + math.log(n))):
                found[
                    f"{gap:.3g} m of the periodic cell are empty along {'xyz'[axis]}, {gap / mean:.2g} mean"
                    " radii: the cell is larger than the body of spheres"
                ] = gap
    return sorted(found, key=lambda reason: -found[reason])


def _extents(shape: Shape, position: PerElement3, radius: PerElement) -> str:
    lower, upper = shape.bounds
    low, high = (position - radius[:, None]).min(axis=0), (position + radius[:, None]).max(axis=0)
    spans = [", ".join(f"{a:.4g} … {b:.4g}" for a, b in zip(*ends, strict=True)) for ends in
             ((low, high), (lower, upper))]  # fmt: skip
    return f"spheres span {spans[0]} m, the shape {spans[1]} m"


def _warn(text: str) -> None:
    warn_user(f"{text}; give the shape that the spheres fill", FillingWarning)
