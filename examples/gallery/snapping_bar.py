"""
Snap-back of a notched bar
==========================

Without inertia the load path turns back where the bar snaps, and the solver
follows it: the elongation shrinks while the crack grows.
"""

import bondem as bd

slot = bd.Box((4e-3, 10e-3, 10e-3)).moved((98e-3, 12e-3, 0.0))
whole = bd.Box((200e-3, 20e-3, 10e-3)).cut(slot, name="notch")
centres = bd.pack(whole, count=150, method="even", seed=1)
bar = bd.connect(centres, method="laguerre")
ends = [
    bd.Fix(bd.Face("x_min"), translation="x", rotation=""),
    bd.Drive(bd.Face("x_max"), x=1e-6),
]
mortar = bd.Rankine(tension=4e6, fracture_energy=20.0)  # [Pa], [J/m²]
elastic = bd.CellBond(E=40e9, nu=0.2)
model = bd.Model(bar, elastic, 2400.0, boundary=ends, failure=mortar)
path = bd.solve_quasistatic(model, bd.Face("x_max"), most=600, ripple=0.1)
print(f"peak {path.load.max():.0f} N, {len(path.load)} events")
path.plot("snapping_bar.png")
