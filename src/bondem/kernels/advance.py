"""Many steps in one compiled call: bonds, elements, boundary and sampling."""

import math

import numpy as np

from bondem._compile import device, kernel
from bondem.kernels.bond_pass import bond_energies, rotation_guard
from bondem.kernels.boundary import apply_added, apply_schedules
from bondem.kernels.contact_pass import advance_walls, contact_energy, contact_loads, outdated
from bondem.kernels.element_pass import open_step, open_step_serial
from bondem.kernels.incremental import incremental_energies
from bondem.kernels.sweep import step_forces

# Below this many bonds launching threads costs more than the loop.
SERIAL_BONDS = 2000
# Steps between two looks at the relative rotations, for numbers that are not finite, and at the energy.
GUARD_INTERVAL = 100
# What that look finds.
FINE, NOT_FINITE, RUNAWAY = range(3)
# Kinetic energy over all there ever was from which on a run is taken for unstable. It never exceeds one but by the
# error of the scheme, at a frequency next to the critical one at most 1 / (1 - (ω dt / ω dt critical)²); and what
# grows does so by orders of magnitude in a hundred steps.
_BEYOND = 1000.0
# Columns of a record before the gauges.
(
    TIME, TRANSLATION, ROTATION, NORMAL, SHEAR, BENDING, TWISTING, CONTACT, WORK, LOSS, FRICTION, FIXED_COLUMNS,
) = range(12)  # fmt: skip
# Gauges from this quantity on are of walls: displacement, force, and what belongs to the radius.
WALL_DISPLACEMENT, WALL_FORCE, WALL_GROWTH = range(5, 8)


@device
def rotation_component(w, x, y, z, d):
    """Component d of the rotation vector of a unit quaternion [rad], of length at most π."""
    sine = math.sqrt(x * x + y * y + z * z)
    part = x if d == 0 else (y if d == 1 else z)
    if sine < 1e-12:
        return 2.0 * part
    return 2.0 * math.atan2(sine, abs(w)) * part / sine * (1.0 if w >= 0.0 else -1.0)


@kernel(parallel=False)
def guard(motion, work, contacts, budget):
    """Whether the motion is finite, and its energy [J] no more than what can have come in.

    `budget` is the energy at the start and the most that loads, drives and walls have done since, as the sum of the
    sizes of all their parts; the latter is brought up to date.
    """
    kinetic = 0.0
    for p in range(len(motion)):
        v2 = motion[p, 0] ** 2 + motion[p, 1] ** 2 + motion[p, 2] ** 2
        w2 = motion[p, 4] ** 2 + motion[p, 5] ** 2 + motion[p, 6] ** 2
        kinetic += 0.5 * v2 / motion[p, 3] + 0.5 * w2 / motion[p, 7]
    supplied = 0.0
    for r in range(len(work)):
        supplied += abs(work[r])
    if contacts is not None:
        for w in range(len(contacts.walls)):
            supplied += abs(contacts.walls[w, 12])
    if not (kinetic < np.inf and supplied < np.inf):
        return NOT_FINITE
    budget[1] = max(budget[1], supplied)
    return RUNAWAY if kinetic > _BEYOND * (budget[0] + budget[1]) else FINE


