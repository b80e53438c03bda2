"""Outlines of cracks in successive states of the same body, for files to which states are appended."""

from dataclasses import dataclass
from functools import cache, partial

import numpy as np

from bondem._types import Floats, Ints
from bondem.fracture.crack_faces import faces_of
from bondem.fracture.crack_polygons import crack_polygons
from bondem.model.state import State
from bondem.specimen.lattice import Lattice
from bondem.specimen.tessellation.polyhedra import polyhedra


@dataclass(frozen=True, eq=False)
class CrackOutlines:
    """Polygons of the facets and beams that have lost integrity.

    Attributes:
        vertex: corners, half-way between both faces [m], (v, 3).
        start: corners of polygon q are start[q] … start[q + 1] - 1, (p + 1,).
        fields: fields of the polygons: facet, integrity, area [m²], opening, sliding [m], (p,) each.
    """

    vertex: Floats
    start: Ints
    fields: dict[str, np.ndarray]


class GrowingCracks:
    """Callable that returns the crack outlines of a state; it cuts the cells into polygons only once.

    Args:
        lattice: lattice of the model.
    """

    def __init__(self, lattice: Lattice) -> None:
        self._lattice = lattice
        self._solid = cache(partial(polyhedra, lattice))

    def __call__(self, state: State) -> CrackOutlines:
        """Return the outlines of all facets and beams with an integrity below 1."""
        whole = state.bond_integrity
        chosen = np.flatnonzero(whole < 1.0)
        faces = faces_of(self._lattice, state, chosen)
        found = crack_polygons(self._lattice, state, chosen, faces, self._solid)
        row = found.facet
        fields = {
            "facet": chosen[row], "integrity": whole[chosen][row], "area": faces.area[row],
            "opening": faces.opening[row], "sliding": faces.sliding[row],
        }  # fmt: skip
        return CrackOutlines(found.vertex, found.start, fields)
