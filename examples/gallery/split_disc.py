"""A disc of concrete splits between two platens; red cells have lost facets."""

import matplotlib.pyplot as plt
import numpy as np

import bondem as bd

disc = bd.connect(bd.pack(bd.Cylinder(25e-3, 10e-3), count=300, method="even", seed=1), method="laguerre")
concrete = bd.MohrCoulomb(tension=4e6, cohesion=14.3e6, friction_angle=0.61, fracture_energy=20.0)
split = bd.labtests.brazilian(disc, bd.CellBond(E=40e9, nu=0.2), concrete)
lost = np.bincount(disc.pairs.ravel(), np.repeat(1.0 - split.state.bond_integrity, 2)) / 13.0
print(f"splitting strength {split.peak / 1e6:.2f} MPa")
skin, drawn = bd.polyhedra(disc), plt.figure(figsize=(4, 4), layout="constrained").add_subplot(aspect="equal")
for one, cell in zip(np.split(skin.vertex, skin.start[1:-1]), skin.cell, strict=True):
    if np.ptp(one[:, 0]) < 1e-6 and one[0, 0] > 9e-3:  # on the face that is seen
        place = 1e3 * (one + 30.0 * (split.state.position[cell] - disc.centre[cell]))
        drawn.fill(place[:, 2], place[:, 1], facecolor=plt.get_cmap("YlOrRd")(1.5 * lost[cell]), edgecolor="white")
drawn.set_axis_off()
plt.savefig("split_disc.png", dpi=100)
