"""Generated input: every public function, given anything in place of one argument, does it or says no in one line.

What is drawn: numbers that are none, of 10^±300 and of the wrong sign, wrong types, arrays of any shape, empty
things, parts of another model. What is refused must be refused by an error of the package with a message of one line;
what is taken must not hold a number that is none, must be done in time, and what it gives must be finite.
"""

import dataclasses
import functools
import inspect
import math
import time
import warnings
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import hypothesis
import numpy as np
import pytest
from hypothesis import strategies as st
from hypothesis.extra import numpy as npst

import bondem as bd
from bondem.errors import BondemError

EXAMPLES = 8  # an argument
SECONDS = 20


class Later:
    """A usual argument that takes a while to make."""

    def __init__(self, make: Callable[[], Any]) -> None:
        self.made = functools.cache(make)


def pressed(tension, cohesion):
    """A compressive strength in closed form."""
    return 2.0 * cohesion**0.9 * tension**0.1


def split(tension, cohesion):
    """A splitting strength in closed form."""
    return 1.0 / (1.0 / tension + 1.0 / cohesion)


def along(stress, tension):
    """Index of a criterion."""
    return stress[:, 0, 0] / tension


GRID = np.indices((4, 3, 3)).reshape(3, -1).T.astype(float)
SPHERES = bd.Particles(GRID, 0.5)
LATTICE = bd.connect(SPHERES, reach=1.1)
LAW = bd.EulerBernoulli(E=1e7, nu=0.2, radius_ratio=0.6)
ENDS = (bd.Fix(bd.Face("x_min")), bd.Load(bd.Face("x_max"), force=(1e3, 0.0, 0.0)))
MODEL = bd.Model(LATTICE, LAW, 1000.0, ENDS)
BREAKING = bd.Model(LATTICE, LAW, 1000.0, ENDS, failure=bd.PeripheralStress(tension=1e6, shear=1e6))
PULLED = Later(lambda: bd.Model(
    bd.connect(bd.pack(BOX, count=30, method="even", seed=1), method="laguerre"), bd.CellBond(E=1e9, nu=0.2), 1e3,
    [bd.Fix(FACE), bd.Drive(bd.Face("x_max"), x=1e-6)], failure=bd.Rankine(tension=1e6),
))
OTHER = bd.Model(bd.connect(bd.Particles(GRID[:18], 0.5), reach=1.1), LAW, 900.0, ENDS)
BAR = Later(lambda: bd.connect(bd.pack(bd.Cylinder(0.5, 3.0), count=400, seed=2)))
CELL = Later(lambda: bd.connect(bd.pack(bd.Cell((1.0, 1.0, 1.0)), count=200, seed=2)))
GLASS = bd.Material("glass", E=70e9, nu=0.2, rho=2500.0)
BOX, BALL, EVERYTHING, FACE = bd.Box((1.0, 1.0, 1.0)), bd.Ball(1.0), bd.Everything(), bd.Face("x_min")
BEAM = {"E": 1e9, "nu": 0.2, "radius_ratio": 0.5, "radius_rule": "mean", "formulation": "total"}
CELLS = bd.CellBond(E=1e9, nu=0.2)
SMALL = Later(lambda: bd.connect(bd.pack(BALL, count=30, method="even", seed=1), method="laguerre"))
BRICK = bd.Box((2.0, 1.0, 1.0))
PIECE = Later(lambda: bd.connect(bd.pack(BRICK, count=30, method="even", seed=1), method="laguerre"))
ISOTROPIC = {"E": 1e7, "nu": 0.2, "gyration": None, "stress": 1e3, "depth": 0.02}
MOVING = {"density": 1e3, "E": 1e7, "nu": 0.2, "rho": 9e2, "depth": 0.02}
STATIC = Later(lambda: bd.solve_static(MODEL))

EVENTS = bd.BrokenBonds(
    time=np.arange(4.0), step=np.arange(4), bond=np.arange(4), mode=np.array(["tension"] * 4), gap=np.zeros(4),
    energy=np.ones(4), position=GRID[::9], opening_steps=np.full(4, np.nan),
)  # fmt: skip

