"""Result of a test of a specimen: a measured value beside the theoretical value."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from bondem._drawing import Plotted
from bondem._types import Floats
from bondem.labtests.cracking import Cracking
from bondem.model.state import State


@dataclass(frozen=True, eq=False)
class Outcome(Plotted):
    """Measured quantity of one specimen, with its theoretical values.

    Attributes:
        name: name of the test, as in `results.json`.
        measured: measured value [unit].
        theory: value of beam theory with the paper's lengths (eq 12), Euler–Bernoulli for bending [unit]; NaN without
            theory.
        unit: SI unit of measured and theoretical values.
        theory_timoshenko: theoretical value with shear deformation [unit], or None.
        theory_refined: theoretical value with the lengths between the clamped, loaded and measured elements and the
            section that carries the axial force [unit]. It is a consistency check, not a validation, as it uses the
            measured softness of the specimen (docs/decisions/0004-measures.md).
        curves: arrays for figures, and further scalars of the test.
        told: further numbers for the report, keyed by name with unit.
        cracking: cracks and pieces of the broken specimen and the energy that they took, for tests to failure.
        energy: energy balance along the curve, `labtests.energy_balance.energy_ledger`, for tests to failure [J],
            (k,) each.
    """

    name: str
    measured: float
    theory: float
    unit: str
    theory_timoshenko: float | None = None
    theory_refined: float | None = None
    curves: Mapping[str, np.ndarray] = field(default_factory=dict)
    told: Mapping[str, float] = field(default_factory=dict)
    cracking: Cracking | None = None
    energy: Mapping[str, Floats] = field(default_factory=dict)

    @property
    def state(self) -> State | None:
        """State of the broken specimen, or None."""
        return None if self.cracking is None else self.cracking.state

    @property
    def error(self) -> float:
        """Relative error measured / theory - 1 [-]; NaN without theory."""
        return self.measured / self.theory - 1.0

    @property
    def error_timoshenko(self) -> float | None:
        """Relative error measured / theory_timoshenko - 1 [-], or None."""
        return None if self.theory_timoshenko is None else self.measured / self.theory_timoshenko - 1.0

    @property
    def error_refined(self) -> float | None:
        """Relative error measured / theory_refined - 1 [-], or None."""
        return None if self.theory_refined is None else self.measured / self.theory_refined - 1.0
