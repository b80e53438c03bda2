"""A step over all bonds and elements, block by block, and on several threads domain by domain.

See `bondem.model.blocks` for how a step is cut, and why the cuts change no bit.
"""

import numpy as np

from bondem._compile import loop, prange
from bondem.kernels.beam_softening import begin_to_soften, soften_beams
from bondem.kernels.bond_pass import bond_loads
from bondem.kernels.breaking import break_bonds, let_go, lists
from bondem.kernels.cell_pass import facet_loads, gather_swelling, stress_cells, swell
from bondem.kernels.cell_strain import book_strains
from bondem.kernels.cell_stress import take_moments, take_shared_moments
from bondem.kernels.crack_pass import crack_before, crack_between
from bondem.kernels.dashpots import collect_dashpots, damp_bonds
from bondem.kernels.element_pass import collect_parts, move, move_held
from bondem.kernels.facet_breaking import break_facets, judge_facets
from bondem.kernels.grip_pass import hand_on, swell_grips
from bondem.kernels.incremental import incremental_loads
from bondem.kernels.judging import judge_block
from bondem.kernels.non_local import non_local_forces, non_local_loads
from bondem.kernels.pair_breaking import break_pairs, judge_pairs
from bondem.kernels.press_pass import book_presses


@loop(parallel=False)
def sweep(elements, bonds, same, history, cells, non_local, cut, rows, scheme, added, breaks, part):
    """A part of the step: bonds, sums, and the elements whose sums are complete.

    `history` is what bonds store in the incremental formulation, (6, m), or None; `cells` are facets and cells, whose
    stresses are known, or None; `non_local` is the table of the non-local law, whose forces are known, or None;
    `breaks` says when bonds break, or is None. `part` is the blocks first … last, and whether elements open the next
    step.
    """
    first, last, go_on = part
    waiting = 0
    if (cells is not None or non_local is not None) and breaks is not None:
        waiting = breaks.found.sum()  # facets, and bonds of the non-local law, are judged before
    for b in range(first, last):
        k0, k1 = cut.bond[b], cut.bond[b + 1]
        if cells is not None:  # decided when compiled
            facet_loads(elements.pose, bonds, cells, cells.moment, cut.sums, cut.row_i, cut.row_j, k0, k1)
            take_moments(cells.moment, cells.sums, cut.ready, cut.ready_row, cut.move[b], cut.move[b + 1])
        elif non_local is not None:
            non_local_loads(non_local, cut.sums, cut.row_i, cut.row_j, k0, k1)
        elif history is None:
            place = bond_loads(elements.pose, bonds, same, cut.sums, cut.row_i, cut.row_j, breaks, k0, k1)
            if breaks is not None:
                waiting += judge_block(elements.pose, bonds, breaks, b, k0, place)
        else:
            incremental_loads(elements, bonds, history, scheme.dt, cut.sums, cut.row_i, cut.row_j, k0, k1)
        damp_bonds(added, elements, bonds, cut.row_i, cut.row_j, k0, k1)
        span = cut.move[b], cut.held[b], cut.move[b + 1], cut.move[b]
        both = lists(cut.sums, added, breaks, cut.ready, cut.ready_row, span, waiting > 0)
        for n in range(2):
            element, row, e0, e1, e2, e3 = both[0] if n == 0 else both[1]
            move(elements, cut.sums, rows, scheme, added, go_on and n == 0, element, row, e0, e1)
            move_held(elements, cut.sums, rows, scheme, added, go_on and n == 0, element, row, e2, e3)


@loop(parallel=False)
def sweep_shared(elements, cells, cut, rows, scheme, added, breaks, go_on, first, last):
    """The shared elements first … last, when the bonds of all domains are done; those that own rows are the last."""
    collect_parts(cut.sums, cut.shared_row, cut.parts, cut.part, first, last)
    collect_dashpots(added, cut, first, last)
    if cells is not None:  # decided when compiled
        take_shared_moments(cells.moment, cells.sums, cut, first, last)
    held = min(max(cut.shared_held, first), last)
    waiting = False
    if breaks is not None:
        waiting = breaks.found.sum() > 0
    span = first, held, last, len(cut.ready) + first
    both = lists(cut.sums, added, breaks, cut.shared, cut.shared_row, span, waiting)
    for n in range(2):
        element, row, e0, e1, e2, e3 = both[0] if n == 0 else both[1]
        move(elements, cut.sums, rows, scheme, added, go_on and n == 0, element, row, e0, e1)
        move_held(elements, cut.sums, rows, scheme, added, go_on and n == 0, element, row, e2, e3)


@loop(parallel=False)
def swell_domain(pose, bonds, cells, breaks, cut, d):
    """What the facets of a domain do to V θ of their cells, and which are to be judged."""
    first, last = cut.bond[cut.domain[d]], cut.bond[cut.domain[d + 1]]
    place = swell(pose, bonds, cells, breaks, first, last)
    if breaks is not None:  # decided when compiled
        breaks.found[d] = place - first


