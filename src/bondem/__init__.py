"""bondem: bonded-particle discrete element method.

`import bondem as bd` reaches every public name; each is loaded at its first use, so that importing the
package costs nothing. What type checkers and editors see is `__init__.pyi`, which a test compares with the list here.
"""

import importlib
from typing import Any

from bondem import _forking as _forking

__version__ = "0.1.0"

_PUBLIC = {
    "bondem.campaign.coordinator": ("run_campaign",),
    "bondem.campaign.sweep": ("Campaign", "CampaignSpecimen", "Slurm", "read_campaign"),
    "bondem.campaign.table": ("campaign_dataset", "campaign_table"),
    "bondem.specimen.material": ("Material",),
    "bondem.specimen.shape": ("Shape",),
    "bondem.specimen.geometry": ("Ball", "Box", "Cell", "Cylinder"),
    "bondem.specimen.surface": ("Surface",),
    "bondem.specimen.particles": ("Particles",),
    "bondem.specimen.lattice": ("Lattice", "carve"),
    "bondem.specimen.aggregates": ("Aggregates",),
    "bondem.specimen.bonding": ("connect",),
    "bondem.specimen.cells.tables": ("Cells", "Facets", "FreeFacets"),
    "bondem.specimen.cells.polyhedra": ("Polyhedra", "polyhedra"),
    "bondem.specimen.regions": ("Everything", "Face", "Index", "Plane", "Region", "Within"),
    "bondem.specimen.fabric": ("Fabric", "fabric"),
    "bondem.specimen.strata": ("Strata",),
    "bondem.specimen.layering": ("Layering", "wall_layering"),
    "bondem.specimen.radial_distribution": ("RadialDistribution", "radial_distribution"),
    "bondem.packing": ("aggregates", "pack"),
    "bondem.packing.grading": ("Graded",),
    "bondem.packing.sizes": ("Lognormal", "Sieve", "SizeLaw", "Uniform"),
    "bondem.fracture.crack_growth": ("CrackGrowth", "crack_speed"),
    "bondem.fracture.crack_polygons": ("CrackPolygons",),
    "bondem.fracture.crack_surfaces": ("CrackSurfaces",),
    "bondem.fracture.cracks": ("Cracks", "cracks"),
    "bondem.fracture.emission": ("AcousticEmission", "acoustic_emission"),
    "bondem.fracture.explain": ("Explanation", "explain"),
    "bondem.fracture.fragments": ("Fragments", "fragments"),
    "bondem.fracture.magnitudes": ("BValue",),
    "bondem.quasistatic.solve": ("QuasistaticResult", "solve_quasistatic"),
    "bondem.laws.bond": ("BondGeometry", "BondLaw", "BondStiffness"),
    "bondem.laws.cell_bond": ("CellBond",),
    "bondem.laws.contact": ("ContactLaw", "LinearContact"),
    "bondem.laws.contact_bond": ("ContactBond",),
    "bondem.laws.damping": ("AnyDamping", "BondDamping", "LocalDamping", "MassDamping"),
    "bondem.laws.euler_bernoulli": ("EulerBernoulli",),
    "bondem.laws.failure.bilinear": ("Bilinear",),
    "bondem.laws.failure.criterion": ("Criterion",),
    "bondem.laws.failure.drucker_prager": ("DruckerPrager",),
    "bondem.laws.failure.elliptic": ("Elliptic",),
    "bondem.laws.failure.hydrostatic": ("Hydrostatic",),
    "bondem.laws.failure.linear_sum": ("LinearSum",),
    "bondem.laws.failure.mohr_coulomb": ("MohrCoulomb",),
    "bondem.laws.failure.peripheral_stress": ("PeripheralStress",),
    "bondem.laws.failure.rankine": ("Rankine",),
    "bondem.laws.failure.scatter": ("Normal", "Weibull"),
    "bondem.laws.failure.stress_criterion": ("StressCriterion",),
    "bondem.laws.free_parameter": ("FreeParameter",),
    "bondem.laws.hertz_mindlin": ("HertzMindlin",),
    "bondem.laws.non_local": ("NonLocal",),
    "bondem.laws.obermayr": ("Obermayr",),
    "bondem.laws.parallel_bond": ("ParallelBond",),
    "bondem.laws.timoshenko": ("Timoshenko",),
    "bondem.model.assignment": ("BondAssignment",),
    "bondem.model.failure_assignment": ("FailureAssignment",),
    "bondem.model.schedules": ("Constant", "Ramp", "Schedule", "Table"),
    "bondem.model.boundary": ("BoundaryCondition", "Drive", "Fix", "Load"),
    "bondem.model.loads": ("Absorbing", "BodyForce", "Eigenstrain", "Pressure"),
    "bondem.model.gauges": ("AnyGauge", "Gauge", "WallGauge"),
    "bondem.model.implied_fracture": ("ImpliedFracture",),
    "bondem.model.model": ("Model",),
    "bondem.model.state": ("State",),
    "bondem.model.walls": ("CylinderWall", "Driven", "Free", "PlaneWall", "Servo", "SphereWall", "Wall"),
    "bondem.observe.bond_forces": ("BondForces", "bond_forces"),
    "bondem.observe.bond_strain": ("BondStrain",),
    "bondem.observe.breakage": ("BrokenBonds", "failure_index"),
    "bondem.observe.cell_forces": ("SmallMotion",),
    "bondem.observe.cell_stress": ("cell_stress",),
    "bondem.observe.energy": ("EnergyParts",),
    "bondem.solve.schemes": ("Scheme", "TchamwaWielgosz", "VelocityVerlet"),
    "bondem.solve.events": ("AtRest", "Event"),
    "bondem.solve.history": ("History",),
    "bondem.solve.solution": ("Solution", "Status"),
    "bondem.solve.plan": ("Callback", "ExplicitResult", "Plan"),
    "bondem.solve.static": ("StaticResult",),
    "bondem.solve.modal": ("ModesResult",),
    "bondem.io.exporting": ("export",),
    "bondem.io.importing": ("read_lattice", "read_particles"),
    "bondem.io.particles_file": ("load_particles", "read_provenance", "save_particles"),
    "bondem.io.run_contents": ("RunContents", "read_contents"),
    "bondem.io.runfile": ("Checkpoint", "read_run"),
    "bondem.io.vtk": ("write_vtkhdf",),
    "bondem.run": ("resume", "solve_explicit", "solve_modes", "solve_relaxed", "solve_static"),
    "bondem.labtests.bulk": ("BulkModuli", "bulk_moduli"),
    "bondem.calibration.elastic": ("Calibration", "Trial", "calibrate"),
    "bondem.calibration.response": ("Response", "Slope"),
    "bondem.calibration.strength": ("StrengthCalibration", "calibrate_strength"),
    "bondem.calibration.strength_runs": ("StrengthRun",),
    "bondem.calibration.uncertainty": ("Sample",),
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
