"""Kinds of bodies whose steps are timed, all on the elements of one periodic packing.

Beams join spheres that touch, and cells fill the periodic cell. Bodies in pieces are timed after some steps in which
they fail. Intact bodies with a criterion have strengths that no load reaches.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

import bondem as bd

BEAM = bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.71)
CELL = bd.CellBond(E=72.5e9, nu=0.17)
TOUCH = bd.LinearContact(E=70e9, friction=0.4)
#: Strength that no load reaches, and strength of bodies that break to pieces [Pa].
SAFE, WEAK = 1e15, 50e6
MOHR = {"friction_angle": 0.6}


@dataclass(frozen=True)
class Kind:
    """Kind of body: its model and its initial motion.

    Attributes:
        model: function that returns the model for a lattice of touching spheres.
        speed: standard deviation of each component of the velocity at the start [m/s].
        share: time step over the critical one [-].
        before: number of steps before those that are timed.
    """

    model: Callable[[bd.Lattice], bd.Model]
    speed: float = 1.0
    share: float = 0.5
    before: int = 0


def beams(lattice: bd.Lattice, failure: bd.Criterion | None = None, *, touch: bool = False) -> bd.Model:
    """Return a model of equal beams, with a criterion and contact if given."""
    return bd.Model(lattice, BEAM, density=2500.0, failure=failure, contact=TOUCH if touch else None)


def cells(
    lattice: bd.Lattice, failure: bd.Criterion | None = None, *, touch: bool = False,
    law: bd.CellBond | bd.NonLocal = CELL,
) -> bd.Model:  # fmt: skip
    """Return a model of cells by `law`, with a criterion and contact if given."""
    body = bd.connect(lattice.particles, method="laguerre")
    return bd.Model(body, law, density=2500.0, failure=failure, contact=TOUCH if touch else None)


def grains(lattice: bd.Lattice) -> bd.Model:
    """Return a model of spheres that touch, without bonds."""
    return bd.Model(bd.Lattice(lattice.particles, lattice.pairs[:0]), None, density=2500.0, contact=TOUCH)


def laid(lattice: bd.Lattice) -> bd.Model:
    """Return a model of as many equal spheres side by side on a plane, each pressed into it by 1e-3 of its radius."""
    count, r = len(lattice.particles), float(lattice.particles.radius.mean())
    across = math.ceil(math.sqrt(count))
    column, row = np.divmod(np.arange(count), across)
    centre = np.column_stack([2.2 * r * column, 2.2 * r * row, np.full(count, 0.999 * r)])
    spheres = bd.Particles(centre, np.full(count, r))
    pressed = bd.Load(bd.Everything(), force=(0.0, 0.0, -count * np.pi * TOUCH.E * r * 1e-3 * r))
    return bd.Model(
        bd.Lattice(spheres, lattice.pairs[:0]), None, density=2500.0, contact=TOUCH, boundary=[pressed],
        walls=[bd.PlaneWall(point=(0.0, 0.0, 0.0), normal=(0.0, 0.0, 1.0))],
    )  # fmt: skip


def _cohesive(strength: float, energy: float | None = None) -> bd.MohrCoulomb:
    return bd.MohrCoulomb(tension=strength, cohesion=3.0 * strength, fracture_energy=energy, **MOHR)


def _fibres(strength: float, energy: float | None = None) -> bd.PeripheralStress:
    return bd.PeripheralStress(tension=strength, shear=strength, fracture_energy=energy)


KINDS = {
    "beams": Kind(beams, share=0.9),
    "beams, contact": Kind(lambda lattice: beams(lattice, touch=True)),
    "beams, may break": Kind(lambda lattice: beams(lattice, _fibres(SAFE)), share=0.9),
    "beams, in pieces": Kind(lambda lattice: beams(lattice, _fibres(265e6), touch=True), speed=2.0, before=200),
    "beams, softening": Kind(lambda lattice: beams(lattice, _fibres(265e6, 2e4)), speed=5.0, before=200),
    "grains": Kind(grains),
    "grains on a plane": Kind(laid, speed=0.0),
    "cells": Kind(cells, share=0.9),
    "cells, contact": Kind(lambda lattice: cells(lattice, touch=True)),
    "cells, may break": Kind(lambda lattice: cells(lattice, _cohesive(SAFE)), share=0.9),
    "cells, may soften": Kind(lambda lattice: cells(lattice, _cohesive(SAFE, 1e18)), share=0.9),
    "cells, softening": Kind(
        lambda lattice: cells(lattice, _cohesive(WEAK, 50.0), touch=True), speed=5.0, before=300
    ),
    "non-local": Kind(lambda lattice: cells(lattice, law=bd.NonLocal(E=72.5e9, nu=0.17))),
}  # fmt: skip
