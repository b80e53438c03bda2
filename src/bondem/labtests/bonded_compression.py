"""Compression of bonded spheres along x, with or without confining walls, and tension along x."""

import math
from functools import partial

import numpy as np

from bondem.boundary.gauges import Gauge, StrainGauge
from bondem.boundary.schedules import Ramp
from bondem.boundary.wall_motions import Servo
from bondem.boundary.walls import CylinderWall, PlaneWall, Wall
from bondem.errors import InputError
from bondem.geometry.elementary_shapes import BoundingBox, Box, Cylinder
from bondem.labtests.bonded_platens import LEAST, REACH, RECORDS, BondedSpecimen, Side
from bondem.labtests.gauge_length import middle_half
from bondem.labtests.quasi_static_rig import Rig, RunOptions, StrengthTest
from bondem.model.model import Model
from bondem.specimen.regions import Index

# Assumed rise of the axial strength with the confining pressure, (1 + sin φ) / (1 - sin φ) at φ = 30° [-]. It sets
# the speed and the limit of the motion.
_CONFINED = 3.0
# Largest speed of confining walls over that of the platens [-].
_FOLLOWS = 20.0
# Share of the peak at which a torn specimen has lost its load [-].
_TORN = 0.1


def compress_bonded(
    specimen: BondedSpecimen, *, pressure: float, friction: float, reach: float | None, options: RunOptions
) -> StrengthTest:
    """Compress bonded spheres along x between a fixed platen and one that approaches it.

    The platens have a coefficient of `friction` [-], and the sides a confining `pressure` [Pa]. `reach` is the
    largest motion over that at the expected peak [-]; None for 20. Raises InputError for a pressure on a shape that
    walls cannot confine, and for friction with the non-local law on cells.
    """
    lower, upper = specimen.bounds
    length, section = float(upper[0] - lower[0]), specimen.lattice.particles.envelope.section()
    specimen.require_smooth(friction)
    below, above = (
        Side(specimen.layer(0, side), share, partial(specimen.platen, 0, side, friction))
        for side, share in ((-1.0, 0.0), (1.0, 1.0))
    )
    compliance, force = specimen.response(0, below.elements, above.elements, section, 0.0, -1.0)
    expected = force / section + _CONFINED * pressure
    way = compliance * expected * section

    def around(speed: float, begin: float) -> tuple[Wall, ...]:
        return _confining(specimen, pressure, _FOLLOWS * abs(speed), begin)

    near, far, model = specimen.sides(0, (below,), (above,), around)
    rig = Rig(
        axis=0, sign=-1.0, near=near, far=far, section=section, torn=section, length=length, size=length,
        expected=expected, way=way, reach=(REACH if reach is None else reach) * way, ending=0.5, traverses=math.nan,
        model=model, gauge=StrainGauge(Index(middle_half(specimen.lattice))),
        strain=lambda strains: -strains[:, 0], least=LEAST, records=RECORDS,
    )  # fmt: skip
    return specimen.load(rig, options)


def tear_bonded(specimen: BondedSpecimen, options: RunOptions) -> StrengthTest:
    """Pull one end layer of bonded spheres along x away from the other, until the load is a tenth of its peak."""
    lower, upper = specimen.bounds
    section = specimen.lattice.particles.envelope.section()
    near, far = specimen.layer(0, -1.0), specimen.layer(0, 1.0)
    place = specimen.lattice.centre[:, 0]
    length = float(place[far].mean() - place[near].mean())
    compliance, force = specimen.response(0, near, far, section, 1.0, 0.0)

    def pulled(speed: float, begin: float) -> Model:
        return specimen.driven(0, ((near, 0.0), (far, speed)), begin)

    rig = Rig(
        axis=0, sign=1.0, near=(Gauge(Index(near), "force"),), far=(Gauge(Index(far), "force"),), section=section,
        torn=section, length=length, size=float(upper[0] - lower[0]), expected=force / section,
        way=compliance * force, reach=REACH * compliance * force, ending=_TORN, traverses=math.nan, model=pulled,
        gauge=StrainGauge(Index(middle_half(specimen.lattice))), least=LEAST, records=RECORDS,
    )  # fmt: skip
    return specimen.load(rig, options)


def _confining(specimen: BondedSpecimen, pressure: float, speed: float, begin: float) -> tuple[Wall, ...]:
    """Create smooth walls for a confining pressure [Pa], none for 0: a servo cylinder, or fixed and servo planes.

    Raises:
        InputError: the specimen is neither a cylinder nor a box.
    """
    if not pressure > 0.0:
        return ()
    shape, (lower, upper) = specimen.lattice.particles.envelope, specimen.bounds
    length, width, height = (float(edge) for edge in upper - lower)
    middle = 0.5 * (lower + upper)
    x, y, z = middle.tolist()

    def servo(area: float) -> Servo:
        return Servo(Ramp(0.0, pressure * area, begin), speed=speed)

    if isinstance(shape, Cylinder):
        away = np.hypot(*(specimen.lattice.centre - middle)[:, 1:].T) + specimen.bare.contact_radius
        radius = float(away[specimen.lattice.connected].max())
        around = servo(math.pi * width * length)
        return (CylinderWall(radius, (x, y, z), (1.0, 0.0, 0.0), motion=around, friction=0.0),)
    if not isinstance(shape, Box | BoundingBox):
        raise InputError(
            f"labtests.{specimen.test}: a {type(shape).__name__} has no sides that plane or cylindrical walls can"
            " confine; pack a bd.Cylinder or a bd.Box"
        )
    found: list[Wall] = []
    for axis, area in ((1, length * height), (2, length * width)):
        fixed, pressed = (specimen.platen(axis, side, 0.0, 0.0, begin) for side in (-1.0, 1.0))
        found += [fixed, PlaneWall(pressed.point, pressed.normal, servo(area), 0.0)]
    return tuple(found)
