"""Cracks whose direction changes: principal axes that turn while they open, and two notches apart along a bar."""

import math
from dataclasses import replace
from functools import cache

import bondem as bd
from validation.studies.paths.affine import sheared
from validation.studies.paths.driving import ENERGY, NU, RANKINE, TENSION, E, course, cube
from validation.studies.paths.rows import Row

#: Strains along x and y and shear in proportion from the strain at f_t on (Willam, Pramono and Sture 1987), and the
#: shear at the end over f_t / E.
TURN, FAR = (0.5, 0.75, 1.0), 5.0
#: Fracture energy of that cube [J/m²], and how far the largest principal stress may be from f_t. What is left at the
#: end has no known answer: cells on two faces whose strain is given stay strained.
BRITTLE, PEAK = 10.0, 0.03
#: A bar, notches on both sides, width along x and depth along y, and how far along x one is from the other [m].
BAR, NOTCH, APART = (80e-3, 40e-3, 40e-3), (4e-3, 8e-3), 20e-3
#: What a bar in two parts may bear over f_t on its ligament.
TORN = 0.05


def turned_axes(seed: int, count: int) -> list[Row]:
    """Tension along x to f_t, from there strains whose principal axes turn: σ1 never exceeds f_t."""
    yields = TENSION / E
    x, y, shear = (rate * FAR * yields for rate in TURN)
    points = [(0.0, 0.0, 0.0), (yields, 0.0, -NU * yields), (yields + x, shear, y - NU * yields)]
    found = sheared(cube(seed, count), replace(RANKINE, fracture_energy=BRITTLE), points, ending=None)
    run, told = found.run, "axes that turn after the peak"
    note = f"{run.status.value}, imbalance {run.history.imbalance:.1e}"
    return [Row("curved", f"{told}: largest σ1", found.peak / TENSION, 1.0, PEAK, note=note)]


@cache
def _notched(seed: int, count: int) -> bd.Lattice:
    slot = bd.Box((NOTCH[0], NOTCH[1], 2.0 * BAR[2]))
    shape: bd.Shape = bd.Box(BAR)
    for name, way, y in (("lower", -0.5, 0.0), ("upper", 0.5, BAR[1] - NOTCH[1])):
        x = 0.5 * (BAR[0] - NOTCH[0]) + way * APART
        shape = shape.cut(slot.moved((x, y, -0.5 * BAR[2])), name=name)
    return bd.connect(bd.pack(shape, count=count, method="even", seed=seed), method="laguerre")


def offset(seed: int, count: int) -> list[Row]:
    """A bar with two notches that are apart along it: what it bears at the end, over the section between notches.

    Dissipation is over G_f and the straight line from notch to notch, which the crack need not follow.
    """
    body, stretch, last = _notched(seed, count), 1.05 * TENSION / E * BAR[0], 2.0 * ENERGY / TENSION
    found = course(body, RANKINE, {"x": (0.0, stretch, stretch + 2.5 * last)})
    net = (BAR[1] - 2.0 * NOTCH[1]) / BAR[1]
    line = math.hypot(net * BAR[1], APART) / BAR[1]
    told = "notches on both sides, apart along the bar"
    left, peak = found.left() / net / TENSION, found.peak() / net / TENSION
    return [
        Row("curved", f"{told}: left over f_t", left, 0.0, TORN, note=found.note),
        Row("curved", f"{told}: peak over f_t", peak, 1.0, None),
        Row("curved", f"{told}: G_f over the line between them", found.dissipated() / ENERGY / line, 1.0, None),
    ]  # fmt: skip
