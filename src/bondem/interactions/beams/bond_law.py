"""Common part of all linear bond laws: a bond is a cylinder, and a law is four stiffnesses and a contact point.

Chen et al. (2022) show that the parallel-bond, Euler–Bernoulli and Timoshenko models differ only in four stiffnesses
of the bond (normal, shear, bending, twisting) and in its contact point. A law is therefore data, computed once per
bond; `core/laws/beam.hpp` computes the forces of all laws.
"""

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any, ClassVar, Literal, Self

import numpy as np

from bondem._checks import choice, number
from bondem._plausibility import physical
from bondem._types import PerBond
from bondem.errors import InputError
from bondem.interactions.beams.free_parameter import RADIUS_RATIO, FreeParameter

RadiusRule = Literal["mean", "pair_min", "pair_mean"]
Formulation = Literal["total", "incremental"]


@dataclass(frozen=True)
class BondGeometry:
    """Geometry of the bonds in the reference configuration, the input of a law.

    Attributes:
        length: distance of the centres [m], shape (m,).
        radius_i, radius_j: element radii at the two ends [m], shape (m,).
        mean_radius: mean radius R̄ of all elements of the body of each bond [m], shape (m,).
    """

    length: PerBond
    radius_i: PerBond
    radius_j: PerBond
    mean_radius: PerBond

    def take(self, chosen: np.ndarray) -> "BondGeometry":
        """Return the geometry of the bonds `chosen`, by indices or by a mask."""
        return BondGeometry(
            self.length[chosen], self.radius_i[chosen], self.radius_j[chosen], self.mean_radius[chosen]
        )


@dataclass(frozen=True)
class BondStiffness:
    """Stiffnesses and contact points of bonds by a law, each of shape (m,).

    Attributes:
        kn: normal stiffness [N/m].
        ks: shear stiffness at the contact point [N/m].
        kb: bending stiffness [N·m].
        kt: twisting stiffness [N·m].
        lever: distance of the contact point from centre i [m].
        radius: bond radius [m].
    """

    kn: PerBond
    ks: PerBond
    kb: PerBond
    kt: PerBond
    lever: PerBond
    radius: PerBond

    def put(self, chosen: np.ndarray, other: "BondStiffness") -> None:
        """Overwrite the stiffnesses of the bonds `chosen` (indices or mask) with the rows of `other`, in place."""
        for item in fields(self):
            getattr(self, item.name)[chosen] = getattr(other, item.name)

    def take(self, chosen: np.ndarray) -> "BondStiffness":
        """Return the stiffnesses of the bonds `chosen`, by indices or by a mask."""
        return BondStiffness(**{item.name: getattr(self, item.name)[chosen] for item in fields(self)})

    @classmethod
    def empty(cls, count: int) -> "BondStiffness":
        """Return a table for `count` bonds, filled with NaN."""
        return cls(**{item.name: np.full(count, np.nan) for item in fields(cls)})