# The usual arguments of each public function; one of them at a time is replaced.
USUAL: dict[str, dict[str, Any]] = {
    "Absorbing": {"region": FACE, "density": 1e3, "E": 1e9, "nu": 0.2, "c": 10.0},
    "Aggregates": {"position": [(0.0, 0.0, 0.0), (2.0, 0.0, 0.0)], "radius": [0.5, 0.6]},
    "AtRest": {"speed": 1.0, "after": 0.0},
    "Ball": {"radius": 1.0},
    "BodyForce": {"acceleration": (0.0, 0.0, -9.81), "region": EVERYTHING, "schedule": bd.Constant(1.0)},
    "Body": {"which": 0},
    "BondDamping": {"eta": 0.1, "beta": 0.0},
    "Box": {"size": (1.0, 1.0, 1.0)},
    "Cell": {"size": (1.0, 1.0, 1.0)},
    "CellBond": {"E": 1e9, "nu": 0.2, "facet_rotation": "bending"},
    "Constant": {"value": 1.0},
    "ContactBond": BEAM | {"kappa": 1.0},
    "Cylinder": {"radius": 1.0, "length": 2.0},
    "CylinderWall": {"radius": 1.0, "point": (0.0, 0.0, 0.0), "axis": (1.0, 0.0, 0.0), "outside": False,
                     "motion": None, "friction": 0.1},
    "Drive": {"region": FACE, "x": 1e-6, "vy": bd.Ramp(0.0, 1.0, 1.0)},
    "Driven": {
        "x": 1e-6, "vy": bd.Ramp(0.0, 1.0, 1.0), "spin": 1.0, "axis": (0.0, 1.0, 0.0), "about": (0.0, 0.0, 0.0),
    },
    "Eigenstrain": {"strain": 1e-4, "region": EVERYTHING, "schedule": bd.Constant(1.0)},
    "Elliptic": {"elongation": 0.01, "rotation": 0.1, "scatter": None},
    "DruckerPrager": {
        "tension": 1e6, "compression": 1e7, "hydrostatic": None, "fracture_energy": 50.0,
        "fracture_energy_shear": 500.0, "dilatancy": 0.1, "friction": 0.3, "scatter": None,
    },
    "EulerBernoulli": BEAM | {"radius": None},
    "Face": {"name": "x_min", "depth": 0.02, "body": None},
    "Fix": {"region": FACE, "translation": "xyz", "rotation": "xyz"},
    "Gauge": {"region": FACE, "quantity": "displacement", "reduction": "mean"},
    "Gravity": {"g": 9.81, "direction": (0.0, 0.0, -1.0), "region": None},
    "Adhesion": {"strength": 1e4, "reach": 1e-3},
    "HertzMindlin": {"E": 1e9, "nu": 0.2, "friction": 0.1, "restitution": 0.9, "overlap": 0.01, "stress_free": True},
    "Hydrostatic": {"tension": 1e6, "fracture_energy": 50.0, "friction": 0.3, "scatter": None},
    "Index": {"elements": [0, 1], "size": 4},
    "Lattice": {"particles": SPHERES, "pairs": [[0, 1], [1, 2]]},
    "LinearContact": {"E": 1e9, "friction": 0.1, "kappa": 2.0, "damping": 0.1, "stress_free": True},
    "LoadDrop": {"load": {"end": (1.0, 0.0, 0.0)}, "share": 0.5, "least": 1.0},
    "LinearSum": {"force": 1.0, "shear": 1.0, "bending": 1e-3, "twisting": 1e-3, "scatter": None},
    "Load": {"region": FACE, "force": (1.0, 0.0, 0.0), "moment": (0.0, 1.0, 0.0), "schedule": bd.Constant(1.0)},
    "LocalDamping": {"gamma": 0.1},
    "Lognormal": {"cv": 0.2, "cut": 2.0},
    "MassDamping": {"alpha": 1.0},
    "Material": {"name": "glass", "E": 70e9, "nu": 0.2, "rho": 2500.0, "source": "book"},
    "Model": {"lattice": LATTICE, "bond": LAW, "density": 1000.0, "boundary": ENDS, "contact": None, "walls": (),
              "failure": None},
    "MohrCoulomb": {
        "tension": 1e6, "cohesion": 1e6, "friction_angle": 0.6, "fracture_energy": 50.0,
        "fracture_energy_shear": 500.0, "dilatancy": 0.1, "scatter": None,
    },
    "Rankine": {"tension": 1e6, "fracture_energy": 50.0, "friction": 0.3, "scatter": None, "on": None},
    "Normal": {"deviation": 0.1, "seed": 1, "correlation": 1e-3},
    "Obermayr": BEAM | {"alpha_s": 0.9},
    "ParallelBond": BEAM | {"kappa": 1.0},
    "Particles": {"position": GRID, "radius": 0.5, "period": None, "shape": None},
    "Plan": {"duration": 1e-3, "dt": 1e-5, "scheme": bd.VelocityVerlet(), "damping": None, "gauges": {}, "every": 10,
             "save_every": 0, "until": (), "safety": 0.9},
    "NonLocal": {"E": 1e9, "nu": 0.2, "lever": "facet", "areas": "facet", "volume": "cell", "limited": True},
    "PeripheralStress": {"tension": 1e6, "shear": 1e6, "beta": 1.0, "scatter": None},
    "Plane": {"point": (0.0, 0.0, 0.0), "normal": (1.0, 0.0, 0.0)},
    "PlaneWall": {"point": (0.0, 0.0, 0.0), "normal": (1.0, 0.0, 0.0), "motion": None, "friction": 0.1,
                  "outer": 2.0, "inner": 1.0},
    "Pressure": {"region": FACE, "pressure": 1e5, "schedule": bd.Constant(1.0)},
    "Ramp": {"start": 0.0, "end": 1.0, "duration": 1.0, "begin": 0.0},
    "Response": {"lattice": LATTICE, "law": LAW, "guess": None},
    "Free": {
        "mass": 1.0, "velocity": (1.0, 0.0, 0.0), "force": (0.0, 0.0, 0.0), "inertia": (1.0, 1.0, 1.0),
        "spin": (0.0, 0.0, 1.0), "torque": (0.0, 0.0, 0.0),
    },
    "SphereWall": {"radius": 1.0, "centre": (0.0, 0.0, 0.0), "inside": False, "motion": None, "friction": 0.1},
    "Servo": {"force": 1e3, "speed": 1.0, "mass": 1.0},
    "Sieve": {"diameters": (1.0, 2.0), "mass_passing": (0.0, 1.0)},
    "State": {"model": MODEL},
    "StressCriterion": {
        "function": along, "fracture_energy": 50.0, "friction": 0.3, "scatter": None, "tension": 1e6,
    },
    "StrainGauge": {"region": FACE},
    "Surface": {"file": None, "unit": None, "vertices": np.eye(4, 3), "triangles": [[0, 2, 1], [0, 1, 3], [1, 2, 3],
                                                                                     [0, 3, 2]],
                "named": {"foot": [0]}, "sharp": 0.5},
    "Table": {"times": [0.0, 1.0], "values": [0.0, 1.0]},
    "TchamwaWielgosz": {"phi": 1.1},
    "Timoshenko": BEAM | {"radius": None},
    "Uniform": {"spread": 0.2},
    "Bilinear": {"stress": 0.3, "opening": 0.8},
    "Weibull": {"modulus": 8.0, "volume": 1e-6, "seed": 1, "correlation": 1e-3},
    "WallGauge": {"wall": 0, "quantity": "force"},
    "Within": {"shape": BALL},
    "acoustic_emission": {"events": EVENTS, "time": 1.0, "distance": 1.0, "model": BREAKING},
    "bulk_moduli": {"lattice": CELL, "law": LAW, "guess": None},
    "calibrate": {"lattice": BAR, "material": GLASS, "law": bd.EulerBernoulli, "nu_mu": 0.3, "search": (0.3, 0.9),
                  "tolerance": 1e-3},
    "calibrate_strength": {
        "tests": {"ucs": pressed, "brazilian": split}, "targets": {"ucs": (5e7, 2e6), "brazilian": (4e6, 3e5)},
        "start": {"tension": 4e6, "cohesion": 1e7}, "strengths": ("tension", "cohesion"),
        "bounds": {"tension": (1e6, 1e8)}, "most": 15, "about": "closed forms", "progress": None,
    },
    "carve": {"lattice": LATTICE, "shape": BOX},
    "connect": {"particles": SPHERES, "tolerance": None, "reach": 1.1},
    "fabric": {"lattice": LATTICE},
    "crack_speed": {"events": EVENTS, "origin": (0.0, 0.0, 0.0), "direction": (1.0, 0.0, 0.0), "between": (0.0, 9.0),
                    "beyond": 0.0},
    "cracks": {"lattice": LATTICE, "state": BREAKING.state(), "integrity": 0.5},
    "bond_forces": {"model": BREAKING, "result": BREAKING.state()},
    "element_stress": {"model": BREAKING, "result": BREAKING.state()},
    "explain": {"model": BREAKING, "state": BREAKING.state(), "most": 3},
    "explain_step": {"model": BREAKING, "damping": None, "gauges": None, "state": BREAKING.state()},
    "failure_index": {"model": BREAKING, "state": BREAKING.state()},
    "fragments": {"lattice": LATTICE, "state": BREAKING.state(), "integrity": 0.5},
    "Graded": {"fine": 1e-3, "coarse": 1e-2, "about": BALL, "growth": 0.3},
    "aggregates": {"shape": BOX, "sieve": bd.Sieve((0.2, 0.3), (0.0, 1.0)), "fraction": 0.1, "gap": 0.05, "seed": 1},
    "pack": {"shape": BOX, "count": 40, "size": None, "spread": 0.2, "sizes": None, "method": "quench", "seed": 1,
             "coordination_number": None, "volume_fraction": 0.5, "jamming": False},
    "principal_stresses": {"stress": np.eye(3)},
    "von_mises_stress": {"stress": np.eye(3)},
    "radial_distribution": {"particles": Later(lambda: BAR.made().particles), "reach": 2.0, "bins": 10},
    "replicate": {"body": LATTICE, "positions": [[0.0, 0.0, 0.0], [0.0, 0.0, 99.0]], "rotations": None,
                  "name": "body", "seed": 0},
    "strew": {"body": LATTICE, "shape": bd.Box((99.0, 99.0, 99.0)), "count": 2, "seed": 0, "gap": 0.0,
              "attempts": 10, "name": "body"},
    "solve_explicit": {"model": MODEL, "duration": 1e-4, "dt": 1e-5, "scheme": None, "damping": None, "gauges": None,
                       "every": 5, "save_every": 0, "until": (), "safety": 0.9, "state": None, "device": "cpu"},
    "solve_modes": {"model": MODEL, "count": 2, "prestress": False},
    "solve_quasistatic": {"model": PULLED, "drive": bd.Face("x_max"), "ripple": 0.2, "together": 0.01, "until": 0.5,
                          "most": 3, "gauges": None},
    "solve_relaxed": {"model": MODEL, "tolerance": 1e-3, "most": 1000},
    "solve_static": {"model": MODEL, "nonlinear": False, "guess": STATIC},
    "wall_layering": {"particles": Later(lambda: BAR.made().particles), "reach": 2.0, "bins_per_diameter": 5},
    "labtests.clamped_tension": {"lattice": BAR, "law": LAW, **ISOTROPIC},
    "labtests.static_bending": {"lattice": BAR, "law": LAW, **ISOTROPIC},
    "labtests.static_torsion": {"lattice": BAR, "law": LAW, **ISOTROPIC},
    "labtests.static_tension": {"lattice": BAR, "law": LAW, "stress": 1e3, "depth": 0.02},
    "labtests.uniform_stress": {"lattice": BAR, "law": LAW, "depth": 0.02},
    "labtests.natural_frequencies": {"lattice": BAR, "law": LAW, "density": 1e3, "count": 7, "depth": 0.02},
    "labtests.dynamic_tension": {"lattice": BAR, "law": LAW, **MOVING},
    "labtests.dynamic_bending": {"lattice": BAR, "law": LAW, **MOVING},
    "labtests.dynamic_torsion": {"lattice": BAR, "law": LAW, **MOVING},
    "labtests.free_vibration": {"lattice": BAR, "law": LAW, **MOVING, "periods": 1.0, "stress": 1e3},
    "labtests.punch_specimen": {"diameter": 0.15, "height": 0.08, "ring": 0.045, "width": 0.004, "depth": 0.01},
    "labtests.sphere_crushing": {
        "ball": SMALL, "law": CELLS, "failure": bd.Rankine(tension=1e6, fracture_energy=1e3), "friction": 0.1,
        "contact": None, "density": 1e3, "traverses": 2.0, "ending": 0.2, "fine": 0.2,
    },
    "labtests.sphere_impact": {
        "ball": SMALL, "law": CELLS, "failure": None, "density": 1e3, "velocity": 1.0, "wall": None, "friction": 0.1,
        "contact": None, "duration": None, "fine": 0.2,
    },
    "labtests.spall": {
        "bar": PIECE, "law": CELLS, "failure": None, "density": 1e3, "pressure": 1e4, "rise": 1e-4, "fall": 1e-4,
        "duration": 1e-3, "rebound": 1e-3, "bins": 4,
    },
    "show_progress": {"mode": "off"},
    "labtests.impact": {"lattice": BAR, "law": LAW, **MOVING, "velocity": 0.1},
}  # fmt: skip
# Read and write files (`test_hostile_specimens`, `test_runfile`), have no arguments, or are made by the package.
ELSEWHERE = {
    "load_particles", "read_lattice", "read_particles", "read_contents", "read_provenance", "read_run", "resume",
    # likewise (`test_campaign`)
    "read_campaign", "run_campaign", "campaign_table", "campaign_dataset", "Campaign",
    "CampaignSpecimen", "Slurm",
    "save_particles", "write_vtkhdf", "export", "Everything", "VelocityVerlet", "BondLaw", "Event", "Region",
    "Schedule",
    "RunContents", "Scheme", "Shape", "SizeLaw",
    "BondGeometry", "BondStiffness", "BondStrain", "BulkModuli", "Calibration", "Callback", "Checkpoint",
    "EnergyParts", "ExplicitResult", "Fabric", "FreeParameter", "History", "Layering", "ModesResult",
    "ExplainedPass", "ExplainedStep",
    "Quasistatic", "QuasistaticResult", "RadialDistribution", "Sample", "Slope", "Solution", "StaticResult", "Status",
    "Strata",
    "Trial", "StrengthCalibration", "StrengthRun", "Cells",
    "Bodies", "join",  # see `test_joining`
    "Facets", "FreeFacets", "Polyhedra", "SmallMotion", "cell_stress", "polyhedra",
    # changes all runs that follow (`test_names`)
    "set_threads",
    "ElementStress",
    "BondForces", "BrokenBonds", "ContactLaw", "Criterion", "Fragments", "AcousticEmission", "BValue", "CrackGrowth",
    "CrackPolygons", "CrackSurfaces", "Patch", "Cracks", "Explanation", "FractureEnergy", "ImpliedFracture",
    # whole tests to failure (`test_strength`)
    "labtests.direct_tension", "labtests.uniaxial_compression",
    # the same (`test_laboratory`)
    "labtests.brazilian", "labtests.triaxial", "labtests.three_point_bending", "labtests.shear",
}  # fmt: skip
# Runs on purpose: what is possible there takes as long as was asked for.
LONG = {("solve_explicit", "duration"), ("solve_explicit", "dt"), ("solve_explicit", "safety"),
        ("labtests.sphere_impact", "duration"), ("labtests.spall", "duration"),
        ("labtests.sphere_crushing", "traverses"),
        *((f"labtests.{test}", key) for test in ("free_vibration", "impact") for key in ("periods", "E", "rho"))}

