"""Outcome of a run of any code, and measures of its difference from bondem."""

import subprocess
from dataclasses import dataclass

import numpy as np
from specimen import Saved, Specimen


@dataclass(frozen=True, kw_only=True)
class Outcome(Saved):
    """One run: `check` steps that are compared, then `steps` steps that are timed.

    Attributes:
        seconds: wall time of the loop over the timed steps alone, as the code itself gives it [s].
        bonds: number of unbroken bonds at the end.
        position: centres after the first `check` steps [m], shape (n, 3).
        velocity, spin: velocities [m/s] and angular velocities [rad/s] after all steps, shape (n, 3).
        version: name and version of the code.
    """

    seconds: float
    bonds: int
    position: np.ndarray
    velocity: np.ndarray
    spin: np.ndarray
    version: str


class Code:
    """A code that is compared, with what its motion and its bonds have in common with bondem.

    Attributes:
        name: in tables and records.
        differs: remarks on what differs.
        alike: whether its bonds are those of bondem, so that its motion has to be the same.
        own_law: whether its motion is that of another law.
    """

    name = ""
    differs: tuple[str, ...] = ()
    alike = True
    own_law = False

    def missing(self) -> str:
        """Why the code cannot run here; "" where it can."""
        return ""


def why_not(command: list[str], wanted: str = "", environment: dict[str, str] | None = None) -> str:
    """Why a command fails, or that it does not print what is wanted; "" where it does."""
    try:
        done = subprocess.run(command, env=environment, capture_output=True, text=True)
    except OSError as error:
        return f"{command[0]}: {error.strerror}"
    if done.returncode and not wanted:
        return f"{' '.join(command)} fails: {done.stderr.strip().splitlines()[-1:]}"
    return "" if wanted in done.stdout else f"{command[0]} was built without {wanted}"


def kinetic_energy(specimen: Specimen, velocity: np.ndarray, spin: np.ndarray) -> float:
    """Return the kinetic energy of spheres with velocities [m/s] and spins [rad/s], (n, 3) each [J]."""
    inertia = 0.4 * specimen.mass * specimen.radius**2
    return float(0.5 * (specimen.mass @ (velocity**2).sum(axis=1) + inertia @ (spin**2).sum(axis=1)))


def kinetic_share(specimen: Specimen, outcome: Outcome) -> float:
    """Return the kinetic energy at the end over that at the start [-], about one half: the rest is in the bonds."""
    start = kinetic_energy(specimen, specimen.velocity, np.zeros_like(specimen.velocity))
    return kinetic_energy(specimen, outcome.velocity, outcome.spin) / start


def difference(specimen: Specimen, outcome: Outcome, reference: Outcome, check: int) -> float:
    """Return the relative difference of displacements by the bonds in `check` steps [-].

    Free flight is subtracted from both, so that only forces of bonds count. Positions are compared, because some
    codes store velocities half a step earlier. Positions of leapfrog and velocity Verlet are the same for an initial
    state without strain.
    """
    flight = specimen.position + check * specimen.dt * specimen.velocity
    theirs, ours = outcome.position - flight, reference.position - flight
    return float(np.linalg.norm(theirs - ours) / np.linalg.norm(ours))
