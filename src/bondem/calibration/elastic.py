"""Elastic calibration: bond parameters with which specimens have given E, ν and ρ."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np

from bondem._checks import array, instance, number, several, shown
from bondem._progress import staged
from bondem._types import PerElement
from bondem.calibration.abacus import curve
from bondem.calibration.density import balanced_density, element_density
from bondem.calibration.reach import recommend
from bondem.calibration.response import Response, Slope
from bondem.calibration.search import Search
from bondem.calibration.surface_correction import SurfaceCorrection
from bondem.calibration.uncertainty import Sample
from bondem.errors import InputError
from bondem.labtests.tension import Tension
from bondem.laws.bond import BondLaw
from bondem.laws.catalogue import DEFAULT
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material

_RANGE = "two positive values of the free parameter, the smaller first"


@dataclass(frozen=True)
class Trial:
    """One evaluation on the way: means over the calibrating lattices.

    Attributes:
        value: of the free parameter.
        stiffness_ratio: E / E_μ [-].
        nu: Poisson's ratio [-].
    """

    value: float
    stiffness_ratio: float
    nu: float


@dataclass(frozen=True, eq=False)
class Calibration:
    """A calibrated law, and how well it does.

    Attributes:
        law: the bond law to use.
        density: of the elements, ρ_μ [kg/m³].
        material: the target.
        parameter: name of the parameter found for ν, that which the law declares free.
        table: every evaluation, in ascending order of the parameter.
        responses: what each calibrating lattice does with the final law.
        slopes: of each lattice to the parameter.
        reason: why this law was taken, where it was not chosen.
    """

    law: BondLaw
    density: float
    material: Material
    parameter: str
    table: tuple[Trial, ...]
    responses: tuple[Response, ...]
    slopes: tuple[Slope, ...]
    reason: str = ""

    @property
    def tensions(self) -> tuple[Tension, ...]:
        """The tension test of each calibrating lattice with the final law; none of periodic cells."""
        return tuple(one.tension for one in self.responses if one.tension is not None)

    @property
    def value(self) -> float:
        """Of the parameter [-]."""
        return float(getattr(self.law, self.parameter))

    @property
    def E(self) -> float:
        """Young's modulus achieved, mean over the lattices [Pa]."""
        return self.sample("E").mean

    @property
    def nu(self) -> float:
        """Poisson's ratio achieved, mean over the lattices [-]."""
        return self.sample("nu").mean

    @property
    def E_std(self) -> float:
        """Standard deviation of E over the lattices [Pa]; 0 for one."""
        return self.sample("E").std

    @property
    def nu_std(self) -> float:
        """Standard deviation of ν over the lattices [-]; 0 for one."""
        return self.sample("nu").std

    def sample(self, quantity: str) -> Sample:
        """One quantity of each calibrating lattice.

        Args:
            quantity: "E" [Pa] or "nu" [-] with the calibrated law; "E_mu" [Pa] or "value" [-], the modulus and the
                parameter of bonds that each lattice would have by itself, to first order in its difference.

        Raises:
            InputError: another quantity.
        """
        E, nu = (np.array([getattr(one, name) for one in self.responses]) for name in ("E", "nu"))
        if quantity in ("E", "nu"):
            return Sample(E if quantity == "E" else nu)
        if quantity not in ("E_mu", "value"):
            raise InputError(f"quantity = '{quantity}'; choose from E, nu, E_mu, value")
        shift = (nu.mean() - nu) / np.array([slope.nu for slope in self.slopes])
        if quantity == "value":
            return Sample(self.value + shift)
        log_E = np.log(E / E.mean()) + np.array([slope.log_E for slope in self.slopes]) * shift
        return Sample(self.law.E * np.exp(-log_E))

    def interval(self, quantity: str, *, kind: str = "confidence", level: float = 0.95) -> tuple[float, float]:
        """Interval of the mean of all packings ("confidence") or of one new packing ("prediction").

        For packings made like those of the calibration; see `Sample.interval`.

        Args:
            quantity: "E", "nu", "E_mu" or "value"; see `sample`.
            kind: "confidence" or "prediction".
            level: share of cases in which the interval is right [-].

        Raises:
            InputError: calibrated on one packing, or an unknown quantity or kind.
        """
        return self.sample(quantity).interval(kind=kind, level=level)

    def packings_for(self, precision: float, *, quantity: str = "E", level: float = 0.95) -> int:
        """Number of calibrating packings for a mean within ± precision [-], at the scatter seen here."""
        return self.sample(quantity).packings_for(precision, level=level)

    def law_for(self, lattice: Lattice) -> BondLaw:
        """The law with which another specimen of the same packing, of any shape, is expected to have E and ν.

        Skins of bodies are not like their inside, so that E and ν of a specimen depend on its shape. The
        `SurfaceCorrection` predicts how far it is from the calibrating lattices; slopes turn that into bonds. Nothing
        is solved.

        Args:
            lattice: the specimen, elements of any size.

        Warns:
            ExtrapolationWarning: the lattice is beyond those the correction was fitted to.
        """
        correction = SurfaceCorrection.default(self.law)
        known = [one.lattice for one in self.responses]
        log_E = math.log(correction.E(lattice)) - float(np.mean([math.log(correction.E(one)) for one in known]))
        ratio = correction.nu(lattice) / float(np.mean([correction.nu(one) for one in known]))
        slope = _mean_slope(self.slopes)
        shift = (self.material.nu / ratio - self.nu) / slope.nu
        log_E += slope.log_E * shift
        E_mu = self.law.E * self.material.E / self.E * math.exp(-log_E)
        changed: dict[str, Any] = {"E": E_mu, self.parameter: self.value + shift}
        return replace(self.law, **changed)

    def density_for(self, lattice: Lattice, *, balanced: bool = False) -> float | PerElement:
        """ρ_μ of another specimen [kg/m³]: one number by eq (19), or one an element by `balanced_density`, (n,)."""
        if balanced:
            return balanced_density(lattice, self.material.rho)
        return element_density([lattice], self.material.rho)

    def sensitivity(self, parameter: str) -> Slope:
        """d ln E / dp and dν / dp to any parameter of the law, mean over the lattices."""
        return _mean_slope([one.slope(parameter) for one in self.responses])


