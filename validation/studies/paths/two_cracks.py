"""Two cracks that open as opposite wedges: the second solution of a body that is torn between parallel faces.

A uniform body whose faces stay parallel can be torn by one crack that opens evenly, or by two that open by
w (1 - z/L) and w z/L: the part between them turns, and both keep a hinge in which it is pressed. What either solution
takes is known from a rigid block between two cohesive beds, which have the compliance of the body. Flaws decide which
one a body follows: here two strips at opposite ends that are weaker, or one section that is.
"""

from typing import Any

import numpy as np

import bondem as bd
from validation.studies.paths.driving import ENERGY, NU, SIDE, TENSION, Course, E, Floats, course, cube, torn
from validation.studies.paths.rows import Row

#: How much weaker strips are than the rest, and the section; depth of the strips and of the section [m].
STRIPS, SECTION, DEPTH, WIDTH = 0.02, 0.3, 14e-3, 22e-3
#: Limits of the dissipation over that of the block, and of what is left [f_t].
WORK, LEFT = 0.08, 0.05
#: Pressure along the crack, over f_t.
BESIDE = 1.0
#: Displacement between the wide and the narrow end of a wedge, over the last opening, from which it is one.
TILTED = 0.5
LAST = 2.0 * ENERGY / TENSION
_POINTS, _STEP, _ROUNDS, _EXACT = 200, 2e-8, 4000, 1e-6


class _Bed:
    """Springs of stiffness k over the section, with cracks that soften along a line and close to their origin."""

    def __init__(self, stiffness: float) -> None:
        self.k, self.opened = stiffness, np.zeros(_POINTS)

    def stress(self, stretch: Floats) -> Floats:
        """Of every spring [Pa], (k,), and keep how far its crack has been open."""
        softening = (stretch - TENSION / self.k) / (1.0 - TENSION / (LAST * self.k))
        self.opened = np.maximum(self.opened, np.clip(softening, 0.0, LAST))
        strength = TENSION * (1.0 - self.opened / LAST)
        with np.errstate(divide="ignore"):
            compliance = np.where(strength > 0.0, self.opened / strength, np.inf) + 1.0 / self.k
        return np.where(stretch > 0.0, stretch / compliance, self.k * stretch)


def wedges(reach: float) -> tuple[float, float]:
    """Dissipation over G_f and stress over f_t of a block between two wedges, at a distance of the faces [m]."""
    k = 2.0 * E / SIDE
    z = ((np.arange(_POINTS) + 0.5) / _POINTS - 0.5) * SIDE
    near, far = _Bed(k), _Bed(k)
    apart = 0.999 * 2.0 * TENSION / k
    middle, turn, stress = 0.5 * apart, 1e-3 * apart / SIDE, 0.0
    while apart < reach:
        apart, middle = apart + _STEP, middle + 0.5 * _STEP
        for _ in range(_ROUNDS):
            pulls = far.stress(apart - middle - turn * z) - near.stress(middle + turn * z)
            force, couple = float(pulls.mean()), float((pulls * z).mean())
            if abs(force) < _EXACT * TENSION and abs(couple) < _EXACT * TENSION * SIDE:
                break
            middle, turn = middle + 0.45 * force / k, turn + 0.45 * couple / (k * float((z**2).mean()))
        stress = float(near.stress(middle + turn * z).mean())
    spent = 0.5 * TENSION * float((near.opened + far.opened).mean())
    return spent / ENERGY, stress / TENSION


def wedged(seed: int, count: int) -> list[Row]:
    """Tension beside a held pressure: strips that are weaker at opposite ends, then one section that is."""
    return [*strips(seed, count), *section(seed, count)]


def strips(seed: int, count: int) -> list[Row]:
    """The cube whose strips at opposite ends are weaker; what is exact is that of the solution which it follows."""
    low, high = _slab(2, 0.0, 0.5 * SIDE), _slab(2, 0.5 * SIDE, SIDE)
    weak = (_slab(0, 0.0, DEPTH) & low) | (_slab(0, SIDE - DEPTH, SIDE) & high)
    found = _torn(seed, count, weak, STRIPS)
    twice = _tilt(found, cube(seed, count)) > TILTED
    spent, left = wedges(NU * BESIDE * TENSION / E * SIDE + torn()) if twice else (1.0, 0.0)
    told = f"weaker strips at opposite ends, torn {'twice: two wedges' if twice else 'once'}"
    return _rows(told, found, spent, left)


def section(seed: int, count: int) -> list[Row]:
    """The cube with one section that is weaker: it is torn there, once."""
    weak = _slab(0, 0.5 * (SIDE - WIDTH), 0.5 * (SIDE + WIDTH))
    return _rows("one section weaker", _torn(seed, count, weak, SECTION), 1.0, 0.0)


def _rows(told: str, found: Course, spent: float, left: float) -> list[Row]:
    rest = found.left() / TENSION - left
    return [
        Row("states", f"{told}: G_f", found.dissipated() / ENERGY, spent, WORK, note=found.note),
        Row("states", f"{told}: left over f_t, less what is exact", rest, 0.0, LEFT, note=found.note),
    ]


def _slab(axis: int, begin: float, end: float) -> bd.Region:
    """Elements between two planes across an axis."""
    size, origin = [3.0 * SIDE] * 3, [-SIDE] * 3
    size[axis], origin[axis] = end - begin, begin
    return bd.Within(bd.Box((size[0], size[1], size[2])).moved((origin[0], origin[1], origin[2])))


def _torn(seed: int, count: int, weak: bd.Region, share: float) -> Course:
    """Torn with a region whose strength is lower by a share, and whose G_f is the same."""
    strength = {bd.Everything(): TENSION, weak: (1.0 - share) * TENSION}
    softened = {where: bd.Rankine(tension=one, fracture_energy=ENERGY) for where, one in strength.items()}
    failure: dict[Any, bd.Rankine] = softened
    stretch = TENSION / E * SIDE
    free = NU * BESIDE * stretch
    knots = {"x": (0.0, free, free + torn()), "y": (0.0, -BESIDE * stretch, -BESIDE * stretch)}
    return course(cube(seed, count), failure, knots)


def _tilt(found: Course, body: bd.Lattice) -> float:
    """Displacement of the middle between its upper and its lower quarter along z, over the last opening."""
    x, _, z = body.centre.T
    inside, moved = np.abs(x - 0.5 * SIDE) < 0.25 * SIDE, found.run.state.displacement[:, 0]
    upper, lower = inside & (z > 0.75 * SIDE), inside & (z < 0.25 * SIDE)
    return float(abs(moved[upper].mean() - moved[lower].mean())) / LAST
