"""Grégoire's half-notched beam of 50 mm in three-point bending: its peak load.

Given (pypd's data of Grégoire, Rojas-Solano and Pijaudier-Cabot 2013): D = 50 mm, length 3.5 D, span 2.5 D, width
50 mm, notch 0.5 D at mid-span, mouth opening over 20 mm; E = 37 GPa, f_t = 3.9 MPa, G_f = 143.2 N/m, ρ = 2346
kg/m³. Held against: peaks of 933 to 1114 N.

Fixed before the runs of the scorecard: ν = 0.2, which is not given; a notch 2 mm wide; no weight of its own;
nothing fails within 0.15 D of the rollers below and 0.1 D of the one above, whose plates are not known.
"""

from validation.cases.beams import BentBeam
from validation.cases.case import Case, Claim

D = 0.05
BEAM = BentBeam(
    length=3.5 * D, depth=D, width=0.05, supports=(0.5 * D, 3.0 * D), loaded=1.75 * D,
    notch=(1.75 * D, 0.5 * D, 2e-3), gauge=0.02,
)  # fmt: skip
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