@kernel(parallel=False)
def sample(
    t, pose, motion, i, j, constants, shear, bending, lever, integrity, history, period,
    rest, gauge_start, gauge_element, gauge_quantity, gauge_reduction, row_of, row_fixed, row_reaction,
    row_force, work, loss, contacts, record,
):  # fmt: skip
    """One row of the history: time, energies, work, and three components a gauge."""
    record[TIME] = t
    translation = 0.0
    rotation = 0.0
    for p in range(len(pose)):
        v2 = motion[p, 0] ** 2 + motion[p, 1] ** 2 + motion[p, 2] ** 2
        w2 = motion[p, 4] ** 2 + motion[p, 5] ** 2 + motion[p, 6] ** 2
        translation += 0.5 * v2 / motion[p, 3]
        rotation += 0.5 * w2 / motion[p, 7]
    record[TRANSLATION] = translation
    record[ROTATION] = rotation
    if history.shape[1] > 0:
        energies = incremental_energies(pose, i, j, constants, shear, bending, integrity, history, period)
    else:
        energies = bond_energies(pose, i, j, constants, shear, lever, integrity, period)
    for part in range(4):
        record[NORMAL + part] = energies[part]
    total = 0.0
    for r in range(len(work)):
        total += work[r]
    record[WORK] = total
    record[CONTACT] = 0.0
    damped = 0.0
    rubbed = 0.0
    for p in range(len(loss)):
        damped += loss[p, 0]
        rubbed += loss[p, 2]
    record[LOSS] = damped
    record[FRICTION] = rubbed
    if contacts is not None:
        record[CONTACT] = contact_energy(pose, period, contacts)
        for w in range(len(contacts.walls)):
            record[WORK] += contacts.walls[w, 12]
    for g in range(len(gauge_quantity)):
        quantity, reduction = gauge_quantity[g], gauge_reduction[g]
        first, last = gauge_start[g], gauge_start[g + 1]
        if quantity >= WALL_DISPLACEMENT:
            if contacts is not None:
                wall = contacts.walls[gauge_element[first]]
                column = 0 if quantity == WALL_DISPLACEMENT else 8
                for d in range(3):
                    record[FIXED_COLUMNS + 3 * g + d] = wall[column + d]
                if quantity == WALL_GROWTH:
                    record[FIXED_COLUMNS + 3 * g] = wall[3]
                    record[FIXED_COLUMNS + 3 * g + 1] = wall[11]
                    record[FIXED_COLUMNS + 3 * g + 2] = wall[13]
            continue
        for d in range(3):
            value = -np.inf if reduction == 2 else 0.0
            for e in range(first, last):
                p = gauge_element[e]
                if quantity == 0:
                    x = pose[p, d] - rest[p, d]
                elif quantity == 1:
                    x = motion[p, d]
                elif quantity == 2:
                    x = rotation_component(pose[p, 4], pose[p, 5], pose[p, 6], pose[p, 7], d)
                elif quantity == 3:
                    x = motion[p, 4 + d]
                else:
                    r = row_of[p]
                    x = 0.0 if r < 0 else (row_reaction[r, d] if row_fixed[r, d] else row_force[r, d])
                value = max(value, abs(x)) if reduction == 2 else value + x
            record[FIXED_COLUMNS + 3 * g + d] = value / (last - first) if reduction == 0 else value


@kernel(parallel=False)
def evaluate(
    step, t0, dt, gamma, stale,
    pose, motion, acceleration, i, j, constants, same, shear, bending, lever, integrity, history, period,
    rows, row_i, row_j, sums, domain, block_bond, block_move, ready, ready_row, shared, shared_row, parts, part,
    times, values, start, drive_row, drive_dof, drive_schedule, drive_rate, load_row, load_schedule, load_value,
    row_of, row_fixed, row_force, row_half, row_full, row_reaction, work, loss,
    rest, gauge_start, gauge_element, gauge_quantity, gauge_reduction, contacts, added, strain, records,
):  # fmt: skip
    """Find the acceleration of the present state where it is stale, and record the state."""
    apply_schedules(
        t0 + step * dt, dt, times, values, start, drive_row, drive_dof, drive_schedule, drive_rate,
        load_row, load_schedule, load_value, row_force, row_half, row_full,
    )  # fmt: skip
    apply_added(
        t0 + step * dt, dt, True, added, strain, times, values, start, pose, i, j, period, constants, shear, lever,
        integrity, work,
    )  # fmt: skip
    if stale:
        if contacts is not None:
            contact_loads(pose, motion, loss, period, 0.0, contacts)
        step_forces(
            pose, motion, acceleration, i, j, constants, same, shear, bending, lever, integrity, history, period,
            rows, row_i, row_j, sums, domain, block_bond, block_move, ready, ready_row, shared, shared_row, parts,
            part,
            row_of, row_fixed, row_force, row_half, row_full, row_reaction, work,
            # not the literal False, for which all of it would be compiled once more
            0.0, 0.0, 0.0, 0.0, gamma, loss, not stale, added,
        )  # fmt: skip
    sample(
        t0 + step * dt, pose, motion, i, j, constants, shear, bending, lever, integrity, history, period,
        rest, gauge_start, gauge_element, gauge_quantity, gauge_reduction, row_of, row_fixed,
        row_reaction, row_force, work, loss, contacts, records[0],
    )  # fmt: skip


