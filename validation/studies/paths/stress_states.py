"""Tension with another stress beside it: peak and fracture energy, where principal axes stay and where they turn."""

import bondem as bd
from validation.studies.paths.affine import sheared
from validation.studies.paths.driving import ENERGY, NU, RANKINE, SIDE, TENSION, E, course, cube, torn
from validation.studies.paths.rows import Row

#: How far the peak may be from σ1 = f_t, and what cracks dissipate over the ligament from G_f [-].
PEAK, WORK = 0.02, 0.08
#: What may be left of f_t in either direction, where both are pulled until both cracks are open.
LEFT = 0.1
#: Poisson's ratios of tension with held sides.
HELD = (0.2, 0.4)
#: Strains along x and y over f_t / E at which σ_x = f_t, by ratio of the stresses along y and x.
RATIOS = {1.0: "biaxial 1:1", 0.5: "biaxial 1:1/2", -1.0: "pure shear"}
#: Where the proportional path ends, over the strain at which σ_x = f_t.
PAST = 1.02
_STRETCH = TENSION / E * SIDE


def _pair(told: str, peak: float, work: float, note: str) -> list[Row]:
    return [
        Row("states", f"{told}: peak", peak / TENSION, 1.0, PEAK, note=note),
        Row("states", f"{told}: G_f", work / ENERGY, 1.0, WORK, note=note),
    ]


def proportional(seed: int, count: int) -> list[Row]:
    """σ_x and σ_y in proportion until the strain of the peak; from there on only x goes on, and y is held."""
    rows = []
    for ratio, told in RATIOS.items():
        x, y = (1.0 - NU * ratio) * PAST * _STRETCH, (ratio - NU) * PAST * _STRETCH
        knots = {"x": (0.0, x, x + torn()), "y": (0.0, y, y)}
        found = course(cube(seed, count), RANKINE, knots, ending=0.005)
        rows += _pair(told, found.peak("x"), found.dissipated("x"), found.note)
    return rows


def equibiaxial(seed: int, count: int) -> list[Row]:
    """Both axes pulled alike, until a crack across each of them would be open."""
    both = (0.0, (1.0 - NU) * PAST * _STRETCH, (1.0 - NU) * PAST * _STRETCH + torn())
    found = course(cube(seed, count), RANKINE, {"x": both, "y": both})
    rows = []
    for axis in ("x", "y"):
        told = f"both axes to the end, along {axis}"
        peak, left = found.peak(axis) / TENSION, found.left(axis) / TENSION
        rows += [
            Row("states", f"{told}: peak", peak, 1.0, PEAK, note=found.note),
            Row("states", f"{told}: left over f_t", left, 0.0, LEFT, note=found.note),
        ]
    told, both = "both axes to the end: dissipated over G_f", found.dissipated() / ENERGY
    return [*rows, Row("states", told, both, 2.0, None, note=found.note)]


def held(seed: int, count: int) -> list[Row]:
    """Tension between held sides."""
    rows = []
    for nu in HELD:
        law = bd.CellBond(E=E, nu=nu)
        stretch = (1.0 + nu) * (1.0 - 2.0 * nu) / (1.0 - nu) * _STRETCH
        knots = {"x": (0.0, stretch + torn()), "y": (0.0, 0.0), "z": (0.0, 0.0)}
        found = course(cube(seed, count), RANKINE, knots, law=law, ending=0.005)
        rows += _pair(f"sides held, nu = {nu:g}", found.peak("x"), found.dissipated("x"), found.note)
    return rows


def turning(seed: int, count: int) -> list[Row]:
    """Tension to 0.9 f_t and then shear, in a homogeneous strain; tension past the peak, then opening and sliding."""
    body = cube(seed, count)
    first = 0.9 * TENSION / E
    found = sheared(body, RANKINE, [(0.0, 0.0), (first, 0.0), (first, 3.0 * TENSION / E)])
    rows = [Row("states", "tension, then shear: peak", found.peak / TENSION, 1.0, PEAK)]
    knots = {"x": (0.0, 1.2 * _STRETCH, 1.2 * _STRETCH + torn())}
    slid = course(body, RANKINE, knots, slide=(0.0, 0.0, torn()), ending=0.005)
    told, work = "tension past the peak, then opening and sliding: G_f", slid.dissipated("x")
    rows.append(Row("states", told, work / ENERGY, 1.0, WORK, note=slid.note))
    return rows
