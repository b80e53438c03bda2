"""Walls of a model as the tables of numbers that the compiled core reads."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from bondem._tables.columns import WallKind
from bondem._types import Floats, Ints, PerElement, PerElement3, Triple
from bondem.boundary.schedules import Schedule, joined_tables
from bondem.boundary.wall_motions import TURN, Driven, Free, Servo
from bondem.boundary.wall_rows import named_rows, no_rows
from bondem.boundary.walls import PlaneWall, SphereWall, Wall, pivot


@dataclass(frozen=True, eq=False)
class WallTable:
    """Walls of a model as the tables of numbers that the compiled core reads.

    Attributes:
        shape: rows of `WallShape`, (w, 12).
        inertia: rows of `WallInertia`, (w, 8).
        start, times, values: times [s] and values of all schedules; schedule k has rows start[k] … start[k + 1] - 1.
        drive_wall, drive_component, drive_schedule, drive_rate, drive_axis: prescribed motions, (d,) and (d, 3).
        servo_wall, servo_schedule, servo_speed, servo_mass, servo_damping: walls and quantities of `Servo`, (s,).
        free_wall, free_mass, free_force, free_torque: walls and quantities of `Free`, (f,) and (f, 3).
        free_lever: largest distance of a contact from the centre of a free wall that turns, else 0 [m], (f,).
    """

    shape: Floats
    inertia: Floats
    start: Ints
    times: Floats
    values: Floats
    drive_wall: Ints
    drive_component: Ints
    drive_schedule: Ints
    drive_rate: np.ndarray
    drive_axis: Floats
    servo_wall: Ints
    servo_schedule: Ints
    servo_speed: Floats
    servo_mass: Floats
    servo_damping: Floats
    free_wall: Ints
    free_mass: Floats
    free_force: Floats
    free_torque: Floats
    free_lever: Floats

    @property
    def turning(self) -> Ints:
        """Numbers of the walls that can turn, by a prescribed motion or freely, ascending."""
        free = named_rows("WallInertia", self.inertia)["inverse_moment"].any(axis=1)
        return np.union1d(self.drive_wall[self.drive_component == TURN], np.flatnonzero(free))

    @property
    def platens(self) -> Floats:
        """Effective masses at a contact of the walls moved by forces, first servos, then free walls [kg], (s + f,).

        A turning wall of mass M has 1 / (1/M + lever² / I) at its largest lever, with I the least principal moment.
        """
        softest = named_rows("WallInertia", self.inertia)["inverse_moment"][self.free_wall].max(axis=1)
        eased = self.free_mass / (1.0 + self.free_mass * self.free_lever**2 * softest)
        return np.concatenate([self.servo_mass, eased])

    @classmethod
    def of(
        cls, walls: Sequence[Wall], mass: float, origin: Floats,
        position: PerElement3, radius: PerElement,
    ) -> "WallTable":  # fmt: skip
        """Build the tables of the walls of a model.

        Args:
            walls: walls of the model.
            mass: mass of all elements [kg].
            origin: local origin of the elements, to which the walls are shifted too [m], (3,).
            position: centres of the elements [m], (n, 3).
            radius: contact radii of the elements [m], (n,).
        """
        schedules: list[Schedule] = []
        drives: list[tuple[int, int, int, bool]] = []
        axes: list[Triple] = []
        servos: list[tuple[int, int, float, float, float]] = []
        for k, wall in enumerate(walls):
            match wall.motion:
                case Driven(motion=motion, axis=axis):
                    for component, schedule, rate in motion:
                        drives.append((k, component, len(schedules), rate))
                        axes.append(axis if component == TURN else (0.0, 0.0, 0.0))
                        schedules.append(schedule)
                case Servo(force=force, speed=speed, mass=platen, damping=damping):
                    servos.append((k, len(schedules), speed, mass if platen is None else platen, damping))
                    schedules.append(force)
        free = [(k, wall.motion) for k, wall in enumerate(walls) if isinstance(wall.motion, Free)]
        drive = np.array(drives, dtype=np.int64).reshape(-1, 4)
        return cls(
            shape=_shapes(walls, origin),
            inertia=_inertias(walls),
            **joined_tables(schedules),
            drive_wall=drive[:, 0].copy(),
            drive_component=drive[:, 1].copy(),
            drive_schedule=drive[:, 2].copy(),
            drive_rate=drive[:, 3].astype(np.uint8),
            drive_axis=np.array(axes, dtype=float).reshape(-1, 3),
            servo_wall=np.array([k for k, *_ in servos], dtype=np.int64),
            servo_schedule=np.array([s for _, s, *_ in servos], dtype=np.int64),
            servo_speed=np.array([v for *_, v, _, _ in servos], dtype=float),
            servo_mass=np.array([m for *_, m, _ in servos], dtype=float),
            servo_damping=np.array([share for *_, share in servos], dtype=float),
            free_wall=np.array([k for k, _ in free], dtype=np.int64),
            free_mass=np.array([body.mass for _, body in free], dtype=float),
            free_force=np.array([body.force for _, body in free], dtype=float).reshape(-1, 3),
            free_torque=np.array([body.torque for _, body in free], dtype=float).reshape(-1, 3),
            free_lever=np.array([_lever(walls[k], position, radius) for k, _ in free], dtype=float),
        )


def _shapes(walls: Sequence[Wall], origin: Floats) -> Floats:
    """Return rows of `WallShape` relative to an origin; points of planes become the nearest to it, unless it is 0."""
    numbers = no_rows("WallShape", len(walls))
    if not len(walls):
        return numbers
    numbers[:, :9] = [wall.row for wall in walls]
    shape = named_rows("WallShape", numbers)
    shape["about"] = [pivot(wall) for wall in walls]
    if origin.any():
        shape["point"] -= origin
        shape["about"] -= origin
        plane = shape["kind"] == WallKind.PLANE_WALL
        normal = shape["axis"][plane]
        shape["point"][plane] = normal * (shape["point"][plane] * normal).sum(axis=1, keepdims=True)
    return numbers


def _inertias(walls: Sequence[Wall]) -> Floats:
    """Return rows of `WallInertia`: inverse masses, inverse principal moments and principal axes of free walls."""
    numbers = no_rows("WallInertia", len(walls))
    rows = named_rows("WallInertia", numbers)
    rows["principal"][:, 0] = 1.0
    for k, wall in enumerate(walls):
        if not isinstance(wall.motion, Free):
            continue
        rows["inverse_mass"][k] = 1.0 / wall.motion.mass
        if wall.motion.inertia is None:
            continue
        matrix = wall.motion.matrix
        moments, axes = np.diag(matrix), np.eye(3)
        if np.any(matrix != np.diag(moments)):
            moments, axes = np.linalg.eigh(matrix)
            axes[:, 2] = np.cross(axes[:, 0], axes[:, 1])
        rows["inverse_moment"][k] = 1.0 / moments
        rows["principal"][k] = Rotation.from_matrix(axes).as_quat()[[3, 0, 1, 2]]
    return numbers


def _lever(wall: Wall, position: PerElement3, radius: PerElement) -> float:
    """Return the largest distance of a contact from the centre of a free wall that turns, else 0 [m]."""
    if not isinstance(wall.motion, Free) or wall.motion.inertia is None:
        return 0.0
    if isinstance(wall, SphereWall):
        return wall.radius
    if isinstance(wall, PlaneWall) and wall.outer is not None:
        return wall.outer
    return float((np.linalg.norm(position - wall.point, axis=1) + radius).max())
