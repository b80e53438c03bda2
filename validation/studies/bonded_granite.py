"""Granite of parallel bonds in the laboratory: E, UCS, Brazilian strength and their ratio, and calibrated strengths.

Part "granite": elasticity of Lac du Bonnet granite (E = 69 GPa, ν = 0.26) by `bd.calibrate` on one packing, bond
strengths scaled so that this packing has the UCS of 200 MPa, five other packings. The criterion is
`bd.PeripheralStress` with equal strengths in tension and shear, as Potyondy and Cundall (2004) have it. Cylinders
have Ø31.7 × 63.4 mm and 600 spheres, and platens a friction of 0.3; discs have Ø31.7 × 16 mm, 500 spheres and flats
of 15°.

Part "unseen": tensile strength and cohesion by `bd.calibrate` to a UCS of 60 MPa and a tensile strength of 8 MPa on
five packings of 250 spheres, Ø6 × 10 mm. Strengths of twenty further packings beside the intervals for one new
packing (95 %). All packings that were tried are kept.
"""

import math
from functools import partial
from typing import Any

import bondem as bd
from validation.frame.record import Record

GRANITE, UCS, SCALE = bd.materials.granite, 200e6, 100e6
FRICTION, FLATS = 0.3, math.radians(15.0)
RADIUS, LENGTH, THICKNESS = 15.85e-3, 63.4e-3, 16e-3
PIN, DISC, SMALL = 600, 500, 250
TARGETS = {"ucs": 60e6, "tension": 8e6}
SEEDS, FITTED, UNSEEN = (1, 2, 3, 4, 5), (1, 2, 3, 4, 5), tuple(range(101, 121))


def criterion(strength: float) -> bd.Criterion:
    """Criterion of bonds of one strength in tension and shear [Pa]."""
    return bd.PeripheralStress(tension=strength, shear=strength)


def packed(shape: bd.Shape, count: int, seed: int) -> bd.Lattice:
    """Dense random packing, bonded where spheres touch."""
    return bd.connect(bd.pack(shape, count=count, seed=seed))


def disc() -> bd.Shape:
    """Disc with flats across y."""
    shape: bd.Shape = bd.Cylinder(radius=RADIUS, length=THICKNESS)
    size, at = (2.0 * THICKNESS, RADIUS, 4.0 * RADIUS), RADIUS * math.cos(FLATS)
    for name, y in (("top", at), ("bottom", -at - RADIUS)):
        shape = shape.cut(bd.Box(size).moved((-0.5 * THICKNESS, y, -2.0 * RADIUS)), name=name)
    return shape


class Granite:
    """Calibrated bonds of the granite, and the strengths with which packing 0 has its UCS."""

    def __init__(self) -> None:
        self.pin = bd.Cylinder(radius=RADIUS, length=LENGTH)
        self.first = packed(self.pin, PIN, 0)
        self.fit = bd.calibrate(self.first, GRANITE, law=bd.ParallelBond)
        self.strength = SCALE * UCS / self.compressed(self.first, SCALE).peak

    def compressed(self, body: bd.Lattice, strength: float) -> bd.labtests.StrengthTest:
        """Compression between platens with friction."""
        return bd.labtests.uniaxial_compression(
            body, self.fit.law, criterion(strength), platen_friction=FRICTION, density=self.fit.density
        )

    def measure(self, seed: int) -> list[dict[str, Any]]:
        """Strengths of a packing."""
        strength = self.strength
        body, given = packed(self.pin, PIN, seed), (self.fit.law, criterion(strength))
        ucs = self.compressed(body, strength)
        split = bd.labtests.brazilian(packed(disc(), DISC, seed), *given, density=self.fit.density)
        torn = bd.labtests.direct_tension(body, *given, density=self.fit.density)
        static = bd.labtests.static_tension(body, self.fit.law)
        return [{
            "bond_strength": strength, "E": static.E, "nu": static.nu, "ucs": ucs.peak, "brazilian": split.peak,
            "direct_tension": torn.peak, "ucs_over_brazilian": ucs.peak / split.peak,
            "ucs_over_tension": ucs.peak / torn.peak,
            "largest_residual": max(ucs.residual, split.test.residual, torn.residual),
        }]  # fmt: skip


class Calibrated:
    """Strengths calibrated on a few packings."""

    def __init__(self) -> None:
        self.shape = bd.Cylinder(radius=3e-3, length=10e-3)
        bodies = [packed(self.shape, SMALL, seed) for seed in FITTED]
        self.fit = bd.calibrate(bodies, GRANITE, law=bd.ParallelBond, **TARGETS)
        assert self.fit.strength is not None
        self.strength = self.fit.strength

    def summary(self) -> list[dict[str, Any]]:
        """Parameters and their intervals."""
        failure = self.fit.failure
        return [{
            "runs": len(self.strength.runs), "message": self.strength.message, "tension": failure.tension,
            "cohesion": failure.cohesion, "tension_95": self.strength.interval("tension"),
            "cohesion_95": self.strength.interval("cohesion"),
            "measured": {name: self.strength.strengths(name).values.tolist() for name in TARGETS},
            "new_packing_95": {name: self.strength.strengths(name).interval(kind="prediction") for name in TARGETS},
        }]  # fmt: skip

    def unseen(self, seed: int) -> list[dict[str, Any]]:
        """Strengths of a packing that did not calibrate, and which of them are within their intervals."""
        given = packed(self.shape, SMALL, seed), self.fit.law, self.fit.failure
        ucs = bd.labtests.uniaxial_compression(*given, density=self.fit.density).peak
        tension = bd.labtests.direct_tension(*given, density=self.fit.density).peak
        within = {}
        for name, value in (("ucs", ucs), ("tension", tension)):
            low, high = self.strength.strengths(name).interval(kind="prediction")
            within[name] = bool(low <= value <= high)
        return [{"ucs": ucs, "tension": tension, "within": within}]


def measure(record: Record) -> None:
    """Measure both parts."""
    fit = Calibrated()
    record.add(fit.summary, "calibrated", packings=len(FITTED), elements=SMALL)
    for seed in UNSEEN:
        record.add(partial(fit.unseen, seed), "unseen", seed=seed)
    granite = Granite()
    for seed in SEEDS:
        record.add(partial(granite.measure, seed), "granite", seed=seed)
