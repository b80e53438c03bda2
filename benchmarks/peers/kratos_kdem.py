"""Runs of Kratos DEM with the continuum law `DEM_KDEM`: input, execution and outcome."""

import json
import os
import subprocess
from pathlib import Path

import numpy as np
from outcome import Code, Outcome, why_not
from specimen import DENSITY, POISSON, Specimen

_SCRIPT = Path(__file__).parent / "kratos_script.py"
_NEVER = 1e20


class Kratos(Code):
    """Its Python is `python3`, or what the environment variable KRATOS names."""

    name = "kratos"
    # The bond law differs: the difference of positions is printed, but does not exclude a ratio.
    alike = False
    differs = (
        "stiffnesses are its own, E A / L, G A / L, E I / L and G J / L with the mean radius of the two spheres, "
        "weighted by their neighbours; E makes E A / L ours before weighting; another motion, but the same work",
        "its non-local terms and the search for neighbours are off",
        "bonds compute their dashpots, with coefficients of zero, and their strength, which is never reached",
    )

    def __init__(self) -> None:
        self.python = os.environ.get("KRATOS", "python3")

    def missing(self) -> str:
        return why_not([self.python, "-c", "import KratosMultiphysics.DEMApplication"])

    def run(self, specimen: Specimen, folder: Path, check: int, steps: int) -> Outcome:
        specimen.save(folder / "specimen.npz")
        write_spheres(folder / "bondsDEM.mdpa", specimen)
        (folder / "MaterialsDEM.json").write_text(json.dumps(materials(specimen), indent=1))
        settings = parameters(specimen)
        (folder / "ProjectParametersDEM.json").write_text(json.dumps(settings, indent=1))
        environment = {**os.environ, "PYTHONPATH": str(_SCRIPT.parent), "OMP_NUM_THREADS": "1"}
        command = [self.python, str(_SCRIPT), str(folder), str(check), str(steps)]
        done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)
        if done.returncode != 0:
            raise RuntimeError(f"Kratos failed: {done.stderr.strip()[-2000:]}")
        return Outcome.load(folder / "outcome.npz")


def write_spheres(path: Path, specimen: Specimen) -> None:
    """Write the file of the spheres, which Kratos bonds to those they touch."""
    ids = range(1, len(specimen.radius) + 1)
    lines = ["Begin ModelPartData", "End ModelPartData", "", "Begin Properties 0", "End Properties", ""]
    lines += ["Begin Nodes"]
    lines += [f"{k} {x:.17g} {y:.17g} {z:.17g}" for k, (x, y, z) in zip(ids, specimen.position, strict=True)]
    lines += ["End Nodes", "", "Begin Elements SphericContinuumParticle3D", *(f"{k} 0 {k}" for k in ids)]
    lines += ["End Elements", "", "Begin NodalData RADIUS"]
    lines += [f"{k} 0 {r:.17g}" for k, r in zip(ids, specimen.radius, strict=True)]
    lines += ["End NodalData", "", "Begin NodalData COHESIVE_GROUP", *(f"{k} 0 1" for k in ids), "End NodalData", ""]
    lines += ["Begin SubModelPart Bonded", "Begin SubModelPartNodes", *map(str, ids), "End SubModelPartNodes"]
    lines += ["Begin SubModelPartElements", *map(str, ids), "End SubModelPartElements", "End SubModelPart"]
    path.write_text("\n".join(lines) + "\n")


def materials(specimen: Specimen) -> dict:
    """Return the materials: one, with the E that gives bonds the mean normal stiffness of the specimen."""
    mean = specimen.radius[specimen.pairs].mean(axis=1)
    young = float((specimen.kn * specimen.length / (np.pi * mean**2)).mean())
    relation = {
        "material_names_list": ["bonded", "bonded"],
        "material_ids_list": [1, 1],
        "Variables": {
            "STATIC_FRICTION": 0.0, "DYNAMIC_FRICTION": 0.0, "FRICTION_DECAY": 500.0, "PARTICLE_COHESION": 0.0,
            "COEFFICIENT_OF_RESTITUTION": 1.0, "PARTICLE_MATERIAL": 1, "ROLLING_FRICTION": 0.0,
            "ROLLING_FRICTION_WITH_WALLS": 0.0, "DAMPING_GAMMA": 0.0, "ROTATIONAL_MOMENT_COEFFICIENT": 1.0,
            "DEM_CONTINUUM_CONSTITUTIVE_LAW_NAME": "DEM_KDEM",
            "DEM_DISCONTINUUM_CONSTITUTIVE_LAW_NAME": "DEM_D_Linear_viscous_Coulomb",
            "DEM_ROLLING_FRICTION_MODEL_NAME": "DEMRollingFrictionModelConstantTorque",
            "CONTACT_TAU_ZERO": _NEVER, "CONTACT_SIGMA_MIN": _NEVER, "CONTACT_INTERNAL_FRICC": 0.0,
        },
    }  # fmt: skip
    own = {"PARTICLE_DENSITY": DENSITY, "YOUNG_MODULUS": young, "POISSON_RATIO": POISSON}
    return {
        "materials": [{"material_name": "bonded", "material_id": 1, "Variables": own}],
        "material_relations": [relation],
        "material_assignation_table": [["SpheresPart.Bonded", "bonded"]],
    }


def parameters(specimen: Specimen) -> dict:
    """Bonds and motion, without a search for contacts."""
    return {
        "problem_name": "bonds", "Dimension": 3, "do_print_results_option": False, "BoundingBoxOption": False,
        "dem_inlet_option": False, "GravityX": 0.0, "GravityY": 0.0, "GravityZ": 0.0, "RotationOption": True,
        "CleanIndentationsOption": False, "RollingFrictionOption": False, "GlobalDamping": 0.0,
        "ContactMeshOption": False, "ElementType": "SphericContPartDEMElement3D",
        "TranslationalIntegrationScheme": "Symplectic_Euler", "RotationalIntegrationScheme": "Direct_Integration",
        "solver_settings": {"strategy": "continuum_sphere_strategy", "RemoveBallsInitiallyTouchingWalls": False},
        "PoissonEffectOption": False, "ShearStrainParallelToBondOption": False, "ComputeStressTensorOption": False,
        # the usual 10 makes one search at 10 000 spheres take seconds
        "MaxAmplificationRatioOfSearchRadius": 1.0, "AmplifiedSearchRadiusExtension": 0.0,
        "DeltaOption": "Absolute", "SearchTolerance": 1e-8 * float(specimen.radius.mean()),
        "NeighbourSearchFrequency": 1_000_000_000,
        "MaxTimeStep": float(specimen.dt), "FinalTime": 1.0, "GraphExportFreq": 1.0,
        "VelTrapGraphExportFreq": 1.0, "OutputTimeStep": 1.0,
    }  # fmt: skip
