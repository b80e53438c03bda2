"""Failure that leaves the places of rollers out."""

from dataclasses import dataclass

import numpy as np

from bondem._types import Floats, PerBond, PerBond3
from bondem.damage.criteria.rankine import Rankine

# Strength over that of the material where nothing is to fail.
_NEVER = 1e3


@dataclass(frozen=True, kw_only=True)
class SparedRankine(Rankine):
    """`Rankine`, but near lines along z facets do not fail: rollers press through plates that no body here has.

    The force of a line of cells is shear on their flanks, the more the finer they are.

    Attributes:
        lines: x, y and how far about them nothing fails [m].
    """

    lines: tuple[tuple[float, float, float], ...] = ()

    def factors(self, volume: PerBond, place: PerBond3, period: Floats | None, body: float) -> PerBond:
        factor = super().factors(volume, place, period, body)
        for x, y, reach in self.lines:
            factor = np.where(np.hypot(place[:, 0] - x, place[:, 1] - y) < reach, _NEVER, factor)
        return factor
