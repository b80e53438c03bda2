"""Bonded-particle discrete element method for solids that deform and break.

`import bondem as bd` gives access to every public name. Names are loaded on first use, so that the import is fast.
Type checkers and editors read `__init__.pyi`, which a test compares with the list here.
"""

import importlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

from bondem._describe import describe
from bondem._environment import check_environment
from bondem._guard import guard
from bondem._names import no_attribute
from bondem._outlets import OUTLETS

try:
    from bondem._version import __version__  # type: ignore[missing-import]
except ImportError:  # a source tree that was not installed
    __version__ = "0.2.0.dev0+unknown"
else:
    if (Path(__file__).parents[2] / ".git").exists():
        # In a clone the code changes after its installation: results state the commit that ran, beside this version.
        __version__ = __version__.partition("+")[0]

_PUBLIC = {
    "bondem._progress": ("show_progress",),
    "bondem.campaign.coordinator": ("run_campaign",),
    "bondem.campaign.sweep": ("Campaign", "CampaignSpecimen", "Slurm", "read_campaign"),
    "bondem.campaign.table": ("campaign_dataset", "campaign_table"),
    "bondem.specimen.material": ("Material",),
    "bondem.geometry.shape": ("Shape",),
    "bondem.geometry.elementary_shapes": ("Ball", "Box", "Cell", "Cylinder"),
    "bondem.geometry.smooth_patches": ("Patch",),
    "bondem.geometry.surface": ("Surface",),
    "bondem.specimen.particles": ("Particles",),
    "bondem.specimen.bodies": ("Bodies",),
    "bondem.specimen.joining": ("join", "replicate"),
    "bondem.specimen.strewing": ("strew",),
    "bondem.specimen.lattice": ("Lattice", "carve"),
    "bondem.specimen.aggregates": ("Aggregates",),
    "bondem.specimen.bonding": ("connect",),
    "bondem.specimen.tessellation.facets": ("Cells", "Facets", "FreeFacets"),
    "bondem.specimen.tessellation.polyhedra": ("Polyhedra", "polyhedra"),
    "bondem.specimen.regions": ("Body", "Everything", "Face", "Index", "Plane", "Region", "Within"),
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
    "bondem.statics.quasistatic.quasistatic_run": ("QuasistaticResult", "solve_quasistatic"),
    "bondem.interactions.beams.bond_law": ("BondGeometry", "BondLaw", "BondStiffness"),
    "bondem.interactions.cells.cell_bond": ("CellBond",),
    "bondem.interactions.contact.adhesion": ("Adhesion",),
    "bondem.interactions.contact.contact_law": ("ContactLaw", "LinearContact"),
    "bondem.interactions.beams.contact_bond": ("ContactBond",),
    "bondem.dynamics.damping": ("AnyDamping", "BondDamping", "LocalDamping", "MassDamping"),
    "bondem.interactions.beams.euler_bernoulli": ("EulerBernoulli",),
    "bondem.damage.bilinear": ("Bilinear",),
    "bondem.damage.criteria.criterion": ("Criterion",),
    "bondem.damage.criteria.drucker_prager": ("DruckerPrager",),
    "bondem.damage.criteria.elliptic": ("Elliptic",),
    "bondem.damage.criteria.hydrostatic": ("Hydrostatic",),
    "bondem.damage.criteria.linear_sum": ("LinearSum",),
    "bondem.damage.criteria.mohr_coulomb": ("MohrCoulomb",),
    "bondem.damage.criteria.peripheral_stress": ("PeripheralStress",),
    "bondem.damage.criteria.rankine": ("Rankine",),
    "bondem.damage.scatter": ("Normal", "Weibull"),
    "bondem.damage.criteria.stress_criterion": ("StressCriterion",),
    "bondem.interactions.beams.free_parameter": ("FreeParameter",),
    "bondem.interactions.contact.hertz_mindlin": ("HertzMindlin",),
    "bondem.interactions.non_local.non_local_law": ("NonLocal",),
    "bondem.interactions.beams.obermayr": ("Obermayr",),
    "bondem.interactions.beams.parallel_bond": ("ParallelBond",),
    "bondem.interactions.beams.timoshenko": ("Timoshenko",),
    "bondem.interactions.beams.assignment": ("BondAssignment",),
    "bondem.damage.failure_assignment": ("FailureAssignment",),
    "bondem.boundary.schedules": ("Constant", "Ramp", "Schedule", "Table"),
    "bondem.boundary.conditions": ("BoundaryCondition", "Drive", "Fix", "Load"),
    "bondem.boundary.loads": ("Absorbing", "BodyForce", "Eigenstrain", "Gravity", "Pressure"),
    "bondem.boundary.gauges": ("AnyGauge", "Gauge", "StrainGauge", "WallGauge"),
    "bondem.damage.implied_fracture": ("ImpliedFracture",),
    "bondem.model.model": ("Model",),
    "bondem.model.state": ("State",),
    "bondem.boundary.wall_motions": ("Driven", "Free", "Servo"),
    "bondem.boundary.walls": ("CylinderWall", "PlaneWall", "SphereWall", "Wall"),
    "bondem.observables.bond_forces": ("BondForces", "bond_forces"),
    "bondem.interactions.beams.bond_strain": ("BondStrain",),
    "bondem.observables.breakage": ("BrokenBonds", "failure_index"),
    "bondem.observables.cell_forces": ("SmallMotion",),
    "bondem.observables.cell_stress": ("cell_stress",),
    "bondem.observables.element_stress": ("ElementStress", "element_stress"),
    "bondem.interactions.energy_parts": ("EnergyParts",),
    "bondem.observables.fracture_energy": ("FractureEnergy",),
    "bondem.observables.principal_stresses": ("principal_stresses", "von_mises_stress"),
    "bondem.dynamics.explained_step": ("ExplainedPass", "ExplainedStep", "explain_step"),
    "bondem.dynamics.schemes": ("Scheme", "TchamwaWielgosz", "VelocityVerlet"),
    "bondem.dynamics.events": ("AtRest", "Event", "LoadDrop"),
    "bondem.dynamics.history": ("History",),
    "bondem.model.solution": ("Solution", "Status"),
    "bondem.dynamics.plan": ("Callback", "ExplicitResult", "Plan"),
    "bondem.dynamics.quasistatic": ("Quasistatic",),
    "bondem.statics.static": ("StaticResult",),
    "bondem.statics.modes": ("ModesResult",),
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
# Functions of upper layers that objects of lower layers call.
_OUTLETS = {
    "bondem._progress_bars": ("bars",),
    "bondem.io.csv_table": ("write_csv",),
    "bondem.report.plots": ("draw_lattice", "draw_model", "draw_result", "draw_surface"),
}

__all__ = ["__version__", *sorted(_HOME), *_MODULES]


# Names in other packages and in earlier versions, with their present names.
_INSTEAD = {
    "solve_dynamic": "bd.solve_explicit", "solve_dynamics": "bd.solve_explicit", "run": "bd.solve_explicit",
    "simulate": "bd.solve_explicit", "solve": "bd.solve_static or bd.solve_explicit", "Sphere": "bd.Ball",
    "tessellate": "bd.connect(particles, method='laguerre')", "read_stl": "bd.Surface", "load_stl": "bd.Surface",
    "HertzContact": "bd.HertzMindlin", "set_num_threads": "bd.set_threads",
    "plot": ".plot() of a lattice, a model or a result", "show": ".plot() of a lattice, a model or a result",
    "draw": ".plot() of a lattice, a model or a result", "view": ".plot(), or the command bondem view",
    "render": "the command bondem render", "save": "out= of a solver, bd.write_vtkhdf or bd.save_particles",
    "load": "bd.read_run or bd.load_particles", "read": "bd.read_run or bd.read_particles",
    "Simulation": "bd.Model and bd.solve_explicit", "Solver": "bd.Model and bd.solve_explicit",
    "voronoi": "bd.connect(particles, method='laguerre')", "Mesh": "bd.Surface", "Force": "bd.Load",
    "Displacement": "bd.Drive", "Velocity": "bd.Drive", "Support": "bd.Fix",
}  # fmt: skip


def __getattr__(name: str) -> Any:
    if name in _HOME:
        module = importlib.import_module(_HOME[name])
        guard(_PUBLIC)
        describe(_PUBLIC)
        return getattr(module, name)
    if name in _MODULES:
        return importlib.import_module(_MODULES[name])
    within = [one for one, home in _MODULES.items() if name[0] != "_" and name in dir(importlib.import_module(home))]
    known = {name: f"bd.{within[0]}.{name}"} if within else _INSTEAD
    raise AttributeError(no_attribute("bondem", name, __all__, known), name=name)


def __dir__() -> list[str]:
    return __all__


def _later(module: str, name: str) -> Callable[..., Any]:
    """Return a function whose module is loaded at the first call."""
    return lambda *what, **options: getattr(importlib.import_module(module), name)(*what, **options)


for _module, _names in _OUTLETS.items():
    for _name in _names:
        setattr(OUTLETS, _name, _later(_module, _name))
check_environment()
