"""Cases whose bits must not change: every kind of bond, load, damping, rotation and contact."""

from collections.abc import Callable

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
)

CASES: dict[str, Callable[[int], Case]] = {}


def case(function: Callable[[int], Case]) -> Callable[[int], Case]:
    CASES[function.__name__] = function
    return function


# ---- bonds


@case
def alike(size: int) -> Case:
    return bonded(crooked(size), density=1000.0)


@case
def alike_periodic(size: int) -> Case:
    return bonded(crooked(size, period=True))


@case
def damaged(size: int) -> Case:
    """Return a case with broken and weakened bonds."""
    lattice = crooked(size)
    integrity = np.random.default_rng(3).uniform(-0.2, 1.3, len(lattice.pairs)).clip(0.0, 1.0)
    return bonded(lattice, integrity=integrity)


@case
def regions(size: int) -> Case:
    lattice = crooked(size)
    return bonded(lattice, bond=patches(lattice))


@case
def regions_damaged(size: int) -> Case:
    lattice = crooked(size, period=True)
    integrity = np.random.default_rng(3).uniform(-0.2, 1.3, len(lattice.pairs)).clip(0.0, 1.0)
    return bonded(lattice, bond=patches(lattice), integrity=integrity)


@case
def parallel_bond(size: int) -> Case:
    return bonded(crooked(size, period=True), bond=bd.ParallelBond(E=E, nu=NU, radius_ratio=RATIO))


@case
def incremental(size: int) -> Case:
    law = bd.EulerBernoulli(E=E, nu=NU, radius_ratio=RATIO, formulation="incremental")
    return bonded(crooked(size, period=True), bond=law)


@case
def incremental_rows(size: int) -> Case:
    lattice = crooked(size)
    law = bd.Timoshenko(E=E, nu=NU, radius_ratio=RATIO, formulation="incremental")
    return bonded(lattice, bond=law, boundary=rows(lattice), options={"damping": bd.LocalDamping(0.1)})


# ---- damping and schemes


@case
def local_damping(size: int) -> Case:
    return bonded(crooked(size), options={"damping": bd.LocalDamping(0.3)})


@case
def mass_damping(size: int) -> Case:
    return bonded(crooked(size), options={"damping": bd.MassDamping(5.0)})


@case
def bond_damping(size: int) -> Case:
    return bonded(crooked(size, period=True), options={"damping": bd.BondDamping(0.05, 1e-4)})


@case
def all_damping(size: int) -> Case:
    lattice = crooked(size)
    damping = (bd.LocalDamping(0.2), bd.MassDamping(3.0), bd.BondDamping(0.03))
    return bonded(lattice, bond=patches(lattice), boundary=rows(lattice), options={"damping": damping})


@case
def tchamwa(size: int) -> Case:
    return bonded(crooked(size, period=True), options={"scheme": bd.TchamwaWielgosz(1.05)})


@case
def tchamwa_rows(size: int) -> Case:
    lattice = crooked(size)
    options = {"scheme": bd.TchamwaWielgosz(1.2), "damping": bd.LocalDamping(0.1)}
    return bonded(lattice, bond=SHORT, boundary=rows(lattice), options=options)


# ---- loads


@case
def driven(size: int) -> Case:
    """Return a case whose second run has other boundary conditions than the first."""
    lattice = crooked(size)
    first = bonded(lattice, bond=patches(lattice), boundary=rows(lattice))
    pull = bd.Load(bd.Face("z_max", depth=0.5), force=(0.0, 0.0, 5e3))
    then = first.model.with_boundary([bd.Fix(bd.Face("z_min", depth=0.5)), pull])
    return Case(model=first.model, then=then, velocity=first.velocity, turn=first.turn)


@case
def driven_alike(size: int) -> Case:
    lattice = crooked(size)
    return bonded(lattice, boundary=rows(lattice), options={"damping": bd.LocalDamping(0.1)})


@case
def weight(size: int) -> Case:
    """Return a case with weight, and a second body force that follows a schedule."""
    lattice = crooked(size)
    part = bd.Within(bd.Box(size=(4.0, 1e3, 1e3)))
    pulse = bd.BodyForce((2.0, 0.0, 3.0), region=part, schedule=bd.Ramp(0.0, 1.0, 0.05))
    return bonded(lattice, boundary=[bd.Fix(bd.Face("z_min", depth=0.5)), bd.BodyForce((0.0, 0.0, -9.81)), pulse])


