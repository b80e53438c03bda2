"""Grégoire's half-notched beams in three-point bending: peak loads of several depths.

Given (pypd's data of Grégoire, Rojas-Solano and Pijaudier-Cabot 2013): length 3.5 D, span 2.5 D, width 50 mm, notch
0.5 D at mid-span, D = 50 (mouth opening over 20 mm), 100, 200 mm; E = 37 GPa, f_t = 3.9 MPa, G_f = 143.2 N/m, ρ =
2346 kg/m³. Held against: peaks of 933 to 1114 N of D = 50 mm; those of the others were not to be had.

Fixed before the runs of the scorecard: ν = 0.2, which is not given; a notch 2 mm wide; no weight of its own;
nothing fails within 0.15 D of the rollers below and 0.1 D of the one above, whose plates are not known. Cells are in
proportion to D, but for the width, which is the same for all.
"""

import math
from dataclasses import replace

from validation.cases.beams import BentBeam
from validation.cases.case import Case, Claim

D = 0.05


def beam(depth: float) -> BentBeam:
    """The geometry of a depth [m]."""
    return BentBeam(
        length=3.5 * depth, depth=depth, width=0.05, supports=(0.5 * depth, 3.0 * depth), loaded=1.75 * depth,
        notch=(1.75 * depth, 0.5 * depth, 2e-3), gauge=0.02,
    )  # fmt: skip


BEAM = beam(D)
GREGOIRE = Case(
    name="gregoire",
    title="Grégoire, D = 50 mm, half notched",
    E=37e9, nu=0.2, rho=2346.0, tension=3.9e6, fracture_energy=143.2,
    shape=BEAM.shape, about=BEAM.about(2e-3), fine=2.3e-3, coarse=10e-3,
    path=(1.25 * D, 2.25 * D, 0.0, D),
    driven=BEAM.driven, held=BEAM.held, spared=BEAM.spared(0.15 * D, 0.1 * D), mouth=BEAM.mouth,
    until=0.5,
    claim=Claim("peak", 933.0, 1114.0, "933–1114 N measured"),
)  # fmt: skip


def scaled(depth: float) -> Case:
    """The test on a beam of another depth [m], to its peak, with cells in proportion."""
    one, by = beam(depth), depth / D
    return replace(
        GREGOIRE, name=f"gregoire_{1e3 * depth:g}", title=f"Grégoire, D = {1e3 * depth:g} mm, half notched",
        shape=one.shape, about=one.about(2e-3 * by), fine=GREGOIRE.fine * by, coarse=GREGOIRE.coarse * by,
        path=(1.25 * depth, 2.25 * depth, 0.0, depth), driven=one.driven, held=one.held,
        spared=one.spared(0.15 * depth, 0.1 * depth), mouth=None, until=0.8,
        claim=Claim("peak", 0.0, math.inf, "no published value"),
    )  # fmt: skip
