"""Constants of the bonds in the internal order."""

from dataclasses import dataclass, replace

import numpy as np

from bondem._core import core_lanes
from bondem._types import Floats, PerBond
from bondem.interactions.beams.bond_law import BondStiffness
from bondem.specimen.lattice import Lattice
from bondem.specimen.ordering import Layout

#: Bonds that a pass of the core takes at once.
GROUP = core_lanes()


@dataclass(frozen=True, eq=False)
class BondTable:
    """Constants of bonds, internal order.

    Attributes:
        direction: X0, from i to j in the reference [-], shape (3, m).
        length: L, or with a stress-free strain L (1 + ε*) [m], shape (m,).
        kn: normal stiffness [N/m], shape (m,).
        A, B, C: ks a² + kb - kt, ks a b - kb + kt, ks b² + kb - kt, with b = L - a [N·m], shape (m,).
        kt: twisting stiffness [N·m], shape (m,).
        ks: shear stiffness [N/m], shape (m,).
        kb: bending stiffness [N·m], shape (m,).
        lever: a, distance of the contact point from the internal element i [m], shape (m,).
        radius: bond radius [m], shape (m,).
    """

    direction: Floats
    length: PerBond
    kn: PerBond
    A: PerBond
    B: PerBond
    C: PerBond
    kt: PerBond
    ks: PerBond
    kb: PerBond
    lever: PerBond
    radius: PerBond

    @classmethod
    def of(cls, lattice: Lattice, layout: Layout, stiffness: BondStiffness) -> "BondTable":
        """Compute the constants of the bonds in internal order from stiffnesses in the user's order."""
        order, flipped = layout.bond_order, layout.flipped
        L = lattice.length[order]
        ks, kb, kt = stiffness.ks[order], stiffness.kb[order], stiffness.kt[order]
        a = np.where(flipped, L - stiffness.lever[order], stiffness.lever[order])
        b = L - a
        k = kb - kt
        return cls(
            direction=directions(lattice, layout), length=L, kn=stiffness.kn[order],
            A=ks * a * a + k, B=ks * a * b - k, C=ks * b * b + k, kt=kt, ks=ks, kb=kb, lever=a,
            radius=stiffness.radius[order],
        )  # fmt: skip

    def stretched(self, strain: PerBond) -> "BondTable":
        """Return the same bonds with rest lengths L (1 + ε*); the constants of moments are unchanged.

        Args:
            strain: ε* [-], shape (m,), or (0,) for none.
        """
        if strain.size == 0:
            return self
        stretch = 1.0 + strain
        return replace(self, length=self.length * stretch, ks=self.ks / stretch**2, lever=self.lever * stretch)

    def sheared(self, ks: PerBond) -> "BondTable":
        """Return the bonds with a shear stiffness of at least ks [N/m], (m,)."""
        more, a = np.maximum(ks - self.ks, 0.0), self.lever
        b = self.length - a
        return replace(
            self, ks=self.ks + more, A=self.A + more * a * a, B=self.B + more * a * b, C=self.C + more * b * b
        )

    def separate(self) -> "BondTable":
        """Return the table with copies of the arrays that a pass changes if strains change in time."""
        return replace(self, length=self.length.copy(), ks=self.ks.copy(), lever=self.lever.copy())

    @property
    def uniform(self) -> tuple[float, float, float, float] | None:
        """Return kn L [N], A L = C L, B L and kt L [N·m²] if all bonds share them, else None.

        Euler–Bernoulli bonds of one material and radius share them, as their stiffnesses are proportional to 1 / L.
        """
        if len(self.length) == 0:
            return None
        products = np.stack([self.kn, self.A, self.B, self.C, self.kt]) * self.length
        largest = np.abs(products).max(axis=1)
        spread = np.append(np.ptp(products, axis=1), abs(products[1] - products[3]).max())
        if (spread > _ROUNDING * np.append(largest, largest[1])).any():
            return None
        kn, A, B, _, kt = products.mean(axis=1).tolist()
        return kn, A, B, kt


def directions(lattice: Lattice, layout: Layout) -> Floats:
    """Return the directions from i to j in the reference [-], internal order, (3, m)."""
    branch, sign = lattice.branch[layout.bond_order], np.where(layout.flipped, -1.0, 1.0)
    return np.ascontiguousarray((branch / np.linalg.norm(branch, axis=1)[:, None] * sign[:, None]).T)


def with_twins(column: np.ndarray) -> np.ndarray:
    """Return a column of bonds, (m,), padded with its first entry to the number that a pass computes at once."""
    return _longer(column, column[:1])


def with_zeros(columns: np.ndarray) -> np.ndarray:
    """Return columns of bonds, (…, m), padded with zeros to the number of bonds that a pass computes at once."""
    return _longer(columns, np.zeros(1))


def keep_columns(columns: np.ndarray, filled: np.ndarray) -> None:
    """Copy the result of `with_zeros` back to its columns, (k, m), unless it is the same array."""
    if filled is not columns:
        columns[:] = filled[:, : columns.shape[1]]


def _longer(columns: np.ndarray, value: np.ndarray) -> np.ndarray:
    m = columns.shape[-1]
    if m == 0 or m >= GROUP:
        return columns
    more = np.broadcast_to(value.astype(columns.dtype), (*columns.shape[:-1], GROUP - m))
    return np.concatenate([columns, more], axis=-1)


# Relative difference by rounding between products of constants and length that count as equal.
_ROUNDING = 1e-14
