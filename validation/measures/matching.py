"""Modes of a specimen beside those of the continuum: which is which, by their shapes.

Several modes of one frequency are compared as a group, by the root mean square of their frequencies.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from bondem.statics.modes import ModesResult
from validation.measures.continuum import Vibration


@dataclass(frozen=True)
class Match:
    """A group of modes of one frequency.

    Attributes:
        modes: which ones of the continuum, from 0.
        measured: of the specimen [Hz].
        reference: of the continuum [Hz].
        likeness: least modal assurance criterion of the group [-].
    """

    modes: list[int]
    measured: float
    reference: float
    likeness: float


def groups(frequency: np.ndarray, gap: float = 5e-3) -> list[list[int]]:
    """Modes of one frequency each, to a gap; the last group, which may be incomplete, is left out."""
    found = [[0]]
    for k in range(1, len(frequency)):
        if frequency[k] > (1.0 + gap) * frequency[k - 1]:
            found.append([])
        found[-1].append(k)
    return found[:-1]


def matched(
    found: ModesResult,
    volume: np.ndarray,
    theory: Vibration,
    expected: np.ndarray,
    moving: np.ndarray | slice = slice(None),
) -> Iterator[Match]:
    """Groups of the continuum, each with the modes of the specimen that are most like it.

    Args:
        found: modes of the specimen, more than there are of the continuum.
        volume: of the elements that move [m³].
        theory: modes of the continuum.
        expected: their displacements at these elements, (modes, elements, 3).
        moving: which elements move.
    """
    root = np.sqrt(volume)[:, None]
    pair = found.shape[:, moving, :3], expected
    seen, wanted = ((root * shapes).reshape(len(shapes), -1) for shapes in pair)
    likeness = (seen @ wanted.T) ** 2 / np.outer((seen**2).sum(axis=1), (wanted**2).sum(axis=1))
    for group in groups(theory.frequency):
        alike = likeness[:, group].sum(axis=1)
        best = np.argsort(-alike)[: len(group)]
        one, other = (float(np.sqrt((f**2).mean())) for f in (found.frequency[best], theory.frequency[group]))
        yield Match(group, one, other, float(alike[best].min()))
