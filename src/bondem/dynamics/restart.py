"""Start of a run from a state, with checks of the schedules at its time."""

import math
import warnings
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from bondem._checks import shown
from bondem._names import users_line
from bondem._types import Floats, Triple
from bondem.boundary.conditions import Drive
from bondem.boundary.frozen_conditions import Scheduled
from bondem.boundary.gauges import Gauge
from bondem.boundary.schedules import Schedule
from bondem.boundary.wall_constraints import Supports
from bondem.boundary.wall_motions import Driven, Servo
from bondem.boundary.wall_rows import wall_rows
from bondem.boundary.wall_sides import doubts
from bondem.dynamics.contact_check import doubt_of_faces
from bondem.dynamics.plan import Plan
from bondem.dynamics.stage_walls import goes_on, stage_walls
from bondem.errors import ContactWarning, InputError, StageWarning
from bondem.geometry.rotations import rotation_vector
from bondem.model.model import Model
from bondem.model.state import State
from bondem.model.state_check import check_arrays
from bondem.model.state_compatibility import Origin

# Tolerated difference between a prescribed displacement and that of its element, for rounding of many steps: as a
# share of the displacement and, where anything has moved, of the extent of the specimen or of one radian.
_SHARE, _ROUNDING = 1e-6, 1e-10

_DOF = ("x", "y", "z", "rx", "ry", "rz")


def begin(model: Model, state: State | None) -> State:
    """Return a state to run `model` from: a new one at rest, or a copy of `state`, whose time continues.

    Raises:
        InputError: The state belongs to a model with other elements, masses or bonds, or has an array or damage that
            does not fit `model`, or displacements would jump.

    Warns:
        StageWarning: A schedule that is new in this run no longer has its first value at the time of the state, or a
            load or strain differs from that of the equilibrium from which the run begins.
        ContactWarning: A wall faces away from all elements, elements begin behind a wall, or plane faces of
            bodies of cells stand against each other.
    """
    if state is not None:
        check_arrays(state)
    own = State(model) if state is None else state.copy()
    moved = bool((own.pose[:, :3] != own.rest).any())
    before = None if state is None or state.time == 0.0 else state.model
    if state is not None:
        own.begin(model)
        own.grips = stage_walls(model, state)
    _refuse_jumps(model, own, () if before is None else (*before.boundary, *before.walls))
    at_rest = state is None or (before is None and not moved and goes_on(model, state))
    _refuse_wall_jumps(model.interaction.supports, own, at_rest=at_rest)
    if before is not None:
        _warn_of_lost_time(model, before, own.time)
    elif state is not None and moved:
        _warn_of_other_loads(model, state.model)
    _warn_of_sides(model, own, () if before is None else before.walls)
    if before is None and not moved and (doubt := doubt_of_faces(model, own)):
        warnings.warn(doubt, ContactWarning, stacklevel=users_line())
    return own


def check_gauges(model: Model, plan: Plan) -> None:
    """Raise InputError for a force gauge in whose region no element is fixed, driven or loaded."""
    row_of = model.constraints.row_of
    for name, gauge in plan.gauges.items():
        if not isinstance(gauge, Gauge) or gauge.quantity != "force":
            continue
        if (row_of[model.layout.rank[gauge.region.select(model.lattice)]] < 0).all():
            raise InputError(
                f"gauge '{name}' reads forces of loads and supports, and {shown(gauge.region)} has none; use a"
                " region that is fixed, driven or loaded"
            )


def _refuse_jumps(model: Model, state: State, before: Sequence[object]) -> None:
    """Raise InputError if a condition or a wall, unless in `before`, begins with a jump of the displacement."""
    position = state.pose[:, :3] - state.rest
    shift = np.concatenate([position, rotation_vector(state.pose[:, 4:])], axis=1)
    slack = np.where(shift.any(axis=0), _ROUNDING, 0.0)
    slack[:3] *= float(np.ptp(state.rest, axis=0).max()) + model.lattice.particles.mean_radius
    constraints, s = model.constraints, -1
    for condition in model.interaction.on_elements(model.boundary):
        if isinstance(condition, Scheduled):
            s += 1  # schedules are numbered in the order of the conditions
        if not isinstance(condition, Drive):
            continue
        for dof, schedule, rate in condition.motion:
            s += 1
            if rate or condition in before:
                continue
            elements = constraints.element[constraints.drives.row[constraints.drives.schedule == s]]
            _refuse_jump(f"Drive({_DOF[dof]}=)", schedule, state.time, shift[elements, dof], float(slack[dof]))
    for k, wall in enumerate(model.walls):
        if not isinstance(wall.motion, Driven) or wall in before:
            continue
        row = wall_rows(state.walls)[k]
        places = dict(zip("xyz", row["displacement"], strict=True)) | {"growth": row["growth"]}
        for name, schedule in wall.motion.components.items():
            if name == "angle":
                where = _angle(row["orientation"], wall.motion.axis, schedule.at(state.time))
                _refuse_jump("Driven(angle=)", schedule, state.time, np.array([where]), _ROUNDING if where else 0.0)
            elif name in places:
                where = np.array([places[name]])
                rounding = _ROUNDING * model.lattice.particles.mean_radius if where.any() else 0.0
                _refuse_jump(f"Driven({name}=)", schedule, state.time, where, rounding)


