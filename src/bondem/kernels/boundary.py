"""Prescribed motion, loads and strains, updated once a step by one thread.

Motion and loads of faces are a few rows. What only some models have on all their elements or bonds is in `Added` and
`Strain`; where these are None it is decided when compiled, and costs nothing.
"""

import math

from bondem._compile import device, loop
from bondem.kernels.bond_pass import branch
from bondem.kernels.couples import add_couple
from bondem.laws.rotations import rotate


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


@device
def value_at(schedules, s, t):
    """Value of schedule s at time t."""
    return interpolate(schedules.times, schedules.values, schedules.start[s], schedules.start[s + 1], t)


@loop(parallel=False)
def _turned_load(force, load, amplitude, x):
    """Add a load that has turned with its element, whose row of the pose is x."""
    for d in (0, 3):
        a, b, c = rotate(x[4], x[5], x[6], x[7], load[d], load[d + 1], load[d + 2])
        force[d] += amplitude * a
        force[d + 1] += amplitude * b
        force[d + 2] += amplitude * c


@loop(parallel=False)
def apply_schedules(t, dt, schedules, rows, pose):
    """Set the rows' forces at time t, their velocities at t, and those over the step from t to t + dt."""
    rows.force[:] = 0.0
    turning = len(schedules.load_turns) > 0
    for e in range(len(schedules.load_row)):
        amplitude = value_at(schedules, schedules.load_schedule[e], t)
        if turning and schedules.load_turns[e] >= 0:
            x = pose[schedules.load_turns[e]]
            _turned_load(rows.force[schedules.load_row[e]], schedules.load_value[e], amplitude, x)
            continue
        for d in range(6):
            rows.force[schedules.load_row[e], d] += amplitude * schedules.load_value[e, d]
    for c in range(len(schedules.couples.schedule)):
        amplitude = value_at(schedules, schedules.couples.schedule[c], t)
        add_couple(schedules.couples, c, amplitude, pose, rows.force)
    for e in range(len(schedules.drive_row)):
        s = schedules.drive_schedule[e]
        r, d = schedules.drive_row[e], schedules.drive_dof[e]
        if schedules.drive_rate[e]:
            rows.full[r, d] = value_at(schedules, s, t)
            rows.half[r, d] = value_at(schedules, s, t + 0.5 * dt)
        else:
            rows.half[r, d] = (value_at(schedules, s, t + dt) - value_at(schedules, s, t)) / dt
            rows.full[r, d] = rows.half[r, d]


@loop(parallel=False)
def pull_bodies(t, added, schedules):
    """Bring body forces to time t: groups may be as many as elements, and are left alone where nothing changes."""
    changed = False
    for b in range(len(added.schedule)):
        amplitude = value_at(schedules, added.schedule[b], t)
        changed |= amplitude != added.factor[b]
        added.factor[b] = amplitude
    if not changed:
        return
    added.present[:] = 0.0
    for b in range(len(added.schedule)):
        amplitude = added.factor[b]
        for g in range(len(added.present)):
            for d in range(3):
                added.present[g, d] += added.member[g, b] * amplitude * added.pull[b, d]


@loop(parallel=False)
def strain_bonds(t, dt, first, strain, schedules, pose, bonds, work):
    """Set rest lengths L (1 + ε*) of time t, and add up their work: the trapezoid of ∂U/∂ε* over dε*.

    Nothing is done in steps in which no strain changes. ∂U/∂ε* is also found one step before a change, because the
    trapezoid needs it.
    """
    factor = strain.factor
    changed = first
    needed = first
    for g in range(len(strain.schedule)):
        s = strain.schedule[g]
        factor[1, g] = value_at(schedules, s, t)
        changed |= factor[1, g] != factor[0, g]
        needed |= factor[1, g] != value_at(schedules, s, t + dt)
    if not (changed or needed):
        return
    for g in range(len(strain.schedule)):
        factor[3, g] = 0.0
    for e in range(len(strain.bond)):
        k = strain.bond[e]
        stretch = strain.still[e]
        for g in range(len(strain.schedule)):
            stretch += factor[1, g] * strain.part[g, e]
        if changed:
            bonds.length[k] = strain.length[e] * stretch
            bonds.ks[k] = strain.shear[e] / (stretch * stretch)
            bonds.lever[k] = strain.lever[e] * stretch
        dx, dy, dz = branch(pose, bonds.i[k], bonds.j[k], bonds.period)
        length = math.sqrt(dx * dx + dy * dy + dz * dz)
        tension = bonds.integrity[k] * bonds.kn[k] * (length - bonds.length[k])
        for g in range(len(strain.schedule)):
            factor[3, g] -= tension * strain.length[e] * strain.part[g, e]
    for g in range(len(strain.schedule)):
        if not first:
            step = factor[1, g] - factor[0, g]
            work[strain.place] += 0.5 * (factor[2, g] + factor[3, g]) * step
        factor[0, g] = factor[1, g]
        factor[2, g] = factor[3, g]


@loop(parallel=False)
def set_boundary(t, dt, first, schedules, rows, pose, bonds, added, strain):
    """Loads, drives, body forces and strains of time t; `first` where it is not reached by a step."""
    apply_schedules(t, dt, schedules, rows, pose)
    if added is not None:
        pull_bodies(t, added, schedules)
    if strain is not None:
        strain_bonds(t, dt, first, strain, schedules, pose, bonds, rows.work)
