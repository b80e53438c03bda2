"""Strengths and fracture energies of bodies of cells: what is put in, and what tests to failure give back.

A concrete: E = 40 GPa, ν = 0.2, f_t = 4 MPa, c = 14.3 MPa, φ = 35°. Direct tension of a bar, plain and notched on one
side to a third of its depth: peak over f_t, and work over the ligament and G_f. Compression between smooth platens,
with a pressure on the sides or without: peak over what a Mohr–Coulomb continuum bears. Nothing is calibrated.
Without fracture energy a notched bar has the toughness of its elements: σ √(π a) over f_t √d is the same for all
sizes d, with σ the largest stress of the whole section, a the depth of the notch, and no factor for the shape; "slit"
is a notch half a cell wide, where the root of the notch has no size of its own.
"""

import math
from dataclasses import dataclass
from functools import partial
from itertools import product
from typing import Any

import numpy as np

import bondem as bd
from validation.frame.record import Record

LAW = bd.CellBond(E=40e9, nu=0.2)
TENSION, COHESION, ANGLE = 4e6, 14.3e6, math.radians(35.0)
SIZE = (60e-3, 30e-3, 30e-3)
NOTCH = (3e-3, 10e-3)  # width along x, depth along y
#: Allowed distance from what was put in [-].
LIMIT = 0.05


@dataclass(frozen=True)
class Case:
    """One test.

    Attributes:
        kind: of test.
        energy: G_f [J/m²] in tension, G_II in compression; 0 is brittle.
        pressure: on the sides [Pa].
    """

    kind: str
    energy: float
    pressure: float = 0.0


CASES = (
    Case("tension", 20.0), Case("tension", 80.0), Case("notched", 20.0), Case("notched", 80.0), Case("brittle", 0.0),
    Case("notched", 0.0), Case("slit", 0.0),
    Case("compression", 50.0), Case("compression", 500.0), Case("compression", 5000.0),
    Case("triaxial", 500.0, 5e6), Case("triaxial", 500.0, 10e6), Case("triaxial", 5000.0, 5e6),
    Case("triaxial", 5000.0, 10e6),
)  # fmt: skip


def specimen(kind: str, count: int, seed: int) -> bd.Lattice:
    shape: bd.Shape = bd.Box(SIZE)
    if kind in ("notched", "slit"):
        width = NOTCH[0] if kind == "notched" else 0.5 * (math.prod(SIZE) / count) ** (1.0 / 3.0)
        slot = bd.Box((width, NOTCH[1], 2.0 * SIZE[2]))
        shape = shape - slot.moved((0.5 * (SIZE[0] - width), 0.0, -0.5 * SIZE[2]))
    return bd.connect(bd.pack(shape, count=count, method="even", seed=seed), method="laguerre")


def measured(case: Case, count: int, seed: int) -> dict[str, Any]:
    """One test of one specimen: ratios to what was put in, and how far from statics it was."""
    body = specimen(case.kind, count, seed)
    rows: dict[str, float] = {}
    if case.kind in ("compression", "triaxial"):
        failure = bd.MohrCoulomb(
            tension=TENSION, cohesion=COHESION, friction_angle=ANGLE, fracture_energy=50.0,
            fracture_energy_shear=case.energy,
        )  # fmt: skip
        test = bd.labtests.uniaxial_compression(body, LAW, failure, pressure=case.pressure)
        assert failure.softening is not None
        (slip,) = failure.softening.slips
        rows["strength"] = test.peak / slip.compressive(case.pressure)
    else:
        failure = bd.Rankine(tension=TENSION, fracture_energy=case.energy or None)
        test = bd.labtests.direct_tension(body, LAW, failure)
        if case.kind not in ("notched", "slit"):
            rows["strength"] = test.peak / TENSION
        if case.energy:
            rows["energy"] = test.work / case.energy  # over the section at mid-length, the ligament
    assert body.facets is not None
    length = float(np.median(body.facets.span))
    toughness = {}
    if case.kind in ("notched", "slit") and not case.energy:
        gross = test.peak * (1.0 - NOTCH[1] / SIZE[1])
        toughness = {"toughness": gross * math.sqrt(math.pi * NOTCH[1]) / (TENSION * math.sqrt(length))}
    return toughness | {
        "length": length, "ratios": rows, "asymmetry": test.asymmetry, "kinetic": test.kinetic,
        "residual": test.residual, "status": test.run.status.value,
    }  # fmt: skip


def measure(
    record: Record, *, kinds: tuple[str, ...] = tuple(sorted({case.kind for case in CASES})),
    counts: tuple[int, ...] = (1000, 3000, 10_000), seeds: tuple[int, ...] = (1, 2, 3, 4, 5),
) -> None:  # fmt: skip
    """Carry out all tests of several kinds."""
    for count, seed, case in product(counts, seeds, CASES):
        if case.kind in kinds:
            record.add(partial(measured, case, count, seed), kind=case.kind, energy=case.energy,
                       pressure=case.pressure, count=count, seed=seed)  # fmt: skip
    record.rows().sort(key=lambda one: one["seed"])
    judged = [one for one in record.rows() if one["ratios"]]
    within = sum(all(abs(ratio - 1.0) <= LIMIT for ratio in one["ratios"].values()) for one in judged)
    record.keep(within=within)
    print(f"{within} of {len(judged)} specimens within {100 * LIMIT:g} % in all that was measured")
