"""Runs of Yade with `CohFrictMat` and `Law2_ScGeom6D_CohFrictPhys_CohesionMoment`: execution and outcome."""

import os
import subprocess
from pathlib import Path

from outcome import Code, Outcome, why_not
from specimen import Specimen

_SCRIPT = Path(__file__).parent / "yade_script.py"


class Yade(Code):
    """The executable is `yade`, or what the environment variable YADE names."""

    name = "yade"
    differs = (
        "bonds shear where the spheres touch, not in the middle",
        "bonds compute their strength, which is never reached",
    )

    def __init__(self) -> None:
        self.executable = os.environ.get("YADE", "yade")

    def missing(self) -> str:
        return why_not([self.executable, "--version"])

    def run(self, specimen: Specimen, folder: Path, check: int, steps: int) -> Outcome:
        specimen.save(folder / "specimen.npz")
        answer = folder / "outcome.npz"
        answer.unlink(missing_ok=True)
        command = [self.executable, "-n", "-x", "-j1", str(_SCRIPT), str(folder), str(check), str(steps)]
        environment = {**os.environ, "PYTHONPATH": str(_SCRIPT.parent), "OMP_NUM_THREADS": "1"}
        done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)
        # the exit status of Yade does not show errors in the script
        if not answer.exists():
            raise RuntimeError(f"Yade left no answer: {done.stderr.strip()[-2000:]}")
        return Outcome.load(answer)
