"""UCS 55 ± 2 and Brazilian 4 ± 0.3 MPa together: runs that it takes, and what unseen packings then bear.

The concrete of Celigueta et al. (2020), E = 40 GPa, ν = 0.2, Ø100 × 200 mm, by `bd.calibrate_strength` on packing 1;
then the same parameters on packings 2 to 5, which the calibration has not seen. Cases, with what is free:

  cells        f_t and c at φ = 35°, from f_t = 4 MPa and c = 14.3 MPa: a continuum has 55 and 4 MPa with these
  cells_steep  f_t and c at φ = 59.8°, from f_t = 4 MPa and c = 7.4 MPa: the line through 55 and 4 MPa
  cells_angle  c and φ at f_t = 4 MPa, from the same
  beams        Euler–Bernoulli beams, peripheral stress: tension and β; shear is ten times tension, friction 0.1
  beams_mohr   parallel bonds, Mohr and Coulomb without moments: tension and cohesion at φ = 35°, friction 0.1
  rankine      the non-local law as the paper has it, weighted areas: σ_R and μ, of elements and of plates
  mohr         the same with Mohr and Coulomb: c and μ at φ = 60°, tension at the tip of the cone

Cells have G_f = 100 J/m² and the tests of `bd.labtests`; beams those of platens.py, with E and ν calibrated on
packing 1; the non-local law the plates of `python -m validation celigueta`.
"""

import functools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from bondem.errors import UnstableRunError
from validation.frame.record import Record
from validation.measures.platens import NU, RHO, E, broken_by, cells, spheres
from validation.rows.celigueta import COUNT, DASHPOT, CeliguetaRun

TARGETS = {"ucs": (55e6, 2e6), "brazilian": (4e6, 0.3e6)}
LAW, ENERGY = bd.CellBond(E=E, nu=NU), 100.0
#: The test of the non-local law that stands for each.
PLATES = {"ucs": "compression", "brazilian": "splitting"}
SHEAR = 10.0
STEEP = math.radians(59.8)

Strength = Callable[..., float]


@functools.cache
def body_of(kind: str, count: int, seed: int) -> bd.Lattice:
    """A specimen, made once."""
    return cells(count, seed) if kind == "cells" else spheres(count, seed)


@functools.cache
def beams(family: type[bd.BondLaw], count: int) -> bd.BondLaw:
    """The law with which packing 1 has E and ν."""
    material = bd.Material("concrete", E=E, nu=NU, rho=RHO)
    return bd.calibrate(body_of("spheres", count, 1), material, law=family).law


def of_cells(test: str, count: int, seed: int, tension: float, cohesion: float, angle: float) -> float:
    """Strength of a body of cells [Pa]."""
    failure = bd.MohrCoulomb(tension=tension, cohesion=cohesion, friction_angle=angle, fracture_energy=ENERGY)
    lab = bd.labtests.uniaxial_compression if test == "ucs" else bd.labtests.brazilian
    return lab(body_of("cells", count, seed), LAW, failure).peak


def of_beams(test: str, count: int, seed: int, family: type[bd.BondLaw], failure: bd.Criterion) -> float:
    """Strength of a lattice of beams [Pa]."""
    return broken_by(test, body_of("spheres", count, seed), beams(family, count), failure, friction=0.1).peak


def of_non_local(test: str, count: int, seed: int, failure: bd.Criterion, friction: float) -> float:
    """Strength of a body of the non-local law [Pa]: largest force on the moving plate.

    Raises:
        UnstableRunError: the run became unstable.
    """
    name = PLATES[test]
    asked = CeliguetaRun(name, "Rankine", "weighted", count or COUNT[name], seed)
    body = asked.body()
    there = asked.model(body)  # for its plates and its density
    model = bd.Model(
        body, bd.NonLocal(E=E, nu=NU, areas="weighted", lever="contact"), there.density, failure=failure,
        contact=bd.LinearContact(E=E, friction=friction, kappa=2.0 * (1.0 + NU), damping=DASHPOT), walls=there.walls,
    )  # fmt: skip
    run = asked.run(model)
    if run.status.failed:
        raise UnstableRunError(run.message)
    return float(np.abs(run.history["moving"][:, asked.axis]).max()) / asked.section


def cone(cohesion: float) -> bd.MohrCoulomb:
    """Mohr and Coulomb of the paper: 60°, and the tip of the cone as its tensile strength."""
    angle = math.radians(60.0)
    return bd.MohrCoulomb(tension=cohesion / math.tan(angle), cohesion=cohesion, friction_angle=angle)


@dataclass(frozen=True)
class Case:
    """What is calibrated.

    Attributes:
        words: what it is.
        start: first values of the free parameters.
        scaled: those that scale all strengths together.
        bounds: of those that have some.
        strength: of a test, a number of elements, a packing and the free parameters [Pa].
    """

    words: str
    start: dict[str, float]
    scaled: tuple[str, ...]
    bounds: dict[str, tuple[float, float]]
    strength: Strength


def _fixed_angle(angle: float) -> Strength:
    def strength(test: str, count: int, seed: int, *, tension: float, cohesion: float) -> float:
        return of_cells(test, count, seed, tension, cohesion, angle)

    return strength


