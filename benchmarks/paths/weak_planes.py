"""Flat planes that are weaker than what is beside them: their own traction decides, and nothing else."""

import math

import numpy as np

import bondem as bd
from paths.driving import Course, course, torn
from paths.mirrored import Halves, halves
from paths.rows import Row

#: Of the planes [Pa, J/m²], and of what is beside them.
WEAK = bd.Rankine(tension=1e6, fracture_energy=4.0)
STRONG = bd.Rankine(tension=10e6, fracture_energy=400.0)
#: Angles between the normal of the plane and the load [degrees]; lateral tension over f_w; limits [-].
ANGLES, LATERAL, LIMIT = (0.0, 30.0, 60.0), (0.0, 1.1, 2.0), 0.05
#: Stress along a plane that has to stay as it is, over f_w.
ALONG = 4.0
SIZE = (80e-3, 40e-3, 40e-3)

#: Beam tests: E [Pa], energy and strength of the plane, length, height and thickness [m], limit [-].
DCB_E, DCB_LIMIT = (5e9, 20e9, 70e9), 0.08
DCB_WEAK = bd.Rankine(tension=2e6, fracture_energy=20.0)
DCB_STRONG = bd.Rankine(tension=100e6, fracture_energy=1e5)
DCB_SIZE = (120e-3, 20e-3, 10e-3)
# Share of the plane that is cracked where the window begins and ends.
_WINDOW = (0.35, 0.65)


def _pulled(found: Halves, weak: bd.Rankine, reach: float, lateral: float = 0.0) -> Course:
    def sides(begin: float, rise: float) -> list[bd.BoundaryCondition]:
        if lateral == 0.0:
            return []
        grows = bd.Ramp(0.0, 1.0, 2.0 * rise, begin=begin)
        return [bd.Pressure(bd.Face(name), -lateral, schedule=grows) for name in ("y_min", "y_max")]

    failure = {bd.Everything(): STRONG, (found.above, found.below): weak}
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
        reach = torn(long[0], strength=WEAK.tension / c**2, energy=WEAK.fracture_energy)
        pulled = _pulled(found, WEAK, reach)
        name = f"plane at {angle:g} degrees: peak over f_w / cos²"
        rows.append(
            Row("planes", name, pulled.peak() * c**2 / WEAK.tension, 1.0, LIMIT, seed, count, note=pulled.note)
        )  # fmt: skip
    found = halves(SIZE, (0.0, 1.0, 0.0), seed, count)
    pulled = _pulled(found, WEAK, ALONG * WEAK.tension / 40e9 * SIZE[0])
    least = float(pulled.run.state.bond_integrity[found.facets].min())
    name = f"plane at 90 degrees: least integrity at {ALONG:g} f_w"
    return [*rows, Row("planes", name, least, 1.0, 0.0, seed, count, note=pulled.note)]


def lateral(seed: int, count: int) -> list[Row]:
    """Peak and work of a plane across the load with a dead tension beside it, which is there first."""
    found = halves(SIZE, (1.0, 0.0, 0.0), seed, count)
    rows = []
    for share in LATERAL:
        reach = torn(SIZE[0], strength=WEAK.tension, energy=WEAK.fracture_energy)
        pulled = _pulled(found, WEAK, reach, share * WEAK.tension)
        told = f"plane across, lateral tension {share:g} f_w"
        rows += [
            Row("planes", f"{told}: peak", pulled.peak() / WEAK.tension, 1.0, LIMIT, seed, count, note=pulled.note),
            Row("planes", f"{told}: G_w", pulled.dissipated() / WEAK.fracture_energy, 1.0, LIMIT, seed, count),
        ]
    return rows


def beams(seed: int, count: int) -> list[Row]:
    """Energy that is released per new area of a plane between two beams that are opened at one end (DCB).

    Work less stored energy over a window of steady growth, by equilibria; both arms move alike.
    """
    found = halves(DCB_SIZE, (0.0, 1.0, 0.0), seed, count)
    rows = []
    for modulus in DCB_E:
        released, note = _released(found, modulus)
        name = f"DCB, E = {modulus / 1e9:g} GPa: released over G_w"
        rows.append(
            Row("dcb", name, released / DCB_WEAK.fracture_energy, 1.0, DCB_LIMIT, seed, count, note=note)
        )  # fmt: skip
    return rows


def _released(found: Halves, modulus: float) -> tuple[float, str]:
    body = found.body
    upper, lower = (bd.Face("x_min") & part for part in (found.above, found.below))
    ends = [
        bd.Drive(upper, y=1e-4), bd.Drive(lower, y=-1e-4), bd.Fix(bd.Face("x_max"), translation="xz", rotation="")
    ]  # fmt: skip
    failure = {bd.Everything(): DCB_STRONG, (found.above, found.below): DCB_WEAK}
    model = bd.Model(body, bd.CellBond(E=modulus, nu=0.2), 2400.0, failure=failure, boundary=ends)
    path = bd.solve_quasistatic(model, upper, ripple=0.05, together=0.01, until=0.05, most=8000)
    area = np.zeros(len(path.load))
    left = np.ones(len(body.pairs))
    assert body.facets is not None
    for k, now, event in zip(path.bond, path.integrity, path.event, strict=True):
        area[event] += (left[k] - now) * body.facets.area[k]
        left[k] = now
    cracked = np.concatenate([[0.0], np.cumsum(area)[:-1]])  # before each event
    first, last = np.searchsorted(cracked, [share * found.area for share in _WINDOW])
    if last >= len(cracked):
        return math.nan, f"{path.end} at {cracked[-1] / found.area:.2f} of the plane"
    spent = 2.0 * (path.work - path.stored)
    released = float((spent[last] - spent[first]) / (cracked[last] - cracked[first]))
    others = np.setdiff1d(path.bond, found.facets)
    return released, f"{path.end}, {len(path.load)} events, {len(others)} facets beside the plane"

