"""Notched beams of one concrete that are alike but for their size: peaks, a continuum, and Bažant's law.

The concrete of concrete.py, nothing calibrated: E = 40 GPa, ν = 0.2, f_t = 4 MPa, c = 7.4 MPa, φ = 59.8°, G_f = 100
J/m² along a straight line. Beams 4 D long, D deep and D wide over a span of 3 D, a slot of D/3 × D/20 in the middle,
by load factors. The nominal strength is 3 P S / 2 b D². A continuum with one cohesive crack
(`validation.measures.cohesive_crack`) has the same numbers and nothing else; the law is fitted to the cells.
"""

from dataclasses import replace
from functools import partial
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from bondem.report.style import BLUE, INK, ORANGE, sheet
from validation.cases.beams import BentBeam
from validation.cases.gregoire import GREGOIRE
from validation.figures.axes import plain_ticks
from validation.frame.record import Record
from validation.measures.cohesive_crack import cohesive_crack
from validation.measures.size_effect import SizeEffect
from validation.studies.concrete import ENERGY, LAW, TENSION, concrete

SPAN = 3.0


def beam(depth: float) -> BentBeam:
    """Of a depth [m]."""
    return BentBeam(
        length=4.0 * depth, depth=depth, width=depth, supports=(0.5 * depth, 3.5 * depth), loaded=2.0 * depth,
        notch=(2.0 * depth, depth / 3.0, depth / 20.0),
    )  # fmt: skip


def continuum(depth: float) -> float:
    """Peak of a continuum with a cohesive crack [N]."""
    material = replace(GREGOIRE, E=LAW.E, nu=LAW.nu, tension=TENSION, fracture_energy=ENERGY)
    return cohesive_crack(material, beam(depth), None).peak


def nominal(load: Any, depth: Any) -> Any:
    """3 P S / 2 b D² of a load [N] [Pa]."""
    return 1.5 * load * SPAN / depth**2


def measured(depth: float, count: int, seed: int) -> dict[str, Any]:
    """One beam."""
    shape = beam(depth).shape
    body = bd.connect(bd.pack(shape, count=count, method="even", seed=seed), method="laguerre")
    test = bd.labtests.three_point_bending(body, LAW, concrete(), span=SPAN * depth, together=0.01)
    path: Any = test.path
    return {"load": path.peak, "nominal": float(nominal(path.peak, depth))}


def measure(
    record: Record, *, depths: tuple[float, ...] = (50.0, 100.0, 200.0, 400.0), count: int = 2500,
    seeds: tuple[int, ...] = (1, 2, 3),
) -> None:  # fmt: skip
    """Break beams of several depths [mm], and fit the law to all."""
    for seed, depth in product(seeds, depths):
        record.add(partial(measured, 1e-3 * depth, count, seed), "beams", depth=1e-3 * depth, count=count, seed=seed)
    rows = record.rows("beams")
    rows.sort(key=lambda one: (one["depth"], one["count"], one["seed"]))
    depth, strength = (np.array([one[key] for one in rows]) for key in ("depth", "nominal"))
    law = SizeEffect.fitted(depth, strength)
    known = {each: continuum(each) for each in sorted({*depth.tolist(), 0.8, 1.6})}
    for one in rows:
        one["over_continuum"] = one["load"] / known[one["depth"]]
    record.keep(
        continuum=[{"depth": one, "load": load} for one, load in known.items()],
        law={"strength": law.strength, "transition": law.transition,
             "over": (strength / law.nominal(depth)).tolist()},
    )  # fmt: skip


def draw(record: Record, folder: Path) -> None:
    """Nominal strengths over depths."""
    depth, strength = (np.array([one[key] for one in record.rows("beams")]) for key in ("depth", "nominal"))
    depths, load = (np.array([one[key] for one in record.rows("continuum")]) for key in ("depth", "load"))
    law, fine = SizeEffect.fitted(depth, strength), np.geomspace(0.04, 1.8, 60)
    with sheet(folder / "concrete_beams.png", 6.0, 4.2) as (_, ax):
        ax.plot(1e3 * depths, 1e-6 * nominal(load, depths), "-", color=INK, label="continuum with a cohesive crack")
        ax.plot(1e3 * fine, 1e-6 * law.nominal(fine), "--", color=ORANGE, label="Bažant's law, fitted to the cells")
        ax.plot(1e3 * depth, 1e-6 * strength, "o", color=BLUE, label=f"cells, {len(depth)} beams")
        ax.set(xscale="log", yscale="log", xlabel="depth D [mm]", ylabel="nominal strength 3 P S / 2 b D² [MPa]")
        plain_ticks(ax.xaxis, (50.0, 100.0, 200.0, 400.0, 800.0, 1600.0))
        plain_ticks(ax.yaxis, (1.0, 1.5, 2.0, 2.5, 3.0))
        ax.legend(frameon=False, fontsize=8.0)
