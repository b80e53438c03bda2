"""Lac du Bonnet granite: one input, and the four tests that are held against its published strengths.

Given, by a second-hand document and a public code: E = 69 GPa, ν = 0.26; direct tension 6.9 MPa; K_Ic = 1.14 to 1.89
MPa√m over two granites, which gives G_f = 17.6 to 48 N/m; from memory: c = 30 MPa, φ = 59° and the specimen, Ø31.7 ×
63.4 mm. Held against: UCS 200 ± 22 MPa, direct tension 6.9 MPa within
10 %, Brazilian 8.8 to 9.3 MPa, K_Ic 1.14 to 1.89 MPa√m. Mohr and Coulomb give 216 MPa by this c and φ.

Fixed before the first run, as it is not known: G_f = 32.8 N/m, the middle of its range, so that √(E G_f) = 1.50
MPa√m; straight softening; G_II = 10 G_f, the default; no dilatancy; smooth platens. Brazilian: a disc Ø54 × 27 mm
(ISRM's smallest) with flats of 20°. K_Ic: the load at the peak of a beam in three-point bending, of ASTM E399's
proportions (span 4 W, notch 0.5 W and 1 mm wide, W/2 thick, W = 50 mm), by the formula of that standard. Its process
zone, E G_f/f_t² = 48 mm, is as long as the beam is deep: a beam of W = 200 mm is run beside it, without a verdict.
"""

import math
from dataclasses import dataclass

from bondem.damage.criteria.mohr_coulomb import MohrCoulomb
from bondem.geometry.elementary_shapes import Cylinder
from bondem.interactions.cells.cell_bond import CellBond
from validation.cases.beams import BentBeam
from validation.cases.case import Case, Claim
from validation.cases.flattened_disc import FlattenedDisc


@dataclass(frozen=True)
class Granite:
    """What is put in.

    Attributes:
        E, nu: [Pa, -].
        tension, cohesion: [Pa].
        friction_angle: [rad].
        fracture_energy: [J/m²].
    """

    E: float = 69e9
    nu: float = 0.26
    tension: float = 6.9e6
    cohesion: float = 30e6
    friction_angle: float = math.radians(59.0)
    fracture_energy: float = 32.8

    @property
    def law(self) -> CellBond:
        """Its elasticity."""
        return CellBond(E=self.E, nu=self.nu)

    @property
    def failure(self) -> MohrCoulomb:
        """Its strength."""
        return MohrCoulomb(
            tension=self.tension, cohesion=self.cohesion, friction_angle=self.friction_angle,
            fracture_energy=self.fracture_energy,
        )  # fmt: skip

    @property
    def compressive(self) -> float:
        """UCS by Mohr and Coulomb [Pa]."""
        sine = math.sin(self.friction_angle)
        return 2.0 * self.cohesion * math.cos(self.friction_angle) / (1.0 - sine)

    @property
    def toughness(self) -> float:
        """√(E G_f) [Pa√m]."""
        return math.sqrt(self.E * self.fracture_energy)


#: The specimen of compression and of direct tension, and the disc.
CORE = Cylinder(radius=0.5 * 31.7e-3, length=63.4e-3)
DISC = FlattenedDisc(diameter=54e-3, thickness=27e-3)
#: What each test is held against: quantity as tables have it, from, to.
CLAIMS = {
    "ucs": Claim("UCS", 178e6, 222e6, "200 ± 22 MPa"),
    "direct_tension": Claim("direct tension", 0.9 * 6.9e6, 1.1 * 6.9e6, "6.9 MPa"),
    "brazilian": Claim("Brazilian strength", 8.8e6, 9.3e6, "8.8–9.3 MPa"),
    "toughness": Claim("K_Ic", 1.14e6, 1.89e6, "1.14–1.89 MPa√m"),
}


def bent(granite: Granite, depth: float) -> Case:
    """A notched beam of ASTM E399's proportions, of a depth W [m]; 17 cells in W at `finer=1` where it cracks."""
    W, reach = depth, 0.5 * depth
    beam = BentBeam(
        length=4.0 * W + 2.0 * reach, depth=W, width=0.5 * W, supports=(reach, reach + 4.0 * W),
        loaded=reach + 2.0 * W, notch=(reach + 2.0 * W, 0.5 * W, 1e-3), gauge=0.2 * W,
    )  # fmt: skip
    return Case(
        name=f"beam_{1e3 * W:g}mm", title=f"notched beam, W = {1e3 * W:g} mm", E=granite.E, nu=granite.nu, rho=2630.0,
        tension=granite.tension, fracture_energy=granite.fracture_energy,
        shape=beam.shape, about=beam.about(0.05 * W), fine=0.06 * W, coarse=0.25 * W,
        path=(reach + 1.5 * W, reach + 2.5 * W, 0.0, W), driven=beam.driven, held=beam.held,
        spared=beam.spared(0.15 * W, 0.1 * W), mouth=beam.mouth, until=0.1, claim=CLAIMS["toughness"],
    )  # fmt: skip


def toughness(load: float, depth: float) -> float:
    """K of a beam of `bent` under a load [N], by ASTM E399 for a span of 4 W [Pa√m]."""
    a, W = 0.5, depth
    shape = 1.5 * math.sqrt(a) * (1.99 - a * (1.0 - a) * (2.15 - 3.93 * a + 2.7 * a**2))
    return 4.0 * load / (0.5 * W**1.5) * shape / ((1.0 + 2.0 * a) * (1.0 - a) ** 1.5)
