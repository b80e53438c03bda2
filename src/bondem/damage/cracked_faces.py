"""Faces of cracked material planes by which cells touch (`core/passes/contacts/face_contacts.hpp`)."""

import numpy as np

from bondem._cache_lines import exact_sums
from bondem._indices import group_starts
from bondem._tables.columns import CrackStatus
from bondem._tables.contact_tables import ContactPairs, FacePairs
from bondem._types import Floats, PerElement
from bondem.damage.crack_columns import FACET, STATUS
from bondem.damage.damage_part import CrackJoints
from bondem.damage.failing_state import FailingState


class CrackedFaces:
    """Faces of cells on material planes, which may touch other faces once their facet has parted.

    Args:
        joints: cracked facets of the run.
        state: state of the run.

    Attributes:
        outer: reach of the faces of each cell [m], (n,): two cells can touch by faces only if the distance of their
            centres is less than the sum of both.
    """

    def __init__(self, joints: CrackJoints, state: FailingState) -> None:
        facets, n = joints.facets, len(state.pose)
        planes = joints.strengths.planes
        self._joints = joints
        self._open, self._faced = np.zeros(len(facets.k), dtype=np.uint8), np.zeros(n, dtype=np.uint8)
        parted = state.cracks[state.cracks[:, STATUS] == CrackStatus.PARTED, FACET].astype(np.int64)
        parted = np.intersect1d(parted, planes)
        self._open[parted] = 1
        self._faced[facets.i[parted]] = self._faced[facets.j[parted]] = 1
        # Centroids of faces that overlap are within R of each other, R² = 3 (A_a + A_b) / 2π, and √(x + y) ≤ √x + √y:
        # each cell reaches as far as its own part of this way, along its face from the foot of its centre.
        normal, beside = facets.normal[:, planes], np.sqrt(1.5 / np.pi * joints.strengths.area[planes])
        self.outer: PerElement = np.zeros(n)
        for cell, lever in ((facets.i, facets.lever_i), (facets.j, facets.lever_j)):
            arm = facets.pitch[:, None] * lever[:, planes]
            ahead = (arm * normal).sum(axis=0)
            along = np.sqrt(((arm - ahead * normal) ** 2).sum(axis=0))
            np.maximum.at(self.outer, cell[planes], np.hypot(ahead, along + beside))

    def pairs(self, pairs: ContactPairs, chosen: Floats, portions: int) -> FacePairs:
        """Return the table of contact by faces for a list of pairs.

        Args:
            pairs: pairs of cells that may touch.
            chosen: code of the faces by which each pair touches, a column of `State.stretch`, (c,).
            portions: number of groups of ELEMENTS_OF_PORTION elements.
        """
        facets, strengths, c = self._joints.facets, self._joints.strengths, len(chosen)
        return FacePairs(
            *self._joints.of_cells, facets.lever_i, facets.lever_j, facets.pitch, facets.normal, facets.j, facets.k,
            strengths.area, self._joints.cracks.listed, strengths.plane, self._open, self._faced, self.outer,
            group_starts(pairs.first, len(self._faced)),
            np.argsort(pairs.first, kind="stable").astype(np.uint32), chosen,
            np.zeros(c, dtype=np.uint32), np.zeros((c, 12)), np.zeros(c), exact_sums(),
            np.zeros(portions, dtype=np.int64),
        )  # fmt: skip
