"""Record of a laboratory test to failure: all that studies, results and reports know of it."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from bondem._types import Floats
from bondem.damage.cohesive_softening import Softening
from bondem.fracture.fragments import fragments
from bondem.labtests.suited import Suited
from bondem.model.state import State
from bondem.specimen.lattice import Lattice

#: Curve of a test, as two arrays.
Curve = tuple[Floats, Floats]


@dataclass(frozen=True)
class TestOption:
    """Option of a test in a study.

    Attributes:
        unit: SI unit.
        needed: True if the option has no default.
    """

    __test__ = False  # no test of pytest

    unit: str
    needed: bool = False


@dataclass(frozen=True)
class TestFigure:
    """Style of the figures of a test.

    Attributes:
        title: title of its panels.
        strain, stress: quantities of its curve.
        azimuth, elevation: direction of view of the broken specimen [rad].
        slips: True to colour cells by their slip, if there is any.
        halved: True to leave out the nearer half.
        across, up: factor and unit of both axes.
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


def no_theory(softening: Softening, asked: Mapping[str, float]) -> float:
    """Return NaN, for tests without a closed form."""
    return math.nan


def curve_of(result: Any) -> Curve:
    """Return both columns of `result.curve`."""
    return result.curve[:, 0], result.curve[:, 1]


def peak_of(result: Any) -> float:
    """Return `result.peak`."""
    return float(result.peak)


def nothing_of(result: Any) -> dict[str, Any]:
    """Return an empty mapping."""
    return {}


@dataclass(frozen=True, kw_only=True)
class FailureTest:
    """Laboratory test to failure of a body of cells.

    Attributes:
        name: name in studies and results.
        perform: runs the test; called with body, law, failure and, by keyword, density, progress and the options.
        figure: style of its figures.
        options: options in studies, by name.
        suited: specimens that the test needs; None for a bar along x.
        yields: True if the cells of the material have to yield.
        uniform: True if one law and one criterion are needed.
        theory: strength implied by the criterion and the options [unit].
        measured: measured value of a result [unit].
        unit: unit of measured value and theory.
        curve: curve of a result.
        more: further arrays and scalars of a result, for figures.
        told: further numbers of a result, by name with unit; None is left out.
        energy: energy balance along the curve of a result [J], (k,) each.
        integrity: integrity of the facets at the end [-].
        parted: True if fragments are coloured.
    """

    name: str
    perform: Callable[..., Any]
    figure: TestFigure
    options: Mapping[str, TestOption] = field(default_factory=dict)
    suited: Suited | None = None
    yields: bool = False
    uniform: bool = False
    theory: Callable[[Softening, Mapping[str, float]], float] = no_theory
    measured: Callable[[Any], float] = peak_of
    unit: str = "Pa"
    curve: Callable[[Any], Curve] = curve_of
    more: Callable[[Any], Mapping[str, Any]] = nothing_of
    told: Callable[[Any], Mapping[str, float | None]] = nothing_of
    energy: Callable[[Any], Mapping[str, Floats]] = nothing_of
    integrity: Callable[[Any], Floats] = lambda result: result.state.bond_integrity
    parted: bool = False

    def curves(self, result: Any, body: Lattice) -> dict[str, np.ndarray]:
        """Collect the curve of a result, and fields of the broken specimen for figures."""
        state: State = result.state
        across, up = self.curve(result)
        damage = np.zeros(len(body.particles))
        for end in body.pairs.T:
            np.maximum.at(damage, end, 1.0 - self.integrity(result))
        found = {"strain": across, "stress": up} | {name: np.asarray(one) for name, one in self.more(result).items()}
        found |= {"displacement": state.displacement, "orientation": state.orientation, "damage": damage,
                  "slip": state.slipped}  # fmt: skip
        return found | ({"piece": fragments(body, state).label} if self.parted else {})
