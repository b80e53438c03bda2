"""What comes back from a run of any code, and whether it is the motion that bondem finds."""

from dataclasses import asdict, dataclass, fields
from pathlib import Path

import numpy as np
from specimen import Specimen


@dataclass(frozen=True, kw_only=True)
class Outcome:
    """One run: `check` steps that are compared, then `steps` steps that are timed.

    Attributes:
        seconds: of the loop over the timed steps alone, as the code itself gives it [s].
        bonds: bonds not broken at the end.
        position: centres after the first `check` steps [m], shape (n, 3).
        velocity, spin: after all steps [m/s] and [rad/s], shape (n, 3).
        version: of the code.
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
    """Of spheres [J]."""
    inertia = 0.4 * specimen.mass * specimen.radius**2
    return float(0.5 * (specimen.mass @ (velocity**2).sum(axis=1) + inertia @ (spin**2).sum(axis=1)))


def kinetic_share(specimen: Specimen, outcome: Outcome) -> float:
    """Kinetic energy at the end over that at the start [-]; about one half, as the rest is in the bonds."""
    start = kinetic_energy(specimen, specimen.velocity, np.zeros_like(specimen.velocity))
    return kinetic_energy(specimen, outcome.velocity, outcome.spin) / start


def difference(specimen: Specimen, outcome: Outcome, reference: Outcome, check: int) -> float:
    """Relative difference of what the bonds did to the positions in `check` steps [-].

    Free flight is taken off both: what is left comes from forces and torques of bonds alone. Positions are
    compared, not velocities, because some codes keep these half a step earlier; as nothing is strained at the start,
    positions of leapfrog and velocity Verlet are the same.
    """
    flight = specimen.position + check * specimen.dt * specimen.velocity
    theirs, ours = outcome.position - flight, reference.position - flight
    return float(np.linalg.norm(theirs - ours) / np.linalg.norm(ours))
