"""A bar of concrete pulled apart: strength and fracture energy go in, and the curve gives them back."""

import matplotlib.pyplot as plt

import bondem as bd

bar = bd.connect(bd.pack(bd.Box((60e-3, 30e-3, 30e-3)), count=200, method="even", seed=1), method="laguerre")
concrete = bd.Rankine(tension=4e6, fracture_energy=100.0)
pulled = bd.labtests.direct_tension(bar, bd.CellBond(E=40e9, nu=0.2), concrete)
print(f"strength {pulled.peak / 1e6:.3f} MPa, work of fracture {pulled.work:.1f} J/m²")

drawn = plt.figure(figsize=(4, 4), layout="constrained").add_subplot()
drawn.plot(60.0 * 1e3 * pulled.curve[:, 0], 1e-6 * pulled.curve[:, 1], color="#1f77b4", linewidth=2)
drawn.axhline(4.0, color="grey", linestyle=":")
drawn.set(xlabel="elongation [µm]", ylabel="stress [MPa]", title="Concrete in tension")
plt.savefig("pulled_concrete.png", dpi=100)
