"""Damping of modes of a free bar of cells by `bd.BondDamping(beta)`, over Rayleigh's β ω / 2, from the decay of runs.

Damping in proportion to the stiffness would give 1. Dashpots of facets stand beside their springs, on the line of the
centres; the energy of cells has the dilatation too, and facets open at their centroids.
"""

import math
from functools import partial
from itertools import product

import numpy as np

import bondem as bd
from validation.frame.record import Record
from validation.measures.accuracy_problems import cells_of

SIZE, E, RHO = (40e-3, 8e-3, 8e-3), 70e9, 2500.0
SEEDS, COUNTS, NUS, MODES = (1, 2, 3), (200, 1000), (0.0, 0.2, 0.45), 6
#: Share of critical damping that is entered, amplitude [m], periods of a run, and least share of it that is read.
SHARE, AMPLITUDE, PERIODS, READ = 0.03, 1e-7, 5.2, 0.2


def damping_of_mode(model: bd.Model, frequency: float, shape: np.ndarray) -> float:
    """Damping of a run that starts in a mode, over β ω / 2, by the decay of the largest displacement."""
    omega = 2.0 * math.pi * frequency
    scale = AMPLITUDE * omega / np.abs(shape[:, :3]).max()
    state = model.state()
    state.set_motion(velocity=scale * shape[:, :3], angular_velocity=scale * shape[:, 3:])
    element, axis = np.unravel_index(np.abs(shape[:, :3]).argmax(), (len(shape), 3))
    run = bd.solve_explicit(
        model, duration=PERIODS / frequency, every=5, state=state, damping=bd.BondDamping(beta=2.0 * SHARE / omega),
        gauges={"moved": bd.Gauge(bd.Index([int(element)]), "displacement")},
    )  # fmt: skip
    moved = np.abs(run.history["moved"][:, axis])
    inner = moved[1:-1]
    peaks = inner[(inner > moved[:-2]) & (inner >= moved[2:]) & (inner > READ * moved.max())]
    slope = np.polyfit(np.arange(len(peaks)), np.log(peaks), 1)[0]
    return -float(slope) / math.pi / SHARE


def damped(body: bd.Lattice, nu: float) -> dict[str, list[float]]:
    """Damping of the first modes of one bar over β ω / 2."""
    model = bd.Model(body, bd.CellBond(E=E, nu=nu), RHO)
    found = bd.solve_modes(model, count=MODES)
    modes = zip(found.frequency, found.shape, strict=True)
    return {"modes": [round(damping_of_mode(model, float(frequency), shape), 4) for frequency, shape in modes]}


def measure(
    record: Record, *, seeds: tuple[int, ...] = SEEDS, counts: tuple[int, ...] = COUNTS, nus: tuple[float, ...] = NUS
) -> None:
    """Measure bars.

    Args:
        seeds: of the packings.
        counts: numbers of cells.
        nus: Poisson's ratios.
    """
    for count, seed in product(counts, seeds):
        body = cells_of(bd.Box(SIZE), count, seed)
        for nu in nus:
            record.add(partial(damped, body, nu), count=count, seed=seed, nu=nu)