EXTREME = st.one_of(
    st.floats(1e290, 1e308), st.floats(-1e308, -1e290), st.floats(1e-308, 1e-290), st.floats(-1e3, -1e-3),
    st.sampled_from([math.nan, math.inf, -math.inf, 0.0, -0.0]),
)  # fmt: skip
NUMBERS = st.one_of(
    EXTREME, st.sampled_from([0, -1, 10**15, 10**400, True, 1j, np.float32("nan"), np.int8(-1), Fraction(-1, 3)])
)
ARRAYS = npst.arrays(np.float64, npst.array_shapes(min_dims=0, max_dims=3, min_side=0, max_side=4), elements=EXTREME)
LISTS = st.recursive(
    NUMBERS, lambda inner: st.lists(inner, max_size=4) | st.tuples(inner, inner, inner), max_leaves=6
)
THINGS = st.sampled_from([
    None, "", b"1", [], (), {}, set(), object(), bd.Box, len, [[]], {"a": 1}, np.zeros((0, 3)), np.array(["a", "b"]),
    SPHERES, LATTICE, LAW, MODEL, OTHER, Later(OTHER.state), STATIC, BALL, EVERYTHING, FACE, GLASS, bd.Index([10**6]),
    bd.Within(bd.Ball(1e-9)), bd.Face("z_min"), (bd.Fix(bd.Within(bd.Ball(1e-9))),), bd.Ramp(0.0, 1.0, 1.0),
    {"g": bd.Gauge(bd.Within(bd.Ball(1e-9)), "velocity")}, {"g": bd.WallGauge(3, "force")},
    bd.Particles([[0.0] * 3], 1.0), bd.Lattice(bd.Particles([[0.0] * 3], 1.0), []),
])  # fmt: skip
ANYTHING = st.one_of(NUMBERS, LISTS, ARRAYS, THINGS, st.text(max_size=5))

