"""Results of a study as the input of its report."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from bondem.calibration.elastic import Calibration, Trial
from bondem.damage.criteria.criterion import Criterion
from bondem.errors import InputError
from bondem.interactions.beams.bond_law import BondLaw
from bondem.interactions.cells.cell_bond import CellBond
from bondem.interactions.law_catalogue import AnyLaw
from bondem.labtests.modal import NaturalFrequencies
from bondem.labtests.outcome import Outcome
from bondem.labtests.tension import Tension
from bondem.specimen.aggregates import Aggregates
from bondem.specimen.fabric import Fabric
from bondem.specimen.lattice import Lattice
from bondem.specimen.layering import Layering, wall_layering
from bondem.specimen.material import Material
from bondem.specimen.radial_distribution import RadialDistribution, radial_distribution


@dataclass(frozen=True, eq=False)
class Bonding:
    """Bond law and density of the elements of a study.

    Attributes:
        law: bond law, calibrated or with E and ν of the material.
        density: density of the elements [kg/m³].
        fit: calibration; None for a law without calibration.
    """

    law: BondLaw | CellBond
    density: float
    fit: Calibration | None = None


@dataclass(frozen=True, eq=False)
class Examined:
    """Packing with the results of its tests.

    Attributes:
        seed: seed of the packing.
        lattice: the specimen.
        quality: fabric of a packing of spheres; None for a body of cells.
        tension: measured E and ν under the law of the study, or None.
        rho: mass of the connected elements over the volume of the shape [kg/m³], or None.
        outcomes: results of the tests, by name.
        frequencies: natural frequencies if a dynamic test was requested, or None.
        law: law of the body, by region if it has aggregates; None for a study without a material.
        aggregates: aggregates of the specimen, or None.
    """

    seed: int
    lattice: Lattice
    quality: Fabric | None = None
    tension: Tension | None = None
    rho: float | None = None
    outcomes: Mapping[str, Outcome] = field(default_factory=dict)
    frequencies: NaturalFrequencies | None = None
    law: AnyLaw | None = None
    aggregates: Aggregates | None = None

    @cached_property
    def layering(self) -> Mapping[str, Layering]:
        """Layering of the packing at each wall, by face; empty for a periodic cell and for a body of cells."""
        return {} if self.quality is None else wall_layering(self.lattice.particles)

    @cached_property
    def distribution(self) -> RadialDistribution | None:
        """Radial distribution of the centres; None for cells, or if too few elements are away from the walls."""
        if self.quality is None:
            return None
        try:
            return radial_distribution(self.lattice.particles)
        except InputError:
            return None


@dataclass(frozen=True, eq=False)
class Findings:
    """Results of a finished study.

    Attributes:
        title: title of the report.
        material: continuum that the bonds have to reproduce; None for a study that packs and checks only.
        bonds: law and density of the bonds of the tests; None for a study that packs and checks only.
        chart: evaluations at 0.6 to 1.4 times the calibrated parameter; empty without a calibration or figures.
        calibrating: number of packings of the calibration, which are the first of `specimens`.
        specimens: all packings, with the results of their tests.
        results: contents of `results.json`.
        citation: source of `published` and `peaks`, or "".
        published: published errors of the tests, by test [-].
        peaks: published range of the peak of the curve of each test, in the SI unit of the curve.
        failures: failure criteria by part of the material.
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
    peaks: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    failures: Mapping[str, Criterion] = field(default_factory=dict)
    source: tuple[str, str] | None = None

    @property
    def fit(self) -> Calibration | None:
        """Calibration of the study, or None."""
        return None if self.bonds is None else self.bonds.fit
