"""The two faces of facets or beams: their places in a state, and the opening and sliding between them."""

from dataclasses import dataclass

import numpy as np

from bondem._types import Floats, Ints
from bondem.geometry.rotations import turned_vectors
from bondem.model.state import State
from bondem.specimen.lattice import Lattice


@dataclass(frozen=True, eq=False)
class Faces:
    """Geometry of k facets, or of the sections of k beams at their contact points, in a state.

    Attributes:
        area: area in the reference, or of the section of a beam [m²], shape (k,).
        reference: centroids, or contact points of beams, in the reference; periodic image at element i [m], (k, 3).
        straight: normals in the reference, from element i to j [-], shape (k, 3).
        centroid: points half-way between both faces [m], shape (k, 3).
        normal: mean of the normals of both faces [-], shape (k, 3).
        opening: gap along the normal [m], shape (k,).
        sliding: displacement between the faces across the normal [m], shape (k,).
    """

    area: Floats
    reference: Floats
    straight: Floats
    centroid: Floats
    normal: Floats
    opening: Floats
    sliding: Floats


def faces_of(lattice: Lattice, state: State, chosen: Ints) -> Faces:
    """Compute the geometry of the facets or beams numbered `chosen`, user's order, in a state."""
    i, j = lattice.pairs[chosen].T
    area = lattice.elements.bond_area(state.model.interaction.bonds.radius)[chosen]
    straight = lattice.elements.bond_normal[chosen]
    arm = lattice.elements.bond_arm(state.model.interaction.bonds.lever, chosen)
    on_i, gap = moved_points(lattice, state, chosen, lattice.centre[i] + arm)
    q = state.orientation
    normal = turned_vectors(q[i], straight) + turned_vectors(q[j], straight)
    size = np.linalg.norm(normal, axis=1, keepdims=True)
    normal = np.where(size > 1e-6, normal / np.where(size > 1e-6, size, 1.0), straight)
    opening = (gap * normal).sum(axis=1)
    return Faces(
        area=area, reference=lattice.centre[i] + arm, straight=straight, centroid=on_i + 0.5 * gap, normal=normal,
        opening=opening, sliding=np.linalg.norm(gap - opening[:, None] * normal, axis=1),
    )  # fmt: skip


def moved_points(lattice: Lattice, state: State, facet: Ints, points: Floats) -> tuple[Floats, Floats]:
    """Move points on facets with each of the two elements that share the facet.

    Args:
        lattice: lattice of the state.
        state: state with the pose of the elements.
        facet: facet of each point, user's numbers, shape (k,).
        points: places in the reference, periodic image at element i [m], shape (k, 3).

    Returns:
        Places on element i, and vectors from there to the places on element j [m], shape (k, 3) each.
    """
    i, j = lattice.pairs[facet].T
    q, P = state.orientation, state.plastic_deformation
    stretch = np.ones(len(lattice.pairs))
    strain = state.rest_strain
    if strain.size:
        stretch[state.layout.bond_order] += strain
    arm = points - lattice.centre[i]
    other = arm - lattice.branch[facet]
    grown = stretch[facet, None]
    a = turned_vectors(q[i], np.einsum("kab,kb->ka", P[i], grown * arm))
    b = turned_vectors(q[j], np.einsum("kab,kb->ka", P[j], grown * other))
    on_i = state.position[i] + a
    return on_i, lattice.particles.nearest(state.local_position[j] - state.local_position[i]) + b - a
