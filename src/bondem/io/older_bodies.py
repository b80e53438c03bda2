"""Shares of bodies in files older than the balanced shares (run files before schema 9).

A run continues with its original law. The share of a facet of area A and normal n in the dilatation of its cell p was
A w_p M_p⁻¹ n. Here w_p = d_p / (d_p + d_q), d_p is the distance of the facet from the centre of p, and M_p is
(1/V_p) Σ A d_p n⊗n over all facets of p. Particle files get balanced shares.
"""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from bondem._types import Ints
from bondem.boundary.conditions import BoundaryCondition
from bondem.boundary.wall_constraints import FixedFacets
from bondem.interactions.cells.cell_body import body_of, sums_of_normals
from bondem.specimen.lattice import Lattice
from bondem.specimen.particles import Particles, freeze
from bondem.specimen.tessellation.balanced_shares import balanced_shares
from bondem.specimen.tessellation.facets import Cells, Facets, FreeFacets

#: Fields that older files lack, by table.
LACKING = {Facets: ("share_i", "share_j"), Cells: ("remainder",), FreeFacets: ("share",)}


def balanced_body(
    particles: Particles, pairs: Ints, facets: dict[str, Any], cells: dict[str, Any], free: dict[str, Any]
) -> Lattice:
    """Create a body from the tables of an older file, with balanced shares."""
    surface = FreeFacets(**free, share=freeze(free["area"][:, None] * free["normal"]))
    span = facets["depth_i"] + facets["depth_j"]
    shares = balanced_shares(
        pairs, facets["area"][:, None] * facets["normal"], (facets["depth_i"] / span, facets["depth_j"] / span),
        particles.separation(*pairs.T), surface, cells["volume"], particles.position,
    )  # fmt: skip
    return Lattice(
        particles, pairs, facets=Facets(**facets, share_i=freeze(shares.i), share_j=freeze(shares.j)),
        cells=Cells(**cells, remainder=freeze(shares.remainder), free=surface),
    )  # fmt: skip


def with_corrected_normals(body: Lattice, boundary: Sequence[BoundaryCondition]) -> Lattice:
    """Return a body with the shares A w M⁻¹ n of run files before schema 9; body and boundary are those of the run.

    M is (1/V) Σ A d n⊗n over the facets of a cell, with area A, normal n and distance d from the centre. w is the
    part of d in the distance of both centres, 1 for a free facet. A smooth platen fixes the displacement of a facet
    along its normal only: the share of this facet is along n alone.
    """
    if body.cells is None:
        return body
    facets, cells = body_of(body)
    free, (i, j) = cells.free, body.pairs.T
    sides = ((i, facets.area * facets.depth_i, facets.normal), (j, facets.area * facets.depth_j, facets.normal))
    every = (*sides, (free.cell, free.area * free.depth, free.normal))
    M = sum(sums_of_normals(*side, len(cells.volume)) for side in every)
    inverse = np.linalg.inv(M / cells.volume[:, None, None])
    share_i, share_j = (
        (weight / facets.span)[:, None] * np.einsum("mab,mb->ma", inverse[cell], normal)
        for cell, weight, normal in sides
    )
    outer = np.einsum("kab,kb->ka", inverse[free.cell], free.normal)
    fixed = FixedFacets.of(body, boundary)
    normal = free.normal[fixed.facet]
    smooth = (((fixed.axes * normal) ** 2).sum(axis=1) > 0.5) & ~fixed.axes.all(axis=1)
    at, normal = fixed.facet[smooth], normal[smooth]
    outer[at] = normal * (normal * outer[at]).sum(axis=1, keepdims=True)
    free = replace(free, share=freeze(free.area[:, None] * outer))
    return Lattice(
        body.particles, body.pairs, facets=replace(facets, share_i=freeze(share_i), share_j=freeze(share_j)),
        cells=replace(cells, free=free),
    )  # fmt: skip
