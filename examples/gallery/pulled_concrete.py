"""
Concrete in tension
===================

A bar of concrete is pulled apart.
Strength and fracture energy of the material are entered, and the test returns
the same strength.
"""

import bondem as bd

box = bd.Box((60e-3, 30e-3, 30e-3))  # [m]
centres = bd.pack(box, count=200, method="even", seed=1)
bar = bd.connect(centres, method="laguerre")
concrete = bd.Rankine(tension=4e6, fracture_energy=100.0)  # [Pa], [J/m²]
elastic = bd.CellBond(E=40e9, nu=0.2)  # [Pa], [-]
pulled = bd.labtests.direct_tension(bar, elastic, concrete)
print(f"strength {pulled.peak / 1e6:.3f} MPa")
print(f"work over the section {pulled.work:.1f} J/m²")
pulled.plot("pulled_concrete.png")
