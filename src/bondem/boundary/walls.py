"""Rigid walls that elements touch: planes, cylinders and spheres, fixed, driven, servo-controlled or free."""

from dataclasses import dataclass

import numpy as np

from bondem._checks import instance, number, several, vector
from bondem._tables.columns import WallKind
from bondem._types import Floats, Triple
from bondem.boundary.wall_motions import Driven, Free, Servo, direction
from bondem.errors import InputError


def _point(owner: str, value: object) -> tuple[float, float, float]:
    return vector("", owner, value, advice="three finite coordinates [m]")


def _check_motion(owner: str, motion: object, friction: object) -> None:
    if motion is not None:
        wanted = "bd.Driven(x=schedule), bd.Servo(force, speed=...) or bd.Free(mass), or None"
        instance(owner, "motion", motion, (Driven, Servo, Free), wanted)
    if friction is not None:
        number(owner, "friction", friction, least=0.0, advice="a coefficient of zero or more, or None")


@dataclass(frozen=True)
class PlaneWall:
    """A plane or a disc, with or without a hole; elements are on the side to which its normal points.

    A disc models a piston, and a disc with a hole the plate around it. Elements beside a disc touch its rim.

    Attributes:
        point: a point of the plane, the centre of a disc [m], (3,).
        normal: vector of any length towards the elements, (3,).
        motion: motion of the wall; None for a fixed wall.
        friction: μ against the elements [-]; None for that of the contact law.
        outer: radius of a disc [m]; None for an infinite plane.
        inner: radius of the hole [m].

    Raises:
        InputError: A value is out of range, or the growth of a radius is prescribed.
    """

    point: Triple
    normal: Triple
    motion: Driven | Servo | Free | None = None
    friction: float | None = None
    outer: float | None = None
    inner: float = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "point", _point("PlaneWall: point", self.point))
        object.__setattr__(self, "normal", direction("PlaneWall: normal", self.normal))
        _check_motion("PlaneWall", self.motion, self.friction)
        if isinstance(self.motion, Driven) and any(k == 3 for k, _, _ in self.motion.motion):
            raise InputError("PlaneWall: growth is prescribed, but a plane has no radius; name x, y or z")
        number("PlaneWall", "inner", self.inner, unit="m", least=0.0, advice="the radius of the hole, zero or more")
        if self.outer is not None:
            number("PlaneWall", "outer", self.outer, unit="m", above=self.inner, advice="more than inner, or None")

    @property
    def row(self) -> Floats:
        """Row of the core's table of walls, (9,): point [m], normal, outer radius or 0, kind, inner radius [m]."""
        if self.outer is None and not self.inner:
            return np.array([*self.point, *self.normal, 0.0, WallKind.PLANE_WALL, 0.0])
        outer = np.inf if self.outer is None else self.outer
        return np.array([*self.point, *self.normal, outer, WallKind.DISC_WALL, self.inner])


@dataclass(frozen=True)
class CylinderWall:
    """An infinite cylinder, around the elements or among them.

    Attributes:
        radius: radius [m].
        point: a point of its axis [m], (3,).
        axis: direction of any length, (3,).
        outside: True for elements outside the cylinder (a rod), False for elements inside (a vessel).
        motion: motion of the wall; None for a fixed wall. A servo changes the radius.
        friction: μ against the elements [-]; None for that of the contact law.

    Raises:
        InputError: A value is out of range, or a direction has no length.
    """

    radius: float
    point: Triple = (0.0, 0.0, 0.0)
    axis: Triple = (1.0, 0.0, 0.0)
    outside: bool = False
    motion: Driven | Servo | Free | None = None
    friction: float | None = None

    def __post_init__(self) -> None:
        number("CylinderWall", "radius", self.radius, unit="m", above=0.0, advice="a positive radius")
        object.__setattr__(self, "point", _point("CylinderWall: point", self.point))
        object.__setattr__(self, "axis", direction("CylinderWall: axis", self.axis))
        _check_motion("CylinderWall", self.motion, self.friction)
        instance("CylinderWall", "outside", self.outside, bool, "True or False")

    @property
    def row(self) -> Floats:
        """Row of the core's table of walls, (9,): point of the axis [m], axis, radius [m], kind of the wall, 0."""
        kind = WallKind.CYLINDER_AMONG if self.outside else WallKind.CYLINDER_AROUND
        return np.array([*self.point, *self.axis, self.radius, kind, 0.0])


@dataclass(frozen=True)
class SphereWall:
    """A sphere among the elements, such as an impactor, or around them.

    Attributes:
        radius: radius [m].
        centre: centre [m], (3,).
        inside: True for elements inside the sphere, False for elements outside.
        motion: motion of the wall; None for a fixed wall. A servo changes the radius.
        friction: μ against the elements [-]; None for that of the contact law.

    Raises:
        InputError: A value is out of range.
    """

    radius: float
    centre: Triple = (0.0, 0.0, 0.0)
    inside: bool = False
    motion: Driven | Servo | Free | None = None
    friction: float | None = None

    def __post_init__(self) -> None:
        number("SphereWall", "radius", self.radius, unit="m", above=0.0, advice="a positive radius")
        object.__setattr__(self, "centre", _point("SphereWall: centre", self.centre))
        _check_motion("SphereWall", self.motion, self.friction)
        instance("SphereWall", "inside", self.inside, bool, "True or False")

    @property
    def row(self) -> Floats:
        """Row of the core's table of walls, (9,): centre [m], three zeros, radius [m], kind of the wall, 0."""
        kind = WallKind.SPHERE_AROUND if self.inside else WallKind.SPHERE_AMONG
        return np.array([*self.centre, 0.0, 0.0, 0.0, self.radius, kind, 0.0])


Wall = PlaneWall | CylinderWall | SphereWall


def pivot(wall: Wall) -> Triple:
    """Return the point about which a wall turns in the reference [m]: its point or centre, or `about` if driven."""
    if isinstance(wall.motion, Driven) and wall.motion.turns:
        return wall.motion.about
    return wall.centre if isinstance(wall, SphereWall) else wall.point


def check_walls(walls: object) -> tuple[Wall, ...]:
    """Return one wall or several as a tuple; raise InputError if a value is not a wall, or is given twice."""
    kinds = PlaneWall, CylinderWall, SphereWall
    found = several("Model", "walls", walls, kinds, "bd.PlaneWall, bd.CylinderWall and bd.SphereWall")
    for k, wall in enumerate(found):
        if (first := found.index(wall)) < k:
            raise InputError(f"walls[{k}] is walls[{first}] again, and would double its forces; leave one out")
    return found
