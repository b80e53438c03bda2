"""Constants of the bonds in the kernels' order and form."""

from dataclasses import dataclass, replace

import numpy as np

from bondem._core import core_lanes
from bondem._types import Floats, PerBond
from bondem.kernels.lanes import WIDTH
from bondem.kernels.tables import Alike, Bonds
from bondem.laws.bond import BondStiffness
from bondem.model.layout import Layout
from bondem.specimen.lattice import Lattice

#: Bonds that a loop takes at once, at most: of Numba's loops and of the core.
GROUP = max(WIDTH, core_lanes())


@dataclass(frozen=True, eq=False)
class BondTable:
    """Constants read by the bond pass, internal order.

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
        """Reorder a law's stiffnesses and form the constants of the energy."""
        order, flipped = layout.bond_order, layout.flipped
        L = lattice.length[order]
        direction = lattice.branch[order] / L[:, None] * np.where(flipped, -1.0, 1.0)[:, None]
        ks, kb, kt = stiffness.ks[order], stiffness.kb[order], stiffness.kt[order]
        a = np.where(flipped, L - stiffness.lever[order], stiffness.lever[order])
        b = L - a
        k = kb - kt
        return cls(
            direction=np.ascontiguousarray(direction.T),
            length=L,
            kn=stiffness.kn[order],
            A=ks * a * a + k,
            B=ks * a * b - k,
            C=ks * b * b + k,
            kt=kt,
            ks=ks,
            kb=kb,
            lever=a,
            radius=stiffness.radius[order],
        )

    def stretched(self, strain: PerBond) -> "BondTable":
        """Return the same bonds with rest lengths L (1 + ε*); the constants of moments are unchanged.

        Args:
            strain: ε* [-], shape (m,), or (0,) for none.
        """
        if strain.size == 0:
            return self
        stretch = 1.0 + strain
        return replace(
            self, length=self.length * stretch, ks=self.ks / stretch**2, lever=self.lever * stretch
        )

    def sheared(self, ks: PerBond) -> "BondTable":
        """Return the same bonds with at least the shear stiffness ks [N/m], (m,)."""
        more, a = np.maximum(ks - self.ks, 0.0), self.lever
        b = self.length - a
        return replace(
            self, ks=self.ks + more, A=self.A + more * a * a, B=self.B + more * a * b, C=self.C + more * b * b
        )

    def separate(self) -> "BondTable":
        """Return the table with copies of the arrays that a kernel changes if strains change in time."""
        return replace(self, length=self.length.copy(), ks=self.ks.copy(), lever=self.lever.copy())

    @property
    def alike(self) -> Alike | None:
        """Return kn L, A L = C L, B L and kt L if all bonds share them, else None.

        They do for Euler–Bernoulli bonds of one material and radius, whose stiffnesses are proportional to 1 / L.
        """
        if len(self.length) == 0:
            return None
        products = np.stack([self.kn, self.A, self.B, self.C, self.kt]) * self.length
        largest = np.abs(products).max(axis=1)
        spread = np.append(np.ptp(products, axis=1), abs(products[1] - products[3]).max())
        if (spread > _ROUNDING * np.append(largest, largest[1])).any():
            return None
        kn, A, B, _, kt = products.mean(axis=1).tolist()
        return Alike(kn, A, B, kt)

    def rows(
        self,
        layout: Layout,
        period: Floats,
        integrity: PerBond,
        *,
        alike: bool = False,
    ) -> Bonds:
        """Return the bonds in the kernels' form.

        Fewer than WIDTH bonds are followed by copies of the first one that carry no force, so that a loop may read
        WIDTH at once.

        Args:
            layout: ends of the bonds.
            period: edges of the periodic cell and their inverses, (6,).
            integrity: integrity of the bonds, (m,).
            alike: True if the kernel will read the force over the length only.
        """
        m = len(layout.i)
        X0, Y0, Z0 = self.direction
        hold = integrity / self.length if alike else np.zeros(0)
        return Bonds(
            m=m, i=with_twins(layout.i), j=with_twins(layout.j),
            X0=with_twins(X0), Y0=with_twins(Y0), Z0=with_twins(Z0), length=with_twins(self.length),
            kn=with_zeros(self.kn), A=with_zeros(self.A), B=with_zeros(self.B), C=with_zeros(self.C),
            kt=with_zeros(self.kt), ks=with_zeros(self.ks), kb=with_zeros(self.kb), lever=with_zeros(self.lever),
            integrity=with_zeros(integrity), hold=with_zeros(hold), period=period,
        )  # fmt: skip


def with_twins(column: np.ndarray) -> np.ndarray:
    """Return a column of bonds (m,), padded with copies of the first one to WIDTH."""
    return _longer(column, column[:1])


def with_zeros(columns: np.ndarray) -> np.ndarray:
    """Return columns of bonds (…, m), padded with zeros to WIDTH."""
    return _longer(columns, np.zeros(1))


def _longer(columns: np.ndarray, value: np.ndarray) -> np.ndarray:
    m = columns.shape[-1]
    if m == 0 or m >= GROUP:
        return columns
    more = np.broadcast_to(value.astype(columns.dtype), (*columns.shape[:-1], GROUP - m))
    return np.concatenate([columns, more], axis=-1)


# Rounding that products of constants and length may differ by.
_ROUNDING = 1e-14
