"""Resistance of facets to relative rotations of their cells: bending, and twist at free surfaces.

The opening of a facet varies over it where its cells turn. Openings along the normal n give the bending resistance
H = (2 G / L)(tr S P - S), with the shear modulus G, the distance L of the centres, the second moment S of the facet
and P = 1 - n⊗n. Openings in its plane (twist) would give up to (2 G / L) tr S n⊗n. The curl of the shear on a facet
is ∂ω_n/∂n in a continuum, and twice that on a rigid facet, so that only a part of this resistance is right. At a free
surface of normal a this part is (2 G / L) a·S·a, the bending of a plate whatever the directions of its facets. In a
column it is that of Saint-Venant's torsion. Inside a body, and where two free surfaces meet, facets resist no twist.
"""

import numpy as np

from bondem._types import Floats, Ints
from bondem.interactions.cells.free_walls import FreeWalls

# cos² of the angle between the walls of two cells within which they are one wall.
_PARALLEL = 0.8
# Torsion constant of a cross-section over A⁴ / I_p, exact for a square.
_TORSION = 0.1406 / 6.0


def resistance(S: Floats, normal: Floats, stiffness: Floats, rotation: str) -> Floats:
    """Return the resistance H of facets to relative rotations, without twist at free surfaces [N·m], (m, 3, 3).

    Args:
        S: second moments of the facets [m⁴], (m, 3, 3).
        normal: normals of the facets, (m, 3).
        stiffness: 2 G / L [Pa/m], (m,).
        rotation: "bending", "full" or "none".
    """
    if rotation == "none":
        return np.zeros_like(S)
    unit = np.eye(3)
    if rotation == "bending":
        unit = unit - normal[:, :, None] * normal[:, None, :]
    return stiffness[:, None, None] * (np.einsum("mii->m", S)[:, None, None] * unit - S)


def twist_at_walls(
    S: Floats, area: Floats, normal: Floats, stiffness: Floats, walls: FreeWalls, cells: tuple[Ints, Ints]
) -> Floats:
    """Return the twisting part of H of facets between two cells at the same free surface [N·m], (m, 3, 3).

    Args:
        S: second moments of the facets [m⁴], (m, 3, 3).
        area: areas of the facets [m²], (m,).
        normal: normals of the facets, (m, 3).
        stiffness: 2 G / L [Pa/m], (m,).
        walls: directions across which the cells are free.
        cells: cells on both sides of each facet, (m,) each.
    """
    one, other = (walls.wall[cell] for cell in cells)
    parallel = (one * other).sum(axis=1) ** 2 > _PARALLEL
    moment = 0.5 * parallel * (np.einsum("ma,mab,mb->m", one, S, one) + np.einsum("ma,mab,mb->m", other, S, other))
    column = walls.column[cells[0]] & walls.column[cells[1]]
    polar = np.einsum("mii->m", S)
    moment = np.where(column, 0.5 * _TORSION * area**4 / np.where(column, polar, 1.0), moment)
    return (stiffness * moment)[:, None, None] * normal[:, :, None] * normal[:, None, :]
