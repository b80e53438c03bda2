"""A notched bar without inertia: the load path turns back where the bar snaps, and is followed."""

import matplotlib.pyplot as plt

import bondem as bd

slot = bd.Box((4e-3, 10e-3, 10e-3)).moved((98e-3, 12e-3, 0.0))
whole = bd.Box((200e-3, 20e-3, 10e-3)).cut(slot, name="notch")
bar = bd.connect(bd.pack(whole, count=150, method="even", seed=1), method="laguerre")
ends = [bd.Fix(bd.Face("x_min"), translation="x", rotation=""), bd.Drive(bd.Face("x_max"), x=1e-6)]
mortar = bd.Rankine(tension=4e6, fracture_energy=20.0)
model = bd.Model(bar, bd.CellBond(E=40e9, nu=0.2), density=2400.0, boundary=ends, failure=mortar)
path = bd.solve_quasistatic(model, bd.Face("x_max"), most=600, ripple=0.1)
print(f"peak {path.load.max():.0f} N, {len(path.load)} events")
drawn = plt.figure(figsize=(4, 4), layout="constrained").add_subplot()
drawn.plot(1e6 * path.displacement, path.load, color="#1f77b4", linewidth=1.5)
drawn.set(xlabel="elongation [µm]", ylabel="load [N]", title="Snap-back")
plt.savefig("snapping_bar.png", dpi=100)
