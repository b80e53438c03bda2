"""A record of the history: time, energies, work and gauges."""

import math

import numpy as np

from bondem._compile import device, loop
from bondem.kernels.beam_softening import pressed_energy
from bondem.kernels.bond_pass import bond_energies
from bondem.kernels.cell_energies import cell_energies
from bondem.kernels.contact_pass import contact_energy
from bondem.kernels.cracking import dissipated
from bondem.kernels.incremental import incremental_energies
from bondem.kernels.non_local import non_local_energies
from bondem.kernels.soft_tables import BEGUN
from bondem.kernels.tables import (
    BENDING,
    CONTACT,
    DAMPED,
    FIXED_COLUMNS,
    FRACTURE,
    FRICTION,
    INVERSE_INERTIA,
    INVERSE_MASS,
    LARGEST,
    LOSS,
    MEAN,
    NON_LOCAL,
    NORMAL,
    OF_DISPLACEMENT,
    OF_ROTATION,
    OF_SPIN,
    OF_VELOCITY,
    PLASTIC,
    QUATERNION,
    ROTATION,
    RUBBED,
    SHEAR,
    SPIN,
    TIME,
    TRANSLATION,
    TWISTING,
    WALL_DISPLACEMENT,
    WALL_GROWTH,
    WALL_VELOCITY,
    WORK,
)
from bondem.kernels.walls import FORCE, GROWTH, RATE
from bondem.kernels.walls import NORMAL as NORMAL_FORCE
from bondem.kernels.walls import WORK as WALL_WORK


@device
def rotation_component(w, x, y, z, d):
    """Component d of the rotation vector of a unit quaternion [rad], of length at most π."""
    sine = math.sqrt(x * x + y * y + z * z)
    part = x if d == 0 else (y if d == 1 else z)
    if sine < 1e-12:
        return 2.0 * part
    return 2.0 * math.atan2(sine, abs(w)) * part / sine * (1.0 if w >= 0.0 else -1.0)


@device
def kinetic_energies(motion, p):
    """Of the translation and of the rotation of an element [J]."""
    v2 = motion[p, 0] ** 2 + motion[p, 1] ** 2 + motion[p, 2] ** 2
    w2 = motion[p, SPIN] ** 2 + motion[p, SPIN + 1] ** 2 + motion[p, SPIN + 2] ** 2
    return 0.5 * v2 / motion[p, INVERSE_MASS], 0.5 * w2 / motion[p, INVERSE_INERTIA]


@loop(parallel=False)
def energies(elements, bonds, work, history, body, non_local, record):
    """Kinetic and elastic energy, work and losses, without those of contacts."""
    translation = rotation = damped = rubbed = total = taken = 0.0
    for p in range(len(elements.pose)):
        along, about = kinetic_energies(elements.motion, p)
        translation += along
        rotation += about
        damped += elements.loss[p, DAMPED]
        rubbed += elements.loss[p, RUBBED]
    if body is not None:  # decided when compiled
        parts = cell_energies(elements.pose, elements.rest, bonds, body.cells, body.grips, body.cracks)
    elif non_local is not None:
        springs = non_local_energies(elements.pose, bonds, non_local)
        parts = springs[0], springs[1], 0.0, 0.0
        taken = springs[2]
    elif history is None:
        parts = bond_energies(elements.pose, bonds)
    else:
        parts = incremental_energies(elements.pose, bonds, history)
    for r in range(len(work)):
        total += work[r]
    record[TRANSLATION], record[ROTATION] = translation, rotation
    record[NORMAL], record[SHEAR], record[BENDING], record[TWISTING] = parts
    record[CONTACT], record[WORK], record[LOSS], record[FRICTION] = 0.0, total, damped, rubbed
    record[NON_LOCAL], record[FRACTURE], record[PLASTIC] = taken, 0.0, 0.0


@loop(parallel=False)
def of_contacts(pose, period, contacts, gauges, record):
    """Energy of the contacts, work of the walls, and what gauges read of these."""
    walls = contacts.walls
    record[CONTACT] = contact_energy(pose, period, contacts)
    for w in range(len(walls)):
        record[WORK] += walls[w, WALL_WORK]
    for g in range(len(gauges.quantity)):
        quantity, column = gauges.quantity[g], FIXED_COLUMNS + 3 * g
        if quantity >= WALL_DISPLACEMENT:
            wall = walls[gauges.element[gauges.start[g]]]
            first = FORCE
            if quantity == WALL_DISPLACEMENT:
                first = 0
            elif quantity == WALL_VELOCITY:
                first = RATE
            for d in range(3):
                record[column + d] = wall[first + d]
            if quantity == WALL_GROWTH:
                record[column], record[column + 1] = wall[GROWTH], wall[FORCE + 3]
                record[column + 2] = wall[NORMAL_FORCE]


@device
def _element_value(pose, motion, rest, rows, quantity, p, d):
    """Component d of what a gauge reads of an element."""
    if quantity == OF_DISPLACEMENT:
        return pose[p, d] - rest[p, d]
    if quantity == OF_VELOCITY:
        return motion[p, d]
    if quantity == OF_ROTATION:
        q = QUATERNION
        return rotation_component(pose[p, q], pose[p, q + 1], pose[p, q + 2], pose[p, q + 3], d)
    if quantity == OF_SPIN:
        return motion[p, SPIN + d]
    r = rows.of[p]
    if r < 0:
        return 0.0
    wall = rows.grip[r, d] if len(rows.grip) > 0 else 0.0
    return wall + (rows.reaction[r, d] if rows.fixed[r, d] else rows.force[r, d])


@loop(parallel=False)
def gauged(elements, rows, gauges, record):
    """Three components of each gauge of elements."""
    pose, motion, rest = elements.pose, elements.motion, elements.rest
    for g in range(len(gauges.quantity)):
        quantity, reduction = gauges.quantity[g], gauges.reduction[g]
        if quantity >= WALL_DISPLACEMENT:
            continue
        first, last = gauges.start[g], gauges.start[g + 1]
        for d in range(3):
            value = -np.inf if reduction == LARGEST else 0.0
            for e in range(first, last):
                x = _element_value(pose, motion, rest, rows, quantity, gauges.element[e], d)
                value = max(value, abs(x)) if reduction == LARGEST else value + x
            record[FIXED_COLUMNS + 3 * g + d] = value / (last - first) if reduction == MEAN else value


@device
def _of_cracks(cracks, record):
    if cracks is not None:  # decided when compiled
        record[FRACTURE], record[PLASTIC] = dissipated(cracks)


@loop(parallel=False)
def sample(t, elements, bonds, rows, gauges, history, body, non_local, contacts, breaks, soft, record):
    """One row of the history."""
    record[TIME] = t
    energies(elements, bonds, rows.work, history, body, non_local, record)
    if contacts is not None:
        of_contacts(elements.pose, bonds.period, contacts, gauges, record)
    if breaks is not None:
        record[FRACTURE] = breaks.released[0]
    if soft is not None:
        record[NORMAL] += pressed_energy(elements.pose, bonds, soft.row, soft.sizes[BEGUN], soft.handed)
    if body is not None:
        _of_cracks(body.cracks, record)
    gauged(elements, rows, gauges, record)
