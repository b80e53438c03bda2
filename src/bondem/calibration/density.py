"""Density of the elements, from eq (19) of André et al. (2012) or from all mass moments of the body."""

from collections.abc import Sequence

import numpy as np

from bondem._types import Floats, PerElement
from bondem.errors import InputError
from bondem.geometry.moments import moments
from bondem.specimen.lattice import Lattice

# Largest relative error of the moments, from rounding.
_ROUNDING = 1e-10


def element_density(lattices: Sequence[Lattice], rho: float) -> float:
    """Compute the uniform element density that gives specimens the mass of their material [kg/m³].

    ρ_μ = ρ_M V_M / Σ V_μ, with V_M the volume of the shape and the sum over connected elements. Rattlers do not move
    with the specimen, so that their mass does not count. Over several lattices both volumes are summed.

    Args:
        lattices: the specimens.
        rho: density of the material [kg/m³].

    Raises:
        InputError: a scene of several bodies.
    """
    for one in lattices:
        one.bodies.require_one("element_density")
    particles = [lattice.particles for lattice in lattices]
    solid = sum(p.volume[lattice.connected].sum() for p, lattice in zip(particles, lattices, strict=True))
    return float(rho * sum(p.envelope.volume for p in particles) / solid)


def balanced_density(lattice: Lattice, rho: float) -> PerElement:
    """Compute element densities that reproduce the mass, the centre of mass and the inertia tensor of the shape.

    Eq (19) gives the mass only. Spheres fill the skin of a body less than its core, so that moments of inertia are
    then a few percent too small. Here each element has its own density,

        min Σ (ρ_i / ρ_μ - 1)²   with   Σ m_i = M,   Σ m_i x_i = M c,   Σ m_i (r_i² 1 - r_i r_iᵀ + 2/5 R_i² 1) = I,

    with ρ_μ of eq (19). The minimum under ten linear conditions varies smoothly over the body: it is a polynomial of
    second degree in position times the element's volume. Rattlers keep ρ_μ and are not counted.

    Args:
        lattice: the specimen; `Model(density=)` accepts the result.
        rho: density of the material [kg/m³].

    Returns:
        Density ρ_i of each element [kg/m³], user's order, (n,), all positive.

    Raises:
        InputError: no positive densities satisfy the conditions (too few elements), several bodies, a periodic cell.
    """
    particles, inside = lattice.particles, lattice.connected
    body = moments(particles.envelope)
    uniform = element_density([lattice], rho)
    size = (body.volume) ** (1.0 / 3.0)
    arm = (particles.position[inside] - body.centre) / size
    mass = uniform * particles.volume[inside] / (rho * body.volume)
    own = 0.4 * (particles.radius[inside] / size) ** 2
    rows = mass * _conditions(arm, own)
    inertia = body.inertia[[0, 1, 2, 1, 0, 0], [0, 1, 2, 2, 2, 1]]
    wanted = np.concatenate([[1.0, 0.0, 0.0, 0.0], inertia / (body.volume * size**2)])
    factor = np.ones(len(mass))
    for _ in range(2):  # the second round removes the rounding error of the first
        factor += np.linalg.lstsq(rows, wanted - rows @ factor, rcond=None)[0]
    if np.abs(rows @ factor - wanted).max() > _ROUNDING or not (factor > 0.0).all():
        raise InputError(
            f"lattice: {len(mass)} connected elements cannot have the mass and inertia of {particles.envelope} at"
            " positive densities; pack more elements, or use the uniform density of eq (19) (bd.element_density)"
        )
    density = np.full(len(particles), uniform)
    density[inside] *= factor
    return density


def _conditions(arm: Floats, own: PerElement) -> Floats:
    """Contributions of unit masses at arms (n, 3) with inertia (n,) to mass, first moments and inertia, (10, n)."""
    x, y, z = arm.T
    one = np.ones_like(x)
    return np.stack([one, x, y, z, y * y + z * z + own, z * z + x * x + own, x * x + y * y + own,
                     -y * z, -x * z, -x * y])  # fmt: skip
