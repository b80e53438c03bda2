"""Petersson's notched beam in three-point bending: the work of fracture.

Given (a second-hand document of Petersson 1981): 2000 × 200 × 50 mm, a notch of 100 mm at mid-span; E = 30 GPa, ν =
0.2, f_t = 3.33 MPa, G_f = 124 N/m. Held against: the work of the load, G_f b (D - a) = 0.62 J, within 5 %.

Fixed before the runs of the scorecard, as the document does not say it: a span of 2000 mm between lines, with 50 mm
of beam beyond each, which bears nothing; a notch 5 mm wide; no weight of its own, so that the work is that of the
load alone; nothing fails within 0.15 D of the rollers below, whose plates are not known; a density of 2400 kg/m³,
of no account.
"""

from validation.cases.beams import BentBeam
from validation.cases.case import Case, Claim

BEAM = BentBeam(
    length=2.1, depth=0.2, width=0.05, supports=(0.05, 2.05), loaded=1.05, notch=(1.05, 0.1, 5e-3), gauge=None
)
PETERSSON = Case(
    name="petersson",
    title="Petersson",
    E=30e9, nu=0.2, rho=2400.0, tension=3.33e6, fracture_energy=124.0,
    shape=BEAM.shape, about=BEAM.about(10e-3), fine=6e-3, coarse=30e-3,
    path=(0.95, 1.15, 0.0, 0.2),
    driven=BEAM.driven, held=BEAM.held, spared=BEAM.spared(0.15 * 0.2, 0.0),
    claim=Claim("work", 0.95 * 0.62, 1.05 * 0.62, "G_f b (D − a) = 0.62 J ± 5 %"),
    until=0.02,
)  # fmt: skip
