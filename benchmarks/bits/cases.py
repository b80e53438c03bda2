"""Cases whose bits must not change: every kind of bond, load, damping, rotation and contact."""

from collections.abc import Callable
from functools import partial

import numpy as np

import bondem as bd
from bits.case import (
    ALIKE,
    CONTACT,
    GRIDS,
    NU,
    RATIO,
    ROUND,
    SHORT,
    Case,
    E,
    bonded,
    crooked,
    density,
    patches,
    random_motion,
    rows,
    wave_of,
    weakened,
)

LOCAL = {"damping": bd.LocalDamping(0.1)}
#: Conditions on a crooked grid, by the part of it they act on.
FLOOR = bd.Fix(bd.Face("z_min", depth=0.5))
CLAMP = bd.Fix(bd.Face("x_min", depth=0.5))
FRONT = bd.Within(bd.Box(size=(4.0, 1e3, 1e3)))
SOAKED = [bd.Absorbing(bd.Face(name, depth=0.5), density=150.0, E=1e6, nu=0.2) for name in ("x_max", "z_min")]


def law(kind: type[bd.EulerBernoulli | bd.Timoshenko | bd.ParallelBond], **options: str):
    return kind(E=E, nu=NU, radius_ratio=RATIO, **options)


def driven(size: int) -> Case:
    """Return a case whose second run has other boundary conditions than the first."""
    lattice = crooked(size)
    first = bonded(lattice, bond=patches(lattice), boundary=rows(lattice))
    pull = bd.Load(bd.Face("z_max", depth=0.5), force=(0.0, 0.0, 5e3))
    then = first.model.with_boundary([bd.Fix(bd.Face("z_min", depth=0.5)), pull])
    return Case(model=first.model, then=then, velocity=first.velocity, turn=first.turn)


def turns(n: int) -> np.ndarray:
    """Return rotations per step [rad], (n, 3), in all three ranges of `half_angle`: whole turns in `ROUND` steps."""
    rng = np.random.default_rng(5)
    axis = rng.standard_normal((n, 3))
    axis /= np.linalg.norm(axis, axis=1)[:, None]
    return axis * (2.0 * np.pi / ROUND * rng.choice([0.0, 1.0, 3.0, 7.0, 9.0], n))[:, None]


def spinning(size: int) -> Case:
    """Return a case whose elements rotate by up to half a radian per step, on bonds too soft to prevent it."""
    lattice = crooked(size, period=True)
    return bonded(lattice, velocity=None, turn=turns(len(lattice.particles)), share=0.004, rounds=True)


