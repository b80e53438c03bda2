"""Continuum materials, described by their elastic constants and density."""

import functools
import inspect
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeVar

from bondem._checks import instance, number, shown
from bondem._plausibility import question_material

_RANGES: dict[str, dict[str, Any]] = {
    "E": {"above": 0.0, "unit": "Pa", "advice": "a positive Young's modulus in Pa"},
    "nu": {"above": -1.0, "below": 0.5, "advice": "a Poisson's ratio in (-1, 0.5)"},
    "rho": {"above": 0.0, "unit": "kg/m³", "advice": "a positive density"},
}


@dataclass(frozen=True)
class Material:
    """An isotropic, linear elastic material.

    Attributes:
        name: name used in reports and messages.
        E: Young's modulus [Pa].
        nu: Poisson's ratio [-], strictly between -1 and 0.5.
        rho: density [kg/m³].
        source: origin of the values, as text.

    Raises:
        InputError: A value is not finite or is outside its physical range.

    Warns:
        UnitWarning: E or rho differs by a factor of 300 from that of a material of this name, or no solid has such
            a value.
    """

    name: str
    E: float
    nu: float
    rho: float
    source: str = ""

    def __post_init__(self) -> None:
        instance("Material", "name", self.name, str, "the name used in reports, as text")
        instance("Material", "source", self.source, str, "the origin of the values, as text")
        for name, options in _RANGES.items():
            value = number(f"material {shown(self.name)}", name, getattr(self, name), **options)
            object.__setattr__(self, name, value)
        question_material(" ".join(self.name.split()), self.E, self.rho)

    @property
    def G(self) -> float:
        """Shear modulus [Pa]."""
        return self.E / (2.0 * (1.0 + self.nu))


Given = TypeVar("Given")
Law = TypeVar("Law")
# Constants of a material by the names of the arguments that stand for them.
_CONSTANTS = {"E": "E", "nu": "nu", "rho": "rho", "density": "rho"}


def constant(name: str, given: Given | Material) -> Given | float:
    """Return the constant of a material for the argument `name`: "E", "nu", "rho" or "density".

    A value that is not a material is returned unchanged.
    """
    return getattr(given, _CONSTANTS[name]) if isinstance(given, Material) else given


def of_material(law: type[Law]) -> type[Law]:
    """Make a class accept a `Material` in place of one of its arguments E, nu, rho and density, or of all of them.

    `bd.CellBond(granite)` is `bd.CellBond(E=granite.E, nu=granite.nu)`.
    """
    made: Callable[..., None] = vars(law)["__init__"]
    signature = inspect.signature(made)
    named_only = all(one.kind is one.KEYWORD_ONLY for one in list(signature.parameters.values())[1:])

    @functools.wraps(made)
    def make(self: Any, *args: Any, **named: Any) -> None:
        material = next((one for one in (*args, *named.values()) if isinstance(one, Material)), None)
        if material is None:
            made(self, *args, **named)
            return
        rest = args[1:] if named_only and args[:1] == (material,) else args
        given = signature.bind_partial(self, *rest, **named)
        for name in signature.parameters:
            if name in _CONSTANTS:
                given.arguments[name] = constant(name, given.arguments.get(name, material))
        made(*given.args, **given.kwargs)

    setattr(law, "__init__", make)  # noqa: B010  a method, for type checkers
    return law
