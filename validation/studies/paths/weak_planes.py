"""Flat planes that are weaker than what is beside them: their own traction decides, and nothing else."""

import itertools
import math
import warnings
from typing import Any

import numpy as np

import bondem as bd
from validation.studies.paths.driving import NU, RHO, Course, E, Floats, course, torn, travel
from validation.studies.paths.mirrored import Halves, halves
from validation.studies.paths.rows import Row

#: Of the planes [Pa, J/m²], and of what is beside them.
F_W, G_W = 1e6, 4.0
WEAK = bd.Rankine(tension=F_W, fracture_energy=G_W)
STRONG = bd.Rankine(tension=10e6, fracture_energy=400.0)
#: Angles between the normal of the plane and the load [degrees]; lateral tension over f_w; limits [-].
ANGLES, LATERAL, LIMIT = (0.0, 30.0, 60.0), (0.0, 1.1, 2.0), 0.05
#: Stress along a plane that has to stay as it is, over f_w.
ALONG = 4.0
SIZE = (80e-3, 40e-3, 40e-3)

#: Beam tests: E [Pa], energy and strength of the plane, length, height and thickness [m], limit [-].
DCB_E, DCB_LIMIT = (5e9, 20e9, 70e9), 0.08
DCB_G = 20.0
DCB_WEAK = bd.Rankine(tension=2e6, fracture_energy=DCB_G)
DCB_STRONG = bd.Rankine(tension=100e6, fracture_energy=1e5)
DCB_SIZE = (120e-3, 20e-3, 10e-3)
# Share of the plane that is cracked where the window begins and ends.
_WINDOW = (0.35, 0.6)
# Of explicit runs: length of the crack at the end over that of the beam, and periods of such an arm that it takes.
_LAST, _PERIODS = 0.75, 8.0


def _pulled(found: Halves, weak: bd.Rankine, reach: float, lateral: float = 0.0) -> Course:
    def sides(begin: float, rise: float) -> list[bd.BoundaryCondition]:
        if lateral == 0.0:
            return []
        grows = bd.Ramp(0.0, 1.0, 2.0 * rise, begin=begin)
        return [bd.Pressure(bd.Face(name), -lateral, schedule=grows) for name in ("y_min", "y_max")]

    failure: dict[Any, bd.Rankine] = {bd.Everything(): STRONG, (found.above, found.below): weak}
    return course(
        found.body, failure, {"x": (0.0, 0.0, reach)}, others=sides, strength=weak.tension, ending=0.01
    )  # fmt: skip


def inclined(seed: int, count: int) -> list[Row]:
    """Peak over f_w of planes at angles to the load, and whether a plane along the load stays as it is."""
    rows = []
    for angle in ANGLES:
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        long = SIZE if angle < 45.0 else (2.0 * SIZE[0], *SIZE[1:])  # so that the plane ends at the sides
        found = halves(long, (c, s, 0.0), seed, count)
        reach = torn(long[0], strength=WEAK.tension / c**2, energy=G_W)
        pulled = _pulled(found, WEAK, reach)
        name = f"plane at {angle:g} degrees: peak over f_w / cos²"
        rows.append(
            Row("planes", name, pulled.peak() * c**2 / WEAK.tension, 1.0, LIMIT, note=pulled.note)
        )  # fmt: skip
    found = halves(SIZE, (0.0, 1.0, 0.0), seed, count)
    pulled = _pulled(found, WEAK, ALONG * WEAK.tension / E * SIZE[0])
    least = float(pulled.run.state.bond_integrity[found.facets].min())
    name = f"plane at 90 degrees: least integrity at {ALONG:g} f_w"
    return [*rows, Row("planes", name, least, 1.0, 0.0, note=pulled.note)]


def lateral(seed: int, count: int) -> list[Row]:
    """Peak and work of a plane across the load with a dead tension beside it, which is there first."""
    found = halves(SIZE, (1.0, 0.0, 0.0), seed, count)
    rows = []
    for share in LATERAL:
        reach = torn(SIZE[0], strength=WEAK.tension, energy=G_W)
        pulled = _pulled(found, WEAK, reach, share * WEAK.tension)
        told = f"plane across, lateral tension {share:g} f_w"
        rows += [
            Row("planes", f"{told}: peak", pulled.peak() / WEAK.tension, 1.0, LIMIT, note=pulled.note),
            Row("planes", f"{told}: G_w", pulled.dissipated() / G_W, 1.0, LIMIT),
        ]
    return rows


