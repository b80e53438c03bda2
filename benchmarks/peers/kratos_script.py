"""Script that the Python of Kratos runs: `python kratos_script.py FOLDER CHECK STEPS`, with the input in FOLDER."""

import sys
import time
from pathlib import Path

import KratosMultiphysics as Core
import numpy as np
from KratosMultiphysics.DEMApplication.DEM_analysis_stage import DEMAnalysisStage
from outcome import Outcome
from specimen import Specimen

folder, check, steps = Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
specimen = Specimen.load(folder / "specimen.npz")
Core.Logger.GetDefaultOutput().SetSeverity(Core.Logger.Severity.WARNING)
Core.ParallelUtilities.SetNumThreads(1)
stage = DEMAnalysisStage(Core.Model(), Core.Parameters((folder / "ProjectParametersDEM.json").read_text()))
stage.Initialize()
nodes = list(stage.spheres_model_part.Nodes)
for node, velocity in zip(nodes, specimen.velocity, strict=True):
    node.SetSolutionStepValue(Core.VELOCITY, velocity.tolist())


def go(count: int) -> float:
    """Take steps as the loop of an analysis does, without output; return their wall time [s]."""
    start = time.perf_counter()
    for _ in range(count):
        stage.time = stage._AdvanceTime()
        stage.InitializeSolutionStep()
        stage.SolveSolutionStep()
        stage.FinalizeSolutionStep()
    return time.perf_counter() - start


def values(variable) -> np.ndarray:
    return np.array([list(node.GetSolutionStepValue(variable)) for node in nodes])


def touching() -> int:
    """Return the number of pairs that transmit force: bonds and contacts."""
    # the argument is the spread of the coordination number, which Kratos does not use
    return round(0.5 * stage._GetSolver().cplusplus_strategy.ComputeCoordinationNumber(0.0) * len(nodes))


go(check)
bonds = touching()
position = np.array([[node.X, node.Y, node.Z] for node in nodes])
seconds = go(steps)
Outcome(
    seconds=seconds,
    bonds=min(bonds, touching()),
    position=position,
    velocity=values(Core.VELOCITY),
    spin=values(Core.ANGULAR_VELOCITY),
    version="Kratos " + Core.KratosGlobals.Kernel.Version().split("-")[0].replace('"', ""),
).save(folder / "outcome.npz")