def _angle(test: str, count: int, seed: int, *, cohesion: float, angle: float) -> float:
    return of_cells(test, count, seed, 4e6, cohesion, angle)


def _moments(test: str, count: int, seed: int, *, tension: float, beta: float) -> float:
    failure = bd.PeripheralStress(tension=tension, shear=SHEAR * tension, beta=beta)
    return of_beams(test, count, seed, bd.EulerBernoulli, failure)


def _parallel(test: str, count: int, seed: int, *, tension: float, cohesion: float) -> float:
    failure = bd.MohrCoulomb(tension=tension, cohesion=cohesion, friction_angle=math.radians(35.0))
    return of_beams(test, count, seed, bd.ParallelBond, failure)


def _rankine(test: str, count: int, seed: int, *, tension: float, friction: float) -> float:
    return of_non_local(test, count, seed, bd.Rankine(tension=tension), friction)


def _mohr(test: str, count: int, seed: int, *, cohesion: float, friction: float) -> float:
    return of_non_local(test, count, seed, cone(cohesion), friction)


ROUGH = {"friction": (0.01, 1.5)}
CASES = {
    "cells": Case("cells, φ = 35°: f_t, c", {"tension": 4e6, "cohesion": 14.3e6}, ("tension", "cohesion"), {},
                  _fixed_angle(math.radians(35.0))),
    "cells_steep": Case("cells, φ = 59.8°: f_t, c", {"tension": 4e6, "cohesion": 7.4e6}, ("tension", "cohesion"), {},
                        _fixed_angle(STEEP)),
    "cells_angle": Case("cells, f_t = 4 MPa: c, φ", {"cohesion": 7.4e6, "angle": STEEP}, (), {"angle": (0.3, 1.4)},
                        _angle),
    "beams": Case("beams, peripheral stress: tension, β", {"tension": 60e6, "beta": 0.2}, ("tension",),
                  {"beta": (0.001, 1.0)}, _moments),
    "beams_mohr": Case("parallel bonds, Mohr and Coulomb, φ = 35°: tension, cohesion",
                       {"tension": 12e6, "cohesion": 36e6}, ("tension", "cohesion"), {}, _parallel),
    "rankine": Case("non-local law, Rankine: σ_R, μ", {"tension": 6e6, "friction": 0.1}, ("tension",), ROUGH,
                    _rankine),
    "mohr": Case("non-local law, Mohr and Coulomb, φ = 60°: c, μ", {"cohesion": 14.5e6, "friction": 0.1},
                 ("cohesion",), ROUGH, _mohr),
}  # fmt: skip


def calibrated(name: str, count: int, unseen: Sequence[int], folder: Path) -> dict[str, Any]:
    """One case, and its unseen packings."""
    case = CASES[name]

    def tests(seed: int) -> dict[str, Strength]:
        return {test: functools.partial(case.strength, test, count, seed) for test in TARGETS}

    def tell(line: str) -> None:
        print(f"{name}: {line}", flush=True)

    fit = bd.calibrate_strength(
        tests(1), TARGETS, case.start, strengths=case.scaled, bounds=case.bounds, out=folder / "seed1", progress=tell,
        about=f"{name}, {count} elements, packing 1",
    )  # fmt: skip
    print(f"{name}: {fit}", flush=True)
    found = {
        "case": name, "words": case.words, "count": count, "reached": fit.reached, "message": fit.message,
        "start": case.start, "parameters": dict(fit.nearest.parameters), "sensitivities": fit.sensitivities,
        "runs": [{"parameters": dict(run.parameters), "failed": run.failed,
                  "measured": {test: values[0] for test, values in run.measured.items()}} for run in fit.runs],
        "best": fit.best, "tolerated": {}, "interval": {}, "unseen": [],
    }  # fmt: skip
    if fit.sensitivities is not None:
        found["tolerated"] = {one: fit.tolerated(one) for one in fit.names}
    if not fit.reached:
        return found
    for seed in unseen:
        one = bd.calibrate_strength(
            tests(seed), TARGETS, dict(fit.nearest.parameters), most=1, out=folder / f"seed{seed}", progress=tell,
            about=f"{name}, {count} elements, packing {seed}",
        )  # fmt: skip
        found["unseen"].append({"seed": seed} | {test: one.runs[0].mean(test) for test in TARGETS})
        print(f"{name}: packing {seed}: {one.message}", flush=True)
    if fit.sensitivities is not None and unseen:
        everyone = {test: [fit.nearest.mean(test), *(one[test] for one in found["unseen"])] for test in TARGETS}
        found["interval"] = {one: fit.interval(one, everyone) for one in fit.names}
    return found


def measure(
    record: Record, *, cases: tuple[str, ...] = tuple(CASES), count: int = 1500,
    unseen: tuple[int, ...] = (2, 3, 4, 5),
) -> None:  # fmt: skip
    """Calibrate cases on packing 1, and measure unseen packings."""
    record.keep(targets=TARGETS)
    for name in cases:
        folder = record.beside(f"{name}-{count}")
        record.add(partial(calibrated, name, count, unseen, folder), case=name, count=count)
    record.rows().sort(key=lambda one: (list(CASES).index(one["case"]), one["count"]))
    record.keep()
