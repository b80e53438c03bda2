"""Bonded spheres in three-point bending between rigid rollers."""

import math
from dataclasses import dataclass
from functools import partial

import numpy as np

from bondem._types import Floats, Mask
from bondem.boundary.gauges import AnyGauge, Gauge
from bondem.boundary.schedules import Ramp
from bondem.boundary.wall_motions import Driven
from bondem.boundary.walls import CylinderWall
from bondem.labtests.bonded_platens import LEAST, REACH, RECORDS, BondedSpecimen, Side
from bondem.labtests.quasi_static_rig import Rig, RunOptions, StrengthTest, initial_slope
from bondem.specimen.regions import Index

# Radius of the rollers over the depth of the beam, and its lower limit in mean radii.
_ROLLER, _RADII = 0.25, 3.0
# Lower limits of half the width of the layers whose motion is the deflection, in mean radii and over the depth.
_HALF, _SHARE = 1.5, 0.05


@dataclass(frozen=True, eq=False)
class BentBonds:
    """Result of a bending test of bonded spheres.

    Attributes:
        test: result of the test to failure.
        load: load P of each record [N], (k,).
        deflection: deflection of each record [m], (k,).
        stiffness: slope of the load over the deflection, from 0.1 to 0.5 of the peak [N/m]; NaN for too few records.
    """

    test: StrengthTest
    load: Floats
    deflection: Floats
    stiffness: float


def bend_bonded(
    specimen: BondedSpecimen, *, span: float, ligament: float, friction: float, ending: float, options: RunOptions
) -> BentBonds:
    """Bend a beam of bonded spheres between a moving rod above mid-span and two fixed rods below, all along z.

    For the non-local law on cells, driven layers of cells replace the rods, and friction raises InputError.

    Args:
        specimen: the beam.
        span: distance of the supports [m].
        ligament: height of the section at mid-span [m].
        friction: coefficient of friction of the rollers [-].
        ending: share of the peak load at which the test ends [-].
        options: options of the test.
    """
    lower, upper = specimen.bounds
    length, depth, width = (float(edge) for edge in upper - lower)
    x = 0.5 * float(lower[0] + upper[0])
    supports = (x - 0.5 * span, x + 0.5 * span)
    mean = float(specimen.bare.contact_radius.mean())
    half = max(_SHARE * depth, _HALF * mean)
    place = specimen.lattice.centre

    def about(at: float, y: float | None = None) -> Mask:
        chosen = (np.abs(place[:, 0] - at) < half) & specimen.lattice.connected
        return chosen if y is None else chosen & (np.abs(place[:, 1] - y) < half)

    radius = max(_ROLLER * depth, _RADII * mean)
    specimen.require_smooth(friction)
    top = Side(specimen.layer(1, 1.0, where=about(x)), 1.0, partial(_roller, specimen, x, 1.0, radius, friction))
    left, right = (
        Side(specimen.layer(1, -1.0, where=about(at)), 0.0, partial(_roller, specimen, at, -1.0, radius, friction))
        for at in supports
    )
    section = width * ligament**2 / (1.5 * span)
    below = np.concatenate([left.elements, right.elements])
    compliance, force = specimen.response(1, below, top.elements, section, 1.0, -1.0)
    near, far, model = specimen.sides(1, (left, right), (top,))
    middle = 0.5 * float(lower[1] + upper[1])
    inside = float(upper[1]) - 0.5 * ligament
    measured: dict[str, AnyGauge] = {
        name: Gauge(Index(np.flatnonzero(about(at, y))), "displacement")
        for name, at, y in (("left", supports[0], middle), ("right", supports[1], middle), ("middle", x, inside))
    }

    rig = Rig(
        axis=1, sign=-1.0, near=near, far=far, section=section, torn=width * ligament, length=span, size=length,
        expected=force / section, way=compliance * force, reach=REACH * compliance * force, ending=ending,
        traverses=math.nan, model=model, more=measured, least=LEAST, records=RECORDS,
    )  # fmt: skip
    test = specimen.load(rig, options)
    history = test.run.history
    load = test.curve[:, 1] * section
    deflection = (0.5 * (history["left"] + history["right"]) - history["middle"])[:, 1]
    return BentBonds(test, load, deflection, initial_slope(deflection, load))


def _roller(
    specimen: BondedSpecimen, at: float, side: float, radius: float, friction: float, speed: float, begin: float
) -> CylinderWall:
    """Create a rod along z at x = `at` [m] that touches the beam from above (side 1) or below (-1).

    The rod moves along y at `speed` [m/s], which it reaches at the time `begin` [s].
    """
    lower, upper = specimen.bounds
    reach = specimen.bare.contact_radius + radius
    away = specimen.lattice.centre[:, 0] - at
    near = (np.abs(away) < reach) & specimen.lattice.connected
    height = side * specimen.lattice.centre[near, 1] + np.sqrt(reach[near] ** 2 - away[near] ** 2)
    z = 0.5 * float(lower[2] + upper[2])
    centre = (at, side * float(height.max()), z)
    motion = Driven(vy=Ramp(0.0, speed, begin)) if speed else None
    return CylinderWall(radius, centre, (0.0, 0.0, 1.0), outside=True, motion=motion, friction=friction)
