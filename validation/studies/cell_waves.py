"""Waves in the infinite medium of cells: their celerity from the longest to the shortest.

A standing plane wave cos(k x) along or across x is let go in a periodic cell; what it does on itself oscillates with
ω(k), which is read from its zero crossings. For long waves ω / k is √((λ + 2G)/ρ) and √(G/ρ) of the material. The
shortest wave that elements carry is two of them long. With lumped masses, and with the dispersion-corrected mass
matrix at the usual time step and at half of it: a step of velocity Verlet adds (ω dt)² / 24 to ω.
"""

from functools import partial
from itertools import product

import numpy as np

import bondem as bd
from bondem.model.model import MassMatrix
from validation.frame.record import Record

LENGTH = 8.0
#: Waves in the length of the cell.
NUMBERS = (1, 2, 3, 4, 6, 8, 12, 16, 24, 32)


#: Mass matrices, and shares of the usual time step.
KINDS: tuple[tuple[MassMatrix, float], ...] = (
    ("lumped", 1.0), ("dispersion-corrected", 1.0), ("dispersion-corrected", 0.5)
)  # fmt: skip


def celerity(model: bd.Model, number: int, axis: int, guess: float, *, share: float = 1.0) -> float:
    """ω / k of a standing wave, from the first zero crossings of its own part, at a share of the usual time step."""
    k = 2.0 * np.pi * number / LENGTH
    wave = np.cos(k * model.lattice.particles.position[:, 0])
    state = model.state()
    velocity = np.zeros((len(wave), 3))
    velocity[:, axis] = 1e-6 * wave
    state.set_motion(velocity=velocity)
    time, own = [], []

    def look(state: bd.State, record: bd.History) -> None:
        time.append(float(record.time[-1]))
        own.append(float((model.mass * wave * state.velocity[:, axis]).sum()))

    period = 2.0 * np.pi / (k * guess)
    dt = None if share == 1.0 else share * bd.solve_explicit(model, duration=0.0).dt
    bd.solve_explicit(model, duration=2.6 * period, dt=dt, every=1, state=state, callback=look)
    t, p = np.array(time), np.array(own)
    at = np.flatnonzero(p[1:] * p[:-1] < 0.0)
    zero = t[at] - p[at] * (t[at + 1] - t[at]) / (p[at + 1] - p[at])
    # quarter, three quarters … of a period
    return float(np.pi * (len(zero) - 1) / (zero[-1] - zero[0]) / k)


def measure(record: Record, *, count: int = 8000, seed: int = 1, nus: tuple[float, ...] = (0.2, 0.4)) -> None:
    """Measure all cases."""
    particles = bd.pack(bd.Cell((LENGTH, 1.0, 1.0)), count=count, spread=0.25, seed=seed)
    body = bd.connect(particles, method="laguerre")
    size = (LENGTH / count) ** (1.0 / 3.0)
    record.keep(count=count, seed=seed)
    for nu, (mass, share) in product(nus, KINDS):
        law = bd.CellBond(E=1.0, nu=nu)
        model = bd.Model(body, law, 1.0, mass_matrix=mass)
        for kind, axis, exact in (("P", 0, np.sqrt(law.lame + 2.0 * law.G)), ("S", 1, np.sqrt(law.G))):
            for number in NUMBERS if mass == "lumped" else NUMBERS[:7]:
                ratio = partial(over, model, number, axis, float(exact), share)
                record.add(ratio, "rows", nu=nu, mass=mass, step=share, wave=kind, elements=LENGTH / number / size)


def over(model: bd.Model, number: int, axis: int, exact: float, share: float) -> dict[str, float]:
    """Celerity of a wave over that of the material."""
    return {"ratio": celerity(model, number, axis, exact, share=share) / exact}
