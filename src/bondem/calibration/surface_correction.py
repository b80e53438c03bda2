"""Surface correction: the moduli of a bond law, calibrated in the bulk, in a body with walls.

Spheres at a wall have fewer neighbours. With a prescribed mean number of contacts the interior compensates with
more contacts, and thin bodies are stiffer. At the onset of jamming, or in a body cut from a larger packing, thin
bodies are softer. The prediction is the affine estimate of the lattice, a sum over its bonds, times a factor for the
relaxation of the elements,

    ln(E / E_affine) = Σ_jk c_jk f_j g_k,    ν - ν_affine = Σ_jk d_jk f_j g_k,
    f = 1, ln p, ln² p, ln(12 q / p),    p = Σ ks L² / Σ kn L²,  q = Σ kb / Σ kn L²      (the law),
    g = 1, ln v, w, w ln v, ln z,     v = ⟨1/z_i + 1/z_j⟩,  z = ⟨z_i + z_j⟩ / 2      (the lattice),

with coefficients c_jk and d_jk measured by `python -m validation surface`. Sums and means ⟨⟩ are over bonds of length
L and stiffnesses kn (normal), ks (shear) and kb (bending). z_i is the number of bonds of element i, and w is
`AffineEstimate.wall`. v and z are relative to reference values. Errors are about the scatter of single packings.
"""

import json
import math
import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from bondem._names import users_line
from bondem._types import Floats
from bondem.calibration.affine import AffineEstimate, affine_estimate
from bondem.errors import InputError
from bondem.interactions.beams.bond_law import BondGeometry, BondLaw, BondStiffness
from bondem.labtests.isotropic import Isotropic
from bondem.specimen.lattice import Lattice

_DATA = Path(__file__).with_suffix(".json")

# Reference values of z and v, about those of a periodic cell with 6.2 contacts per sphere [-].
_COORDINATION, _LOOSENESS = 6.6, 0.32


class ExtrapolationWarning(UserWarning):
    """Warning of a prediction for a law or lattice outside the range of the fit."""


def law_terms(shear: Any, bending: Any) -> Floats:
    """Return the terms f, (…, 4): 1, ln p, ln² p, ln(12 q / p), with p = `shear` and q = `bending`."""
    x = np.log(shear)
    return np.stack([np.ones_like(x), x, x * x, np.log(12.0 * np.asarray(bending)) - x], axis=-1)


def lattice_terms(coordination: Any, looseness: Any, wall: Any) -> Floats:
    """Return the terms g, (…, 5): 1, ln v, w, w ln v, ln z; v, z: looseness, coordination over reference; w: wall."""
    z, v, w = np.log(np.asarray(coordination) / _COORDINATION), np.log(np.asarray(looseness) / _LOOSENESS), wall
    return np.stack([np.ones_like(z), v, np.asarray(w, dtype=float), v * w, z], axis=-1)


