"""User-defined criteria: any function of the stress tensor."""

import inspect
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from types import FunctionType
from typing import Any

import numpy as np

from bondem._calls import callback
from bondem._checks import number, shown
from bondem.errors import InputError
from bondem.laws.failure.bilinear import Bilinear
from bondem.laws.failure.criterion import Criterion
from bondem.laws.failure.scatter import Normal, Weibull
from bondem.laws.failure.softening import TRIED, Softening, StressIndex, check_crack

_NAME = "StressCriterion"
# A function is tried at stresses of these sizes [Pa].
_SIZES = (1.0, 1e3, 1e6, 1e9)


@dataclass(frozen=True, init=False)
class StressCriterion(Criterion):
    """Cracking of facets of cells where a function of the stress reaches 1.

        function(σ*, **parameters) ≥ 1     σ* of `bd.Rankine`, for facets in tension

        def largest(stress, tension):
            return np.linalg.eigvalsh(stress)[2] / tension

        failure = bd.StressCriterion(largest, tension=4e6, fracture_energy=50.0)

    The stress is a symmetric matrix (3, 3) [Pa], in global axes, tension positive, as in `bd.cell_stress`. Numba
    compiles the function by itself, so it may use only features of Python and NumPy that Numba supports. Strengths
    that scatter divide the stress. A crack softens up to the opening 2 G_f / f_t, as for `bd.Rankine`. Here f_t is
    the least uniaxial tension along x, y or z at which the function reaches 1. Without a fracture energy a facet
    breaks at once.

    Facets of a cell without cracks are evaluated only in two cases. The function reaches 1 at twice the stress of the
    cell, or at twice that stress with a tension from all sides of a fifth of its size. An index must therefore not
    fall below 1 again along a growing stress. For bodies of cells only.

    Args:
        function: function of the stress and the parameters that returns the index [-]. NaN breaks a facet.
        fracture_energy: G_f [J/m²]; None for brittle facets.
        friction: μ on the faces of closed cracks [-].
        curve: softening curve of cracks; None for a straight line.
        scatter: scatter of strengths from facet to facet.
        **parameters: numbers, by the names of the function's arguments.

    Raises:
        InputError: The function cannot be compiled, or returns a value that is not finite at one of the stresses at
            which it is tried. Or it is 1 or more without stress, or stays below 1 in uniaxial tension. Or a parameter
            is not one of its arguments, or is not a number.
    """

    function: Callable[..., Any]
    fracture_energy: float | None
    friction: float
    curve: Bilinear | None
    parameters: Mapping[str, float] = field(hash=False)

    def __init__(
        self,
        function: Callable[..., Any],
        *,
        fracture_energy: float | None = None,
        friction: float = 0.0,
        curve: Bilinear | None = None,
        scatter: Weibull | Normal | None = None,
        **parameters: float,
    ) -> None:
        object.__setattr__(self, "function", function)
        object.__setattr__(self, "fracture_energy", fracture_energy)
        object.__setattr__(self, "friction", friction)
        object.__setattr__(self, "curve", curve)
        object.__setattr__(self, "scatter", scatter)
        object.__setattr__(self, "parameters", _own_parameters(function, parameters))
        self.__post_init__()
        check_crack(_NAME, fracture_energy, friction, curve)
        self._try()
        object.__setattr__(self, "_tension", min(self._surface.reached(direction) for direction in TRIED[:3]))
        if not math.isfinite(self._tension):
            raise InputError(
                f"{_NAME}: {self.name} stays below 1 in uniaxial tension, whatever its size; give an index that"
                " reaches 1 where the material fails, tension positive"
            )

    _tension: float = field(init=False, repr=False, compare=False)

    @property
    def name(self) -> str:
        """Name of the function."""
        return str(getattr(self.function, "__qualname__", "the function"))

    @property
    def softening(self) -> Softening:
        return Softening(
            tension=self._tension, fracture_energy=self.fracture_energy or 0.0, friction=self.friction, slip=None,
            surface=self._surface, curve=self.curve,
        )  # fmt: skip

    @property
    def _surface(self) -> StressIndex:
        return StressIndex(function=self.function, values=tuple(self.parameters.values()))

    def _try(self) -> None:
        """Compile the function, and call it for some stresses."""
        values = tuple(self.parameters.values())
        try:
            compiled = callback(self.function, len(values)).function
        except Exception as error:  # whatever Numba says
            raise InputError(
                f"{_NAME}: {self.name} cannot be compiled ({_reason(error)}); give a function of a matrix (3, 3) and"
                " numbers that returns a number, in Python that Numba supports"
            ) from None

        def index(stress: np.ndarray) -> float:
            try:
                found = float(compiled(stress.copy(), *values))
            except Exception as error:  # the user's own
                raise InputError(
                    f"{_NAME}: {self.name} raises '{_reason(error)}' at a stress of {_listed(stress)} Pa; let it"
                    " return a number for any stress"
                ) from None
            if not math.isfinite(found):
                raise InputError(
                    f"{_NAME}: {self.name} is {found} at a stress of {_listed(stress)} Pa; let it return a finite"
                    " number for any stress"
                )
            return found

        at_rest = index(np.zeros((3, 3)))
        if at_rest >= 1.0:
            raise InputError(f"{_NAME}: {self.name} is {at_rest:g} without stress; give an index below 1 there")
        for size in _SIZES:
            for direction in TRIED:
                index(size * direction)
                index(-size * direction)


def _own_parameters(function: object, given: Mapping[str, object]) -> dict[str, float]:
    """Return parameters in the order of the function's arguments, with its defaults."""
    plain = getattr(function, "py_func", function)
    wanted = "a function of a stress (3, 3) and numbers that returns an index"
    if not isinstance(plain, FunctionType):
        raise InputError(f"{_NAME}: function = {shown(function)}; give {wanted}")
    arguments = list(inspect.signature(plain).parameters.values())
    if not arguments or any(one.kind is not inspect.Parameter.POSITIONAL_OR_KEYWORD for one in arguments):
        raise InputError(
            f"{_NAME}: {plain.__qualname__}{inspect.signature(plain)} has arguments that are not plain; give {wanted}"
        )
    names = [one.name for one in arguments[1:]]
    for name in given:
        if name not in names:
            raise InputError(
                f"{_NAME}: {plain.__qualname__} has no parameter '{name}'; give {', '.join(names) or 'none'}"
            )
    found = {}
    for one in arguments[1:]:
        value = given.get(one.name, one.default)
        if value is inspect.Parameter.empty:
            raise InputError(f"{_NAME}: {plain.__qualname__} needs '{one.name}'; give {one.name}=")
        found[one.name] = number(_NAME, one.name, value)
    return found


def _listed(stress: np.ndarray) -> str:
    return str((stress + 0.0).tolist())


def _reason(error: Exception) -> str:
    """Return the most informative line of an error."""
    lines = [line.strip() for line in str(error).splitlines() if line.strip()]
    told = "Failed in", "-", "During", "File", "This error", "For"
    telling = [line for line in lines if not line.startswith(told)]
    text = (telling or lines or [type(error).__name__])[0].partition(", defined at None")[0]
    return text if len(text) <= 120 else f"{text[:117]}..."
