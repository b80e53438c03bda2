"""Elastic calibration: bond parameters for given E, ν and ρ of specimens."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from typing import Any, Literal

import numpy as np

from bondem._checks import array, choice, instance, number, several, shown
from bondem._progress import staged
from bondem._types import PerElement
from bondem.calibration.abacus import curve
from bondem.calibration.bond_strength import calibrate_bond_strength
from bondem.calibration.density import balanced_density, element_density
from bondem.calibration.reach import recommend
from bondem.calibration.response import Response, Slope
from bondem.calibration.search import Search
from bondem.calibration.strength import StrengthCalibration
from bondem.calibration.surface_correction import SurfaceCorrection
from bondem.calibration.uncertainty import Kind, Sample
from bondem.damage.criteria.mohr_coulomb import MohrCoulomb
from bondem.errors import InputError
from bondem.interactions.beams.bond_law import BondLaw
from bondem.interactions.law_catalogue import DEFAULT
from bondem.labtests.tension import Tension
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material

# Least ratio of length along x to largest width for a tension test. With 800 spheres, calibrated bonds are 1.8, 1.2,
# 0.8 and 0.9 times as stiff as those of a periodic cell at ratios of 0.4, 0.8, 1 and 1.5.
_SLENDER = 1.0
_RANGE = "two positive values of the free parameter, the smaller first"
#: Quantities of a calibration that scatter from packing to packing.
Quantity = Literal["E", "nu", "E_mu", "value"]


@dataclass(frozen=True)
class Trial:
    """Evaluation of a law during a calibration: means over the calibrating lattices.

    Attributes:
        value: value of the free parameter [-].
        stiffness_ratio: ratio E / E_μ [-].
        nu: Poisson's ratio [-].
    """

    value: float
    stiffness_ratio: float
    nu: float


@dataclass(frozen=True, eq=False)
class Calibration:
    """Calibrated law with its achieved moduli and their uncertainty.

    Attributes:
        law: calibrated bond law.
        density: density of the elements, ρ_μ [kg/m³].
        material: target of the calibration.
        parameter: name of the parameter calibrated for ν, which the law declares free.
        table: all evaluations of the law, in ascending order of the parameter.
        responses: E and ν of each calibrating lattice with the calibrated law.
        slopes: derivatives of ln E and ν of each lattice with respect to the parameter.
        reason: reason for the recommended law; empty for a chosen law.
        strength: calibrated tensile strength and cohesion of the bonds, with their intervals; None without targets.
        friction_angle: friction angle of these bonds [rad].
    """

    law: BondLaw
    density: float
    material: Material
    parameter: str
    table: tuple[Trial, ...]
    responses: tuple[Response, ...]
    slopes: tuple[Slope, ...]
    reason: str = ""
    strength: StrengthCalibration | None = None
    friction_angle: float = 0.0

    @property
    def failure(self) -> MohrCoulomb:
        """Calibrated criterion of the bonds.

        Raises:
            InputError: no strengths were calibrated.
            ConvergenceError: the targets were not reached; `.strength.nearest` is the best run.
        """
        if self.strength is None:
            raise InputError("calibrate: no strengths were calibrated; give bd.calibrate ucs= and tension=")
        found = self.strength.parameters
        return MohrCoulomb(tension=found["tension"], cohesion=found["cohesion"], friction_angle=self.friction_angle)

    @property
    def tensions(self) -> tuple[Tension, ...]:
        """Tension test of each calibrating lattice with the calibrated law; empty for periodic cells."""
        return tuple(one.tension for one in self.responses if one.tension is not None)

    @property
    def value(self) -> float:
        """Calibrated value of the free parameter [-]."""
        return float(getattr(self.law, self.parameter))

    @property
    def E(self) -> float:
        """Achieved Young's modulus, mean over the lattices [Pa]."""
        return self.sample("E").mean

    @property
    def nu(self) -> float:
        """Achieved Poisson's ratio, mean over the lattices [-]."""
        return self.sample("nu").mean

    @property
    def E_std(self) -> float:
        """Standard deviation of E over the lattices [Pa]; 0 for a single lattice."""
        return self.sample("E").std

    @property
    def nu_std(self) -> float:
        """Standard deviation of ν over the lattices [-]; 0 for a single lattice."""
        return self.sample("nu").std

    def sample(self, quantity: Quantity) -> Sample:
        """Values of one quantity for all calibrating lattices.

        Args:
            quantity: "E" [Pa] or "nu" [-] with the calibrated law; "E_mu" [Pa] or "value" [-] for the modulus and the
                parameter that each lattice alone would need, to first order.

        Raises:
            InputError: an unknown quantity.
        """
        choice("sample", "quantity", quantity, Quantity)
        E, nu = (np.array([getattr(one, name) for one in self.responses]) for name in ("E", "nu"))
        if quantity in ("E", "nu"):
            return Sample(E if quantity == "E" else nu)
        shift = (nu.mean() - nu) / np.array([slope.nu for slope in self.slopes])
        if quantity == "value":
            return Sample(self.value + shift)
        log_E = np.log(E / E.mean()) + np.array([slope.log_E for slope in self.slopes]) * shift
        return Sample(self.law.E * np.exp(-log_E))

    def interval(self, quantity: Quantity, *, kind: Kind = "confidence", level: float = 0.95) -> tuple[float, float]:
        """Compute an interval for the mean of all packings ("confidence") or for one new packing ("prediction").

        The interval applies to packings made like those of the calibration; see `Sample.interval`.

        Args:
            quantity: name "E", "nu", "E_mu" or "value"; see `sample`.
            kind: kind of interval, "confidence" or "prediction".
            level: probability that the interval contains the value [-].

        Raises:
            InputError: a calibration on a single packing, an unknown quantity or kind, or `level` outside (0, 1).
        """
        return self.sample(quantity).interval(kind=kind, level=level)

    def packings_for(self, precision: float, *, quantity: Quantity = "E", level: float = 0.95) -> int:
        """Return the number of packings for a confidence interval of ± `precision` times the mean.

        Args:
            precision: half-width of the confidence interval over the mean [-].
            quantity: name "E", "nu", "E_mu" or "value"; see `sample`.
            level: probability that the interval contains the value [-].

        Raises:
            InputError: a single packing, an unknown quantity, or a precision that is not positive or out of reach.
        """
        return self.sample(quantity).packings_for(precision, level=level)

    def law_for(self, lattice: Lattice) -> BondLaw:
        """Predict the law with which another specimen of the same packing, of any shape, has the target E and ν.

        The skin of a body differs from its interior, so that E and ν of a specimen depend on its shape. The
        `SurfaceCorrection` predicts the difference from the calibrating lattices, and the slopes convert it into bond
        parameters. No system is solved.

        Args:
            lattice: the specimen, with elements of any size.

        Raises:
            InputError: bonds that do not resist every strain, or several bodies.

        Warns:
            ExtrapolationWarning: the lattice is outside the range of the fit of the correction.
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
        """Return the density ρ_μ that gives another specimen the density of the material [kg/m³].

        Args:
            lattice: the specimen.
            balanced: False for one density, by eq (19) of André et al. (2012); True for one per element, (n,), which
                also gives the centre of mass and the inertia of the shape, see `balanced_density`.

        Raises:
            InputError: several bodies; if `balanced`, also a periodic cell or no positive densities.
        """
        if balanced:
            return balanced_density(lattice, self.material.rho)
        return element_density([lattice], self.material.rho)

    def sensitivity(self, parameter: str) -> Slope:
        """Return d ln E / dp and dν / dp for a named parameter p of the law, as means over the lattices."""
        return _mean_slope([one.slope(parameter) for one in self.responses])


@staged("calibration")
def calibrate(
    lattice: Lattice | Sequence[Lattice], material: Material, *, law: type[BondLaw] | None = None, nu_mu: float = 0.3,
    search: tuple[float, float] | None = None, tolerance: float = 1e-5, ucs: float | None = None,
    tension: float | None = None, friction_angle: float = math.radians(35.0), **parameters: Any,
) -> Calibration:  # fmt: skip
    """Calibrate a family of bond laws to E, ν and ρ of a material, and optionally to its strengths.

    In linear elasticity ν does not depend on E_μ, and E is proportional to E_μ. The free parameter of the law (r̃ of
    beams, a factor on the shear stiffness of others: `law.free`) is solved for ν. One division then gives E_μ. The
    root is found by Newton's method with derivatives of the adjoint problem. The start is taken from the calibration
    curve of the law, so that two or three evaluations suffice. Moduli are those of `labtests.static_tension` along x,
    or of `bulk_moduli` for periodic cells. Over several lattices, the means are calibrated.

    With `ucs` and `tension`, `calibrate_strength` then calibrates the tensile strength and the cohesion of
    `bd.MohrCoulomb` bonds, within 4 %. The tests are `labtests.uniaxial_compression` between smooth platens and
    `labtests.direct_tension`. Several packings give intervals: `.strength.interval("tension")` of a parameter, and
    `.strength.strengths("ucs").interval(kind="prediction")` of a new packing. Where bonds cannot have both strengths,
    `.failure` raises an error that states the nearest strengths.

    Args:
        lattice: the specimen, or several packings of it.
        material: target material.
        law: family of bond laws; None for the one that `recommend` selects.
        nu_mu: Poisson's ratio of the bonds, ν_μ [-]; Euler–Bernoulli bonds hardly depend on it.
        search: range of the free parameter [-]; None for `law.free.search`.
        tolerance: tolerance of ν [-].
        ucs: uniaxial compressive strength [Pa], together with `tension`; None for no strengths.
        tension: strength in direct tension [Pa].
        friction_angle: friction angle of the bonds [rad].
        **parameters: further, fixed parameters of the law: radius_rule=, formulation=, and radius_ratio= (1 by
            default) if it is not the free parameter.

    Raises:
        UnreachableTargetError: the law cannot give this ν on this lattice; the message states its range.
        InputError: no lattice, one of several bodies, a specimen too short for a tension test along x or without
            ends to pull, an unknown parameter, a parameter that calibration sets, or one strength without the other.
        ConvergenceError: ν is not within the tolerance after more than 30 evaluations.
        UnstableRunError: a strength test failed at the start.
    """
    if (ucs is None) != (tension is None):
        raise InputError("calibrate: ucs and tension belong together; give both strengths, or neither")
    lattices = several("calibrate", "lattice", lattice, Lattice, "a lattice, from bd.connect, or several")
    if not lattices:
        raise InputError("calibrate: lattice is empty; give at least one lattice, such as bd.connect(particles)")
    for one in lattices:
        one.bodies.require_one("calibrate")
        _require_slender(one)
    instance("calibrate", "material", material, Material, "a bd.Material, or one of bd.materials")
    number("calibrate", "tolerance", tolerance, above=0.0, advice="a tolerance on ν above zero")
    if law is not None and not (isinstance(law, type) and issubclass(law, BondLaw)):
        raise InputError(
            f"law = {shown(law)}: not a bond law class; give a class, such as bd.{DEFAULT.__name__}, not an instance"
        )
    if search is not None:
        ends = array("calibrate", "search", search, wanted=_RANGE)
        if ends.shape != (2,) or not 0.0 < ends[0] < ends[1]:
            raise InputError(f"calibrate: search = {shown(search)}; give {_RANGE}")
        search = float(ends[0]), float(ends[1])
    reason = ""
    if law is None:
        for one in lattices:
            one.elements.refuse_cells(
                "calibrate: the lattice has cells, to which bd.CellBond(material) gives E and ν without calibration;"
                " use bd.connect without method='laguerre' for beams, or give law="
            )
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
    density, strength = element_density(lattices, material.rho), None
    if ucs is not None and tension is not None:
        strength = calibrate_bond_strength(
            lattices, calibrated, ucs=ucs, tension=tension, friction_angle=friction_angle, density=density
        )
    return Calibration(
        calibrated, density, material, parameter=free.name, table=tuple(trials[key] for key in sorted(trials)),
        responses=responses, slopes=slopes, reason=reason, strength=strength, friction_angle=friction_angle,
    )  # fmt: skip


def _require_slender(lattice: Lattice) -> None:
    """Reject specimens whose E and ν a tension test along x does not measure; accept all periodic cells.

    Raises:
        InputError: the specimen is too short, or has no faces x_min and x_max.
    """
    if lattice.particles.period is not None:
        return
    shape = lattice.particles.envelope
    instead = "calibrate on a periodic cell of the same packing, bd.pack(bd.Cell(...)), and use its law here"
    if not {"x_min", "x_max"} <= set(shape.faces):
        raise InputError(f"calibrate: a {type(shape).__name__} has no faces x_min and x_max to pull; {instead}")
    lower, upper = shape.bounds
    length, *widths = (float(extent) for extent in upper - lower)
    if length < _SLENDER * max(widths):
        raise InputError(
            f"calibrate: the specimen is {length:.4g} m long along x and {max(widths):.4g} m wide, too short for a"
            f" tension test, which needs a length of its width; {instead}, or on a longer specimen"
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
            f" {', '.join(sorted(known))} (E and {free.name} are calibrated, nu_mu= sets nu)"
        )
