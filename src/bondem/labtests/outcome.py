"""What a test of a specimen returns: a measured number beside the number of theory."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from bondem._drawing import Plotted
from bondem._types import Floats
from bondem.model.state import State


@dataclass(frozen=True, eq=False)
class Outcome(Plotted):
    """One measured quantity of one specimen.

    Attributes:
        name: name of the test, as in `results.json`.
        measured: what the specimen does [unit].
        theory: strength of materials with the paper's lengths (eq 12), Euler–Bernoulli for bending [unit]; NaN where
            there is none.
        unit: SI unit of the three numbers.
        theory_timoshenko: the same with shear deformation, where that differs [unit].
        theory_refined: theory with the specimen's own lengths, between the sets clamped, loaded and measured, and
            the section its own tension test fills: a consistency check, no validation, as it takes the softness of
            the specimen from the specimen (docs/decisions/0004-measures.md) [unit].
        curves: arrays for figures, and further scalars beside the main one.
        told: further numbers for the report, by their name with its unit.
        state: the broken specimen, of a test to failure.
        energy: of a test to failure, `labtests.ledger.energy_ledger` along the curve [J], (k,) each.
    """

    name: str
    measured: float
    theory: float
    unit: str
    theory_timoshenko: float | None = None
    theory_refined: float | None = None
    curves: Mapping[str, np.ndarray] = field(default_factory=dict)
    told: Mapping[str, float] = field(default_factory=dict)
    state: State | None = None
    energy: Mapping[str, Floats] = field(default_factory=dict)

    @property
    def error(self) -> float:
        """Ratio measured / theory - 1 [-]; NaN without theory."""
        return self.measured / self.theory - 1.0

    @property
    def error_timoshenko(self) -> float | None:
        """Ratio measured / theory_timoshenko - 1 [-], or None."""
        return None if self.theory_timoshenko is None else self.measured / self.theory_timoshenko - 1.0

    @property
    def error_refined(self) -> float | None:
        """Ratio measured / theory_refined - 1 [-], or None."""
        return None if self.theory_refined is None else self.measured / self.theory_refined - 1.0
