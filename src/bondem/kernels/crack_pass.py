"""Cracks in a step: facets that have begun to soften, which are treated one by one outside of the lanes.

A facet that has begun to crack leaves the loops over facets (there its integrity is 0) and stands in a list, in the
order in which cracks began. Between the two passes over the facets the stresses of their cells are found anew, as
cracks open or press; then integrities fall, and forces are handed to the elements with those of contacts. A crack
that is open and does not soften rests: it is a facet of less stiffness among the others, which is the same to
rounding. What is done with a crack or a cell by itself is done on all threads, the rest by one, in the order of the
list: no bit depends on threads. See `bondem.laws.softening`.
"""

import numpy as np

from bondem._compile import loop, prange
from bondem.kernels.cell_stress import cell_stresses, surface_stresses
from bondem.kernels.crack_list import begin_cracks, list_cracks
from bondem.kernels.crack_onset import judge_body
from bondem.kernels.crack_states import (
    begin_bases,
    leave_cracks,
    look_at_rest,
    measure_cracks,
    relax_cells,
    soften,
    wake_cracks,
)
from bondem.kernels.crack_tables import AT_REST, CELLS, CRACKS, TREATED_ONES
from bondem.kernels.cracking import add_crack_moments, clear_cracks, crack_forces, hand_out_cracks, log_cracks

# Below this many cracks launching threads costs more than the loop.
_SERIAL = 500
# Cracks of one portion of work.
_PORTION = 250
# What is done to the cracks and cells of a portion.
_MOMENTS, _MEASURE, _RELAX, _RELAX_AGAIN, _REST, _SOFTEN, _FORCES, _CHANGES, _SUMS = range(9)


@loop(parallel=False)
def _portion(kind, elements, bonds, cells, cracks, share, count):
    """What `kind` says, of share 0 … count - 1 of the cracks or cells of a list."""
    sizes, listed = cracks.sizes, CELLS
    if kind == _REST:
        listed = AT_REST
    elif kind in (_MEASURE, _SOFTEN, _FORCES, _CHANGES):
        listed = TREATED_ONES
    first, last = sizes[listed] * share // count, sizes[listed] * (share + 1) // count
    pose, n = elements.pose, len(elements.pose)
    a, v = np.empty((3, 3)), np.empty((3, 3))
    if kind == _MOMENTS:
        add_crack_moments(pose, cells, cracks, first, last)
    elif kind == _MEASURE:
        measure_cracks(pose, bonds, cells, cracks, first, last)
        begin_bases(pose, cells, cracks, n * share // count, n * (share + 1) // count)
    elif kind in (_RELAX, _RELAX_AGAIN):
        relax_cells(pose, cells, cracks, kind == _RELAX_AGAIN, first, last)
    elif kind == _REST:
        look_at_rest(pose, bonds, cells, cracks, a, v, first, last)
    elif kind == _SOFTEN:
        soften(pose, bonds, cells, cracks, a, v, first, last)
    elif kind == _SUMS:
        hand_out_cracks(cracks, elements.loss, first, last)
    else:
        crack_forces(pose, bonds, cells, cracks, kind == _CHANGES, first, last)


@loop(parallel=True)
def _portions(kind, elements, bonds, cells, cracks, count):
    for d in prange(count):
        _portion(kind, elements, bonds, cells, cracks, d, count)


@loop(parallel=False)
def _all(kind, elements, bonds, cells, cracks, threaded):
    """The same of all, on all threads where these are many."""
    many = cracks.sizes[TREATED_ONES] + cracks.sizes[AT_REST]
    if threaded and many >= _SERIAL:
        _portions(kind, elements, bonds, cells, cracks, many // _PORTION)
    else:
        _portion(kind, elements, bonds, cells, cracks, 0, 1)


@loop(parallel=False)
def clear_crack_loads(table):
    """Take off what cracks did a step ago, where there are any."""
    if table is not None:  # decided when compiled
        clear_cracks(table.facets)


@loop(parallel=False)
def stresses_now(pose, body, table):
    """Stresses of all cells from the forces they bear now, as a run begins: its first record has their energies."""
    cells, cracks, moment = body.cells, table.facets, body.cells.moment
    kept = moment.copy()  # a step adds the forces of cracks itself
    add_crack_moments(pose, cells, cracks, 0, cracks.sizes[CELLS])
    cell_stresses(moment, table.stress, 0, len(pose))
    surface_stresses(pose, body.grips, body.presses, table.stress, table.flow.pressed)
    moment[:, :] = kept


@loop(parallel=False)
def crack_before(elements, bonds, body, rows, table, threaded):
    """As a step begins: cells yield, and facets begin to crack."""
    if table is not None:  # decided when compiled
        if table.facets.now[1] >= 0.0:
            _all(_MOMENTS, elements, bonds, body.cells, table.facets, threaded)
            if judge_body(elements.pose, bonds, body, rows.work, table, threaded):
                begin_cracks(elements.pose, bonds, body.cells, table.stress, table.onset, table.facets)


@loop(parallel=False)
def crack_between(elements, bonds, cells, contacts, table, threaded):
    """Between the passes over the facets: stresses of cells with cracks, and what these do."""
    if table is not None:  # decided when compiled
        cracks = table.facets
        if cracks.sizes[CRACKS] > 0:
            change = cracks.now[1] >= 0.0
            list_cracks(bonds, cracks)
            _all(_MEASURE, elements, bonds, cells, cracks, threaded)
            _all(_RELAX, elements, bonds, cells, cracks, threaded)
            if change:
                _all(_REST, elements, bonds, cells, cracks, threaded)
                if wake_cracks(elements.pose, bonds, cells, contacts, cracks):
                    list_cracks(bonds, cracks)
                    _all(_RELAX_AGAIN, elements, bonds, cells, cracks, threaded)
                _all(_SOFTEN, elements, bonds, cells, cracks, threaded)
                if leave_cracks(elements.pose, bonds, cells, contacts, cracks):
                    _all(_RELAX_AGAIN, elements, bonds, cells, cracks, threaded)
            _all(_CHANGES if change else _FORCES, elements, bonds, cells, cracks, threaded)
            _all(_SUMS, elements, bonds, cells, cracks, threaded)
            if change:
                log_cracks(elements.pose, bonds, cracks)
