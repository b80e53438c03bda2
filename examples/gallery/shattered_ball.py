"""A ball of glass hits a plate at 30 m/s; each large piece has a colour of its own."""
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

import bondem as bd

ball = bd.connect(bd.pack(bd.Ball(20e-3), count=1000, method="even", seed=1), method="laguerre")
glass = bd.MohrCoulomb(tension=60e6, cohesion=200e6, friction_angle=0.61)
hit = bd.labtests.sphere_impact(ball, bd.CellBond(E=70e9, nu=0.22), glass, density=2500.0, velocity=30.0)
pieces = bd.fragments(ball, hit.state)
print(f"{hit.damage:.0%} of the facets broken, {len(pieces)} pieces")
skin, ax = bd.polyhedra(ball), plt.figure(figsize=(4, 4)).add_axes((0, 0, 1, 1), projection="3d", azim=-115)
corner = np.linspace(skin.start[:-1], skin.start[1:], np.diff(skin.start).max(), endpoint=False, axis=1, dtype=int)
faces = skin.vertex[corner] + 0.4 * (pieces.position - pieces.position[0])[pieces.label[skin.cell], None]
colours = plt.get_cmap("tab20")(pieces.label[skin.cell] % 20)
ax.add_collection3d(Poly3DCollection(faces, facecolors=colours, shade=True), autolim=False)
ax.set(xlim=(-0.0215, 0.0165), ylim=(-0.019, 0.019), zlim=(-0.019, 0.019), box_aspect=(1, 1, 1))
ax.set_axis_off()
plt.savefig("shattered_ball.png", dpi=100)
