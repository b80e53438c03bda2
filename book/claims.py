"""The first page: what is claimed, how it was measured, on how many packings, and what failed."""

from collections.abc import Sequence
from dataclasses import dataclass

from book.chapter import Chapter
from book.errors import BookError
from book.row import Row


@dataclass(frozen=True)
class Claim:
    """A row of a chapter that a referee would look at first.

    Attributes:
        says: what is claimed, in words.
        chapter: name of the chapter that holds the row.
        case: of the row.
        theirs: how the paper did it; "" where nothing is printed.
        ours: how we did it.
        unseen: packings that had no part in choosing a constant, or what stands in their place.
    """

    says: str
    chapter: str
    case: str
    theirs: str
    ours: str
    unseen: str

    def row(self, chapters: Sequence[Chapter]) -> Row:
        """Its row.

        Raises:
            BookError: there is none, or more than one.
        """
        found = [row for chapter in chapters if chapter.name == self.chapter for row in chapter.rows
                 if row.case == self.case]  # fmt: skip
        if len(found) != 1:
            raise BookError(f"'{self.says}': {len(found)} rows '{self.case}' in '{self.chapter}' instead of one")
        return found[0]


_BAR = "a cylinder of 10 × 40 mm, about 10 000 spheres"
_SHEAR = "one packing by shear compaction"
_OURS = "bonds calibrated on seed 1, theory with each packing's own E and ν"
_FIVE = "4 of 5"

CLAIMS = (
    Claim("A data sheet's E comes out of packings that were not calibrated on", "andre_tables",
          "E, mean of twelve unseen packings, calibrated on four", "", "four packings calibrate, twelve test", "12"),
    Claim("The same of ν", "andre_tables", "ν, mean of twelve unseen packings, calibrated on four", "",
          "four packings calibrate, twelve test", "12"),
    Claim("95 % prediction intervals hold unseen packings", "calibration",
          "E: unseen packings in the 95 % prediction interval, of 40", "", "eight packings calibrate", "40"),
    Claim("The paper's bonds give the paper's E", "protocol",
          "E with the printed bonds: shear compaction, eqs (12)–(15)", f"{_SHEAR}, z above 6.2; E by eq (14)",
          "the paper's protocol, z = 6.2, seeds 1 to 4", "no constant chosen"),
    Claim("Tension agrees with strength of materials", "andre_tables", "tension, displacement of the free face",
          f"{_SHEAR}, explicit", f"static; {_OURS}", _FIVE),
    Claim("Bending agrees with strength of materials", "andre_tables", "bending, deflection of the free face",
          f"{_SHEAR}, explicit", f"static; {_OURS}", _FIVE),
    Claim("Torsion agrees with strength of materials", "andre_tables", "torsion, rotation of the free face",
          f"{_SHEAR}, explicit", f"static; {_OURS}", _FIVE),
    Claim("First axial frequency", "andre_tables", "tension, first axial frequency", f"{_SHEAR}, free vibration",
          f"free vibration and modes; {_OURS}", _FIVE),
    Claim("First bending frequency", "andre_tables", "bending, first frequency", f"{_SHEAR}, free vibration",
          f"free vibration and modes; {_OURS}", _FIVE),
    Claim("Celerity of a wave", "protocol", "celerity, arrival at 50 %: shear compaction",
          "an initial velocity on one face; when the wave has arrived is not said",
          "the paper's protocol, arrival at half the first peak", "none: each packing calibrates its own bonds"),
    Claim("Dense packings end where the paper's do", "packings", "φ, cube, limit in N at z = 6.2",
          "22 sizes to 50 000 spheres", "22 sizes, five seeds each, limit fitted", "110 packings"),
    Claim("A Timoshenko beam of bonds is one at any slenderness", "chen_tables",
          "TBBM, case 1: largest error along the beam", "explicit", "static and explicit", "no packing"),
    Claim("The parallel bond's error is the paper's", "chen_tables", "PBM, case 5, equal spheres, against 8.541 mm",
          "explicit", "static and explicit", "no packing"),
    Claim("Calibrated by layers, any shape is within 3 % of its continuum (experimental, not public)", "any_specimen",
          "seed 1, bonds by layer, experimental: how many of 15 are within the limit", "",
          "constants chosen on seed 101; seed 1, tried before, failed", "15 specimens"),
    Claim("Faster than LAMMPS on the same bonds and the same core", "cost",
          "bondem over LAMMPS bpm/rotational, one thread each, 10 000 elements", "",
          "the same lattice, step and machine", "no packing"),
)  # fmt: skip
