"""bondem: bonded-particle discrete element method.

`import bondem as bd` reaches every public name; each is loaded at its first use, so that importing the
package costs nothing.
"""

import importlib
from typing import Any

__version__ = "0.1.0"

_PUBLIC = {
    "bondem.specimen.material": ("Material",),
    "bondem.specimen.geometry": ("Ball", "Box", "Cell", "Cylinder"),
    "bondem.specimen.surface": ("Surface",),
    "bondem.specimen.particles": ("Particles",),
    "bondem.specimen.lattice": ("Lattice", "carve"),
    "bondem.specimen.bonding": ("connect",),
    "bondem.specimen.regions": ("Everything", "Face", "Index", "Within"),
    "bondem.specimen.fabric": ("fabric",),
    "bondem.specimen.layering": ("wall_layering",),
    "bondem.specimen.radial_distribution": ("radial_distribution",),
    "bondem.packing": ("pack",),
    "bondem.packing.sizes": ("Lognormal", "Sieve", "Uniform"),
    "bondem.laws.contact": ("LinearContact",),
    "bondem.laws.contact_bond": ("ContactBond",),
    "bondem.laws.damping": ("BondDamping", "LocalDamping", "MassDamping"),
    "bondem.laws.euler_bernoulli": ("EulerBernoulli",),
    "bondem.laws.obermayr": ("Obermayr",),
    "bondem.laws.parallel_bond": ("ParallelBond",),
    "bondem.laws.timoshenko": ("Timoshenko",),
    "bondem.model.schedules": ("Constant", "Ramp", "Table"),
    "bondem.model.boundary": ("Drive", "Fix", "Load"),
    "bondem.model.loads": ("Absorbing", "BodyForce", "Eigenstrain", "Pressure"),
    "bondem.model.gauges": ("Gauge", "WallGauge"),
    "bondem.model.model": ("Model",),
    "bondem.model.walls": ("CylinderWall", "Driven", "PlaneWall", "Servo"),
    "bondem.solve.schemes": ("TchamwaWielgosz", "VelocityVerlet"),
    "bondem.solve.events": ("AtRest",),
    "bondem.io.importing": ("read_lattice", "read_particles"),
    "bondem.io.particles_file": ("load_particles", "read_provenance", "save_particles"),
    "bondem.io.runfile": ("read_run",),
    "bondem.io.vtk": ("write_vtkhdf",),
    "bondem.run": ("resume", "solve_explicit", "solve_modes", "solve_relaxed", "solve_static"),
    "bondem.labtests.bulk": ("bulk_moduli",),
    "bondem.calibration": ("calibrate",),
    "bondem.calibration.layers": ("calibrate_layers",),
}
_MODULES = {"errors": "bondem.errors", "labtests": "bondem.labtests", "materials": "bondem.specimen.materials"}
_HOME = {name: module for module, names in _PUBLIC.items() for name in names}

__all__ = ["__version__", *sorted(_HOME), *_MODULES]


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(importlib.import_module(_HOME[name]), name)
    if name in _MODULES:
        return importlib.import_module(_MODULES[name])
    raise AttributeError(f"module 'bondem' has no attribute '{name}'")


def __dir__() -> list[str]:
    return __all__
