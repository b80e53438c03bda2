"""Walls that hold facets of cells: their motion, what they add to dilatation, and their forces on the cells.

A wall keeps its orientation, so that a gap is measured along fixed axes: with a point of the facet at x + R b,

    δ = P (wall - (x + R b - its reference)),   V θ += s·δ,   U = ½ k |δ|² + 2 v·H v

where P keeps the held axes and v is the vector part of q q₀*, the rotation of the cell since the wall holds it; see
`bondem.laws.cell_energy`. A wall that takes over a face which has moved begins where that is: `base` has the
displacement there and q₀.
"""

from bondem._compile import device, kernel, loop
from bondem.kernels.boundary import interpolate
from bondem.kernels.cell_pass import STRESS
from bondem.laws.cell_energy import cross, resisted_turn, scalar, turned_by


@device
def _integral(times, values, first, last, t):
    """Integral of a piecewise linear schedule from time 0 to t, constant beyond its ends."""
    end = interpolate(times, values, first, last, t)
    total, before, value = 0.0, 0.0, interpolate(times, values, first, last, 0.0)
    for k in range(first, last):
        if 0.0 < times[k] < t:
            # up to a jump the earlier value holds
            total += 0.5 * (times[k] - before) * (value + values[k])
            before, value = times[k], values[k]
    return total + 0.5 * (t - before) * (value + end)


@device
def place_wall(t, grips, g):
    """Bring the wall of a grip to time t; `came` is how far that is."""
    for d in range(3):
        s = grips.drive[g, d]
        if s < 0:
            continue
        first, last = grips.start[s], grips.start[s + 1]
        if grips.rate[s]:
            now = grips.base[g, d] + _integral(grips.times, grips.values, first, last, t)
        else:
            now = grips.base[g, d] + interpolate(grips.times, grips.values, first, last, t)
        grips.came[g, d] = now - grips.wall[g, d]
        grips.wall[g, d] = now


@kernel(parallel=False)
def place_walls(t, grips):
    """Bring the walls to time t."""
    for g in range(len(grips.cell)):
        place_wall(t, grips, g)


@device
def _gap(pose, rest, grips, g):
    """δ of a grip, and its lever turned with the cell."""
    p = grips.cell[g]
    b, own = grips.lever[g], (grips.arm[g, 0], grips.arm[g, 1], grips.arm[g, 2])
    arm = turned_by((pose[p, 4], pose[p, 5], pose[p, 6], pose[p, 7]), own)
    return (
        grips.axes[g, 0] * (grips.wall[g, 0] - (pose[p, 0] - rest[p, 0]) - (arm[0] - b[0])),
        grips.axes[g, 1] * (grips.wall[g, 1] - (pose[p, 1] - rest[p, 1]) - (arm[1] - b[1])),
        grips.axes[g, 2] * (grips.wall[g, 2] - (pose[p, 2] - rest[p, 2]) - (arm[2] - b[2])),
    ), arm


@device
def _turn(pose, grips, g):
    """Quaternion of the rotation of a cell since its wall holds it: q q₀*."""
    p, o = grips.cell[g], grips.base[g]
    w, x, y, z = pose[p, 4], pose[p, 5], pose[p, 6], pose[p, 7]
    return w * o[3] + x * o[4] + y * o[5] + z * o[6], (
        x * o[3] - w * o[4] + z * o[5] - y * o[6],
        y * o[3] - w * o[5] + x * o[6] - z * o[4],
        z * o[3] - w * o[6] + y * o[4] - x * o[5],
    )


@device
def grip_swelling(pose, rest, grips, g):
    """What a wall does to V θ of the cell that it holds [m³]."""
    gap, _ = _gap(pose, rest, grips, g)
    return scalar((grips.share[g, 0], grips.share[g, 1], grips.share[g, 2]), gap)


@kernel(parallel=False)
def swell_grips(pose, rest, grips, swelling):
    """Add what the walls do to V θ of the cells that they hold."""
    for g in range(len(grips.cell)):
        swelling[grips.cell[g]] += grip_swelling(pose, rest, grips, g)


@device
def grip_load(pose, rest, grips, g):
    """Force and torque of a wall on its cell, into its row, with the stress of the cell known."""
    p = grips.cell[g]
    gap, arm = _gap(pose, rest, grips, g)
    stress, k = pose[p, STRESS], grips.k[g]
    f = (
        k * gap[0] + stress * grips.share[g, 0],
        k * gap[1] + stress * grips.share[g, 1],
        k * gap[2] + stress * grips.share[g, 2],
    )
    w, v = _turn(pose, grips, g)
    h = resisted_turn(grips.H[g], v)
    turn, about = cross(v, h), cross(arm, f)
    for d in range(3):
        grips.load[g, d] = f[d]
        grips.load[g, 3 + d] = about[d] - 2.0 * (w * h[d] + turn[d])


@kernel(parallel=False)
def grip_loads(pose, rest, grips):
    """Force and torque of the walls on their cells, one row a grip, with the stresses of the cells known."""
    for g in range(len(grips.cell)):
        grip_load(pose, rest, grips, g)


@loop(parallel=False)
def give(grips, rows):
    """Put the forces of the walls into the rows of their cells."""
    rows.grip[:] = 0.0
    for g in range(len(grips.cell)):
        for d in range(6):
            rows.grip[grips.row[g], d] += grips.load[g, d]


@loop(parallel=False)
def hand_on(pose, rest, grips, rows):
    """Forces of the walls on the rows of their cells, and the work of walls that move: the trapezoid of f over dw."""
    for g in range(len(grips.cell)):
        for d in range(3):
            rows.work[grips.place] += 0.5 * grips.load[g, d] * grips.came[g, d]
    grip_loads(pose, rest, grips)
    give(grips, rows)
    for g in range(len(grips.cell)):
        for d in range(3):
            rows.work[grips.place] += 0.5 * grips.load[g, d] * grips.came[g, d]
            grips.came[g, d] = 0.0


@device
def held_energy(pose, rest, grips, g):
    """Energy of the half facet at a wall, without dilatation [J]."""
    gap, _ = _gap(pose, rest, grips, g)
    _, v = _turn(pose, grips, g)
    return 0.5 * grips.k[g] * scalar(gap, gap) + 2.0 * scalar(v, resisted_turn(grips.H[g], v))


@loop(parallel=False)
def grip_energy(pose, rest, grips):
    """Energy of the half facets at the walls, without dilatation [J]."""
    total = 0.0
    for g in range(len(grips.cell)):
        total += held_energy(pose, rest, grips, g)
    return total
