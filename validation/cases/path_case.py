"""A test whose crack chooses its path: what is run, what is read of it, and what is known of it."""

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

import bondem as bd
from bondem._types import Floats, PerBond
from validation.cases.case import Claim

#: A facet that has lost this share of its integrity belongs to the crack.
LOST = 0.5


@dataclass(frozen=True, eq=False)
class Outcome:
    """Result of a run.

    Attributes:
        body: the cells.
        integrity: remaining integrity of the facets, user's order [-], (m,).
        values: measured quantities by name, in SI units; claims name some of them.
        curve: displacement [m] and load [N], (k, 2).
    """

    body: bd.Lattice
    integrity: PerBond
    values: Mapping[str, float]
    curve: Floats


@dataclass(frozen=True)
class PathCase(ABC):
    """A test in plane geometry, the same along z.

    Attributes:
        name: name of the case in commands.
        title: title in tables and figures.
        claims: what is known, a quantity each.
        window: part of the body that a figure shows, x and y from, to [m].
        finer: how many times smaller cells are than stated in the case.
    """

    name: str
    title: str
    claims: tuple[Claim, ...] = ()
    window: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
    finer: float = field(default=1.0, kw_only=True)

    @property
    @abstractmethod
    def shape(self) -> bd.Shape:
        """The body."""

    @property
    @abstractmethod
    def size(self) -> float | bd.Graded:
        """Size of the cells [m]."""

    def packed(self, seed: int) -> bd.Particles:
        """Centres of the cells."""
        return bd.pack(self.shape, size=self.size, method="even", seed=seed)

    def body(self, seed: int) -> bd.Lattice:
        """The cells of a packing."""
        return bd.connect(self.packed(seed), method="laguerre")

    @abstractmethod
    def run(self, seed: int) -> Outcome:
        """Carry out the test on one packing."""


def cracked(body: bd.Lattice, integrity: PerBond) -> tuple[Floats, Floats]:
    """Return the centroids [m], (k, 3), and areas [m²], (k,), of the facets that belong to the crack."""
    assert body.facets is not None
    lost = np.flatnonzero(integrity < 1.0 - LOST)
    return body.facets.centroid[lost], body.facets.area[lost]
