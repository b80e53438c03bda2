"""Cracks of a specimen after a test to failure, and the energy that they dissipated."""

import math
import warnings
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from bondem._names import users_line
from bondem.dynamics.history import History
from bondem.errors import FractureEnergyWarning
from bondem.fracture.cracks import Cracks, cracks
from bondem.fracture.fragments import Fragments, fragments
from bondem.model.state import State
from bondem.specimen.lattice import Lattice

#: Largest integrity of a facet that counts as cracked [-], as some tests end before the last facets have broken.
CRACKED = 0.1
#: Smallest number of elements of a piece, and of facets of a crack; smaller fragments are counted as crumbs.
FEW = 10
# Energy dissipated per section over that of one crack, above which several cracks dissipated it [-].
_SEVERAL = 1.5


def dissipated_in(history: History) -> dict[str, Any]:
    """Return the energies `dissipated`, `slipped` and `crushed` of a `Cracking` at the end of a run [J], by name."""
    fracture, crushed, slipped = (float(history.energy[name][-1]) for name in ("fracture", "crushing", "plastic"))
    return {"dissipated": fracture + crushed, "slipped": slipped, "crushed": crushed}


@dataclass(frozen=True, eq=False)
class Cracking:
    """Cracks and pieces of a specimen after a test to failure, and the energy that they dissipated.

    Attributes:
        body: lattice of the specimen.
        state: state of the broken specimen.
        integrity: largest integrity of a facet that counts as cracked [-].
        dissipated: energy dissipated by facets until the end of the test, crushing included [J].
        slipped: energy dissipated by yielding cells until the end of the test [J].
        stored: elastic energy of the specimen at the peak load, or the largest one if fragments fly apart [J].
        fracture_energy: fracture energy G_f of the material, or of the matrix [J/m²]; NaN for brittle bonds.
        section: area that a single crack has to cross [m²]; NaN for a test in compression, which has no such section.
        axis: normal of that section, 0, 1 or 2.
        crushed: part of `dissipated` that facets released beyond G_f times their area, or without cohesion [J].
        ended: load at the end of the test over its peak [-]; NaN if it is not known.
    """

    body: Lattice
    state: State
    integrity: float
    dissipated: float
    slipped: float
    stored: float
    fracture_energy: float
    section: float = math.nan
    axis: int = 0
    crushed: float = 0.0
    ended: float = math.nan

    @cached_property
    def found(self) -> Cracks:
        """Cracked facets or broken bonds, grouped into crack surfaces."""
        return cracks(self.body, self.state, integrity=self.integrity)

    @cached_property
    def fragments(self) -> Fragments:
        """Fragments of the specimen, the heaviest first."""
        return fragments(self.body, self.state, integrity=self.integrity)

    @property
    def broken(self) -> int:
        """Number of cracked facets of cells, or of broken bonds of spheres."""
        return len(self.found)

    @property
    def count(self) -> int:
        """Number of cracks: connected surfaces of at least ten facets or bonds; cracks that meet count as one."""
        return int((self.found.surfaces.count >= FEW).sum())

    @property
    def pieces(self) -> int:
        """Number of pieces: fragments of at least ten elements."""
        return int((self.fragments.size >= FEW).sum())

    @property
    def crumbs(self) -> int:
        """Number of fragments of fewer than ten elements."""
        return len(self.fragments) - self.pieces

    @property
    def surface(self) -> float:
        """Total area of all cracked facets, or of the sections of broken bonds [m²]."""
        return self.found.area

    @property
    def brittle(self) -> bool:
        """True for a material without a fracture energy."""
        return math.isnan(self.fracture_energy)

    @property
    def sectioned(self) -> bool:
        """True for a test with a section that a single crack can cross."""
        return not math.isnan(self.section)

    @property
    def projected(self) -> float:
        """Area of all cracks projected on the plane of the section [m²]; NaN without a section."""
        if not self.sectioned:
            return math.nan
        return self.found.projected_area(np.eye(3)[self.axis].tolist()) if len(self.found) else 0.0

    @property
    def per_crack_area(self) -> float:
        """Dissipated energy over the projected area of all cracks [J/m²]; NaN without a section or a crack."""
        return self.dissipated / self.projected if self.projected > 0.0 else math.nan

    @property
    def per_section(self) -> float:
        """Energy dissipated by facets over the section [J/m²], near G_f for a single crack; NaN without a section."""
        return self.dissipated / self.section

    @property
    def stored_ratio(self) -> float:
        """Elastic energy at the peak over the energy of one crack, G_f times the section [-]; NaN without either.

        Above 1 the specimen stores more energy than one crack dissipates, and the equilibrium path snaps back. In
        a test under displacement control the excess drives further cracks and vibrations.
        """
        taken = self.fracture_energy * self.section
        return self.stored / taken if taken > 0.0 else math.nan

    @property
    def single(self) -> bool:
        """True if the work per section is a fracture energy, as the energies allow for one crack only.

        The stored energy is then at most G_f times the section, and the dissipated energy at most 1.5 times this.
        """
        return self.stored_ratio <= 1.0 and self.per_section <= _SEVERAL * self.fracture_energy

    @property
    def mode(self) -> str:
        """Text on the failure: the number of cracks, or in compression whether the specimen split or yielded."""
        if self.sectioned:
            return "cracks once" if self.count == 1 else f"cracks {self.count} times" if self.count else "softens"
        split = "splits" if self.pieces > 1 else "does not split"
        if self.slipped > self.dissipated:
            return f"yields in shear and {split}"
        before = "" if math.isnan(self.ended) else f" before its end at {self.ended:.2f} of the peak"
        return split if self.pieces > 1 or not len(self.found) else f"cracks and {split}{before}"

    @property
    def objection(self) -> str:
        """Reason why the work per section cannot be a fracture energy, with advice; "" if it can."""
        if self.stored_ratio > 1.0:
            return (
                f"at its peak the specimen stores {self.stored_ratio:.3g} times the energy that one crack takes"
                f" (G_f = {self.fracture_energy:.4g} J/m² times the section); use a shorter specimen or a notch, or"
                " bd.labtests.three_point_bending, which follows snap-back"
            )
        if self.per_section > _SEVERAL * self.fracture_energy > 0.0:
            return (
                f"its cracks took {self.per_section / self.fracture_energy:.3g} times the energy of a single one; cut"
                " a notch, so that the specimen cracks once"
            )
        return ""

    def warn(self, test: str) -> None:
        """Issue a FractureEnergyWarning if the work of the test of a given name cannot be a fracture energy."""
        if self.objection:
            warnings.warn(
                f"labtests.{test}: the work per section is not a fracture energy: {self.objection}",
                FractureEnergyWarning, stacklevel=users_line(),
            )  # fmt: skip

    def numbers(self) -> dict[str, Any]:
        """Collect all numbers for `results.json` in SI units; quantities per section are NaN without a section."""
        return {
            "mode": self.mode, "pieces": self.pieces, "crumbs": self.crumbs, "cracks": self.count,
            "broken_bonds": self.broken,
            "crack_area": self.surface, "crack_area_on_section": self.projected, "section": self.section,
            "fracture_energy": self.fracture_energy, "dissipated": self.dissipated,
            "crushed": self.crushed, "slipped": self.slipped,
            "dissipated_per_crack_area": self.per_crack_area, "dissipated_per_section": self.per_section,
            "stored_at_peak": self.stored, "stored_over_one_crack": self.stored_ratio,
            "single_crack": self.single if self.sectioned and not self.brittle else None,
        }  # fmt: skip
