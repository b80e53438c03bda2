"""What an exact continuum does in the seven tests of a clamped specimen: a finite-element reference.

Strength of materials takes the clamped section for a rigid plane and the bar for a line. A specimen of spheres
is held and loaded at the few spheres that touch its ends. This script solves three-dimensional elasticity on a
cylinder in two ways, each relative to strength of materials with the length from wall to wall:

    face      the face x = 0 held, tractions on the face x = L
    spheres   the material inside the spheres of Face("x_min") of a packing held, the loads of Face("x_max") on
              the material inside its spheres, whose mean motion is what counts

Each way also gets an impact: x = L (or the spheres there) pushed at a held velocity, arrival at x = 0 at half
the plateau. The first packing is done on every mesh, to see how far the results are from converged; the others and
`face` on the mesh `--common`.
"""

from functools import partial
from typing import Any

import numpy as np

import bondem as bd
from bondem.labtests.gauge_length import rigid_motion
from validation.frame.record import Record
from validation.measures.fem_cylinder import SHAPE, Continuum

COUNT, SPREAD = 10_000, 0.25


def unit_loads(points: np.ndarray, weight: np.ndarray) -> np.ndarray:
    """Nodal loads of a unit force along x and y, one along z, and a unit moment about x, (3 n, 4)."""
    loads = np.zeros((len(points), 3, 4))
    share = weight / weight.sum()
    loads[:, 0, 0] = loads[:, 1, 1] = loads[:, 2, 2] = share
    y, z = points[:, 1:].T
    polar = (share * (y * y + z * z)).sum()
    loads[:, 1, 3], loads[:, 2, 3] = -share * z / polar, share * y / polar
    return loads.reshape(-1, 4)


def seven_tests(model: Continuum, held, loads, measure, pushed, arrived) -> dict[str, float]:
    """Measured over theory, less one, of one way of holding and loading; names as in `results.json` of a study.

    `measure` and `arrived` turn displacements (n, 3) into the motion of the loaded and of the far face (6,).
    """
    bar = model.bar
    solve = model.solver(held)
    shapes = np.stack([solve(load) for load in loads.T], axis=1)
    u = shapes.reshape(len(model.points), 3, 4)
    axial, bending, torsion = model.frequencies(solve, shapes)
    deflection = measure(u[:, :, 1])[1]
    ratios = {
        "static_tension": measure(u[:, :, 0])[0] / bar.extension(1.0),
        "static_bending": deflection / bar.deflection(1.0),
        "static_bending_timoshenko": deflection / bar.deflection(1.0, shear=True),
        "static_torsion": measure(u[:, :, 3])[3] / bar.twist(1.0),
        "dynamic_tension": axial / bar.axial_frequency,
        "dynamic_bending": bending / bar.bending_frequency,
        "dynamic_torsion": torsion / bar.torsional_frequency,
        "impact": model.celerity(pushed, arrived),
    }
    return {name: float(ratio) - 1.0 for name, ratio in ratios.items()}


def face(model: Continuum) -> dict[str, float]:
    """The face x = 0 held, tractions on the face x = L."""
    x = model.points[:, 0]
    near, end = x < 1e-9, np.abs(x - SHAPE.length) < 1e-9
    weight, share = (np.where(chosen, model.lumped[::3], 0.0) for chosen in (end, near))

    def loaded(u: np.ndarray) -> np.ndarray:
        return np.concatenate([weight @ u / weight.sum(), rigid_motion(model.points[end], u[end])[3:]])

    def far(u: np.ndarray) -> np.ndarray:
        return share @ u / share.sum()

    return seven_tests(model, near, unit_loads(model.points, weight), loaded, end, far)


def spheres(model: Continuum, lattice: bd.Lattice) -> dict[str, float]:
    """Held and loaded at the spheres of a packing."""
    particles = lattice.particles
    first, last = (bd.Face(name).select(lattice) for name in ("x_min", "x_max"))
    held, inside = (_inside(model, particles, chosen) for chosen in (first, last))
    share = inside / inside.sum(axis=1, keepdims=True)
    centres = share @ model.points
    loads = np.einsum("pn,pck->nck", share, _sphere_loads(lattice, len(last)))
    far_share = held.sum(axis=0) / held.sum()

    def loaded(u: np.ndarray) -> np.ndarray:
        moved = share @ u
        return np.concatenate([moved.mean(axis=0), rigid_motion(centres, moved)[3:]])

    def far(u: np.ndarray) -> np.ndarray:
        return far_share @ u

    gripped, pushed = ((part > 0.0).any(axis=0) for part in (held, inside))
    return seven_tests(model, gripped, loads.reshape(-1, 4), loaded, pushed, far)


def _inside(model: Continuum, particles: bd.Particles, chosen: np.ndarray) -> np.ndarray:
    """Mass of the points that lie in each sphere, (spheres, points); at least the nearest one."""
    distance = np.linalg.norm(model.points[None] - particles.position[chosen][:, None], axis=2)
    inside = distance <= particles.radius[chosen][:, None]
    inside[np.arange(len(chosen)), distance.argmin(axis=1)] = True
    return inside * model.lumped[::3]


def _sphere_loads(lattice: bd.Lattice, count: int) -> np.ndarray:
    """Forces on the spheres as `bd.Load` gives them, (spheres, 3, 4)."""
    loads = np.zeros((count, 3, 4))
    for k, (force, moment) in enumerate([((1, 0, 0), 0), ((0, 1, 0), 0), ((0, 0, 1), 0), ((0, 0, 0), 1)]):
        _, nodal = bd.Load(bd.Face("x_max"), force=force, moment=(moment, 0, 0)).nodal(lattice)
        loads[:, :, k] = nodal[:, :3]
    return loads


def measure(record: Record, *, cells: tuple[int, ...] = (8, 12, 16), common: int = 12, packings: int = 5) -> None:
    """Solve on several meshes.

    Args:
        cells: across the section, of each mesh.
        common: cells of the mesh on which all packings are solved.
        packings: how many.
    """
    lattices = [bd.connect(bd.pack(SHAPE, count=COUNT, spread=SPREAD, seed=1 + k)) for k in range(packings)]
    record.keep(cells=cells, common=common)
    for each in cells:
        model = Continuum(each)
        for seed in [*range(1, 1 + (packings if each == common else 1)), *([None] if each == common else [])]:
            record.add(
                partial(held, model, lattices[seed - 1] if seed else None), "runs", way="spheres" if seed else "face",
                seed=seed, cells=each,
            )  # fmt: skip


def held(model: Continuum, lattice: bd.Lattice | None) -> dict[str, Any]:
    """Errors of one way on one mesh."""
    return {"unknowns": model.K.shape[0], "error": spheres(model, lattice) if lattice else face(model)}
