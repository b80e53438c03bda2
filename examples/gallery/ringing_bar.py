"""Beam bonds calibrated to fused silica: the first bending mode of a clamped cylinder of spheres."""

import matplotlib.pyplot as plt
import numpy as np

import bondem as bd

rod = bd.connect(bd.pack(bd.Cylinder(radius=5e-3, length=40e-3), count=600, seed=1))
fit = bd.calibrate(rod, bd.materials.fused_silica, law=bd.EulerBernoulli)
held = bd.Model(rod, bond=fit.law, density=fit.density, boundary=[bd.Fix(bd.Face("x_min"))])
mode = bd.solve_modes(held, count=2)
print(f"E = {fit.E / 1e9:.2f} GPa, first frequency {mode.frequency[0]:.0f} Hz")
shown = mode.shape[0, :, :3] / np.abs(mode.shape[0, :, :3]).max()
x, y, z = (1e3 * rod.centre + 8.0 * shown).T
drawn = plt.figure(figsize=(4, 4)).add_axes((0, 0, 1, 1), projection="3d", proj_type="ortho")
drawn.scatter(x, y, z, s=130, c=np.linalg.norm(shown, axis=1), edgecolors="white", linewidths=0.3)
drawn.set(xlim=(0, 40), ylim=(-6, 14), zlim=(-6, 6))
drawn.set_box_aspect((40, 20, 12), zoom=1.05)
drawn.set_axis_off()
plt.savefig("ringing_bar.png", dpi=100)
