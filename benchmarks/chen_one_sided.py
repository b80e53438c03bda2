"""A row of bonded spheres by explicit dynamics, with what `bd.solve_explicit` does not have.

A linear contact beside each intact bond (in bondem elements that a bond joins have none), readings of the paper's
eqs (11) and (12) other than that of `bd.LocalDamping`, and an η for each component of the dashpots. Forces of bonds,
contacts and dashpots and the update of rotations are bondem's own; what is written here is the loop over a row, and
it has to come to what `bd.solve_explicit` comes to where both can.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

import bondem as bd
from bondem._compile import kernel
from bondem.laws.beam_energy import bond_force
from bondem.laws.bond import BondLaw
from bondem.laws.contact import contact_force
from bondem.laws.damping import dashpot_force, direction, local_damping
from bondem.laws.rotations import turn
from bondem.solve.timestep import critical_step
from chen_specimens import cantilever

#: Readings of eq (11): |F_i| sign(U_i), |F| U/|U|, F_i U_i/U_i as printed, F_i sign(U_i).
READINGS = ("component", "vector", "printed", "signed")
_FAST = 1e3


@dataclass(frozen=True)
class Rest:
    """Where a row came to rest, or how far it came.

    Attributes:
        status: "STOPPED" at rest, "COMPLETED" at the end of the time given, "DIVERGED" beyond 1 km/s.
        displacement: of the spheres [m], (n, 3).
        gap: between the surfaces, from that of the reference configuration [m], (n - 1,).
        steps, time: [-], [s].
        pressed, pressed_at_rest: largest normal force of a contact, of the run and at its end [N].
        speed: largest of the last quarter of a period [m/s].
    """

    status: str
    displacement: np.ndarray
    gap: np.ndarray
    steps: int
    time: float
    pressed: float
    pressed_at_rest: float
    speed: float


def run_to_rest(
    lattice: bd.Lattice,
    law: BondLaw,
    *,
    load: float,
    push: float = 0.0,
    contact: bd.LinearContact | None = None,
    gamma: float = 0.0,
    reading: str = "component",
    eta: Sequence[float] = (0.0, 0.0, 0.0, 0.0),
    ramp: float = 0.1,
    slow: float = 1e-9,
    duration: float = 900.0,
) -> Rest:
    """Clamped at its first sphere, loaded across at its last, after a push along the row if there is one.

    Args:
        lattice: spheres along x, each bonded to the next.
        law: of the bonds.
        load: across, along y [N], ramped up over `ramp`.
        push: against x [N], ramped up over `ramp` before the load.
        contact: beside each bond, where the spheres touch.
        gamma: of local damping, γ_b [-].
        reading: of eqs (11) and (12), one of `READINGS`.
        eta: η of the normal, shear, bending and twisting dashpots [-].
        ramp: of each load [s].
        slow: speed of the fastest sphere at rest, the paper's rule [m/s]; here over a quarter of the longest period,
            since at one instant it may be that of a turning point.
        duration: after which a run ends without coming to rest [s].
    """
    model = cantilever(lattice, law, load)
    s, i, j = model.stiffness, lattice.pairs[:, 0], lattice.pairs[:, 1]
    R, L, a = lattice.particles.radius, lattice.length, s.lever
    more = s.kb - s.kt
    far = L - a
    bonds = np.stack([L, s.kn, s.ks * a * a + more, s.ks * a * far - more, s.ks * far * far + more, s.kt, a], 1)
    pair = np.zeros((len(L), 4))
    if contact is not None:
        pair[:, 0] = contact.E * math.pi * np.minimum(R[i], R[j]) ** 2 / (R[i] + R[j])
        pair[:, 1], pair[:, 2] = pair[:, 0] / contact.kappa, contact.friction
        # spheres that just touch do, whatever the rounding
        pair[:, 3] = np.where(L - R[i] - R[j] < 1e-9 * R[i], L, R[i] + R[j])
    mass, inertia = model.mass, model.inertia
    light, slight = (v[i] * v[j] / (v[i] + v[j]) for v in (mass, inertia))
    dash = 2.0 * np.stack(
        [h * np.sqrt(k * m) for h, k, m in zip(eta, (s.kn, s.ks, s.kb, s.kt), (light, light, slight, slight),
                                               strict=True)], 1
    )  # fmt: skip
    # the contact adds at most the share of stiffness that it has of the bond's
    raised = 1.0 + float((pair[:, :2] / np.stack([s.kn, s.ks], 1)).max())
    dt = 0.8 * critical_step(model, bd.VelocityVerlet(), (bd.LocalDamping(gamma), bd.BondDamping(max(eta))))
    dt /= math.sqrt(raised)
    # no mode is slower than with all the mass at the tip
    quarter = 0.5 * math.pi * math.sqrt(mass.sum() * bd.solve_static(model).displacement[-1, 1] / load)
    place = lattice.particles.position.copy()
    found = _loop(
        place, lattice.pairs, bonds, pair, dash, np.stack([mass, inertia], 1), np.array([load, push, ramp]), gamma,
        READINGS.index(reading), dt, int(duration / dt), slow, math.ceil(quarter / dt),
    )  # fmt: skip
    moved = place - lattice.particles.position
    gap = np.linalg.norm(place[j] - place[i], axis=1) - L
    steps, pressed, at_rest, speed = found
    status = "DIVERGED" if speed > _FAST else "STOPPED" if speed < slow else "COMPLETED"
    return Rest(status, moved, gap, int(steps), steps * dt, pressed, at_rest, speed)


@kernel(parallel=False)
def _loop(place, pairs, bonds, pair, dash, inert, loads, gamma, reading, dt, count, slow, hold):
    """Leapfrog: forces at the whole steps, velocities between them; element 0 is held."""
    n, m = len(place), len(pairs)
    turned = np.zeros((n, 4))
    turned[:, 0] = 1.0
    v, w, f, t = np.zeros((n, 3)), np.zeros((n, 3)), np.zeros((n, 3)), np.zeros((n, 3))
    memory = np.zeros((m, 6))
    axis = np.zeros((m, 3))
    for b in range(m):
        for c in range(3):
            axis[b, c] = (place[pairs[b, 1], c] - place[pairs[b, 0], c]) / bonds[b, 0]
    load, push, ramp = loads[0], loads[1], loads[2]
    begin = ramp if push > 0.0 else 0.0
    largest, now, last, held = 0.0, 0.0, 0.0, 0
    for step in range(count):
        time = step * dt
        f[:], t[:] = 0.0, 0.0
        f[n - 1, 0] -= push * min(1.0, time / ramp)
        f[n - 1, 1] += load * min(1.0, max(0.0, (time - begin) / ramp))
        now = 0.0
        for b in range(m):
            i, j = pairs[b, 0], pairs[b, 1]
            dx, dy, dz = place[j, 0] - place[i, 0], place[j, 1] - place[i, 1], place[j, 2] - place[i, 2]
            fx, fy, fz, ax, ay, az, bx, by, bz = bond_force(
                dx, dy, dz, turned[i, 0], turned[i, 1], turned[i, 2], turned[i, 3], turned[j, 0], turned[j, 1],
                turned[j, 2], turned[j, 3], axis[b, 0], axis[b, 1], axis[b, 2], bonds[b, 0], bonds[b, 1], bonds[b, 2],
                bonds[b, 3], bonds[b, 4], bonds[b, 5],
            )  # fmt: skip
            ux, uy, uz = v[j, 0] - v[i, 0], v[j, 1] - v[i, 1], v[j, 2] - v[i, 2]
            if dash[b, 0] + dash[b, 1] + dash[b, 2] + dash[b, 3] > 0.0:
                gx, gy, gz, px, py, pz, qx, qy, qz = dashpot_force(
                    dx, dy, dz, ux, uy, uz, w[i, 0], w[i, 1], w[i, 2], w[j, 0], w[j, 1], w[j, 2],
                    bonds[b, 6] / bonds[b, 0], dash[b, 0], dash[b, 1], dash[b, 2], dash[b, 3],
                )  # fmt: skip
                fx, fy, fz = fx + gx, fy + gy, fz + gz
                ax, ay, az, bx, by, bz = ax + px, ay + py, az + pz, bx + qx, by + qy, bz + qz
            if pair[b, 0] > 0.0:
                l = math.sqrt(dx * dx + dy * dy + dz * dz)
                nx, ny, nz = dx / l, dy / l, dz / l
                near = bonds[b, 6] + 0.5 * (l - bonds[b, 0])
                far = l - near
                sx, sy = near * w[i, 0] + far * w[j, 0], near * w[i, 1] + far * w[j, 1]
                sz = near * w[i, 2] + far * w[j, 2]
                spin = 0.5 * ((w[i, 0] + w[j, 0]) * nx + (w[i, 1] + w[j, 1]) * ny + (w[i, 2] + w[j, 2]) * nz)
                overlap = max(0.0, pair[b, 3] - l)
                slide = ux - (sy * nz - sz * ny), uy - (sz * nx - sx * nz), uz - (sx * ny - sy * nx)
                now_there = (nx, ny, nz), slide
                (gx, gy, gz), stretch, _, _, _ = contact_force(
                    (pair[b, 0], 1.0, pair[b, 1], pair[b, 1], 0.0, 0.0), pair[b, 2], overlap, now_there, now_there,
                    spin, (memory[b, 0], memory[b, 1], memory[b, 2]), (0.0, 0.0, 0.0), dt,
                )  # fmt: skip
                memory[b, 0], memory[b, 1], memory[b, 2] = stretch
                now = max(now, pair[b, 0] * overlap)
                fx, fy, fz = fx + gx, fy + gy, fz + gz
                # a force at the contact point, and no moment of its own
                mx, my, mz = ny * gz - nz * gy, nz * gx - nx * gz, nx * gy - ny * gx
                ax, ay, az = ax - near * mx, ay - near * my, az - near * mz
                bx, by, bz = bx - far * mx, by - far * my, bz - far * mz
            f[i, 0], f[i, 1], f[i, 2] = f[i, 0] - fx, f[i, 1] - fy, f[i, 2] - fz
            f[j, 0], f[j, 1], f[j, 2] = f[j, 0] + fx, f[j, 1] + fy, f[j, 2] + fz
            t[i, 0], t[i, 1], t[i, 2] = t[i, 0] + ax, t[i, 1] + ay, t[i, 2] + az
            t[j, 0], t[j, 1], t[j, 2] = t[j, 0] + bx, t[j, 1] + by, t[j, 2] + bz
        largest = max(largest, now)
        speed = 0.0
        for k in range(1, n):
            _damp(f[k], v[k], gamma, reading)
            _damp(t[k], w[k], gamma, reading)
            before = 0.0
            for c in range(3):
                v[k, c] += dt * f[k, c] / inert[k, 0]
                w[k, c] += dt * t[k, c] / inert[k, 1]
                place[k, c] += dt * v[k, c]
                before += v[k, c] * v[k, c]
            turned[k, 0], turned[k, 1], turned[k, 2], turned[k, 3] = turn(
                turned[k, 0], turned[k, 1], turned[k, 2], turned[k, 3], dt * w[k, 0], dt * w[k, 1], dt * w[k, 2]
            )
            speed = max(speed, before)
        speed = math.sqrt(speed)
        if speed > _FAST:
            return step + 1, largest, now, speed
        held = held + 1 if time >= begin + ramp and speed < slow else 0
        last = max(last, speed) if step >= count - hold else 0.0
        if held == hold:
            return step + 1, largest, now, speed
    return count, largest, now, last


@kernel(parallel=False)
def _damp(force, velocity, gamma, reading):
    """Local damping of a force and a velocity, or of a torque and an angular velocity, in one of the readings."""
    if reading == 0:
        for c in range(3):
            force[c] = local_damping(force[c], direction(velocity[c]), gamma)
    elif reading == 1:
        size = math.sqrt(velocity[0] ** 2 + velocity[1] ** 2 + velocity[2] ** 2)
        if size > 0.0:
            strength = gamma * math.sqrt(force[0] ** 2 + force[1] ** 2 + force[2] ** 2) / size
            for c in range(3):
                force[c] -= strength * velocity[c]
    elif reading == 2:
        for c in range(3):
            force[c] -= gamma * force[c] * abs(direction(velocity[c]))
    else:
        for c in range(3):
            force[c] -= gamma * force[c] * direction(velocity[c])