@kernel(parallel=False)
def advance(
    step, steps, every, t0, dt, moved, finish, begin, extra, gamma,
    pose, motion, acceleration, i, j, constants, same, shear, bending, lever, integrity, history, period,
    rows, row_i, row_j, sums, domain, block_bond, block_move, ready, ready_row, shared, shared_row, parts, part,
    times, values, start, drive_row, drive_dof, drive_schedule, drive_rate, load_row, load_schedule, load_value,
    row_of, row_fixed, row_force, row_half, row_full, row_reaction, work, loss,
    rest, gauge_start, gauge_element, gauge_quantity, gauge_reduction, contacts, added, strain, budget, records,
):  # fmt: skip
    """Go from `step` to `step + steps`; write a record whenever the step number is a multiple of `every`.

    `acceleration` holds that of the present state on entry and on return. Between samples the end of one
    step and the start of the next are fused into one pass over the elements. The two passes go block by block, and
    an element moves when the last of its bonds has been seen, so that forces are gathered while still in the cache.

    Where there are `contacts` and their list is out of date, it comes back in the middle of a step, the elements
    moved and the forces not yet known; it goes on there when called again with a new list and `moved`.

    Returns:
        (steps done, records written, bonds turned wide at most, bonds lost, what `guard` says, whether the list of
        contacts is out of date).
    """
    threaded = len(i) >= SERIAL_BONDS
    if not moved:
        apply_added(
            t0 + step * dt, dt, True, added, strain, times, values, start, pose, i, j, period, constants, shear,
            lever, integrity, work,
        )  # fmt: skip
    done = 0
    written = 0
    wide = 0
    lost = 0
    sick = FINE
    paused = True
    while done < steps:
        if paused and not moved:
            t = t0 + (step + done) * dt
            apply_schedules(
                t, dt, times, values, start, drive_row, drive_dof, drive_schedule, drive_rate,
                load_row, load_schedule, load_value, row_force, row_half, row_full,
            )  # fmt: skip
            if threaded:
                open_step(
                    pose, motion, acceleration, row_of, row_fixed, row_force, row_half, row_reaction, work,
                    dt, begin, extra, added,
                )  # fmt: skip
            else:
                open_step_serial(
                    pose, motion, acceleration, row_of, row_fixed, row_force, row_half, row_reaction, work,
                    dt, begin, extra, added,
                )  # fmt: skip
        if contacts is not None:
            if not moved:
                advance_walls(t0 + (step + done) * dt, dt, contacts)
                if outdated(pose, contacts):
                    return done, written, wide, lost, sick, True
            contact_loads(pose, motion, loss, period, dt, contacts)
        moved = False
        done += 1
        now = step + done
        t = t0 + now * dt
        sampled = every > 0 and now % every == 0
        paused = sampled or done == steps or now % GUARD_INTERVAL == 0
        apply_schedules(
            t, dt, times, values, start, drive_row, drive_dof, drive_schedule, drive_rate,
            load_row, load_schedule, load_value, row_force, row_half, row_full,
        )  # fmt: skip
        apply_added(
            t, dt, False, added, strain, times, values, start, pose, i, j, period, constants, shear, lever,
            integrity, work,
        )  # fmt: skip
        step_forces(
            pose, motion, acceleration, i, j, constants, same, shear, bending, lever, integrity, history, period,
            rows, row_i, row_j, sums, domain, block_bond, block_move, ready, ready_row, shared, shared_row, parts,
            part,
            row_of, row_fixed, row_force, row_half, row_full, row_reaction, work,
            dt, finish, begin, extra, gamma, loss, not paused, added,
        )  # fmt: skip
        if now % GUARD_INTERVAL == 0 or done == steps:
            turned, lost, broken = rotation_guard(pose, i, j, constants, integrity, period)
            wide = max(wide, turned)
            sick = NOT_FINITE if broken else guard(motion, work, contacts, budget)
            if lost > 0 or sick != FINE:
                break
        if sampled:
            sample(
                t, pose, motion, i, j, constants, shear, bending, lever, integrity, history, period,
                rest, gauge_start, gauge_element, gauge_quantity, gauge_reduction, row_of, row_fixed,
                row_reaction, row_force, work, loss, contacts, records[written],
            )  # fmt: skip
            written += 1
    return done, written, wide, lost, sick, False
