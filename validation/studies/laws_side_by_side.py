"""One cylinder, one rig, all laws side by side: E, ν, strengths, toughness, cracks and cost.

The concrete of E = 40 GPa, ν = 0.2, f_t = 4 MPa, c = 14.3 MPa, φ = 35° (54.9 MPa in compression as a continuum), as
a cylinder Ø100 × 200 mm, compressed, pulled and split between the platens of platens.py. Beams have E and ν
calibrated on packing 1. Strengths of laws that break at once are multiplied by one factor so that packing 1 bears
4 MPa in direct tension; shear or cohesion over tension stays 3.575. What a law has then in compression and in
splitting is its own. Friction of what is broken is 0.1; there is none at the platens. K_Ic is what `bd.explain` says
that strength, stiffness and size of elements mean together, not a test. The cost is that of 2000 elastic steps with
criterion and contacts, of the second of two such runs, in time of the processor and without that of starting a run
(of the non-local law, whose step is found by trial, a fourth of it).
"""

import functools
import json
import math
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from validation.figures.side_by_side import draw_broken
from validation.frame.record import Record
from validation.measures.platens import NU, RADIUS, RHO, E, Tested, broken_by, cells, model_of, spheres

TENSION, OVER, ANGLE, ENERGY = 4e6, 14.3 / 4.0, math.radians(35.0), 100.0
FRICTION, REACH, STEPS = 0.1, 1.3, 2000
TESTS = ("tension", "ucs", "brazilian")
Failure = Callable[[float], bd.Criterion]


def peripheral(strength: float) -> bd.Criterion:
    """Of the outermost fibre; parallel bonds have it as their own strength."""
    return bd.PeripheralStress(tension=strength, shear=OVER * strength)


def coulomb(strength: float) -> bd.Criterion:
    """Breaks at once."""
    return bd.MohrCoulomb(tension=strength, cohesion=OVER * strength, friction_angle=ANGLE)


def softening(strength: float) -> bd.Criterion:
    """With a fracture energy."""
    return bd.MohrCoulomb(tension=strength, cohesion=OVER * strength, friction_angle=ANGLE, fracture_energy=ENERGY)


def rankine(strength: float) -> bd.Criterion:
    """Of the largest principal stress."""
    return bd.Rankine(tension=strength)


@dataclass(frozen=True)
class Kind:
    """A law with its criterion.

    Attributes:
        words: name in the table.
        specimen: "spheres", "cells", or "gaps": spheres bonded up to a reach of 1.3.
        family: of beams, calibrated; None for laws that take E and ν of the material.
        failure: by strength in tension.
        first: strength at which the factor is measured [Pa]; None for those that keep what is put in.
    """

    words: str
    specimen: str
    family: type[bd.BondLaw] | None
    failure: Failure
    first: float | None


KINDS = {
    "euler": Kind("Euler–Bernoulli, peripheral stress", "spheres", bd.EulerBernoulli, peripheral, 70e6),
    "timoshenko": Kind("Timoshenko, Mohr–Coulomb", "spheres", bd.Timoshenko, coulomb, 7e6),
    "parallel": Kind("parallel bond, its strength", "spheres", bd.ParallelBond, peripheral, 25e6),
    "rankine": Kind("non-local, Rankine", "gaps", None, rankine, 6e6),
    "mohr": Kind("non-local, Mohr–Coulomb", "gaps", None, coulomb, 6e6),
    "cells": Kind("cells, Mohr–Coulomb, brittle", "cells", None, coulomb, 4e6),
    "cells_soft": Kind("cells, Mohr–Coulomb, G_f = 100 J/m²", "cells", None, softening, None),
}


@functools.cache
def body_of(specimen: str, count: int, seed: int) -> bd.Lattice:
    """A specimen, made once."""
    if specimen == "cells":
        return cells(count, seed)
    touching = spheres(count, seed)
    return touching if specimen == "spheres" else bd.connect(touching.particles, reach=REACH)


@functools.cache
def law_of(name: str, count: int) -> Any:
    """With E and ν of the concrete, of beams on packing 1."""
    kind = KINDS[name]
    if kind.family is not None:
        material = bd.Material("concrete", E=E, nu=NU, rho=RHO)
        wider = (0.1, 2.0) if kind.family is bd.Timoshenko else None
        return bd.calibrate(body_of("spheres", count, 1), material, law=kind.family, search=wider).law
    if kind.specimen == "gaps":
        return bd.NonLocal(E=E, nu=NU, areas="weighted", lever="contact")
    return bd.CellBond(E=E, nu=NU)


