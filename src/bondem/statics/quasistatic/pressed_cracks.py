"""Check for cracks that open under pressure along them, which an equilibrium loses as a crack opens."""

import numpy as np

from bondem._names import warn_user
from bondem._types import Ints
from bondem.errors import FractureEnergyWarning
from bondem.observables.principal_stresses import principal_stresses
from bondem.specimen.tessellation.symmetric_columns import NINE
from bondem.statics.quasistatic.damaged_body import DamagedBody, Loaded

# Mean pressure along cracks over the tension across them. Cubes of 400 cells dissipate as much at 1 as without, and
# more at 2, before they end. Facets whose tension is a smaller share of the pressure slide rather than open.
_LIMIT, _OPENS = 1.5, 0.05


class PressedCracks:
    """Sums over the facets that begin to open: pressing and pulling force of their principal stresses [N]."""

    def __init__(self, body: DamagedBody) -> None:
        self._body, self._pressing, self._pulling = body, 0.0, 0.0

    def add(self, found: Loaded, factor: float, facets: Ints) -> None:
        """Add facets (c,) that begin to soften at a factor of the given loads."""
        both = found.tensor[self._body.i[facets]] + found.tensor[self._body.j[facets]]
        principal = principal_stresses(both[:, NINE].reshape(-1, 3, 3))
        pressure, tension = np.maximum(-principal[:, 2], 0.0), principal[:, 0]
        area = np.where(tension > _OPENS * pressure, 0.5 * factor * self._body.area[facets], 0.0)
        self._pressing += float(area @ pressure)
        self._pulling += float(area @ tension)

    def warn(self) -> None:
        """Issue a `FractureEnergyWarning` if the mean pressure along the cracks exceeds the limit."""
        if self._pressing > _LIMIT * self._pulling:
            warn_user(
                f"solve_quasistatic: the pressure along the cracks is {self._pressing / self._pulling:.1f} times the "
                "tension across them. Equilibria lose it where a crack opens, and dissipate too much energy; use "
                "solve_explicit",
                FractureEnergyWarning,
            )
