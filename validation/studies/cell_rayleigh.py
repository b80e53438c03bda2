"""Rayleigh waves on the free surface of a body of cells: their celerity from long waves to short ones.

A slab 1 × t × 2 (x, y, z), t = 4 elements, stands between smooth walls at both ends of x and of y, on a smooth floor,
its top free: the walls are planes of symmetry of standing waves of 1, 1½, 2 … waves along x, in plane strain. The
motion of the Rayleigh wave of the half-space is its velocity at the beginning, mass by mass, with its spin; what the
body does on that shape oscillates with ω, read from zero crossings over three and a half periods, and ω / k is held
against the root of the Rayleigh function. The longest wave has twice its length below it. What the length of the
step adds to ω, (ω dt)²/24, stands beside each ratio.
"""

from functools import partial
from itertools import product
from typing import NamedTuple

import numpy as np
from scipy.optimize import brentq

import bondem as bd
from validation.frame.record import Record

LENGTH, DEPTH, ACROSS = 1.0, 2.0, 4.0
#: Half waves in the length of the slab.
HALVES = (2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 28)
PERIODS = 3.6


class Wave(NamedTuple):
    """The Rayleigh wave of a half-space with ρ = 1, E = 1.

    Attributes:
        celerity: c [m/s].
        p, s: decay of its parts with depth over k, √(1 − c²/c_P²) and √(1 − c²/c_S²) [-].
    """

    celerity: float
    p: float
    s: float

    @classmethod
    def of(cls, nu: float) -> "Wave":
        """The root of (2 − c²/c_S²)² = 4 p s below c_S."""
        G = 0.5 / (1.0 + nu)
        share = (1.0 - 2.0 * nu) / (2.0 - 2.0 * nu)  # c_S² / c_P²

        def parts(x: float) -> tuple[float, float]:
            return float(np.sqrt(1.0 - share * x)), float(np.sqrt(1.0 - x))

        x = brentq(lambda x: (2.0 - x) ** 2 - 4.0 * np.prod(parts(x)), 0.3, 0.999, xtol=1e-15)
        return cls(float(np.sqrt(x * G)), *parts(x))

    def shape(self, k: float, x: np.ndarray, depth: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Displacement and rotation of the standing wave with u_z ∝ cos k x, z upwards, (n, 3) each."""
        p, s, x_ = self.p, self.s, 1.0 + self.s**2
        fast, slow = np.exp(-k * p * depth), np.exp(-k * s * depth)
        along = fast - 2.0 * p * s / x_ * slow
        up = p * fast - 2.0 * p / x_ * slow
        shape, turn = np.zeros((2, len(x), 3))
        shape[:, 0], shape[:, 2] = -along * np.sin(k * x), up * np.cos(k * x)
        # half the curl; ∂/∂z = −∂/∂depth
        d_along = k * (p * fast - 2.0 * p * s**2 / x_ * slow)
        turn[:, 1] = 0.5 * (-d_along * np.sin(k * x) + k * up * np.sin(k * x))
        return shape, turn


def slab(count: int, seed: int) -> tuple[bd.Lattice, float]:
    """The body, and the edge of a cube of the volume of an element."""
    size = (ACROSS * LENGTH * DEPTH / count) ** 0.5
    particles = bd.pack(bd.Box((LENGTH, ACROSS * size, DEPTH)), count=count, spread=0.25, seed=seed)
    return bd.connect(particles, method="laguerre"), size


def smooth(body: bd.Lattice, nu: float) -> bd.Model:
    """Between smooth walls, the top free; E = ρ = 1."""
    faces = (("x_min", "x"), ("x_max", "x"), ("y_min", "y"), ("y_max", "y"), ("z_min", "z"))
    held = [bd.Fix(bd.Face(name), translation=axis, rotation="") for name, axis in faces]
    return bd.Model(body, bd.CellBond(E=1.0, nu=nu), 1.0, boundary=held)


def celerity(model: bd.Model, halves: int, wave: Wave, every: int = 1) -> tuple[float, float]:
    """ω / k of a standing wave from zero crossings of its own part, seen every few steps [m/s], and dt [s]."""
    k = np.pi * halves / LENGTH
    centre = model.lattice.centre
    shape, turn = wave.shape(k, centre[:, 0], DEPTH - centre[:, 2])
    state = model.state()
    state.set_motion(velocity=1e-6 * shape, angular_velocity=1e-6 * turn)
    time, own = [], []

    def look(state: bd.State, record: bd.History) -> None:
        time.append(float(record.time[-1]))
        own.append(float((model.mass[:, None] * shape * state.velocity).sum()))

    duration = PERIODS * 2.0 * np.pi / (k * wave.celerity)
    done = bd.solve_explicit(model, duration=duration, every=every, state=state, callback=look)
    t, p = np.array(time), np.array(own)
    at = np.flatnonzero(p[1:] * p[:-1] < 0.0)
    zero = t[at] - p[at] * (t[at + 1] - t[at]) / (p[at + 1] - p[at])
    return float(np.pi * (len(zero) - 1) / (zero[-1] - zero[0]) / k), done.dt


def measure(
    record: Record, *, counts: tuple[int, ...] = (10_000, 20_000), seeds: tuple[int, ...] = (1, 2),
    nus: tuple[float, ...] = (0.2, 0.4),
) -> None:  # fmt: skip
    """Measure all cases."""
    record.keep(across=ACROSS, theory={str(nu): Wave.of(nu)._asdict() for nu in nus})
    for count, seed in product(counts, seeds):
        body, size = slab(count, seed)
        for nu, halves in product(nus, HALVES):
            case = {"count": count, "seed": seed, "nu": nu, "elements": 2.0 * LENGTH / halves / size}
            record.add(partial(measured, body, nu, halves, case["elements"]), "rows", **case)


def measured(body: bd.Lattice, nu: float, halves: int, elements: float) -> dict[str, float]:
    """Celerity of one wave over theory, and what the length of the step adds to it."""
    wave, every = Wave.of(nu), max(1, int(elements / 20.0))  # at least 60 times a period, or every step
    found, dt = celerity(smooth(body, nu), halves, wave, every)
    turn = 0.5 * dt * np.pi * halves / LENGTH * found
    step = float(turn / np.sin(turn) - 1.0)  # exact for central differences
    return {"depth": 0.5 * halves * DEPTH / LENGTH, "ratio": found / wave.celerity, "step": step}
