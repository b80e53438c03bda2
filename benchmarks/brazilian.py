"""Brazilian strength beside the tensile strength that was put in: discs of cells, loaded across a diameter.

A concrete: E = 40 GPa, ν = 0.2, f_t = 4 MPa, c = 14.3 MPa, φ = 35°. The disc is flattened by 20° (2α) at both ends,
and smooth platens press on the flats. Theory is the elastic stress at the centre of such a disc (Wang et al. 2004):

    σ = k 2P / (π D t),     k = (2 cos³α + cos α + sin α/α)² / (8 (cos α + sin α/α)) · α/sin α     = 0.960 at 10°

in plane stress. Without failure "centre" is σ_z of the cells near the axis over it, and "largest" the largest
principal stress of all cells: on both end faces, as the disc is thick. A brittle disc splits where that is f_t; one
that softens takes more, the more so the longer E G_f / f_t² is beside D (`disc_finite_elements.py`). The strength is
the first maximum, from which the load falls by a tenth; the halves, which stay between the platens, may take more
later. Nothing is calibrated; all discs that were tried are kept.

Run: python benchmarks/brazilian.py [--counts 3000 10000] [--seeds 1 2 3] [--energies 5 20] [--out FILE]
"""

import argparse
import itertools
import json
import math
import time
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from kept import RESULTS, keep, origin

LAW = bd.CellBond(E=40e9, nu=0.2)
TENSION, COHESION, ANGLE = 4e6, 14.3e6, math.radians(35.0)
DIAMETER, THICKNESS, DENSITY = 50e-3, 20e-3, 2400.0
HALF = math.radians(10.0)  # α, half the angle of a flat
SOUND = math.sqrt(LAW.E / DENSITY)
#: Traverses of sound until the stress at the centre is f_t.
TRAVERSES = 100.0


def flattened() -> float:
    """Stress at the centre of a flattened disc over that of a whole one [-]."""
    c, s = math.cos(HALF), math.sin(HALF) / HALF
    return (2.0 * c**3 + c + s) ** 2 / (8.0 * (c + s)) / s


#: Load at which the stress at the centre is f_t [N].
EXPECTED = 0.5 * math.pi * DIAMETER * THICKNESS * TENSION / flattened()


def disc(count: int, seed: int) -> bd.Lattice:
    """A disc with its axis along x, and the flats "top" and "bottom" across y."""
    radius = 0.5 * DIAMETER
    flat = radius * math.cos(HALF)
    shape: bd.Shape = bd.Cylinder(radius=radius, length=THICKNESS)
    lower, upper = shape.bounds
    middle = 0.5 * (lower[1] + upper[1])
    block = bd.Box((3.0 * THICKNESS, DIAMETER, 2.0 * DIAMETER))
    corner = lower[0] - THICKNESS, 0.5 * (lower[2] + upper[2]) - DIAMETER
    for name, y in (("top", middle + flat), ("bottom", middle - flat - DIAMETER)):
        shape = shape.cut(block.moved((corner[0], y, corner[1])), name=name)
    return bd.connect(bd.pack(shape, count=count, method="even", seed=seed), method="laguerre")


def pressed(body: bd.Lattice, failure: bd.Criterion | None) -> bd.ExplicitResult:
    """One disc until it has split, or to a third of the expected load without failure."""
    rise = TRAVERSES * DIAMETER / SOUND
    # both flats come together by some 8 f_t / E of the height until then
    speed = 0.5 * 8.0 * TENSION / LAW.E * DIAMETER / rise
    begin = 0.1 * rise
    boundary: list[bd.BoundaryCondition] = [
        bd.Drive(bd.Face(name), vy=bd.Ramp(0.0, sign * speed, begin)) for name, sign in (("top", -1), ("bottom", 1))
    ]
    model = bd.Model(body, LAW, DENSITY, failure=failure, boundary=boundary)
    top = [0.0]

    def ended(_: bd.State, record: bd.History) -> bool:
        force = abs(float(record["top"][-1, 1]))
        top[0] = max(top[0], force)
        if failure is None:
            return top[0] > 0.3 * EXPECTED
        return top[0] > 0.5 * EXPECTED and force < 0.9 * top[0]

    return bd.solve_explicit(
        model, duration=4.0 * rise, every=40, callback=ended,
        damping=bd.MassDamping(alpha=0.1 * math.pi * SOUND / DIAMETER),
        gauges={name: bd.Gauge(bd.Face(name), "force") for name in ("top", "bottom")},
    )  # fmt: skip


def elastic(body: bd.Lattice) -> dict[str, float]:
    """Stress across the loaded diameter in the cells near the axis, and the largest principal one, over theory."""
    run = pressed(body, None)
    stress = bd.cell_stress(run.state.model, run.state)
    place, middle = body.particles.position, np.mean(body.particles.envelope.bounds, axis=0)
    near = np.hypot(place[:, 1] - middle[1], place[:, 2] - middle[2]) < 0.1 * DIAMETER
    assert body.cells is not None
    volume = body.cells.volume[near]
    force = abs(run.history["top"][-1, 1])
    theory = 2.0 * flattened() * force / (math.pi * DIAMETER * THICKNESS)
    return {
        "centre": float((stress[near, 2, 2] * volume).sum() / volume.sum() / theory),
        "largest": float(np.linalg.eigvalsh(stress)[:, 2].max() / theory),
    }


def measured(body: bd.Lattice, energy: float) -> dict[str, Any]:
    """Ratio of the Brazilian strength to the tensile one."""
    failure = bd.MohrCoulomb(tension=TENSION, cohesion=COHESION, friction_angle=ANGLE, fracture_energy=energy)
    begun = time.perf_counter()
    run = pressed(body, failure)
    history = run.history
    both = -history["top"][:, 1], history["bottom"][:, 1]
    peak = int(np.argmax(both[0] + both[1]))
    force = 0.5 * (both[0] + both[1])[peak]
    return {
        "energy": energy, "peak": float(force),
        "strength": 2.0 * flattened() * float(force) / (math.pi * DIAMETER * THICKNESS * TENSION),
        "asymmetry": float(np.abs(both[0] - both[1])[: peak + 1].max() / force), "residual": run.residual,
        "length": LAW.E * energy / TENSION**2 / DIAMETER, "slipped": int((run.state.slipped > 0.0).sum()),
        "cracks": len(run.state.cracks), "broken": len(run.events), "status": run.status.value,
        "seconds": time.perf_counter() - begun,
    }  # fmt: skip


def main(arguments: list[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--counts", type=int, nargs="+", default=[3000, 10_000])
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3])
    parser.add_argument("--energies", type=float, nargs="+", default=[5.0, 20.0])
    parser.add_argument("--out", type=Path, default=RESULTS / "brazilian.json")
    given = parser.parse_args(arguments)
    begun, found = origin(), []
    if given.out.exists():
        found = json.loads(given.out.read_text())["cases"]
    for case in itertools.product(given.counts, given.seeds, given.energies):
        if any((one["count"], one["seed"], one["energy"]) == case for one in found):
            continue
        count, seed, energy = case
        body = disc(count, seed)
        found.append({"count": count, "seed": seed} | elastic(body) | measured(body, energy))
        keep(given.out, begun | {"flattened": flattened(), "cases": found})
        print({name: found[-1][name] for name in ("count", "seed", "largest", "energy", "strength")}, flush=True)


if __name__ == "__main__":
    main()
