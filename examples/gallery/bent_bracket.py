"""A bracket from an STL file under a load on its tip: von Mises stress of the cells, nothing calibrated."""
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

import bondem as bd

bracket = bd.pack(bd.Surface("examples/bracket.stl", unit="mm"), count=800, method="even", seed=1)
part, load = bd.connect(bracket, method="laguerre"), bd.Load(bd.Face("z_max"), force=(0.0, 10.0, 0.0))
model = bd.Model(part, bd.CellBond(E=72.5e9, nu=0.17), 2201.0, boundary=[bd.Fix(bd.Face("x_min")), load])
stress = np.linalg.eigvalsh(bd.cell_stress(model, bd.solve_static(model)))  # principal
mises = np.sqrt(np.square(stress - np.roll(stress, 1, axis=1)).sum(axis=1) / 2.0)
print(f"von Mises stress {mises.max() / 1e6:.2f} MPa")
skin, ax = bd.polyhedra(part), plt.figure(figsize=(4, 4)).add_axes((0, 0, 1, 1), projection="3d", proj_type="ortho")
corner = np.linspace(skin.start[:-1], skin.start[1:], np.diff(skin.start).max(), endpoint=False, axis=1, dtype=int)
colours = plt.get_cmap("viridis")(mises[skin.cell] / mises.max())
ax.add_collection3d(Poly3DCollection(skin.vertex[corner], facecolors=colours, shade=True), autolim=False)
ax.set(xlim=(2.6e-3, 37.4e-3), ylim=(0.8e-3, 11.2e-3), zlim=(2e-3, 28e-3), box_aspect=(40, 12, 30))
ax.set_axis_off()
plt.savefig("bent_bracket.png", dpi=100)
