"""Beam theory of a straight bar, clamped at x = 0 and free at x = length."""

import math
from dataclasses import dataclass, replace

import numpy as np
from scipy.linalg import expm
from scipy.optimize import brentq

from bondem._types import Floats
from bondem.errors import InputError
from bondem.geometry.elementary_shapes import BoundingBox, Box, Cylinder, Shape

# First root of cos β cosh β = -1: the cantilever's first bending mode.
_BETA_1 = 1.8751040687119611


@dataclass(frozen=True)
class CrossSection:
    """Cross-section normal to x.

    Attributes:
        area: area S [m²].
        second_moment: second moment I for bending along y, ∫ y² dS [m⁴].
        torsion_constant: Saint-Venant's J for torsion [m⁴]; the polar moment for a circle.
        rotary_moment: I for the rotary inertia in bending [m⁴].
        polar_moment: ∫ (y² + z²) dS for the inertia in torsion [m⁴].
        circular: True for a circle, which has its own shear coefficient.
    """

    area: float
    second_moment: float
    torsion_constant: float
    rotary_moment: float
    polar_moment: float
    circular: bool

    @classmethod
    def of(cls, shape: Shape) -> "CrossSection":
        """Compute the cross-section of a circular or rectangular bar along x.

        Raises:
            InputError: the shape is neither a Cylinder nor a Box.
        """
        match shape:
            case Cylinder():
                I = 0.25 * math.pi * shape.radius**4
                return cls(shape.section(), I, 2.0 * I, I, 2.0 * I, True)
            case Box() | BoundingBox():
                lower, upper = shape.bounds
                _, b, c = upper - lower
                area = shape.section()
                polar = area * (b * b + c * c) / 12.0
                I = c * b**3 / 12.0
                return cls(area, I, _torsion_of_rectangle(b, c), I, polar, False)
            case _:
                raise InputError(f"a {type(shape).__name__} is not a bar along x; test a Cylinder or a Box")

    def filled(self, stiffness: Floats, mass: Floats) -> "CrossSection":
        """Return a cross-section of equal area whose second moments are those of nonuniform stiffness and mass.

        Args:
            stiffness: ⟨y²⟩ and ⟨z²⟩, weighted with the axial force in tension [m²], (2,). The shear stiffness is
                assumed to have the same distribution.
            mass: ⟨y²⟩ and ⟨z²⟩, weighted with the mass [m²], (2,).
        """
        return replace(
            self,
            second_moment=self.area * float(stiffness[0]),
            torsion_constant=self.torsion_constant * self.area * float(stiffness.sum()) / self.polar_moment,
            rotary_moment=self.area * float(mass[0]),
            polar_moment=self.area * float(mass.sum()),
        )

    def shear_coefficient(self, nu: float) -> float:
        """Return the shear coefficient k of Timoshenko's beam for Poisson's ratio ν, after Cowper (1966) [-]."""
        if self.circular:
            return 6.0 * (1.0 + nu) / (7.0 + 6.0 * nu)
        return 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu)


def _torsion_of_rectangle(b: float, c: float) -> float:
    """Compute the torsion constant J of a b × c rectangle [m⁴] by Saint-Venant's series, with terms ∝ n⁻⁵."""
    long, short = max(b, c), min(b, c)
    n = np.arange(1, 60, 2)
    tail = (np.tanh(0.5 * n * math.pi * long / short) / n**5.0).sum()
    return float(long * short**3 / 3.0 * (1.0 - 192.0 / math.pi**5 * short / long * tail))


@dataclass(frozen=True)
class Bar:
    """Prismatic elastic bar, clamped at x = 0.

    Attributes:
        length: length L [m].
        section: cross-section.
        E: Young's modulus [Pa].
        nu: Poisson's ratio [-].
        rho: density [kg/m³].
    """

    length: float
    section: CrossSection
    E: float
    nu: float
    rho: float = 1.0

    @property
    def G(self) -> float:
        """Shear modulus [Pa]."""
        return self.E / (2.0 * (1.0 + self.nu))

    @property
    def EI(self) -> float:
        """Bending stiffness [N·m²]."""
        return self.E * self.section.second_moment

    @property
    def kGS(self) -> float:
        """Shear stiffness [N]."""
        return self.section.shear_coefficient(self.nu) * self.G * self.section.area

    def extension(self, force: float) -> float:
        """Return the axial displacement F L / (E S) of the end [m] under an axial force F [N]."""
        return force * self.length / (self.E * self.section.area)

    def deflection(self, force: float, *, overhang: float = 0.0, shear: bool = False) -> float:
        """Return the transverse displacement of the end [m]: F L³ / (3 E I), plus F L / (k G S) with shear.

        Args:
            force: transverse force F [N].
            overhang: distance beyond the end at which the force acts [m]; it adds the moment F · overhang.
            shear: True for Timoshenko's beam, False for Euler–Bernoulli's.
        """
        bent = force * self.length**2 * (2.0 * self.length + 3.0 * overhang) / (6.0 * self.EI)
        return bent + (force * self.length / self.kGS if shear else 0.0)

    def twist(self, moment: float) -> float:
        """Return the rotation T L / (G J) of the end about x [rad] under a moment T [N·m]."""
        return moment * self.length / (self.G * self.section.torsion_constant)

    @property
    def wave_speed(self) -> float:
        """Wave speed √(E/ρ) of a thin rod [m/s]."""
        return math.sqrt(self.E / self.rho)

    @property
    def axial_frequency(self) -> float:
        """First axial frequency [Hz]: √(E/ρ) / (4 L)."""
        return self.wave_speed / (4.0 * self.length)

    @property
    def torsional_frequency(self) -> float:
        """First torsional frequency [Hz]: √(G J / (ρ I_p)) / (4 L)."""
        section = self.section
        speed = math.sqrt(self.G * section.torsion_constant / (self.rho * section.polar_moment))
        return speed / (4.0 * self.length)

    @property
    def bending_frequency(self) -> float:
        """First bending frequency of Euler and Bernoulli [Hz]: 1.8751² / (2π L²) √(E I / (ρ S))."""
        per_length = self.rho * self.section.area
        return _BETA_1**2 / (2.0 * math.pi * self.length**2) * math.sqrt(self.EI / per_length)

    @property
    def bending_frequency_timoshenko(self) -> float:
        """First bending frequency with shear and rotary inertia [Hz].

        The state (v, θ, M, Q) obeys y' = A y along the bar with
            v' = θ + Q/(kGS)   θ' = M/(EI)   M' = -Q - ρ I ω² θ   Q' = -ρ S ω² v.

        The matrix exp(A L) maps the state at the clamped end (v = θ = 0) to that at the free end (M = Q = 0). At a
        natural frequency its block from (M, Q) to (M, Q) is singular.
        """
        section, L = self.section, self.length
        # lengths in L and forces in EI/L² keep the numbers near one
        shear = self.EI / (self.kGS * L * L)
        rotary = section.rotary_moment / (section.area * L * L)

        def free_end(share: float) -> float:
            w = (share * _BETA_1**2) ** 2
            A = np.array([[0, 1, 0, shear], [0, 0, 1, 0], [0, -rotary * w, 0, -1], [-w, 0, 0, 0]])
            return float(np.linalg.det(expm(A)[2:, 2:]))

        # shear and rotary inertia only lower the frequency, so the first change of sign from below is the first mode
        high = 0.05
        while free_end(high) > 0.0:
            high += 0.05
        share = brentq(free_end, high - 0.05, high, xtol=1e-13)
        assert isinstance(share, float)
        return share * self.bending_frequency
