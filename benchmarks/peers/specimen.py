"""Specimen that all codes run: a dense random packing in a box, bonded at its contacts, with a small motion.

Only NumPy is needed to read a specimen, so that scripts in the Python of other codes can read it.
"""

from dataclasses import asdict, dataclass, fields
from pathlib import Path

import numpy as np

YOUNG = 265e9
POISSON = 0.3
RADIUS_RATIO = 0.71
DENSITY = 2500.0
MEAN_RADIUS = 1e-3
# Amplitude of the motion over the mean bond length: small enough for linear bonds to be compared, far above rounding
# (LAMMPS takes angles from arc cosines, which are good to 1e-8).
STRAIN = 1e-4
# Share of the critical time step: other codes become unstable near the limit, and a step takes the same time at any
# dt.
STEP_SHARE = 0.5


class Saved:
    """Data that is kept in a file of arrays."""

    def save(self, path: Path) -> None:
        np.savez(path, **asdict(self))

    @classmethod
    def load(cls, path: Path):
        """Data of a file; what is no array there is a number or a text."""
        with np.load(path) as file:
            values = {item.name: file[item.name] for item in fields(cls)}
        return cls(**{name: value if value.ndim else value.item() for name, value in values.items()})


@dataclass(frozen=True, kw_only=True)
class Specimen(Saved):
    """Everything a code needs to know, and nothing else.

    Attributes:
        position: centres [m], shape (n, 3).
        radius: radii of the elements [m], shape (n,).
        pairs: elements i < j of each bond, shape (m, 2).
        kn, ks, kb, kt: normal, shear [N/m], bending and twisting stiffness [N·m], each of shape (m,).
        bond_radius: radius of all bonds [m].
        velocity: initial velocities [m/s], shape (n, 3); initial spins are zero.
        dt: time step [s].
    """

    position: np.ndarray
    radius: np.ndarray
    pairs: np.ndarray
    kn: np.ndarray
    ks: np.ndarray
    kb: np.ndarray
    kt: np.ndarray
    bond_radius: float
    velocity: np.ndarray
    dt: float

    @property
    def length(self) -> np.ndarray:
        """Distance of bonded centres [m], shape (m,)."""
        return np.linalg.norm(self.position[self.pairs[:, 1]] - self.position[self.pairs[:, 0]], axis=1)

    @property
    def mass(self) -> np.ndarray:
        """Masses of the elements [kg], shape (n,)."""
        return 4.0 / 3.0 * np.pi * self.radius**3 * DENSITY


def build(elements: int, *, seed: int = 1) -> Specimen:
    """Return a specimen of `elements` spheres with κ = 25 %, z of about 6.2, and Euler–Bernoulli bonds."""
    import bondem as bd
    from bondem.dynamics.timestep import critical_step

    edge = (elements * 4.0 / 3.0 * np.pi * MEAN_RADIUS**3 / 0.64) ** (1.0 / 3.0)
    lattice = bd.connect(bd.pack(bd.Box(size=(edge, edge, edge)), count=elements, spread=0.25, seed=seed))
    particles = lattice.particles
    law = bd.EulerBernoulli(E=YOUNG, nu=POISSON, radius_ratio=RADIUS_RATIO)
    critical = critical_step(bd.Model(lattice, law, DENSITY), bd.VelocityVerlet())
    radius = RADIUS_RATIO * particles.mean_radius
    L = lattice.length
    area, second_moment = np.pi * radius**2, 0.25 * np.pi * radius**4
    EI, GJ = YOUNG * second_moment, YOUNG / (2.0 * (1.0 + POISSON)) * 2.0 * second_moment
    # displacements of STRAIN · L at about half the highest frequency, 2 / critical
    speed = STRAIN * L.mean() / critical
    velocity = speed * np.random.default_rng(seed).standard_normal((elements, 3))
    mass = particles.volume
    velocity -= (mass[:, None] * velocity).sum(axis=0) / mass.sum()
    return Specimen(
        position=particles.position,
        radius=particles.radius,
        pairs=lattice.pairs,
        kn=YOUNG * area / L,
        ks=12.0 * EI / L**3,
        kb=EI / L,
        kt=GJ / L,
        bond_radius=radius,
        velocity=velocity,
        dt=STEP_SHARE * critical,
    )
