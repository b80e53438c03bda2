"""Outcome of a run of any code, and measures of its difference from bondem."""

from dataclasses import asdict, dataclass, fields
from pathlib import Path

import numpy as np
from specimen import Specimen


@dataclass(frozen=True, kw_only=True)
class Outcome:
    """Outcome of a run: `check` steps that are compared, then `steps` steps that are timed.

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

    def save(self, path: Path) -> None:
        np.savez(path, **asdict(self))

    @classmethod
    def load(cls, path: Path) -> "Outcome":
        with np.load(path) as file:
            values = {item.name: file[item.name] for item in fields(cls)}
        return cls(
            **{
                **values,
                "seconds": float(values["seconds"]),
                "bonds": int(values["bonds"]),
                "version": str(values["version"]),
            }
        )


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
