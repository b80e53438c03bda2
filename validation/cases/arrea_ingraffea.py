"""Arrea and Ingraffea's notched beam in four-point shear, series B: peak load and path of the crack.

Given: 1322 × 306 × 156 mm, a notch of 82 mm at mid-length; forces F 61 mm from the notch and 0.13 F at 458 mm from
it, and the supports opposite, antisymmetric about the notch (Arrea and Ingraffea 1982). The report could not be read;
geometry and E = 24.8 GPa, ν = 0.18, f_t = 2.8 MPa, G_f = 100 N/m are those of later simulations, as the report
gives neither f_t nor G_f. Held against figures of such simulations, read from memory and therefore wide: F at the
peak 120 to 160 kN; the crack curves towards the nearer force on the other side, 20 to 100 mm off the notch at 0.75 to
0.95 of the depth.

Fixed before the runs: a slab of 45 mm, three cells, whose forces count 156/45 times; cells of 15 mm between the inner
forces, 40 mm elsewhere; a notch one cell wide; softening along Petersson's two lines; forces on one row of cells
each, in balance, about which nothing fails within a tenth of the depth.
"""

from dataclasses import dataclass

import numpy as np

import bondem as bd
from validation.cases.case import Claim, Line
from validation.cases.path_case import Outcome, PathCase, cracked
from validation.cases.spared import SparedRankine

#: Length, depth, thickness of the test and of the slab, depth and width of the notch [m].
LENGTH, DEPTH, THICK, SLAB, NOTCH, SLIT = 1.322, 0.306, 0.156, 45e-3, 82e-3, 15e-3
#: E [Pa], ν, ρ [kg/m³], f_t [Pa], G_f [J/m²]; the density is of no account.
E, NU, RHO, TENSION, ENERGY = 24.8e9, 0.18, 2400.0, 2.8e6, 100.0
#: How far from the notch the inner and the outer forces act [m], and the outer force over the inner one [-].
INNER, OUTER, SHARE = 61e-3, 458e-3, 0.13
# Sizes of cells [m], load at a factor of 1 [N], band of softening, load factors that count as one, and load over its
# peak at which a run ends.
_FINE, _COARSE, _LOAD, _RIPPLE, _TOGETHER, _UNTIL = 15e-3, 40e-3, 1e3, 0.05, 0.01, 0.3
# Share of the depth at which the crack is read, and distance from a force within which nothing fails, over the depth.
_READ, _SPARED = (0.75, 0.95), 0.1
# A force is a line; so thin is the box about which cells are fine [m].
_THIN = 1e-6


@dataclass(frozen=True)
class ShearBeam(PathCase):
    """The beam, its notch from below; the inner force acts from above to the left of it."""

    @property
    def shape(self) -> bd.Shape:
        slot = bd.Box((SLIT, 2.0 * NOTCH, 3.0 * SLAB)).moved((0.5 * (LENGTH - SLIT), -NOTCH, -SLAB))
        return bd.Box((LENGTH, DEPTH, SLAB)).cut(slot, name="notch")

    @property
    def lines(self) -> dict[str, tuple[Line, float]]:
        """Lines of the four forces, and the force over F, up positive."""
        middle = 0.5 * LENGTH
        far, near = middle - OUTER, middle + INNER
        forces = ((middle - INNER, 1.0), (middle + OUTER, SHARE))
        left = sum(force * (near - x) for x, force in forces) / (near - far)
        return {
            "inner force": (Line(forces[0][0], DEPTH), -1.0), "outer force": (Line(forces[1][0], DEPTH), -SHARE),
            "outer support": (Line(far, 0.0), left), "inner support": (Line(near, 0.0), 1.0 + SHARE - left),
        }  # fmt: skip

    @property
    def size(self) -> bd.Graded:
        about: bd.Shape = bd.Box((2.0 * INNER + 60e-3, DEPTH, SLAB)).moved((0.5 * LENGTH - INNER - 30e-3, 0.0, 0.0))
        for line, _ in self.lines.values():
            about = about | bd.Box((_THIN, _THIN, SLAB)).moved((line.x, min(line.y, DEPTH - _THIN), 0.0))
        return bd.Graded(fine=_FINE / self.finer, coarse=_COARSE / self.finer, about=about, growth=0.3)

    def run(self, seed: int) -> Outcome:
        body = self.body(seed)
        loads: list[bd.BoundaryCondition] = [line.load(body, by * _LOAD) for line, by in self.lines.values()]
        spared = tuple((line.x, line.y, _SPARED * DEPTH) for line, _ in self.lines.values())
        failure = SparedRankine(tension=TENSION, fracture_energy=ENERGY, curve=bd.Bilinear(), lines=spared)
        model = bd.Model(body, bd.CellBond(E=E, nu=NU), RHO, failure=failure, boundary=loads)
        pushed, below = (self.lines[name][0].cells(body) for name in ("inner force", "outer support"))
        path = bd.solve_quasistatic(
            model, pushed, ripple=_RIPPLE, together=_TOGETHER, until=_UNTIL, gauges={"way": (below, pushed)}
        )
        whole = THICK / SLAB
        place, area = cracked(body, path.bond_integrity)
        high = (place[:, 1] > _READ[0] * DEPTH) & (place[:, 1] < _READ[1] * DEPTH)
        high &= np.abs(place[:, 0] - 0.5 * LENGTH) < DEPTH
        off = 0.5 * LENGTH - np.average(place[high, 0], weights=area[high]) if high.any() else np.nan
        return Outcome(
            body=body, integrity=path.bond_integrity, values={"peak": path.peak * whole, "off the notch": float(off)},
            curve=np.column_stack([-path.gauge["way"][:, 1], path.load * whole]),
        )  # fmt: skip


ARREA_INGRAFFEA = ShearBeam(
    name="arrea_ingraffea", title="Arrea and Ingraffea, four-point shear",
    claims=(Claim("peak", 120e3, 160e3, "120–160 kN (figures)"),
            Claim("off the notch", 20e-3, 100e-3, "20–100 mm (figures)")),
    window=(0.5 * LENGTH - 0.2, 0.5 * LENGTH + 0.2, 0.0, DEPTH),
)  # fmt: skip
