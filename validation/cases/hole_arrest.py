"""A crack that runs into a hole and stops: the load at which it starts again on the other side.

A crack that has ended in a hole of radius R is a blunt one. By the criterion of Gómez, Elices and Planas for cohesive
cracks at U-notches (Eng. Fract. Mech. 72, 2005, as we remember it),

    K / K_Ic = √((1 + 0.47392 r + 2.1382 r² + π/4 r³) / (1 + r²)),    r = R / l, l = E' G_f / f_t²,

with K that of a sharp crack of the same length: 1 for a small hole, and Creager and Paris' ½ √(π r) for a large one.
R = l gives 1.483. The compact specimen of `validation.cases.toughness` has a formula for K. Held against 1.483 within
10 %; before the crack reaches the hole K is 1, as there, so that the load has to rise: it is to exceed the least load
after the crack has reached the hole by at least a tenth.

Fixed before the runs: W = 32 l, a notch of 0.4 W, the hole's near side 4 l ahead of it, on the axis of the notch;
cells of 0.2 l from 0.4 l behind the tip to 3 l behind the hole, within 1.4 l to both sides, growing by 0.3 of the
distance to 1.6 l; material and plane strain as in `validation.cases.toughness`; runs to 0.4 of the peak. The crack
has reached the hole with the first facet that loses half of its integrity within 0.3 l before it, and starts behind
it with the first one farther behind it than 0.3 l; K behind it is that of the largest load after the crack has
reached the hole.
"""

import math
from dataclasses import dataclass

import numpy as np

import bondem as bd
from bondem._types import Floats
from validation.cases.case import Claim
from validation.cases.path_case import LOST, Outcome, PathCase
from validation.cases.toughness import LENGTH, TOUGHNESS, CompactTension

#: Width W, notch, distance of the hole's near side from it, and radius of the hole, over l.
OVER, NOTCH, AHEAD, RADIUS = 32.0, 12.8, 4.0, 1.0
_BEHIND, _BESIDE, _COARSE, _NEAR = 3.0, 1.4, 1.6, 0.3
_RIPPLE, _TOGETHER, _UNTIL = 0.05, 0.01, 0.4


def blunt(r: float) -> float:
    """K / K_Ic at which a cohesive crack starts from a U-notch of radius r l [-]."""
    return math.sqrt((1.0 + 0.47392 * r + 2.1382 * r**2 + 0.25 * math.pi * r**3) / (1.0 + r**2))


@dataclass(frozen=True)
class HoleArrest(PathCase):
    """The compact specimen with a hole on the path of its crack."""

    @property
    def plate(self) -> CompactTension:
        """The specimen without hole, whose formula for K is used."""
        return CompactTension(OVER, 0.2 / self.finer)

    @property
    def far(self) -> float:
        """Far side of the hole, x from the line of the load [m]."""
        return (NOTCH + AHEAD + 2.0 * RADIUS) * LENGTH

    @property
    def shape(self) -> bd.Shape:
        plate, unit = self.plate, LENGTH
        hole = bd.Cylinder(radius=RADIUS * unit, length=3.0 * plate.thickness).rotated("y", 0.5 * math.pi)
        at = (self.far - RADIUS * unit, 0.0, 2.0 * plate.thickness)
        return plate.notched(NOTCH * unit, plate.cells * unit).cut(hole.moved(at), name="hole")

    @property
    def size(self) -> bd.Graded:
        plate, unit = self.plate, LENGTH
        place = bd.Box(((0.4 + AHEAD + 2.0 * RADIUS + _BEHIND) * unit, 2.0 * _BESIDE * unit, plate.thickness))
        about = place.moved(((NOTCH - 0.4) * unit, -_BESIDE * unit, 0.0))
        return bd.Graded(fine=plate.cells * unit, coarse=_COARSE * unit, about=about, growth=0.3)

    def run(self, seed: int) -> Outcome:
        body, plate = self.body(seed), self.plate
        model, read = plate.model(body)
        path = bd.solve_quasistatic(model, read, ripple=_RIPPLE, together=_TOGETHER, until=_UNTIL)
        reached, behind = self._events(body, path)
        tough = plate.thickness * math.sqrt(plate.width) * TOUGHNESS
        k = plate.k(self.far / plate.width) / tough
        top = float(path.load[reached:].max()) if behind is not None else math.nan
        least = float(path.load[reached:behind].min()) if behind is not None and behind > reached else math.nan
        first = float(path.load[: reached + 1].max()) * plate.k(NOTCH / OVER) / tough
        return Outcome(
            body=body, integrity=path.bond_integrity, curve=np.column_stack([path.displacement, path.load]),
            values={"K behind": top * k, "rise": top / least, "K at the notch": first},
        )  # fmt: skip

    def _events(self, body: bd.Lattice, path: bd.QuasistaticResult) -> tuple[int, int | None]:
        """Return the event at which the crack reaches the hole, and that at which it starts behind it."""
        assert body.facets is not None
        lost = path.integrity < 1.0 - LOST
        x: Floats = body.facets.centroid[path.bond[lost], 0]
        event, near = path.event[lost], _NEAR * LENGTH
        at = (x > self.far - 2.0 * RADIUS * LENGTH - near) & (x < self.far - 2.0 * RADIUS * LENGTH)
        behind = event[x > self.far + near]
        return int(event[at].min(initial=len(path.load) - 1)), int(behind.min()) if behind.size else None


_EXPECTED = blunt(RADIUS)
HOLE_ARREST = HoleArrest(
    name="hole_arrest", title="Crack that runs into a hole",
    claims=(Claim("K behind", 0.9 * _EXPECTED, 1.1 * _EXPECTED, f"{_EXPECTED:.3f} ± 10 %"),
            Claim("rise", 1.1, math.inf, "above 1.1")),
    window=((NOTCH - 2.0) * LENGTH, (NOTCH + 12.0) * LENGTH, -4.0 * LENGTH, 4.0 * LENGTH),
)  # fmt: skip
