"""Description of a laboratory test to failure, from which studies run it and reports draw it."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from bondem._types import Floats
from bondem.damage.cohesive_softening import Softening
from bondem.labtests.cracking import Cracking
from bondem.labtests.requirements import Requirements
from bondem.specimen.lattice import Lattice

# SI unit of a display unit.
_SI = {"10$^{-3}$": "-", "µs": "s", "µm": "m", "MPa": "Pa", "kN": "N", "m/s": "m/s"}
#: Curve of a test, as two arrays.
Curve = tuple[Floats, Floats]


@dataclass(frozen=True)
class TestOption:
    """Option of a test in a study: a number above 0 and below `below`, in an SI unit.

    A `closed` option may also be 0. A `needed` option has no default.
    """

    __test__ = False  # no test of pytest

    unit: str
    needed: bool = False
    closed: bool = False
    below: float = math.inf


@dataclass(frozen=True)
class TestFigure:
    """Style of the figures of a test.

    Attributes:
        title: title of its panels.
        strain, stress: names of the quantities of its curve, on the horizontal and on the vertical axis.
        azimuth, elevation: direction of view of the broken specimen [rad].
        slips: True to colour yielded cells by their slip.
        halved: True to leave out the half of the specimen in front.
        across, up: factor on SI values, and unit, of the horizontal and of the vertical axis.
        plain: quantity of the horizontal axis for a specimen without a notch; "" if a notch makes no difference.
        quantity: name of the measured value.
        line: True to draw the strength of the material, where it is known.
    """

    __test__ = False

    title: str
    strain: str = "strain"
    stress: str = "stress"
    azimuth: float = math.radians(28.0)
    elevation: float = math.radians(24.0)
    slips: bool = False
    halved: bool = False
    across: tuple[float, str] = (1e3, "10$^{-3}$")
    up: tuple[float, str] = (1e-6, "MPa")
    line: bool = True
    plain: str = ""
    quantity: str = "strength"

    @property
    def units(self) -> tuple[str, str]:
        """SI units of both axes."""
        return _SI[self.across[1]], _SI[self.up[1]]

    @property
    def axes(self) -> tuple[str, str]:
        """Names and SI units of both axes."""
        return f"{self.strain} [{self.units[0]}]", f"{self.stress} [{self.units[1]}]"


def _nothing(result: Any) -> dict[str, Any]:
    """Return an empty mapping, for a test without further numbers."""
    return {}


@dataclass(frozen=True, kw_only=True)
class FailureTest:
    """Laboratory test to failure, with functions that evaluate its result.

    Attributes:
        name: name in studies and results.
        perform: function of body, law, failure and, by keyword, density, progress and options that runs the test.
        figure: style of its figures.
        options: options in studies, by name.
        requirements: specimens that the test needs; None for a bar along x.
        yields: True if the criterion needs a shear strength, so that cells can yield.
        uniform: True if laws and criteria by region are not supported.
        bonded: True if the test accepts bonded spheres.
        theory: function of softening law and options that returns the theoretical strength [unit]; NaN without one.
        measured: function of the result that returns the measured value [unit].
        unit: unit of measured value and theory.
        curve: function of the result that returns both columns of its curve.
        more: function of the result that returns further arrays and scalars for figures.
        details: function of the result that returns further numbers by name with unit; None is left out.
        energy: function of the result that returns the energy balance along its curve [J], (k,) each.
        integrity: function of the result that returns the final integrity of bonds or facets [-], (m,).
        cracking: function of result, body and fracture energy of the material [J/m²] that returns the cracks.
    """

    name: str
    perform: Callable[..., Any]
    figure: TestFigure
    options: Mapping[str, TestOption] = field(default_factory=dict)
    requirements: Requirements | None = None
    yields: bool = False
    uniform: bool = False
    bonded: bool = True
    theory: Callable[[Softening, Mapping[str, float]], float] = lambda softening, asked: math.nan
    measured: Callable[[Any], float] = lambda result: float(result.peak)
    unit: str = "Pa"
    curve: Callable[[Any], Curve] = lambda result: (result.curve[:, 0], result.curve[:, 1])
    more: Callable[[Any], Mapping[str, Any]] = _nothing
    details: Callable[[Any], Mapping[str, float | None]] = _nothing
    energy: Callable[[Any], Mapping[str, Floats]] = _nothing
    integrity: Callable[[Any], Floats] = lambda result: result.state.bond_integrity
    cracking: Callable[[Any, Lattice, float], Cracking] = lambda result, body, fracture_energy: result.cracking

    def figure_of(self, curves: Mapping[str, Any]) -> TestFigure:
        """Return the style of the figures of a specimen; a plain beam has the key "plain" in its `Outcome.curves`."""
        return replace(self.figure, strain=self.figure.plain) if "plain" in curves else self.figure

    def curves(self, result: Any, cracking: Cracking) -> dict[str, np.ndarray]:
        """Collect the curve of a result and the fields of the broken specimen for figures, as arrays by name."""
        state, body = cracking.state, cracking.body
        across, up = self.curve(result)
        damage = np.zeros(len(body.particles))
        for end in body.pairs.T:
            np.maximum.at(damage, end, 1.0 - self.integrity(result))
        return {
            "strain": across, "stress": up, **{name: np.asarray(one) for name, one in self.more(result).items()},
            "displacement": state.displacement, "orientation": state.orientation, "damage": damage,
            "slip": state.slipped, "piece": cracking.fragments.label,
        }  # fmt: skip
