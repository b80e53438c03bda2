"""Parameters of failure of bodies of cells: cracks of facets, and cells that yield."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.special import ndtri

from bondem._checks import instance, number
from bondem._plausibility import physical
from bondem._types import Floats, Mask
from bondem.damage.bilinear import Bilinear
from bondem.damage.counter_random import uniform_by_counter
from bondem.damage.stress_passes import StressPasses
from bondem.errors import InputError

# Least last opening u of a facet that is too long for its fracture energy, as k u / A over its strength.
SNAP = 1.05
# Largest strength of interest [Pa], and number of random directions of stress in which strengths are computed.
_STRONGEST = 1e15
_DIRECTIONS = 200
_EYE = np.eye(3)
#: Trial stresses of size about 1 for a criterion: along x, y and z, hydrostatic, in a plane, in shear, and general.
TRIED = np.array([
    *(np.outer(e, e) for e in _EYE), _EYE, _EYE - np.outer(_EYE[2], _EYE[2]),
    [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 0.0]],
    [[0.7, -0.2, 0.4], [-0.2, -0.5, 0.1], [0.4, 0.1, 0.3]],
])  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Slip:
    """Yielding of cells in shear (`core/laws/plasticity.hpp`), by Mohr–Coulomb or on Drucker–Prager's cone.

    Attributes:
        cone: True for the cone.
        cohesion: c, or k of the cone [Pa], which decreases with slip.
        strength: c cos φ, or k [Pa].
        slope: sin φ, or α [-].
        dilation: sin ψ, or β [-].
        fracture_energy: G_II, which slip dissipates until the cohesion is zero [J/m²]; inf for a constant cohesion.
        width: width of shear bands [m], or None for that of four cells (`damage/shear_bands.py`).
    """

    cone: bool
    cohesion: float
    strength: float
    slope: float
    dilation: float
    fracture_energy: float
    width: float | None = None

    def compressive(self, pressure: float = 0.0) -> float:
        """Return the strength of a continuum along one axis under a pressure on its sides [Pa].

        It is (2 c cos φ + p (1 + sin φ)) / (1 - sin φ), or (k + p (1/√3 + 2 α)) / (1/√3 - α).
        """
        if self.cone:
            third = 1.0 / math.sqrt(3.0)
            return (self.strength + pressure * (third + 2.0 * self.slope)) / (third - self.slope)
        return (2.0 * self.strength + pressure * (1.0 + self.slope)) / (1.0 - self.slope)


@dataclass(frozen=True, kw_only=True)
class StressIndex:
    """A criterion that is a function of the stress tensor, reached where its index is 1.

    Attributes:
        function: function of stresses (k, 3, 3) [Pa], tension positive, and of the values, that returns k indices;
            the address of a C function (`bd.StressCriterion`); or the name of a criterion of the core.
        values: parameters of the criterion, in order.
    """

    function: Callable[..., Any] | int | str
    values: tuple[float, ...]

    def indices(self, stress: Floats) -> Floats:
        """Return the indices of stresses (k, 3, 3) [Pa], (k,)."""
        if isinstance(self.function, int | str):
            return self.passes.indices(stress)
        with np.errstate(all="ignore"):
            return np.asarray(self.function(stress, *self.values), dtype=float)

    @property
    def passes(self) -> StressPasses:
        """Passes of the core that evaluate the criterion."""
        return StressPasses.of(self.function, self.values)

    def reached(self, directions: Floats) -> Floats:
        """Return the factors [-] that bring stresses (d, 3, 3) [Pa] to the criterion, (d,), within a share of 1e-6.

        A factor is inf if it would be above 10^15.
        """
        count = len(directions)
        low, high = np.zeros(count), np.ones(count)
        never = np.zeros(count, dtype=bool)
        growing = np.arange(count)
        while len(growing):
            growing = growing[self._below(high[growing], directions[growing])]
            high[growing] *= 2.0
            never[growing] = high[growing] > _STRONGEST
            growing = growing[~never[growing]]
        low = np.where(high > 1.0, 0.5 * high, 0.0)
        while True:
            near = np.flatnonzero((high - low > 1e-6 * high) & (high > 1.0 / _STRONGEST) & ~never)
            if not len(near):
                break
            middle = 0.5 * (low[near] + high[near])
            there = self.indices(middle[:, None, None] * directions[near]) >= 1.0
            high[near[there]], low[near[~there]] = middle[there], middle[~there]
        return np.where(never, np.inf, high)

    def _below(self, factors: Floats, directions: Floats) -> Mask:
        return self.indices(factors[:, None, None] * directions) < 1.0

    def nearest(self) -> float:
        """Return the least size √(σ:σ) of a stress that reaches the criterion, over about 200 directions [Pa]."""
        drawn = ndtri(uniform_by_counter(0, 9 * _DIRECTIONS)).reshape(-1, 3, 3)
        tried = np.concatenate([TRIED, -TRIED, drawn + drawn.transpose(0, 2, 1)])
        size = np.array([np.linalg.norm(matrix) for matrix in tried])
        return float(self.reached(tried / size[:, None, None]).min())


@dataclass(frozen=True, kw_only=True)
class Softening:
    """Cracking of facets in tension, and yielding of cells.

    Attributes:
        tension: f_t, the strength in uniaxial tension [Pa].
        fracture_energy: G_f of tension [J/m²]; 0 for brittle facets.
        friction: μ on the faces of closed cracks [-].
        slips: yielding of cells, none or one.
        surface: criterion of crack initiation; None if that is the largest principal stress at `tension`.
        curve: softening curve over the opening; None for a straight line.
    """

    tension: float
    fracture_energy: float
    friction: float
    slips: tuple[Slip, ...]
    surface: StressIndex | None = None
    curve: Bilinear | None = None

    @property
    def kink(self) -> float:
        """Stress over `tension` at the kink of the curve [-], 0 for a straight line."""
        return 0.0 if self.curve is None else self.curve.stress

    @property
    def steep(self) -> float:
        """Opening where the first line of the curve would reach zero, over the last opening [-]."""
        return 1.0 if self.curve is None else self.curve.steep

    @property
    def last(self) -> float:
        """Opening of a crack at zero stress, over G_f / f_t [-]."""
        return 2.0 if self.curve is None else self.curve.last


def check_crack(owner: str, fracture_energy: float | None, friction: float, curve: Bilinear | None = None) -> None:
    """Check G_f [J/m²], μ [-] and the softening curve of cracks, for a criterion named `owner`.

    Raises:
        InputError: The energy is not positive, the friction is negative, or a curve is given without an energy.
    """
    if curve is not None:
        instance(owner, "curve", curve, Bilinear, "bd.Bilinear(), or None for a straight line")
        if fracture_energy is None:
            raise InputError(f"{owner}: curve applies to facets that soften; give fracture_energy too")
    if fracture_energy is not None:
        advice = "a positive energy in J/m², or None for brittle facets"
        physical(owner, "fracture_energy", fracture_energy, advice=advice)
    number(owner, "friction", friction, least=0.0, advice="a coefficient of zero or more")


def check_energies(owner: str, fracture_energy: float | None, shear: float | None) -> None:
    """Check G_f and G_II [J/m²] of softening beams, for a criterion named `owner`.

    Raises:
        InputError: An energy is not positive, or that of shear is given without that of tension.
    """
    if fracture_energy is not None:
        advice = "a positive energy in J/m², or None for bonds that break at once"
        physical(owner, "fracture_energy", fracture_energy, advice=advice)
    if shear is not None:
        if fracture_energy is None:
            raise InputError(f"{owner}: fracture_energy_shear applies to bonds that soften; give fracture_energy too")
        advice = "a positive energy in J/m², or None for 10 G_f"
        physical(owner, "fracture_energy_shear", shear, advice=advice)


def check_slip(
    owner: str, fracture_energy: float | None, shear: float | None, dilatancy: float, width: float | None
) -> None:
    """Check G_II [J/m²] (inf for a constant cohesion), dilatancy [rad or -] and band width [m] of yielding cells.

    Raises:
        InputError: The energy or the width is not positive, or one of the three is given without G_f of tension.
    """
    if fracture_energy is None and (shear is not None or dilatancy != 0.0 or width is not None):
        raise InputError(
            f"{owner}: fracture_energy_shear, dilatancy and band_width apply to cells that yield; give"
            " fracture_energy too"
        )
    if width is not None:
        number(owner, "band_width", width, unit="m", above=0.0, advice="a width in m, or None for that of four cells")
    if shear is not None and not (isinstance(shear, float) and shear == math.inf):
        physical(owner, "fracture_energy_shear", shear)
