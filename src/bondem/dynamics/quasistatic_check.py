"""Measurement of runs that are meant to be quasi-static: kinetic energy, forces at both ends and of servo walls.

Runs with a servo wall are checked. A run that loads the specimen between two ends, one of them driven, is checked if
it has local or mass damping. It is also checked if it records a force and reaches its largest elastic energy only
after many transits of a wave. Other runs, such as impacts, waves, vibrations and pulses of pressure, are not checked.
"""

from collections.abc import Iterator

import numpy as np

from bondem.boundary.conditions import Drive, Fix
from bondem.boundary.gauges import Gauge, WallGauge
from bondem.boundary.schedules import Schedule
from bondem.boundary.wall_motions import Driven, Servo
from bondem.boundary.wall_rows import wall_rows
from bondem.boundary.walls import PlaneWall
from bondem.dynamics.damping import DampingTerms
from bondem.dynamics.history import STORED_ENERGIES, History
from bondem.dynamics.plan import Plan
from bondem.dynamics.quasistatic import Quasistatic
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observables.breakage import BrokenBonds

# Steps to the largest elastic energy, over the number of elements along the specimen, from which on loading without
# damping counts as slow: a wave passes an element in two to four steps.
_PASSES = 60.0


def measured(model: Model, plan: Plan, history: History, state: State) -> Quasistatic:
    """Return the measures of equilibrium of a run, from its records and its last state."""
    kinetic = difference = None
    passes = 0.0
    if len(history) > 1:
        energy = history.energy
        elastic = np.sum([energy[name] for name in STORED_ENERGIES[2:]], axis=0)
        top = int(np.argmax(elastic))
        # a specimen that only servo walls load must be at rest at the end
        whole = chosen = slice(len(history) - max(1, len(history) // 10), len(history))
        # with driven ends, the initial motion is prescribed, and broken parts move at any speed of loading
        if any(any(_ends(model, axis)) for axis in range(3)):
            broken = BrokenBonds.of(state).time.min(initial=np.inf)
            whole, chosen = slice(1, top + 1), slice(1, min(top + 1, int(np.searchsorted(history.time, broken))))
        moving, stored = (energy["translation"] + energy["rotation"])[chosen], elastic[whole].max(initial=0.0)
        kinetic = float(moving.max(initial=0.0) / stored) if stored > 0.0 else None
        difference = _difference(plan, history, whole, chosen)
        passes = top * plan.every * _share_of_a_step(model)
    servo = {
        k: (float(wall_rows(state.walls)["normal_force"][k]), wall.motion.force.at(state.time))
        for k, wall in enumerate(model.walls)
        if isinstance(wall.motion, Servo) and wall.motion.force.at(state.time) > 0.0
    }
    return Quasistatic(kinetic, difference, servo, _meant(model, plan, passes))


def _difference(plan: Plan, history: History, whole: slice, chosen: slice) -> float | None:
    """Return the largest sum of two opposite forces in `chosen` records over the largest force in `whole` [-].

    The result is None unless exactly two gauges record opposite forces.
    """
    names = _force_gauges(plan)
    if len(names) != 2:
        return None
    one, other = (history[name][whole] for name in names)
    largest = max(float(np.linalg.norm(force, axis=1).max(initial=0.0)) for force in (one, other))
    if not largest > 0.0 or not float((one * other).sum()) < 0.0:
        return None
    differences = np.linalg.norm(history[names[0]] + history[names[1]], axis=1)[chosen]
    return float(differences.max(initial=0.0)) / largest


def _force_gauges(plan: Plan) -> list[str]:
    """Return the names of the gauges that record the whole force on a region or a wall."""
    return [
        name for name, gauge in plan.gauges.items()
        if isinstance(gauge, Gauge | WallGauge) and gauge.quantity == "force"
        and getattr(gauge, "reduction", "sum") == "sum"
    ]  # fmt: skip


def _share_of_a_step(model: Model) -> float:
    """Return the mean diameter of an element over the largest extent of the specimen [-].

    A wave passes less than one element per step, so that this share of the extent bounds its travel per step.
    """
    lower, upper = model.lattice.particles.envelope.bounds
    extent = float(np.max(np.asarray(upper) - np.asarray(lower)))
    return 2.0 * model.lattice.particles.mean_radius / extent


def _meant(model: Model, plan: Plan, passes: float) -> str:
    if any(isinstance(wall.motion, Servo) for wall in model.walls):
        return "with a servo wall"
    if not any(_squeezed(model, axis) for axis in range(3)):
        return ""
    terms = DampingTerms.of(plan.damping)
    if terms.gamma or terms.alpha:
        return "driven between two ends, with damping"
    slow = bool(_force_gauges(plan)) and passes > _PASSES
    return "driven slowly between two ends, whose force is recorded" if slow else ""


def _squeezed(model: Model, axis: int) -> bool:
    """Return True if conditions act on two ends of the specimen along an axis, and drive one of them."""
    ends = list(_ends(model, axis))
    return len(ends) > 1 and any(ends)


def _ends(model: Model, axis: int) -> Iterator[bool]:
    """Yield True for each end that is driven along an axis, and False for each that is fixed along it."""
    for condition in model.boundary:
        if isinstance(condition, Fix) and (axis in condition.components or condition.friction):
            yield False
        if isinstance(condition, Drive):
            yield from (_moves(schedule) for dof, schedule, _ in condition.motion if dof == axis)
    for wall in model.walls:
        if isinstance(wall, PlaneWall) and abs(wall.normal[axis]) > 0.5:
            motion = wall.motion.motion if isinstance(wall.motion, Driven) else ()
            yield any(_moves(schedule) for component, schedule, _ in motion if component == axis)


def _moves(schedule: Schedule) -> bool:
    return bool(np.any(schedule.table[1]))
