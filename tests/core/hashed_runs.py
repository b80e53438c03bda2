"""Print the level of the core, a hash of a packing, its cells, and beams and cells after some steps, and a number.

A script of its own, which `test_bits.py` runs with several libraries.
"""

import hashlib
import warnings

import bondem as bd
from bondem._core import compiled_level

warnings.simplefilter("ignore", bd.errors.ContactWarning)
p = bd.pack(bd.Box(size=(1.0, 1.0, 1.0)) - bd.Ball(radius=0.5), count=300, spread=0.3, seed=2)
b = bd.connect(p, method="laguerre")
parts = [p.position, p.radius, b.facets.area, b.facets.centroid, b.cells.volume, b.cells.inertia]
ends = [bd.Fix(bd.Face("x_min")), bd.Drive(bd.Face("x_max"), vx=bd.Ramp(0.0, 2.0, 1e-4))]


def add(model: bd.Model, duration: float, *, breaks: bool = True) -> None:
    run = bd.solve_explicit(model, duration=duration, every=1)
    state = run.state
    assert breaks == (len(state.broken) + len(state.cracks) > 0), model
    parts.extend([state.pose, state.motion, state.broken, state.cracks, state.softened, run.history.records])


# ---- beams
law = bd.Timoshenko(E=1e9, nu=0.3, radius_ratio=0.7)
drive = bd.Drive(bd.Face("x_min"), vx=bd.Ramp(0.0, 1.0, 1e-3))
add(bd.Model(bd.connect(p), law, 2500.0, boundary=[drive]), 5e-3, breaks=False)
weak = bd.Elliptic(elongation=1e-3, rotation=3e-3), bd.PeripheralStress(tension=8e5, shear=8e5, fracture_energy=9e1)
for failure in weak:
    add(bd.Model(bd.connect(p), law, 2500.0, boundary=ends, failure=failure), 5e-3)

# ---- cells: brittle, softening, in contact, and fewer facets than a group of lanes
cell, touch = bd.CellBond(E=1e9, nu=0.3), bd.LinearContact(E=1e9, friction=0.4)
brittle = bd.MohrCoulomb(tension=1e6, cohesion=3e6, friction_angle=0.6)
soft = bd.MohrCoulomb(tension=1e6, cohesion=3e6, friction_angle=0.6, fracture_energy=3e2)
for failure, contact in ((brittle, touch), (soft, None), (soft, touch)):
    add(bd.Model(b, cell, 2500.0, boundary=ends, failure=failure, contact=contact), 5e-3)
two = bd.connect(bd.pack(bd.Box(size=(0.02, 0.01, 0.01)), count=2, method="even", seed=1), method="laguerre")
add(bd.Model(two, cell, 2500.0, boundary=ends, failure=soft), 1e-3)

# ---- the non-local law
add(bd.Model(b, bd.NonLocal(E=1e9, nu=0.2), 2500.0, boundary=ends, failure=bd.Rankine(tension=1e6)), 2e-3)
print(compiled_level(), hashlib.sha256(b"".join(part.tobytes() for part in parts)).hexdigest(), float(p.radius.sum()))
