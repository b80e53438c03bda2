"""Calibration curves of every law, computed once: ν and E/E_μ of packings over the parameter that sets ν.

The files in `curves`, named after laws, have the results of `python -m validation abacus` for periodic cells, as in
figs 15 and 16 of André et al. (2012). If a law has a curve, its calibration starts from the curve, close to the
solution.
"""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from itertools import pairwise
from typing import Any

import numpy as np
from scipy.interpolate import PchipInterpolator
from scipy.optimize import brentq

from bondem._types import Floats
from bondem.interactions.beams.bond_law import BondLaw


@dataclass(frozen=True, eq=False)
class Curve:
    """Calibration curve of a law: ν and E/E_μ of periodic packings with 6.2 contacts per sphere, over one parameter.

    Attributes:
        law: name of the law.
        parameter: name of the varied parameter.
        fixed: values of the other parameters; ν_μ is 0.3.
        values: values of the parameter, ascending [-], shape (k,).
        nu, nu_std: mean and standard deviation of Poisson's ratio over packings [-], shape (k,).
        stiffness_ratio, stiffness_ratio_std: mean and standard deviation of E/E_μ over packings [-], shape (k,).
    """

    law: str
    parameter: str
    fixed: Mapping[str, float]
    values: Floats
    nu: Floats
    nu_std: Floats
    stiffness_ratio: Floats
    stiffness_ratio_std: Floats

    @classmethod
    def read(cls, law: str, data: Mapping[str, Any]) -> "Curve":
        """Create the curve of a law, named `law`, from the parsed JSON of its file."""
        arrays = ("values", "nu", "nu_std", "stiffness_ratio", "stiffness_ratio_std")
        return cls(law, data["parameter"], dict(data["fixed"]),
                   **{name: np.array(data[name], dtype=float) for name in arrays})  # fmt: skip

    @property
    def reach(self) -> tuple[float, float]:
        """Smallest and largest ν of the curve [-]."""
        return float(self.nu.min()), float(self.nu.max())

    def value_for(self, nu: float) -> float | None:
        """Return the parameter value for a given ν [-]; None for ν outside the longest monotone branch of the curve.

        On that branch, `nu_at` is the inverse of this function.
        """
        first, last = self._branch
        low, high = sorted((self.nu[first], self.nu[last]))
        if not low <= nu <= high:
            return None
        known = np.flatnonzero(self.nu[first : last + 1] == nu)
        if len(known):
            return float(self.values[first + known[0]])
        curve = PchipInterpolator(np.log(self.values), self.nu)
        place: Any = brentq(
            lambda place: float(curve(place)) - nu, *np.log(self.values[[first, last]]), xtol=1e-14
        )
        return float(np.exp(place))

    def nu_at(self, value: float) -> float | None:
        """Poisson's ratio ν at a parameter value [-], or None beyond the ends of the curve.

        The interpolation is monotone and cubic in the logarithm of the parameter.
        """
        return self._at(self.nu, value)

    def stiffness_ratio_at(self, value: float) -> float | None:
        """Stiffness ratio E/E_μ at a parameter value [-], or None beyond the ends of the curve."""
        ratio = self._at(np.log(self.stiffness_ratio), value)
        return None if ratio is None else float(np.exp(ratio))

    def _at(self, quantity: Floats, value: float) -> float | None:
        if not self.values[0] <= value <= self.values[-1]:
            return None
        return float(PchipInterpolator(np.log(self.values), quantity)(np.log(value)))

    @property
    def _branch(self) -> tuple[int, int]:
        """Indices of the first and the last value on the longest strictly monotone branch of ν."""
        rising = np.sign(np.diff(self.nu))
        turns = [0, *(np.flatnonzero(rising[1:] != rising[:-1]) + 1), len(rising)]
        first, last = max(pairwise(turns), key=lambda ends: ends[1] - ends[0])
        return int(first), int(last)


@cache
def curve(law: type[BondLaw]) -> Curve | None:
    """Return the calibration curve shipped with bondem for a family of laws, or None."""
    file = files("bondem.calibration").joinpath("curves", f"{law.__name__}.json")
    return Curve.read(law.__name__, json.loads(file.read_text(encoding="utf-8"))) if file.is_file() else None