def _angle(orientation: Floats, axis: Triple, near: float) -> float:
    """Return the angle of a wall about an axis [rad], with as many whole turns as bring it closest to `near`."""
    found = 2.0 * math.atan2(float(orientation[1:] @ np.array(axis)), float(orientation[0]))
    return found + 2.0 * math.pi * round((near - found) / (2.0 * math.pi))


def _refuse_wall_jumps(supports: Supports, state: State, *, at_rest: bool) -> None:
    """Raise InputError if walls that fix cells would jump; in a state `at_rest` these walls have not moved yet."""
    extent = float(np.ptp(state.rest, axis=0).max()) if state.time > 0.0 else 0.0
    for s, (schedule, rate) in enumerate(zip(supports.fixed.drives, supports.fixed.rate, strict=True)):
        moved = supports.fixed.drive == s
        if not rate and moved.any():
            where = state.grips[:, :3][moved] + schedule.at(state.time)
            dof = int(np.flatnonzero(moved.any(axis=0))[0])
            _refuse_jump(
                f"Drive({_DOF[dof]}=)", schedule, state.time, np.zeros(1) if at_rest else where, _ROUNDING * extent
            )


def _refuse_jump(owner: str, schedule: Schedule, time: float, where: Floats, slack: float) -> None:
    """Raise InputError if a displacement jumps from `where` it is, or at a time of its schedule that is to come."""
    value = schedule.at(time)
    worst = where[np.abs(where - value).argmax()]
    if abs(worst - value) > _SHARE * max(abs(worst), abs(value)) + slack:
        raise InputError(
            f"{owner} begins at {value:.6g}, but is at {worst:.6g} when the run begins (t = {time:.6g} s), and an"
            f" explicit run cannot jump: begin there, as by bd.Ramp({worst:.6g}, {schedule.final:.6g}, duration),"
            " or give a velocity"
        )
    times, values = schedule.table
    jump = np.abs(np.diff(values)) > _SHARE * np.maximum(np.abs(values[1:]), np.abs(values[:-1])) + slack
    for k in np.flatnonzero(jump & (np.diff(times) == 0.0) & (times[1:] > time)).tolist():
        raise InputError(
            f"{owner} jumps from {values[k]:.6g} to {values[k + 1]:.6g} at t = {times[k]:.6g} s, and an explicit run"
            " cannot jump: give different times for both values, or give a velocity"
        )


def _warn_of_lost_time(model: Model, before: Origin, time: float) -> None:
    known = [schedule for _, schedule in _schedules(before)]
    for owner, schedule in _schedules(model):
        value, first = schedule.at(time), float(schedule.table[1][0])
        if value != first and schedule not in known:
            over = "over" if schedule.table[0][-1] <= time else "under way"
            warnings.warn(
                f"{owner}: {shown(schedule)} is {over} when this run begins, because the time continues from that of"
                f" its initial state (t = {time:.6g} s): its first value is {value:.6g}, not {first:.6g}; give later"
                f" times, such as begin={time:.6g}",
                StageWarning, stacklevel=users_line(),
            )  # fmt: skip


def _warn_of_other_loads(model: Model, before: Origin) -> None:
    """Warn about loads and strains whose factor differs from that of the equilibrium from which a run begins."""
    known = [one for one in before.boundary if isinstance(one, Scheduled)]
    for one in model.boundary:
        if not isinstance(one, Scheduled):
            continue
        value = one.schedule.at(0.0)
        for was in (other.schedule.at(0.0) for other in known if replace(other, schedule=one.schedule) == one):
            if abs(value - was) > _SHARE * max(abs(value), abs(was)):
                warnings.warn(
                    f"{type(one).__name__}: its factor is {value:.6g} when this run begins, and {was:.6g} in the"
                    " equilibrium that it begins from: the difference acts at once; begin there, as by"
                    f" bd.Ramp({was:.6g}, {one.schedule.final:.6g}, duration)",
                    StageWarning, stacklevel=users_line(),
                )  # fmt: skip


def _warn_of_sides(model: Model, state: State, before: Sequence[object]) -> None:
    """Warn about new walls that face away from the elements, or have elements behind them."""
    fresh = [(k, wall) for k, wall in enumerate(model.walls) if wall not in before]
    for doubt in doubts(fresh, state.position, model.contact_radius) if fresh else ():
        warnings.warn(doubt, ContactWarning, stacklevel=users_line())


def _schedules(model: Origin) -> Iterator[tuple[str, Schedule]]:
    for condition in model.boundary:
        owner = type(condition).__name__
        if isinstance(condition, Drive):
            for _, schedule, _ in condition.motion:
                yield owner, schedule
        elif isinstance(condition, Scheduled):
            yield owner, condition.schedule
    for wall in model.walls:
        if isinstance(wall.motion, Driven):
            for _, schedule, _ in wall.motion.motion:
                yield "Driven", schedule
        elif isinstance(wall.motion, Servo):
            yield "Servo", wall.motion.force
