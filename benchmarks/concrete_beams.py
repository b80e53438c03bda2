"""Notched beams of one concrete that are alike but for their size: peaks, a continuum, and Bažant's law.

The concrete of concrete.py, nothing calibrated: E = 40 GPa, ν = 0.2, f_t = 4 MPa, c = 7.4 MPa, φ = 59.8°, G_f = 100
J/m² along a straight line. Beams 4 D long, D deep and D wide over a span of 3 D, a slot of D/3 × D/20 in the middle,
by load factors. The nominal strength is 3 P S / 2 b D². A continuum with one cohesive crack
(`validation.measures.cohesive_crack`) has the same numbers and nothing else; the law is fitted to the cells.

Run: python benchmarks/concrete_beams.py [--depths 50 100 200 400] [--count 2500] [--seeds 1 2 3] [--out DIR]
     python benchmarks/concrete_beams.py --summary [--figures DIR]
Every beam is kept in --out as soon as it is done.
"""

import argparse
import json
import time
from dataclasses import replace
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from bondem.report.style import BLUE, INK, ORANGE, sheet
from concrete import ENERGY, LAW, TENSION, concrete
from kept import RESULTS, commit, keep, origin
from validation.cases.beams import BentBeam
from validation.cases.gregoire import GREGOIRE
from validation.figures.axes import plain_ticks
from validation.measures.cohesive_crack import cohesive_crack
from validation.measures.size_effect import SizeEffect

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
    begun = time.perf_counter()
    test = bd.labtests.three_point_bending(body, LAW, concrete(), span=SPAN * depth, together=0.01)
    load = test.path.peak
    return {
        "depth": depth, "count": count, "seed": seed, "load": load, "nominal": float(nominal(load, depth)),
        "work": test.work, "events": len(test.path.factor), "seconds": time.perf_counter() - begun,
    }  # fmt: skip


def sum_up(out: Path, figures: Path | None) -> None:
    """Bring all beams into the results, and draw them."""
    rows = [json.loads(file.read_text()) for file in out.glob("*-seed?.json")]
    rows.sort(key=lambda one: (one["depth"], one["count"], one["seed"]))
    depth, strength = (np.array([one[key] for one in rows]) for key in ("depth", "nominal"))
    law = SizeEffect.fitted(depth, strength)
    known = {each: continuum(each) for each in sorted({*depth.tolist(), 0.8, 1.6})}
    for one in rows:
        one["over_continuum"] = one["load"] / known[one["depth"]]
    begun = origin() | {"command": "python benchmarks/concrete_beams.py", "commit": rows[0]["commit"]}
    keep(RESULTS / "concrete_beams.json", begun | {
        "beams": rows, "continuum": [{"depth": one, "load": load} for one, load in known.items()],
        "law": {"strength": law.strength, "transition": law.transition,
                "over": (strength / law.nominal(depth)).tolist()},
    })  # fmt: skip
    if figures is None:
        return
    fine, all_depths = np.geomspace(0.04, 1.8, 60), np.array(list(known))
    with sheet(figures / "concrete_beams.png", 6.0, 4.2) as (_, ax):
        ax.plot(1e3 * all_depths, 1e-6 * nominal(np.array(list(known.values())), all_depths), "-", color=INK,
                label="continuum with a cohesive crack")  # fmt: skip
        ax.plot(1e3 * fine, 1e-6 * law.nominal(fine), "--", color=ORANGE, label="Bažant's law, fitted to the cells")
        ax.plot(1e3 * depth, 1e-6 * strength, "o", color=BLUE, label=f"cells, {len(rows)} beams")
        ax.set(xscale="log", yscale="log", xlabel="depth D [mm]", ylabel="nominal strength 3 P S / 2 b D² [MPa]")
        plain_ticks(ax.xaxis, (50.0, 100.0, 200.0, 400.0, 800.0, 1600.0))
        plain_ticks(ax.yaxis, (1.0, 1.5, 2.0, 2.5, 3.0))
        ax.legend(frameon=False, fontsize=8.0)


def main(arguments: list[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--depths", type=float, nargs="+", default=[50.0, 100.0, 200.0, 400.0], help="[mm]")
    parser.add_argument("--count", type=int, default=2500)
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3])
    parser.add_argument("--out", type=Path, default=Path("out/concrete_beams"))
    parser.add_argument("--summary", action="store_true", help="bring what is in --out into the results")
    parser.add_argument("--figures", type=Path, help="draw them here as well")
    given = parser.parse_args(arguments)
    given.out.mkdir(parents=True, exist_ok=True)
    if given.summary:
        sum_up(given.out, given.figures)
        return
    for seed, depth in product(given.seeds, given.depths):
        file = given.out / f"{depth:g}-{given.count}-seed{seed}.json"
        if not file.exists():
            found = measured(1e-3 * depth, given.count, seed)
            file.write_text(json.dumps(found | {"commit": commit()}))
            print(f"{file.stem}: {found['nominal'] / 1e6:.3f} MPa, {found['seconds']:.0f} s", flush=True)


if __name__ == "__main__":
    main()
