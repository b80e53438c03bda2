"""Equilibria (`bd.solve_quasistatic`) with a pressure along the crack: cubes that are torn, and split discs.

The pressure on two sides of a cube grows with its stretch: it is q f_t where the cube begins to crack, and some
2 to 5 times that where it parts. Discs are those of `discs.py`, between platens that approach.
"""

import bondem as bd
from validation.studies import brazilian
from validation.studies.paths.beside import PEAK, WORK
from validation.studies.paths.discs import LIMIT, disc, energy_of, expected
from validation.studies.paths.driving import ENERGY, LAW, NU, RANKINE, RHO, SIDE, TENSION, E, cube
from validation.studies.paths.rows import Row

#: Pressures on the sides where cubes begin to crack, over f_t, and E G_f / f_t² of discs over the diameter.
PRESSURES, SHARES = (0.0, 1.0, 3.0, 6.0, 10.0), (0.25, 1.0)
# Band and simultaneous failures of discs, and the share of the peak at which their paths end.
_RIPPLE, _TOGETHER, _UNTIL = 0.05, 0.01, 0.85


def pressed_equilibria(seed: int, count: int) -> list[Row]:
    """Peak and dissipation of cubes torn along x while a pressure along y grows with the load."""
    body, rows = cube(seed, count), []
    for share in PRESSURES:
        sides = [bd.Pressure(bd.Face("y_max"), share * TENSION)] if share else []
        model = bd.Model(body, LAW, RHO, failure=RANKINE, boundary=[
            *(bd.Fix(bd.Face(f"{axis}_min"), translation=axis, rotation="") for axis in "xyz"),
            bd.Drive(bd.Face("x_max"), x=(1.0 + NU * share) * TENSION / E * SIDE), *sides,
        ])  # fmt: skip
        path = bd.solve_quasistatic(model, bd.Face("x_max"))
        name, note = f"equilibria, pressure {share:g} f_t along the crack", f"{path.end}, {len(path.load)} events"
        rows += [
            Row("states", f"{name}: peak", path.peak / (TENSION * SIDE**2), 1.0, PEAK, note=note),
            Row("states", f"{name}: G_f", float(path.energy.sum()) / (ENERGY * SIDE**2), 1.0, WORK, note=note),
        ]
    return rows


def disc_equilibria(seed: int, count: int) -> list[Row]:
    """Strength of split discs over that of finite elements with one cohesive crack."""
    body, rows = disc(count, seed), []
    for share in SHARES:
        failure = bd.Rankine(tension=brazilian.TENSION, fracture_energy=energy_of(share))
        ends = [bd.Drive(bd.Face(name), y=sign * 1e-6) for name, sign in (("top", -1.0), ("bottom", 1.0))]
        model = bd.Model(body, brazilian.LAW, brazilian.DENSITY, failure=failure, boundary=ends)
        path = bd.solve_quasistatic(model, bd.Face("top"), ripple=_RIPPLE, together=_TOGETHER, until=_UNTIL)
        name = f"equilibria, E G_f / f_t² = {share:g} D: strength over f_t"
        note = f"{path.end}, {len(path.load)} events"
        rows.append(Row("discs", name, path.peak / brazilian.EXPECTED, expected(share) or 1.0, LIMIT, note=note))
    return rows
