"""Bodies of cells against three-dimensional elasticity: E, ν, free frequencies and what loads do to clamped bodies.

Nothing is calibrated: E, ν and ρ of a material are the parameters of the law. As E scales out, a case is a shape, a
Poisson's ratio, a number of elements and a seed. Seven shapes are cut into cells; the continuum is meshed with
triquadratic hexahedra (`measures/continuum.py`), refined towards held faces. A mode of the body is matched with one
of the continuum by its shape (modal assurance criterion); modes of one frequency are compared as a group. Clamped
bodies are held and loaded on their faces, as the continuum is; what a load does is its work on the face it acts on.
"""

from collections.abc import Callable
from functools import lru_cache, partial
from itertools import product
from typing import Any

import numpy as np

import bondem as bd
from bondem.observables.surface_displacement import surface_displacement
from bondem.statics.static import Statics
from validation.frame.record import Record
from validation.measures.bodies import MODES, bodies, free_modes, mesh
from validation.measures.continuum import Vibration
from validation.measures.matching import matched
from validation.studies.any_specimen import MATERIALS as NAMES

#: Poisson's ratios of five materials.
MATERIALS = {one: bd.materials.get(one).nu for one in NAMES}
#: Allowed error [-] where the thinnest part is at least so many elements thick, by number of elements.
LIMITS = {10_000: ((8.0, 0.01), (4.0, 0.02)), 40_000: ((0.0, 0.005),)}


@lru_cache(maxsize=6)
def reference(name: str, nu: float) -> tuple[Vibration, dict[str, float]]:
    """Free modes for E = ρ = 1, and what each unit load does where it acts on the clamped body."""
    return free_modes(name, nu), bodies()[name].moved(mesh(name), nu)


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
