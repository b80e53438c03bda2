"""Cracks beside a pressure along them, which has to stay as they open."""

import warnings

import numpy as np

from bondem._names import users_line
from bondem._types import Floats, Ints, Mask
from bondem.errors import FractureEnergyWarning
from bondem.observables.principal_stresses import principal_stresses
from bondem.specimen.tessellation.symmetric_columns import NINE
from bondem.statics.quasistatic.damaged_body import DamagedBody, Loaded

# A facet keeps the pressure along its crack if that is more than this share of the tension across it as it begins.
# Facets whose tension is a smaller share of the pressure than `_OPENS` slide rather than open.
_PRESSED, _OPENS = 0.5, 0.05
# Mean pressure along cracks that lose it, over the strength, beyond which their energy is in doubt.
_LIMIT = 1.0


def _principal(body: DamagedBody, found: Loaded, facets: Ints) -> tuple[Floats, Floats]:
    """Return the largest tension and the largest pressure of the mean stress of both cells at a factor of 1 [Pa]."""
    mean = 0.5 * (found.tensor[body.i[facets]] + found.tensor[body.j[facets]])
    principal = principal_stresses(mean[:, NINE].reshape(-1, 3, 3))
    return principal[:, 0], np.maximum(-principal[:, 2], 0.0)


def pressed_along(body: DamagedBody, found: Loaded, facets: Ints) -> Mask:
    """Return the mask of facets that open beside a pressure along their crack, (c,)."""
    tension, pressure = _principal(body, found, facets)
    return (pressure > _PRESSED * tension) & (tension > _OPENS * pressure)


class LostPressure:
    """Pressure along cracks that lose it as they open, and their strength, summed over their softening steps [N]."""

    def __init__(self, body: DamagedBody, strength: Floats) -> None:
        self._body, self._strength, self._pressure, self._size = body, strength, 0.0, 0.0

    def add(self, found: Loaded, factor: float, facets: Ints) -> None:
        """Add facets (c,) that soften at a factor of the given loads."""
        facets = facets[~self._body.in_one[facets]]
        area = self._body.area[facets]
        self._pressure += factor * float(area @ _principal(self._body, found, facets)[1])
        self._size += float(area @ self._strength[facets])

    def warn(self) -> None:
        """Issue a `FractureEnergyWarning` if the mean pressure exceeds the limit."""
        if self._pressure > _LIMIT * self._size > 0.0:
            warnings.warn(
                f"solve_quasistatic: the pressure along cracks has grown to {self._pressure / self._size:.1f} times the"
                " strength after they began. They lose it as they open, and their energy is in doubt; use"
                " solve_explicit", FractureEnergyWarning, stacklevel=users_line(),
            )  # fmt: skip
