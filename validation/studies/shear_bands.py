"""Shear bands of Mohr–Coulomb bodies of cells: residual strength, and work of failure.

A prism 14 mm wide, E = 30 GPa, ν = 0.2, c = 10 MPa, φ = 30°, ψ = 0, is compressed between a rough base and a smooth
platen under a dead pressure p on its four sides, without platens there. Nothing is calibrated.

residual: 2.2 : 1, G_II = 300 J/m². Mean stress of the last sixth of the run, over p (1 + sin φ) / (1 - sin φ), which
    a Mohr–Coulomb continuum without cohesion bears; peak over (2 c cos φ + p (1 + sin φ)) / (1 - sin φ).
work: 3 : 1, G_II = 500 J/m², p = c/2. A plane of cells through the middle, at 45° to the axis, has 0.95 of the
    cohesion, so that one band of a known area √2 a² is formed. Cohesive work Σ V r c Δγ, and external work beyond the
    residual strength, both over G_II times that area.
"""

import math
from functools import partial
from itertools import product
from typing import Any

import numpy as np

import bondem as bd
from validation.frame.record import Record

#: Allowed distances from what is entered, fixed before the runs: of the residual strength of each specimen, of the
#: mean cohesive work from G_II, and of mean works at two sizes from each other [-]; imbalance of the ledger [-].
RESIDUAL, WORK, SIZES, LEDGER = 0.10, 0.10, 0.10, 1e-4
COUNTS = {"residual": (500, 2000), "work": (700, 2000)}
WIDTH, E, NU, DENSITY = 14e-3, 30e9, 0.2, 2400.0
COHESION, ANGLE = 10e6, math.radians(30.0)
WEAK = 0.95
_PIECES = 120


def material(energy: float, share: float = 1.0) -> bd.MohrCoulomb:
    return bd.MohrCoulomb(
        tension=2e6, cohesion=share * COHESION, friction_angle=ANGLE, fracture_energy=100.0,
        fracture_energy_shear=energy,
    )  # fmt: skip


def prism(count: int, seed: int, aspect: float) -> bd.Lattice:
    return bd.connect(
        bd.pack(bd.Box((aspect * WIDTH, WIDTH, WIDTH)), count=count, method="even", seed=seed), method="laguerre"
    )


def compressed(
    body: bd.Lattice, failure: Any, pressure: float, aspect: float, way: float
) -> tuple[bd.Model, float, bd.MassDamping]:
    """Return the model, the duration of a sixth of the run [s] and the damping; p is applied before `way` [m]."""
    length, speed = aspect * WIDTH, math.sqrt(E / DENSITY)
    sixth = 60.0 * length / speed
    end = 6.0 * sixth
    faces = [bd.Face(name) for name in ("y_min", "y_max", "z_min", "z_max")]
    path = bd.Table([0.0, sixth, end, 2.0 * end], [0.0, -pressure / E * (1.0 - 2.0 * NU) * length, -way, -way])
    model = bd.Model(body, bd.CellBond(E=E, nu=NU), density=DENSITY, failure=failure, boundary=[
        bd.Fix(bd.Face("x_min"), translation="xyz", rotation=""),
        *(bd.Pressure(face, pressure, schedule=bd.Ramp(0.0, 1.0, sixth)) for face in faces),
        bd.Drive(bd.Face("x_max"), x=path),
    ])  # fmt: skip
    return model, sixth, bd.MassDamping(0.01 * math.pi * speed / length)


def gauges() -> dict[str, bd.Gauge]:
    return {"force": bd.Gauge(bd.Face("x_max"), "force"), "way": bd.Gauge(bd.Face("x_max"), "displacement")}


def strengths(pressure: float) -> tuple[float, float]:
    """Return the peak and the residual strength of a continuum [Pa]."""
    sine = math.sin(ANGLE)
    rest = pressure * (1.0 + sine) / (1.0 - sine)
    return rest + 2.0 * COHESION * math.cos(ANGLE) / (1.0 - sine), rest


