"""Many steps in one compiled call: bonds, elements, boundary and sampling."""

import numpy as np

from bondem._compile import device, kernel, loop
from bondem.kernels.boundary import apply_schedules, set_boundary
from bondem.kernels.cell_strain import strain_body
from bondem.kernels.contact_pass import contact_loads, outdated
from bondem.kernels.element_pass import open_step, open_step_serial
from bondem.kernels.grip_pass import place_walls
from bondem.kernels.present import clear_loads, look
from bondem.kernels.press_pass import press
from bondem.kernels.sample import kinetic_energies, sample
from bondem.kernels.sweep import all_forces
from bondem.kernels.turn_guard import rotation_guard
from bondem.kernels.walls import WORK as WALL_WORK
from bondem.kernels.walls import move_walls

# Below this many bonds launching threads costs more than the loop.
SERIAL_BONDS = 2000
# Steps between two looks at the relative rotations, for numbers that are not finite, and at the energy.
GUARD_INTERVAL = 100
# What that look finds.
FINE, NOT_FINITE, RUNAWAY = range(3)
# Kinetic energy over all there ever was from which on a run is taken for unstable. It never exceeds one but by the
# error of the scheme, at a frequency next to the critical one at most 1 / (1 - (ω dt / ω dt critical)²); and what
# grows does so by orders of magnitude in a hundred steps.
BEYOND = 1000.0


@loop(parallel=False)
def guard(motion, work, contacts, budget):
    """Whether the motion is finite, and its energy [J] no more than what can have come in.

    `budget` is the energy at the start and the most that loads, drives and walls have done since, as the sum of the
    sizes of all their parts; the latter is brought up to date.
    """
    kinetic = 0.0
    for p in range(len(motion)):
        along, about = kinetic_energies(motion, p)
        kinetic += along + about
    supplied = 0.0
    for r in range(len(work)):
        supplied += abs(work[r])
    if contacts is not None:
        for w in range(len(contacts.walls)):
            supplied += abs(contacts.walls[w, WALL_WORK])
    if not (kinetic < np.inf and supplied < np.inf):
        return NOT_FINITE
    budget[1] = max(budget[1], supplied)
    return RUNAWAY if kinetic > BEYOND * (budget[0] + budget[1]) else FINE


@loop(parallel=False)
def move_holds(t, dt, schedules, body):
    """Bring walls that hold cells, tractions on them and their stress-free strains to time t, where there are any."""
    if body is not None:  # decided when compiled
        place_walls(t, body.grips)
        press(t, schedules, body.presses, body.cells.given)
        strain_body(t, dt, False, schedules, body, body.strain)


@device
def set_clock(breaks, t, step):
    """Tell bonds that break when they do, where there are any."""
    if breaks is not None:
        breaks.now[0], breaks.now[1] = t, step


@device
def _set_crack_clock(cracks, t, step):
    if cracks is not None:  # decided when compiled
        cracks.facets.now[0], cracks.facets.now[1] = t, step


@loop(parallel=False)
def set_body_clock(body, t, step):
    """The same for cracks of a body of cells."""
    if body is not None:
        _set_crack_clock(body.cracks, t, step)


@kernel(parallel=False)
def advance(span, scheme, run, law, contacts, added, strain, breaks, records):
    """Take the steps of `span`; write a record whenever the step number is a multiple of its `every`.

    `law` is what forces come from: what all bonds share, what bonds store, the tables of a body of cells, of the
    non-local law and of beams that soften, each or None. `breaks` says when bonds break, or is None where none do.

    The acceleration is that of the present state on entry and on return. Between samples the end of one step and the
    start of the next are fused into one pass over the elements. The two passes go block by block, and an element
    moves when the last of its bonds has been seen, so that forces are gathered while still in the cache.

    Where `span` looks, no step is taken, and the present is recorded (`look`). Both are one function, as forces are
    most of its machine code.

    Where there are `contacts` and their list is out of date, it comes back in the middle of a step, the elements
    moved and the forces not yet known; it goes on there when called again with a new list and `moved`.

    Returns:
        (steps done, records written, bonds turned wide at most, bonds lost, what `guard` says, whether the list of
        contacts is out of date).
    """
    elements, bonds, rows, schedules = run.elements, run.bonds, run.rows, run.schedules
    same, history, body, non_local, soft = law
    start, dt = scheme.origin + span.step * scheme.dt, scheme.dt
    if span.looks:
        look(start, span.stale, scheme, run, law, contacts, added, strain, breaks, records[0])
        return 0, 1, 0, 0, FINE, False
    threaded = bonds.m >= SERIAL_BONDS
    done = written = wide = lost = 0
    sick, paused, moved = FINE, True, span.moved
    if not moved:
        set_boundary(start, dt, True, schedules, rows, elements.pose, bonds, added, strain)
    while done < span.steps:
        t = scheme.origin + (span.step + done) * dt
        if paused and not moved:
            apply_schedules(t, dt, schedules, rows, elements.pose)
            if threaded:
                open_step(elements, rows, scheme, added)
            else:
                open_step_serial(elements, rows, scheme, added)
        if contacts is not None:
            if not moved:
                move_walls(t, dt, contacts)
                if outdated(elements.pose, contacts):
                    return done, written, wide, lost, sick, True
        clear_loads(bonds, body, soft)
        if contacts is not None:
            contact_loads(elements, bonds.period, dt, contacts, len(run.cut.domain) > 2)
        moved = False
        done += 1
        now = span.step + done
        t = scheme.origin + now * dt
        sampled = span.every > 0 and now % span.every == 0
        looked = now % GUARD_INTERVAL == 0 or done == span.steps
        paused = sampled or looked
        set_boundary(t, dt, False, schedules, rows, elements.pose, bonds, added, strain)
        move_holds(t, dt, schedules, body)
        set_clock(breaks, t, now)
        set_body_clock(body, t, now)
        all_forces(run, same, history, body, non_local, scheme, added, contacts, breaks, soft, not paused)
        if looked:
            turned, lost, broken = rotation_guard(elements.pose, bonds, body)
            wide = max(wide, turned)
            sick = NOT_FINITE if broken else guard(elements.motion, rows.work, contacts, run.budget)
            if lost > 0 or sick != FINE:
                break
        if sampled:
            record = records[written]
            sample(t, elements, bonds, rows, run.gauges, history, body, non_local, contacts, breaks, soft, record)
            written += 1
    return done, written, wide, lost, sick, False
