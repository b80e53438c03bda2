"""Bodies of cells against three-dimensional elasticity: E, ν, free frequencies and what loads do to clamped bodies.

Nothing is calibrated: E, ν and ρ of a material are the parameters of the law. As E scales out, a case is a shape, a
Poisson's ratio, a number of elements and a seed. Seven shapes are cut into cells; the continuum is meshed with
triquadratic hexahedra (`measures/continuum.py`), refined towards held faces. A mode of the body is matched with one
of the continuum by its shape (modal assurance criterion); modes of one frequency are compared as a group. Clamped
bodies are held and loaded on their faces, as the continuum is; what a load does is its work on the face it acts on.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, lru_cache, partial
from itertools import product
from typing import Any

import numpy as np
from skfem import Basis, ElementHex2, ElementVector

import bondem as bd
from bondem.observables.surface_displacement import surface_displacement
from bondem.statics.static import Statics
from validation.frame.record import Record
from validation.frame.sources import REPOSITORY
from validation.measures.continuum import Continuum, Vibration, _lines
from validation.measures.fem_cylinder import disc, extruded
from validation.measures.matching import matched
from validation.studies.any_specimen import FORCE_X, FORCE_Y, FORCE_Z, MODES, MOMENT_X
from validation.studies.any_specimen import MATERIALS as NAMES

#: Poisson's ratios of five materials.
MATERIALS = {one: bd.materials.get(one).nu for one in NAMES}
#: Allowed error [-] where the thinnest part is at least so many elements thick, by number of elements.
LIMITS = {10_000: ((8.0, 0.01), (4.0, 0.02)), 40_000: ((0.0, 0.005),)}
BAR = {"tension": FORCE_X, "bending": FORCE_Y, "torsion": MOMENT_X}
FOOT = {"tension": FORCE_X, "bending": FORCE_Z, "torsion": FORCE_Y}


@dataclass(frozen=True)
class Body:
    """A shape, its mesh and how it is tested.

    Attributes:
        shape: what is cut into cells.
        mesh: makes the continuum.
        thickness: of its thinnest part [m].
        loaded: face that is loaded; x_min is held.
        loads: (force, moment) on it, by name.
        bar: whether E and ν are those of a bar pulled along x.
    """

    shape: bd.Shape
    mesh: Callable[[], Continuum]
    thickness: float
    loaded: str = "x_max"
    loads: Any = None
    bar: bool = True


def _box(size: tuple[float, float, float], cell: float) -> Body:
    return Body(bd.Box(size), lambda: Continuum.box(size, cell=cell), min(size), loads=BAR)


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
    """The seven shapes."""
    flange, web = (40e-3, 10e-3, 3e-3), (40e-3, 3e-3, 10e-3)
    angle = (((0, 0, 0), flange), ((0, 0, 3e-3), web))
    hole = bd.Cylinder(4e-3, 10e-3).rotated("y", np.pi / 2).moved((20e-3, 10e-3, 8e-3))
    refined = ((0.0, 40e-3), (3e-3,), (3e-3,))  # the ends, and the re-entrant edge
    return {
        "cube": _box((10e-3, 10e-3, 10e-3), 1.67e-3),
        "beam": _box((40e-3, 5e-3, 5e-3), 1.25e-3),
        "plate": _box((24e-3, 16e-3, 2.5e-3), 1.6e-3),
        "cylinder": Body(bd.Cylinder(5e-3, 40e-3), _cylinder, 10e-3, loads=BAR),
        "l_beam": Body(
            bd.Box(flange) | bd.Box(web),
            lambda: Continuum.of(angle, cell=1.6e-3, refined=refined), 3e-3, loads=BAR,
        ),
        "bracket": Body(
            bd.Surface(REPOSITORY / "examples" / "bracket.stl", unit="mm"),
            lambda: Continuum.bracket(cell=2.67e-3), 8e-3, "z_max", FOOT, bar=False,
        ),
        "holed_plate": Body(bd.Box((40e-3, 20e-3, 4e-3)) - hole, _holed, 4e-3, loads=BAR, bar=False),
    }  # fmt: skip


@lru_cache(maxsize=2)
def mesh(name: str) -> Continuum:
    return bodies()[name].mesh()


@lru_cache(maxsize=6)
def free_modes(name: str, nu: float) -> Vibration:
    """For E = ρ = 1."""
    return mesh(name).vibration(1.0, nu, 1.0, count=MODES)


@lru_cache(maxsize=6)
def reference(name: str, nu: float) -> tuple[Vibration, dict[str, float]]:
    """Free modes for E = ρ = 1, and what each unit load does where it acts on the clamped body."""
    body = bodies()[name]
    motion = mesh(name).response(1.0, nu, held="x_min", loaded=body.loaded, loads=list(body.loads.values()))
    pairs = zip(body.loads.items(), motion, strict=True)
    moved = {load: float(np.concatenate(one) @ way) for (load, one), way in pairs}
    return free_modes(name, nu), moved


@lru_cache(maxsize=1)
def cut(name: str, count: int, seed: int) -> bd.Lattice:
    return bd.connect(bd.pack(bodies()[name].shape, count=count, spread=0.25, seed=seed), method="laguerre")


@lru_cache(maxsize=1)
def sampler(name: str, count: int, seed: int) -> Callable[[np.ndarray], np.ndarray]:
    """Modes of the continuum at the elements of a body."""
    part = cut(name, count, seed)
    middle = part.centre.mean(axis=0)
    # inside a curved wall the mesh may end before a centre does
    return mesh(name).sampler(middle + 0.999 * (part.centre - middle))


def case(name: str, nu: float, count: int, seed: int) -> dict[str, Any]:
    """One body: every quantity over that of the continuum, less one."""
    part, law = cut(name, count, seed), bd.CellBond(E=1.0, nu=nu)
    theory, moved = reference(name, nu)
    rows: dict[str, float] = {}
    if bodies()[name].bar:
        bar = bd.labtests.static_tension(part, law)
        rows |= {"E": bar.E - 1.0, "nu": bar.nu - nu}
    for k, error in enumerate(_frequencies(part, law, theory, sampler(name, count, seed)(theory.shape)), start=1):
        rows[f"f{k}"] = error
    rows |= {load: found / moved[load] - 1.0 for load, found in _work(part, law, name).items()}
    thick = bodies()[name].thickness / (bodies()[name].shape.volume / count) ** (1.0 / 3.0)
    return {
        "shape": name, "nu": nu, "count": count, "seed": seed, "thickness": thick,
        "limit": next((error for least, error in LIMITS.get(count, ()) if thick >= least), None), "errors": rows,
    }  # fmt: skip


def _work(part: bd.Lattice, law: bd.CellBond, name: str) -> dict[str, float]:
    """What each unit load does on the mean motion of the face that it acts on, the other end held."""
    body = bodies()[name]
    face = bd.Face(body.loaded)
    statics = Statics(bd.Model(part, law, 1.0, boundary=[bd.Fix(bd.Face("x_min"))]))
    assert part.cells is not None
    free, on = part.cells.free, part.on_face(face.name)
    area, arm = free.area[on, None], free.centroid[on] - face.anchor(part)
    polar = (area * arm**2).sum() * np.eye(3) - arm.T @ (area * arm)
    found = {}
    for load, (force, moment) in body.loads.items():
        chosen, values = bd.Load(face, force=force, moment=moment).nodal(part)
        nodal, traction = np.zeros((len(part.particles), 6)), np.zeros((len(free.area), 3))
        nodal[chosen] = values
        traction[on] = np.array(force) / area.sum() + np.cross(np.linalg.solve(polar, moment), arm)
        joined = statics.model.interaction
        swelling = joined.swelling_load(joined.pressed(np.arange(len(free.area)), free.area[:, None] * traction))
        motion = statics.response(nodal + swelling)
        moved = surface_displacement(statics.model, motion[:, :3], motion[:, 3:], traction=traction)[on]
        turned = np.linalg.solve(polar, (area * np.cross(arm, moved)).sum(axis=0))
        found[load] = float(np.dot(force, (area * moved).sum(axis=0)) / area.sum() + np.dot(moment, turned))
    return found


def _frequencies(part: bd.Lattice, law: bd.CellBond, theory: Vibration, expected: np.ndarray) -> list[float]:
    assert part.cells is not None
    found = bd.solve_modes(bd.Model(part, law, 1.0), count=MODES + 3)
    pairs = matched(found, part.cells.volume, theory, expected)
    return [one.measured / one.reference - 1.0 for one in pairs for _ in one.modes][:6]


def measure(
    record: Record, *, counts: tuple[int, ...] = (10_000,), seeds: tuple[int, ...] = (1, 2, 3, 4, 5),
    shapes: tuple[str, ...] = tuple(bodies()), nus: tuple[float, ...] = tuple(sorted(set(MATERIALS.values()))),
) -> None:  # fmt: skip
    """Measure bodies of several numbers of cells and Poisson's ratios."""
    # shape by shape: meshes and factors of seven continua together do not fit into memory
    for shape, count, seed, nu in product(shapes, counts, seeds, nus):
        record.add(partial(case, shape, nu, count, seed), shape=shape, nu=nu, count=count, seed=seed)
    cases, order = record.rows(), list(bodies())
    cases.sort(key=lambda one: (one["count"], order.index(one["shape"]), one["nu"], one["seed"]))
    judged = [one for one in cases if one["limit"] is not None]
    held = sum(max(map(abs, one["errors"].values())) <= one["limit"] for one in judged)
    record.keep(within=held, judged=len(judged))
    print(f"{held} of {len(judged)} within their limit")
