"""The calibration curves of every law, computed once: ν and E/E_μ of packings over the parameter that sets ν.

The files in `curves`, named after laws, are what `python -m validation abacus` found in periodic cells: André et al.
(2012), figs 15 and 16. Where a curve is, the search for the value of a parameter starts next to its end.
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
from bondem.laws.bond import BondLaw


@dataclass(frozen=True, eq=False)
class Curve:
    """ν and E/E_μ of packings of 6.2 contacts a sphere, in bulk, over one parameter of a law.

    Attributes:
        law: name of the law.
        parameter: name of its parameter that varies.
        fixed: its other parameters; ν_μ is 0.3.
        values: of the parameter, ascending [-], shape (k,).
        nu, nu_std: mean and standard deviation of Poisson's ratio over packings [-], shape (k,).
        stiffness_ratio, stiffness_ratio_std: those of E/E_μ [-], shape (k,).
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
        """The curve of a law, as `python -m validation abacus` writes it."""
        arrays = ("values", "nu", "nu_std", "stiffness_ratio", "stiffness_ratio_std")
        return cls(law, data["parameter"], dict(data["fixed"]),
                   **{name: np.array(data[name], dtype=float) for name in arrays})  # fmt: skip

    @property
    def reach(self) -> tuple[float, float]:
        """Smallest and largest ν on the curve [-]."""
        return float(self.nu.min()), float(self.nu.max())

    def value_for(self, nu: float) -> float | None:
        """The value of the parameter that gives ν [-], or None where the curve does not reach.

        The inverse of `nu_at`; where ν turns, on the longer branch.
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
        """ν at a value of the parameter [-], or None beyond the ends of the curve.

        Monotone cubic interpolation over the logarithm of the parameter.
        """
        return self._at(self.nu, value)

    def stiffness_ratio_at(self, value: float) -> float | None:
        """E/E_μ at a value of the parameter [-], or None beyond the ends of the curve."""
        ratio = self._at(np.log(self.stiffness_ratio), value)
        return None if ratio is None else float(np.exp(ratio))

    def _at(self, quantity: Floats, value: float) -> float | None:
        if not self.values[0] <= value <= self.values[-1]:
            return None
        return float(PchipInterpolator(np.log(self.values), quantity)(np.log(value)))

    @property
    def _branch(self) -> tuple[int, int]:
        """Ends of the longest stretch over which ν is strictly monotone."""
        rising = np.sign(np.diff(self.nu))
        turns = [0, *(np.flatnonzero(rising[1:] != rising[:-1]) + 1), len(rising)]
        first, last = max(pairwise(turns), key=lambda ends: ends[1] - ends[0])
        return int(first), int(last)


def curve(law: type[BondLaw]) -> Curve | None:
    """The curve that comes with bondem for a family of laws, or None."""
    return _shipped(law.__name__)


@cache
def _shipped(law: str) -> Curve | None:
    file = files("bondem.calibration").joinpath("curves", f"{law}.json")
    return Curve.read(law, json.loads(file.read_text(encoding="utf-8"))) if file.is_file() else None
