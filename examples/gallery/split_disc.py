"""
Brazilian test
==============

A disc of concrete splits between two platens.
"""

import bondem as bd

disc = bd.Cylinder(radius=25e-3, length=10e-3)  # [m]
centres = bd.pack(disc, count=300, method="even", seed=1)
body = bd.connect(centres, method="laguerre")
concrete = bd.MohrCoulomb(
    tension=4e6, cohesion=14.3e6, friction_angle=0.61, fracture_energy=20.0
)  # [Pa], [Pa], [rad], [J/m²]
elastic = bd.CellBond(E=40e9, nu=0.2)
split = bd.labtests.brazilian(body, elastic, concrete)
print(f"splitting strength {split.peak / 1e6:.2f} MPa")
split.plot("split_disc.png", view=(80.0, 10.0))
