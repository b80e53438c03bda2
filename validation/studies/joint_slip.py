"""A flat joint that slips by three edges of its facets under a pressure: its friction with and without contact."""

from functools import partial

import numpy as np

import bondem as bd
from bondem._threads import threads
from validation.frame.record import Record

LENGTH, HEIGHT, E, RHO = 20e-3, 8e-3, 20e9, 2400.0
COHESION, PHI, PRESSURE, G_SHEAR = 2e6, 0.5, 4e6, 100.0
EDGES = 3.0
CONTACTS = {
    "none": None,
    "LinearContact": bd.LinearContact(E=E, friction=np.tan(PHI)),
    "HertzMindlin": bd.HertzMindlin(E=E, nu=0.2, friction=np.tan(PHI)),
}
CASES = [
    *((way, "LinearContact", seed, n) for n in (240, 320) for way in ("held", "dead") for seed in (1, 2, 3, 4, 5)),
    *((way, "HertzMindlin", seed, 240) for way in ("held", "dead") for seed in (1, 2)),
    *((way, "none", 1, 240) for way in ("held", "dead")),
]  # fmt: skip


def slipped(way: str, contact: str, seed: int, count: int) -> dict:
    """What the joint of one packing carries."""
    plane = bd.Plane(point=(0, 0, HEIGHT / 2), normal=(0, 0, 1))
    packing = bd.pack(bd.Box((LENGTH, LENGTH, HEIGHT)), count=count, method="even", seed=seed, around=plane)
    body = bd.connect(packing, method="laguerre")
    far = bd.Box((3 * LENGTH,) * 3)
    low, up = (bd.Within(far.moved((-LENGTH, -LENGTH, HEIGHT / 2 - z))) for z in (3 * LENGTH, 0.0))
    i, j = body.pairs.T
    upper = np.zeros(len(body.centre), dtype=bool)
    upper[up.select(body)] = True
    assert body.facets is not None
    edge = float(np.sqrt(np.median(body.facets.area[upper[i] != upper[j]])))
    strong = bd.MohrCoulomb(tension=80e6, cohesion=300e6, friction_angle=PHI, fracture_energy=5e4)
    joint = bd.MohrCoulomb(
        tension=1e6, cohesion=COHESION, friction_angle=PHI, fracture_energy=10.0, fracture_energy_shear=G_SHEAR
    )
    sound = np.sqrt(E / RHO)
    rise = 100 * LENGTH / sound
    duration, distance = 22 * rise, (EDGES + 0.15) * edge
    slide = bd.Ramp(0, distance / (duration - 1.5 * rise), 0.5 * rise, begin=1.2 * rise)
    top, closing = bd.Face("z_max"), bd.Ramp(0, -PRESSURE / E * HEIGHT, rise)
    press = [bd.Drive(top, z=closing, vx=slide, vy=0.0)]
    if way == "dead":
        press = [bd.Drive(top, vx=slide, vy=0.0), bd.Pressure(top, PRESSURE, schedule=bd.Ramp(0, 1, rise))]
    model = bd.Model(
        body, bd.CellBond(E=E, nu=0.0), density=RHO, contact=CONTACTS[contact],
        failure={bd.Everything(): strong, (low, up): joint}, boundary=[bd.Fix(bd.Face("z_min")), *press],
    )  # fmt: skip
    with threads(1):
        run = bd.solve_explicit(
            model, duration=duration, every=50, damping=bd.MassDamping(0.4 * np.pi * sound / LENGTH),
            gauges={"force": bd.Gauge(bd.Face("z_min"), "force"), "moved": bd.Gauge(top, "displacement")},
        )  # fmt: skip
    slip = run.history["moved"][:, 0]
    stress = run.history["force"] / LENGTH**2 / PRESSURE
    friction, energy = -stress[:, 0] / np.tan(PHI), run.history.energy
    rows = [(slip >= a * edge) & (slip < (a + 0.5) * edge) & (slip > 0.2 * edge) for a in np.arange(0, EDGES, 0.5)]
    overlap = np.array([1.0 - slip[row].mean() / LENGTH if way == "held" and row.any() else 1.0 for row in rows])
    mean = np.array([friction[row].mean() if row.any() else 0.0 for row in rows])
    return {
        "edges": float(slip[-1] / edge), "friction": np.round(mean, 3).tolist(),
        "of_overlap": np.round(mean / overlap, 3).tolist(),
        "ledger": float(np.abs(energy["balance"]).max() / energy["work"].max()),
    }  # fmt: skip


def measure(record: Record, *, name: str = "after") -> None:
    """Let joints slip; rows of several versions stand beside each other by `name`."""
    record.keep(runs=record.data.get("runs", {}) | {name: record.origin})
    for way, contact, seed, count in CASES:
        record.add(partial(slipped, way, contact, seed, count), "rows", name=name, press=way, contact=contact,
                   seed=seed, cells=count)  # fmt: skip
