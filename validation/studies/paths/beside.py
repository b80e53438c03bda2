"""Tension beside a pressure or a tension along the crack: no part of it may cross a crack that opens.

The side faces are pressed by rigid platens, or by a dead stress, where one face across z is held along z: two dead
pressures on opposite faces would turn a cube over that nothing holds about the pull. All runs go on to an opening of
one and a half times the last one, so that what is left then, and what halves that push each other apart take up, is
measured. Pressure alone is beside them: a Rankine material cannot crack in it.
"""

import numpy as np

import bondem as bd
from validation.studies.paths.driving import (
    ENERGY,
    NU,
    RANKINE,
    SIDE,
    TENSION,
    TRAVERSES,
    Course,
    E,
    course,
    cube,
    torn,
)
from validation.studies.paths.rows import Row

#: Pressures of platens, and dead stresses on the sides (tension positive), over f_t.
HELD = (0.0, 1.0, 3.0, 6.0, 10.0)
DEAD = (-10.0, -6.0, -3.0, -1.0, -0.5, 0.5, 0.9)
#: How far the peak may be from f_t, the dissipation from G_f over the section [-], and the end from no stress [f_t].
PEAK, WORK, LEFT = 0.02, 0.08, 0.05
#: Pressure of the cube that is only pressed, over f_t, its Poisson's ratio, limits of stress and dissipation [-].
PRESSED, SQUEEZED, STIFFNESS, NOTHING = 40.0, 0.4, 0.01, 0.01
#: Dead stresses over f_t beside cracks that open further, and how far over the last opening.
WIDE, OPENED = (-10.0, -3.0, 0.9), 5.0
_STRETCH = TENSION / E * SIDE


def _rows(told: str, found: Course) -> list[Row]:
    along = found.stress["x"] / TENSION
    least = float(along[int(np.argmax(along)) :].min())
    note = f"{found.note}, least after the peak {least:.3f} f_t"
    return [
        Row("states", f"{told}: peak", found.peak() / TENSION, 1.0, PEAK, note=note),
        Row("states", f"{told}: G_f", found.dissipated() / ENERGY, 1.0, WORK, note=note),
        Row("states", f"{told}: left over f_t", found.left() / TENSION, 0.0, LEFT, note=note),
    ]


def beside(seed: int, count: int) -> list[Row]:
    """Tension along x while rigid platens hold a pressure along y, which is there first."""
    rows = []
    for share in HELD:
        free, quick = NU * share * _STRETCH, max(1.0, share)
        knots = {"x": (0.0, free, free + torn())}
        if share:
            knots["y"] = (0.0, -share * _STRETCH, -share * _STRETCH)
        # the sides come in as slowly as the tension grows afterwards, whatever the pressure
        found = course(cube(seed, count), RANKINE, knots, traverses=TRAVERSES / quick, hurry=1.0 / quick)
        told = f"pressure {share:g} f_t held by platens"
        rows += _rows(told, found)
        if share:
            left = -found.left("y") / TENSION
            rows.append(Row("states", f"{told}: pressure at the end over f_t", left, share, None))
    return rows


def dead(seed: int, count: int) -> list[Row]:
    """Tension along x under a constant stress along y, which is there first."""
    return [
        row for share in DEAD for row in _rows(f"dead stress {share:g} f_t across", _torn(seed, count, share, torn()))
    ]


def wide(seed: int, count: int) -> list[Row]:
    """The same with cracks that open further: what acts along them has to stay while their faces are near."""
    rows = []
    for share in WIDE:
        found = _torn(seed, count, share, OPENED * 2.0 * ENERGY / TENSION)
        rows += _rows(f"dead stress {share:g} f_t across, opened by {OPENED:g}", found)[1:]
    return rows


def _torn(seed: int, count: int, share: float, way: float) -> Course:
    """Tension along x as far as a way [m], under a constant stress along y, over f_t, which is there first."""

    def sides(begin: float, rise: float) -> list[bd.BoundaryCondition]:
        grows = bd.Ramp(0.0, 1.0, 2.0 * rise, begin=begin)
        return [
            bd.Fix(bd.Face("z_min"), translation="z", rotation=""),
            *(bd.Pressure(bd.Face(name), -share * TENSION, schedule=grows) for name in ("y_min", "y_max")),
        ]

    apart = way + NU * max(0.0, -share) * _STRETCH  # what the pressure takes from the tension at first
    return course(cube(seed, count), RANKINE, {"x": (0.0, 0.0, apart)}, others=sides)


def pressed(seed: int, count: int) -> list[Row]:
    """A cube between smooth platens, pressed only: it stays elastic."""
    law = bd.CellBond(E=E, nu=SQUEEZED)
    way = (0.0, -PRESSED * _STRETCH)
    found = course(cube(seed, count), RANKINE, {"x": way}, law=law, traverses=0.1 * TRAVERSES)
    told = f"pressure alone to {PRESSED:g} f_t, nu = {SQUEEZED:g}"
    stress = found.left() / TENSION
    return [
        Row("states", f"{told}: stress over f_t", -stress, PRESSED, STIFFNESS, note=found.note),
        Row("states", f"{told}: dissipated over G_f", found.dissipated() / ENERGY, 0.0, NOTHING),
    ]
