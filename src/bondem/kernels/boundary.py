"""Prescribed motion and loads, updated once a step by one thread.

Motion and loads of faces are a few rows. What only some models have on all their elements or bonds is in `Added`;
where that is None it is decided when compiled, and costs nothing.
"""

import math
from typing import NamedTuple

import numpy as np

from bondem._compile import device, kernel
from bondem.kernels.bond_pass import branch


class Added(NamedTuple):
    """What only some models have; a part that a model does not have is empty.

    Flat and without None inside, because threads take no other tuples.
    """

    contact: np.ndarray  #: force and torque of all contacts on each element [N, N·m], (n, 6)
    group: np.ndarray  #: of each element: those of one group have the same body forces, (n,)
    member: np.ndarray  #: which body forces act on a group, 0 or 1, (g, b)
    pull: np.ndarray  #: their accelerations [m/s²], (b, 3)
    schedule: np.ndarray  #: and schedules, (b,)
    present: np.ndarray  #: acceleration of each group now [m/s²], (g, 3)
    place: int  #: of the first element in the list of works
    absorbing: np.ndarray  #: dashpots of each row, xx, yy, zz, xy, xz, yz [N·s/m], (r, 6)
    alpha: float  #: of mass damping [1/s]
    dashpot: np.ndarray  #: of each bond: cn, cs [N·s/m], cb, ct [N·m·s], (4, m)
    share: np.ndarray  #: where the contact point divides a bond, from i [-], (m,)
    dashed: np.ndarray  #: dashpots' force and torque on each element, and further rows as of the bonds, (…, 8)
    viscous: bool  #: whether there are any dashpots or mass damping


class Strain(NamedTuple):
    """Stress-free strains that change in time; e bonds, g strains."""

    schedule: np.ndarray  #: (g,)
    bond: np.ndarray  #: uint32, (e,)
    part: np.ndarray  #: strain of each bond at factor 1 [-], (g, e)
    still: np.ndarray  #: 1 and what does not change [-], (e,)
    length: np.ndarray  #: L [m], (e,)
    shear: np.ndarray  #: ks [N/m], (e,)
    lever: np.ndarray  #: a [m], (e,)
    factor: np.ndarray  #: rows: present factors, those to come, energy by factor [J] a step ago and now, (4, g)
    place: int  #: in the list of works


@device
def interpolate(times, values, first, last, t):
    """Value of a piecewise linear schedule at time t, constant beyond its ends; of a jump, the later value."""
    if t < times[first]:
        return values[first]
    k = first
    while k + 1 < last and times[k + 1] <= t:
        k += 1
    if k + 1 >= last:
        return values[last - 1]
    return values[k] + (values[k + 1] - values[k]) * ((t - times[k]) / (times[k + 1] - times[k]))


@kernel(parallel=False)
def apply_schedules(
    t, dt, times, values, start, drive_row, drive_dof, drive_schedule, drive_rate,
    load_row, load_schedule, load_value, row_force, row_half, row_full,
):  # fmt: skip
    """Set the rows' forces at time t, their velocities at t, and those over the step from t to t + dt."""
    row_force[:] = 0.0
    for e in range(len(load_row)):
        s = load_schedule[e]
        amplitude = interpolate(times, values, start[s], start[s + 1], t)
        for d in range(6):
            row_force[load_row[e], d] += amplitude * load_value[e, d]
    for e in range(len(drive_row)):
        s = drive_schedule[e]
        r, d = drive_row[e], drive_dof[e]
        if drive_rate[e]:
            row_full[r, d] = interpolate(times, values, start[s], start[s + 1], t)
            row_half[r, d] = interpolate(times, values, start[s], start[s + 1], t + 0.5 * dt)
        else:
            now = interpolate(times, values, start[s], start[s + 1], t)
            row_half[r, d] = (interpolate(times, values, start[s], start[s + 1], t + dt) - now) / dt
            row_full[r, d] = row_half[r, d]


@device
def apply_added(
    t, dt, first, added, strain, times, values, start, pose, i, j, period, constants, shear, lever, integrity, work
):  # fmt: skip
    """Bring body forces and stress-free strains to time t; `first` where it is not reached by a step."""
    if added is not None:
        added.present[:] = 0.0
        for b in range(len(added.schedule)):
            s = added.schedule[b]
            amplitude = interpolate(times, values, start[s], start[s + 1], t)
            for g in range(len(added.present)):
                for d in range(3):
                    added.present[g, d] += added.member[g, b] * amplitude * added.pull[b, d]
    if strain is not None:
        strain_bonds(
            t, dt, first, strain, times, values, start, pose, i, j, period, constants, shear, lever, integrity, work
        )


@kernel(parallel=False)
def strain_bonds(
    t, dt, first, strain, times, values, start, pose, i, j, period, constants, shear, lever, integrity, work
):  # fmt: skip
    """Set rest lengths L (1 + ε*) of time t, and add up their work: the trapezoid of ∂U/∂ε* over dε*.

    Nothing is done in steps in which no strain changes. ∂U/∂ε* is also found one step before a change, because the
    trapezoid needs it.
    """
    changed = first
    needed = first
    for g in range(len(strain.schedule)):
        s = strain.schedule[g]
        strain.factor[1, g] = interpolate(times, values, start[s], start[s + 1], t)
        changed |= strain.factor[1, g] != strain.factor[0, g]
        needed |= strain.factor[1, g] != interpolate(times, values, start[s], start[s + 1], t + dt)
    if not (changed or needed):
        return
    for g in range(len(strain.schedule)):
        strain.factor[3, g] = 0.0
    for e in range(len(strain.bond)):
        k = strain.bond[e]
        stretch = strain.still[e]
        for g in range(len(strain.schedule)):
            stretch += strain.factor[1, g] * strain.part[g, e]
        if changed:
            constants[3, k] = strain.length[e] * stretch
            shear[k] = strain.shear[e] / (stretch * stretch)
            lever[k] = strain.lever[e] * stretch
        dx, dy, dz = branch(pose, i[k], j[k], period)
        tension = integrity[k] * constants[4, k] * (math.sqrt(dx * dx + dy * dy + dz * dz) - constants[3, k])
        for g in range(len(strain.schedule)):
            strain.factor[3, g] -= tension * strain.length[e] * strain.part[g, e]
    for g in range(len(strain.schedule)):
        if not first:
            step = strain.factor[1, g] - strain.factor[0, g]
            work[strain.place] += 0.5 * (strain.factor[2, g] + strain.factor[3, g]) * step
        strain.factor[0, g] = strain.factor[1, g]
        strain.factor[2, g] = strain.factor[3, g]
