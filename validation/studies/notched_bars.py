"""K_Ic of all laws side by side, measured: a round bar with a ring notch, pulled until it breaks.

The laws, criteria and rig of laws_side_by_side.py; the bar is the cylinder Ø100 × 200 mm with a slot one element wide
in its middle, which leaves a ligament of radius b = 30 mm. With the largest load P, s = b / R,

    K = P / (π b²) √(π b) G(s),   G = ½ √(1 - s) (1 + s/2 + 3 s²/8 - 0.363 s³ + 0.731 s⁴)

(Tada, Paris and Irwin 1973; 1 % for any s). It is K_Ic where the bar breaks as linear fracture mechanics has it: of a
law that breaks at once the process zone is an element or so, and K_Ic is what strength and size of elements make of
it. Of cells with a fracture energy the process zone E G_f / f_t², 0.25 m, is longer than the bar: what comes out is
below √(E G_f), and must be. Strengths are those with which packing 1 of the cylinder without a notch bears 4 MPa at
this number of elements; what `bd.explain` says that they imply stands beside.
"""

import math
from functools import cache, partial
from itertools import product
from pathlib import Path
from typing import Any

import bondem as bd
from validation.frame.record import Record
from validation.measures.platens import LENGTH, RADIUS, broken_by, model_of
from validation.studies.laws_side_by_side import FRICTION, KINDS, REACH, law_of, strength_of

LIGAMENT = 30e-3


def bar(count: int) -> bd.Shape:
    """The notched bar, its slot as wide as an element."""
    wide = (math.pi * RADIUS**2 * LENGTH / count) ** (1.0 / 3.0)
    ring = bd.Cylinder(radius=2.0 * RADIUS, length=wide).cut(bd.Cylinder(radius=LIGAMENT, length=wide))
    return bd.Cylinder(radius=RADIUS, length=LENGTH).cut(ring.moved((0.5 * (LENGTH - wide), 0.0, 0.0)), name="notch")


@cache
def notched(specimen: str, count: int, seed: int) -> bd.Lattice:
    """The bar, packed and bonded as the cylinder of the same specimen is."""
    if specimen == "cells":
        return bd.connect(bd.pack(bar(count), count=count, method="even", seed=seed), method="laguerre")
    particles = bd.pack(bar(count), count=count, seed=seed)
    return bd.connect(particles, reach=REACH) if specimen == "gaps" else bd.connect(particles)


def intensity(stress: float) -> float:
    """K at a stress over the whole section [Pa √m]."""
    s = LIGAMENT / RADIUS
    shape = 0.5 * math.sqrt(1.0 - s) * (1.0 + 0.5 * s + 0.375 * s**2 - 0.363 * s**3 + 0.731 * s**4)
    return stress / s**2 * math.sqrt(math.pi * LIGAMENT) * shape


def measured(name: str, count: int, seed: int, out: Path) -> dict[str, Any]:
    """The test of one law on one packing."""
    kind, law = KINDS[name], law_of(name, count)
    strength = strength_of(name, count, out)
    body, failure = notched(kind.specimen, count, seed), kind.failure(strength)
    test = broken_by("tension", body, law, failure, friction=FRICTION)
    model, _ = model_of("tension", body, law, failure, FRICTION, 1e-6, 1.0)
    implied = model.implied_fracture
    return {
        "words": kind.words, "bonds": len(body.pairs), "strength": strength, "peak": test.peak,
        "K": intensity(test.peak), "implied": None if implied is None else implied.toughness,
        "broken_at_peak": test.broken[1],
    }  # fmt: skip


def measure(
    record: Record, *, laws: tuple[str, ...] = tuple(KINDS), count: int = 12_000, seeds: tuple[int, ...] = (1, 2),
) -> None:  # fmt: skip
    """Pull notched bars of all laws."""
    for seed, name in product(seeds, laws):
        record.add(partial(measured, name, count, seed, record.folder), law=name, count=count, seed=seed)
    record.rows().sort(key=lambda one: (list(KINDS).index(one["law"]), one["count"], one["seed"]))
    record.keep()
