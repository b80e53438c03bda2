"""Fracture energy of compact specimens (ASTM E399) whose pins turn freely: cracks that open by turning."""

import math
from dataclasses import dataclass
from functools import cache

import numpy as np

import bondem as bd
from validation.studies.paths.driving import LAW, RHO, RISE, TENSION, E
from validation.studies.paths.mirrored import cut
from validation.studies.paths.rows import Row
from validation.studies.paths.softening_energy import CURVES, ENERGY_LIMIT, kinds, material

#: W from the line of the load, thickness, a / W, width of the notch [m], distance of a pin from the notch over W.
WIDTH, THICK, ALPHA, SLOT, PIN = 80e-3, 16e-3, 0.5, 4e-3, 0.275
#: Share of the ligament that is still to open when a run ends, by halves that turn about their far edge.
REST = 0.15
# Time for an opening of the ligament by its last one, in traverses of sound, and rounds of centring.
_TRAVERSES, _ROUNDS = 120.0, 8


@dataclass(frozen=True, eq=False)
class Compact:
    """A compact specimen, 1.25 W long and 1.2 W high, and the cells of its pins: a row on each axis, upper one first.

    A pin in its hole turns freely. Cells that move alike do so only where they are on one line: with pins of a
    diameter of W/4 whose cells move alike, the load stays at 0.8 of its peak until the last cells part at once.
    """

    body: bd.Lattice
    pins: tuple[bd.Region, bd.Region]


@cache
def specimen(seed: int, count: int) -> Compact:
    """A packing whose cells nearest to the axes of the pins are moved until their centroids are on them."""
    height, tip = 1.2 * WIDTH, (0.25 + ALPHA) * WIDTH
    slot = bd.Box((2.0 * tip, SLOT, 3.0 * THICK)).moved((-tip, 0.5 * (height - SLOT), -THICK))
    shape = bd.Box((1.25 * WIDTH, height, THICK)).cut(slot, name="notch")
    cell = (shape.volume / count) ** (1.0 / 3.0)
    place = bd.pack(shape, count=count, method="even", seed=seed).position.copy()
    layers = max(2, round(THICK / cell))
    axes = [(0.25 * WIDTH, 0.5 * height + way * PIN * WIDTH) for way in (1.0, -1.0)]
    aims = np.array([[x, y, (k + 0.5) / layers * THICK] for x, y in axes for k in range(layers)])
    chosen: list[int] = []
    for aim in aims:
        away = ((place - aim) ** 2).sum(axis=1)
        away[chosen] = np.inf
        chosen.append(int(away.argmin()))
    place[chosen] = aims
    for _ in range(_ROUNDS):
        centroid = cut(place, shape, cell).centre
        seeds = place[chosen] + aims - centroid[chosen]
        place = centroid.copy()
        place[chosen] = seeds
    pins = bd.Index(chosen[:layers]), bd.Index(chosen[layers:])
    return Compact(cut(place, shape, cell), pins)


def compact_tension(seed: int, count: int) -> list[Row]:
    """Work of compact specimens over their ligament."""
    rows = []
    for energy, curve in kinds():
        work, note = _torn(specimen(seed, count), energy, curve)
        note = f"G_f = {energy:g} J/m², {curve}, {note}"
        rows.append(Row("energy", "compact tension: G_f", work / energy, 1.0, ENERGY_LIMIT, mean=True, note=note))
    return rows


def _torn(found: Compact, energy: float, curve: str) -> tuple[float, str]:
    """Work over the ligament [J/m²], with what the part that is still to open would take, and a note."""
    strong = bd.Rankine(tension=10.0 * TENSION, fracture_energy=100.0 * energy, curve=CURVES[curve])
    # nothing is to fail outside a band about the ligament: arms of tough material would bend before it parts
    block = bd.Box((1.5 * WIDTH, 0.41 * WIDTH, 3.0 * THICK))
    about = [bd.Within(block.moved((-0.1 * WIDTH, y * WIDTH, -THICK))) for y in (-0.01, 0.8)]
    opening = (3.6 if CURVES[curve] else 2.0) * energy / TENSION
    ligament, arm = (1.0 - ALPHA) * WIDTH, WIDTH
    # of each pin when the crack is open by its last opening at REST of the ligament from the far edge
    way = 0.5 * opening / (REST * ligament) * arm
    long = 1.2 * WIDTH
    sound = math.sqrt(E / RHO)
    duration = _TRAVERSES * long / sound * way / opening
    rise = RISE * duration
    speed = way / (duration - 0.5 * rise)
    boundary = [
        bd.Drive(pin, vy=bd.Ramp(0.0, side * speed, rise)) for pin, side in zip(found.pins, (1.0, -1.0), strict=True)
    ]
    failure: bd.FailureAssignment = {
        bd.Everything(): material(energy, curve), about[0]: strong, about[1]: strong,
    }  # fmt: skip
    run = bd.solve_explicit(
        bd.Model(found.body, LAW, RHO, failure=failure, boundary=boundary), duration=duration, every=50,
        damping=bd.MassDamping(alpha=0.02 * math.pi * sound / long),  # halves turn
    )  # fmt: skip
    spent = float(run.history.released[-1]) / (ligament * THICK * energy)
    rest = REST * _rest(curve)
    note = f"{run.status.value}, dissipated {spent:.3f}, to open {rest:.3f}, imbalance {run.history.imbalance:.1e}"
    return (spent + rest) * energy, note


def _rest(curve: str) -> float:
    """Mean over openings from nothing to the last one of the share of G_f that is still to be dissipated."""
    # stress at openings over the last one: along a line, or along two (Petersson 1981: f_t/3 at 0.8 G_f / f_t of 3.6)
    w, stress = ([0.0, 1.0], [1.0, 0.0]) if CURVES[curve] is None else ([0.0, 0.8 / 3.6, 1.0], [1.0, 1.0 / 3.0, 0.0])
    at = np.linspace(0.0, 1.0, 2001)
    left = np.interp(at, w, stress)
    # dissipated with unloading to the origin: area under the curve, less the triangle below the present stress
    area = np.concatenate([[0.0], np.cumsum(0.5 * (left[1:] + left[:-1]) * np.diff(at))])
    return float(np.mean(1.0 - (area - 0.5 * left * at) / area[-1]))
