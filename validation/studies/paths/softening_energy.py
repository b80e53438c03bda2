"""Fracture energy of bars, notched bars and compact specimens; explicit beside quasi-static results."""

import itertools
import math
from functools import cache
from typing import Any

import bondem as bd
from validation.studies.paths.driving import LAW, RHO, RISE, TENSION, Course, E, course
from validation.studies.paths.rows import Row

#: Fracture energies [J/m²] and curves.
ENERGIES = (50.0, 200.0)
CURVES: dict[str, bd.Bilinear | None] = {"linear": None, "bilinear": bd.Bilinear()}
#: Limits: of the mean fracture energy of a kind, the strength of a bar, explicit beside quasi-static results [-].
ENERGY_LIMIT, STRENGTH_LIMIT, SOLVER_LIMIT = 0.04, 0.005, 0.01
#: Bars, and the notch on one side: width along x and depth along y [m].
BAR, NOTCH = (80e-3, 40e-3, 40e-3), (4e-3, 13e-3)
#: Compact specimen: W from the line of the load, thickness, a / W, width of the notch [m]; radius of its pins over W.
WIDTH, THICK, ALPHA, SLOT, PIN = 80e-3, 16e-3, 0.5, 4e-3, 0.125
_TRAVERSES = 30.0
# Of a compact specimen until its pins are as far apart as they come.
_TRAVERSES_APART = 600.0
# Speed at which bars are torn after their peak: so much of G_f / f_t over f_t / E of the length.
_HURRY = 0.7
#: The load at which a compact specimen is taken to be in two parts, over its peak.
_ENDING = 0.01


@cache
def bar(kind: str, seed: int, count: int) -> bd.Lattice:
    """A bar, plain or notched to a third of its height."""
    shape: bd.Shape = bd.Box(BAR)
    if kind == "notched":
        slot = bd.Box((NOTCH[0], NOTCH[1], 2.0 * BAR[2]))
        shape = shape.cut(slot.moved((0.5 * (BAR[0] - NOTCH[0]), 0.0, -0.5 * BAR[2])), name="notch")
    return bd.connect(bd.pack(shape, count=count, method="even", seed=seed), method="laguerre")


def _material(energy: float, curve: str) -> bd.Rankine:
    return bd.Rankine(tension=TENSION, fracture_energy=energy, curve=CURVES[curve])


def _kinds() -> list[tuple[float, str]]:
    return list(itertools.product(ENERGIES, CURVES))


def _pulled(kind: str, energy: float, curve: str, seed: int, count: int) -> Course:
    """A bar pulled past its peak slowly, and then apart: an opening of G_f / f_t takes as long whatever G_f is."""
    stretch = 1.05 * TENSION / E * BAR[0]
    last = 1.5 * (3.6 if CURVES[curve] else 2.0) * energy / TENSION
    return course(
        bar(kind, seed, count), _material(energy, curve), {"x": (0.0, stretch, stretch + last)}, ending=0.003,
        hurry=max(1.0, _HURRY * energy / TENSION / stretch),
    )  # fmt: skip


def plain(seed: int, count: int) -> list[Row]:
    """Strength and fracture energy of a bar."""
    rows = []
    for energy, curve in _kinds():
        found = _pulled("plain", energy, curve, seed, count)
        ratio = float(found.run.history.energy["work"][-1]) / (BAR[1] * BAR[2] * energy)
        note = f"G_f = {energy:g} J/m², {curve}, {found.note}"
        rows += [
            Row("energy", "plain bar: f_t", found.peak() / TENSION, 1.0, STRENGTH_LIMIT, seed, count, note=note),
            Row("energy", "plain bar: G_f", ratio, 1.0, ENERGY_LIMIT, seed, count, mean=True, note=note),
        ]
    return rows


def notched(seed: int, count: int) -> list[Row]:
    """Fracture energy of a notched bar: work over the ligament."""
    rows = []
    for energy, curve in _kinds():
        found = _pulled("notched", energy, curve, seed, count)
        ratio = float(found.run.history.energy["work"][-1]) / ((BAR[1] - NOTCH[1]) * BAR[2] * energy)
        note = f"G_f = {energy:g} J/m², {curve}, {found.note}"
        rows.append(Row("energy", "notched bar: G_f", ratio, 1.0, ENERGY_LIMIT, seed, count, mean=True, note=note))
    return rows


@cache
def compact(seed: int, count: int) -> bd.Lattice:
    """The specimen of ASTM E399, 1.25 W long and 1.2 W high, its pins full of material; x runs from its left edge."""
    size = (1.25 * WIDTH, 1.2 * WIDTH, THICK)
    tip = (0.25 + ALPHA) * WIDTH
    slot = bd.Box((2.0 * tip, SLOT, 3.0 * THICK)).moved((-tip, 0.5 * (size[1] - SLOT), -THICK))
    shape = bd.Box(size).cut(slot, name="notch")
    return bd.connect(bd.pack(shape, count=count, method="even", seed=seed), method="laguerre")


