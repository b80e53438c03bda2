"""User-defined criterion: any function of the stress tensor."""

import inspect
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from types import BuiltinFunctionType
from typing import Any

import numpy as np

from bondem._checks import number, shown
from bondem._types import Floats
from bondem.damage.bilinear import Bilinear
from bondem.damage.cohesive_softening import TRIED, Softening, StressIndex, check_crack
from bondem.damage.criteria.criterion import Criterion
from bondem.damage.scatter import Normal, Weibull
from bondem.errors import InputError

_NAME = "StressCriterion"
# Sizes of the trial stresses at which a function is checked [Pa].
_SIZES = (1.0, 1e3, 1e6, 1e9)
# Lowest possible address of a function: systems leave the first page unused.
_FIRST_ADDRESS = 4096


@dataclass(frozen=True, init=False)
class StressCriterion(Criterion):
    """Cracking of facets of cells where a function of the stress reaches 1.

        function(σ*, **parameters) ≥ 1     σ* of `bd.Rankine`, for facets in tension

        def largest(stress, tension):
            return np.linalg.eigvalsh(stress)[:, 2] / tension

        failure = bd.StressCriterion(largest, tension=4e6, fracture_energy=50.0)

    The function takes the stresses of many facets at once: symmetric matrices (k, 3, 3) [Pa], in global axes, tension
    positive, as in `bd.cell_stress`. It returns k indices. It is called at most twice per step, and only in steps in
    which a facet is near to failure. Where strengths scatter, it receives the stress over the strength factor of the
    facet. A crack softens up to the opening 2 G_f / f_t, as for `bd.Rankine`. Here f_t is the least uniaxial tension
    along x, y or z at which the function reaches 1. Without a fracture energy a facet breaks at once.

    The address of a C function, such as of cffi or `numba.cfunc`, is faster than a function of Python. Its parameters
    are those given, in this order::

        void function(int64_t count, const double *stress, const double *parameter, double *index)

    To save time, the facets of a cell without cracks are skipped while the size √(σ:σ) of its stress is far below all
    sizes at which the function reaches 1. An index that has reached 1 must therefore not fall below 1 again as the
    stress grows. For bodies of cells only.

    Args:
        function: function of the stresses and the parameters that returns the indices [-], or the address of a C
            function. NaN breaks a facet.
        fracture_energy: G_f [J/m²]; None for brittle facets.
        friction: μ on the faces of closed cracks [-].
        curve: softening curve of cracks; None for a straight line.
        scatter: scatter of strengths from facet to facet.
        **parameters: numbers, by the names of the function's arguments.

    Raises:
        InputError: The function does not take stresses (k, 3, 3) or does not return k numbers, such as a function of
            one stress. Or an index is not finite at one of the stresses at which it is tried, is 1 or more without
            stress, or stays below 1 in uniaxial tension. Or a parameter is not one of its arguments, or is not a
            number. Or energy, friction or curve are invalid as for `bd.Rankine`.
    """

    function: Callable[..., Any] | int
    fracture_energy: float | None
    friction: float
    curve: Bilinear | None
    parameters: Mapping[str, float] = field(hash=False)

    def __init__(
        self, function: Callable[..., Any] | int, *, fracture_energy: float | None = None, friction: float = 0.0,
        curve: Bilinear | None = None, scatter: Weibull | Normal | None = None, **parameters: float,
    ) -> None:  # fmt: skip
        own = _own_parameters(function, parameters)
        given = {"fracture_energy": fracture_energy, "friction": friction, "curve": curve, "scatter": scatter}
        for name, value in {"function": function, **given, "parameters": own}.items():
            object.__setattr__(self, name, value)
        self.__post_init__()
        check_crack(_NAME, fracture_energy, friction, curve)
        self._try()
        object.__setattr__(self, "_tension", float(self._surface.reached(TRIED[:3]).min()))
        if not math.isfinite(self._tension):
            raise InputError(
                f"{_NAME}: {self.name} stays below 1 in uniaxial tension, whatever its size; give an index that"
                " reaches 1 where the material fails, tension positive"
            )

    _tension: float = field(init=False, repr=False, compare=False)

    @property
    def name(self) -> str:
        """Name of the function."""
        if isinstance(self.function, int):
            return f"the C function at {self.function:#x}"
        return str(getattr(self.function, "__qualname__", "the function"))

    @property
    def softening(self) -> Softening:
        return Softening(
            tension=self._tension, fracture_energy=self.fracture_energy or 0.0, friction=self.friction, slips=(),
            surface=self._surface, curve=self.curve,
        )  # fmt: skip

    @property
    def _surface(self) -> StressIndex:
        return StressIndex(function=self.function, values=tuple(self.parameters.values()))

    def _try(self) -> None:
        """Raise InputError if the function is unusable at trial stresses."""
        sizes = np.array(_SIZES)[:, None, None, None]
        stress = np.concatenate([np.zeros((1, 3, 3)), *(sizes * TRIED), *(-sizes * TRIED)])
        found = self._tried(stress)
        if found.shape != (len(stress),):
            raise InputError(
                f"{_NAME}: {self.name} returns an array {found.shape} for stresses {stress.shape}; give a function of"
                f" many stresses that returns {len(stress)} indices for them, such as"
                " np.linalg.eigvalsh(stress)[:, 2] / tension"
            )
        if found[0] >= 1.0:
            raise InputError(f"{_NAME}: {self.name} is {found[0]:g} without stress; give an index below 1 there")
        wrong = np.flatnonzero(~np.isfinite(found))
        if len(wrong):
            raise InputError(
                f"{_NAME}: {self.name} is {found[wrong[0]]} at a stress of {(stress[wrong[0]] + 0.0).tolist()} Pa;"
                " let it return a finite number for any stress"
            )

    def _tried(self, stress: Floats) -> Floats:
        """Return the result of the function for stresses (k, 3, 3); raise InputError if it raises any error."""
        try:
            return self._surface.indices(stress.copy())
        except Exception as error:  # any error of the user's function
            raise InputError(
                f"{_NAME}: {self.name} raises '{_reason(error)}' for stresses {stress.shape}; give a function of many"
                " stresses (k, 3, 3) that returns k indices for any stress"
            ) from None