def beams(seed: int, count: int) -> list[Row]:
    """Energy that is released per new area of a plane between two beams that are opened at one end (DCB).

    By equilibria, work less stored energy; by a slow run, what cracks dissipate; over a window of steady growth.
    """
    found = halves(DCB_SIZE, (0.0, 1.0, 0.0), seed, count)
    rows = []
    for modulus, (how, released) in itertools.product(DCB_E, (("equilibria", _balanced), ("explicit", _opened))):
        energy, note = released(found, modulus)
        name = f"E = {modulus / 1e9:g} GPa, {how}: released over G_w"
        rows.append(Row("dcb", name, energy / DCB_G, 1.0, DCB_LIMIT, note=note))
    return rows


def _beam(found: Halves, modulus: float, way: float | bd.Schedule, back: float | bd.Schedule) -> bd.Model:
    upper, lower = (bd.Face("x_min") & part for part in (found.above, found.below))
    failure: dict[Any, bd.Rankine] = {bd.Everything(): DCB_STRONG, (found.above, found.below): DCB_WEAK}
    ends = [bd.Drive(upper, y=way), bd.Drive(lower, y=back), bd.Fix(bd.Face("x_max"), translation="xz", rotation="")]
    law = bd.CellBond(E=modulus, nu=NU)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", bd.errors.StrengthWarning)  # nothing beside the plane is to break
        return bd.Model(found.body, law, RHO, failure=failure, boundary=ends)


def _slope(energy: Floats, cracked: Floats, area: float) -> float:
    """Energy over new area in the window [J/m²]; NaN where the crack has not run through it."""
    first, last = np.searchsorted(cracked, [share * area for share in _WINDOW])
    if last >= len(cracked):
        return math.nan
    return float((energy[last] - energy[first]) / (cracked[last] - cracked[first]))


def _balanced(found: Halves, modulus: float) -> tuple[float, str]:
    """Both arms move alike, so that the work of both is twice that of one."""
    path = bd.solve_quasistatic(
        _beam(found, modulus, 1e-4, -1e-4), bd.Face("x_min") & found.above, ripple=0.05, together=0.01, until=0.05,
        most=8000,
    )  # fmt: skip
    size, left = _areas(found.body), np.ones(len(found.body.pairs))
    area = np.zeros(len(path.load))
    for k, now, event in zip(path.bond, path.integrity, path.event, strict=True):
        area[event] += (left[k] - now) * size[k]
        left[k] = now
    cracked = np.concatenate([[0.0], np.cumsum(area)[:-1]])  # before each event
    beside = len(np.setdiff1d(path.bond, found.facets))
    note = f"{path.end}, {len(path.load)} events, {beside} facets beside the plane"
    return _slope(2.0 * (path.work - path.stored), cracked, found.area), note


def _opened(found: Halves, modulus: float) -> tuple[float, str]:
    """The ends of the arms move apart in `_PERIODS` periods of an arm as long as the crack is at the end."""
    long, height, _ = DCB_SIZE
    arm, half = _LAST * long, 0.5 * height
    sound = math.sqrt(modulus / RHO)
    inertia = half**3 / 12.0  # per width
    way = math.sqrt(DCB_G * modulus * inertia) * arm**2 / (3.0 * modulus * inertia)
    period = 2.0 * math.pi * arm**2 / (3.52 * half / math.sqrt(12.0) * sound)
    times, values = travel([(0.0,), (way,)], way / (_PERIODS * period), period)
    size = _areas(found.body)
    cracked: list[float] = []

    def read(state: bd.State, _record: bd.History) -> bool:
        cracked.append(float(size @ (1.0 - state.bond_integrity)))
        return cracked[-1] > _WINDOW[1] * found.area

    opens = [bd.Table(times, sign * values[:, 0]) for sign in (1.0, -1.0)]
    run = bd.solve_explicit(
        _beam(found, modulus, *opens), duration=float(times[-1]), damping=bd.MassDamping(alpha=2.0 / period),
        callback=read, every=50,
    )  # fmt: skip
    fracture = run.history.released[: len(cracked)]
    note = f"{run.status.value}, imbalance {run.history.imbalance:.1e}, cracked {cracked[-1] / found.area:.2f}"
    return _slope(fracture, np.maximum.accumulate(cracked), found.area), note


def _areas(body: bd.Lattice) -> Floats:
    assert body.facets is not None
    return body.facets.area
