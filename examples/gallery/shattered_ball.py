"""
A ball of glass
===============

The ball hits a plate at 30 m/s. Each piece has a colour of its own, and the
pieces are drawn apart.
"""

import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

import bondem as bd

centres = bd.pack(bd.Ball(20e-3), count=1000, method="even", seed=1)
ball = bd.connect(centres, method="laguerre")
strength = bd.MohrCoulomb(tension=60e6, cohesion=200e6, friction_angle=0.61)
glass = bd.CellBond(E=70e9, nu=0.22)
hit = bd.labtests.sphere_impact(
    ball, glass, strength, density=2500.0, velocity=30.0)  # [kg/m³], [m/s]
pieces = bd.fragments(ball, hit.state)
print(f"{hit.damage:.0%} of the facets broken, {len(pieces)} pieces")

skin = bd.polyhedra(ball)
apart = 0.4 * (pieces.position - pieces.position[0])[pieces.label]
corners = np.split(skin.vertex, skin.start[1:-1])
faces = [face + apart[k] for face, k in zip(corners, skin.cell, strict=True)]
colours = plt.get_cmap("tab20")(pieces.label[skin.cell] % 20)
fig = plt.figure(figsize=(4, 4))
ax = fig.add_axes((0, 0, 1, 1), projection="3d", azim=-115, box_aspect=3 * [1])
drawn = Poly3DCollection(faces, facecolors=colours, shade=True)
ax.add_collection3d(drawn, autolim=False)
ax.set(xlim=(-22e-3, 16e-3), ylim=(-19e-3, 19e-3), zlim=(-19e-3, 19e-3))
ax.set_axis_off()
fig.savefig("shattered_ball.png", dpi=100)
