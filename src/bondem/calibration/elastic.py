"""Elastic calibration: bond parameters with which a specimen has given E, ν and ρ."""

from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from bondem.calibration.density import element_density
from bondem.calibration.free_parameter import FreeParameter
from bondem.errors import InputError
from bondem.labtests.tension import Tension, static_tension
from bondem.laws.bond import BondLaw
from bondem.laws.euler_bernoulli import EulerBernoulli
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material


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
        parameter: name of the parameter found for ν, "radius_ratio" or "kappa".
        table: every evaluation, in ascending order of the parameter.
        tensions: the tension test of each calibrating lattice with the final law.
    """

    law: BondLaw
    density: float
    parameter: str
    table: tuple[Trial, ...]
    tensions: tuple[Tension, ...]

    @property
    def E(self) -> float:
        """Young's modulus achieved, mean over the lattices [Pa]."""
        return float(np.mean([tension.E for tension in self.tensions]))

    @property
    def nu(self) -> float:
        """Poisson's ratio achieved, mean over the lattices [-]."""
        return float(np.mean([tension.nu for tension in self.tensions]))

    @property
    def E_std(self) -> float:
        """Standard deviation of E over the lattices [Pa]; 0 for one."""
        return _deviation([tension.E for tension in self.tensions])

    @property
    def nu_std(self) -> float:
        """Standard deviation of ν over the lattices [-]; 0 for one."""
        return _deviation([tension.nu for tension in self.tensions])


def calibrate(
    lattice: Lattice | Sequence[Lattice],
    material: Material,
    *,
    law: type[BondLaw] = EulerBernoulli,
    nu_mu: float = 0.3,
    search: tuple[float, float] | None = None,
    tolerance: float = 1e-5,
    **parameters: Any,
) -> Calibration:
    """Find the law of a family with which specimens have the E, ν and ρ of a material.

    In linear elasticity ν does not depend on E_μ and E is proportional to it: one root in the law's free
    parameter gives ν (r̃, or κ for parallel and contact bonds), one division gives E. Moduli are those of
    `labtests.static_tension` along x; over several lattices, their means are calibrated.

    Args:
        lattice: the specimen, or several packings of it.
        material: the target.
        law: family of bond laws.
        nu_mu: Poisson's ratio of the bonds, ν_μ [-]; it hardly matters for Euler–Bernoulli bonds.
        search: between which values of the free parameter to look; r̃ in (0.1, 0.9), κ in (0.5, 50).
        tolerance: on ν [-].
        **parameters: further parameters of the law, held fixed (radius_rule=, alpha_s=, radius_ratio= of
            parallel bonds, which is 1 unless given).

    Raises:
        UnreachableTargetError: the law cannot give this ν on this lattice; the message names its reach.
        InputError: no lattice, or a parameter the law does not have or that calibration sets.
    """
    lattices = [lattice] if isinstance(lattice, Lattice) else list(lattice)
    if not lattices:
        raise InputError("calibrate needs at least one lattice; pass bd.connect(particles)")
    if not (isinstance(law, type) and issubclass(law, BondLaw)):
        raise InputError(f"law = {law!r}; pass a bond law class, such as bd.EulerBernoulli, not an instance")
    if search is not None and not 0.0 < search[0] < search[1]:
        raise InputError(f"search = {search}; give two positive values, the smaller first")
    free = FreeParameter.of(law, search)
    fixed = _fixed_parameters(law, free, parameters) | {"nu": nu_mu}
    trials: list[Trial] = []

    def bonds(E: float, value: float) -> BondLaw:
        varied: dict[str, Any] = {"E": E, free.name: value}
        return law(**fixed, **varied)

    def measure(candidate: BondLaw) -> list[Tension]:
        return [static_tension(specimen, candidate) for specimen in lattices]

    def nu_of(value: float) -> float:
        tensions = measure(bonds(material.E, value))
        E, nu = (float(np.mean([getattr(t, name) for t in tensions])) for name in ("E", "nu"))
        trials.append(Trial(value, E / material.E, nu))
        return nu

    value = free.solve(nu_of, material.nu, tolerance=tolerance, who=f"{law.__name__} bonds")
    ratio = next(trial.stiffness_ratio for trial in trials if trial.value == value)
    calibrated = bonds(material.E / ratio, value)
    return Calibration(
        law=calibrated,
        density=element_density(lattices, material.rho),
        parameter=free.name,
        table=tuple(sorted(trials, key=lambda trial: trial.value)),
        tensions=tuple(measure(calibrated)),
    )


def _fixed_parameters(law: type[BondLaw], free: FreeParameter, given: dict[str, Any]) -> dict[str, Any]:
    known = {item.name for item in fields(law)} - {"E", "nu", free.name}
    if free.name == "radius_ratio":
        known -= {"radius"}
    unknown = sorted(set(given) - known)
    if unknown:
        raise InputError(
            f"calibrate: {law.__name__} has no fixed parameter '{unknown[0]}'; choose from"
            f" {', '.join(sorted(known))} (E and {free.name} are what is looked for, nu_mu= sets nu)"
        )
    if free.name != "radius_ratio" and not {"radius_ratio", "radius"} & set(given):
        return {"radius_ratio": 1.0} | given
    return dict(given)


def _deviation(values: list[float]) -> float:
    return float(np.std(values, ddof=1)) if len(values) > 1 else 0.0
