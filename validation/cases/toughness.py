"""Cracked plates whose stress intensity is known: the load at which they break against K_Ic = √(E' G_f).

A plate wide enough against the process zone breaks at K = K_Ic; a smaller one earlier. Of a crack whose softening is
a straight line the process zone acts as Δa = 0.419 l, l = E' G_f / f_t², as it becomes short against the plate
(Planas and Elices 1991), so that K at the peak, with the length of the notch, is

    K / K_Ic = k(α) / k(α + Δa / W),    K = σ √W k(α), α = a / W, for the same load

Fixed before any run: plane strain between two smooth walls four cells apart; cells of 0.2 l about the tip, 0.4 l to
both sides and 1.6 l ahead of it, growing by 0.3 of the distance to 1.6 l; a slot one cell wide as the notch, α = 0.5;
a straight line; E = 40 GPa, ν = 0.2, f_t = 4 MPa, G_f = 20 J/m², of which only l counts; widths W of 8, 16 and 32 l
of half the plate with a crack in its middle, of 16, 24 and 32 l of compact specimens, for which the equation above
gives 0.91, 0.95, 0.98 and 0.92, 0.95, 0.96.

Changed after a first round of both packings, with widths of compact specimens of 16, 32 and 64 l and runs to 0.8 of
the peak: the largest were refused, as their coarse cells were longer than 2 E G_f / f_t²; and the crack of the
largest plate with a central one had run 4 l by the end, out of its fine cells into coarse ones, where it bore K =
1.08 and 1.13 K_Ic, after 1.02 and 1.01 at the notch. Runs end at 0.9 of the peak now.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

import bondem as bd
from validation.cases.spared import SparedRankine

#: E [Pa], ν, f_t [Pa] and G_f [J/m²]: only l of them counts.
E, NU, TENSION, ENERGY, RHO = 40e9, 0.2, 4e6, 20.0, 2400.0
#: E' = E / (1 - ν²) [Pa], K_Ic [Pa √m], and l [m].
PLANE = E / (1.0 - NU**2)
TOUGHNESS = float(np.sqrt(PLANE * ENERGY))
LENGTH = PLANE * ENERGY / TENSION**2
#: Length of a crack by which a process zone acts, over l, of a straight line of softening.
LONGER = 0.419
# Thickness over the size of cells at the tip; over l the size of cells far from it, and where they are fine: beside
# the tip, and ahead.
_THICK, _COARSE, _BESIDE, _AHEAD = 4.0, 1.6, 0.4, 1.6
# a / W, and the load at a factor of 1 [N]: nothing depends on it.
_ALPHA, _LOAD = 0.5, 1e3


@dataclass(frozen=True)
class Cracked(ABC):
    """A plate with a notch along x that ends at x = a, y = 0.

    Attributes:
        over: its width W over l.
        cells: size of the cells at the tip over l.
    """

    over: float
    cells: float = 0.2

    @property
    @abstractmethod
    def name(self) -> str:
        """Of files and tables."""

    @property
    @abstractmethod
    def plate(self) -> bd.Shape:
        """The plate without its notch, at its place."""

    @abstractmethod
    def k(self, alpha: float) -> float:
        """K B √W / P, with P the load and B the thickness."""

    @abstractmethod
    def ends(self, body: bd.Lattice) -> tuple[list[bd.BoundaryCondition], bd.Region]:
        """What loads it, and which region to read."""

    @property
    def spared(self) -> tuple[tuple[float, float, float], ...]:
        """Lines about which nothing fails, and how far [m]."""
        return ()

    @property
    def width(self) -> float:
        """W [m]."""
        return self.over * LENGTH

    @property
    def thickness(self) -> float:
        """B [m]."""
        return _THICK * self.cells * LENGTH

    @property
    def shape(self) -> bd.Shape:
        """The plate with its notch."""
        return self.notched(_ALPHA * self.width, self.cells * LENGTH)

    def notched(self, tip: float, wide: float) -> bd.Shape:
        """The plate with a slot of some width that ends at x = tip [m]."""
        lower, _ = self.plate.bounds
        slot = bd.Box((tip - lower[0] + wide, wide, 3.0 * self.thickness))
        return self.plate.cut(slot.moved((lower[0] - wide, -0.5 * wide, -self.thickness)), name="notch")

    @property
    def about(self) -> bd.Shape:
        """Where cells are fine."""
        tip = _ALPHA * self.width
        place = bd.Box(((_BESIDE + _AHEAD) * LENGTH, 2.0 * _BESIDE * LENGTH, self.thickness))
        return place.moved((tip - _BESIDE * LENGTH, -_BESIDE * LENGTH, 0.0))

    def body(self, seed: int) -> bd.Lattice:
        """Its cells."""
        size = bd.Graded(fine=self.cells * LENGTH, coarse=_COARSE * LENGTH, about=self.about, growth=0.3)
        return bd.connect(bd.pack(self.shape, size=size, method="even", seed=seed), method="laguerre")

    def model(self, body: bd.Lattice) -> tuple[bd.Model, bd.Region]:
        """The test on a body, and the region whose load is read."""
        loads, read = self.ends(body)
        walls = [bd.Fix(bd.Face(name), translation="z", rotation="") for name in ("z_min", "z_max")]
        failure = SparedRankine(tension=TENSION, fracture_energy=ENERGY, lines=self.spared)
        return bd.Model(body, bd.CellBond(E=E, nu=NU), RHO, failure=failure, boundary=[*walls, *loads]), read

    def intensity(self, load: float) -> float:
        """K over K_Ic at a load [N]."""
        return load * self.k(_ALPHA) / (self.thickness * np.sqrt(self.width) * TOUGHNESS)

    @property
    def expected(self) -> float:
        """K over K_Ic at the peak, of a crack longer by 0.419 l."""
        return self.k(_ALPHA) / self.k(_ALPHA + LONGER / self.over)


@dataclass(frozen=True)
class CentreCrack(Cracked):
    """A plate 2 W wide and 4 W high with a crack 2 a in its middle, pulled at its ends; the right half of it.

    K = σ √(π a) (1 - 0.025 α² + 0.06 α⁴) √sec(π α / 2), to 0.1 % for plates of any height above 2 W (Tada, Paris and
    Irwin, The stress analysis of cracks handbook, after Isida 1971 and Feddersen).
    """

    @property
    def name(self) -> str:
        return "centre crack"

    @property
    def plate(self) -> bd.Shape:
        """See `Cracked`; x = 0 is the plane of symmetry."""
        return bd.Box((self.width, 4.0 * self.width, self.thickness)).moved((0.0, -2.0 * self.width, 0.0))

    def k(self, alpha: float) -> float:
        """See `Cracked`; P is the load on the half, σ B W."""
        about = 1.0 - 0.025 * alpha**2 + 0.06 * alpha**4
        return float(np.sqrt(np.pi * alpha / np.cos(0.5 * np.pi * alpha)) * about)

    def ends(self, body: bd.Lattice) -> tuple[list[bd.BoundaryCondition], bd.Region]:
        tension = -_LOAD / (self.thickness * self.width)
        top = bd.Face("y_max")
        middle = bd.Fix(bd.Face("x_min"), translation="x", rotation="")
        return [middle, bd.Pressure(top, tension), bd.Pressure(bd.Face("y_min"), tension)], top


@dataclass(frozen=True)
class CompactTension(Cracked):
    """The compact specimen of ASTM E399, 1.25 W long and 1.2 W high, x from the line of its load.

    Its pins, 0.25 W thick and 0.275 W above and below the notch, are material here, pulled by a force on their cells
    through their axes, and do not fail.

    K = P / (B √W) (2 + α) (0.886 + 4.64 α - 13.32 α² + 14.72 α³ - 5.6 α⁴) / (1 - α)^(3/2) (E399, after Srawley 1976).
    """

    @property
    def name(self) -> str:
        return "compact tension"

    @property
    def plate(self) -> bd.Shape:
        size = bd.Box((1.25 * self.width, 1.2 * self.width, self.thickness))
        return size.moved((-0.25 * self.width, -0.6 * self.width, 0.0))

    def k(self, alpha: float) -> float:
        sum_ = 0.886 + 4.64 * alpha - 13.32 * alpha**2 + 14.72 * alpha**3 - 5.6 * alpha**4
        return float((2.0 + alpha) * sum_ / (1.0 - alpha) ** 1.5)

    def ends(self, body: bd.Lattice) -> tuple[list[bd.BoundaryCondition], bd.Region]:
        pins = {way: self._pin(body, way) for way in (1, -1)}
        loads: list[bd.BoundaryCondition] = []
        for way, pin in pins.items():
            off = np.array([0.0, way * 0.275 * self.width, 0.5 * self.thickness]) - pin.anchor(body)
            force = (0.0, way * _LOAD, 0.0)
            loads.append(bd.Load(pin, force=force, moment=(-off[2] * force[1], 0.0, off[0] * force[1])))
        return loads, pins[1]

    @property
    def spared(self) -> tuple[tuple[float, float, float], ...]:
        """See `Cracked`: twice the radius of the pins."""
        return tuple((0.0, way * 0.275 * self.width, 0.25 * self.width) for way in (1, -1))

    def _pin(self, body: bd.Lattice, way: int) -> bd.Index:
        away = body.centre[:, :2] - [0.0, way * 0.275 * self.width]
        return bd.Index(np.flatnonzero(np.hypot(*away.T) < 0.125 * self.width))


#: Kinds of plates, and their widths W over l.
PLATES: dict[str, tuple[type[Cracked], tuple[float, ...]]] = {
    "centre crack": (CentreCrack, (8.0, 16.0, 32.0)),
    "compact tension": (CompactTension, (16.0, 24.0, 32.0)),
}
