"""Elastic response of one lattice with a bond law: E and ν and their derivatives with respect to parameters.

E and ν follow from strains ε that are linear in a static solution u, or from the energy of u in a periodic cell.
Their derivatives need no finite differences of solutions. Let K u = f, ε = cᵀ u with a constant vector c, and K λ = c
(the adjoint problem). The derivative by a parameter p of the stiffnesses k of the bonds is

    dε/dp = - λᵀ (dK/dp) u = - Σ bonds, (dk/dp) × (products of the bond's deformation under u and under λ).
The energy of a periodic cell is stationary with respect to u, so that u replaces λ there.
"""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from bondem._checks import instance
from bondem._types import Floats
from bondem.interactions.beams.assignment import bond_geometry
from bondem.interactions.beams.bond_law import BondGeometry, BondLaw
from bondem.interactions.beams.bond_strain import BondStrain
from bondem.labtests.arguments import refuse_turned
from bondem.labtests.bulk import BulkModuli, bulk_moduli
from bondem.labtests.gauge_length import middle_half
from bondem.labtests.isotropic import Isotropic
from bondem.labtests.tension import Tension, tension_model, tension_of
from bondem.observables.affine_strain import gradient_weights
from bondem.specimen.lattice import Lattice
from bondem.statics.static import Statics

# Step of central differences of closed forms, relative to the parameter: derivatives have ten correct digits.
_STEP = 1e-5


@dataclass(frozen=True)
class Slope:
    """Derivatives of the moduli of a lattice with respect to a parameter p of its bonds.

    Attributes:
        log_E: derivative d ln E / dp.
        nu: derivative dν / dp.
    """

    log_E: float
    nu: float


class Response:
    """E and ν of one lattice with one law: bulk moduli of a periodic cell, otherwise a tension test along x.

    Iterations start from `guess`, a Response of the same lattice to similar bonds, if given. A lattice of several
    bodies raises InputError.

    Attributes:
        lattice: the specimen.
        law: bond law.
        E: Young's modulus [Pa].
        nu: Poisson's ratio [-].
        tension, moduli: tension test, or bulk moduli for a periodic cell; the other one is None.
    """

    def __init__(self, lattice: Lattice, law: BondLaw, *, guess: "Response | None" = None) -> None:
        self.lattice = instance("Response", "lattice", lattice, Lattice, "a lattice, from bd.connect")
        lattice.bodies.require_one("Response")
        self.law = instance("Response", "law", law, BondLaw, "a bond law with its parameters")
        if guess is not None:
            instance("Response", "guess", guess, Response, "the Response of the same lattice to similar bonds")
        self.tension: Tension | None = None
        self.moduli: BulkModuli | None = None
        self._adjoint: tuple[BondStrain, ...] | None = None
        self._statics: Statics | None = None
        if lattice.particles.period is not None:
            self.moduli = bulk_moduli(lattice, law, guess=guess.moduli if guess is not None else None)
            self.E, self.nu = self.moduli.E, self.moduli.nu
        else:
            refuse_turned("static_tension", lattice, "x_min x_max")
            self._statics = Statics(tension_model(lattice, law))
            start = None
            if guess is not None and guess.tension is not None:
                start = guess.tension.solution.scaled(guess.law.E / law.E)
            self.tension = tension_of(self._statics, guess=start)
            self.E, self.nu = self.tension.E, self.tension.nu

    def slope(self, parameter: str) -> Slope:
        """Return the derivatives of ln E and ν with respect to a parameter of the law.

        A tension test solves two adjoint problems, once for all parameters; bulk moduli need none.

        Args:
            parameter: name of the parameter: "nu", "radius_ratio" or the free parameter of the law.
        """
        change = stiffness_slope(self.lattice, self.law, parameter)
        if self.moduli is not None:
            return _slope_of_moduli(self.moduli, self.moduli.stiffness_of(change))
        assert self.tension is not None
        u, axial, lateral = self._deformations()
        d_axial, d_lateral = (-float(np.vdot(change, adjoint.products(u))) for adjoint in (axial, lateral))
        strain = np.diag(self.tension.strain)
        return Slope(float(-d_axial / strain[0]), float(-(d_lateral + self.nu * d_axial) / strain[0]))

    def forget_matrix(self) -> None:
        """Free the assembled matrix; a later request for slopes assembles it again."""
        self._statics = None

    def _deformations(self) -> tuple[BondStrain, ...]:
        """Deformations of the bonds under tension and under the adjoints of axial and mean lateral strain."""
        if self._adjoint is None:
            assert self.tension is not None
            if self._statics is None:
                self._statics = Statics(tension_model(self.lattice, self.law))
            lattice, lever = self.lattice, self._statics.model.stiffness.lever
            chosen = middle_half(lattice)
            weight = gradient_weights(lattice.particles.position[chosen])
            loads = np.zeros((2, len(lattice.particles), 6))
            loads[0, chosen, 0] = weight[:, 0]
            loads[1, chosen, 1:3] = 0.5 * weight[:, 1:]
            statics = self._statics
            motions = [statics.response(load) for load in loads]
            solution = self.tension.solution
            motions.insert(0, np.hstack([solution.displacement, solution.rotation]))
            self._adjoint = tuple(BondStrain.of(lattice, lever, m[:, :3], m[:, 3:]) for m in motions)
        return self._adjoint


def stiffness_slope(lattice: Lattice, law: BondLaw, parameter: str) -> Floats:
    """Derivatives of kn, ks, kb and kt of every bond with respect to a parameter of the law, (4, m)."""
    bonds = bond_geometry(lattice)
    value = float(getattr(law, parameter))
    step = _STEP * max(abs(value), 1e-3)
    above, below = (_stiffness(law, bonds, {parameter: value + sign * step}) for sign in (1.0, -1.0))
    return (above - below) / (2.0 * step)


def _stiffness(law: BondLaw, bonds: BondGeometry, changed: dict[str, Any]) -> Floats:
    k = replace(law, **changed).stiffness(bonds)
    return np.stack([k.kn, k.ks, k.kb, k.kt])


def _slope_of_moduli(moduli: BulkModuli, change: Floats) -> Slope:
    K, G = moduli.K, moduli.G
    rate = Isotropic.average(change)
    dK, dG, whole = rate.K, rate.G, 3.0 * K + G
    return Slope(log_E=(dK * G / K + 3.0 * dG * K / G) / whole, nu=4.5 * (dK * G - dG * K) / whole**2)
