"""Brazilian strength beside the tensile strength that was put in: discs of cells, loaded across a diameter.

A concrete: E = 40 GPa, ν = 0.2, f_t = 4 MPa, c = 14.3 MPa, φ = 35°. The disc is flattened by 20° (2α) at both ends,
and smooth platens press on the flats. Theory is the elastic stress at the centre of such a disc (Wang et al. 2004):

    σ = k 2P / (π D t),     k = (2 cos³α + cos α + sin α/α)² / (8 (cos α + sin α/α)) · α/sin α     = 0.960 at 10°

in plane stress. Without failure "centre" is σ_z of the cells near the axis over it, and "largest" the largest
principal stress of all cells: on both end faces, as the disc is thick. A brittle disc splits where that is f_t; one
that softens takes more, the more so the longer E G_f / f_t² is beside D (`disc_finite_elements.py`). The strength is
the first maximum, from which the load falls by a tenth; the halves, which stay between the platens, may take more
later. Nothing is calibrated; all discs that were tried are kept.
"""

import math
from functools import partial
from itertools import product
from typing import Any

import numpy as np

import bondem as bd
from validation.cases.flattened_disc import FlattenedDisc
from validation.frame.record import Record

LAW = bd.CellBond(E=40e9, nu=0.2)
TENSION, COHESION, ANGLE = 4e6, 14.3e6, math.radians(35.0)
DIAMETER, THICKNESS, DENSITY = 50e-3, 20e-3, 2400.0
DISC = FlattenedDisc(DIAMETER, THICKNESS)
#: Load at which the stress at the centre is f_t [N].
EXPECTED = 0.5 * math.pi * DIAMETER * THICKNESS * TENSION / DISC.factor


def pressed(body: bd.Lattice, failure: bd.Criterion | None) -> bd.ExplicitResult:
    """One disc until it has split, or to a third of the expected load without failure."""
    top = [0.0]

    def ended(_: bd.State, record: bd.History) -> bool:
        force = abs(float(record["top"][-1, 1]))
        top[0] = max(top[0], force)
        if failure is None:
            return top[0] > 0.3 * EXPECTED
        return top[0] > 0.5 * EXPECTED and force < 0.9 * top[0]

    return DISC.loaded(body, LAW, failure, TENSION, density=DENSITY, ended=ended)


def elastic(body: bd.Lattice) -> dict[str, float]:
    """Stress across the loaded diameter in the cells near the axis, and the largest principal one, over theory."""
    run = pressed(body, None)
    state: Any = run.state
    stress = bd.cell_stress(state.model, state)
    place, middle = body.particles.position, np.mean(body.particles.envelope.bounds, axis=0)
    near = np.hypot(place[:, 1] - middle[1], place[:, 2] - middle[2]) < 0.1 * DIAMETER
    assert body.cells is not None
    volume = body.cells.volume[near]
    force = abs(run.history["top"][-1, 1])
    theory = 2.0 * DISC.factor * force / (math.pi * DIAMETER * THICKNESS)
    return {
        "centre": float((stress[near, 2, 2] * volume).sum() / volume.sum() / theory),
        "largest": float(np.linalg.eigvalsh(stress)[:, 2].max() / theory),
    }


def measured(body: bd.Lattice, energy: float) -> dict[str, Any]:
    """Ratio of the Brazilian strength to the tensile one."""
    failure = bd.MohrCoulomb(tension=TENSION, cohesion=COHESION, friction_angle=ANGLE, fracture_energy=energy)
    run = pressed(body, failure)
    history = run.history
    both = -history["top"][:, 1], history["bottom"][:, 1]
    peak = int(np.argmax(both[0] + both[1]))
    force = 0.5 * (both[0] + both[1])[peak]
    return {
        "energy": energy, "peak": float(force),
        "strength": 2.0 * DISC.factor * float(force) / (math.pi * DIAMETER * THICKNESS * TENSION),
        "asymmetry": float(np.abs(both[0] - both[1])[: peak + 1].max() / force), "residual": run.residual,
        "length": LAW.E * energy / TENSION**2 / DIAMETER, "status": run.status.value,
    }  # fmt: skip


def measure(
    record: Record, *, counts: tuple[int, ...] = (3000, 10_000), seeds: tuple[int, ...] = (1, 2, 3),
    energies: tuple[float, ...] = (5.0, 20.0),
) -> None:  # fmt: skip
    """Split discs whose facets have several fracture energies [J/m²]."""
    record.keep(flattened=DISC.factor)
    for count, seed, energy in product(counts, seeds, energies):
        record.add(partial(split, count, seed, energy), count=count, seed=seed, energy=energy)


def split(count: int, seed: int, energy: float) -> dict[str, Any]:
    """One disc, without failure and with it."""
    body = DISC.body(count, seed)
    return elastic(body) | measured(body, energy)
