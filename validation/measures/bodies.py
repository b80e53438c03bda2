"""Bodies that are tested against three-dimensional elasticity: their shapes, their meshes, and what loads do."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, lru_cache
from typing import Any

import numpy as np
from skfem import Basis, ElementHex2, ElementVector

import bondem as bd
from validation.frame.sources import REPOSITORY
from validation.measures.continuum import BRACKET, Continuum, Corners, Vibration, _lines
from validation.measures.fem_cylinder import disc, extruded

#: Modes of the continuum.
MODES = 9
FORCE_X, FORCE_Y, FORCE_Z = ((tuple(axis), (0.0, 0.0, 0.0)) for axis in np.eye(3).tolist())
MOMENT_X = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0))
BAR = {"tension": FORCE_X, "bending": FORCE_Y, "torsion": MOMENT_X}
#: Of the bracket's arm: forces along x, z and y stretch, bend and twist its foot.
FOOT = {"tension": FORCE_X, "bending": FORCE_Z, "torsion": FORCE_Y}


@dataclass(frozen=True)
class Body:
    """A shape, its mesh and how it is tested.

    Attributes:
        shape: what is packed.
        thickness: of its thinnest part [m].
        boxes: the same for the continuum.
        cell: of the mesh [m].
        refined: places along x, y and z towards which it is refined [m].
        solid: makes the mesh of a shape that is no union of boxes.
        loaded: face that is loaded; x_min is held.
        loads: (force, moment) on it, by name.
        bar: whether E and ν are those of a bar pulled along x.
    """

    shape: bd.Shape
    thickness: float
    boxes: tuple[Corners, ...] = ()
    cell: float = 0.0
    refined: tuple[tuple[float, ...], ...] = ((), (), ())
    solid: Callable[[], Continuum] | None = None
    loaded: str = "x_max"
    loads: Any = None
    bar: bool = True

    def continuum(self, inside: float = 0.0) -> Continuum:
        """The mesh, of boxes also of what lies between planes `inside` [m] of the held and the loaded face."""
        if self.solid is not None:
            return self.solid()
        boxes = [(list(lower), list(upper)) for lower, upper in self.boxes]
        boxes[0][0][0] += inside
        boxes[-1][1]["xyz".index(self.loaded[0])] -= inside
        along, *others = self.refined
        end = min(along[1], max(upper[0] for _, upper in boxes))
        return Continuum.of(boxes, cell=self.cell, refined=((inside, end), *others))

    def moved(self, part: Continuum, nu: float, inside: float = 0.0) -> dict[str, float]:
        """What each unit load does where it acts on a mesh for E = 1, with its force `inside` [m] of the face."""
        lever = inside * np.eye(3)["xyz".index(self.loaded[0])]
        loads = list(self.loads.values())
        motion = part.response(1.0, nu, held="x_min", loaded=self.loaded, loads=loads, lever=lever.tolist())
        pairs = zip(self.loads.items(), motion, strict=True)
        return {load: float(np.concatenate(values) @ way) for (load, values), way in pairs}


def _box(size: tuple[float, float, float], cell: float) -> Body:
    ends = ((0.0, size[0]), (), ())
    return Body(bd.Box(size), min(size), (((0, 0, 0), size),), cell, ends, loads=BAR)


def _prism(points: np.ndarray, quads: np.ndarray, x: np.ndarray) -> Continuum:
    mesh = extruded(points, quads, x)
    return Continuum(Basis(mesh, ElementVector(ElementHex2()), intorder=4))


def _cylinder() -> Continuum:
    points, quads = disc(8)
    one, other = np.moveaxis(points[quads][:, 2:] - points[quads][:, :2], 1, 0)
    area = 0.5 * abs(float((one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]).sum()))
    points = points * np.sqrt(np.pi * 25e-6 / area)  # straight sides, the area of the disc
    return _prism(points, quads, _lines(np.array([0.0, 40e-3]), 1.6e-3, (0.0, 40e-3)))


def _holed() -> Continuum:
    """A plate 40 × 20 × 4 mm with a hole of radius 4 mm: an O-grid about the hole, and two rectangles."""
    side, rings, layers = 6, 4, 3
    t = np.linspace(-1.0, 1.0, side + 1)[:-1]
    one = np.ones(side)
    square = np.concatenate([np.stack(p, 1) for p in ((t, -one), (one, t), (-t, one), (-one, -t))])
    angle = np.arctan2(square[:, 1], square[:, 0])
    fine = 4e-3 * np.sqrt(2.0 * np.pi / len(angle) / np.sin(2.0 * np.pi / len(angle)))  # the area of the hole
    rim = fine * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    share = (np.arange(rings + 1) / rings)[:, None, None] ** 1.4
    ring = (rim + share * (10e-3 * square - rim)).reshape(-1, 2)
    n = len(angle)
    k, m = np.meshgrid(np.arange(rings), np.arange(n), indexing="ij")
    number = k * n + m
    after = k * n + (m + 1) % n
    parts, points = [np.stack([number, number + n, after + n, after], -1).reshape(-1, 4)], [ring]
    for first in (-20e-3, 10e-3):
        along, across = np.linspace(first, first + 10e-3, layers + 1), np.linspace(-10e-3, 10e-3, side + 1)
        a, b = np.meshgrid(along, across, indexing="ij")
        at = sum(map(len, points)) + np.arange(a.size).reshape(a.shape)
        parts.append(np.stack([at[:-1, :-1], at[1:, :-1], at[1:, 1:], at[:-1, 1:]], -1).reshape(-1, 4))
        points.append(np.stack([a.ravel(), b.ravel()], axis=1))
    whole, merged = np.unique(np.round(np.concatenate(points), 9), axis=0, return_inverse=True)
    mesh = _prism(whole, merged.ravel()[np.concatenate(parts)], np.linspace(0.0, 4e-3, layers + 1))
    p = mesh.basis.mesh.p  # extruded along x: turn to plate axes x, y in plane and z across
    turned = type(mesh.basis.mesh)(np.stack([p[1] + 20e-3, p[2] + 10e-3, p[0]]), mesh.basis.mesh.t)
    return Continuum(Basis(turned, ElementVector(ElementHex2()), intorder=4))


@cache
def bodies() -> dict[str, Body]:
    """Seven shapes; frequencies on their meshes are within 0.15 % of those of a fine mesh."""
    flange, web = (40e-3, 10e-3, 3e-3), (40e-3, 3e-3, 10e-3)
    angle = (((0, 0, 0), flange), ((0, 0, 3e-3), web))
    (_, (_, _, height)), ((inner, _, _), _) = BRACKET
    hole = bd.Cylinder(4e-3, 10e-3).rotated("y", np.pi / 2).moved((20e-3, 10e-3, 8e-3))
    return {
        "cube": _box((10e-3, 10e-3, 10e-3), 1.67e-3),
        "beam": _box((40e-3, 5e-3, 5e-3), 1.25e-3),
        "plate": _box((24e-3, 16e-3, 2.5e-3), 1.6e-3),
        "cylinder": Body(bd.Cylinder(5e-3, 40e-3), 10e-3, solid=_cylinder, loads=BAR),
        # refined towards the ends and the re-entrant edge
        "l_beam": Body(
            bd.Box(flange) | bd.Box(web), 3e-3, angle, 1.6e-3, ((0.0, 40e-3), (3e-3,), (3e-3,)), loads=BAR,
        ),
        "bracket": Body(
            bd.Surface(REPOSITORY / "examples" / "bracket.stl", unit="mm"), 8e-3, BRACKET, 2.67e-3,
            ((0.0, inner), (), (height,)), loaded="z_max", loads=FOOT, bar=False,
        ),
        "holed_plate": Body(bd.Box((40e-3, 20e-3, 4e-3)) - hole, 4e-3, solid=_holed, loads=BAR, bar=False),
    }  # fmt: skip


@lru_cache(maxsize=2)
def mesh(name: str) -> Continuum:
    return bodies()[name].continuum()


@lru_cache(maxsize=6)
def free_modes(name: str, nu: float) -> Vibration:
    """For E = ρ = 1."""
    return mesh(name).vibration(1.0, nu, 1.0, count=MODES)
