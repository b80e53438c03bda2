"""Centres of cells that end on surfaces: planes, walls of shapes, or closed triangulated surfaces.

A centre at half the size of a cell below a face has its mirror image outside. The plane half-way between the two is
the face, or touches it where it is curved. If no point of the face is nearer to any other centre, cells end there and
nowhere else: exactly on plane faces, on a polyhedron of the same volume around curved ones. Near a convex edge a
centre is half a cell size from both faces and has an image beyond each. Concave edges are only approximated: the
error is 0.13 cell sizes, root mean square over an L-shaped surface. Where a plane meets a wall at an acute angle,
images have no room: both centres of such a pair stand nearer to the plane, which remains half-way between them.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from scipy.spatial import KDTree

from bondem._types import PerElement, PerElement3
from bondem.errors import InputError
from bondem.geometry.elementary_shapes import Shape
from bondem.packing.even import moved_inside, usual_radius
from bondem.packing.free_centres import MARGIN, settled_free, thrown_free, without_twins
from bondem.packing.graded import nearest_others, pushed
from bondem.specimen.aggregates import Aggregates
from bondem.specimen.particles import Particles, filled
from bondem.specimen.regions import Plane

#: Surfaces on which cells can end.
Around = Plane | Shape | Aggregates

# Distances over the size of a cell: of pins from their face; up to which a face is near to a pin; of free centres
# from surfaces; below which one of two pins is removed, and two surfaces are too near; of pins from walls.
_HALF, _NEAR_FACE, _CLEAR, _TWIN, _PIN_MARGIN = 0.5, 0.8, 1.25, 0.5, 0.45
# Largest shift of a tangent plane for curvature, over the size of a cell; a larger one is that of an edge.
_SHIFT = 0.08
# Over the size of a cell: distance of mirror images outside the walls that makes a plane oblique, least distance of
# centres beside an oblique plane, and least distance of these from walls.
_OBLIQUE, _LEAST, _RIM = 0.05, 0.3, 0.1
# Rounds in which pins push each other apart, pushes per round, neighbours of a pin, and Lloyd's steps.
_ROUNDS, _SAME, _NEAR, _LLOYD = 10, 5, 16, 8
# Distance from all pins, over the size of a cell, from which a point of a layer is a hole, and rounds of filling.
_HOLE, _FILLED = 0.8, 3
# Number of points in the body by which areas are measured, and number of points of a layer per pin.
_SAMPLES, _POINTS = 400_000, 150

_Depth = Callable[[PerElement3], PerElement]


@dataclass(frozen=True)
class _Sided:
    """Depth functions of a surface: below all of its faces, and below each face, positive inside."""

    depth: _Depth
    faces: tuple[_Depth, ...]

    @classmethod
    def of(cls, surface: Around) -> "_Sided":
        if isinstance(surface, Shape):
            return cls(surface.depth, tuple(partial(surface.face_depth, face) for face in surface.faces))
        return cls(surface.depth, (surface.depth,))


def around_surfaces(
    shape: Shape, count: int, surfaces: Sequence[Around], random: np.random.Generator, report: Callable[[float], None]
) -> Particles:
    """Pack equal spheres for cells that end on surfaces.

    Args:
        shape: shape to fill.
        count: number of spheres.
        surfaces: surfaces within the shape or across it, apart from each other by 1.6 cells or more.
        random: random generator.
        report: function called with the completed share.

    Raises:
        InputError: The cells are too large or too few, or surfaces lie outside the shape or too near to each other.
    """
    h = float(np.cbrt(shape.volume / count))
    sided = [_Sided.of(surface) for surface in surfaces]
    layers = [_layers(shape, surface, one, h, random) for surface, one in zip(surfaces, sided, strict=True)]
    for k, layer in enumerate(layers):
        for other in layers[:k]:
            if KDTree(layer).query(other)[0].min() < _TWIN * h:
                raise InputError(
                    f"pack: two surfaces of around= cross, or are nearer to each other than 1.6 cells of {h:.3g} m;"
                    " leave one out if they cross, else give surfaces farther apart, or more and smaller cells"
                )
    pins = np.concatenate(layers)
    if count <= len(pins):
        raise InputError(f"pack: the surfaces of around= need more than {count} cells; ask for more")
    nearest = partial(_nearest, sided)
    free = thrown_free(shape, count - len(pins), nearest, _CLEAR * h, h, random)
    x = settled_free(shape, pins, free, h, report, nearest=nearest, clear=_CLEAR * h)
    return filled(Particles(x, usual_radius(shape, x, 0.5 * h), None), shape)


def _nearest(sided: list[_Sided], x: PerElement3) -> PerElement:
    """Return the distance of points (n, 3) from the nearest surface [m], (n,)."""
    return np.min([np.abs(one.depth(x)) for one in sided], axis=0)


def _layers(shape: Shape, surface: Around, sided: _Sided, h: float, random: np.random.Generator) -> PerElement3:
    """Return the centres on both sides of a surface [m], (k, 3)."""
    lower, upper = shape.bounds
    x = lower + (upper - lower) * random.random((_SAMPLES, 3))
    x = x[shape.depth(x) > 0.0]
    depth = sided.depth(x)
    # the area of the surface is the volume within h / 2 of it, over h
    area = float((np.abs(depth) < 0.5 * h).mean()) * shape.volume / h
    inside = x[(depth > 0.0) & (depth < h)]
    wanted = round(area / h**2)
    if not wanted or not len(inside):
        raise InputError(
            f"pack: around= has {surface}, with no room for cells of {h:.3g} m inside of it and of the shape; check"
            " its position and its unit (metres), or ask for smaller cells"
        )
    beside = x[np.abs(depth) < 0.5 * h]
    if isinstance(surface, Plane) and len(pairs := _oblique(shape, surface, beside, wanted, h)):
        return pairs
    # points of the layer, of which each pin becomes the centre of some
    inside = _onto(sided, inside[: _POINTS * wanted], h)
    pin = _spread(shape, sided, inside, wanted, h, lambda x: shape.depth(x) - MARGIN * h)
    pin = pin[(shape.depth(pin) >= MARGIN * h) & (sided.depth(pin) > 0.25 * h)]
    pin = _apart(pin, _TWIN * h)
    images = []
    for face in sided.faces:
        near = pin[face(pin) < _NEAR_FACE * h]
        if not len(near):
            continue
        image = near - 2.0 * (face(near) - _shift(face, near, h))[:, None] * _slope(face, near, h)
        images.append(image[(shape.depth(image) >= MARGIN * h) & (sided.depth(image) < -0.25 * h)])
    outside = np.concatenate([np.empty((0, 3)), *images])
    if not len(pin) or not len(outside):
        raise InputError(
            f"pack: around= has {surface}, which has no cells of {h:.3g} m on both sides within the shape; check its"
            " position, or ask for smaller cells"
        )
    return np.concatenate([pin, _apart(outside, _TWIN * h)])


def _oblique(shape: Shape, plane: Plane, x: PerElement3, wanted: int, h: float) -> PerElement3:
    """Return centres on both sides of a plane that meets walls obliquely [m], (k, 3); none if it does not.

    There are about as many pairs as `wanted`; `x` are points of the shape within h / 2 of the plane [m], (n, 3).
    """
    normal = np.array(plane.normal)
    section = x - plane.depth(x)[:, None] * normal

    def room(foot: PerElement3, half: float = _LEAST) -> PerElement:
        return np.min([shape.depth(foot + side * half * h * normal) for side in (-1, 1)], axis=0) - _RIM * h

    if (shape.depth(2.0 * section - x) >= -_OBLIQUE * h).all() or (room(section, _HALF) < 0.0).all():
        return x[:0]
    section = section[shape.depth(section) > 0.0][: _POINTS * wanted]
    raised = _Sided.of(replace(plane, point=tuple(plane.point - _HALF * h * normal)))
    foot = _spread(shape, raised, section, wanted, h, room)
    foot = _apart(foot[room(foot) >= 0.0], _TWIN * h)
    most = [np.where(room(foot, half) >= 0.0, half, _LEAST) for half in np.linspace(_LEAST, _HALF, 11)]
    out = np.max(most, axis=0)[:, None] * h * normal
    return np.concatenate([foot + out, foot - out])


def _spread(shape: Shape, sided: _Sided, points: PerElement3, count: int, h: float, room: _Depth) -> PerElement3:
    """Return centres along a surface [m], (k, 3): `count` of `points` pushed apart, more in holes, then centred."""
    pin = points[:count].copy()
    if len(pin) <= 1:
        return pin
    for _ in range(_ROUNDS):
        other = nearest_others(pin, min(_NEAR, len(pin)))[1]
        for _ in range(_SAME):
            moved = pushed(pin, np.full(len(pin), h), other)
            pin = _onto(sided, moved_inside(shape, moved, pin, np.full(len(pin), _PIN_MARGIN * h)), h)
    for _ in range(_FILLED):
        far = np.asarray(KDTree(pin).query(points)[0])
        hole = _apart(points[np.argsort(-far)][: int((far > _HOLE * h).sum())], _HOLE * h)
        for _ in range(_LLOYD):
            pin, hole = np.concatenate([pin, hole]), hole[:0]
            own = np.asarray(KDTree(pin).query(points)[1])
            number = np.bincount(own, minlength=len(pin))
            middle = np.column_stack([np.bincount(own, weights=points[:, d], minlength=len(pin)) for d in range(3)])
            pin = _onto(sided, (middle / np.maximum(number, 1)[:, None])[number > 0], h)
    # in a corner of the body, moving off one wall leads to another: such a pin moves to the nearest point with room
    deep = points[room(points) > 0.02 * MARGIN * h]
    if len(deep):
        shallow = np.flatnonzero(room(pin) < 0.0)
        pin[shallow] = deep[np.asarray(KDTree(deep).query(pin[shallow])[1])]
    return pin


def _onto(sided: _Sided, x: PerElement3, h: float) -> PerElement3:
    """Move points, in place, to a depth of half the cell size `h` [m] below the nearest face and other near faces."""
    for _ in range(3):
        depth = np.array([face(x) for face in sided.faces])
        nearest = np.abs(depth - _HALF * h).argmin(axis=0)
        for k, face in enumerate(sided.faces):
            own = np.flatnonzero((depth[k] < _NEAR_FACE * h) | (nearest == k))
            if len(own):
                wanted = _HALF * h + _shift(face, x[own], h)
                x[own] += (wanted - face(x[own]))[:, None] * _slope(face, x[own], h)
    return x


def _slope(face: _Depth, x: PerElement3, h: float) -> PerElement3:
    """Return the inward unit normals of a face at points (n, 3) [-]."""
    tiny = 1e-3 * h
    slope = np.column_stack([(face(x + tiny * axis) - face(x - tiny * axis)) / (2.0 * tiny) for axis in np.eye(3)])
    return slope / np.maximum(np.linalg.norm(slope, axis=1, keepdims=True), 0.1)


def _shift(face: _Depth, x: PerElement3, h: float) -> PerElement:
    """Return the depth of tangent planes below a curved face at which they enclose the right volume [m], (n,).

    Flat tiles of width h lie above a surface of principal curvatures κ by h² (κ₁ + κ₂) / 24 on average.
    """
    at = x - face(x)[:, None] * _slope(face, x, h)
    step, middle = 0.3 * h, face(at)
    bend = sum(face(at + step * axis) + face(at - step * axis) - 2.0 * middle for axis in np.eye(3)) / step**2
    shift = np.clip(-bend * h**2 / 24.0, -_SHIFT * h, _SHIFT * h)
    return np.where(np.abs(shift) < 1e-9 * h, 0.0, shift)


def _apart(x: PerElement3, least: float) -> PerElement3:
    """Remove points that are nearer to an earlier point than `least` [m]."""
    return x[without_twins(x, least, np.ones(len(x), dtype=bool))]
