"""Measures of how far an explicit run is from equilibrium."""

import warnings
from collections.abc import Mapping
from dataclasses import dataclass

from bondem._names import users_line
from bondem.errors import NotQuasistaticWarning

# Limits of a quasi-static run: kinetic over elastic energy, difference of the forces at both ends, and error of the
# force of a servo wall, each as a share [-]. An inertial stress of a fifth of the static one has a kinetic energy of
# about a twentieth of the elastic one.
_KINETIC, _DIFFERENCE, _SERVO = 0.05, 0.10, 0.10
_ADVICE = "load more slowly and for longer, or add damping such as bd.LocalDamping(0.2), or do not read it as static"


@dataclass(frozen=True)
class Quasistatic:
    """Measures of how far a run is from equilibrium (`run.quasistatic`).

    `kinetic` and `difference` are near 0 for quasi-static loading.

    Attributes:
        kinetic: largest kinetic energy over the largest elastic energy [-]. If ends are driven, both are sought from
            the first step to the time of the largest elastic energy, and the kinetic energy only until the first bond
            or facet breaks. Otherwise both are sought in the last tenth of the records. None if there are fewer than
            two records, or no elastic energy.
        difference: largest difference between the forces of two force gauges over the largest of these forces [-],
            in the records of `kinetic`. None unless exactly two gauges of the run record opposite forces.
        servo: final force and prescribed final force [N] of each servo wall, by the index of the wall; without walls
            whose prescribed force is 0.
        meant: reason why the run should be quasi-static; empty for other runs, which are not checked.
    """

    kinetic: float | None
    difference: float | None
    servo: Mapping[int, tuple[float, float]]
    meant: str

    @property
    def faults(self) -> tuple[str, ...]:
        """Measures beyond their limits, in words; empty for a quasi-static run, and if `meant` is empty."""
        if not self.meant:
            return ()
        found = [
            f"servo wall {k} presses with {force:.4g} N at the end, not {wanted:.4g} N"
            for k, (force, wanted) in self.servo.items() if abs(force - wanted) > _SERVO * wanted
        ]  # fmt: skip
        if self.kinetic is not None and self.kinetic > _KINETIC:
            found.append(f"its kinetic energy reached {self.kinetic:.2g} of the elastic energy (limit {_KINETIC:g})")
        if self.difference is not None and self.difference > _DIFFERENCE:
            found.append(f"the forces at both ends differed by {self.difference:.2g} of them (limit {_DIFFERENCE:g})")
        return tuple(found)

    def warn(self) -> None:
        """Issue a warning for a run that is meant to be quasi-static and is not.

        Warns:
            NotQuasistaticWarning: A measure is beyond its limit.
        """
        if self.faults:
            warnings.warn(
                f"this run ({self.meant}) is not quasi-static: {'; '.join(self.faults)}; {_ADVICE}",
                NotQuasistaticWarning, stacklevel=users_line(),
            )  # fmt: skip
