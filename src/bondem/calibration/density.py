"""Density of the elements from mass equality, eq (19) of André et al. (2012)."""

from collections.abc import Sequence

from bondem.specimen.lattice import Lattice


def element_density(lattices: Sequence[Lattice], rho: float) -> float:
    """ρ_μ = ρ_M V_M / Σ V_μ [kg/m³], V_M the volume of the shape.

    The sum runs over connected elements: rattlers do not move with the specimen, so their mass is not part of
    it. Over several lattices both volumes are added up.

    Args:
        lattices: the specimens.
        rho: density of the material [kg/m³].
    """
    particles = [lattice.particles for lattice in lattices]
    solid = sum(p.volume[lattice.connected].sum() for p, lattice in zip(particles, lattices, strict=True))
    return float(rho * sum(p.envelope.volume for p in particles) / solid)
