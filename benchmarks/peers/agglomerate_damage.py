"""Damage of agglomerates that hit a floor, as a function of speed and energy.

    python benchmarks/peers/agglomerate_damage.py [--out FILE]

The falls are those of `agglomerates.py`, in bondem: 50 balls of 200 bonded spheres in random orientations, and one
ball of 3000, at speeds that break from few to most bonds. 50 balls of a second packing fall at intermediate speeds.

over_strength_speed  speed over that at which E v / c, c² = E / ρ, is the tensile strength of a bond [-]
damage       share of broken bonds at the end [-]
exponent     of a power of the speed, between this one and the one before [-]
share        energy that breaking bonds released over that of the fall [-]
per_bond     kinetic energy of the fall per broken bond, over the elastic energy of a bond at its tensile strength [-]

"lines" have D = slope (v² - threshold²) by least squares over the speeds BETWEEN, of each case, the largest deviation
from it, and that from the line of the first case [-].
"""

import math
import sys
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).parent.parent))
from agglomerate_scenes import DENSITY, STRENGTH, Fall, model_of

import bondem as bd
from kept import Record, run

SPEEDS = (2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0, 14.0)
#: Speeds between the threshold and saturation; cases of bodies, spheres of each, seed of the packing, and speeds.
BETWEEN = (3.0, 4.0, 5.0, 6.0)
CASES = ((50, 200, 1, SPEEDS), (1, 3000, 1, SPEEDS), (50, 200, 2, BETWEEN))


def fall(bodies: int, each: int, seed: int, speed: float) -> dict[str, Any]:
    """Run a fall at one speed [m/s]; return its row of the result."""
    scene = Fall(bodies=bodies, each=each, speed=speed, seed=seed)
    model, state, bond = model_of(scene)
    energy = 0.5 * float(model.mass.sum()) * speed**2
    run = bd.solve_explicit(model, duration=scene.duration, state=state, every=200)
    broken, bonds = len(run.events), len(model.lattice.pairs)
    return {
        "speed": speed, "over_strength_speed": speed / (STRENGTH * math.sqrt(scene.E / DENSITY)), "bonds": bonds,
        "damage": broken / bonds, "share": float(run.history.released[-1]) / energy, "ledger": run.history.imbalance,
        "per_bond": energy / broken / (0.5 * bond["force"] ** 2 / bond["kn"]) if broken else None,
    }  # fmt: skip


def measure(record: Record) -> None:
    lines, first = [], None
    for bodies, each, seed, speeds in CASES:
        case = {"bodies": bodies, "each": each, "seed": seed}
        for speed in speeds:
            record.add(lambda case=case, speed=speed: fall(**case, speed=speed), "falls", **case, speed=speed)
        rows = [row for row in record.rows("falls") if case.items() <= row.items()]
        v, D = (np.array([row[name] for row in rows]) for name in ("speed", "damage"))
        for k, row in enumerate(rows):
            row["exponent"] = None
            if k and D[k - 1] > 0.0:
                row["exponent"] = float(np.log(D[k] / D[k - 1]) / np.log(v[k] / v[k - 1]))
            print({name: row[name] for name in ("speed", "damage", "exponent", "share", "per_bond")}, flush=True)
        between = np.isin(v, BETWEEN)
        line = np.polyfit(v[between] ** 2, D[between], 1)
        first = line if first is None else first
        away, beside = (np.abs(np.polyval(fit, v[between] ** 2) - D[between]).max() for fit in (line, first))
        threshold = math.sqrt(-line[1] / line[0])
        found = {"slope": line[0], "threshold": threshold, "deviation": away, "from_the_first": beside}
        lines.append(case | {name: float(value) for name, value in found.items()})
        record.keep(lines=lines)
        print(lines[-1])


if __name__ == "__main__":
    run()
