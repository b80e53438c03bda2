"""Splitting of a cube between two strips: the splitting stress at the peak.

The standard test (EN 12390-6) takes f_t = 2 P / (π D t). Held against a continuum with one cohesive crack on the axis
of the load (`validation.measures.split_plate`), of the same D, strips, E G_f/f_t² and straight softening, within 5 %.
By elasticity alone strips of 0.16 D give 1.078 f_t there, and 1.057 by Rocco et al. (1999, Mater. Struct. 32, as we
remember it: f_t = 2 P/(π D t) ((1 - β²)^(5/3) - 0.0115)).

Fixed before the runs: a slab of a cube of 100 mm, 12 mm or three cells of 4 mm thick, plane stress; strips 16 mm
wide, pads of the same material two cells high, which do not fail, between smooth platens; E = 30 GPa, ν = 0.2,
f_t = 3 MPa, G_f = 15 J/m², so that E G_f/f_t² = D/2. Load factors, 1500 events at most; the first maximum is the
largest load until the crack is 0.7 D long, of facets without half of their integrity within D/20 of the axis.
"""

from dataclasses import dataclass

import numpy as np

import bondem as bd
from validation.cases.case import Claim
from validation.cases.path_case import LOST, Outcome, PathCase

#: Edge, thickness of the slab and width of the strips [m].
EDGE, SLAB, STRIP = 0.1, 12e-3, 16e-3
#: E [Pa], ν, ρ [kg/m³], f_t [Pa], G_f [J/m²]; the density is of no account.
E, NU, RHO, TENSION, ENERGY = 30e9, 0.2, 2400.0, 3e6, 15.0
# Size of cells, height of the pads and approach of the platens at a factor of 1 [m]; strength of the pads over that
# of the material.
_CELL, _PAD, _WAY, _NEVER = 4e-3, 8e-3, 1e-6, 1e3
_RIPPLE, _TOGETHER, _UNTIL, _MOST = 0.05, 0.01, 0.8, 1500
# Half width of the strip in which the crack is sought, and length at which the first maximum is over, over the edge.
_AXIS, _LONG = 0.05, 0.7


@dataclass(frozen=True)
class SplitCube(PathCase):
    """The slab, its middle at x = y = 0, pressed along y."""

    @property
    def shape(self) -> bd.Shape:
        return bd.Box((EDGE, EDGE, SLAB)).moved((-0.5 * EDGE, -0.5 * EDGE, 0.0))

    @property
    def pads(self) -> bd.Shape:
        """The strips."""
        pad = bd.Box((STRIP, _PAD, SLAB))
        return pad.moved((-0.5 * STRIP, 0.5 * EDGE, 0.0)) | pad.moved((-0.5 * STRIP, -0.5 * EDGE - _PAD, 0.0))

    @property
    def size(self) -> float:
        return _CELL / self.finer

    def packed(self, seed: int) -> bd.Particles:
        return bd.pack(self.shape | self.pads, size=self.size, method="even", seed=seed)

    def run(self, seed: int) -> Outcome:
        body, rest, pads = self.body(seed), bd.Everything(), bd.Within(self.pads)
        own, strong = (
            bd.Rankine(tension=TENSION * by, fracture_energy=ENERGY * by**2, on="stress") for by in (1.0, _NEVER)
        )
        failure: dict[bd.Region | tuple[bd.Region, bd.Region], bd.Criterion] = {
            rest: own,
            pads: strong,
            (rest, pads): strong,
        }
        ends = [bd.Fix(bd.Face("y_min"), translation="y", rotation=""), bd.Drive(bd.Face("y_max"), y=-_WAY)]
        model = bd.Model(body, bd.CellBond(E=E, nu=NU), RHO, failure=failure, boundary=ends)
        path = bd.solve_quasistatic(
            model, bd.Face("y_max"), ripple=_RIPPLE, together=_TOGETHER, until=_UNTIL, most=_MOST
        )
        assert body.facets is not None
        lost = path.integrity < 1.0 - LOST
        place = body.facets.centroid[path.bond[lost]]
        long = (np.abs(place[:, 0]) < _AXIS * EDGE) & (np.abs(place[:, 1]) > 0.5 * _LONG * EDGE)
        over = int(path.event[lost][long].min(initial=len(path.load)))
        stress = 2.0 * path.load / (np.pi * EDGE * SLAB * TENSION)
        return Outcome(
            body=body, integrity=path.bond_integrity, curve=np.column_stack([path.displacement, path.load]),
            values={"splitting stress": float(stress[: over + 1].max()), "onset": float(stress[0])},
        )  # fmt: skip


# `split_plate` of E G_f/f_t² over the edge, the strips and ν; a test computes it again.
_EXPECTED = 1.1088769
SPLIT_CUBE = SplitCube(
    name="split_cube", title="Splitting of a cube",
    claims=(Claim("splitting stress", 0.95 * _EXPECTED, 1.05 * _EXPECTED, f"{_EXPECTED:.3f} f_t ± 5 %"),),
    window=(-0.5 * EDGE, 0.5 * EDGE, -0.5 * EDGE - _PAD, 0.5 * EDGE + _PAD),
)  # fmt: skip
