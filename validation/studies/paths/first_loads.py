"""A first load in one direction and a second one in another; and cycles below the strength."""

import itertools
import math
from dataclasses import replace
from functools import cache

import numpy as np

import bondem as bd
from validation.studies.paths.affine import sheared
from validation.studies.paths.driving import LAW, MOHR, NU, RANKINE, RHO, SIDE, TENSION, Course, E, course, cube
from validation.studies.paths.rows import Row

#: First loads along x over f_t / E, and how far strength and stiffness of a second load across may be off [-].
FIRST = {1.02: 0.03, 2.0: 0.03}
#: The same of a second load along the diagonal, which shears the crack of the first one.
DIAGONAL = {1.02: 0.05, 2.0: 0.08}
#: Of the modulus in compression after such a tension.
PRESSED = 0.03
#: Criteria and edges of the cubes [m]: the smaller and tougher one softens all over before a crack localises.
CUBES: dict[str, tuple[bd.Criterion, float]] = {
    "Rankine, 80 mm": (RANKINE, SIDE),
    "Rankine, 40 mm": (replace(RANKINE, fracture_energy=100.0), 40e-3),
    "Mohr-Coulomb, 40 mm": (replace(MOHR, fracture_energy=100.0), 40e-3),
}
#: Further directions of the second load in the first of them.
ALSO = {"Rankine, 80 mm": ("z",)}
#: Stress of the cycles over f_t, and their number in a run and in a full one.
LEVEL, FEW, MANY = 0.9, 100, 1000


def stretch(name: str) -> float:
    """Of a cube by f_t / E [m]."""
    return TENSION / E * CUBES[name][1]


@cache
def pulled(name: str, reach: float, seed: int, count: int) -> Course:
    """A cube after a first load along x, unloaded and at rest."""
    failure, side = CUBES[name]
    return course(cube(seed, count, side), failure, {"x": (0.0, reach * stretch(name), 0.0, 0.0)})


def cross(seed: int, count: int) -> list[Row]:
    """Strength and stiffness along y and z, and the modulus in compression, after a tension along x."""
    rows: list[Row] = []
    for (name, (failure, side)), (reach, limit) in itertools.product(CUBES.items(), FIRST.items()):
        body, long = cube(seed, count, side), stretch(name)
        state = pulled(name, reach, seed, count).run.state
        found: list[tuple[str, float, float, str]] = []
        for axis in ("y", *ALSO.get(name, ())):
            second = course(body, failure, {axis: (0.0, 1.6 * long)}, state=state, watch=axis, ending=0.7)
            found += [
                (f"strength along {axis}", second.peak(axis) / TENSION, limit, second.note),
                (f"stiffness along {axis}", second.modulus(axis) / E, limit, second.note),
            ]
        pressed = course(body, failure, {"x": (0.0, -0.5 * long)}, state=state)
        found.append(("modulus in compression along x", pressed.modulus("x", 0.2, 0.95) / E, PRESSED, pressed.note))
        told = f"{name}, after {reach:g} f_t/E along x"
        rows += [
            Row("cross", f"{told}: {what}", ratio, 1.0, tolerance, note=note)
            for what, ratio, tolerance, note in found
        ]
    return rows


def diagonal(seed: int, count: int) -> list[Row]:
    """The same with a second load along the diagonal: shear in the plane of x and y."""
    rows = []
    for reach, limit in DIAGONAL.items():
        state = pulled("Rankine, 80 mm", reach, seed, count).run.state
        second = sheared(cube(seed, count), RANKINE, [(0.0, 0.0), (0.0, 2.5 * (1.0 + NU) * TENSION / E)], state=state)
        told = f"Rankine, 80 mm, after {reach:g} f_t/E along x"
        rows += [
            Row("diagonal", f"{told}: largest σ1 in shear", second.peak / TENSION, 1.0, limit),
            Row("diagonal", f"{told}: shear modulus", second.shear_modulus / LAW.G, 1.0, limit),
        ]
    return rows


def cycles(seed: int, count: int, number: int = FEW) -> list[Row]:
    """Cycles of tension and back to nothing, below the strength: no facet loses any of its integrity.

    A cycle takes ten periods of the first axial vibration.
    """
    body, top = cube(seed, count), LEVEL * TENSION / E * SIDE
    sound = math.sqrt(E / RHO)
    period = 2.0 * SIDE / sound
    share = np.arange(20 * number + 1) / 20.0
    way = bd.Table(10.0 * period * share, 0.5 * top * (1.0 - np.cos(2.0 * np.pi * share)))
    boundary = [bd.Fix(bd.Face("x_min"), translation="x", rotation=""), bd.Drive(bd.Face("x_max"), x=way)]
    run = bd.solve_explicit(
        bd.Model(body, LAW, RHO, failure=RANKINE, boundary=boundary), duration=10.0 * period * number,
        damping=bd.MassDamping(alpha=0.1 * math.pi * sound / SIDE), every=1000,
    )  # fmt: skip
    least = float(run.state.bond_integrity.min())
    note = f"{run.status.value}, imbalance {run.history.imbalance:.1e}"
    name = f"least integrity after {number} cycles to {LEVEL:g} f_t"
    return [Row("cycles", name, least, 1.0, 0.0, note=note)]


def many_cycles(seed: int, count: int) -> list[Row]:
    """As many as are asked for."""
    return cycles(seed, count, MANY)