def _own_parameters(function: object, given: Mapping[str, object]) -> dict[str, float]:
    """Return the parameters by name, with defaults, in the order of the function's arguments.

    Parameters of a C function stay in the order in which they are given.
    """
    if isinstance(function, int) and function >= _FIRST_ADDRESS:
        return {name: number(_NAME, name, value) for name, value in given.items()}
    wanted = "a function of stresses (k, 3, 3) and numbers that returns k indices, or the address of a C function"
    if not isinstance(function, Callable) or isinstance(function, type | BuiltinFunctionType):
        raise InputError(f"{_NAME}: function = {shown(function)}; give {wanted}")
    called, signature = getattr(function, "__qualname__", type(function).__name__), inspect.signature(function)
    arguments = list(signature.parameters.values())
    if not arguments or any(one.kind is not inspect.Parameter.POSITIONAL_OR_KEYWORD for one in arguments):
        raise InputError(f"{_NAME}: {called}{signature} has arguments that are not plain; give {wanted}")
    names = [one.name for one in arguments[1:]]
    for name in given:
        if name not in names:
            raise InputError(f"{_NAME}: {called} has no parameter '{name}'; give {', '.join(names) or 'none'}")
    found = {}
    for one in arguments[1:]:
        value = given.get(one.name, one.default)
        if value is inspect.Parameter.empty:
            raise InputError(f"{_NAME}: {called} needs '{one.name}'; give {one.name}=")
        found[one.name] = number(_NAME, one.name, value)
    return found


def _reason(error: Exception) -> str:
    """Return the first line of an error, cut to 120 characters."""
    lines = [line.strip() for line in str(error).splitlines() if line.strip()]
    text = (lines or [type(error).__name__])[0]
    return text if len(text) <= 120 else f"{text[:117]}..."
