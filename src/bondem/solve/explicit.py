"""Explicit dynamics: a plan, and the loop that carries it out."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from enum import Enum
from typing import Protocol, cast

import numpy as np

from bondem._compile import current_threads
from bondem.errors import InputError
from bondem.kernels.advance import (
    CONTACT,
    FINE,
    FIXED_COLUMNS,
    NOT_FINITE,
    RUNAWAY,
    SERIAL_BONDS,
    TRANSLATION,
    WALL_DISPLACEMENT,
    advance,
    evaluate,
)
from bondem.kernels.contact_pass import Contacts
from bondem.kernels.sweep import TILE
from bondem.laws.damping import AnyDamping, DampingTerms
from bondem.model.blocks import Blocks
from bondem.model.bond_table import BondTable, alike
from bondem.model.gauges import QUANTITIES, REDUCTIONS, WALL_QUANTITIES, AnyGauge, Gauge
from bondem.model.model import Model
from bondem.model.state import State
from bondem.solve.added import added, changing_strain
from bondem.solve.contacts import ContactList
from bondem.solve.events import Event
from bondem.solve.history import History
from bondem.solve.saving import Sink
from bondem.solve.schemes import Scheme, VelocityVerlet
from bondem.solve.timestep import choose_step

# Elements of a block: they stay in the L2 cache from their bonds to their motion.
BLOCK = 4000
# Steps in one compiled call at most, so that progress and interrupts are not far away, and between copies of a state
# that is good: copying costs about as much as two steps.
_CHUNK = 5_000
# Steps in which what ends a run comes up from rounding: a copy must be older than that to be given back.
_RISE = 1_000
# Elements that move by this share of their radius a step have an energy that no guard minds.
_STILL = 1e-6

# Called with the state and the record of each output; ends the run by returning True.
Callback = Callable[[State, History], bool | None]


class Status(Enum):
    """How a run ended."""

    COMPLETED = "completed"
    STOPPED = "stopped by an event"
    UNSTABLE = "unstable"


@dataclass(frozen=True, kw_only=True)
class Plan:
    """How a model is run.

    Attributes:
        duration: physical time [s]; the run takes round(duration / dt) steps.
        dt: time step [s]; None for `safety` times the critical one.
        scheme: time integration.
        damping: of elements or bonds, one kind or several in a tuple, or None.
        gauges: what to record, by name.
        every: steps between records; 0 for none.
        save_every: steps between checkpoints; 0 for none but the last.
        until: events that end the run.
        safety: share of the critical time step to use when dt is None [-].
    """

    duration: float
    dt: float | None = None
    scheme: Scheme = field(default_factory=VelocityVerlet)
    damping: AnyDamping | tuple[AnyDamping, ...] | None = None
    gauges: Mapping[str, AnyGauge] = field(default_factory=dict)
    every: int = 100
    save_every: int = 0
    until: tuple[Event, ...] = ()
    safety: float = 0.9

    def __post_init__(self) -> None:
        if not (math.isfinite(self.duration) and self.duration >= 0.0):
            raise InputError(f"duration = {self.duration} s; give a time of zero or more")
        if not 0.0 < self.safety <= 1.0:
            raise InputError(f"safety = {self.safety}; give a share of the critical step in (0, 1]")
        for name in ("every", "save_every"):
            if getattr(self, name) < 0 or int(getattr(self, name)) != getattr(self, name):
                raise InputError(f"{name} = {getattr(self, name)}; give a whole number of steps, 0 for never")
        if self.until and not self.every:
            raise InputError("events are looked at with each record: give every= at least 1 where there is until=")
        object.__setattr__(self, "until", tuple(self.until))
        DampingTerms.of(self.damping)


@dataclass(frozen=True, eq=False)
class ExplicitResult:
    """What came back.

    Attributes:
        status: how the run ended.
        state: where everything is; after an unstable run, where all was well for the last time, at most 10 000
            steps before.
        history: the records.
        dt: time step used [s].
        steps: steps done since the start of the model's time.
        message: one line for people.
    """

    status: Status
    state: State
    history: History
    dt: float
    steps: int
    message: str


class Loop(Protocol):
    """What carries out the steps of a run, on the CPU or another device."""

    state: State

    def look(self) -> np.ndarray:
        """Bring the acceleration up to date and record the present."""
        ...

    def run(self, steps: int) -> tuple[np.ndarray, int, int, int]:
        """Go on; the records written, bonds turned wide, bonds lost, and what `kernels.advance.guard` found."""
        ...


def settled(model: Model, plan: Plan) -> Plan:
    """The same plan with its time step chosen, or checked where it is given.

    Raises:
        UnstableStepError: dt above the critical step of the lattice.
    """
    step = choose_step(model, plan.scheme, plan.dt, safety=plan.safety, damping=plan.damping)
    return replace(plan, dt=step.dt)


def integrate(
    model: Model,
    plan: Plan,
    *,
    state: State | None = None,
    history: History | None = None,
    sink: Sink | None = None,
    progress: Callable[[float], None] | None = None,
    loop_of: Callable[[Model, Plan, State, float], Loop] | None = None,
    callback: Callback | None = None,
    remark: str = "",
) -> ExplicitResult:
    """Carry out a plan, from rest or from where `state` and `history` of the same plan left off.

    Args:
        model: what to run; its geometry is the reference configuration.
        plan: how.
        state: where to start; it is changed in place.
        history: the records so far.
        sink: takes checkpoints, and the last state.
        progress: called now and then with the share done, 0 … 1.
        loop_of: makes the loop from model, plan, state and dt; that of the CPU unless given.
        callback: called with the state and its record, a history of one, whenever one is written; it only looks,
            and ends the run by returning True.
        remark: more to say in the message of the result.

    A given dt is taken as it is: `settled` checks it.
    """
    if callback is not None and not plan.every:
        raise InputError("a callback is called with each record: give every= at least 1 where there is callback=")
    if plan.dt is None:
        plan = settled(model, plan)
    dt = cast(float, plan.dt)
    names = tuple(plan.gauges)
    history = History.empty(names) if history is None else history
    state = State(model) if state is None else state
    loop = (_Loop if loop_of is None else loop_of)(model, plan, state, dt)
    total = round(plan.duration / dt)
    status, message = Status.COMPLETED, f"{total} steps of {dt:.4g} s"
    kept = (state.copy(),)
    begun = loop.look()  # whether it is kept or not: guards need its energy
    fresh: list[np.ndarray] = []
    if len(history) == 0 and plan.every:
        fresh.append(begun)
    stop = bool(fresh) and callback is not None and bool(callback(state, History(begun, names)))
    warning = f"; {remark}" if remark else ""
    turned = ""
    while state.step < total and not stop:
        goal = min(total, kept[-1].step + _CHUNK)
        looked = plan.every if plan.until or callback is not None else 0
        for interval in (plan.save_every, looked):
            if interval:
                goal = min(goal, (state.step // interval + 1) * interval)
        records, wide, lost, sick = loop.run(goal - state.step)
        fresh.append(records)
        if lost or sick != FINE:
            cause = _CAUSES.get(sick, f"{lost} unbroken bonds are turned beyond 90 degrees")
            good = kept[-1] if state.step - kept[-1].step >= _RISE else kept[0]
            status = Status.UNSTABLE
            message = (
                f"stopped at step {state.step}: {cause}; the state is that of step {good.step}."
                " Use a smaller dt, or load more gently"
            )
            state = good
            break
        if wide:
            turned = (
                f"; {wide} bonds were turned so far (c < 0.7 or w² < 0.75) that the bond energy is no longer that of"
                " a beam: use shorter bonds or lower loads"
            )
        if progress is not None:
            progress(state.step / total)
        if plan.save_every and state.step % plan.save_every == 0 and sink is not None:
            history = history.extended(*fresh)
            fresh.clear()
            sink.checkpoint(state, history)
        if state.step - kept[-1].step >= _CHUNK:
            kept = (kept[-1], state.copy())
        if callback is not None and len(records) and callback(state, History(records, names)):
            stop = True
        elif any(event.happened(state) for event in plan.until):
            status, message = Status.STOPPED, f"stopped by an event at t = {state.time:.6g} s"
            break
    if stop:
        status, message = Status.STOPPED, f"stopped by the callback at t = {state.time:.6g} s"
    history = history.extended(*fresh)
    if sink is not None and status is not Status.UNSTABLE:
        sink.checkpoint(state, history)
    return ExplicitResult(status, state, history, dt, state.step, message + turned + warning)


_CAUSES = {
    NOT_FINITE: "a number is not finite",
    RUNAWAY: "the kinetic energy is a thousand times what was there and was put in",
}


def rested(bonds: BondTable, eigenstrain: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Constants, shear stiffness and lever with rest lengths L (1 + ε*)."""
    table = bonds.stretched(eigenstrain)
    return table.constants, table.shear, table.lever