@dataclass(frozen=True, eq=False)
class SurfaceModel:
    """Coefficients of the surface correction (symbols as in the module's docstring), with range and error of the fit.

    Attributes:
        E, nu: coefficients c_jk and d_jk, (4, 5).
        E_curve, nu_curve: coefficients of s, s ln p, s² and s² ln p in E/E_bulk - 1 and ν/ν_bulk - 1, with s = R̄S/V
            (mean radius, surface, volume), for bodies with 6.2 contacts per sphere, (4,).
        E_error, nu_error: a, b of the relative standard error √(a² + b² / elements) of predictions from a lattice, on
            shapes outside the fit, (2,).
        E_curve_error, nu_curve_error: relative standard error of predictions from R̄S/V [-].
        length: mean and standard deviation of the length of bonds in the bulk, over R̄ [-], (2,).
        number: number of bonds in the bulk per volume R̄³ [-].
        coordination, looseness: values of the bulk, as in `AffineEstimate` [-].
        fitted: lowest and highest "coordination", "looseness", "wall", "shear" and "softness" (12 q / p) of the fit.
    """

    E: Floats
    nu: Floats
    E_curve: Floats
    nu_curve: Floats
    E_error: tuple[float, float]
    nu_error: tuple[float, float]
    E_curve_error: float
    nu_curve_error: float
    length: Floats
    number: float
    coordination: float
    looseness: float
    fitted: Mapping[str, tuple[float, float]]

    @classmethod
    def read(cls, data: Mapping[str, Any]) -> "SurfaceModel":
        """Create the model from the contents of its JSON file."""
        E, nu, E_curve, nu_curve, length = (
            np.array(data[name], dtype=float) for name in ("E", "nu", "E_curve", "nu_curve", "length")
        )
        E_error, nu_error, *fitted = (
            (float(low), float(high)) for low, high in (data["E_error"], data["nu_error"], *data["fitted"].values())
        )
        return cls(
            E=E, nu=nu, E_curve=E_curve, nu_curve=nu_curve, E_error=E_error, nu_error=nu_error,
            E_curve_error=float(data["E_curve_error"]), nu_curve_error=float(data["nu_curve_error"]), length=length,
            number=float(data["number"]), coordination=float(data["coordination"]),
            looseness=float(data["looseness"]),
            fitted=dict(zip(data["fitted"], fitted, strict=True)),
        )  # fmt: skip

    def moduli(self, estimate: AffineEstimate) -> tuple[float, float]:
        """Predict E [Pa] and ν [-] of the lattice of an affine estimate."""
        f = law_terms(estimate.shear, estimate.bending)
        g = lattice_terms(estimate.coordination, estimate.looseness, estimate.wall)
        return estimate.E * math.exp(float(f @ self.E @ g)), estimate.nu + float(f @ self.nu @ g)

    def bulk(self, law: BondLaw, mean_radius: float) -> AffineEstimate:
        """Isotropic affine estimate of a law in a large periodic cell: 6.2 contacts per sphere, mean radius [m]."""
        # two lengths of this mean and standard deviation represent all bonds
        length = mean_radius * (self.length[0] + self.length[1] * np.array([-1.0, 1.0]))
        half = 0.5 * length
        k = law.stiffness(BondGeometry(length, half, half, np.full(2, mean_radius)))
        volume = len(length) * mean_radius**3 / self.number
        return self._isotropic(k, length, volume)

    def _isotropic(self, k: BondStiffness, length: Floats, volume: float) -> AffineEstimate:
        """Affine estimate of bonds with uniformly distributed directions in a volume [m³]."""
        normal, shear = float(k.kn @ length**2), float(k.ks @ length**2)
        mean = Isotropic(K=normal / (9.0 * volume), G=(normal / 15.0 + shear / 10.0) / volume)
        stiffness = np.diag([2.0 * mean.G] * 3 + [mean.G] * 3)
        stiffness[:3, :3] += mean.K - 2.0 * mean.G / 3.0
        return AffineEstimate(
            stiffness, mean.E, mean.nu, self.coordination, self.looseness, wall=0.0, shear=shear / normal,
            bending=float(k.kb.sum()) / normal,
        )  # fmt: skip


@cache
def _default() -> SurfaceModel:
    return SurfaceModel.read(json.loads(_DATA.read_text(encoding="utf-8")))