CASES = [(name, key) for name, usual in USUAL.items() for key in usual]


def function(name: str) -> Callable[..., Any]:
    return getattr(bd.labtests, name.rpartition(".")[2]) if name.startswith("labtests.") else getattr(bd, name)


def made(value: Any) -> Any:
    return value.made() if isinstance(value, Later) else value


def call(which: str, /, **changed: Any) -> Any:
    return function(which)(**{key: made(value) for key, value in (USUAL[which] | changed).items()})


# a ball is crushed within two passes of sound
@pytest.mark.filterwarnings("ignore::bondem.errors.NotQuasistaticWarning")
def test_every_public_function_is_drawn_from():
    found = {name for name in bd.__all__ if callable(getattr(bd, name))}
    found |= {f"labtests.{name}" for name in bd.labtests.__all__ if inspect.isfunction(getattr(bd.labtests, name))}
    assert found - ELSEWHERE == set(USUAL)
    for name in USUAL:
        call(name)


def holds_nan(value: object) -> bool:
    """Whether there is a number in it that is none."""
    if isinstance(value, list | tuple | set):
        return any(map(holds_nan, value))
    if isinstance(value, np.ndarray):
        return value.dtype.kind == "f" and bool(np.isnan(value).any())
    return isinstance(value, float | np.floating) and math.isnan(value)


