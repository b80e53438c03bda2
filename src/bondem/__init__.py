"""Bonded-particle discrete element method for solids that deform and break.

`import bondem as bd` gives access to every public name. Names are loaded on first use, so that the import is fast.
Type checkers and editors read `__init__.pyi`, which a test compares with the list here.
"""

import importlib
from typing import Any

from bondem._describe import describe
from bondem._environment import check_environment
from bondem._names import no_attribute, suggesting

__version__ = "0.1.0"

_PUBLIC = {
    "bondem._progress": ("show_progress",),
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
    "bondem.observe.element_stress": ("ElementStress", "element_stress"),
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
    "bondem._threads": ("set_threads",),
}
_MODULES = {"errors": "bondem.errors", "labtests": "bondem.labtests", "materials": "bondem.specimen.materials"}
_HOME = {name: module for module, names in _PUBLIC.items() for name in names}

__all__ = ["__version__", *sorted(_HOME), *_MODULES]


# What other packages, and earlier versions of this one, call what is here.
_INSTEAD = {
    "solve_dynamic": "bd.solve_explicit", "solve_dynamics": "bd.solve_explicit", "run": "bd.solve_explicit",
    "simulate": "bd.solve_explicit", "solve": "bd.solve_static or bd.solve_explicit", "Sphere": "bd.Ball",
    "tessellate": "bd.connect(particles, method='laguerre')", "read_stl": "bd.Surface", "load_stl": "bd.Surface",
    "HertzContact": "bd.HertzMindlin", "set_num_threads": "bd.set_threads",
}  # fmt: skip


def __getattr__(name: str) -> Any:
    if name in _HOME:
        found = suggesting(_HOME[name], name)
        describe(_PUBLIC)
        return found
    if name in _MODULES:
        return importlib.import_module(_MODULES[name])
    raise AttributeError(no_attribute("bondem", name, __all__, _INSTEAD), name=name)


def __dir__() -> list[str]:
    return __all__


check_environment()
