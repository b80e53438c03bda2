"""Convex solids with flat faces in flat arrays: plain cells, and the pieces that walls cut them into.

Corners are relative to the centre of the element of the cell, so that no digits are lost far from the origin.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from bondem._compile import kernel
from bondem._types import Floats, Ints

# What is behind a face: an element from 0 up, or one of these; from SPLIT down, a plane that cut the cell.
BOX, LOCAL, SPLIT = -1, -7, -16


class Solids(NamedTuple):
    """Convex solids, k of them, with f faces and v corners.

    Attributes:
        cell: element of the cell that each solid is part of, shape (k,).
        face: faces of solid s are face[s] … face[s + 1] - 1, shape (k + 1,).
        tag: neighbour behind each face, shape (f,): an element; BOX - 0 … BOX - 5, the sides of the box around the
            shape (x_min, x_max, y_min …); LOCAL, an arbitrary end; or SPLIT - 2 s and SPLIT - 2 s - 1, the two sides
            of split s of the cell.
        plane: outward unit normal and distance from the centre, shape (f, 4) [-, m].
        corner: corners of face g are corner[g] … corner[g + 1] - 1, shape (f + 1,).
        vertex: corners relative to the centre of the element [m], shape (v, 3).
    """

    cell: Ints
    face: Ints
    tag: Ints
    plane: Floats
    corner: Ints
    vertex: Floats

    @property
    def number(self) -> int:
        """Number k of solids."""
        return len(self.cell)

    @property
    def of_face(self) -> Ints:
        """Solid of each face, shape (f,)."""
        return np.repeat(np.arange(self.number), np.diff(self.face))

    def chosen(self, solids: Ints) -> "Solids":
        """Return some of the solids, by number."""
        faces, face = ranges(self.face, solids)
        corners, corner = ranges(self.corner, faces)
        return Solids(self.cell[solids], face, self.tag[faces], self.plane[faces], corner, self.vertex[corners])


def ranges(start: Ints, chosen: Ints) -> tuple[Ints, Ints]:
    """Return rows start[c] … start[c + 1] - 1 of all `chosen` c one after another, and where those of each begin."""
    size = start[chosen + 1] - start[chosen]
    begin = np.concatenate([[0], np.cumsum(size)])
    return np.arange(begin[-1]) + np.repeat(start[chosen] - begin[:-1], size), begin


def joined(parts: Sequence[Solids]) -> Solids:
    """Return the solids of several lists in one."""
    none = np.zeros(0, dtype=np.int64)
    faces = np.concatenate([none, *(np.diff(part.face) for part in parts)])
    corners = np.concatenate([none, *(np.diff(part.corner) for part in parts)])
    return Solids(
        np.concatenate([none, *(part.cell for part in parts)]),
        np.append(0, np.cumsum(faces)),
        np.concatenate([none, *(part.tag for part in parts)]),
        np.concatenate([np.zeros((0, 4)), *(part.plane for part in parts)]),
        np.append(0, np.cumsum(corners)),
        np.concatenate([np.zeros((0, 3)), *(part.vertex for part in parts)]),
    )


@kernel(parallel=False)
def _areas(corner, vertex, area, centroid, moment):
    for f in range(corner.size - 1):
        start, end = corner[f], corner[f + 1]
        ox, oy, oz = vertex[start, 0], vertex[start, 1], vertex[start, 2]
        nx, ny, nz = 0.0, 0.0, 0.0
        for k in range(start + 1, end - 1):
            px, py, pz = vertex[k, 0] - ox, vertex[k, 1] - oy, vertex[k, 2] - oz
            qx, qy, qz = vertex[k + 1, 0] - ox, vertex[k + 1, 1] - oy, vertex[k + 1, 2] - oz
            nx += py * qz - pz * qy
            ny += pz * qx - px * qz
            nz += px * qy - py * qx
        size = np.sqrt(nx * nx + ny * ny + nz * nz)
        area[f] = 0.5 * size
        per = 1.0 / size if size > 0.0 else 0.0
        cx, cy, cz = 0.0, 0.0, 0.0
        xx, yy, zz, xy, xz, yz = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
        for k in range(start + 1, end - 1):
            px, py, pz = vertex[k, 0] - ox, vertex[k, 1] - oy, vertex[k, 2] - oz
            qx, qy, qz = vertex[k + 1, 0] - ox, vertex[k + 1, 1] - oy, vertex[k + 1, 2] - oz
            part = 0.5 * per * (
                (py * qz - pz * qy) * nx + (pz * qx - px * qz) * ny + (px * qy - py * qx) * nz
            )
            sx, sy, sz = px + qx, py + qy, pz + qz
            cx, cy, cz = cx + part * sx, cy + part * sy, cz + part * sz
            xx += part * (sx * sx + px * px + qx * qx)
            yy += part * (sy * sy + py * py + qy * qy)
            zz += part * (sz * sz + pz * pz + qz * qz)
            xy += part * (sx * sy + px * py + qx * qy)
            xz += part * (sx * sz + px * pz + qx * qz)
            yz += part * (sy * sz + py * pz + qy * qz)
        per = 2.0 * per / 3.0
        cx, cy, cz = cx * per, cy * per, cz * per
        centroid[f, 0], centroid[f, 1], centroid[f, 2] = ox + cx, oy + cy, oz + cz
        moment[f, 0, 0] = xx / 12.0 - area[f] * cx * cx
        moment[f, 1, 1] = yy / 12.0 - area[f] * cy * cy
        moment[f, 2, 2] = zz / 12.0 - area[f] * cz * cz
        moment[f, 0, 1] = moment[f, 1, 0] = xy / 12.0 - area[f] * cx * cy
        moment[f, 0, 2] = moment[f, 2, 0] = xz / 12.0 - area[f] * cx * cz
        moment[f, 1, 2] = moment[f, 2, 1] = yz / 12.0 - area[f] * cy * cz


def polygon_measures(corner: Ints, vertex: Floats) -> tuple[Floats, Floats, Floats]:
    """Return area [m²], (f,), centroid [m], (f, 3), and second moments about it [m⁴], (f, 3, 3), of polygons."""
    count = len(corner) - 1
    area, centroid, moment = np.empty(count), np.empty((count, 3)), np.empty((count, 3, 3))
    _areas(corner, vertex, area, centroid, moment)
    return area, centroid, moment


@kernel(parallel=False)
def _volumes(solids, volume, first, second, middle, farthest, beyond):
    face, plane, corner, vertex = solids.face, solids.plane, solids.corner, solids.vertex
    for s in range(face.size - 1):
        v, far, out = 0.0, 0.0, -np.inf
        mx, my, mz, corners = 0.0, 0.0, 0.0, max(corner[face[s + 1]] - corner[face[s]], 1)
        fx, fy, fz = 0.0, 0.0, 0.0
        xx, yy, zz, xy, xz, yz = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
        for f in range(face[s], face[s + 1]):
            out = max(out, -plane[f, 3])
            start = corner[f]
            ax, ay, az = vertex[start, 0], vertex[start, 1], vertex[start, 2]
            for k in range(start, corner[f + 1]):
                far = max(far, vertex[k, 0] ** 2 + vertex[k, 1] ** 2 + vertex[k, 2] ** 2)
                mx, my, mz = mx + vertex[k, 0], my + vertex[k, 1], mz + vertex[k, 2]
            for k in range(start + 1, corner[f + 1] - 1):
                bx, by, bz = vertex[k, 0], vertex[k, 1], vertex[k, 2]
                cx, cy, cz = vertex[k + 1, 0], vertex[k + 1, 1], vertex[k + 1, 2]
                part = (
                    ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
                ) / 6.0
                v += part
                sx, sy, sz = ax + bx + cx, ay + by + cy, az + bz + cz
                fx, fy, fz = fx + part * sx, fy + part * sy, fz + part * sz
                xx += part * (sx * sx + ax * ax + bx * bx + cx * cx)
                yy += part * (sy * sy + ay * ay + by * by + cy * cy)
                zz += part * (sz * sz + az * az + bz * bz + cz * cz)
                xy += part * (sx * sy + ax * ay + bx * by + cx * cy)
                xz += part * (sx * sz + ax * az + bx * bz + cx * cz)
                yz += part * (sy * sz + ay * az + by * bz + cy * cz)
        volume[s], farthest[s], beyond[s] = v, np.sqrt(far), out
        middle[s, 0], middle[s, 1], middle[s, 2] = mx / corners, my / corners, mz / corners
        first[s, 0], first[s, 1], first[s, 2] = 0.25 * fx, 0.25 * fy, 0.25 * fz
        second[s, 0, 0], second[s, 1, 1], second[s, 2, 2] = 0.05 * xx, 0.05 * yy, 0.05 * zz
        second[s, 0, 1] = second[s, 1, 0] = 0.05 * xy
        second[s, 0, 2] = second[s, 2, 0] = 0.05 * xz
        second[s, 1, 2] = second[s, 2, 1] = 0.05 * yz


@dataclass(frozen=True, eq=False)
class Bulk:
    """Volumes and moments of solids, all about the centre of the element.

    Attributes:
        volume: ∫ dV [m³], shape (k,).
        first: ∫ x dV [m⁴], shape (k, 3).
        second: ∫ x⊗x dV [m⁵], shape (k, 3, 3).
        middle: a point inside, also of a thin solid [m], shape (k, 3).
        farthest: distance of the farthest corner [m], shape (k,).
        beyond: distance of the centre outside the solid, at most 0 if it lies inside [m], shape (k,).
    """

    volume: Floats
    first: Floats
    second: Floats
    middle: Floats
    farthest: Floats
    beyond: Floats

    def chosen(self, solids: Ints) -> "Bulk":
        """Return the values of some solids, by number."""
        return Bulk(*(values[solids] for values in vars(self).values()))


def bulk(solids: Solids) -> Bulk:
    """Compute volumes and moments of solids."""
    k = solids.number
    found = Bulk(np.empty(k), np.empty((k, 3)), np.empty((k, 3, 3)), np.empty((k, 3)), np.empty(k), np.empty(k))
    _volumes(solids, *vars(found).values())
    return found
