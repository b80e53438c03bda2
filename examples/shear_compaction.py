"""Shear compaction: grains on a grid, pressed from above while two walls shear them to and fro.

Physics: the recipe of André et al. (2012, §4.1, fig 3) as a run with contacts. One wall comes down under a given
pressure, two opposite ones move sinusoidally, the others only repel. The grains (κ = 25 %) leave their grid and jam
at random while the pressure wall follows: a free platen, which swings about its load.

Expected: random close packing, 0.636, less what smooth walls cost a box nine grains wide: 0.595. The mean pressure
is that asked for. Takes about 33 s of a core. Run it with:  python examples/shear_compaction.py [FOLDER]
"""

import sys
from pathlib import Path

import numpy as np

import bondem as bd
from bondem.report.compaction_figure import Course, draw_compaction

RADIUS, SPREAD, DENSITY = 0.5e-3, 0.25, 2500.0  # mean [m], κ [-], kg/m³
PRESSURE, MODULUS = 1e5, 1e8  # Pa: grains overlap by a thousandth
STRAIN, INERTIAL = 0.1, 0.01  # to either side; fastest rate · d √(ρ/p), slow enough to be quasi-static


def main(count: int = 1200, cycles: int = 8, folder: Path | None = None) -> Course:
    """How it went; into a folder go the grains after each cycle, for ParaView."""
    random = np.random.default_rng(1)
    radius = RADIUS * random.permutation(np.linspace(1.0 - 0.5 * SPREAD, 1.0 + 0.5 * SPREAD, count))
    edge, side = 2.02 * radius.max(), max(round((0.7 * count) ** (1.0 / 3.0)), 2)
    layer, place = np.divmod(np.arange(count), side * side)
    # stacked dead straight they would stay so
    grid = edge * (np.column_stack([*np.divmod(place, side), layer]) + random.uniform(0.495, 0.505, (count, 3)))
    width, top, pace = side * edge, (layer[-1] + 1.0) * edge, np.sqrt(PRESSURE / DENSITY)  # m, m, m/s
    period, fall = 4.0 * np.pi * STRAIN * RADIUS / (INERTIAL * pace), 2.0 * top / pace
    phase = np.linspace(0.0, cycles, 32 * cycles + 1)
    sway = 0.5 * STRAIN * width * np.sin(2.0 * np.pi * phase)
    right, left = (bd.Driven(x=bd.Table(fall + period * phase, sign * sway)) for sign in (1.0, -1.0))
    platen = bd.Servo(PRESSURE * width**2, speed=0.3 * pace)
    far, (x, y, z) = np.array([width, width, top]), np.eye(3)
    walls = [bd.PlaneWall(far, -z, motion=platen), bd.PlaneWall(far, -x, motion=right), bd.PlaneWall(far, -y),
             bd.PlaneWall(0 * x, x, motion=left), bd.PlaneWall(0 * y, y), bd.PlaneWall(0 * z, z)]  # fmt: skip
    law = bd.LinearContact(E=MODULUS, damping=0.1, stress_free=False)
    model = bd.Model(bd.Lattice(bd.Particles(grid, radius), []), None, density=DENSITY, contact=law, walls=walls)
    gauges = {"platen": bd.WallGauge(0, "displacement"), "force": bd.WallGauge(0, "force"),
              "sway": bd.WallGauge(1, "displacement")}  # fmt: skip
    histories, frames, state = [], [grid], None
    for k in range(cycles + 1):  # the fall, then cycle by cycle: pauses change no bit
        run = bd.solve_explicit(model, duration=period if k else fall, state=state, gauges=gauges, every=50)
        state = run.state
        histories.append(run.history)
        frames.append(state.position)
        if folder is not None:
            bd.write_vtkhdf(folder / f"grains_{k:02d}.vtkhdf", model.lattice, state=state)
    return Course(tuple(histories), tuple(frames), radius, width, top, PRESSURE)


if __name__ == "__main__":
    course = main(folder=Path(sys.argv[1]) if len(sys.argv) > 1 else None)
    print("φ = {:.3f}, pressure held over asked {:.3f} ± {:.3f}".format(course.fraction[-1], *course.reached))
    if len(sys.argv) > 1:
        draw_compaction(Path(sys.argv[1]) / "shear_compaction.png", course)
