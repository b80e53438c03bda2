"""Rigid walls that elements touch: planes, cylinders and spheres, fixed, driven, servo-controlled or free."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from bondem._checks import instance, number, several, vector
from bondem._types import Floats, Ints, Triple
from bondem.boundary.schedules import Schedule, as_schedule
from bondem.errors import InputError

# Kinds of walls, column 7 of `WallTable.shape`.
PLANE, INSIDE, OUTSIDE, SHELL, BALL, DISC = range(6)
_COMPONENTS = ("x", "y", "z", "growth")


@dataclass(frozen=True, init=False)
class Driven:
    """Prescribed motion of a wall, such as `Driven(x=bd.Ramp(0, -1e-4, 1e-3))`. Other components are held at rest.

    Attributes:
        motion: triples of component 0 … 3, schedule, and True for a velocity.

    Args:
        x, y, z: displacements [m].
        growth: change of a cylinder's radius [m].
        vx, vy, vz, vgrowth: velocities [m/s].
    """

    motion: tuple[tuple[int, Schedule, bool], ...]

    def __init__(self, **components: float | Schedule) -> None:
        names = {name: (k, False) for k, name in enumerate(_COMPONENTS)}
        names |= {"v" + name: (k, True) for k, name in enumerate(_COMPONENTS)}
        unknown = sorted(set(components) - set(names))
        if unknown:
            raise InputError(f"Driven: unknown component '{unknown[0]}'; choose from {', '.join(names)}")
        motion = tuple(
            (names[key][0], as_schedule("Driven", key, value), names[key][1]) for key, value in components.items()
        )
        if not motion or len({k for k, _, _ in motion}) < len(motion):
            raise InputError("Driven: name each component once, as a displacement or as a velocity")
        object.__setattr__(self, "motion", motion)


@dataclass(frozen=True, init=False)
class Servo:
    """A platen pushed along its normal by a prescribed force, against the force of the elements.

    Many codes move a platen without mass in proportion to the missing force; that is unstable where grains are little
    damped. This platen has a mass: it follows fast flow and its energy is accounted for. Local damping brings it to
    rest: a share of the missing force resists its motion, so that an oscillation about the prescribed force loses the
    factor √((1 - damping) / (1 + damping)) of its amplitude every half period, 0.42 by default.

    Attributes:
        force: sum of the normal forces on the wall [N], a number or a schedule; for a pressure, multiply by the area.
        speed: largest speed [m/s].
        mass: mass of the platen [kg]; None for the mass of all elements together.
        damping: share of the missing force that resists the motion [-], in [0, 1).
    """

    force: Schedule
    speed: float
    mass: float | None
    damping: float

    def __init__(
        self, force: float | Schedule, *, speed: float, mass: float | None = None, damping: float = 0.7
    ) -> None:
        schedule = as_schedule("Servo", "force", force)
        if not min(schedule.table[1]) >= 0.0:
            raise InputError("Servo: force must be zero or more [N]; elements can only press on a wall")
        number("Servo", "speed", speed, unit="m/s", above=0.0, advice="the largest speed of the wall, positive")
        if mass is not None:
            number("Servo", "mass", mass, unit="kg", above=0.0, advice="the positive mass of the platen, or None")
        object.__setattr__(self, "force", schedule)
        object.__setattr__(self, "mass", mass)
        share = number("Servo", "damping", damping, least=0.0, below=1.0, advice="a share in [0, 1)")
        object.__setattr__(self, "speed", float(speed))
        object.__setattr__(self, "damping", share)


@dataclass(frozen=True)
class Free:
    """A rigid body pushed by elements, without rotation: an impactor, a dropped weight or a flyer plate.

    The energy ledger counts the work of the body on the elements as "work", and not the kinetic energy ½ m v² of the
    body; `bd.WallGauge(..., "velocity")` records v. In a later stage the body continues at its velocity.

    Attributes:
        mass: mass of the body [kg].
        velocity: initial velocity [m/s], (3,).
        force: force on the body besides that of the elements, such as its weight [N], (3,).

    Raises:
        InputError: The mass is not positive, or a vector is not three finite numbers.
    """

    mass: float
    velocity: Triple = (0.0, 0.0, 0.0)
    force: Triple = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        number("Free", "mass", self.mass, unit="kg", above=0.0, advice="the positive mass of the body in kg")
        for name, unit in (("velocity", "m/s"), ("force", "N")):
            given = vector("Free", name, getattr(self, name), advice=f"three finite components [{unit}]")
            object.__setattr__(self, name, given)


def _direction(owner: str, value: object) -> tuple[float, float, float]:
    wanted = "three finite components, not all zero"
    components = np.array(vector("", owner, value, advice=wanted))
    size = np.linalg.norm(components)
    if not size > 0.0:
        raise InputError(f"{owner} = {value}; give {wanted}")
    x, y, z = (components / size).tolist()
    return x, y, z


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
    """A plane, infinite or a disc, with or without a hole; elements are on the side its normal points to.

    A disc models a piston, and a disc with a hole the plate around it. Elements beside a disc touch its rim.

    Attributes:
        point: a point of the plane, the centre of a disc [m], (3,).
        normal: vector of any length towards the elements, (3,).
        motion: motion of the wall; None for a fixed wall.
        friction: μ against the elements [-]; None for that of the contact law.
        outer: radius of a disc [m]; None for an infinite plane.
        inner: radius of its hole [m].
    """

    point: Triple
    normal: Triple
    motion: Driven | Servo | Free | None = None
    friction: float | None = None
    outer: float | None = None
    inner: float = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "point", _point("PlaneWall: point", self.point))
        object.__setattr__(self, "normal", _direction("PlaneWall: normal", self.normal))
        _check_motion("PlaneWall", self.motion, self.friction)
        if isinstance(self.motion, Driven) and any(k == 3 for k, _, _ in self.motion.motion):
            raise InputError("PlaneWall: growth is prescribed, but a plane has no radius; name x, y or z")
        number("PlaneWall", "inner", self.inner, unit="m", least=0.0, advice="the radius of the hole, zero or more")
        if self.outer is not None:
            number("PlaneWall", "outer", self.outer, unit="m", above=self.inner, advice="more than inner, or None")

    @property
    def row(self) -> Floats:
        """Row of the table of walls that the compiled core reads, (9,).

        It holds the point [m], the normal, the outer radius [m], the kind of the wall and the inner radius [m].
        """
        if self.outer is None and not self.inner:
            return np.array([*self.point, *self.normal, 0.0, PLANE, 0.0])
        outer = np.inf if self.outer is None else self.outer
        return np.array([*self.point, *self.normal, outer, DISC, self.inner])


@dataclass(frozen=True)
class CylinderWall:
    """An infinite cylinder, around the elements or among them.

    Attributes:
        radius: radius [m].
        point: a point of its axis [m], (3,).
        axis: direction of any length, (3,).
        outside: True for elements outside of it (a rod), False for elements inside (a vessel).
        motion: motion of the wall; None for a fixed wall. A servo changes the radius.
        friction: μ against the elements [-]; None for that of the contact law.
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
        object.__setattr__(self, "axis", _direction("CylinderWall: axis", self.axis))
        _check_motion("CylinderWall", self.motion, self.friction)
        instance("CylinderWall", "outside", self.outside, bool, "True or False")

    @property
    def row(self) -> Floats:
        """Row of the table of walls that the compiled core reads, (9,).

        It holds a point of the axis [m], the axis, the radius [m], the kind of the wall and a zero.
        """
        return np.array([*self.point, *self.axis, self.radius, OUTSIDE if self.outside else INSIDE, 0.0])


