"""Base class of results that extend the result of one test to failure."""

from dataclasses import dataclass

from bondem._drawing import PlottedState
from bondem._types import Floats
from bondem.labtests.cracking import Cracking
from bondem.labtests.quasi_static_rig import StrengthTest
from bondem.model.state import State


@dataclass(frozen=True, eq=False)
class OfOneTest(PlottedState):
    """Result that extends `test`, the result of a test to failure; both have the same numbers, cracks and state."""

    test: StrengthTest

    @property
    def peak(self) -> float:
        """Largest stress of the curve [Pa]."""
        return self.test.peak

    @property
    def E(self) -> float:
        """Slope of the stress over the strain from 0.1 to 0.5 of the peak [Pa]; see `StrengthTest.E`."""
        return self.test.E

    @property
    def curve(self) -> Floats:
        """Strain [-] and stress [Pa] of each record, positive along the load, (k, 2)."""
        return self.test.curve

    @property
    def work(self) -> float:
        """Work of platens and loads until the end, per area of the broken section [J/m²]."""
        return self.test.work

    @property
    def table(self) -> dict[str, Floats]:
        """Curve, with time and energies of its records, by name and unit, (k,) each."""
        return self.test.table

    @property
    def cracking(self) -> Cracking:
        """Cracks and pieces of the broken specimen, and the dissipated energy."""
        return self.test.cracking

    @property
    def state(self) -> State:
        """State of the broken specimen."""
        return self.test.state
