"""A record on the device: sums over elements, bonds and gauges in an order that depends on their number only.

A sum is cut into parts, thread s taking entries s, s + S, s + 2S …; the parts are added in two further rounds.
"""

from bondem._compile import device
from bondem._compile_cuda import cuda, cuda_kernel
from bondem.kernels.cuda.bonds import branch, stiffness
from bondem.kernels.sample import rotation_component
from bondem.kernels.tables import (
    DAMPED,
    LARGEST,
    MEAN,
    OF_DISPLACEMENT,
    OF_ROTATION,
    OF_SPIN,
    OF_VELOCITY,
    RUBBED,
    SPIN,
)  # fmt: skip
from bondem.laws.beam_energy import bond_energy

# Columns: kinetic energy (2), elastic energy (4), work, loss, friction, energy of fracture, plastic energy; after
# them three a gauge.
TRANSLATION, ROTATION, NORMAL, WORK, LOSS, FRICTION, RELEASED, HEATED, SUMS = 0, 1, 2, 6, 7, 8, 9, 10, 11


@cuda_kernel
def element_sums(elements, rows, parts):
    """Kinetic energies, losses and the work of the boundary, into `parts` (SUMS, S)."""
    s = cuda.grid(1)
    stride = parts.shape[1]
    if s >= stride:
        return
    motion, loss, work = elements.motion, elements.loss, rows.work
    translation = rotation = damped = rubbed = total = 0.0
    for p in range(s, motion.shape[0], stride):
        v2 = motion[p, 0] ** 2 + motion[p, 1] ** 2 + motion[p, 2] ** 2
        w2 = motion[p, 4] ** 2 + motion[p, 5] ** 2 + motion[p, 6] ** 2
        translation += 0.5 * v2 / motion[p, 3]
        rotation += 0.5 * w2 / motion[p, 7]
        damped += loss[p, DAMPED]
        rubbed += loss[p, RUBBED]
    for r in range(s, work.shape[0], stride):
        total += work[r]
    parts[TRANSLATION, s] = translation
    parts[ROTATION, s] = rotation
    parts[WORK, s] = total
    parts[LOSS, s] = damped
    parts[FRICTION, s] = rubbed


@device
def shear_of(L, A, B, C):
    """Shear stiffness and lever of a bond, which need not be stored: A + B = ks a L and B + C = ks (L - a) L."""
    total = A + 2.0 * B + C
    if total == 0.0:
        return 0.0, 0.0
    return total / (L * L), L * (A + B) / total


@cuda_kernel
def bond_sums(elements, bonds, parts):
    """The four elastic energies, into `parts` (SUMS, S)."""
    s = cuda.grid(1)
    stride = parts.shape[1]
    if s >= stride:
        return
    pose, constants = elements.pose, bonds.constants
    normal = slip = bend = twist = 0.0
    for k in range(s, bonds.m, stride):
        a = bonds.i[k]
        b = bonds.j[k]
        dx, dy, dz = branch(pose, a, b, bonds.period)
        L = constants[3, k]
        kn, A, B, C, kt = stiffness(constants, bonds.same, k, 1.0)
        ks, lever = shear_of(L, A, B, C)
        e0, e1, e2, e3 = bond_energy(
            dx, dy, dz,
            pose[a, 4], pose[a, 5], pose[a, 6], pose[a, 7],
            pose[b, 4], pose[b, 5], pose[b, 6], pose[b, 7],
            constants[0, k], constants[1, k], constants[2, k], L, kn, A, B, C, kt, ks, lever,
        )  # fmt: skip
        share = bonds.integrity[k]
        normal += share * e0
        slip += share * e1
        bend += share * e2
        twist += share * e3
    parts[NORMAL, s] = normal
    parts[NORMAL + 1, s] = slip
    parts[NORMAL + 2, s] = bend
    parts[NORMAL + 3, s] = twist


@cuda_kernel
def gauge_sums(elements, gauges, rows):
    """Sum or largest absolute value of each component of the gauges, into their parts."""
    n = cuda.grid(1)
    stride = gauges.parts.shape[1]
    g = n // stride
    s = n % stride
    if g >= gauges.g:
        return
    pose, start, quantity = elements.pose, gauges.start, gauges.quantity
    for d in range(3):
        value = 0.0
        for e in range(start[g] + s, start[g + 1], stride):
            p = gauges.element[e]
            x = 0.0
            if quantity[g] == OF_DISPLACEMENT:
                x = pose[p, d] - gauges.rest[e, d]
            elif quantity[g] == OF_VELOCITY:
                x = elements.motion[p, d]
            elif quantity[g] == OF_ROTATION:
                x = rotation_component(pose[p, 4], pose[p, 5], pose[p, 6], pose[p, 7], d)
            elif quantity[g] == OF_SPIN:
                x = elements.motion[p, SPIN + d]
            elif rows.of[p] >= 0:
                r = rows.of[p]
                x = rows.grip[r, d] + (rows.reaction[r, d] if rows.fixed[r, d] else rows.force[r, d])
            value = max(value, abs(x)) if gauges.reduction[g] == LARGEST else value + x
        gauges.parts[g, s, d] = value


@cuda_kernel
def fold(parts, fewer):
    """Add up `parts` (SUMS, S) to `fewer` (SUMS, T)."""
    n = cuda.grid(1)
    stride = fewer.shape[1]
    c = n // stride
    s = n % stride
    if c >= parts.shape[0]:
        return
    value = 0.0
    for q in range(s, parts.shape[1], stride):
        value += parts[c, q]
    fewer[c, s] = value


@cuda_kernel
def write_record(fewer, gauges, row, records):
    """The last round, a thread a column: sums, then gauges, into a row of `records`."""
    c = cuda.grid(1)
    if c >= records.shape[1]:
        return
    value = 0.0
    if c < SUMS:
        for s in range(fewer.shape[1]):
            value += fewer[c, s]
    else:
        g = (c - SUMS) // 3
        d = (c - SUMS) % 3
        for s in range(gauges.parts.shape[1]):
            x = gauges.parts[g, s, d]
            value = max(value, x) if gauges.reduction[g] == LARGEST else value + x
        if gauges.reduction[g] == MEAN:
            value /= gauges.start[g + 1] - gauges.start[g]
    records[row, c] = value
