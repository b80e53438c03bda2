"""A run of a case up to several numbers of steps, and one whose start is disturbed by a rounding.

Where two revisions differ by more than the given
limit, a second run of the old one, whose initial positions are disturbed by one rounding of each coordinate, shows
how far the motion itself amplifies roundings.
"""

import warnings
from pathlib import Path

import numpy as np

import bondem as bd
from bits.bodies import ALL
from bits.case import Case, set_threads

# Columns of the energies in the records of a history.
_ENERGIES = slice(1, 14)


def close(
    name: str, size: int, marks: list[int], folder: str, dt: float | None = None, seed: int | None = None,
    share: float = 1.0,
) -> dict:  # fmt: skip
    """Run a case up to each number of steps in `marks`, and leave MARK.npz in the folder for each.

    Args:
        name: of the case.
        size: elements, about.
        marks: numbers of steps.
        folder: where the files are written.
        dt: time step [s]; the share of the critical one that the case names when None.
        share: of that time step.
        seed: of a disturbance of the initial positions by one rounding; None for no disturbance.

    Returns:
        dt, elements, bonds, broken bonds and cracked facets, contacts and how the last run ended.
    """
    warnings.simplefilter("ignore", UserWarning)
    set_threads(1)
    case = ALL[name](size)
    chosen = _run(case, case.model.state(), duration=0.0, safety=case.share, every=0).dt
    dt = share * chosen if dt is None else dt
    for mark in marks:
        state = case.start(dt)
        if seed is not None:
            _disturb(state, seed)
        result = _run(case, state, duration=mark * dt, dt=dt, every=max(1, mark // 10))
        last = result.state
        np.savez(
            Path(folder) / f"{mark}.npz", position=last.local_position, displacement=last.displacement,
            orientation=last.orientation, velocity=last.velocity, energy=result.history.records[:, _ENERGIES],
            rest=last.rest, failed=np.array([len(last.broken), len(last.cracks), len(last.softened)]),
        )  # fmt: skip
    lattice = case.model.lattice
    return {
        "dt": dt, "chosen": chosen, "elements": len(lattice.particles), "bonds": len(lattice.pairs),
        "failed": len(last.broken) + len(last.cracks) + len(last.softened),
        "touching": len(last.touching) + len(last.wall_touching), "status": result.status.name,
    }  # fmt: skip


def _run(case: Case, state: bd.State, **options: object):
    return bd.solve_explicit(case.model, **(case.options | options | {"state": state}))


def _disturb(state: bd.State, seed: int) -> None:
    upward = np.random.default_rng(seed).random((len(state.pose), 3)) < 0.5
    place = state.pose[:, :3]
    place[:] = np.nextafter(place, np.where(upward, np.inf, -np.inf))
    state.stale = True
