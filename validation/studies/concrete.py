"""One concrete in the laboratory's tests: what its strengths imply, and what bodies of cells bear.

E = 40 GPa, ν = 0.2, f_t = 4 MPa, c = 7.4 MPa, φ = 59.8°: what a Mohr–Coulomb continuum needs for 55 MPa in uniaxial
compression and 4 MPa in tension, as the concrete of Celigueta et al. (2020) was measured to do. They publish no
fracture energy: G_f = 100 J/m² is assumed, as is usual for concrete, and G_II is 10 G_f, the default. Nothing is
calibrated. Cylinders Ø100 × 200 mm for "ucs", "brazilian", "triaxial" and "tension", beams 400 × 100 × 100 mm over
300 mm for "bending", to a third of the depth "notched" in the middle, and the paper's specimen with two ring borings
for "shear". "thin" and "tough" are Brazilian tests with other fracture energies, for what that alone changes:
20 J/m², and the same 100 J/m² along Petersson's two lines. "cut_off" is one with c = 14.3 MPa, φ = 35°: the same
strengths in compression and in tension, of which the latter cuts the line off, where above both coincide. "narrow"
and "wide" are Brazilian tests between strips of 5° and 12° (α) in place of the default, 8° for 2000 cells.
"""

import math
from dataclasses import dataclass, replace
from functools import partial
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from validation.figures.concrete import draw_all
from validation.frame.record import Record

LAW = bd.CellBond(E=40e9, nu=0.2)
TENSION, COHESION, ANGLE, ENERGY = 4e6, 7.4e6, math.radians(59.8), 100.0
RADIUS, LENGTH = 50e-3, 200e-3
BEAM, NOTCH = (400e-3, 100e-3, 100e-3), (5e-3, 100e-3 / 3.0)  # notch: width along x, depth along y


def concrete(energy: float = ENERGY, curve: bd.Bilinear | None = None) -> bd.MohrCoulomb:
    """The material."""
    return bd.MohrCoulomb(
        tension=TENSION, cohesion=COHESION, friction_angle=ANGLE, fracture_energy=energy, curve=curve
    )


def compressive(pressure: float = 0.0) -> float:
    """What a Mohr–Coulomb continuum bears under a pressure on its sides [Pa]."""
    sine = math.sin(ANGLE)
    return (2.0 * COHESION * math.cos(ANGLE) + pressure * (1.0 + sine)) / (1.0 - sine)


@dataclass(frozen=True)
class Case:
    """One test.

    Attributes:
        kind: of test.
        theory: what the strengths imply [Pa]; None where that has no closed form.
        pressure: on the sides [Pa].
    """

    kind: str
    theory: float | None
    pressure: float = 0.0


#: The elastic stress at the centre of a disc, (0, -3 s, s), meets Mohr–Coulomb's line at c cos φ / (2 - sin φ).
SPLIT = min(TENSION, COHESION * math.cos(ANGLE) / (2.0 - math.sin(ANGLE)))
CASES = (
    Case("ucs", compressive()), Case("brazilian", TENSION), Case("tension", TENSION),
    *(Case("triaxial", compressive(p), p) for p in (2e6, 5e6, 10e6)),
    Case("bending", None), Case("notched", None), Case("shear", None), Case("thin", TENSION), Case("tough", TENSION),
    Case("cut_off", TENSION), Case("narrow", TENSION), Case("wide", TENSION),
)  # fmt: skip


#: Half the angles of strips that are not the default [rad].
STRIPS = {"narrow": math.radians(5.0), "wide": math.radians(12.0)}


def specimen(kind: str, count: int, seed: int) -> bd.Lattice:
    """The body of a test."""
    shape: bd.Shape = bd.Cylinder(radius=RADIUS, length=LENGTH)
    if kind in ("bending", "notched"):
        shape = bd.Box(BEAM)
    if kind == "notched":
        slot = bd.Box((NOTCH[0], NOTCH[1], 2.0 * BEAM[2]))
        shape = shape.cut(slot.moved((0.5 * (BEAM[0] - NOTCH[0]), 0.0, -0.5 * BEAM[2])), name="notch")
    if kind == "shear":
        shape = bd.labtests.punch_specimen()
    return bd.connect(bd.pack(shape, count=count, method="even", seed=seed), method="laguerre")


