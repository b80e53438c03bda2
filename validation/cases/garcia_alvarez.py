"""García-Álvarez's beam of 80 mm with a notch off its middle: mixed-mode fracture, its peak load.

Given (pypd's data of García-Álvarez, Gettu and Carol 2012): D = 80 mm, width 50 mm, length 3.125 D, supports at
0.3125 D and 2.8125 D, notch 0.25 D deep and 0.625 D off the middle; E = 33.8 GPa, f_t = 3.5 MPa, G_f = 125.2 N/m.
Held against: peaks of 4.89 to 5.41 kN.

Fixed before the runs of the scorecard: ν = 0.2, which is not given; the load half-way between the supports; the
mouth opening between knives 20 mm apart; a notch 2 mm wide; no weight of its own; nothing fails within 0.15 D of
the rollers below and 0.1 D of the one above, whose plates are not known; a density of 2400 kg/m³, of no account.
"""

from validation.cases.beams import BentBeam
from validation.cases.case import Case, Claim

D = 0.08
BEAM = BentBeam(
    length=3.125 * D, depth=D, width=0.05, supports=(0.3125 * D, 2.8125 * D), loaded=1.5625 * D,
    notch=((1.5625 - 0.625) * D, 0.25 * D, 2e-3), gauge=0.02,
)  # fmt: skip
GARCIA_ALVAREZ = Case(
    name="garcia_alvarez",
    title="García-Álvarez, D = 80 mm, notch off the middle",
    E=33.8e9, nu=0.2, rho=2400.0, tension=3.5e6, fracture_energy=125.2,
    shape=BEAM.shape, about=BEAM.about(3e-3, towards=0.625 * D), fine=5e-3, coarse=14e-3,
    path=(0.5 * D, 2.0 * D, 0.0, D),
    driven=BEAM.driven, held=BEAM.held, spared=BEAM.spared(0.15 * D, 0.1 * D), mouth=BEAM.mouth,
    until=0.5,
    claim=Claim("peak", 4890.0, 5410.0, "4.89–5.41 kN measured"),
)  # fmt: skip
