"""
The tone of a bar of spheres
============================

Beams between spheres are calibrated to fused silica.
The colours show the motion of the first bending mode of a clamped bar.
"""

import numpy as np

import bondem as bd

bar = bd.Cylinder(radius=5e-3, length=40e-3)  # [m]
rod = bd.connect(bd.pack(bar, count=600, seed=1))
fit = bd.calibrate(rod, bd.materials.fused_silica, law=bd.EulerBernoulli)
held = [bd.Fix(bd.Face("x_min"))]
model = bd.Model(rod, bond=fit.law, density=fit.density, boundary=held)
mode = bd.solve_modes(model, count=2)
print(f"E = {fit.E / 1e9:.2f} GPa, ν = {fit.nu:.3f}")
print(f"first frequency {mode.frequency[0]:.0f} Hz")
moved = np.linalg.norm(mode.shape[0, :, :3], axis=1)
rod.plot("ringing_bar.png", values=moved / moved.max(), label="motion [-]")
