"""Numbers of a study as JSON and tables have them."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

#: A curve in `results.json` has no more points than this.
POINTS = 300


def plain(value: Any) -> Any:
    """The same as JSON can hold it: null where there is no finite number."""
    if isinstance(value, Mapping):
        return {str(name): plain(item) for name, item in value.items()}
    if isinstance(value, np.ndarray):
        return plain(value.tolist())
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    if isinstance(value, np.integer):
        return int(value)
    if isinstance(value, float):
        return float(value) if math.isfinite(value) else None
    return value


def column(rows: Sequence[Mapping[str, Any]], name: str) -> np.ndarray:
    """One column of rows, (k,)."""
    return np.array([row[name] for row in rows], dtype=float)


def rounded(values: Any, digits: int) -> list[float]:
    """Numbers to so many digits."""
    return [float(f"{value:.{digits}g}") for value in np.asarray(values).tolist()]


def thinned(curve: np.ndarray) -> np.ndarray:
    """Every k-th sample of a long curve along its first axis, at most `POINTS`."""
    return curve[:: max(math.ceil(len(curve) / POINTS), 1)]


def mean_and_scatter(values: Sequence[float]) -> dict[str, float | None]:
    """Mean and standard deviation over packings, null for one packing."""
    return {
        "mean": float(np.mean(values)),
        "std": float(np.std(values, ddof=1)) if len(values) > 1 else None,
    }
