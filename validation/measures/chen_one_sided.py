"""A row of bonded spheres by explicit dynamics, with what `bd.solve_explicit` does not have.

A linear contact beside each intact bond (in bondem elements that a bond joins have none), readings of the paper's
eqs (11) and (12) other than that of `bd.LocalDamping`, and an η for each component of the dashpots. Forces of bonds
are bondem's own. The row moves in the plane x, y of its loads and turns about z. Forces of contacts and dashpots, and
the loop over the steps, are written here; the loop has the results of `bd.solve_explicit` where both can be used.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

import bondem as bd
from bondem._core import bound_pass
from bondem._passes import calls
from bondem._tables.step_tables import BeamSums, Poses
from bondem.dynamics.timestep import critical_step
from bondem.interactions.beams.beam_tables import beam_tables
from bondem.interactions.beams.bond_law import BondLaw
from validation.measures.chen_specimens import cantilever

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
    s, (i, j), n = model.stiffness, lattice.pairs.T, len(lattice.particles)
    assert (i == np.arange(n - 1)).all()
    assert (j == i + 1).all()
    R, L = lattice.particles.radius, lattice.length
    mass, inertia = model.mass, model.inertia
    light, slight = (v[i] * v[j] / (v[i] + v[j]) for v in (mass, inertia))
    dashpots = Dashpots(s.lever / L, *(
        2.0 * h * np.sqrt(k * m) for h, k, m in zip(eta[:3], (s.kn, s.ks, s.kb), (light, light, slight), strict=True)
    ))  # fmt: skip
    pair, raised = None, 1.0
    if contact is not None:
        kn = contact.E * math.pi * np.minimum(R[i], R[j]) ** 2 / (R[i] + R[j])
        # spheres that just touch do, whatever the rounding
        touch = np.where(L - R[i] - R[j] < 1e-9 * R[i], L, R[i] + R[j])
        pair = Contacts(kn, kn / contact.kappa, contact.friction, touch, s.lever, L)
        # the contact adds at most the share of stiffness that it has of the bond's
        raised += float(max((kn / s.kn).max(), (pair.ks / s.ks).max()))
    dt = 0.8 * critical_step(model, bd.VelocityVerlet(), (bd.LocalDamping(gamma), bd.BondDamping(max(eta))))
    dt /= math.sqrt(raised)
    # no mode is slower than with all the mass at the tip
    quarter = 0.5 * math.pi * math.sqrt(mass.sum() * bd.solve_static(model).displacement[-1, 1] / load)
    row = Row(model, dashpots if max(eta) > 0.0 else None, pair)
    begin = ramp if push > 0.0 else 0.0
    largest, last, held, hold, count = 0.0, 0.0, 0, math.ceil(quarter / dt), int(duration / dt)
    speed, step = 0.0, 0
    while step < count:
        time = step * dt
        force = row.forces(dt)
        force[-1, 0] -= push * min(1.0, time / ramp)
        force[-1, 1] += load * min(1.0, max(0.0, (time - begin) / ramp))
        damp(force[:, :2], row.motion[:, :2], gamma, reading)
        damp(force[:, 2:], row.motion[:, 2:], gamma, reading)
        speed = row.move(force, dt)
        largest = max(largest, row.pressed)
        step += 1
        if speed > _FAST:
            break
        held = held + 1 if time >= begin + ramp and speed < slow else 0
        last = max(last, speed) if step > count - hold else 0.0
        if held == hold:
            break
    else:
        speed = last
    moved = np.zeros((n, 3))
    moved[:, :2] = row.place - lattice.particles.position[:, :2]
    gap = np.linalg.norm(np.diff(row.place, axis=0), axis=1) - L
    status = "DIVERGED" if speed > _FAST else "STOPPED" if speed < slow else "COMPLETED"
    return Rest(status, moved, gap, step, step * dt, largest, row.pressed, speed)


@dataclass(frozen=True)
class Dashpots:
    """Dashpots of the bonds.

    Attributes:
        share: position of the contact point along each bond, from its first sphere [-].
        cn, cs, cb: coefficients of stretching, shear and bending [N·s/m, N·m·s].
    """

    share: np.ndarray
    cn: np.ndarray
    cs: np.ndarray
    cb: np.ndarray

    def add(self, row: "Row", force: np.ndarray) -> None:
        """Add their forces and torques."""
        l, normal = row.direction()
        near = self.share * l
        along, across = row.slip(normal, near, l - near)
        bent = self.cb * (row.motion[1:, 2] - row.motion[:-1, 2])
        row.add(force, normal, (-self.cn * along, -self.cs * across), near, l - near)
        force[:-1, 2] += bent
        force[1:, 2] -= bent


@dataclass(frozen=True)
class Contacts:
    """Linear contacts beside the bonds.

    Attributes:
        kn, ks: stiffnesses [N/m].
        friction: μ [-].
        touch: distance of the centres at which spheres touch [m].
        lever, length: of the contact point from the first sphere, and of the bond, at rest [m].
    """

    kn: np.ndarray
    ks: np.ndarray
    friction: float
    touch: np.ndarray
    lever: np.ndarray
    length: np.ndarray

    def add(self, row: "Row", force: np.ndarray, dt: float) -> None:
        """Add their forces, at the contact point and without a moment of their own; follow their springs."""
        l, normal = row.direction()
        near = self.lever + 0.5 * (l - self.length)
        pressed = self.kn * np.maximum(0.0, self.touch - l)
        _, across = row.slip(normal, near, l - near)
        stretch, limit = row.stretch + dt * across, self.friction * pressed / self.ks
        row.stretch = np.clip(stretch, -limit, limit)
        row.pressed = float(pressed.max())
        row.add(force, normal, (pressed, -self.ks * row.stretch), near, l - near)


class Row:
    """Spheres that move in the plane x, y and turn about z; the first one is held.

    Attributes:
        place: centres [m], (n, 2).
        motion: velocity and angular velocity [m/s, rad/s], (n, 3).
        stretch: of the tangential springs of contacts [m], (n - 1,).
        pressed: largest normal force of a contact [N].
    """

    def __init__(self, model: bd.Model, dashpots: Dashpots | None, contacts: Contacts | None) -> None:
        n = len(model.mass)
        self._dashpots, self._contacts = dashpots, contacts
        self.place, self.motion = model.lattice.particles.position[:, :2].copy(), np.zeros((n, 3))
        self.stretch, self.pressed = np.zeros(n - 1), 0.0
        self._turned, self._inverse = np.zeros(n), 1.0 / np.column_stack([model.mass, model.mass, model.inertia])
        self._rank, self._pose, self._sums = model.layout.rank, model.state().pose, np.zeros((n, 8))
        beams, _ = beam_tables(model.bonds, model.layout, model.period, np.ones(n - 1), may_share=False)
        self._load = bound_pass(calls.load_beams(Poses(self._pose), beams, BeamSums(beams.i, beams.j, self._sums)))

    def forces(self, dt: float) -> np.ndarray:
        """Return force and torque of bonds, dashpots and contacts [N, N·m], (n, 3)."""
        self._sums[:] = 0.0
        self._load()
        force = self._sums[self._rank][:, [0, 1, 6]]
        if self._dashpots is not None:
            self._dashpots.add(self, force)
        if self._contacts is not None:
            self._contacts.add(self, force, dt)
        return force

    def move(self, force: np.ndarray, dt: float) -> float:
        """Move by one step of the leapfrog; return the speed of the fastest sphere [m/s]."""
        force[0] = 0.0
        self.motion += dt * self._inverse * force
        self.place += dt * self.motion[:, :2]
        self._turned += dt * self.motion[:, 2]
        self._pose[self._rank, :2] = self.place
        self._pose[self._rank, 4] = np.cos(0.5 * self._turned)
        self._pose[self._rank, 7] = np.sin(0.5 * self._turned)
        return math.sqrt((self.motion[:, :2] ** 2).sum(axis=1).max())

    def direction(self) -> tuple[np.ndarray, np.ndarray]:
        """Return distances [m] and unit directions (2, m) from each sphere to the next."""
        d = (self.place[1:] - self.place[:-1]).T
        l = np.hypot(*d)
        return l, d / l

    def slip(self, normal: np.ndarray, near: np.ndarray, far: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return velocities of each sphere against the one before at their contact point, along and across [m/s]."""
        (nx, ny), (vx, vy, _) = normal, (self.motion[1:] - self.motion[:-1]).T
        turn = near * self.motion[:-1, 2] + far * self.motion[1:, 2]
        return vx * nx + vy * ny, vy * nx - vx * ny - turn

    def add(self, force: np.ndarray, normal: np.ndarray, load: tuple[np.ndarray, np.ndarray], near, far) -> None:
        """Add loads on the second sphere of each pair, along and across [N], and their opposites on the first."""
        (nx, ny), (along, across) = normal, load
        both = np.column_stack([along * nx - across * ny, along * ny + across * nx])
        force[1:, :2] += both
        force[:-1, :2] -= both
        force[1:, 2] -= far * across
        force[:-1, 2] -= near * across


def damp(force: np.ndarray, velocity: np.ndarray, gamma: float, reading: str) -> None:
    """Apply local damping to forces and velocities, or torques and angular velocities, in one of the readings."""
    if reading == "component":
        force -= gamma * np.abs(force) * np.sign(velocity)
    elif reading == "vector":
        size = np.sqrt((velocity**2).sum(axis=1, keepdims=True))
        strength = gamma * np.sqrt((force**2).sum(axis=1, keepdims=True))
        force -= strength * velocity / np.where(size > 0.0, size, 1.0)
    elif reading == "printed":
        force -= gamma * force * np.abs(np.sign(velocity))
    else:
        force -= gamma * force * np.sign(velocity)
