"""Walls: rigid planes, cylinders and spheres that elements touch, held, driven, servo-controlled or free."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from bondem._checks import instance, number, several, vector
from bondem._types import Floats, Ints
from bondem.errors import InputError
from bondem.model.schedules import Schedule, as_schedule

# What a row of `WallTable.shape` ends with.
PLANE, INSIDE, OUTSIDE, SHELL, BALL, DISC = range(6)
_COMPONENTS = ("x", "y", "z", "growth")


@dataclass(frozen=True, init=False)
class Driven:
    """Prescribed motion of a wall; what is not named rests. `Driven(x=bd.Ramp(0, -1e-4, 1e-3))`.

    Attributes:
        motion: (component 0 … 3, schedule, whether it is a velocity) triples.

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
    """A free platen: a wall pushed along its normal by a given force, against that of the elements.

    A platen without mass, moved in proportion to the missing force as many codes do it, is unstable wherever grains
    are little damped; one with mass follows fast flow and its energy is accounted for. It swings a little.

    Attributes:
        force: sum of the normal forces on the wall [N], a number or a schedule; for a pressure, times the area.
        speed: most it moves [m/s].
        mass: of the platen [kg]; None for that of all elements together.
    """

    force: Schedule
    speed: float
    mass: float | None

    def __init__(self, force: float | Schedule, *, speed: float, mass: float | None = None) -> None:
        schedule = as_schedule("Servo", "force", force)
        if not min(schedule.table[1]) >= 0.0:
            raise InputError("Servo: force must be zero or more [N]; elements can only press on a wall")
        number("Servo", "speed", speed, unit="m/s", above=0.0, advice="the largest speed of the wall, positive")
        if mass is not None:
            number("Servo", "mass", mass, unit="kg", above=0.0, advice="the positive mass of the platen, or None")
        object.__setattr__(self, "force", schedule)
        object.__setattr__(self, "mass", mass)
        object.__setattr__(self, "speed", float(speed))


@dataclass(frozen=True)
class Free:
    """A rigid body that moves as elements push it, without turning: an impactor, a dropped weight, a flyer plate.

    It is outside of the ledger of energies: what it gives to the elements is "work", what it has left is ½ m v² of
    its `bd.WallGauge(..., "velocity")`. In a later stage it goes on as fast as it was.

    Attributes:
        mass: [kg].
        velocity: at first [m/s], (3,).
        force: on it, beside that of the elements, such as its weight [N], (3,).

    Raises:
        InputError: a mass that is not positive, or what are not three numbers.
    """

    mass: float
    velocity: tuple[float, float, float] = (0.0, 0.0, 0.0)
    force: tuple[float, float, float] = (0.0, 0.0, 0.0)

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
    """A plane, infinite or a disc, with a hole or without; elements are on the side its normal points to.

    A disc is a piston, one with a hole the plate around it; elements beside it touch its rim.

    Attributes:
        point: a point of it, the centre of a disc [m], (3,).
        normal: towards the elements, of any length, (3,).
        motion: how it moves; None stands still.
        friction: μ against the elements [-]; None for that of the contact law.
        outer: radius of a disc [m]; None for an infinite plane.
        inner: radius of its hole [m].
    """

    point: tuple[float, float, float]
    normal: tuple[float, float, float]
    motion: Driven | Servo | Free | None = None
    friction: float | None = None
    outer: float | None = None
    inner: float = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "point", _point("PlaneWall: point", self.point))
        object.__setattr__(self, "normal", _direction("PlaneWall: normal", self.normal))
        _check_motion("PlaneWall", self.motion, self.friction)
        if isinstance(self.motion, Driven) and any(k == 3 for k, _, _ in self.motion.motion):
            raise InputError("PlaneWall: a plane has no radius to grow; name x, y or z")
        number("PlaneWall", "inner", self.inner, unit="m", least=0.0, advice="the radius of the hole, zero or more")
        if self.outer is not None:
            number("PlaneWall", "outer", self.outer, unit="m", above=self.inner, advice="more than inner, or None")

    @property
    def row(self) -> Floats:
        """Point, normal, outer radius, its kind and inner radius, (9,)."""
        if self.outer is None and not self.inner:
            return np.array([*self.point, *self.normal, 0.0, PLANE, 0.0])
        outer = np.inf if self.outer is None else self.outer
        return np.array([*self.point, *self.normal, outer, DISC, self.inner])


