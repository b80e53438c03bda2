"""Check and repair of triangles that must enclose a body: closed, facing outwards, of solids that do not touch.

Files of CAD programs are repaired where the result is unique. Equal corners of several solids are merged. Duplicate
triangles are removed, and so are opposite ones, as between two bodies that share a face.

The winding number decides which solid lies within which (Jacobson et al., ACM Trans. Graph. 32, 2013). It is the
solid angle of a solid seen from points of another, over 4π, and an integer where the surfaces do not touch.
"""

import numpy as np

from bondem._indices import components, inverse
from bondem._types import Floats, Ints, PerElement, PerElement3
from bondem.errors import InputError
from bondem.geometry.smooth_patches import joined_sides

_FARTHEST = 1e30  # largest coordinate of a vertex [m]; volumes of larger ones overflow
# Distance of corners, over the size of the surface, that are merged if this closes an open surface: files keep seven
# digits.
_SAME = 2e-6
# Largest number of pairs of sample and triangle in all winding numbers together, and of samples of a solid.
_PAIRS, _SAMPLES = 4_000_000, 400
# Largest deviation of a winding number from an integer for surfaces that do not touch.
_OFF = 0.1


def closed_surface(name: str, vertices: Floats, triangles: Ints) -> tuple[Floats, Ints, Ints]:
    """Check and repair a closed surface: merge corners, remove duplicate and flat triangles, turn the rest outwards.

    Args:
        name: name of the surface, for messages.
        vertices: corners, (v, 3).
        triangles: three corners each, (t, 3).

    Returns:
        Corners, (w, 3), and triangles, (r, 3), of the repaired surface; rows of `triangles` that remain, (r,).

    Raises:
        InputError: The surface is not closed, encloses nothing, intersects itself at a sample, or has solids that
            overlap, touch or contain others.
    """
    if vertices.ndim != 2 or triangles.ndim != 2 or vertices.shape[1:] != (3,) or triangles.shape[1:] != (3,):
        raise InputError(f"{name}: vertices {vertices.shape}, triangles {triangles.shape}; give (v, 3) and (t, 3)")
    if not np.isfinite(vertices).all() or np.abs(vertices).max(initial=0.0) > _FARTHEST:
        raise InputError(f"{name} has a vertex that is not finite or beyond 1e30 m; export it again")
    if triangles.size and not (triangles.min() >= 0 and triangles.max() < len(vertices)):
        raise InputError(f"{name}: triangles refer to vertices that do not exist; count vertices from 0")
    vertices, triangles, retained = _merged(vertices, triangles, 0.0)
    if len(triangles) and not _is_closed(triangles):
        size = float(np.ptp(vertices, axis=0).max())
        nearer = _merged(vertices, triangles, _SAME * size)
        if _is_closed(nearer[1]):
            vertices, triangles, retained = *nearer[:2], retained[nearer[2]]
    if len(triangles) < 4:
        raise InputError(f"{name} has {len(triangles)} triangles; a closed surface has at least four")
    _require_closed(name, triangles)
    size = float(np.ptp(vertices, axis=0).max())
    # an edge of exactly two triangles joins them to one solid
    part = components(joined_sides(triangles) // 3, len(triangles))
    volume: Floats = np.bincount(part, weights=_cones(vertices, triangles)).astype(float)
    if np.abs(volume).max() <= 1e-12 * size**3:
        raise InputError(f"{name} encloses no volume; close the surface")
    if volume.sum() < 0.0:
        triangles, volume = triangles[:, ::-1], -volume
    if len(volume) > 1:
        turned = _inside_out(name, vertices, triangles, part, volume)
        triangles = np.where(turned[part][:, None], triangles[:, ::-1], triangles)
    _refuse_intersecting(name, vertices[triangles])
    return vertices, np.ascontiguousarray(triangles), retained


def _merged(vertices: Floats, triangles: Ints, tolerance: float) -> tuple[Floats, Ints, Ints]:
    """Merge coincident corners and remove flat and duplicate triangles; also return the rows that remain."""
    place = vertices + 0.0 if tolerance == 0.0 else np.rint(vertices / tolerance)
    _, first, number = np.unique(place, axis=0, return_index=True, return_inverse=True)
    if len(first) < len(vertices):
        order = np.argsort(first)
        vertices, triangles = vertices[first[order]], inverse(order)[number.ravel()][triangles]
    rows = np.flatnonzero((triangles != np.roll(triangles, 1, axis=1)).all(axis=1))
    rows = rows[_once(triangles[rows])]
    return vertices, triangles[rows], rows


def _once(triangles: Ints) -> np.ndarray:
    """Return a mask that keeps one of each set of equal triangles, or none of them if equally many face each way."""
    corners = np.sort(triangles, axis=1)
    _, number, count = np.unique(corners, axis=0, return_inverse=True, return_counts=True)
    if not len(triangles) or count.max() == 1:
        return np.ones(len(triangles), dtype=bool)
    number = number.ravel()
    # direction of circulation: 1 for that of the sorted corners, else -1
    turn = np.argmin(triangles, axis=1)[:, None]
    second = np.take_along_axis(triangles, (turn + 1) % 3, axis=1)[:, 0]
    way = np.where(second == corners[:, 1], 1, -1)
    net = np.bincount(number, weights=way)
    retained = np.zeros(len(triangles), dtype=bool)
    for sign in (1, -1):
        own = np.flatnonzero((way == sign) & (np.sign(net[number]) == sign))
        _, first = np.unique(number[own], return_index=True)
        retained[own[first]] = True
    return retained


def _edges(triangles: Ints) -> tuple[Ints, Ints]:
    """Return the number of triangles at each edge, and the number that run along the edge less those against it."""
    edge = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2)
    way = np.where(edge[:, 0] < edge[:, 1], 1, -1)
    _, number, count = np.unique(np.sort(edge, axis=1), axis=0, return_inverse=True, return_counts=True)
    return count, np.bincount(number.ravel(), weights=way).astype(np.int64)


