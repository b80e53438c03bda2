"""Bonds of their own for the layer of spheres at walls and for what is inside.

A packing of 6.2 contacts a sphere has about five at its walls and the more inside, seven in a thin body: there it is
stiffer than a periodic cell of 6.2. The first layer at a wall is softer: its spheres have no neighbours on the other
side, and half a layer in front of their centres has no bonds at all. One law for the whole body can be right for its
mean stiffness, not for both; bending and torsion, which the skin decides, then come out too soft. So

    inside      bonds calibrated in a cell that has as many contacts a sphere as the inside has
    at walls    the same, stiffer by factors that depend on the law alone

and the elements get `balanced_density`, because a skin with its stiffness back wants its mass back as well.
"""

from dataclasses import replace
from functools import cache

import numpy as np

import bondem as bd

#: At walls E_μ is a - b r̃ times, and r̃ c times that inside [-]. a and b are fitted to E and the free frequencies of
#: cube, beam and bracket of 8000 spheres, of fused silica (r̃ = 0.71) and of steel (r̃ = 0.33), c to ν of the same beam
#: of fused silica, which comes out 4 % high without it; at the small r̃ of steel it has little effect.
SKIN = (1.14, 0.17, 1.07)


def layered_bonds(
    material: bd.Material, lattice: bd.Lattice, *, touching: float = 0.02
) -> dict[bd.Index | tuple[bd.Index, bd.Index], bd.EulerBernoulli]:
    """What `Model(bond=)` takes.

    Args:
        material: the target.
        lattice: a specimen with walls.
        touching: how far from a wall the surface of spheres of the first layer may lie, in mean radii [-].
    """
    particles = lattice.particles
    gap = particles.envelope.depth(particles.position) - particles.radius
    at_wall = gap < touching * particles.mean_radius
    contacts = np.bincount(lattice.pairs.ravel(), minlength=len(particles))
    inner = inner_bonds(material, round(float(contacts[~at_wall].mean()), 2))
    a, b, c = SKIN
    outer = replace(inner, E=(a - b * inner.radius_ratio) * inner.E, radius_ratio=c * inner.radius_ratio)
    skin, inside = bd.Index(np.flatnonzero(at_wall)), bd.Index(np.flatnonzero(~at_wall))
    return {inside: inner, skin: outer, (skin, inside): outer}


@cache
def inner_bonds(material: bd.Material, contacts: float, *, count: int = 4000) -> bd.EulerBernoulli:
    """Bonds calibrated in a periodic cell with this many contacts a sphere."""
    cube = bd.Cell((1e-2, 1e-2, 1e-2))
    particles = bd.pack(cube, count=count, spread=0.25, seed=1, coordination_number=contacts)
    return bd.calibrate(bd.connect(particles), material, law=bd.EulerBernoulli).law