@staged("calibration")
def calibrate(
    lattice: Lattice | Sequence[Lattice],
    material: Material,
    *,
    law: type[BondLaw] | None = None,
    nu_mu: float = 0.3,
    search: tuple[float, float] | None = None,
    tolerance: float = 1e-5,
    **parameters: Any,
) -> Calibration:
    """Find the law of a family with which specimens have the E, ν and ρ of a material.

    In linear elasticity ν does not depend on E_μ and E is proportional to it: one root in the law's free
    parameter gives ν (r̃ of beams, a factor on the shear stiffness of others: `law.free`), one division gives E.
    The root is Newton's, with the derivative of the adjoint problem, begun on the curve of the law that comes with
    bondem: two or three evaluations. Moduli are those of `labtests.static_tension` along x, or of `bulk_moduli`
    for periodic cells; over several lattices, their means are calibrated.

    Args:
        lattice: the specimen, or several packings of it.
        material: the target.
        law: family of bond laws; the one that `recommend` names unless given.
        nu_mu: Poisson's ratio of the bonds, ν_μ [-]; it hardly matters for Euler–Bernoulli bonds.
        search: between which values of the free parameter to look; `law.free.search` unless given.
        tolerance: on ν [-].
        **parameters: further parameters of the law, held fixed: radius_rule=, formulation=, and radius_ratio= where
            it is not what varies, which is 1 unless given.

    Raises:
        UnreachableTargetError: the law cannot give this ν on this lattice; the message names its reach.
        InputError: no lattice, or a parameter the law does not have or that calibration sets.
    """
    lattices = several("calibrate", "lattice", lattice, Lattice, "a lattice, from bd.connect, or several")
    if not lattices:
        raise InputError("calibrate needs at least one lattice; pass bd.connect(particles)")
    instance("calibrate", "material", material, Material, "a bd.Material, or one of bd.materials")
    number("calibrate", "tolerance", tolerance, above=0.0, advice="a tolerance on ν above zero")
    if law is not None and not (isinstance(law, type) and issubclass(law, BondLaw)):
        raise InputError(f"law = {shown(law)}; pass a bond law class, such as bd.{DEFAULT.__name__}, not an instance")
    if search is not None:
        ends = array("calibrate", "search", search, wanted=_RANGE)
        if ends.shape != (2,) or not 0.0 < ends[0] < ends[1]:
            raise InputError(f"calibrate: search = {shown(search)}; give {_RANGE}")
        search = float(ends[0]), float(ends[1])
    reason = ""
    if law is None:
        choice = recommend(material.nu)
        law, reason = choice.law, choice.reason
    free = law.free
    _require_known(law, parameters)
    trials: dict[float, Trial] = {}
    found: list[Response] = []

    def bonds(E: float, value: float) -> BondLaw:
        return law.at(value, E=E, nu=nu_mu, **parameters)

    def measured(candidate: BondLaw) -> list[Response]:
        known = found or [None] * len(lattices)
        return [Response(one, candidate, guess=last) for one, last in zip(lattices, known, strict=True)]

    def nu_of(value: float) -> tuple[float, float]:
        found[:] = measured(bonds(material.E, value))
        slope = _mean_slope([one.slope(free.name) for one in found])
        for one in found:
            one.forget_matrix()
        E, nu = (float(np.mean([getattr(one, name) for one in found])) for name in ("E", "nu"))
        trials[value] = Trial(value, E / material.E, nu)
        return nu, slope.nu

    known = curve(law)
    start = known.value_for(material.nu) if known is not None and known.parameter == free.name else None
    value = Search(free.name, *(search or free.search)).solve(
        nu_of, material.nu, start=start, tolerance=tolerance, who=f"{law.__name__} bonds"
    )
    slopes = tuple(one.slope(free.name) for one in found)
    calibrated = bonds(material.E / trials[value].stiffness_ratio, value)
    responses = tuple(measured(calibrated))
    for one in responses:
        one.forget_matrix()  # a calibration is kept, and large lattices have large matrices
    return Calibration(
        law=calibrated,
        density=element_density(lattices, material.rho),
        material=material,
        parameter=free.name,
        table=tuple(trials[key] for key in sorted(trials)),
        responses=responses,
        slopes=slopes,
        reason=reason,
    )


def _mean_slope(slopes: Sequence[Slope]) -> Slope:
    return Slope(*(float(np.mean([getattr(one, name) for one in slopes])) for name in ("log_E", "nu")))


def _require_known(law: type[BondLaw], given: dict[str, Any]) -> None:
    free = law.free
    known = {item.name for item in fields(law)} - {"E", "nu", free.name}
    if free.is_radius:
        known -= {"radius"}
    unknown = sorted(set(given) - known)
    if unknown:
        raise InputError(
            f"calibrate: {law.__name__} has no fixed parameter '{unknown[0]}'; choose from"
            f" {', '.join(sorted(known))} (E and {free.name} are what is looked for, nu_mu= sets nu)"
        )
