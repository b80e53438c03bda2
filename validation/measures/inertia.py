"""Mass and moments of inertia of a specimen of spheres beside those of the continuum it stands for."""

import math
from dataclasses import dataclass

import numpy as np

from bondem._types import Floats
from bondem.errors import InputError
from bondem.geometry.elementary_shapes import Cylinder
from bondem.geometry.moments import moments
from bondem.labtests.beam_tests import Bar
from bondem.specimen.lattice import Lattice

# (sinh β - sin β) / (cosh β + cos β) and β of the cantilever's first bending mode.
_BETA = 1.8751040687119611
_SIGMA = (math.sinh(_BETA) - math.sin(_BETA)) / (math.cosh(_BETA) + math.cos(_BETA))


@dataclass(frozen=True)
class InertiaExcess:
    """A cylinder of spheres against a continuum of the same walls; what moves only, so without rattlers.

    Attributes:
        mass: of the elements [kg].
        mass_excess: over that of the continuum, less one [-].
        centre: of mass, less that of the continuum, over R [-], (3,).
        axial_excess: moment about the axis, Σ m (y² + z²) + 2/5 m R_i², over M R²/2, less one [-].
        lateral_excess: mean of the moments about y and z through the middle over M (3 R² + L²)/12, less one [-].
        own_share: of Σ 2/5 m R_i² in the moment about the axis [-].
        frequency: what the first frequency of a kind owes to it, to first order [-]: half the excess, with the
            opposite sign, of ∫ dm times the square of the continuum's mode, "tension", "bending" and "torsion".
    """

    mass: float
    mass_excess: float
    centre: tuple[float, float, float]
    axial_excess: float
    lateral_excess: float
    own_share: float
    frequency: dict[str, float]


def inertia_excess(lattice: Lattice, *, density: float, rho: float) -> InertiaExcess:
    """Mass and moments of a cylinder of spheres over those of the continuum.

    Rayleigh's quotient is stationary, so that a change of the mass alone, in the continuum's own mode φ, gives the
    change of the frequency to first order: δf/f = -½ δ(∫ φ² dm) / ∫ φ² dm, with the rotation of the sections,
    φ' y, as part of the motion in bending.

    Args:
        lattice: the specimen.
        density: of the elements, ρ_μ [kg/m³].
        rho: of the continuum, ρ_M [kg/m³].

    Raises:
        InputError: the specimen is no Cylinder.
    """
    particles = lattice.particles
    shape = particles.envelope
    if not isinstance(shape, Cylinder):
        raise InputError(f"moments are compared with those of a Cylinder, not of a {type(shape).__name__}")
    moving = lattice.connected
    position, radius = particles.position[moving], particles.radius[moving]
    mass = density * particles.volume[moving]
    own = 0.4 * mass * radius**2
    R, L = shape.radius, shape.length
    whole = rho * shape.volume
    continuum = rho * np.diag(moments(shape).inertia)
    x, y, z = position.T
    axial = float(mass @ (y * y + z * z) + own.sum())
    lateral = float(mass @ ((x - 0.5 * L) ** 2 + 0.5 * (y * y + z * z)) + own.sum())
    centre = mass @ (position - [0.5 * L, 0.0, 0.0]) / mass.sum() / R
    s = np.linspace(0.0, 1.0, 2001)
    sine, (bent, turned) = np.sin(0.5 * np.pi * s) ** 2, _bending_mode(s)
    at = x / L
    mine, (mine_bent, mine_turned) = np.sin(0.5 * np.pi * at) ** 2, _bending_mode(at)
    rotary = 0.25 * (R / L) ** 2
    excess = {
        "tension": float(mass @ mine) / (whole * float(np.trapezoid(sine, s))),
        "torsion": float((mass * (y * y + z * z) + own) @ mine)
        / (0.5 * whole * R * R * float(np.trapezoid(sine, s))),
        "bending": float(mass @ mine_bent**2 + (mass * y * y + own) @ mine_turned**2 / L**2)
        / (whole * float(np.trapezoid(bent**2 + rotary * turned**2, s))),
    }
    return InertiaExcess(
        mass=float(mass.sum()),
        mass_excess=float(mass.sum()) / whole - 1.0,
        centre=(float(centre[0]), float(centre[1]), float(centre[2])),
        axial_excess=axial / float(continuum[0]) - 1.0,
        lateral_excess=2.0 * lateral / float(continuum[1] + continuum[2]) - 1.0,
        own_share=float(own.sum()) / axial,
        frequency={kind: -0.5 * (value - 1.0) for kind, value in excess.items()},
    )


def stiffness_effect(bar: Bar, filled: Bar) -> dict[str, float]:
    """What the first frequencies owe to a section whose skin carries less, to first order [-]."""
    ratio = filled.section.second_moment / bar.section.second_moment
    twist = filled.section.torsion_constant / bar.section.torsion_constant
    return {"tension": 0.0, "bending": 0.5 * (ratio - 1.0), "torsion": 0.5 * (twist - 1.0)}


def _bending_mode(s: Floats) -> tuple[Floats, Floats]:
    """First mode of the cantilever of Euler and Bernoulli and its slope, over s = x / L."""
    t = _BETA * s
    mode = np.cosh(t) - np.cos(t) - _SIGMA * (np.sinh(t) - np.sin(t))
    slope = _BETA * (np.sinh(t) + np.sin(t) - _SIGMA * (np.cosh(t) - np.cos(t)))
    return mode, slope