def _is_closed(triangles: Ints) -> bool:
    return bool(len(triangles)) and not _edges(triangles)[1].any()


def _require_closed(name: str, triangles: Ints) -> None:
    count, net = _edges(triangles)
    lone, odd = int((count == 1).sum()), int(((count % 2 == 1) & (count > 1)).sum())
    if odd and odd >= lone:
        raise InputError(
            f"{name}: {odd} edges have three triangles or more, an odd number: walls inside the body, or solids"
            " that share a part of a face; unite the solids, remove inner walls, and export again"
        )
    if lone:
        raise InputError(
            f"{name} is not watertight: {lone} edges have one triangle only, at gaps or at corners within the side of"
            " another triangle; close the surface, and export it again"
        )
    if net.any():
        raise InputError(f"{name}: its triangles do not all face the same way; repair the normals and export again")


def _cones(vertices: Floats, triangles: Ints) -> PerElement:
    """Return the signed volumes of the tetrahedra from the mean vertex to each triangle [m³], (t,)."""
    a, b, c = np.moveaxis(vertices[triangles] - vertices.mean(axis=0), 1, 0)
    return np.einsum("ni,ni->n", a, np.cross(b, c)) / 6.0


def _inside_out(name: str, vertices: Floats, triangles: Ints, part: Ints, volume: Floats) -> np.ndarray:
    """Return a mask of the solids whose triangles face inwards although they are no cavities.

    Raises:
        InputError: Solids overlap or touch, or one that faces outwards lies within another.
    """
    corner = vertices[triangles]
    turned = np.zeros(len(volume), dtype=bool)
    solids = [corner[part == k].reshape(-1, 3) for k in range(len(volume))]
    low, high = (np.array([side(one, axis=0) for one in solids]) for side in (np.min, np.max))
    for k in range(len(volume)):
        near = np.flatnonzero((low <= high[k]).all(axis=1) & (high >= low[k]).all(axis=1))
        other = corner[np.isin(part, near[near != k])]
        around = _winding(_samples(corner[part == k], len(volume) * max(len(other), 1))[0], other)
        depth = np.rint(around[0])
        if np.abs(around - depth).max() > _OFF:
            raise InputError(
                f"{name}: two of its {len(volume)} solids overlap or touch; unite them in the CAD program, or join"
                " one surface for each: bd.Surface(…) | bd.Surface(…)"
            )
        if depth and volume[k] > 0.0:
            raise InputError(
                f"{name}: one of its {len(volume)} solids lies within another and faces outwards: an overlap, or a"
                " cavity whose triangles face the wrong way; remove it, or turn the triangles of the cavity inwards"
            )
        turned[k] = volume[k] < 0.0 and not depth
    return turned


def _refuse_intersecting(name: str, corner: Floats) -> None:
    """Raise InputError for a surface that intersects itself, so that some triangles (t, 3, 3) do not bound the body.

    At a point of a triangle that bounds the body, the winding number of all others is ½, between inside and outside.
    """
    points, own = _samples(corner, 4 * len(corner))
    points = 0.97 * points + 0.03 * corner[own].mean(axis=1)  # off the edges
    off = np.abs(_winding(points, corner, own) - 0.5) > _OFF
    if off.any():
        x, y, z = points[off][0]
        raise InputError(
            f"{name} intersects itself: {100.0 * off.mean():.2g} % of it, such as ({x:.4g}, {y:.4g}, {z:.4g}), lies"
            " inside the body or faces inwards; repair it in the CAD program, and export it again"
        )


def _samples(corner: Floats, pairs: int) -> tuple[PerElement3, Ints]:
    """Return points spread over triangles (t, 3, 3), as many as the work for `pairs` per point allows, (k, 3).

    The second result is the triangle of each point.
    """
    count = int(np.clip(_PAIRS // pairs, 2, _SAMPLES))
    area = np.linalg.norm(np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]), axis=1)
    share = np.cumsum(area) / area.sum()
    # by area, and within a triangle by a sequence that fills it evenly
    at = np.minimum(np.searchsorted(share, (np.arange(count) + 0.5) / count), len(corner) - 1)
    u, v = (np.mod(0.5 + np.arange(count) * step, 1.0) for step in (0.7548776662466927, 0.5698402909980532))
    u, v = np.where(u + v > 1.0, 1.0 - u, u), np.where(u + v > 1.0, 1.0 - v, v)
    chosen = corner[at]
    return chosen[:, 0] + u[:, None] * (chosen[:, 1] - chosen[:, 0]) + v[:, None] * (chosen[:, 2] - chosen[:, 0]), at


def _winding(points: PerElement3, corner: Floats, own: Ints | None = None) -> PerElement:
    """Return the winding number of triangles (t, 3, 3) about points (k, 3), from their solid angles [-], (k,).

    The triangle `own[k]`, in which point k lies, does not count.
    """
    found = np.zeros(len(points))
    for k, point in enumerate(points):
        a, b, c = np.moveaxis(corner - point, 1, 0)
        x, y, z = (np.linalg.norm(side, axis=1) for side in (a, b, c))
        top = np.einsum("ni,ni->n", a, np.cross(b, c))
        bottom = x * y * z + (a * b).sum(axis=1) * z + (b * c).sum(axis=1) * x + (c * a).sum(axis=1) * y
        angle = np.arctan2(top, bottom)
        found[k] = (angle.sum() - (0.0 if own is None else angle[own[k]])) / (2.0 * np.pi)
    return found