@dataclass(frozen=True)
class SphereWall:
    """A sphere among the elements, such as an impactor, or around them.

    Attributes:
        radius: radius [m].
        centre: centre [m], (3,).
        inside: True for elements inside of it.
        motion: motion of the wall; None for a fixed wall. A servo changes the radius.
        friction: μ against the elements [-]; None for that of the contact law.
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
        """Row of the table of walls that the compiled core reads, (9,).

        It holds the centre [m], three zeros, the radius [m], the kind of the wall and a zero.
        """
        return np.array([*self.centre, 0.0, 0.0, 0.0, self.radius, SHELL if self.inside else BALL, 0.0])


Wall = PlaneWall | CylinderWall | SphereWall


def check_walls(walls: object) -> tuple[Wall, ...]:
    """Return walls as a tuple.

    Raises:
        InputError: A value is not a wall.
    """
    kinds = PlaneWall, CylinderWall, SphereWall
    return several("Model", "walls", walls, kinds, "bd.PlaneWall, bd.CylinderWall and bd.SphereWall")


@dataclass(frozen=True, eq=False)
class WallTable:
    """Walls in the form of the core.

    Attributes:
        shape: point, normal or axis, radius, kind, radius of a hole; shape (w, 9).
        friction: μ, (w,).
        start, times, values: schedules one after the other.
        drive_wall, drive_component, drive_schedule, drive_rate: prescribed motions, (d,).
        servo_wall, servo_schedule, servo_speed, servo_mass, servo_damping: servo-controlled walls, (s,).
        free_wall, free_mass, free_force: free walls, (f,) and (f, 3).
    """

    shape: Floats
    friction: Floats
    start: Ints
    times: Floats
    values: Floats
    drive_wall: Ints
    drive_component: Ints
    drive_schedule: Ints
    drive_rate: np.ndarray
    servo_wall: Ints
    servo_schedule: Ints
    servo_speed: Floats
    servo_mass: Floats
    servo_damping: Floats
    free_wall: Ints
    free_mass: Floats
    free_force: Floats

    @property
    def platens(self) -> Floats:
        """Masses of the walls moved by a force [kg], (s + f,)."""
        return np.concatenate([self.servo_mass, self.free_mass])

    @classmethod
    def of(cls, walls: Sequence[Wall], friction: float, elements: float, origin: Floats) -> "WallTable":
        """Return the walls of a model, given the `friction` of its contact law and the total mass `elements` [kg].

        Their places are relative to `origin` [m], (3,), as those of the elements are.
        """
        tables: list[tuple[Floats, Floats]] = []
        drives: list[tuple[int, int, int, bool]] = []
        servos: list[tuple[int, int, float, float, float]] = []
        for k, wall in enumerate(walls):
            match wall.motion:
                case Driven(motion=motion):
                    for component, schedule, rate in motion:
                        drives.append((k, component, len(tables), rate))
                        tables.append(schedule.table)
                case Servo(force=force, speed=speed, mass=mass, damping=damping):
                    servos.append((k, len(tables), speed, elements if mass is None else mass, damping))
                    tables.append(force.table)
        free = [(k, wall.motion) for k, wall in enumerate(walls) if isinstance(wall.motion, Free)]
        lengths = [len(times) for times, _ in tables]
        drive = np.array(drives, dtype=np.int64).reshape(-1, 4)
        return cls(
            shape=_from(np.array([wall.row for wall in walls]).reshape(-1, 9), origin),
            friction=np.array([friction if wall.friction is None else wall.friction for wall in walls], dtype=float),
            start=np.concatenate([[0], np.cumsum(lengths)]).astype(np.int64),
            times=np.concatenate([np.zeros(0), *(times for times, _ in tables)]),
            values=np.concatenate([np.zeros(0), *(values for _, values in tables)]),
            drive_wall=drive[:, 0].copy(),
            drive_component=drive[:, 1].copy(),
            drive_schedule=drive[:, 2].copy(),
            drive_rate=drive[:, 3].astype(np.uint8),
            servo_wall=np.array([k for k, *_ in servos], dtype=np.int64),
            servo_schedule=np.array([s for _, s, *_ in servos], dtype=np.int64),
            servo_speed=np.array([v for *_, v, _, _ in servos], dtype=float),
            servo_mass=np.array([m for *_, m, _ in servos], dtype=float),
            servo_damping=np.array([share for *_, share in servos], dtype=float),
            free_wall=np.array([k for k, _ in free], dtype=np.int64),
            free_mass=np.array([body.mass for _, body in free], dtype=float),
            free_force=np.array([body.force for _, body in free], dtype=float).reshape(-1, 3),
        )


def _from(shape: Floats, origin: Floats) -> Floats:
    """Return the shapes of walls relative to another origin; the point of a plane becomes the one nearest to it."""
    if not origin.any():
        return shape
    point = shape[:, :3] - origin
    plane = shape[:, 7] == PLANE  # the column of kinds
    normal = shape[plane, 3:6]
    point[plane] = normal * (point[plane] * normal).sum(axis=1, keepdims=True)
    return np.hstack([point, shape[:, 3:]])