class _Loop:
    """The arguments of the compiled loop, gathered once."""

    def __init__(self, model: Model, plan: Plan, state: State, dt: float) -> None:
        self.state = state
        self.plan = plan
        self.origin = state.time - state.step * dt
        self.dt = dt
        layout, bonds, held = model.layout, model.bonds, model.constraints
        self.width = FIXED_COLUMNS + 3 * len(plan.gauges)
        constants, shear, lever = rested(bonds, state.eigenstrain)
        same = alike(constants)
        if len(held.strain_part):  # they change while it runs
            constants, shear, lever, same = constants.copy(), shear.copy(), lever.copy(), None
        domains = current_threads() if len(layout.i) >= SERIAL_BONDS else 1
        blocks = Blocks.of(layout, BLOCK, domains)
        rows = np.zeros((2, len(held.element), 6))
        terms = DampingTerms.of(plan.damping)
        self.scheme = (*plan.scheme.coefficients(dt), terms.gamma)
        self.arrays = (
            state.pose, state.motion, state.acceleration, layout.i, layout.j, constants, same, shear,
            bonds.bending, lever, state.integrity, state.history, model.period,
            np.empty((domains, 9, TILE)), blocks.row_i, blocks.row_j, np.zeros((blocks.rows, 8)),
            blocks.domain, blocks.bond, blocks.move, blocks.ready, blocks.ready_row, blocks.shared, blocks.shared_row,
            blocks.parts, blocks.part,
            held.times, held.values, held.start, held.drive_row, held.drive_dof, held.drive_schedule,
            held.drive_rate, held.load_row, held.load_schedule, held.load_value,
            held.row_of, held.fixed, np.zeros((len(held.element), 6)), rows[0], rows[1], state.reaction,
            state.work, state.loss, state.rest,
            *gauge_tables(model, plan),
        )  # fmt: skip
        self.contacts = None if model.contacts is None else ContactList(model, model.contacts, state)
        self.budget = np.zeros(2)  # as `kernels.advance.guard` has it
        self._still = 0.5 * float(model.mass.sum()) * (_STILL * model.lattice.particles.mean_radius / dt) ** 2
        contact = None if self.contacts is None else self.contacts.arrays.load
        self.added = added(model, terms, contact, blocks.rows), changing_strain(model, state)

    def look(self) -> np.ndarray:
        """Bring the acceleration up to date and record the present."""
        records = np.empty((1, self.width))
        evaluate(
            self.state.step, self.origin, self.dt, self.scheme[3], self.state.stale, *self.arrays,
            self._contact_arrays, *self.added, records,
        )  # fmt: skip
        self.state.stale = False
        self.budget[0] = max(self.budget[0], self._still + records[0, TRANSLATION : CONTACT + 1].sum())
        return records

    @property
    def _contact_arrays(self) -> Contacts | None:
        return None if self.contacts is None else self.contacts.arrays

    def run(self, steps: int) -> tuple[np.ndarray, int, int, int]:
        """Go on; the records written, bonds turned wide, bonds lost, and what `kernels.advance.guard` found."""
        if self.state.stale:
            self.look()
        every = int(self.plan.every)
        state = self.state
        records = np.empty((steps // every + 1 if every else 0, self.width))
        done, written, wide, lost = 0, 0, 0, 0
        sick, moved = FINE, False
        while sick == FINE:
            gone, new, turned, lost, sick, moved = advance(
                state.step + done, steps - done, every, self.origin, self.dt, moved, *self.scheme, *self.arrays,
                self._contact_arrays, *self.added, self.budget, records[written:],
            )  # fmt: skip
            done, written, wide = done + gone, written + new, max(wide, turned)
            if not moved or self.contacts is None:
                break
            self.contacts.keep()
            sick = FINE if self.contacts.renew(state.step + done) else NOT_FINITE
        state.step += done
        state.time = self.origin + state.step * self.dt
        if self.contacts is not None and sick == FINE:
            self.contacts.keep()
        return records[:written], wide, lost, sick


def gauge_tables(model: Model, plan: Plan) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Gauges as kernels take them: where the elements (or walls) of each begin, these, its quantity and reduction."""
    gauges = list(plan.gauges.values())
    members = [_members(model, gauge) for gauge in gauges]
    return (
        np.concatenate([[0], np.cumsum([len(part) for part in members])]).astype(np.int64),
        np.concatenate(members) if members else np.zeros(0, dtype=np.int64),
        np.array([_quantity(gauge) for gauge in gauges], dtype=np.int64),
        np.array([_reduction(gauge) for gauge in gauges], dtype=np.int64),
    )


def _members(model: Model, gauge: AnyGauge) -> np.ndarray:
    """Elements of a gauge, internal order, or the number of its wall.

    Raises:
        InputError: no such wall.
    """
    if isinstance(gauge, Gauge):
        return np.sort(model.layout.rank[gauge.region.select(model.lattice)])
    if not 0 <= gauge.wall < len(model.walls):
        raise InputError(f"WallGauge: there is no wall {gauge.wall}; give one from 0 to {len(model.walls) - 1}")
    return np.array([gauge.wall], dtype=np.int64)


def _quantity(gauge: AnyGauge) -> int:
    if isinstance(gauge, Gauge):
        return QUANTITIES.index(gauge.quantity)
    return WALL_DISPLACEMENT + WALL_QUANTITIES.index(gauge.quantity)


def _reduction(gauge: AnyGauge) -> int:
    return REDUCTIONS.index(gauge.reduction) if isinstance(gauge, Gauge) else 0
