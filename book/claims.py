"""The claims of the first page: each is a row, or all rows of a section."""

from collections.abc import Sequence
from dataclasses import dataclass

from book.chapter import Chapter
from book.errors import BookError
from book.questions import CRACKS, PACKINGS, STIFFNESS, STRENGTH, TRUST, WAVES
from book.row import Row


@dataclass(frozen=True)
class Claim:
    """A claim that a referee would check first.

    Attributes:
        question: what it helps a reader to decide.
        says: the claim, as a sentence without its full stop.
        chapter: name of the chapter that measures it.
        place: case of the row that decides, or title of the section whose rows decide.
        measured: how it was measured, without a full stop.
    """

    question: str
    says: str
    chapter: str
    place: str
    measured: str

    def rows(self, chapters: Sequence[Chapter]) -> list[Row]:
        """The rows that decide.

        Raises:
            BookError: no row or section of this name, or more than one.
        """
        mine = [chapter for chapter in chapters if chapter.name == self.chapter]
        sections = [section.rows for one in mine for section in one.sections if section.title == self.place]
        rows = [(row,) for one in mine for row in one.rows if row.case == self.place]
        if len(found := [*sections, *rows]) != 1:
            raise BookError(f"'{self.says}': {len(found)} times '{self.place}' in '{self.chapter}', not once")
        return list(found[0])


_SILICA = "static tests on five packings of 10 000 spheres, bonds calibrated on the first"

CLAIMS = (
    Claim(STIFFNESS, "A body of cells has the Young's modulus and the Poisson's ratio that were entered", "cells",
          "E and ν", "periodic cells and bars, ν from −0.3 to 0.49, five packings"),
    Claim(STIFFNESS, "Bodies of seven shapes agree with finite elements", "cells",
          "Seven shapes beside finite elements", "stiffness and natural frequencies, five materials, five packings"),
    Claim(WAVES, "Plane waves have the celerity of the material", "cells", "Plane waves in the infinite medium",
          "P and S waves of at least 20 elements per wave"),
    Claim(STIFFNESS, "The stress beside a hole agrees with finite elements", "cells", "Stress at a hole",
          "a plate in tension, three sizes of cells"),
    Claim(STRENGTH, "A bar in direct tension has the strength and the fracture energy that were entered", "strength",
          "Direct tension", "plain and notched bars, two fracture energies and brittle facets"),
    Claim(STRENGTH, "A prism in compression has the strength of a Mohr–Coulomb continuum", "strength",
          "Compression between smooth platens", "uniaxial and triaxial compression, two fracture energies of slip"),
    Claim(STRENGTH, "Load factors give the peak of a slow explicit run", "strength", "Without inertia",
          "notched bars, both solvers on the same packings"),
    Claim(TRUST, "The energy balance closes through failure", "strength", "Energy balance",
          "largest residual over the work, all runs of the chapter"),
    Claim(CRACKS, "Published fracture tests follow from published material data", "fracture", "Scorecard",
          "four quasi-static tests of concrete, three packings each, inputs fixed before the runs"),
    Claim(CRACKS, "The crack of Kalthoff and Winkler's plate has the published angle", "fracture",
          "Kalthoff and Winkler's plate", "two strengths from the literature, three packings each"),
    Claim(CRACKS, "Fragments of an expanding ring have the published size", "fracture", "Expanding ring",
          "the formula of Zhou, Molinari and Ramesh, four strain rates"),
    Claim(STRENGTH, "A few numbers of a concrete predict its tests", "predictions", "A concrete",
          "compression, tension and the Brazilian test, nothing calibrated"),
    Claim(STRENGTH, "A few numbers of a granite predict its tests", "predictions", "A granite",
          "compression, tension, Brazilian test and toughness, nothing calibrated"),
    Claim(STRENGTH, "The non-local law reproduces the measured strengths of Celigueta et al. (2020)", "celigueta",
          "The paper's sizes", "the authors' law, criteria, parameters and sizes"),
    Claim(STIFFNESS, "Packings that took no part in the calibration have the E of the data sheet", "andre_tables",
          "E, mean of twelve unseen packings, calibrated on four",
          "four packings calibrate, twelve others are tested"),
    Claim(STIFFNESS, "Packings that took no part in the calibration have the ν of the data sheet", "andre_tables",
          "ν, mean of twelve unseen packings, calibrated on four",
          "four packings calibrate, twelve others are tested"),
    Claim(STIFFNESS, "95 % prediction intervals cover new packings", "calibration",
          "E: unseen packings in the 95 % prediction interval, of 40",
          "eight packings calibrate, 40 others are tested"),
    Claim(STIFFNESS, "The bond parameters printed by André et al. (2012) give the printed E", "protocol",
          "E with the printed bonds: shear compaction, eqs (12)–(15)",
          "the paper's protocol at its coordination number, seeds 1 to 4"),
    Claim(STIFFNESS, "A specimen in tension agrees with strength of materials", "andre_tables",
          "tension, displacement of the free face", _SILICA),
    Claim(STIFFNESS, "A specimen in bending agrees with strength of materials", "andre_tables",
          "bending, deflection of the free face", _SILICA),
    Claim(STIFFNESS, "A specimen in torsion agrees with strength of materials", "andre_tables",
          "torsion, rotation of the free face", _SILICA),
    Claim(WAVES, "The first axial frequency agrees with theory", "andre_tables", "tension, first axial frequency",
          "free vibration and modes of five packings, bonds calibrated on the first"),
    Claim(WAVES, "The first bending frequency agrees with theory", "andre_tables", "bending, first frequency",
          "free vibration and modes of five packings, bonds calibrated on the first"),
    Claim(WAVES, "A wave travels at the celerity of a thin bar", "protocol",
          "celerity, arrival at 50 %: shear compaction",
          "the paper's protocol; arrival at half of the first peak, as the paper does not define it"),
    Claim(PACKINGS, "Dense packings reach the density of the paper", "packings", "φ, cube, limit in N at z = 6.2",
          "22 sizes of up to 50 000 spheres, five seeds each, the limit fitted"),
    Claim(STIFFNESS, "A chain of Timoshenko bonds is a Timoshenko beam at any slenderness", "chen_tables",
          "TBBM, case 1: largest error along the beam", "explicit cantilevers"),
    Claim(STIFFNESS, "A chain of parallel bonds has the published error", "chen_tables",
          "PBM, case 5, equal spheres, against 8.541 mm", "static cantilevers"),
    Claim(STIFFNESS, "Bonds calibrated by layers give any shape within 3 % (experimental, not in the package)",
          "any_specimen", "seed 1, bonds by layer, experimental: how many of 15 are within the limit",
          "constants chosen on seed 101, tested on seed 1"),
    Claim(TRUST, "Momentum is conserved to rounding and energy to second order", "dynamics", "Bond energy",
          "tests of bonds and bodies over 10 000 steps"),
    Claim(TRUST, "A run that is killed resumes with identical bits", "runs", "Runs killed while they write",
          "SIGKILL at random moments"),
    Claim(TRUST, "An explicit step is faster than that of LAMMPS on one core", "cost",
          "bondem over LAMMPS bpm/rotational, one thread each, 10 000 elements",
          "the same lattice, step and machine; ratio of the speeds"),
)  # fmt: skip
