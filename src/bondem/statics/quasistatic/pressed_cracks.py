"""Cracks with a pressure parallel to their faces; this pressure must not fall as the cracks open."""

import numpy as np

from bondem._names import warn_user
from bondem._types import Floats, Ints, Mask
from bondem.errors import FractureEnergyWarning
from bondem.observables.principal_stresses import principal_stresses
from bondem.specimen.tessellation.symmetric_columns import NINE
from bondem.statics.quasistatic.damaged_body import DamagedBody, Loaded

# A facet keeps the pressure along its crack if that is more than this share of the tension across it as it begins.
# Facets whose tension is a smaller share of the pressure than `_OPENS` slide rather than open.
_PRESSED, _OPENS = 0.1, 0.05
# Mean pressure along cracks that lose it, over the strength, beyond which their energy is in doubt. It is below 0.04
# in bars and beams, and 0.26 in a bar that dissipates 1.29 G_f.
_LIMIT = 0.2


def _stresses(body: DamagedBody, found: Loaded, facets: Ints) -> tuple[Floats, Floats]:
    """Return the largest principal tension and pressure of the mean stress of both cells [Pa], (c,) each.

    Both are for a factor of 1, and 0 for facets that slide rather than open.
    """
    mean = 0.5 * (found.tensor[body.i[facets]] + found.tensor[body.j[facets]])
    principal = principal_stresses(mean[:, NINE].reshape(-1, 3, 3))
    tension, pressure = principal[:, 0], np.maximum(-principal[:, 2], 0.0)
    opens = tension > _OPENS * pressure
    return np.where(opens, tension, 0.0), np.where(opens, pressure, 0.0)


def pressed_along(body: DamagedBody, found: Loaded, facets: Ints) -> Mask:
    """Return a mask of the facets that open under a pressure parallel to their crack, (c,)."""
    tension, pressure = _stresses(body, found, facets)
    return pressure > _PRESSED * tension


class LostPressure:
    """Pressure parallel to cracks that lose it, and strength of all cracks, summed over their softening steps [N]."""

    def __init__(self, body: DamagedBody, strength: Floats) -> None:
        self._body, self._strength, self._pressure, self._size = body, strength, 0.0, 0.0

    def add(self, found: Loaded, factor: float, facets: Ints) -> None:
        """Add facets (c,) that soften at a factor of the given loads."""
        area, loses = self._body.area[facets], ~self._body.in_one[facets]
        self._pressure += factor * float((area * loses) @ _stresses(self._body, found, facets)[1])
        self._size += float(area @ self._strength[facets])

    def warn(self) -> None:
        """Issue a `FractureEnergyWarning` if the mean pressure exceeds the limit."""
        if self._pressure > _LIMIT * self._size > 0.0:
            warn_user(
                f"solve_quasistatic: a pressure along cracks grows to {self._pressure / self._size:.1f} times the"
                " strength after they began. They lose it as they open, and their energy is in doubt; apply the"
                " pressure first, or use solve_explicit", FractureEnergyWarning,
            )  # fmt: skip
