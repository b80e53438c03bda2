"""The section that internal forces fill, smaller than that of the walls (André et al. 2012, fig. 22)."""

import math
from dataclasses import dataclass

import numpy as np

import bondem as bd
from bondem._types import Floats
from bondem.errors import InputError
from bondem.labtests.tension import static_bond_forces
from bondem.specimen.interior import solid

# Points along a bond; one reaches over some two annuli.
_POINTS = 64


@dataclass(frozen=True, eq=False)
class SectionProfile:
    """What lies and what is carried at each distance from the axis, in the middle half of the length.

    Attributes:
        edge: of the annuli [m], (b + 1,).
        stress: axial force through an annulus over its area, over the mean of the whole section [-], (b,).
        solid: volume fraction of the annulus [-], (b,).
    """

    edge: Floats
    stress: Floats
    solid: Floats

    @property
    def middle(self) -> Floats:
        """Middle of each annulus [m], (b,)."""
        return 0.5 * (self.edge[1:] + self.edge[:-1])

    @property
    def carried(self) -> Floats:
        """Share of the axial force within each edge [-], (b + 1,)."""
        area = np.pi * np.diff(self.edge**2)
        return np.concatenate([[0.0], np.cumsum(self.stress * area)]) / (math.pi * self.edge[-1] ** 2)


def section_profile(model: bd.Model, solution: bd.StaticResult, *, annuli: int = 40) -> SectionProfile:
    """Axial stress and volume fraction over the distance from the axis of a cylinder in tension.

    A bond carries its axial force along the straight line between two centres: its share of an annulus is the length
    along x that the line has in it. So every plane across the middle half carries the whole force.

    Args:
        model: a free cylinder under tension along x.
        solution: its equilibrium.
        annuli: of equal width.

    Raises:
        InputError: the specimen is no Cylinder.
    """
    lattice = model.lattice
    shape = lattice.particles.envelope
    if not isinstance(shape, bd.Cylinder):
        raise InputError(f"a profile over the radius takes a Cylinder, not a {type(shape).__name__}")
    low, high = 0.25 * shape.length, 0.75 * shape.length
    edge = np.linspace(0.0, shape.radius, annuli + 1)
    start, step = lattice.particles.position[lattice.pairs[:, 0]], lattice.branch
    carried = static_bond_forces(model, solution)[:, 0] * step[:, 0]
    force = np.zeros(annuli)
    for share in (np.arange(_POINTS) + 0.5) / _POINTS:
        x, y, z = (start + share * step).T
        inside = (x >= low) & (x <= high)
        force += np.histogram(np.hypot(y, z)[inside], edge, weights=carried[inside])[0] / _POINTS
    area = np.pi * np.diff(edge**2)
    balls = solid(lattice.particles, shape)
    inside = (balls.position[:, 0] >= low) & (balls.position[:, 0] <= high)
    distance = np.hypot(*balls.position[inside, 1:].T)
    volume = np.histogram(distance, edge, weights=balls.volume[inside])[0]
    return SectionProfile(
        edge=edge,
        stress=force / force.sum() * area.sum() / area,
        solid=volume / (area * (high - low)),
    )


@dataclass(frozen=True)
class SectionRadii:
    """Radii one may give the same cylinder [m].

    Attributes:
        walls: of the shape, the "max section".
        paper: R_M of eq (13): R̄ and the mean distance of the elements at the side from the axis.
        force: of the uniform disc with the ⟨y²⟩ + ⟨z²⟩ of the axial force in tension.
        mass: the same of the mass.
        centres: R_M of eq (13) without R̄, the mean distance of the elements at the side from the axis: bonds run
            between centres, so hardly any internal force exists further out.
    """

    walls: float
    paper: float
    force: float
    mass: float
    centres: float

    @classmethod
    def of(cls, lattice: bd.Lattice, *, force: Floats, mass: Floats, depth: float = 0.02) -> "SectionRadii":
        """Of a cylinder, from ⟨y²⟩ and ⟨z²⟩ of force and mass [m²], (2,) each."""
        shape = lattice.particles.envelope
        if not isinstance(shape, bd.Cylinder):
            raise InputError(f"the radius of a section takes a Cylinder, not a {type(shape).__name__}")
        side = bd.Face("side", depth).select(lattice)
        centres = float(np.hypot(*lattice.particles.position[side, 1:].T).mean())
        return cls(
            walls=shape.radius,
            paper=centres + lattice.particles.mean_radius,
            force=math.sqrt(2.0 * float(force.sum())),
            mass=math.sqrt(2.0 * float(mass.sum())),
            centres=centres,
        )


def implied_radius(largest: float, effective: float) -> dict[str, float]:
    """Effective over max radius [-] that two unsigned errors of a bending frequency against Euler–Bernoulli ask for.

    f ∝ √(E/ρ) R: with E and ρ kept, 1 + error goes with 1/R. A smaller radius raises it, so an error that becomes
    smaller was below zero; whether it stays there is left open.

    Args:
        largest: error with the max section, unsigned [-].
        effective: error with the effective section, unsigned [-].
    """
    return {"below": (1.0 - largest) / (1.0 - effective), "above": (1.0 - largest) / (1.0 + effective)}