def compact_tension(seed: int, count: int) -> list[Row]:
    """Fracture energy of a compact specimen: what cracks dissipate over the ligament, as damping takes work."""
    rows = []
    for energy, curve in _kinds():
        work, note = _torn(compact(seed, count), energy, curve)
        told = f"G_f = {energy:g} J/m², {curve}, {note}"
        rows.append(
            Row("energy", "compact tension: G_f", work / energy, 1.0, ENERGY_LIMIT, seed, count, mean=True, note=told)
        )
    return rows


def _torn(body: bd.Lattice, energy: float, curve: str) -> tuple[float, str]:
    material = _material(energy, curve)
    pins = [
        bd.Within(bd.Cylinder(radius=PIN * WIDTH, length=3.0 * THICK).rotated("y", math.pi / 2.0).moved(
            (0.25 * WIDTH, (0.6 + way * 0.275) * WIDTH, 2.0 * THICK)))
        for way in (1.0, -1.0)
    ]  # fmt: skip
    strong = bd.Rankine(tension=10.0 * TENSION, fracture_energy=100.0 * energy, curve=CURVES[curve])
    # nothing is to fail outside a band about the ligament: arms of tough material would bend before it parts
    block = bd.Box((1.5 * WIDTH, 0.41 * WIDTH, 3.0 * THICK))
    about = [bd.Within(block.moved((-0.1 * WIDTH, y * WIDTH, -THICK))) for y in (-0.01, 0.8)]
    opening = (3.6 if CURVES[curve] else 2.0) * energy / TENSION
    long = 1.2 * WIDTH
    sound = math.sqrt(E / RHO)
    # each pin moves five times as far as the root of the notch has to open
    way, duration = 5.0 * opening, _TRAVERSES_APART * long / sound
    rise = RISE * duration
    speed = way / (duration - 0.5 * rise)
    boundary = [
        bd.Drive(pins[0], vy=bd.Ramp(0.0, speed, rise)), bd.Drive(pins[1], vy=bd.Ramp(0.0, -speed, rise)),
    ]  # fmt: skip
    failure: dict[Any, bd.Rankine] = {bd.Everything(): material, about[0]: strong, about[1]: strong}
    top = [0.0]

    def ended(_state: bd.State, record: bd.History) -> bool:
        now = float(record["pin"][-1, 1])
        top[0] = max(top[0], now)
        return record.time[-1] > rise and now < _ENDING * top[0]

    run = bd.solve_explicit(
        bd.Model(body, LAW, RHO, failure=failure, boundary=boundary), duration=duration, every=50,
        damping=bd.MassDamping(alpha=0.02 * math.pi * sound / long), callback=ended,  # halves turn
        gauges={"pin": bd.Gauge(pins[0], "force")},
    )  # fmt: skip
    ligament = (1.0 - ALPHA) * WIDTH * THICK
    left = float(run.history["pin"][-1, 1]) / top[0]
    note = f"{run.status.value} at {left:.3f} of the peak, imbalance {run.history.imbalance:.1e}"
    return float(run.history.released[-1]) / ligament, note


def solvers(seed: int, count: int) -> list[Row]:
    """Peak and work of explicit runs over those of equilibria, of the same bars."""
    rows = []
    for kind in ("plain", "notched"):
        body, material = bar(kind, seed, count), _material(ENERGIES[0], "linear")
        test = bd.labtests.direct_tension(body, LAW, material, traverses=2.0 * _TRAVERSES)
        ends = [bd.Fix(bd.Face("x_min"), translation="x", rotation=""), bd.Drive(bd.Face("x_max"), x=1e-6)]
        held = _held(body)
        path = bd.solve_quasistatic(
            bd.Model(body, LAW, RHO, failure=material, boundary=[*ends, *held]), bd.Face("x_max"), until=0.002
        )  # fmt: skip
        section = BAR[1] * BAR[2]
        torn = (BAR[1] - NOTCH[1]) * BAR[2] if kind == "notched" else section
        work = float(path.work[-1]) / torn
        note = f"{path.end}, {len(path.load)} events"
        # direct_tension gives the stress over the section at mid-length of the shape, which notches do not narrow
        largest = float(test.run.history["far"][:, 0].max())
        rows += [
            Row("solvers", f"{kind} bar: peak", largest / path.peak, 1.0, SOLVER_LIMIT, seed, count, note=note),
            Row("solvers", f"{kind} bar: work", test.work / work, 1.0, SOLVER_LIMIT, seed, count, note=note),
        ]
    return rows


def _held(body: bd.Lattice) -> list[bd.BoundaryCondition]:
    """Three displacements of cells that take the rigid motion across the load out, and bear nothing."""
    place = body.particles.position
    near = int(((place - [0.0, 0.5 * BAR[1], 0.5 * BAR[2]]) ** 2).sum(axis=1).argmin())
    far = int(((place - [0.0, 0.5 * BAR[1], BAR[2]]) ** 2).sum(axis=1).argmin())
    return [
        bd.Fix(bd.Index([near]), translation="yz", rotation=""), bd.Fix(bd.Index([far]), translation="y", rotation="")
    ]  # fmt: skip
