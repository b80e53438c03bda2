"""How far two runs are apart.

Differences are relative: of positions to the largest displacement and to the size of the body, of velocities to the
largest velocity, of energies to the largest energy of the run. The largest of all elements and records counts.
"""

from pathlib import Path

import numpy as np

#: What is compared; the second has the same difference as the first, in units of the size of the body.
QUANTITIES = ("displacement", "size", "velocity", "energy")


def apart(first: Path, second: Path) -> dict[str, float]:
    """Largest relative differences of two files of `close`, by the names of `QUANTITIES`."""
    with np.load(first) as a, np.load(second) as b:
        moved = _farthest(a["position"], b["position"])
        scale = _scale(a["displacement"])
        found = {
            "displacement": moved / scale if scale else moved,
            "size": moved / float(np.ptp(a["rest"], axis=0).max()),
            "velocity": _farthest(a["velocity"], b["velocity"]) / (_scale(a["velocity"]) or 1.0),
            "energy": _farthest(a["energy"], b["energy"]) / (_scale(a["energy"]) or 1.0),
        }
        return found | {"failed": float(np.abs(a["failed"] - b["failed"]).max())}


def _farthest(a: np.ndarray, b: np.ndarray) -> float:
    return float(np.abs(a - b).max()) if a.shape == b.shape else float("inf")


def _scale(values: np.ndarray) -> float:
    return float(np.nanmax(np.abs(values), initial=0.0))
