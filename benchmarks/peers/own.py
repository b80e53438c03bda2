"""bondem itself, in a process of its own like any peer: `python own.py FOLDER CHECK STEPS LAW`."""

import os
import subprocess
import sys
import time
from pathlib import Path

from outcome import Code, Outcome
from specimen import DENSITY, POISSON, RADIUS_RATIO, YOUNG, Specimen


class Bondem(Code):
    """The code that is compared with the others."""

    name = "bondem"
    law = "beams"

    def run(self, specimen: Specimen, folder: Path, check: int, steps: int) -> Outcome:
        specimen.save(folder / "specimen.npz")
        command = [sys.executable, __file__, str(folder), str(check), str(steps), self.law]
        subprocess.run(command, check=True, env={**os.environ, "BONDEM_NUM_THREADS": "1"})
        return Outcome.load(folder / "outcome.npz")


class NonLocalBondem(Bondem):
    """bondem with the non-local law, which authors of Kratos published, and its criterion."""

    name = "non-local"
    differs = (
        "bd.NonLocal with Rankine's criterion, never reached: stresses of all elements in every step",
        "with local damping of 0.3 and a time step of its own: without damping its lag feeds motions at any step",
    )
    alike = False
    law = "non-local"
    own_law = True  # its motion differs from that of beams


def _run(specimen: Specimen, check: int, steps: int, which: str) -> Outcome:
    import bondem as bd
    from bondem.dynamics.explicit import integrate
    from bondem.dynamics.plan import Plan
    from bondem.dynamics.schemes import VelocityVerlet
    from bondem.dynamics.timestep import choose_step
    from bondem.model.state import State

    lattice = bd.Lattice(bd.Particles(specimen.position, specimen.radius), specimen.pairs)
    dt, damping = float(specimen.dt), None
    if which == "beams":
        law = bd.EulerBernoulli(E=YOUNG, nu=POISSON, radius_ratio=RADIUS_RATIO)
        model = bd.Model(lattice, law, DENSITY)
    else:
        law = bd.NonLocal(E=RADIUS_RATIO**2 * YOUNG, nu=POISSON, areas="weighted", lever="contact")
        model = bd.Model(lattice, law, DENSITY, failure=bd.Rankine(tension=1e20))
        damping = bd.LocalDamping(0.3)
        dt = min(dt, choose_step(model, VelocityVerlet(), None, safety=0.9, damping=damping).dt)
    state = State(model)
    state.set_motion(velocity=specimen.velocity)

    def go(state: State, steps: int) -> tuple[float, State]:
        plan = Plan(duration=(state.step + steps) * dt, dt=dt, every=0, damping=damping)
        end = state.step + steps
        start = time.perf_counter()
        state = integrate(model, plan, state=state).state
        seconds = time.perf_counter() - start
        if state.step != end:
            raise RuntimeError(f"the run ended at step {state.step} of {end}")
        return seconds, state

    state = go(state, check)[1]
    position = state.position.copy()
    seconds, state = go(state, steps)
    return Outcome(
        seconds=seconds,
        bonds=int((state.bond_integrity > 0.0).sum()),
        position=position,
        velocity=state.velocity,
        spin=state.angular_velocity,
        version=f"bondem {bd.__version__}",
    )


if __name__ == "__main__":
    here = Path(sys.argv[1])
    check, steps = (int(word) for word in sys.argv[2:4])
    _run(Specimen.load(here / "specimen.npz"), check, steps, sys.argv[4]).save(here / "outcome.npz")
