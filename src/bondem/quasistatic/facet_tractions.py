"""Tractions of facets of any integrity in small motions about the reference, without friction.

A facet has two halves, one in each cell. Each half in compression keeps its stiffness along the normal
(`bondem.laws.softening`). All arrays have one row per facet, in the kernels' order.
"""

from dataclasses import dataclass

import numpy as np

from bondem._types import Floats, Ints, Mask

# A half of a facet closes or opens where its force along the normal exceeds this share of its magnitude.
_TURNS = 1e-9
_XX = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))


@dataclass(frozen=True, eq=False)
class FacetConstants:
    """Constants of m facets.

    Attributes:
        i, j: cells of each facet, (m,).
        k: stiffness [N/m], (m,).
        area: area [m²], (m,).
        part: share of cell i in the compliance [-], (m,).
        lever_i, lever_j: levers from the cells to the facet [m], (m, 3).
        share_i, share_j: shares of the gap in V θ of both cells [m²], (m, 3).
        normal: normals from i to j [-], (m, 3).
        H: resistance to bending and twisting [N·m], (m, 3, 3).
    """

    i: Ints
    j: Ints
    k: Floats
    area: Floats
    part: Floats
    lever_i: Floats
    lever_j: Floats
    share_i: Floats
    share_j: Floats
    normal: Floats
    H: Floats

    def gaps(self, u: Floats, phi: Floats) -> Floats:
        """Return the gaps of the facets under displacements and rotations of the cells (n, 3) each [m], (m, 3)."""
        i, j = self.i, self.j
        return u[j] + _cross(phi[j], self.lever_j) - u[i] - _cross(phi[i], self.lever_i)

    def add_swelling(self, gap: Floats, integrity: Floats, closed: Mask, swelling: Floats) -> None:
        """Add V θ [m³] of gaps (m, 3) to those of the cells, (n,)."""
        along = _dot(gap, self.normal)
        for half, cell, share in ((0, self.i, self.share_i), (1, self.j, self.share_j)):
            grown = integrity * _dot(share, gap)
            shut = np.flatnonzero(closed[:, half])
            grown[shut] += (1.0 - integrity[shut]) * _dot(share[shut], self.normal[shut]) * along[shut]
            swelling += np.bincount(cell, grown, len(swelling))

    def bending(self, phi: Floats) -> Floats:
        """Return T_b of the facets as if they were whole, under rotations of the cells (n, 3) [Pa], (m,)."""
        turn = phi[self.j] - phi[self.i]
        square = np.einsum("ma,mab,mb->m", turn, self.H, turn)
        return np.sqrt(self.k * np.maximum(square, 0.0)) / self.area  # slivers are below 0 by rounding


@dataclass(frozen=True, eq=False)
class FacetTractions:
    """Tractions of facets, and of those that have lost integrity what they would bear as whole ones.

    Attributes:
        force: force on cell i [N], (m, 3).
        cracked: facets that have lost integrity, (c,).
        opening: traction of these, as if they were whole [Pa], (c, 3).
        opened: |F⁺| / A of these [Pa], (c,).
        turned: mask of their halves that close or open now, (c, 2).
    """

    force: Floats
    cracked: Ints
    opening: Floats
    opened: Floats
    turned: Mask

    @classmethod
    def of(
        cls, facets: FacetConstants, gap: Floats, stress: Floats, integrity: Floats, closed: Mask
    ) -> "FacetTractions":
        """Return tractions under gaps (m, 3) [m] and the stresses λ θ of the cells (n,) [Pa]."""
        f = facets
        force = f.k[:, None] * gap + stress[f.i, None] * f.share_i + stress[f.j, None] * f.share_j
        cracked = np.flatnonzero(integrity < 1.0)
        area, whole = f.area[cracked, None], force[cracked]
        spring, normal, s = f.k[cracked, None] * gap[cracked], f.normal[cracked], integrity[cracked, None]
        part = np.stack([f.part[cracked], 1.0 - f.part[cracked]])[:, :, None]
        left, opens, turned = np.zeros_like(whole), np.zeros_like(whole), np.zeros((len(cracked), 2), dtype=bool)
        for half, cell, share in ((0, f.i, f.share_i), (1, f.j, f.share_j)):
            own = spring + stress[cell[cracked], None] / part[half] * share[cracked]
            along = _dot(own, normal)[:, None]
            shut = closed[cracked, half, None]
            pressed = np.where(shut, along * normal, 0.0)
            left += part[half] * (s * own + (1.0 - s) * pressed)
            opens += part[half] * (own - pressed)
            size = _TURNS * np.sqrt(_dot(own, own))[:, None]
            turned[:, half] = np.where(shut, along > size, along < -size)[:, 0]
        force[cracked] = left
        return cls(force, cracked, whole / area, np.sqrt(_dot(opens, opens)) / area[:, 0], turned)


def accumulate_moments(moment: Floats, owner: Ints, arm: Floats, force: Floats) -> None:
    """Add sym b⊗f to V σ of the owners: xx, yy, zz, xy, xz, yz, (n, 6)."""
    for column, (a, b) in enumerate(_XX):
        part = arm[:, a] * force[:, b] if a == b else 0.5 * (arm[:, a] * force[:, b] + arm[:, b] * force[:, a])
        moment[:, column] += np.bincount(owner, part, len(moment))


def _cross(a: Floats, b: Floats) -> Floats:
    """Return the vector products of rows, (m, 3)."""
    x, y, z = a.T
    p, q, r = b.T
    return np.stack([y * r - z * q, z * p - x * r, x * q - y * p], axis=1)


def _dot(a: Floats, b: Floats) -> Floats:
    return np.einsum("ma,ma->m", a, b)