def residual(count: int, seed: int, pressure: float) -> dict[str, float]:
    aspect, energy = 2.2, 300.0
    peak, rest = strengths(pressure)
    way = peak / E * aspect * WIDTH + 400e-6
    model, sixth, damping = compressed(prism(count, seed, aspect), material(energy), pressure, aspect, way)
    run = bd.solve_explicit(model, duration=6.0 * sixth, every=50, damping=damping, gauges=gauges())
    stress = -run.history["force"][:, 0] / WIDTH**2
    last = stress[-len(stress) // 6 :].mean()
    return {"peak": stress.max() / peak, "residual": last / rest, "ledger": run.history.imbalance}


def work(count: int, seed: int) -> dict[str, float]:
    aspect, energy, pressure = 3.0, 500.0, 0.5 * COHESION
    body = prism(count, seed, aspect)
    edge = (aspect * WIDTH**3 / count) ** (1.0 / 3.0)
    offset = (body.centre - 0.5 * np.array([aspect * WIDTH, WIDTH, WIDTH])) @ (math.sqrt(0.5) * np.array([1, 1, 0]))
    weak = bd.Index(np.flatnonzero(np.abs(offset) < 0.6 * edge))
    failure = {bd.Everything(): material(energy), weak: material(energy, WEAK)}
    peak, rest = strengths(pressure)
    way = peak / E * aspect * WIDTH + 400e-6
    model, sixth, damping = compressed(body, failure, pressure, aspect, way)
    assert body.cells is not None
    (yielding,) = model.yielding
    order, area, cohesive = model.layout.order, math.sqrt(2.0) * WIDTH**2, 0.0
    volume = body.cells.volume[order]
    cohesion = COHESION * np.where(np.isin(order, weak.select(body)), WEAK, 1.0)
    state, stress, place = model.state(), [], []
    slip, left = np.zeros(count), np.ones(count)
    for _ in range(_PIECES):
        run = bd.solve_explicit(
            model, duration=6.0 * sixth / _PIECES, every=50, damping=damping, gauges=gauges(), state=state
        )
        state = run.state
        stress.append(-run.history["force"][1:, 0] / WIDTH**2)
        place.append(-run.history["way"][1:, 0])
        after, kept = state.slipped[order], 1.0 - yielding.spent(state.slipped[order])
        cohesive += float((volume * cohesion * 0.5 * (left + kept) * (after - slip)).sum())
        slip, left = after, kept
    load, shortened = np.concatenate(stress), np.concatenate(place)
    last = load[-len(load) // 8 :].mean()
    beyond = np.trapezoid(np.maximum(load - last, 0.0) * WIDTH**2, shortened - load * aspect * WIDTH / E)
    return {
        "cohesive": cohesive / (energy * area), "external": float(beyond) / (energy * area), "residual": last / rest,
    }


def verdicts(report: dict[str, Any]) -> dict[str, Any]:
    found: dict[str, Any] = {}
    if report["residual"]:
        rows = report["residual"]
        off = [abs(row["residual"] - 1.0) for row in rows]
        found["residual"] = {"furthest": max(off), "within": all(one <= RESIDUAL for one in off)}
        ledger = max(row["ledger"] for row in rows)
        found["ledger"] = {"largest": ledger, "within": ledger <= LEDGER}
    counts = sorted({row["count"] for row in report["work"]})
    if len(counts) > 1:
        mean = {
            name: [float(np.mean([row[name] for row in report["work"] if row["count"] == count])) for count in counts]
            for name in ("cohesive", "external")
        }
        found["work"] = mean | {
            "within": all(abs(one - 1.0) <= WORK for one in mean["cohesive"])
            and all(abs(values[-1] / values[0] - 1.0) <= SIZES for values in mean.values())
        }
    return found


def measure(
    record: Record, *, kinds: tuple[str, ...] = tuple(COUNTS), seeds: tuple[int, ...] = (1, 2, 3, 4, 5),
) -> None:  # fmt: skip
    """Measure residual strengths and works of failure."""
    for kind, seed in product(kinds, seeds):
        for count in COUNTS[kind]:
            if kind == "work":
                record.add(partial(work, count, seed), kind, count=count, seed=seed)
                continue
            for p in (0.5 * COHESION, 2.0 * COHESION):
                record.add(partial(residual, count, seed, p), kind, count=count, seed=seed, pressure=p)
    record.keep(verdicts=verdicts({kind: record.rows(kind) for kind in COUNTS}))
    print(record.data["verdicts"])
