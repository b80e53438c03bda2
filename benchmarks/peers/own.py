"""bondem itself, in a process of its own like any peer: `python own.py FOLDER CHECK STEPS`."""

import os
import subprocess
import sys
import time
from pathlib import Path

from outcome import Outcome
from specimen import DENSITY, POISSON, RADIUS_RATIO, YOUNG, Specimen


class Bondem:
    """The code that is compared with the others."""

    name = "bondem"
    differs = ()
    alike = True

    def missing(self) -> str:
        return ""

    def run(self, specimen: Specimen, folder: Path, check: int, steps: int) -> Outcome:
        specimen.save(folder / "specimen.npz")
        command = [sys.executable, __file__, str(folder), str(check), str(steps)]
        subprocess.run(command, check=True, env={**os.environ, "NUMBA_NUM_THREADS": "1"})
        return Outcome.load(folder / "outcome.npz")


def _run(specimen: Specimen, check: int, steps: int) -> Outcome:
    import bondem as bd
    from bondem.model.state import State
    from bondem.solve.explicit import Plan, integrate

    lattice = bd.Lattice(bd.Particles(specimen.position, specimen.radius), specimen.pairs)
    law = bd.EulerBernoulli(E=YOUNG, nu=POISSON, radius_ratio=RADIUS_RATIO)
    model = bd.Model(lattice, law, DENSITY)
    state = State(model)
    state.set_motion(velocity=specimen.velocity)
    dt = float(specimen.dt)

    def go(steps: int) -> float:
        plan = Plan(duration=(state.step + steps) * dt, dt=dt, every=0)
        start = time.perf_counter()
        integrate(model, plan, state=state)
        return time.perf_counter() - start

    go(check)
    position = state.position.copy()
    return Outcome(
        seconds=go(steps),
        bonds=int((state.bond_integrity > 0.0).sum()),
        position=position,
        velocity=state.velocity,
        spin=state.angular_velocity,
        version=f"bondem {bd.__version__}",
    )


if __name__ == "__main__":
    here = Path(sys.argv[1])
    _run(Specimen.load(here / "specimen.npz"), int(sys.argv[2]), int(sys.argv[3])).save(here / "outcome.npz")
