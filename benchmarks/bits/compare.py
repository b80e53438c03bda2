"""Comparison of result files of two revisions by bytes."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np


@dataclass(frozen=True)
class Difference:
    """Difference between two runs: the first array that is not the same.

    Attributes:
        array: name of the array.
        what: description of the difference.
        pause: way in which the run was interrupted.
    """

    array: str
    what: str
    pause: str

    def __str__(self) -> str:
        return f"{self.array}: {self.what} ({self.pause})"


def differing(old: Path, new: Path, pause: str) -> Difference | None:
    """Return the first difference between two files of arrays, or None if every byte is the same."""
    with np.load(old) as a, np.load(new) as b:
        for name in sorted({*a.files, *b.files}, key=lambda name: (*a.files, *b.files).index(name)):
            if name not in a.files or name not in b.files:
                return Difference(name, f"only in the {'old' if name in a.files else 'new'} one", pause)
            what = _unlike(a[name], b[name])
            if what:
                return Difference(name, what, pause)
    return None


def _unlike(a: np.ndarray, b: np.ndarray) -> str:
    if a.dtype != b.dtype or a.shape != b.shape:
        return f"{a.dtype.name} {a.shape}, now {b.dtype.name} {b.shape}"
    if a.tobytes() == b.tobytes():
        return ""
    if a.dtype.kind not in "fiu":
        return f"{a}, now {b}"
    x, y = a.astype(float), b.astype(float)
    with np.errstate(invalid="ignore"):
        far = np.nanmax(np.abs(x - y), initial=0.0)
        scale = np.nanmax(np.abs(x), initial=0.0)
    count = int((~((x == y) & (np.signbit(x) == np.signbit(y)))).sum())
    return f"{far:.1e} of {scale:.1e}, in {count} of {a.size}"
