"""The present of a run: accelerations brought up to date, and a record."""

import numpy as np

from bondem._compile import loop
from bondem.kernels.beam_softening import clear_pushes
from bondem.kernels.boundary import set_boundary
from bondem.kernels.cell_strain import book_strains, strain_body
from bondem.kernels.contact_pass import contact_loads
from bondem.kernels.crack_pass import clear_crack_loads, stresses_now
from bondem.kernels.grip_pass import give, grip_loads, place_walls
from bondem.kernels.press_pass import press
from bondem.kernels.sample import sample
from bondem.kernels.sweep import all_forces
from bondem.kernels.tables import StepScheme

# Step number for which nothing breaks.
_NEVER = -1.0


@loop(parallel=False)
def clear_loads(bonds, body, soft):
    """Take off what cracks and beams that soften did a step ago, where there are any."""
    if body is not None:
        clear_crack_loads(body.cracks)
    clear_pushes(bonds, soft)


@loop(parallel=False)
def _hold(t, dt, schedules, elements, rows, body):
    """Walls that hold cells, tractions on them and their stress-free strains as they are at time t."""
    if body is not None:  # decided when compiled
        press(t, schedules, body.presses, body.cells.given)
        body.presses.came[:] = 0.0
        strain_body(t, dt, True, schedules, body, body.strain)
        if len(body.grips.cell) > 0:
            place_walls(t, body.grips)
            body.grips.came[:] = 0.0
            grip_loads(elements.pose, elements.rest, body.grips)
            give(body.grips, rows)


@loop(parallel=False)
def _book(elements, bonds, rows, body):
    if body is not None:
        book_strains(elements.pose, bonds, body, body.strain, rows.work)


@loop(parallel=False)
def _keep_facets_whole(cracks):
    if cracks is not None:
        cracks.facets.now[1] = _NEVER


@loop(parallel=False)
def _keep_whole(body, breaks):
    if body is not None:
        _keep_facets_whole(body.cracks)
    if breaks is not None:
        breaks.now[1] = _NEVER


@loop(parallel=False)
def _touch(elements, bonds, contacts, threaded):
    if contacts is not None:
        contacts.far[0] = np.inf  # elements may be anywhere by now
        contact_loads(elements, bonds.period, 0.0, contacts, threaded)


@loop(parallel=False)
def _evaluate(scheme, run, law, contacts, added, breaks):
    """Find the acceleration of the present state, in which nothing breaks."""
    same, history, body, non_local, soft = law
    _keep_whole(body, breaks)
    still = StepScheme(0.0, 0.0, 0.0, 0.0, scheme.gamma, scheme.origin)
    clear_loads(run.bonds, body, soft)
    _touch(run.elements, run.bonds, contacts, len(run.cut.domain) > 2)
    all_forces(run, same, history, body, non_local, still, added, contacts, breaks, soft, False)


@loop(parallel=False)
def _stress(pose, body, cracks):
    if cracks is not None:
        if cracks.flow.yielding:
            stresses_now(pose, body, cracks)


@loop(parallel=False)
def _stress_body(pose, body):
    if body is not None:
        _stress(pose, body, body.cracks)


@loop(parallel=False)
def look(t, stale, scheme, run, law, contacts, added, strain, breaks, record):
    """Bring the acceleration up to date, where it is `stale`, and record the present."""
    elements, bonds, rows, schedules = run.elements, run.bonds, run.rows, run.schedules
    _, history, body, non_local, soft = law
    set_boundary(t, scheme.dt, True, schedules, rows, elements.pose, bonds, added, strain)
    _hold(t, scheme.dt, schedules, elements, rows, body)
    if stale:
        _evaluate(scheme, run, law, contacts, added, breaks)
    else:
        _book(elements, bonds, rows, body)
    _stress_body(elements.pose, body)
    sample(t, elements, bonds, rows, run.gauges, history, body, non_local, contacts, breaks, soft, record)