def not_finite(found: object, depth: int = 3) -> list[str]:
    """Names of numbers of a result that are not finite; what a result is given by is not one."""
    if isinstance(found, bd.State):
        found = {name: getattr(found, name) for name in ("displacement", "velocity", "angular_velocity")}
    elif isinstance(found, bd.History):
        found = {"records": found.records}
    elif dataclasses.is_dataclass(found):
        # what the ledger misses is not known without records
        names = {field.name for field in dataclasses.fields(found)} - {"residual"}
        found = {name: getattr(found, name) for name in names}
    if isinstance(found, dict) and depth:
        return [f"{key}.{name}" for key, value in found.items() for name in not_finite(value, depth - 1)]
    if isinstance(found, np.ndarray) and found.dtype.kind in "fc" and not np.isfinite(found).all():
        return [f"in {np.count_nonzero(~np.isfinite(found))} of {found.size}"]
    return ["it"] if isinstance(found, float) and not math.isfinite(found) else []


RESULTS = ("solve_static", "solve_explicit", "solve_relaxed", "bulk_moduli", "labtests.static_tension",
           "labtests.static_bending", "labtests.static_torsion", "labtests.clamped_tension")  # fmt: skip


@pytest.mark.parametrize(("name", "key"), CASES)
@hypothesis.settings(
    max_examples=EXAMPLES, deadline=None, derandomize=True, database=None,
    suppress_health_check=list(hypothesis.HealthCheck),
)  # fmt: skip
@hypothesis.given(value=ANYTHING)
def test_anything_is_done_or_refused_in_one_line(name, key, value):
    if (name, key) in LONG:
        real = np.isscalar(value) and not isinstance(value, str | bytes | complex)
        hypothesis.assume(not real or not 0 < value < math.inf)
    begun = time.process_time()
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        try:
            found = call(name, **{key: value})
        except BondemError as error:
            refused = str(error)
        else:
            refused = None
    assert time.process_time() - begun < SECONDS
    if refused is not None:
        assert len(refused) > 10
        assert "\n" not in refused
        return
    assert not holds_nan(value), "a number that is none was taken"
    assert not [str(one.message) for one in told if issubclass(one.category, RuntimeWarning)]
    if name in RESULTS:
        assert not not_finite(found), not_finite(found)
