"""Winkler's L-shaped panel: peak load and load over displacement.

Given (lShapedPanelBenchmark, after Winkler 2001): 500 × 500 × 100 mm without its lower right quarter, the bottom
clamped, pushed up at (470, 250); E = 25.85 GPa, ν = 0.18, G_f = 89 N/m, f_t = 2.65 MPa. Held against: the largest
load of the curve, 7.22 kN, within 10 %; the curve is drawn beside.

Fixed before the runs of the scorecard, as the plate under the load is not known: a force on one row of cells across
the lower side of the arm at x = 470 mm, which may turn and slide; its displacement is that of the curve. Nothing
fails within 30 mm of it. A density of 2400 kg/m³, of no account.
"""

from bondem.geometry.elementary_shapes import Box
from validation.cases.case import Case, Claim, Line

SIDE, ARM, THICK = 0.5, 0.25, 0.1
#: Displacement [m] and load [N], as published.
CURVE = (
    (0.0, 0.0), (0.096e-3, 4.02e3), (0.148e-3, 6.00e3), (0.208e-3, 7.22e3), (0.300e-3, 5.27e3), (0.449e-3, 3.00e3),
    (1.0e-3, 1.04e3),
)  # fmt: skip
L_PANEL = Case(
    name="l_panel",
    title="Winkler's L-shaped panel",
    E=25.85e9, nu=0.18, rho=2400.0, tension=2.65e6, fracture_energy=89.0,
    shape=Box((SIDE, SIDE, THICK)).cut(
        Box((SIDE, 2.0 * ARM, 3.0 * THICK)).moved((SIDE - ARM, -ARM, -THICK)), name="arm"),
    # from the corner to the left, rising a little
    about=(Box((ARM, 0.1, THICK)).moved((0.0, ARM - 0.01, 0.0))
           | Box((1e-6, 1e-6, THICK)).moved((0.47, ARM, 0.0))),
    fine=12e-3, coarse=40e-3,
    path=(0.0, 0.5, 0.0, 0.5),
    driven=(Line(0.47, ARM), 1), clamped=("y_min",), spared=((Line(0.47, ARM), 0.03),),
    claim=Claim("peak", 0.9 * 7220.0, 1.1 * 7220.0, "7.22 kN ± 10 %"),
    curve=CURVE, until=0.12,
)  # fmt: skip
