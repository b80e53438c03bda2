"""Dynamic relaxation: many steps in one compiled call, with masses of no physical meaning and a time step of one."""

import math

import numpy as np

from bondem._compile import kernel
from bondem.kernels.bond_pass import add_forces, bond_forces
from bondem.laws.rotations import turn


@kernel(parallel=False)
def relax(
    pose, velocity, i, j, constants, same, integrity, period, rows, sums, before,
    load, inverse, free, motion, ramp, first, steps, length, tolerance, noise, memory,
):  # fmt: skip
    """Steps first … first + steps, or fewer where the forces balance.

    Load and prescribed motion grow in `ramp` steps. Each step damps by c = 2 ω, the critical rate of the frequency
    ω² = Σ v·ΔF / Σ m v² at which the free elements move at present (Rayleigh's quotient of the last step,
    ΔF = K v), averaged over about as many steps as that motion lasts.

    Args:
        before: forces of the bonds in the step before, (n, 6).
        inverse: 1 / mass and 1 / moment of inertia, 0 where nothing is bonded, (n, 2).
        motion: prescribed displacements and rotations at the end [m, rad], (n, 6).
        length: by which torques become forces [m].
        noise: force that rounding leaves [N].
        memory: running means Σ v·ΔF and Σ m v² of the steps so far, (2,); changed.

    Returns:
        (steps done, unbalanced force over applied and supporting force).
    """
    n = len(pose)
    tile = rows.shape[1]
    ratio = np.inf
    for step in range(first, first + steps):
        for k0 in range(0, len(i), tile):
            k1 = min(k0 + tile, len(i))
            bond_forces(
                pose, i, j, constants, same, integrity, period, k0, k1,
                rows[0], rows[1], rows[2], rows[3], rows[4], rows[5], rows[6], rows[7], rows[8],
            )  # fmt: skip
            add_forces(
                sums, i, j, k0, k1, rows[0], rows[1], rows[2], rows[3], rows[4], rows[5], rows[6], rows[7], rows[8]
            )
        share = min(1.0, (step + 1.0) / ramp)
        out = applied = borne = power = mass = 0.0
        for p in range(n):
            for d in range(6):
                metric = 1.0 if d < 3 else 1.0 / length
                force, pull = sums[p, d], share * load[p, d]
                applied += (pull * metric) ** 2
                if free[p, d]:
                    out += ((force + pull) * metric) ** 2
                    v = velocity[p, d]
                    power += v * (before[p, d] - force)
                    mass += v * v / inverse[p, d // 3]
                else:
                    borne += (force * metric) ** 2
                before[p, d] = force
        ratio = math.sqrt(out) / (math.sqrt(applied) + math.sqrt(borne) + noise / tolerance)
        if step >= ramp and ratio <= tolerance:
            for p in range(n):
                for d in range(6):
                    sums[p, d] = 0.0
            return step - first, ratio
        omega2 = max(memory[0], 0.0) / memory[1] if memory[1] > 0.0 else 0.0
        fade = min(0.5, max(math.sqrt(omega2), 1e-4))
        memory[0] += fade * (power - memory[0])
        memory[1] += fade * (mass - memory[1])
        omega2 = max(memory[0], 0.0) / memory[1] if memory[1] > 0.0 else 0.0
        rate = min(2.0 * math.sqrt(omega2), 1.9)
        keep, push = (2.0 - rate) / (2.0 + rate), 2.0 / (2.0 + rate)
        moving = 1.0 / ramp if step < ramp else 0.0
        for p in range(n):
            for d in range(6):
                if free[p, d]:
                    velocity[p, d] = keep * velocity[p, d] + push * inverse[p, d // 3] * (
                        before[p, d] + share * load[p, d]
                    )
                else:
                    velocity[p, d] = moving * motion[p, d]
                sums[p, d] = 0.0
            pose[p, 0] += velocity[p, 0]
            pose[p, 1] += velocity[p, 1]
            pose[p, 2] += velocity[p, 2]
            pose[p, 4], pose[p, 5], pose[p, 6], pose[p, 7] = turn(
                pose[p, 4], pose[p, 5], pose[p, 6], pose[p, 7], velocity[p, 3], velocity[p, 4], velocity[p, 5]
            )
    return steps, ratio