@loop(parallel=True)
def swell_domains(pose, bonds, cells, breaks, cut):
    """Stresses of all cells now, each domain on a thread of its own."""
    count, n = len(cut.domain) - 1, len(pose)
    for both in range(2):
        if both == 1:
            gather_swelling(cells, cut.shared, cut.part)
        for d in prange(count):
            if both == 0:
                swell_domain(pose, bonds, cells, breaks, cut, np.int64(d))
            else:
                stress_cells(pose, cells, n * d // count, n * (d + 1) // count)


@loop(parallel=True)
def sweep_domains(elements, bonds, same, history, cells, non_local, cut, rows, scheme, added, breaks, go_on):
    """Forces of all bonds now, and what elements do with them: close the step, and open the next or not.

    Each domain is on a thread of its own; then each thread takes a part of the elements they share.
    """
    count, shared = len(cut.domain) - 1, len(cut.shared)
    for both in range(2):  # one launch in the code, as everything in it is compiled for each
        for d in prange(count):
            if both == 0:
                part = cut.domain[d], cut.domain[d + 1], go_on
                sweep(elements, bonds, same, history, cells, non_local, cut, rows, scheme, added, breaks, part)
            else:
                first, last = shared * d // count, shared * (d + 1) // count
                sweep_shared(elements, cells, cut, rows, scheme, added, breaks, go_on, first, last)


@loop(parallel=False)
def swell_body(elements, bonds, body, cut, rows, contacts, breaks):
    """Stresses of all cells now, what walls that hold some of them do, and which facets break."""
    pose, rest, cells, grips = elements.pose, elements.rest, body.cells, body.grips
    threaded = len(cut.domain) > 2
    crack_before(elements, bonds, body, rows, body.cracks, threaded)
    swell_grips(pose, rest, grips, cells.swelling)
    book_presses(pose, body.presses, rows.work)
    if not threaded:
        swell_domain(pose, bonds, cells, breaks, cut, 0)
        stress_cells(pose, cells, 0, len(pose))
    else:
        swell_domains(pose, bonds, cells, breaks, cut)
    crack_between(elements, bonds, cells, contacts, body.cracks, threaded)
    book_presses(pose, body.presses, rows.work)
    body.presses.came[:] = 0.0
    if len(grips.cell) > 0:
        hand_on(pose, rest, grips, rows)
    book_strains(pose, bonds, body, body.strain, rows.work)
    if breaks is not None:
        judge_facets(pose, bonds, cells, breaks)


@loop(parallel=False)
def sweep_all(elements, bonds, same, history, cells, non_local, cut, rows, scheme, added, breaks, go_on):
    """Forces of all bonds or facets, and what elements do with them."""
    if len(cut.domain) == 2:
        part = 0, len(cut.move) - 1, go_on
        sweep(elements, bonds, same, history, cells, non_local, cut, rows, scheme, added, breaks, part)
    else:
        sweep_domains(elements, bonds, same, history, cells, non_local, cut, rows, scheme, added, breaks, go_on)


@loop(parallel=False)
def all_forces(run, same, history, body, non_local, scheme, added, contacts, breaks, soft, go_on):
    """A step over everything, on one thread or on as many as there are domains.

    The forces of contacts are known, but for those of pairs whose bonds break now. `soft` is the table of beams that
    soften, or None.
    """
    elements, bonds, cut, rows = run.elements, run.bonds, run.cut, run.rows
    if body is not None:  # decided when compiled
        swell_body(elements, bonds, body, cut, rows, contacts, breaks)
        sweep_all(elements, bonds, same, history, body.cells, None, cut, rows, scheme, added, breaks, go_on)
        if breaks is not None:
            break_facets(elements, bonds, body, cut.sums, rows, added, contacts, breaks)
    else:
        if soft is not None:
            soften_beams(elements, bonds, contacts, breaks, soft, len(cut.domain) > 2)
        if non_local is not None:
            non_local_forces(elements, bonds, non_local, scheme.dt, contacts, cut)
            if breaks is not None:
                judge_pairs(bonds, non_local, breaks, cut)
        sweep_all(elements, bonds, same, history, None, non_local, cut, rows, scheme, added, breaks, go_on)
        if soft is not None:
            begin_to_soften(breaks, soft)
        elif breaks is not None and non_local is not None:
            break_pairs(elements, bonds, non_local, cut.sums, added, contacts, breaks)
        elif breaks is not None:
            break_bonds(elements, bonds, cut.sums, added, contacts, breaks)
    if breaks is not None and soft is None:
        let_go(elements, cut.sums, rows, scheme, added, breaks, go_on)