@dataclass(frozen=True, kw_only=True)
class BondLaw(ABC):
    """A linear elastic bond of circular section.

    Attributes:
        E: Young's modulus of the bond, E_μ [Pa].
        nu: Poisson's ratio of the bond, ν_μ [-].
        radius_ratio: bond radius over a mean radius, r̃ [-]; `radius_rule` selects the mean.
        radius: bond radius [m], instead of `radius_ratio`.
        radius_rule: "mean" (R̄ of the body, André), "pair_min" (smaller of the two elements, PFC) or
            "pair_mean".
        formulation: "total" (exact gradient of one energy) or "incremental" (rates integrated step by step,
            as in the papers).
        title: common name of such bonds (class attribute).
        free: parameter that calibration varies (class attribute).
        moments: True if bonds resist bending and twisting (class attribute).
        moments_at_contact: True if the moment that may break a bond is that at its contact point, False for the
            larger one of its ends (class attribute).

    Raises:
        InputError: A value is outside its physical range, or both or neither of the two radii are given.
    """

    title: ClassVar[str]
    free: ClassVar[FreeParameter] = RADIUS_RATIO
    moments: ClassVar[bool] = True
    moments_at_contact: ClassVar[bool] = False

    E: float
    nu: float
    radius_ratio: float | None = None
    radius: float | None = None
    radius_rule: RadiusRule = "mean"
    formulation: Formulation = "total"

    def __post_init__(self) -> None:
        law = type(self).__name__
        physical(law, "E", self.E)
        number(law, "nu", self.nu, above=-1.0, below=0.5, advice="a Poisson's ratio in (-1, 0.5)")
        if (self.radius_ratio is None) == (self.radius is None):
            raise InputError(f"{law}: give either radius_ratio= [-] or radius= [m]")
        for name in ("radius_ratio", "radius"):
            if getattr(self, name) is not None:
                number(law, name, getattr(self, name), above=0.0)
        choice(law, "radius_rule", self.radius_rule, RadiusRule)
        choice(law, "formulation", self.formulation, Formulation)

    @property
    def G(self) -> float:
        """Shear modulus of the bond [Pa]."""
        return self.E / (2.0 * (1.0 + self.nu))

    @classmethod
    def with_radius(cls, given: Mapping[str, Any]) -> dict[str, Any]:
        """Return the parameters that calibration fixes: those given, and r̃ = 1 if no radius is given or free."""
        if cls.free.is_radius or {"radius_ratio", "radius"} & set(given):
            return dict(given)
        return {RADIUS_RATIO.name: 1.0} | dict(given)

    @classmethod
    def at(cls, value: float, *, E: float, nu: float, **fixed: Any) -> Self:
        """Return the law at a value of its free parameter.

        Args:
            value: value of the free parameter [-].
            E, nu: Young's modulus [Pa] and Poisson's ratio [-] of the bonds.
            **fixed: further parameters; see `with_radius`.
        """
        given = cls.with_radius(fixed)
        given[cls.free.name] = value
        return cls(E=E, nu=nu, **given)

    def bond_radius(self, bonds: BondGeometry) -> PerBond:
        """Return the radius of each bond [m], shape (m,)."""
        if self.radius is not None:
            return np.full_like(bonds.length, self.radius)
        assert self.radius_ratio is not None
        if self.radius_rule == "mean":
            base = bonds.mean_radius
        elif self.radius_rule == "pair_min":
            base = np.minimum(bonds.radius_i, bonds.radius_j)
        else:
            base = 0.5 * (bonds.radius_i + bonds.radius_j)
        return self.radius_ratio * base

    @abstractmethod
    def stiffness(self, bonds: BondGeometry) -> BondStiffness:
        """Return the four stiffnesses and the contact point of each bond."""

    def _of_beams(self, bonds: BondGeometry, section: "Section", ks: PerBond) -> BondStiffness:
        """Return the stiffnesses of beams with the shear stiffness ks [N/m], (m,), and contact points at L/2."""
        L = bonds.length
        return BondStiffness(
            kn=self.E * section.area / L, ks=ks, kb=self.E * section.second_moment / L,
            kt=self.G * section.polar_moment / L, lever=0.5 * L, radius=section.radius,
        )  # fmt: skip


@dataclass(frozen=True)
class Section:
    """A full circular section of radius r: A = πr², I = πr⁴/4, J = 2I.

    Attributes:
        radius: radius [m], shape (m,).
    """

    radius: PerBond

    @property
    def area(self) -> PerBond:
        """Area A [m²], shape (m,)."""
        return np.pi * self.radius**2

    @property
    def second_moment(self) -> PerBond:
        """Second moment of area I [m⁴], shape (m,)."""
        return 0.25 * np.pi * self.radius**4

    @property
    def polar_moment(self) -> PerBond:
        """Polar moment J [m⁴], shape (m,)."""
        return 0.5 * np.pi * self.radius**4
