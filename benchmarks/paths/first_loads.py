"""A first load in one direction and a second one in another; and cycles below the strength."""

import itertools
import math
from functools import cache

import numpy as np

import bondem as bd
from paths.affine import sheared
from paths.driving import E, LAW, MOHR, NU, RANKINE, SIDE, TENSION, Course, course, cube
from paths.rows import Row

#: First loads along x over f_t / E, and how far strength and stiffness of the second load may be off [-].
FIRST = {1.02: 0.05, 2.0: 0.08}
#: Of the modulus in compression after such a tension.
PRESSED = 0.03
CRITERIA = {"Rankine": RANKINE, "Mohr-Coulomb": MOHR}
#: Stress of the cycles over f_t, and their number in a run and in a full one.
LEVEL, FEW, MANY = 0.9, 100, 1000
_STRETCH = TENSION / E * SIDE


@cache
def pulled(criterion: str, reach: float, seed: int, count: int) -> Course:
    """A cube after a first load along x, unloaded and at rest."""
    return course(
        cube(seed, count), CRITERIA[criterion], {"x": (0.0, reach * _STRETCH, 0.0, 0.0)}
    )  # fmt: skip


def cross(seed: int, count: int) -> list[Row]:
    """Strength and stiffness along y and z, in shear, and the modulus in compression, after a tension along x."""
    rows: list[Row] = []
    for (criterion, failure), (reach, limit) in itertools.product(CRITERIA.items(), FIRST.items()):
        first = pulled(criterion, reach, seed, count)
        state = first.run.state
        told = f"{criterion}, after {reach:g} f_t/E along x"

        def add(name: str, ratio: float, tolerance: float, note: str, told: str = told) -> None:
            rows.append(Row("cross", f"{told}: {name}", ratio, 1.0, tolerance, seed, count, note=note))

        for axis in ("y", "z") if criterion == "Rankine" else ("y",):
            knots = {axis: (0.0, 1.6 * _STRETCH)}
            second = course(cube(seed, count), failure, knots, state=state, watch=axis, ending=0.7)
            add(f"strength along {axis}", second.peak(axis) / TENSION, limit, second.note)
            add(f"stiffness along {axis}", second.modulus(axis) / E, limit, second.note)
        pressed = course(cube(seed, count), failure, {"x": (0.0, -0.5 * _STRETCH)}, state=state)
        add("modulus in compression along x", pressed.modulus("x", 0.2, 0.95) / E, PRESSED, pressed.note)
    return rows


def diagonal(seed: int, count: int) -> list[Row]:
    """The same with a second load along the diagonal: shear in the plane of x and y."""
    rows = []
    for reach, limit in FIRST.items():
        state = pulled("Rankine", reach, seed, count).run.state
        second = sheared(cube(seed, count), RANKINE, [(0.0, 0.0), (0.0, 2.5 * (1.0 + NU) * TENSION / E)], state=state)
        told = f"Rankine, after {reach:g} f_t/E along x"
        rows += [
            Row("diagonal", f"{told}: largest σ1 in shear", second.peak / TENSION, 1.0, limit, seed, count),
            Row("diagonal", f"{told}: shear modulus", second.shear_modulus / LAW.G, 1.0, limit, seed, count),
        ]
    return rows


def cycles(seed: int, count: int, number: int = FEW) -> list[Row]:
    """Cycles of tension and back to nothing, below the strength: no facet loses any of its integrity.

    A cycle takes ten periods of the first axial vibration.
    """
    body, top = cube(seed, count), LEVEL * _STRETCH
    period = 2.0 * SIDE / math.sqrt(E / 2400.0)
    share = np.arange(20 * number + 1) / 20.0
    way = bd.Table(10.0 * period * share, 0.5 * top * (1.0 - np.cos(2.0 * np.pi * share)))
    boundary = [bd.Fix(bd.Face("x_min"), translation="x", rotation=""), bd.Drive(bd.Face("x_max"), x=way)]
    run = bd.solve_explicit(
        bd.Model(body, LAW, 2400.0, failure=RANKINE, boundary=boundary), duration=10.0 * period * number,
        damping=bd.MassDamping(alpha=0.1 * math.pi * math.sqrt(E / 2400.0) / SIDE), every=1000,
    )  # fmt: skip
    least = float(run.state.bond_integrity.min())
    note = f"{run.status.value}, imbalance {run.history.imbalance:.1e}"
    return [Row("cycles", f"least integrity after {number} cycles to {LEVEL:g} f_t", least, 1.0, 0.0, seed, count, note=note)]


def many_cycles(seed: int, count: int) -> list[Row]:
    """As many as are asked for."""
    return cycles(seed, count, MANY)
