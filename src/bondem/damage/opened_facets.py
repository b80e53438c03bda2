"""Opening of facets along each of the directions by which they soften (`core/laws/softening.hpp`)."""

from dataclasses import dataclass

import numpy as np

from bondem._types import Floats, Ints, PerBond, PerBond3
from bondem.damage.cohesive_softening import LEAST_SLOPE, SNAP
from bondem.damage.softening_table import SofteningTable


@dataclass(frozen=True, eq=False)
class Opened:
    """Tractions and strengths of some facets at a load factor of 1, along principal directions or their own traction.

    Attributes:
        traction: T_a that opens them along a direction, as if they were whole [Pa], (c, 3).
        strength: strength along it, at which they begin to soften [Pa], (c, 3).
        last: T_a at zero integrity [Pa], (c, 3).
        direction: these directions [-], (c, 3, 3), by columns; of facets of material planes without meaning.
        kink, steep: parameters of the softening curve (`core/laws/softening.hpp`) [-].
        gone: load factors at which facets that have begun to soften reach zero integrity in any direction, (c,).
    """

    traction: PerBond3
    strength: PerBond3
    last: PerBond3
    direction: Floats
    kink: float
    steep: float
    gone: PerBond

    @classmethod
    def of(
        cls, table: SofteningTable, facets: Ints, normal: PerBond3, traction: PerBond3, bent: PerBond, mean: Floats
    ) -> "Opened":
        """Evaluate some facets.

        Args:
            table: strengths and softening curve.
            facets: facets to evaluate, (c,).
            normal: normals of these, (c, 3).
            traction: traction that they would have if they were whole [Pa], (c, 3).
            bent: T_b, likewise [Pa], (c,).
            mean: mean stress of their cells [Pa], (c, 3, 3).
        """
        stress, direction = np.linalg.eigh(mean)
        open_bent = np.maximum(bent - np.maximum(-stress[:, 0], 0.0), 0.0)
        slope = np.einsum("cd,cda->ca", normal, direction)
        pull = np.einsum("cd,cda->ca", traction, direction)
        pull = np.where(stress > 0.0, np.abs(pull), pull * np.where(slope >= 0.0, 1.0, -1.0))
        pull, size = np.maximum(pull, 0.0), np.abs(slope)
        bend = open_bent[:, None] * size / size.max(axis=1, keepdims=True)
        opened, both = np.hypot(pull, bend), pull + bend
        share = np.divide(opened, both, out=np.ones_like(both), where=both > 0.0)
        strength = table.strength[facets, None] * np.maximum(size, LEAST_SLOPE) * share
        last = table.last[facets, None] / share
        own = np.flatnonzero(table.plane[facets])
        if len(own):
            opened[own], strength[own, 0], last[own, 0] = 0.0, table.strength[facets[own]], table.last[facets[own]]
            across = (traction[own] * normal[own]).sum(axis=1)
            square = np.maximum((traction[own] ** 2).sum(axis=1) - across**2, 0.0)
            part = np.maximum(across, 0.0) ** 2 + np.maximum(bent[own] + np.minimum(across, 0.0), 0.0) ** 2
            opened[own, 0] = np.sqrt(part)
            share = np.divide(part, part + square, out=np.ones(len(own)), where=part > 0.0)
            end = np.maximum(share * last[own, 0], SNAP * strength[own, 0] / table.steep)
            last[own, 0] = np.where(last[own, 0] > 0.0, end, 0.0)
        across = np.minimum((traction * normal).sum(axis=1, keepdims=True), 0.0)
        size = np.linalg.norm(traction - across * normal, axis=1)
        ends = (size > 0.0) & ~table.plane[facets] & (table.last[facets] > 0.0)
        gone = np.divide(table.last[facets], size, out=np.full(len(size), np.inf), where=ends)
        return cls(opened, strength, last, direction, table.kink, table.steep, gone)

    def reached(self, integrity: PerBond) -> PerBond:
        """Return load factors at which the facets lose integrity below the given values, inf for never, (c,)."""
        reached = self._reached_along(integrity).min(axis=1)
        return np.where(integrity < 1.0, np.minimum(reached, self.gone), reached)

    def softens_along(self, integrity: PerBond) -> PerBond3:
        """Return the direction along which facets of given integrities soften first, (c, 3)."""
        first = self._reached_along(integrity).argmin(axis=1)
        return self.direction[np.arange(len(first)), :, first]

    def _reached_along(self, integrity: PerBond) -> PerBond3:
        s = integrity[:, None]
        with np.errstate(divide="ignore", invalid="ignore"):
            first = np.where(self.last > 0.0, self.strength / (self.steep * self.last), 0.0)
            least = self.strength / (s * (1.0 - first) + first)
            if self.kink > 0.0:
                left = self.last * (1.0 - (1.0 - self.kink) * self.steep)
                slope = np.where(self.last > 0.0, self.kink * self.strength / left, 0.0)
                least = np.maximum(least, slope * self.last / (s * (1.0 - slope) + slope))
            return np.where(self.traction > 0.0, least / self.traction, np.inf)

    def steepest(self) -> Ints:
        """Return the direction along which whole facets begin to soften first, (c,)."""
        with np.errstate(divide="ignore"):
            return np.where(self.traction > 0.0, self.strength / self.traction, np.inf).argmin(axis=1)
