"""Base class of results that extend the result of one test to failure."""

from dataclasses import dataclass

from bondem._drawing import PlottedState
from bondem._types import Floats
from bondem.labtests.cracking import Cracking
from bondem.labtests.quasi_static_rig import StrengthTest
from bondem.model.state import State


@dataclass(frozen=True, eq=False)
class OfOneTest(PlottedState):
    """Result whose curve, cracks and state are those of `test`, the result of a test to failure."""

    test: StrengthTest

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
