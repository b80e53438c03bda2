"""Joints that meet the surface obliquely under compression, and flat blocks of cells that lie on a slope."""

import math
import warnings
from functools import partial

import numpy as np

import bondem as bd
from bondem._threads import threads
from validation.frame.record import Record

WIDTH, E, RHO, COHESION, PHI = 12e-3, 20e9, 2400.0, 2e6, math.radians(30)
LENGTH = {45: 30e-3, 60: 30e-3, 70: 50e-3}
SLOPES = ((0.0, 15), (0.5, 35))
GRAVITY, SOFT, LASTS, CELL = 200.0, 1e8, 6e-3, 3e-3**3


def pressed(degrees: int, count: int, seed: int) -> dict:
    """Jaeger's test: a bar with one joint whose normal is inclined to the load."""
    beta, length = math.radians(degrees), LENGTH[degrees]
    normal = np.array((math.cos(beta), 0.0, math.sin(beta)))
    plane = bd.Plane(point=(length / 2, WIDTH / 2, WIDTH / 2), normal=tuple(normal))
    packing = bd.pack(
        bd.Box((length, WIDTH, WIDTH)), count=round(count * length / 30e-3), method="even", seed=seed, around=plane
    )
    body = bd.connect(packing, method="laguerre")
    assert body.facets is not None
    above = plane.mask(body)
    across = above[body.pairs[:, 0]] != above[body.pairs[:, 1]]
    flat = np.abs(body.facets.normal[across] @ normal) > 1.0 - 1e-6
    rock = bd.MohrCoulomb(tension=10e6, cohesion=40e6, friction_angle=0.6, fracture_energy=500.0)
    weak = bd.MohrCoulomb(tension=1e6, cohesion=COHESION, friction_angle=PHI, fracture_energy=1.5)
    press = bd.Drive(bd.Face("x_max"), x=bd.Table([0.0, 1.5e-3], [0.0, -2e-3 * length]))
    model = bd.Model(
        body, bd.CellBond(E=E, nu=0.2), RHO, boundary=[bd.Fix(bd.Face("x_min"), "x", ""), press],
        failure={bd.Everything(): rock, (plane, bd.Everything() - plane): weak},
        contact=bd.LinearContact(E=E, friction=math.tan(PHI)),
    )  # fmt: skip
    gauges = {"force": bd.Gauge(bd.Face("x_max"), "force")}
    with threads(1):
        run = bd.solve_explicit(model, duration=1.5e-3, every=50, damping=bd.MassDamping(2e4), gauges=gauges)
    stress = -run.history["force"][:, 0] / WIDTH**2
    strength = COHESION / (math.sin(beta) * math.cos(beta) - math.tan(PHI) * math.cos(beta) ** 2)
    return {
        "flat": float(body.facets.area[across][flat].sum() / (WIDTH**2 / normal[0])),
        "peak": float(stress.max() / strength), "end": float(stress[-1] / strength),
        "hold": int((run.state.bond_integrity[across] > 0.0).sum()),
    }  # fmt: skip


def block(height: float, seed: int, *, length: float = 20e-3, around: bd.Plane | None = None) -> bd.Lattice:
    """A flat block, 20 mm wide, of cells of 3 mm."""
    count = round(20e-3 * length * height / CELL)
    packing = bd.pack(bd.Box((length, 20e-3, height)), count=count, method="even", seed=seed, around=around)
    return bd.connect(packing, method="laguerre")


def slid(friction: float, degrees: int, seed: int, under: str) -> dict:
    """How far a flat block slides down a block of cells, a wall, or a joint in one body, and a rigid one [m]."""
    slope, plane = math.radians(degrees), bd.Plane(point=(0.0, 0.0, 8e-3), normal=(0.0, 0.0, 1.0))
    base = bd.Fix(bd.Face("z_min", body="base" if under == "block" else None))
    boundary = [bd.Gravity(GRAVITY, direction=(math.sin(slope), 0.0, -math.cos(slope))), base]
    law = bd.LinearContact(E=SOFT, friction=friction, damping=0.3)
    scene, walls, region = block(8e-3, seed).moved((5e-3, 0.0, 8e-3)), [], bd.Everything()
    failure: dict[bd.Region | tuple[bd.Region, bd.Region], bd.Criterion] | None = None
    if under == "block":
        scene = bd.join(block(8e-3, 3, length=30e-3), scene, names=("base", "top"))
        region = bd.Body("top")
    elif under == "wall":
        walls, boundary = [bd.PlaneWall(point=plane.point, normal=plane.normal)], boundary[:1]
    else:
        scene, region = block(16e-3, seed, around=plane), plane
        rock = bd.MohrCoulomb(tension=1e7, cohesion=1e8, friction_angle=0.5, fracture_energy=1e7)
        weak = bd.MohrCoulomb(tension=200.0, cohesion=200.0, friction_angle=math.atan(friction), fracture_energy=1e-4)
        failure = {bd.Everything(): rock, (plane, bd.Everything() - plane): weak}
    model = bd.Model(
        scene, bd.CellBond(E=SOFT, nu=0.2), RHO, contact=law, boundary=boundary, walls=walls, failure=failure
    )
    with threads(1), warnings.catch_warnings():
        warnings.simplefilter("ignore", bd.errors.ContactWarning)  # that blocks do not slide
        warnings.simplefilter("ignore", bd.errors.StrengthWarning)
        run = bd.solve_explicit(
            model, duration=LASTS, every=50, damping=bd.BondDamping(0.2),
            gauges={"moved": bd.Gauge(region, "displacement")},
        )  # fmt: skip
    path = (math.sin(slope) - friction * math.cos(slope)) * GRAVITY * LASTS**2 / 2.0
    return {"moved": float(run.history["moved"][-1, 0]), "rigid": path}


def measure(record: Record) -> None:
    """Press bars with a joint, and let blocks slide."""
    for count in (200, 1200):
        for degrees in LENGTH:
            for seed in (1, 2, 3):
                record.add(partial(pressed, degrees, count, seed), "joints", degrees=degrees, cells=count, seed=seed)
    for under in ("block", "wall", "joint"):
        for friction, degrees in SLOPES:
            for seed in (1, 2, 3):
                record.add(partial(slid, friction, degrees, seed, under), "blocks", under=under, friction=friction,
                           degrees=degrees, seed=seed)  # fmt: skip