def tested(case: Case, body: bd.Lattice) -> tuple[Any, dict[str, float]]:
    """Return the result of a test; of a disc also stress factors [-], half angle [rad] and tension [Pa]."""
    labtests, failure = bd.labtests, concrete()
    match case.kind:
        case "ucs":
            return labtests.uniaxial_compression(body, LAW, failure), {}
        case "triaxial":
            return labtests.triaxial(body, LAW, failure, pressure=case.pressure), {}
        case "tension":
            return labtests.direct_tension(body, LAW, failure), {}
        case "bending" | "notched":
            return labtests.three_point_bending(body, LAW, failure, together=0.01), {}
        case "shear":
            return labtests.shear(body, LAW, failure), {}
    split = labtests.brazilian(body, LAW, _material(case.kind), half_angle=STRIPS.get(case.kind))
    values = {"centre": split.centre, "factor": split.factor, "half_angle": split.half_angle}
    return split, values | {"tension": split.tension, "onset": SPLIT}


def _material(kind: str) -> bd.MohrCoulomb:
    """Of Brazilian tests."""
    match kind:
        case "thin":
            return concrete(energy=20.0)
        case "tough":
            return concrete(curve=bd.Bilinear())
        case "cut_off":
            return replace(concrete(), cohesion=14.3e6, friction_angle=math.radians(35.0))
    return concrete()


def measured(case: Case, count: int, seed: int, kept: Path) -> dict[str, Any]:
    """One test of one specimen; its curve and how it broke are kept in a file beside its row."""
    body = specimen(case.kind, count, seed)
    test, told = tested(case, body)
    damage = np.zeros(len(body.particles))
    whole = test.path.bond_integrity if hasattr(test, "path") else test.state.bond_integrity
    for end in body.pairs.T:
        np.maximum.at(damage, end, 1.0 - whole)
    np.savez_compressed(
        kept, curve=test.curve, damage=damage, displacement=test.state.displacement,
        orientation=test.state.orientation,
    )  # fmt: skip
    return {
        "peak": test.peak, "theory": case.theory, "ratio": None if case.theory is None else test.peak / case.theory,
        "E": test.E / LAW.E, "work": test.work,
    } | told  # fmt: skip


def measure(
    record: Record, *, kinds: tuple[str, ...] = tuple(dict.fromkeys(case.kind for case in CASES)),
    counts: tuple[int, ...] = (2500,), seeds: tuple[int, ...] = (1, 2, 3),
) -> None:  # fmt: skip
    """Carry out all tests of several kinds."""
    material = {"E": LAW.E, "nu": LAW.nu, "tension": TENSION, "cohesion": COHESION, "friction_angle": ANGLE}
    record.keep(material=material | {"fracture_energy": ENERGY}, onset=SPLIT)
    for count, seed, case in product(counts, seeds, CASES):
        if case.kind in kinds:
            asked = {"kind": case.kind, "pressure": case.pressure, "count": count, "seed": seed}
            record.add(partial(measured, case, count, seed, record.beside(name_of(asked))), **asked)
    order = [case.kind for case in CASES]
    record.rows().sort(key=lambda one: (order.index(one["kind"]), one["pressure"], one["count"], one["seed"]))
    record.keep()


def name_of(one: dict[str, Any]) -> str:
    """Of the file of curves of a row."""
    return f"{one['kind']}-{one['pressure'] / 1e6:g}-{one['count']}-seed{one['seed']}.npz"


def draw(record: Record, folder: Path) -> None:
    """For each test, its largest specimen as it broke and the curves of all."""
    draw_all([(record.beside(name_of(one)), one) for one in record.rows()], folder, specimen)
