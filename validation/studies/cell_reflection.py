"""Plane pulses of P and S in a bar of cells: what a free end and an absorbing face send back.

A Gaussian pulse of velocity, five, ten or twenty cells wide at half its height, travels along x, with the
displacement and rotation of a wave that goes one way only. The sides are held so that plane waves are exact
solutions. For P, velocity along x, their normal displacement is zero. For S, velocity along y, the sides y are held
along x and the sides z along z. A slab of two cells sees the pulse go and come back: a Gaussian is fitted to the
upper part of each peak of its mean velocity v. Reported are least, median and largest of the packings of

    celerity    from the start to the slab, over √((λ + 2G)/ρ) or √(G/ρ)
    travel      height of the pulse at the slab over that at the start
    amplitude   largest |v| that comes back over that of the pulse: 1 at a free end, 0 at an absorbing face
    energy      ∫ v² dt of what comes back over that of the pulse, likewise
    left        energy in the whole bar in the end over that at the start
    delay       time from the pulse to its return, over that by the exact celerity; of a free end

Where a run at the usual step, 0.9 of the critical one, is unstable, it is repeated at half that; "unstable" counts
these packings.
"""

from itertools import product
from typing import Any

import numpy as np
from scipy.special import erf

import bondem as bd
from bondem.model.model import MassMatrix
from validation.frame.record import Record, spread

#: In widths of the pulse: length of the bar, centre of the pulse at the start, place of the slab, standard deviation
#: of the pulse, and its way in a run.
LENGTH, START, SLAB, SIGMA, WAY = 5.6, 2.0, 3.8, 1.0 / np.sqrt(8.0 * np.log(2.0)), 7.0
#: Half the thickness of the slab [cells].
HALF = 1.0
SPEED = 1e-6
#: Energy of an unstable run over that at its start, or more.
GROWN = 1.05
MASSES: tuple[MassMatrix, ...] = "lumped", "dispersion-corrected"
ENDS = "free", "absorbing"
#: Sides of the bar, and along which axis they are held.
SIDES = {"P": {"y": "y", "z": "z"}, "S": {"y": "x", "z": "z"}}


def start(model: bd.Model, wave: str, c: float, width: float) -> bd.State:
    """The pulse at its start, v = f(x - c t): displacement, velocity, and for S the rotation ½ u′."""
    sigma, axis = SIGMA * width, np.eye(3)["PS".index(wave)]
    x = (model.lattice.centre[:, 0] - START * width) / sigma
    f = SPEED * np.exp(-0.5 * x**2)
    state = model.state()
    state.displacement = np.outer(-SPEED * sigma / c * np.sqrt(0.5 * np.pi) * erf(x / np.sqrt(2.0)), axis)
    state.velocity = np.outer(f, axis)
    if wave == "S":
        state.orientation = np.column_stack([np.ones_like(f), np.outer(-0.25 * f / c, [0.0, 0.0, 1.0])])
        state.angular_velocity = np.outer(-0.5 * x * f / sigma, [0.0, 0.0, 1.0])
    return state


def peak(time: np.ndarray, v: np.ndarray) -> tuple[float, float]:
    """Time and height of a pulse, by the Gaussian through the upper part of its peak."""
    top = int(np.argmax(v))
    low = np.flatnonzero(v < 0.6 * v[top])
    part = slice(low[low < top][-1] + 1, low[low > top][0])
    t, scale = time[top], time[-1] - time[0]
    a, b, height = np.polyfit((time[part] - t) / scale, np.log(v[part]), 2)
    return float(t - scale * b / (2.0 * a)), float(np.exp(height - b * b / (4.0 * a)))


def pulse(model: bd.Model, wave: str, c: float, width: float, *, free: bool) -> dict[str, float]:
    """What one pulse does, and whether the usual step is unstable."""
    found = passage(model, wave, c, width, free=free)
    return (found or passage(model, wave, c, width, free=free, safety=0.45) or {}) | {"unstable": not found}