def loose(size: int) -> Case:
    """Return a case with unbonded elements among bonded ones, some of them spinning, under weight and damping."""
    lattice = crooked(size)
    n = len(lattice.particles)
    free = np.zeros(n, dtype=bool)
    free[:: max(7, n // 40)] = True
    pairs = lattice.pairs[~free[lattice.pairs].any(axis=1)]
    alone = np.bincount(pairs.ravel(), minlength=n) == 0
    thinned = bd.Lattice(lattice.particles, pairs)
    motion = random_motion(thinned)
    turn = np.where(alone[:, None], turns(n), motion["turn"])
    boundary = [bd.BodyForce((0.0, 0.1, -1.0)), bd.Fix(bd.Face("x_min", depth=0.5))]
    damping = (bd.LocalDamping(0.05), bd.MassDamping(0.5))
    return bonded(thinned, boundary=boundary, velocity=motion["velocity"], turn=turn, options={"damping": damping})


def cloud(size: int, spacing: float = 2.15) -> tuple[np.ndarray, np.ndarray]:
    """Return centres and radii of grains on a grid with gaps."""
    grid = np.indices(GRIDS[size]).reshape(3, -1).T
    return spacing * (grid + 0.5), np.random.default_rng(size).uniform(0.8, 1.05, len(grid))


def thrown(model: bd.Model, **options) -> Case:
    return Case(model=model, **random_motion(model.lattice, speed=6.0, turn=0.02), share=0.5, **options)


NO_BONDS = np.zeros((0, 2), dtype=int)


def grains(size: int) -> Case:
    """Return a case of grains with friction between fixed, driven and force-controlled walls."""
    position, radius = cloud(size)
    edge = 2.15 * np.array(GRIDS[size])
    ends = [bd.PlaneWall(np.zeros(3), axis, friction=0.2) for axis in np.eye(3)[1:]]
    ends += [bd.PlaneWall((0.0, edge[1], 0.0), (0.0, -1.0, 0.0))]
    drive = bd.PlaneWall((0, 0, 0), (1, 0, 0), motion=bd.Driven(vx=2.0, y=bd.Ramp(0.0, 0.1, 0.2)))
    push = bd.PlaneWall((0.0, 0.0, edge[2]), (0.0, 0.0, -1.0), motion=bd.Servo(1e5, speed=5.0))
    press = bd.PlaneWall((edge[0], 0.0, 0.0), (-1.0, 0.0, 0.0), motion=bd.Servo(bd.Ramp(0, 1e5, 0.2), speed=5.0))
    lattice = bd.Lattice(bd.Particles(position, radius), NO_BONDS)
    model = bd.Model(lattice, None, density=1000.0, contact=CONTACT, walls=[*ends, drive, push, press],
                     boundary=[bd.BodyForce((0.0, 0.0, -9.81))])  # fmt: skip
    gauges = {"driven": bd.WallGauge(3, "force"), "pushed": bd.WallGauge(4, "displacement")}
    return thrown(model, options={"gauges": gauges})


def grains_periodic(size: int) -> Case:
    position, radius = cloud(size)
    edge = 2.15 * np.array(GRIDS[size], dtype=float)
    particles = bd.Particles(position, radius, edge, bd.Cell(size=tuple(edge.tolist())))
    model = bd.Model(bd.Lattice(particles, NO_BONDS), None, density=1000.0, contact=CONTACT)
    return thrown(model, options={"damping": bd.LocalDamping(0.1)})


def vessel(size: int) -> Case:
    """Return a case of grains in a cylinder under pressure, around a rod that grows."""
    position, radius = cloud(size)
    centre = 0.5 * 2.15 * np.array(GRIDS[size])
    away = np.linalg.norm(position[:, 1:] - centre[1:], axis=1)
    inside = (away + radius < centre[1:].min() + 0.5) & (away - radius > 1.3)
    around = {"point": tuple(centre), "axis": (1.0, 0.0, 0.0)}
    shell = bd.CylinderWall(float(centre[1:].min() + 0.5), **around, motion=bd.Servo(1e6, speed=3.0))
    rod = bd.CylinderWall(1.2, **around, outside=True, motion=bd.Driven(growth=bd.Ramp(0.0, 0.3, 0.3)))
    lattice = bd.Lattice(bd.Particles(position[inside], radius[inside]), NO_BONDS)
    model = bd.Model(lattice, None, density=1000.0, contact=CONTACT, walls=[shell, rod])
    return thrown(model, options={"gauges": {"growth": bd.WallGauge(0, "growth"), "rod": bd.WallGauge(1, "growth")}})


def touching(size: int, **options) -> bd.Model:
    """Return a model with bonds and contacts, because not all elements that nearly touch are bonded."""
    lattice = crooked(size, radius=(0.45, 0.52), reach=1.06)
    return bd.Model(lattice, ALIKE, density=density(size), contact=CONTACT, **options)


def everything(size: int) -> Case:
    """Return a case with bonds, contacts, conditions, weight, pressure, dashpots and a dissipative scheme."""
    lattice = touching(size).lattice
    press = bd.Pressure(bd.Face("z_max", depth=0.5), 1e3, schedule=bd.Ramp(0.0, 1.0, 0.05))
    soak = bd.Absorbing(bd.Face("y_min", depth=0.5), density=150.0, E=1e6, nu=0.2)
    model = bd.Model(
        lattice, patches(lattice), density=density(size), contact=CONTACT,
        boundary=[*rows(lattice), bd.BodyForce((0.0, 0.0, -9.81)), press, soak, bd.Eigenstrain(1e-4)],
    )  # fmt: skip
    damping = (bd.LocalDamping(0.1), bd.MassDamping(1.0), bd.BondDamping(0.02))
    options = {"damping": damping, "scheme": bd.TchamwaWielgosz(1.1)}
    return Case(model=model, **random_motion(lattice, speed=2.5), options=options)


def bonds_and_contacts(size: int) -> Case:
    floor = bd.PlaneWall((0.0, 0.0, 0.0), (0.0, 0.0, 1.0), motion=bd.Driven(vz=1.0))
    model = touching(size, walls=[floor], boundary=[bd.BodyForce((0.0, 0.0, -9.81))])
    return Case(model=model, **random_motion(model.lattice, speed=3.0), options=LOCAL)


def broken_contacts(size: int) -> Case:
    """Elements touch where a bond is broken."""
    model = touching(size)
    integrity = (np.random.default_rng(3).uniform(0.0, 1.0, len(model.lattice.pairs)) > 0.2).astype(float)
    return Case(model=model, **random_motion(model.lattice, speed=6.0), integrity=integrity)


def periodic(size: int, **options) -> Case:
    return bonded(crooked(size, period=True), **options)


def walled(size: int, **options) -> Case:
    return bonded(crooked(size), **options)


ALL_DAMPING = (bd.LocalDamping(0.2), bd.MassDamping(3.0), bd.BondDamping(0.03))
#: Bonds in random motion: the grid, and what is given to `bonded`.
BONDED: dict[str, tuple[Callable[..., Case], dict]] = {
    "alike": (walled, {"density": 1000.0}),
    "alike_periodic": (periodic, {}),
    "damaged": (walled, {"integrity": weakened}),
    "regions": (walled, {"bond": patches}),
    "regions_damaged": (periodic, {"bond": patches, "integrity": weakened}),
    "parallel_bond": (periodic, {"bond": law(bd.ParallelBond)}),
    "incremental": (periodic, {"bond": law(bd.EulerBernoulli, formulation="incremental")}),
    "incremental_rows": (
        walled, {"bond": law(bd.Timoshenko, formulation="incremental"), "boundary": rows, "options": LOCAL}
    ),
    "local_damping": (walled, {"options": {"damping": bd.LocalDamping(0.3)}}),
    "mass_damping": (walled, {"options": {"damping": bd.MassDamping(5.0)}}),
    "bond_damping": (periodic, {"options": {"damping": bd.BondDamping(0.05, 1e-4)}}),
    "all_damping": (walled, {"bond": patches, "boundary": rows, "options": {"damping": ALL_DAMPING}}),
    "tchamwa": (periodic, {"options": {"scheme": bd.TchamwaWielgosz(1.05)}}),
    "tchamwa_rows": (
        walled, {"bond": SHORT, "boundary": rows, "options": LOCAL | {"scheme": bd.TchamwaWielgosz(1.2)}}
    ),
    "driven_alike": (walled, {"boundary": rows, "options": LOCAL}),
    "weight": (walled, {"boundary": [
        FLOOR, bd.BodyForce((0.0, 0.0, -9.81)),
        bd.BodyForce((2.0, 0.0, 3.0), region=FRONT, schedule=bd.Ramp(0.0, 1.0, 0.05)),
    ]}),
    "pressure": (walled, {"boundary": [
        CLAMP, bd.Pressure(bd.Face("x_max", depth=0.5), 1e4, schedule=bd.Ramp(0.0, 1.0, 0.05)),
    ]}),
    "absorbing": (walled, {"boundary": [*SOAKED, bd.Drive(bd.Face("x_min", depth=0.5), x=wave_of(0.01))]}),
    "eigenstrain": (walled, {"options": LOCAL, "boundary": [
        bd.Eigenstrain(1e-3, schedule=bd.Ramp(0.0, 1.0, 0.1)),
        bd.Eigenstrain(-5e-4, region=FRONT, schedule=wave_of(1.0)), CLAMP,
    ]}),
    "strained": (periodic, {"strain": 1e-3}),  # the state brings it along
}  # fmt: skip
CASES: dict[str, Callable[[int], Case]] = {name: partial(grid, **given) for name, (grid, given) in BONDED.items()}
CASES |= {one.__name__: one for one in (
    driven, spinning, loose, grains, grains_periodic, vessel, bonds_and_contacts, broken_contacts, everything,
)}  # fmt: skip
