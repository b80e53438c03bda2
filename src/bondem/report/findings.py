"""What a study found out, as the report takes it."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from bondem.calibration.elastic import Calibration, Trial
from bondem.labtests.arguments import AnyLaw
from bondem.labtests.modal import NaturalFrequencies
from bondem.labtests.outcome import Outcome
from bondem.labtests.tension import Tension
from bondem.laws.bond import BondLaw
from bondem.laws.cell_bond import CellBond
from bondem.laws.failure.criterion import Criterion
from bondem.specimen.aggregates import Aggregates
from bondem.specimen.fabric import Fabric
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material


@dataclass(frozen=True, eq=False)
class Bonding:
    """What a study bonds its elements with.

    Attributes:
        law: the bond law, calibrated or with the material's own E and ν.
        density: of the elements [kg/m³].
        fit: the calibration; None of a law that needs none.
    """

    law: BondLaw | CellBond
    density: float
    fit: Calibration | None = None


@dataclass(frozen=True, eq=False)
class Examined:
    """One packing and what its tests gave.

    Attributes:
        seed: of the packing.
        lattice: the specimen.
        quality: its fabric.
        tension: its own E and ν under the law of the study, where there is one.
        rho: its own density, mass of the connected elements over the volume of the shape [kg/m³], likewise.
        outcomes: of the tests, by name.
        frequencies: natural frequencies, where a dynamic test was asked for.
        law: what holds it together, by region where there are aggregates in it.
        aggregates: in it, or None.
    """

    seed: int
    lattice: Lattice
    quality: Fabric
    tension: Tension | None = None
    rho: float | None = None
    outcomes: Mapping[str, Outcome] = field(default_factory=dict)
    frequencies: NaturalFrequencies | None = None
    law: AnyLaw | None = None
    aggregates: Aggregates | None = None


@dataclass(frozen=True, eq=False)
class Findings:
    """A finished study.

    Attributes:
        title: of the report.
        material: the continuum that was to be reproduced, or None where only packings were made and checked.
        bonds: what it was tested with, likewise.
        chart: trials over the range of the free parameter, for the calibration curve.
        calibrating: how many packings, the first ones, a calibration used.
        specimens: every packing.
        results: what `results.json` holds.
        citation: where `published` is from, or "".
        published: errors of the tests in print, by name [-].
        failures: how it fails, by the part of it that does.
        source: name and text of the study file, or None.
    """

    title: str
    material: Material | None
    bonds: Bonding | None
    chart: tuple[Trial, ...]
    calibrating: int
    specimens: tuple[Examined, ...]
    results: Mapping[str, Any]
    citation: str = ""
    published: Mapping[str, float] = field(default_factory=dict)
    failures: Mapping[str, Criterion] = field(default_factory=dict)
    source: tuple[str, str] | None = None

    @property
    def fit(self) -> Calibration | None:
        """The calibration, where there was one."""
        return None if self.bonds is None else self.bonds.fit
