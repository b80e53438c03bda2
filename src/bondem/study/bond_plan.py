"""Table [bond] of a study: bonds between spheres, whose law is calibrated, or a body of cells."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from bondem.calibration.elastic import calibrate
from bondem.calibration.reach import recommend
from bondem.damage.criteria.criterion import BondCriterion, Criterion
from bondem.damage.criteria.mohr_coulomb import MohrCoulomb
from bondem.errors import StudyError
from bondem.interactions.beams.bond_law import BondLaw
from bondem.interactions.cells.cell_bond import CellBond, FacetRotation
from bondem.interactions.law_catalogue import CALIBRATED, CELL_LAWS
from bondem.labtests.failure_tests import FAILURE_TESTS
from bondem.report.findings import Bonding
from bondem.specimen.bonding import connect
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material
from bondem.specimen.particles import Particles
from bondem.study.failure import CRITERIA
from bondem.study.toml_table import TomlTable

# Share of the volume that packed spheres fill [-].
_FILLED = 0.63


@dataclass(frozen=True, kw_only=True)
class BondPlan:
    """Plan of the bonds between spheres and their law.

    Attributes:
        law: class of the bond law to calibrate; None for the one recommended for the material, as in `bd.calibrate`.
        nu_mu: Poisson's ratio of the bonds [-].
        radius_rule: mean radius to which the radius of a bond refers, as for `BondLaw`.
        tolerance: largest gap of a bond, over R̄ [-]; None if `reach` is given.
        reach: largest length of a bond, over Ri + Rj [-], or None.
        of_cells: True for a body of cells; class attribute, like the following ones.
        words: plural nouns for elements and bonds.
        neighbours: estimated number of bonds per element, half the coordination number [-].
        memory: estimated peak memory per element [bytes].
    """

    of_cells: ClassVar[bool] = False
    words: ClassVar[tuple[str, str]] = "spheres", "bonds"
    neighbours: ClassVar[float] = 3.1
    memory: ClassVar[float] = 4e3

    law: type[BondLaw] | None = None
    nu_mu: float = 0.3
    radius_rule: str = "mean"
    tolerance: float | None = 0.0
    reach: float | None = None

    def connect(self, particles: Particles) -> Lattice:
        """Connect the particles of a packing by bonds, or as cells by facets."""
        return connect(particles, tolerance=self.tolerance, reach=self.reach)

    def require_law(self, material: Material) -> None:
        """Raise UnreachableTargetError, before any work, if no recommended law has the ν of a material."""
        if self.law is None:
            recommend(material.nu)

    def of_material(
        self, material: Material, lattices: tuple[Lattice, ...], on_stage: Callable[[str, float], None]
    ) -> Bonding:
        """Calibrate the law to E, ν and ρ of a material on packings; `on_stage` is called with stage and share."""
        on_stage("calibrate", 0.0)
        fit = calibrate(lattices, material, law=self.law, nu_mu=self.nu_mu, radius_rule=self.radius_rule)
        on_stage("calibrate", 1.0)
        return Bonding(law=fit.law, density=fit.density, fit=fit)

    def size(self, volume: float) -> float:
        """Return the diameter of a sphere or the edge of a cell [m], for a volume of the body per element [m³]."""
        return (6.0 * _FILLED * volume / math.pi) ** (1.0 / 3.0)

    def described(self, calibrating: int) -> str:
        """Return a text on the law and the number of packings on which it is calibrated."""
        law = self.law.__name__ if self.law is not None else "recommended for ν"
        return f"{law}, calibrated on {calibrating} packing{'s' * (calibrating > 1)}"

    def heading(self, packings: int, specimen: Mapping[str, Any]) -> list[str]:
        """Return lines of text on the specimens of a study, from "specimen" of its results."""
        return [
            f"packings: {packings} of {specimen['elements']} elements",
            f"  z = {specimen['coordination_number']:.3f}, φ = {specimen['volume_fraction']:.4f}",
        ]

    def require_calibrated(self) -> None:
        """Check that the law is calibrated, so that [calibration] applies; a cell law raises StudyError."""

    def require_centres(self) -> None:
        """Raise StudyError for spheres that hardly touch, bonded where they touch."""
        if not self.tolerance and self.reach is None:
            raise StudyError(
                "'specimen.method' = \"even\" gives centres of cells, spheres that hardly touch; set law ="
                ' "CellBond" in [bond], or leave out method'
            )

    def require_criterion(self, failure: Criterion, tests: list[str]) -> None:
        """Raise StudyError for a criterion or a test to failure that bonds of spheres do not support."""
        if not isinstance(failure, BondCriterion):
            own = [name for name, kind in CRITERIA.items() if issubclass(kind, BondCriterion)]
            raise StudyError(
                f'\'failure.criterion\' = "{type(failure).__name__}" is one of cells; set law = "CellBond" in [bond],'
                f" or a criterion of bonds: {', '.join(own)}"
            )
        only = [one for one in tests if not FAILURE_TESTS[one].bonded]
        if only:
            raise StudyError(f"'tests' contains {only[0]}, a test of cells; set law = \"CellBond\" in [bond]")


@dataclass(frozen=True, kw_only=True)
class CellPlan(BondPlan):
    """Plan of a body of cells.

    Attributes:
        cells: class of the cell law, which replaces the bond law and its calibration.
        facet_rotation: argument of this name of the cell law.
    """

    of_cells: ClassVar[bool] = True
    words: ClassVar[tuple[str, str]] = "cells", "facets"
    neighbours: ClassVar[float] = 7.0
    memory: ClassVar[float] = 9e3

    cells: type[CellBond]
    facet_rotation: FacetRotation = CellBond.facet_rotation

    def connect(self, particles: Particles) -> Lattice:
        return connect(particles, method="laguerre")

    def require_law(self, material: Material) -> None:
        return

    def of_material(
        self, material: Material, lattices: tuple[Lattice, ...], on_stage: Callable[[str, float], None]
    ) -> Bonding:
        """Return the cell law with E and ν of the material, and its density; cells need no calibration."""
        law = self.cells(E=material.E, nu=material.nu, facet_rotation=self.facet_rotation)
        return Bonding(law=law, density=material.rho)

    def size(self, volume: float) -> float:
        return volume ** (1.0 / 3.0)

    def described(self, calibrating: int) -> str:
        return f"{self.cells.__name__}, nothing to calibrate"

    def heading(self, packings: int, specimen: Mapping[str, Any]) -> list[str]:
        return [f"specimens: {packings} of {specimen['elements']} cells, {specimen['bonds']} facets"]

    def require_calibrated(self) -> None:
        raise StudyError(
            f"'calibration': law = \"{self.cells.__name__}\" uses E and nu of the material without"
            " calibration; leave out [calibration]"
        )

    def require_centres(self) -> None:
        return

    def require_criterion(self, failure: Criterion, tests: list[str]) -> None:
        """Raise StudyError for a criterion of beams, or one that lacks properties which cells or the tests need."""
        if isinstance(failure, BondCriterion) and failure.needs_beams:
            raise StudyError(
                f"'failure.criterion' = \"{type(failure).__name__}\" is one of bonds between spheres; leave out law ="
                ' "CellBond" in [bond], or set criterion = "MohrCoulomb"'
            )
        if isinstance(failure, MohrCoulomb) and not failure._softenings:
            raise StudyError("key 'failure.fracture_energy' is missing; cells need it to crack and to yield")
        slipping = [name for name in tests if FAILURE_TESTS[name].yields]
        if slipping and not any(softening.slips for softening in failure._softenings):
            raise StudyError(
                f"'tests' contains {slipping[0]}, which needs a shear strength; set criterion = \"MohrCoulomb\", or"
                ' "DruckerPrager" with a fracture_energy'
            )


def read_bond(table: TomlTable) -> BondPlan:
    """Read the plan of the bonds or of the cells; invalid keys raise StudyError."""
    with table:
        law = table.text("law") if table.has("law") else None
        if law in CELL_LAWS:
            return _cells(table, law)
        reach = table.number("reach", default=None)
        if reach is not None and table.has("tolerance"):
            raise StudyError(
                f"'{table.name('tolerance')}' and '{table.name('reach')}' are both given; give one of them, not both"
            )
        return BondPlan(
            law=CALIBRATED[law] if law is not None else BondPlan.law,
            nu_mu=table.number("nu_mu", default=BondPlan.nu_mu),
            radius_rule=table.text("radius_rule", default=BondPlan.radius_rule),
            tolerance=table.number("tolerance", default=BondPlan.tolerance) if reach is None else None,
            reach=reach,
        )


def _cells(table: TomlTable, law: str) -> CellPlan:
    """Read the plan of a cell law; keys of bonds between spheres raise StudyError."""
    for key in ("nu_mu", "radius_rule", "tolerance", "reach"):
        if table.has(key):
            raise StudyError(
                f"'{table.name(key)}' is an option of bonds between spheres; with law = \"{law}\" cells are joined at"
                " their facets with E and nu of the material; leave it out"
            )
    rotation = table.text("facet_rotation", default=CellPlan.facet_rotation)
    return CellPlan(cells=CELL_LAWS[law], facet_rotation=rotation)