@dataclass(frozen=True)
class SurfaceCorrection:
    """E and ν of a specimen relative to those of the bulk, for one bond law.

    The bulk is a large periodic cell of default packing (6.2 contacts per sphere, radii R̄ ± 12.5 %), measured by
    `bd.bulk_moduli`. The ratio of two lattices, `E(other) / E(calibrated)`, does not depend on this reference. The
    prediction for a bar is that of `labtests.static_tension` along x, for other shapes that of the whole body.

    Attributes:
        law: bond law.
        model: coefficients.
    """

    law: BondLaw
    model: SurfaceModel

    @classmethod
    def default(cls, law: BondLaw) -> "SurfaceCorrection":
        """Correction with the coefficients measured by `python -m validation surface`.

        Args:
            law: bond law; its modulus does not matter. Another object raises InputError.
        """
        if not isinstance(law, BondLaw):
            raise InputError(f"law = {law!r}: not a bond law; give one, such as calibrate(...).law")
        return cls(law, _default())

    def E(self, where: Lattice | float) -> float:
        """Ratio of Young's modulus of a specimen to that of the bulk [-].

        Args:
            where: lattice; or, less accurate, mean radius times surface over volume, R̄S/V, of a body packed with 6.2
                contacts per sphere [-].

        Raises:
            InputError: R̄S/V for a law with radius= instead of radius_ratio=, or an error of `affine_estimate`.

        Warns:
            ExtrapolationWarning: outside the range of the fit.
        """
        return self._ratio(where, 0, self.model.E_curve)

    def nu(self, where: Lattice | float) -> float:
        """Ratio of Poisson's ratio of a specimen to that of the bulk [-]; arguments and errors are those of `E`.

        The value holds for bodies at least twice as long as thick. Uniform tractions on the ends of shorter bodies
        overload their soft skin, and `static_tension` measures a ν some percent smaller. Between rigid plates their ν
        is the value given here.
        """
        return self._ratio(where, 1, self.model.nu_curve)

    def E_error(self, where: Lattice | float) -> float:
        """Relative standard error of `E(where)` for one packing [-]."""
        return self._error(where, self.model.E_error, self.model.E_curve_error)

    def nu_error(self, where: Lattice | float) -> float:
        """Relative standard error of `nu(where)` for one packing [-]."""
        return self._error(where, self.model.nu_error, self.model.nu_curve_error)

    def _ratio(self, where: Lattice | float, which: int, curve: Floats) -> float:
        """Return the ratio of E (0) or ν (1) to that of the bulk [-], by the estimate of a lattice or by a curve."""
        if not isinstance(where, Lattice):
            return 1.0 + float(self._curve_terms(where) @ curve)
        estimate = affine_estimate(where, self.law)
        self._check(estimate)
        bulk = self.model.bulk(self.law, where.particles.mean_radius)
        return self.model.moduli(estimate)[which] / self.model.moduli(bulk)[which]

    def _curve_terms(self, s: float) -> Floats:
        if self.law.radius is not None:
            raise InputError(
                "where: R̄S/V needs a law with radius_ratio=, not radius=; give such a law, or a lattice"
            )
        bulk = self.model.bulk(self.law, 1.0)
        self._check(bulk, wall=float(s))
        x = math.log(bulk.shear)
        return np.array([s, s * x, s * s, s * s * x])

    @staticmethod
    def _error(where: Lattice | float, of_lattice: tuple[float, float], of_curve: float) -> float:
        if isinstance(where, Lattice):
            return math.hypot(of_lattice[0], of_lattice[1] / math.sqrt(where.connected.sum()))
        return of_curve

    def _check(self, estimate: AffineEstimate, *, wall: float | None = None) -> None:
        softness = 12.0 * estimate.bending / estimate.shear
        for name, value, words in (
            ("coordination", estimate.coordination, "mean contacts at the ends of a bond"),
            ("looseness", estimate.looseness, "mean of 1/z over the elements at the ends of bonds"),
            ("wall", estimate.wall if wall is None else wall, "R̄S/V"),
            ("shear", estimate.shear, "shear over normal stiffness of the bonds, Σ ks L² / Σ kn L²"),
            ("softness", softness, "bending over shear stiffness of the bonds, 12 Σ kb / Σ ks L²"),
        ):
            low, high = self.model.fitted[name]
            if not low - 0.02 * (high - low) <= value <= high + 0.02 * (high - low):
                warnings.warn(
                    f"the surface correction was fitted for {words} from {low:.3g} to {high:.3g}, but the value is"
                    f" {value:.3g}: test the specimen itself (labtests.static_tension or uniform_stress)",
                    ExtrapolationWarning,
                    stacklevel=users_line(),
                )
