"""Division of surfaces into patches: faces between sharp edges, as in a CAD program.

Neighbouring triangles belong to one patch if the angle between their normals is below a limit. A plane that passes
smoothly into a rounding, as beside a fillet, is a patch of its own if it is at least four times as large as each flat
piece beside it. A very thin triangle, whose normal is a rounding error, joins the triangle beyond its longest side.
"""

from dataclasses import dataclass, replace

import numpy as np

from bondem._indices import components
from bondem._types import Floats, Ints, PerElement, Vector

# Rounding error of corners, as files keep seven digits, and the height of a triangle below which its normal is not
# used, both over the size of the surface.
_DIGITS, _THIN = 2e-7, 3e-6
# Largest angle between coplanar triangles, besides rounding, and mean angle of those of a plane to its normal [rad].
_COPLANAR, _PLANE = 2e-3, 0.02
# Area of a plane over that of the largest flat piece that it passes into smoothly.
_LARGER = 4.0
# Differences of area and place, over those of the surface, that do not change the order of patches.
_TIE = 1e-6


@dataclass(frozen=True, eq=False)
class Patch:
    """A part of a surface: a face between sharp edges, or a solid or group that the file names.

    Attributes:
        name: name that `bd.Face` takes: "patch:1" … from the largest to the smallest, or a name of the file.
        area: area [m²].
        normal: mean outward normal ∫ n dA / area [-], (3,): of length 1 on a plane, 0 on a sphere. A pressure p on
            the patch has the resultant -p · area · normal.
        centre: centroid of the area [m], (3,).
        triangles: indices into the triangles of the surface, (k,).
    """

    name: str
    area: float
    normal: Vector
    centre: Vector
    triangles: Ints

    def __str__(self) -> str:
        n, x = (" ".join(f"{value + 0.0:.4g}" for value in rounded) for rounded in (
            np.round(self.normal, 4), np.round(self.centre, 12),
        ))  # fmt: skip
        return f"Patch({self.name!r}, area={self.area:.4g} m², normal=({n}), centre=({x}) m)"


def joined_sides(triangles: Ints) -> Ints:
    """Return the sides that exactly two triangles share, each as 3 · triangle + number of the side, (m, 2)."""
    edge = np.sort(np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    _, number, count = np.unique(edge, axis=0, return_inverse=True, return_counts=True)
    number = number.ravel()
    order = np.argsort(number, kind="stable")
    return order[count[number[order]] == 2].reshape(-1, 2)


def smooth_patches(vertices: Floats, triangles: Ints, sharp: float) -> tuple[Patch, ...]:
    """Divide a surface at its sharp edges, from the largest patch to the smallest.

    Patches of the same area are ordered by x, y and z of their centroids, so that the numbers do not depend on the
    order of the triangles.

    Args:
        vertices: corners [m], (v, 3).
        triangles: three corners each, (t, 3).
        sharp: angle between normals from which an edge separates patches [rad].
    """
    size = float(np.ptp(vertices, axis=0).max())
    label = _labels(vertices, triangles, sharp, size)
    corner = vertices[triangles]
    area = 0.5 * np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    found = [patch("", np.flatnonzero(label == k), corner, area) for k in range(label.max() + 1)]
    whole = sum(one.area for one in found)
    lower = vertices.min(axis=0)

    def rank(one: Patch) -> tuple[float, ...]:
        return (-round(one.area / whole / _TIE), *np.rint((one.centre - lower) / size / _TIE))

    found.sort(key=rank)
    return tuple(replace(one, name=f"patch:{k}") for k, one in enumerate(found, start=1))


def patch(name: str, chosen: Ints, corner: Floats, area: Floats) -> Patch:
    """Make a patch of triangles `chosen`, (k,), from corners (t, 3, 3) [m] and area vectors (t, 3) [m²] of all."""
    size = np.linalg.norm(area[chosen], axis=1)
    whole = float(size.sum())
    centre = size @ corner[chosen].mean(axis=1) / whole if whole > 0.0 else corner[chosen].mean(axis=(0, 1))
    return Patch(name, whole, area[chosen].sum(axis=0) / max(whole, 1e-300), centre, chosen)


def _labels(vertices: Floats, triangles: Ints, sharp: float, size: float) -> Ints:
    """Return the patch of each triangle, (t,)."""
    corner = vertices[triangles]
    side = np.roll(corner, -1, axis=1) - corner
    length = np.linalg.norm(side, axis=2)
    area = 0.5 * np.cross(side[:, 0], side[:, 1])
    content = np.linalg.norm(area, axis=1)
    height = 2.0 * content / np.maximum(length.max(axis=1), 1e-300)
    thin = height < _THIN * size
    joined = joined_sides(triangles)
    pairs = joined // 3
    # sides that are the longest of a thin triangle
    beyond = (thin[pairs] & (length.argmax(axis=1)[pairs] == joined % 3)).any(axis=1)
    turn = np.where(thin[pairs].any(axis=1), np.inf, _angles(area / np.maximum(content, 1e-300)[:, None], pairs))
    rounding = (_DIGITS * size / np.maximum(height, _THIN * size))[pairs].sum(axis=1)
    piece = components(pairs[beyond | (turn < _COPLANAR + rounding)], len(triangles))
    smooth = beyond | (turn < sharp)
    plane = _planes(piece, content, area, thin, piece[pairs[smooth]])
    between = piece[pairs]
    apart = (between[:, 0] != between[:, 1]) & plane[between].any(axis=1)
    return components(pairs[smooth & ~apart], len(triangles))


def _angles(normal: Floats, pairs: Ints) -> PerElement:
    a, b = normal[pairs[:, 0]], normal[pairs[:, 1]]
    return np.arctan2(np.linalg.norm(np.cross(a, b), axis=1), (a * b).sum(axis=1))


def _planes(piece: Ints, content: Floats, area: Floats, thin: np.ndarray, beside: Ints) -> np.ndarray:
    """Return a mask of the flat pieces that become patches of their own, (pieces,).

    These consist of several triangles, are flat as a whole, and are at least four times as large as each piece that
    they pass into smoothly.
    """
    count = piece.max() + 1
    own = np.bincount(piece, weights=content, minlength=count)
    whole = np.stack([np.bincount(piece, weights=part, minlength=count) for part in area.T], axis=1)
    even = np.linalg.norm(whole, axis=1) >= np.cos(_PLANE) * own
    several = np.bincount(piece[~thin], minlength=count) > 1
    largest = np.zeros(count)
    other = beside[beside[:, 0] != beside[:, 1]]
    for a, b in (other.T, other.T[::-1]):
        np.maximum.at(largest, a, own[b])
    return even & several & (own >= _LARGER * largest)
