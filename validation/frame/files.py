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


def thinned(curve: np.ndarray) -> np.ndarray:
    """Every k-th sample of a long curve along its first axis, at most `POINTS`."""
    return curve[:: max(math.ceil(len(curve) / POINTS), 1)]


def mean_and_scatter(values: Sequence[float]) -> dict[str, float | None]:
    """Mean and standard deviation over packings, null for one packing."""
    return {
        "mean": float(np.mean(values)),
        "std": float(np.std(values, ddof=1)) if len(values) > 1 else None,
    }


def table(caption: str, head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A Markdown table below its caption."""
    lines = [caption, "", f"| {' | '.join(head)} |", f"|{'---|' * len(head)}"]
    return "\n".join([*lines, *(f"| {' | '.join(row)} |" for row in rows)]) + "\n"


def in_percent(value: Mapping[str, float | None], digits: int = 2) -> str:
    """Mean ± scatter of a ratio, in per cent."""
    mean, std = value["mean"], value["std"]
    assert mean is not None
    text = f"{100.0 * mean:+.{digits}f}".replace("-", "−")
    return text if std is None else f"{text} ± {100.0 * std:.{digits}f}"