@case
def pressure(size: int) -> Case:
    lattice = crooked(size)
    press = bd.Pressure(bd.Face("x_max", depth=0.5), 1e4, schedule=bd.Ramp(0.0, 1.0, 0.05))
    return bonded(lattice, boundary=[bd.Fix(bd.Face("x_min", depth=0.5)), press])


@case
def absorbing(size: int) -> Case:
    faces = [bd.Absorbing(bd.Face(name, depth=0.5), density=150.0, E=1e6, nu=0.2) for name in ("x_max", "z_min")]
    lattice = crooked(size)
    return bonded(lattice, boundary=[*faces, bd.Drive(bd.Face("x_min", depth=0.5), x=wave_of(0.01))])


@case
def eigenstrain(size: int) -> Case:
    heat = bd.Eigenstrain(1e-3, schedule=bd.Ramp(0.0, 1.0, 0.1))
    swelling = bd.Eigenstrain(-5e-4, region=bd.Within(bd.Box(size=(4.0, 1e3, 1e3))), schedule=wave_of(1.0))
    lattice = crooked(size)
    boundary = [heat, swelling, bd.Fix(bd.Face("x_min", depth=0.5))]
    return bonded(lattice, boundary=boundary, options={"damping": bd.LocalDamping(0.1)})


@case
def strained(size: int) -> Case:
    """Return a case with stress-free strains in its initial state."""
    return bonded(crooked(size, period=True), strain=1e-3)


# ---- rotations


def turns(n: int) -> np.ndarray:
    """Return rotations per step [rad], (n, 3), in all three ranges of `half_angle`: whole turns in `ROUND` steps."""
    rng = np.random.default_rng(5)
    axis = rng.standard_normal((n, 3))
    axis /= np.linalg.norm(axis, axis=1)[:, None]
    return axis * (2.0 * np.pi / ROUND * rng.choice([0.0, 1.0, 3.0, 7.0, 9.0], n))[:, None]


@case
def spinning(size: int) -> Case:
    """Return a case whose elements rotate by up to half a radian per step, on bonds too soft to prevent it."""
    lattice = crooked(size, period=True)
    return bonded(lattice, velocity=None, turn=turns(len(lattice.particles)), share=0.004, rounds=True)


@case
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


# ---- contacts


def cloud(size: int, spacing: float = 2.15) -> tuple[np.ndarray, np.ndarray]:
    """Return centres and radii of grains on a grid with gaps."""
    grid = np.indices(GRIDS[size]).reshape(3, -1).T
    return spacing * (grid + 0.5), np.random.default_rng(size).uniform(0.8, 1.05, len(grid))


def thrown(model: bd.Model, **options) -> Case:
    return Case(model=model, **random_motion(model.lattice, speed=6.0, turn=0.02), share=0.5, **options)


NO_BONDS = np.zeros((0, 2), dtype=int)


@case
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


@case
def grains_periodic(size: int) -> Case:
    position, radius = cloud(size)
    edge = 2.15 * np.array(GRIDS[size], dtype=float)
    particles = bd.Particles(position, radius, edge, bd.Cell(size=tuple(edge.tolist())))
    model = bd.Model(bd.Lattice(particles, NO_BONDS), None, density=1000.0, contact=CONTACT)
    return thrown(model, options={"damping": bd.LocalDamping(0.1)})


@case
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


@case
def bonds_and_contacts(size: int) -> Case:
    floor = bd.PlaneWall((0.0, 0.0, 0.0), (0.0, 0.0, 1.0), motion=bd.Driven(vz=1.0))
    model = touching(size, walls=[floor], boundary=[bd.BodyForce((0.0, 0.0, -9.81))])
    return Case(model=model, **random_motion(model.lattice, speed=3.0), options={"damping": bd.LocalDamping(0.1)})


@case
def broken_contacts(size: int) -> Case:
    """Return a case in which elements touch where their bond is broken."""
    model = touching(size)
    integrity = (np.random.default_rng(3).uniform(0.0, 1.0, len(model.lattice.pairs)) > 0.2).astype(float)
    return Case(model=model, **random_motion(model.lattice, speed=6.0), integrity=integrity)


@case
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
