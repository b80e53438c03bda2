"""Result of a test of a specimen: a measured value and its theoretical value."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from bondem._drawing import Plotted, Present
from bondem._types import Floats
from bondem.labtests.cracking import Cracking
from bondem.model.state import State

# Tables of elastic tests: ending of the file name, then key in `Outcome.curves` and label of each column.
_SIGNALS = (
    ("", (("x", "x [m]"), ("profile", "motion of the section [m or rad]"))),
    ("", (("time", "time [s]"), ("near", "velocity of struck face [m/s]"), ("far", "velocity of far face [m/s]"))),
    ("", (("time", "time [s]"), ("signal", "mean motion of the free end [m or rad]"))),
    ("_spectrum", (("frequency", "frequency [Hz]"), ("amplitude", "amplitude [m or rad]"))),
)  # fmt: skip


@dataclass(frozen=True, eq=False)
class Outcome(Plotted):
    """Measured quantity of one specimen, with its theoretical values.

    Attributes:
        name: name of the test, as in `results.json`.
        measured: measured value [unit].
        theory: theoretical value [unit]: the strength of the material, or beam theory with L_M of eq (12) of André et
            al. (2012), Euler–Bernoulli's for bending; NaN without one.
        unit: SI unit of measured and theoretical values.
        theory_timoshenko: theoretical value with shear deformation [unit], or None.
        theory_refined: theoretical value with the lengths between the clamped, loaded and measured elements and the
            section that carries the axial force [unit]. It is a consistency check, not a validation, as it uses the
            measured softness of the specimen (docs/decisions/0004-measures.md).
        curves: arrays for figures, and further scalars of the test.
        axes: names and units of "strain" and "stress" in the curves of tests to failure.
        told: further numbers for the report, keyed by name with unit.
        cracking: cracks and pieces of the broken specimen and the energy that they dissipated, for tests to failure.
        energy: energy balance along the curve of tests to failure [J], (k,) each, by `energy_ledger`.
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
    axes: tuple[str, str] = ("strain [-]", "stress [Pa]")

    @property
    def tables(self) -> dict[str, dict[str, Floats]]:
        """Curves as tables of columns by name and unit, each under the ending of its file name."""
        found: dict[str, dict[str, Floats]] = {}
        if "strain" in self.curves:
            curve = dict(zip(self.axes, (self.curves["strain"], self.curves["stress"]), strict=True))
            found[""] = curve | {f"{part} [J]": values for part, values in self.energy.items()}
        return found | {
            ending: {label: self.curves[key] for key, label in named}
            for ending, named in _SIGNALS if all(key in self.curves for key, _ in named)
        }  # fmt: skip

    @property
    def table(self) -> dict[str, Floats]:
        """Curve by name and unit, or the measured and theoretical values if there is no curve."""
        values = {
            "measured": self.measured, "theory": self.theory, "theory with shear": self.theory_timoshenko,
            "refined theory": self.theory_refined,
        }  # fmt: skip
        row = {f"{name} [{self.unit}]": np.array([one]) for name, one in values.items() if one is not None}
        return next(iter(self.tables.values()), row)

    @property
    def state(self) -> State | None:
        """State of the broken specimen; None for an elastic test."""
        return None if self.cracking is None else self.cracking.state

    @property
    def _pictures(self) -> tuple[Present, ...]:
        return () if self.cracking is None else (Present(self.cracking.state),)

    @property
    def error(self) -> float:
        """Relative error measured / theory - 1 [-]; NaN without theory."""
        return self.measured / self.theory - 1.0

    @property
    def error_timoshenko(self) -> float | None:
        """Relative error measured / theory_timoshenko - 1 [-]; None without this theory."""
        return None if self.theory_timoshenko is None else self.measured / self.theory_timoshenko - 1.0

    @property
    def error_refined(self) -> float | None:
        """Relative error measured / theory_refined - 1 [-]; None without this theory."""
        return None if self.theory_refined is None else self.measured / self.theory_refined - 1.0
