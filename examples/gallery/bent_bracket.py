"""
A bracket under load
====================

A bracket of fused silica is held at its upper end and loaded at the other.
The cells have the E and ν that are entered: nothing is calibrated.
"""

import numpy as np

import bondem as bd

inner = bd.Box((32e-3, 12e-3, 22e-3)).moved((8e-3, 0.0, 8e-3))
bracket = bd.Box((40e-3, 12e-3, 30e-3)).cut(inner, name="inner")
centres = bd.pack(bracket, count=800, method="even", seed=1)
part = bd.connect(centres, method="laguerre")
silica = bd.CellBond(E=72.5e9, nu=0.17)  # [Pa], [-]
held = bd.Fix(bd.Face("z_max"))
load = bd.Load(bd.Face("x_max"), force=(0.0, 0.0, -10.0))  # [N]
model = bd.Model(part, silica, density=2201.0, boundary=[held, load])
bent = bd.solve_static(model)

stress = np.linalg.eigvalsh(bd.cell_stress(model, bent))  # principal [Pa]
mises = np.sqrt(np.square(stress - np.roll(stress, 1, axis=1)).sum(axis=1) / 2)
print(f"largest von Mises stress {mises.max() / 1e6:.2f} MPa")
print(f"the end sinks by {-1e6 * bent.displacement[:, 2].min():.2f} µm")
part.plot("bent_bracket.png", values=mises / 1e6, label="von Mises [MPa]")