def strength_of(name: str, count: int, out: Path) -> float:
    """Strength in tension that is put in [Pa]: that with which packing 1 bears 4 MPa, found once and kept."""
    kind, file = KINDS[name], out / f"{name}-{count}-factor.json"
    if kind.first is None:
        return TENSION
    if not file.exists():
        strength, peak = kind.first, 0.0
        for _ in range(3):  # once does where the first test breaks
            body, law = body_of(kind.specimen, count, 1), law_of(name, count)
            peak = broken_by("tension", body, law, kind.failure(strength), friction=FRICTION).peak
            print(f"{name}: {peak / 1e6:.3f} MPa in tension with {strength / 1e6:.4g} MPa", flush=True)
            if abs(peak / TENSION - 1.0) < 0.05:
                break
            strength *= TENSION / peak
        file.write_text(json.dumps({"first": strength, "peak": peak}))
    known = json.loads(file.read_text())
    return float(known["first"] * TENSION / known["peak"])


def cost(model: bd.Model, dt: float) -> float:
    """Element-steps a second of the processor, of the second of two runs, without what a run needs to start."""
    seconds = {}
    for steps in (1, STEPS, 1, STEPS):
        begun = time.process_time()
        bd.solve_explicit(model, duration=steps * dt, dt=dt, every=0)
        seconds[steps] = time.process_time() - begun
    return len(model.lattice.particles) * (STEPS - 1) / (seconds[STEPS] - seconds[1])


def measured(name: str, count: int, seed: int, out: Path) -> dict[str, Any]:
    """All tests of one law on one packing."""
    kind, law, strength = KINDS[name], law_of(name, count), strength_of(name, count, out)
    body, failure = body_of(kind.specimen, count, seed), kind.failure(strength)
    elastic = bd.labtests.static_tension(body, law)
    found: dict[str, Any] = {
        "words": kind.words, "bonds": len(body.pairs), "strength": strength, "E": elastic.E, "nu": elastic.nu,
    }  # fmt: skip
    for test in TESTS:
        one = broken_by(test, body, law, failure, friction=FRICTION)
        found[test] = {
            "peak": one.peak, "broken_at_peak": one.broken[1], "dt": one.run.dt, "residual": one.run.residual,
            "status": one.run.status.value,
        }  # fmt: skip
        _keep(out / f"{name}-{count}-seed{seed}-{test}.npz", body, one)
    model, _ = model_of("ucs", body, law, failure, FRICTION, -1e-6, 1.0)
    implied = model.implied_fracture
    return found | {"toughness": None if implied is None else implied.toughness}


def costs(rows: list[dict[str, Any]], count: int, out: Path) -> dict[str, float]:
    """Element-steps a second of each law on packing 1, one after the other."""
    found = {}
    for row in rows:
        name = row["law"]
        if row["seed"] == 1 and row["count"] == count:
            kind = KINDS[name]
            body, failure = body_of(kind.specimen, count, 1), kind.failure(strength_of(name, count, out))
            model, _ = model_of("ucs", body, law_of(name, count), failure, FRICTION, -1e-6, 1.0)
            found[name] = cost(model, row["ucs"]["dt"])
    return found


def _keep(path: Path, body: bd.Lattice, test: Tested) -> None:
    damage, total = np.zeros((2, len(body.particles)))
    for end in body.pairs.T:
        np.add.at(damage, end, 1.0 - test.run.state.bond_integrity)
        np.add.at(total, end, 1.0)
    np.savez_compressed(
        path, position=body.centre, displacement=test.run.state.displacement, radius=body.particles.radius,
        damage=damage / np.maximum(total, 1.0), curve=test.curve,
    )  # fmt: skip


def measure(
    record: Record, *, laws: tuple[str, ...] = tuple(KINDS), count: int = 1500, seeds: tuple[int, ...] = (1, 2),
) -> None:  # fmt: skip
    """Carry out the tests of all laws, and then measure what a step of each costs, in one go."""
    for seed, name in product(seeds, laws):
        record.add(partial(measured, name, count, seed, record.folder), law=name, count=count, seed=seed)
    rows = record.rows()
    rows.sort(key=lambda one: (list(KINDS).index(one["law"]), one["count"], one["seed"]))
    record.keep(speeds=costs(rows, count, record.folder))


def draw(record: Record, folder: Path) -> None:
    """Packing 1 at the end of each test."""
    names, count = [(name, kind.words) for name, kind in KINDS.items()], record.rows()[0]["count"]
    draw_broken(folder / "laws_side_by_side.png", record.folder, names, count, RADIUS)