def passage(
    model: bd.Model, wave: str, c: float, width: float, *, free: bool, safety: float = 0.9
) -> dict[str, float] | None:
    """What one pulse does in a run; None if the run is unstable."""
    x, axis = model.lattice.centre[:, 0], "PS".index(wave)
    time, seen = [], []

    def mean(state: bd.State, place: float) -> float:
        weight = model.mass * (np.abs(x - place) < HALF)
        return float(weight @ state.velocity[:, axis] / weight.sum())

    def look(state: bd.State, record: bd.History) -> None:
        time.append(float(record.time[-1]))
        seen.append(mean(state, SLAB * width))

    begun = start(model, wave, c, width)
    run = bd.solve_explicit(
        model, duration=WAY * width / c, every=1, safety=safety, state=begun, callback=look, imbalance=None
    )
    energy = run.history.energy
    stored: Any = sum(energy[part] for part in ("translation", "rotation", "normal", "shear", "bending", "twisting"))
    if run.status != bd.Status.COMPLETED or np.max(stored) > GROWN * stored[0]:
        return None
    t, v = np.array(time), np.array(seen)
    first = t < (LENGTH - START) * width / c
    gone, height = peak(t[first], v[first])
    row = {
        "celerity": (SLAB - START) * width / (c * gone), "travel": height / mean(begun, START * width),
        "amplitude": float(np.abs(v[~first]).max()) / height,
        "energy": float((v[~first] ** 2).sum() / (v[first] ** 2).sum()), "left": float(stored[-1] / stored[0]),
    }  # fmt: skip
    if free:
        back, top = peak(t[~first], v[~first])
        row |= {"amplitude": top / height, "delay": (back - gone) * c / (2.0 * (LENGTH - SLAB) * width)}
    return row


def measure(
    record: Record, *, count: int = 1950, seeds: tuple[int, ...] = (1, 2, 3), nus: tuple[float, ...] = (0.2, 0.4),
    widths: tuple[float, ...] = (5.0, 10.0, 20.0),
) -> None:  # fmt: skip
    """Measure pulses of several widths, in cells."""
    rows: list[dict[str, Any]] = []
    for width in widths:
        across = float(np.sqrt(count / (LENGTH * width)))
        box = bd.Box((LENGTH * width, across, across))
        packings = [bd.pack(box, count=count, method="even", seed=seed) for seed in seeds]
        bodies = [bd.connect(particles, method="laguerre") for particles in packings]
        for nu, wave, end, mass in product(nus, SIDES, ENDS, MASSES):
            law = bd.CellBond(E=1.0, nu=nu)
            c = float(np.sqrt(law.G if wave == "S" else law.lame + 2.0 * law.G))
            conditions: list[bd.BoundaryCondition] = [
                bd.Fix(bd.Face(f"{face}_{which}"), translation=held, rotation="")
                for face, held in SIDES[wave].items()
                for which in ("min", "max")
            ]
            if end == "absorbing":
                conditions.append(bd.Absorbing(bd.Face("x_max"), density=1.0, E=1.0, nu=nu))
            models = [bd.Model(body, law, 1.0, boundary=conditions, mass_matrix=mass) for body in bodies]
            found = [pulse(model, wave, c, width, free=end == "free") for model in models]
            unstable = sum(one.pop("unstable") for one in found)
            values = {name: spread([one[name] for one in found]) for name in found[0]}
            row = {"width": width, "nu": nu, "wave": wave, "end": end, "mass": mass, "unstable": unstable}
            rows.append(row | values)
            medians = ", ".join(f"{name} {value['median']:.4g}" for name, value in values.items())
            print(f"{width:g} cells, ν = {nu}, {wave}, {end} end, {mass}: {medians}, unstable {unstable}", flush=True)
    record.keep(count=count, seeds=seeds, rows=rows)
