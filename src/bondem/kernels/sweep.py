"""A step over all bonds and elements, block by block, and on several threads domain by domain.

See `bondem.model.blocks` for how a step is cut, and why the cuts change no bit.
"""

from bondem._compile import kernel, prange
from bondem.kernels.bond_pass import add_forces, bond_forces
from bondem.kernels.dashpots import collect_dashpots, damp_bonds
from bondem.kernels.element_pass import collect, move
from bondem.kernels.incremental import incremental_forces

# Bonds whose forces are computed before they are added up: nine rows of them fit into the nearest cache.
TILE = 512

# Elements from which on their rows do not stay in the last cache from one step to the next. Those that a tile needs
# are then read before it: nothing but loads waits for many lines of memory at once, while between two bonds there
# is too much to do.
FAR = 50_000


@kernel(parallel=False)
def fetch(table, which, first, last):
    """Bring rows of a table into the cache; the sum is only there so that they are read."""
    total = 0.0
    for e in range(first, last):
        total += table[which[e], 0]
    return total


@kernel(parallel=False)
def sweep(
    pose, motion, acceleration, i, j, constants, same, shear, bending, lever, integrity, history, period,
    rows, row_i, row_j, sums, block_bond, block_move, ready, ready_row,
    row_of, row_fixed, row_force, row_half, row_full, row_reaction, work,
    dt, finish, begin, extra, gamma, loss, go_on, first, last, added,
):  # fmt: skip
    """The blocks first … last: bonds, sums, and the elements whose sums are complete."""
    fx, fy, fz = rows[0], rows[1], rows[2]
    ax, ay, az = rows[3], rows[4], rows[5]
    bx, by, bz = rows[6], rows[7], rows[8]
    far = len(pose) >= FAR
    for b in range(first, last):
        for k0 in range(block_bond[b], block_bond[b + 1], TILE):
            k1 = min(k0 + TILE, block_bond[b + 1])
            if far:
                fx[0] = fetch(pose, i, k0, k1)
            if history.shape[1] > 0:
                incremental_forces(
                    pose, motion, i, j, constants, shear, bending, lever, integrity, history, period, dt,
                    k0, k1, fx, fy, fz, ax, ay, az, bx, by, bz,
                )  # fmt: skip
            else:
                bond_forces(
                    pose, i, j, constants, same, integrity, period, k0, k1, fx, fy, fz, ax, ay, az, bx, by, bz
                )
            add_forces(sums, row_i, row_j, k0, k1, fx, fy, fz, ax, ay, az, bx, by, bz)
            damp_bonds(
                added, pose, motion, i, j, integrity, period, row_i, row_j, k0, k1, fx, fy, fz, ax, ay, az, bx, by, bz
            )
        for e0 in range(block_move[b], block_move[b + 1], TILE):
            e1 = min(e0 + TILE, block_move[b + 1])
            if far:
                fx[0] = fetch(pose, ready, e0, e1) + fetch(motion, ready, e0, e1)
            move(
                pose, motion, acceleration, sums, ready, ready_row, row_of, row_fixed, row_force, row_half, row_full,
                row_reaction, work, dt, finish, begin, extra, gamma, loss, go_on, e0, e1, added,
            )  # fmt: skip


@kernel(parallel=True)
def sweep_domains(
    pose, motion, acceleration, i, j, constants, same, shear, bending, lever, integrity, history, period,
    rows, row_i, row_j, sums, domain, block_bond, block_move, ready, ready_row, shared, shared_row, parts, part,
    row_of, row_fixed, row_force, row_half, row_full, row_reaction, work,
    dt, finish, begin, extra, gamma, loss, go_on, added,
):  # fmt: skip
    """All domains, each on a thread of its own, then the elements they share."""
    count = len(domain) - 1
    for d in prange(count):
        sweep(
            pose, motion, acceleration, i, j, constants, same, shear, bending, lever, integrity, history, period,
            rows[d], row_i, row_j, sums, block_bond, block_move, ready, ready_row,
            row_of, row_fixed, row_force, row_half, row_full, row_reaction, work,
            dt, finish, begin, extra, gamma, loss, go_on, domain[d], domain[d + 1], added,
        )  # fmt: skip
    for d in prange(count):
        first, last = len(shared) * d // count, len(shared) * (d + 1) // count
        collect(sums, shared_row, parts, part, first, last)
        collect_dashpots(added, shared_row, parts, part, first, last)
        move(
            pose, motion, acceleration, sums, shared, shared_row, row_of, row_fixed, row_force, row_half, row_full,
            row_reaction, work, dt, finish, begin, extra, gamma, loss, go_on, first, last, added,
        )  # fmt: skip


@kernel(parallel=False)
def step_forces(
    pose, motion, acceleration, i, j, constants, same, shear, bending, lever, integrity, history, period,
    rows, row_i, row_j, sums, domain, block_bond, block_move, ready, ready_row, shared, shared_row, parts, part,
    row_of, row_fixed, row_force, row_half, row_full, row_reaction, work,
    dt, finish, begin, extra, gamma, loss, go_on, added,
):  # fmt: skip
    """Forces of all bonds now, and what elements do with them: close the step, and open the next or not."""
    if len(domain) == 2:
        sweep(
            pose, motion, acceleration, i, j, constants, same, shear, bending, lever, integrity, history, period,
            rows[0], row_i, row_j, sums, block_bond, block_move, ready, ready_row,
            row_of, row_fixed, row_force, row_half, row_full, row_reaction, work,
            dt, finish, begin, extra, gamma, loss, go_on, domain[0], domain[1], added,
        )  # fmt: skip
    else:
        sweep_domains(
            pose, motion, acceleration, i, j, constants, same, shear, bending, lever, integrity, history, period,
            rows, row_i, row_j, sums, domain, block_bond, block_move, ready, ready_row, shared, shared_row, parts,
            part,
            row_of, row_fixed, row_force, row_half, row_full, row_reaction, work,
            dt, finish, begin, extra, gamma, loss, go_on, added,
        )  # fmt: skip
