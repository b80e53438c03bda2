"""Dynamic relaxation: many steps in one compiled call, with masses of no physical meaning and a time step of one."""

import math
from typing import NamedTuple

import numpy as np

from bondem._compile import device, kernel
from bondem.kernels.bond_pass import bond_loads
from bondem.laws.rotations import turn


class Relaxation(NamedTuple):
    """What relaxes, n elements; kernels write `velocity`, `sums`, `before` and `memory`."""

    velocity: np.ndarray  #: of centres and rotations, (n, 6)
    sums: np.ndarray  #: forces and torques of the bonds, zero between steps, (n, 8)
    before: np.ndarray  #: forces and torques of the bonds in the step before, (n, 6)
    load: np.ndarray  #: at the end [N, N·m], (n, 6)
    inverse: np.ndarray  #: 1 / mass and 1 / moment of inertia, 0 where nothing is bonded, (n, 2)
    free: np.ndarray  #: degrees of freedom that nothing prescribes, bool, (n, 6)
    motion: np.ndarray  #: prescribed displacements and rotations at the end [m, rad], (n, 6)
    memory: np.ndarray  #: running means Σ v·ΔF and Σ m v² of the steps so far, (2,)
    ramp: int  #: steps in which load and prescribed motion grow
    length: float  #: by which torques become forces [m]
    tolerance: float  #: unbalanced force over applied and supporting force at which to stop [-]
    noise: float  #: force that rounding leaves [N]


@device
def _share(relaxation, step):
    """Share of the load that acts in a step [-]."""
    return min(1.0, (step + 1.0) / relaxation.ramp)


@device
def _balance(c, share):
    """Unbalanced force over applied and supporting force; Σ v·ΔF and Σ m v² of the last step; keeps the forces."""
    out = applied = borne = power = mass = 0.0
    for p in range(len(c.sums)):
        for d in range(6):
            metric = 1.0 if d < 3 else 1.0 / c.length
            force, pull = c.sums[p, d + d // 3], share * c.load[p, d]
            applied += (pull * metric) ** 2
            if c.free[p, d]:
                out += ((force + pull) * metric) ** 2
                v = c.velocity[p, d]
                power += v * (c.before[p, d] - force)
                mass += v * v / c.inverse[p, d // 3]
            else:
                borne += (force * metric) ** 2
            c.before[p, d] = force
    c.sums[:] = 0.0
    return math.sqrt(out) / (math.sqrt(applied) + math.sqrt(borne) + c.noise / c.tolerance), power, mass


@device
def _squared_frequency(memory):
    """Rayleigh's quotient of the motion at present."""
    return max(memory[0], 0.0) / memory[1] if memory[1] > 0.0 else 0.0


@device
def _damping(memory, power, mass):
    """The critical rate 2 ω of the frequency at present, averaged over about as many steps as that motion lasts."""
    fade = min(0.5, max(math.sqrt(_squared_frequency(memory)), 1e-4))
    memory[0] += fade * (power - memory[0])
    memory[1] += fade * (mass - memory[1])
    return min(2.0 * math.sqrt(_squared_frequency(memory)), 1.9)


@device
def _go_on(pose, c, share, rate, step):
    """Free elements follow their forces, damped; the others their prescribed motion."""
    keep, push = (2.0 - rate) / (2.0 + rate), 2.0 / (2.0 + rate)
    moving = 1.0 / c.ramp if step < c.ramp else 0.0
    for p in range(len(pose)):
        for d in range(6):
            if c.free[p, d]:
                c.velocity[p, d] = keep * c.velocity[p, d] + push * c.inverse[p, d // 3] * (
                    c.before[p, d] + share * c.load[p, d]
                )
            else:
                c.velocity[p, d] = moving * c.motion[p, d]
        v = c.velocity[p]
        pose[p, 0] += v[0]
        pose[p, 1] += v[1]
        pose[p, 2] += v[2]
        pose[p, 4], pose[p, 5], pose[p, 6], pose[p, 7] = turn(
            pose[p, 4], pose[p, 5], pose[p, 6], pose[p, 7], v[3], v[4], v[5]
        )


@kernel(parallel=False)
def relax_bonds(pose, bonds, same, relaxation, first, steps):
    """Steps first … first + steps, or fewer where the forces balance.

    Each step damps by c = 2 ω, the critical rate of the frequency ω² = Σ v·ΔF / Σ m v² at which the free elements
    move at present (Rayleigh's quotient of the last step, ΔF = K v).

    Returns:
        (steps done, unbalanced force over applied and supporting force).
    """
    ratio = np.inf
    for step in range(first, first + steps):
        bond_loads(pose, bonds, same, relaxation.sums, bonds.i, bonds.j, None, 0, len(bonds.i))
        share = _share(relaxation, step)
        ratio, power, mass = _balance(relaxation, share)
        if step >= relaxation.ramp and ratio <= relaxation.tolerance:
            return step - first, ratio
        _go_on(pose, relaxation, share, _damping(relaxation.memory, power, mass), step)
    return steps, ratio