@dataclass(frozen=True)
class CylinderWall:
    """An infinite cylinder, around the elements or among them.

    Attributes:
        radius: [m].
        point: a point of its axis [m], (3,).
        axis: direction, of any length, (3,).
        outside: whether the elements are outside of it (a rod), not inside (a vessel).
        motion: how it moves; None stands still. A servo changes the radius.
        friction: μ against the elements [-]; None for that of the contact law.
    """

    radius: float
    point: tuple[float, float, float] = (0.0, 0.0, 0.0)
    axis: tuple[float, float, float] = (1.0, 0.0, 0.0)
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
        """Point, axis, radius, its kind and 0, (9,)."""
        return np.array([*self.point, *self.axis, self.radius, OUTSIDE if self.outside else INSIDE, 0.0])


@dataclass(frozen=True)
class SphereWall:
    """A sphere among the elements (an impactor), or around them.

    Attributes:
        radius: [m].
        centre: [m], (3,).
        inside: whether the elements are inside of it.
        motion: how it moves; None stands still. A servo changes the radius.
        friction: μ against the elements [-]; None for that of the contact law.
    """

    radius: float
    centre: tuple[float, float, float] = (0.0, 0.0, 0.0)
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
        """Centre, zeros, radius, its kind and 0, (9,)."""
        return np.array([*self.centre, 0.0, 0.0, 0.0, self.radius, SHELL if self.inside else BALL, 0.0])


Wall = PlaneWall | CylinderWall | SphereWall


def check_walls(walls: object) -> tuple[Wall, ...]:
    """Walls as a tuple.

    Raises:
        InputError: something else than walls.
    """
    kinds = PlaneWall, CylinderWall, SphereWall
    return several("Model", "walls", walls, kinds, "bd.PlaneWall, bd.CylinderWall and bd.SphereWall")


@dataclass(frozen=True, eq=False)
class WallTable:
    """Walls as the kernels take them.

    Attributes:
        shape: point, normal or axis, radius, kind, radius of a hole; shape (w, 9).
        friction: μ, (w,).
        start, times, values: schedules one after the other.
        drive_wall, drive_component, drive_schedule, drive_rate: what is prescribed, (d,).
        servo_wall, servo_schedule, servo_speed, servo_mass: what is controlled, (s,).
        free_wall, free_mass, free_force: what is free, (f,) and (f, 3).
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
    free_wall: Ints
    free_mass: Floats
    free_force: Floats

    @property
    def platens(self) -> Floats:
        """Masses of the walls that a force moves [kg], (s + f,)."""
        return np.concatenate([self.servo_mass, self.free_mass])

    @classmethod
    def of(cls, walls: Sequence[Wall], friction: float, elements: float, origin: Floats) -> "WallTable":
        """The walls of a model whose contact law has `friction` and whose elements weigh `elements` in all [kg].

        Their places count from `origin` [m], (3,), as those of the elements do.
        """
        tables: list[tuple[Floats, Floats]] = []
        drives: list[tuple[int, int, int, bool]] = []
        servos: list[tuple[int, int, float, float]] = []
        for k, wall in enumerate(walls):
            match wall.motion:
                case Driven(motion=motion):
                    for component, schedule, rate in motion:
                        drives.append((k, component, len(tables), rate))
                        tables.append(schedule.table)
                case Servo(force=force, speed=speed, mass=mass):
                    servos.append((k, len(tables), speed, elements if mass is None else mass))
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
            servo_speed=np.array([v for *_, v, _ in servos], dtype=float),
            servo_mass=np.array([m for *_, m in servos], dtype=float),
            free_wall=np.array([k for k, _ in free], dtype=np.int64),
            free_mass=np.array([body.mass for _, body in free], dtype=float),
            free_force=np.array([body.force for _, body in free], dtype=float).reshape(-1, 3),
        )


def _from(shape: Floats, origin: Floats) -> Floats:
    """Shapes of walls from another origin; of a plane the nearest point to that."""
    if not origin.any():
        return shape
    point = shape[:, :3] - origin
    plane = shape[:, 7] == PLANE  # the column of kinds
    normal = shape[plane, 3:6]
    point[plane] = normal * (point[plane] * normal).sum(axis=1, keepdims=True)
    return np.hstack([point, shape[:, 3:]])
