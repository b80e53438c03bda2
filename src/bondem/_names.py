"""Wrong names: messages that suggest the right one, for arguments, attributes of modules, and quantities.

Python names the wrong argument only. `suggesting` makes a public class or function list the arguments that it
accepts. It imports nothing but the standard library, as `import bondem` does.
"""

import difflib
import importlib
import inspect
import sys
from collections.abc import Callable, Collection, Iterable, Mapping
from functools import wraps
from types import FunctionType
from typing import Any

from bondem.errors import ArgumentError

# What other programs and papers call an argument, and what it may be called here.
_SYNONYMS: dict[str, tuple[str, ...]] = {
    "height": ("length",), "h": ("length",), "l": ("length",), "diameter": ("radius",), "r": ("radius",),
    "radii": ("radius",), "centers": ("position",), "centres": ("position",), "positions": ("position",),
    "n": ("count",), "number": ("count",), "num": ("count",), "density": ("rho",), "rho": ("density",),
    "young": ("E",), "youngs_modulus": ("E",), "modulus": ("E",), "poisson": ("nu",), "poissons_ratio": ("nu",),
    "time": ("duration",), "t_end": ("duration",), "output": ("out",), "path": ("out",), "bond": ("law",),
    "law": ("bond",), "bonds": ("pairs",), "dimensions": ("size",), "edges": ("size",), "k": ("count",),
    "cohesion": ("shear",), "phi": ("friction_angle",), "Gf": ("fracture_energy",), "G_f": ("fracture_energy",),
    "bc": ("boundary",), "boundary_conditions": ("boundary",), "loads": ("boundary",), "timestep": ("dt",),
}  # fmt: skip


def meant(name: str, known: Iterable[str]) -> str:
    """Return the known name nearest to a wrong one, as the end of a message: "; did you mean 'length'?", or ""."""
    if name.startswith("_"):  # tools ask every module for such names, and the search takes a millisecond
        return ""
    names = [one for one in known if not one.startswith("_")]
    by_case = {one.lower(): one for one in names}
    near: Collection[str] = [one for one in _SYNONYMS.get(name, ()) if one in names]
    near = near or difflib.get_close_matches(name, names, n=1)
    near = near or [by_case[one] for one in difflib.get_close_matches(name.lower(), by_case, n=1)]
    return f"; did you mean '{next(iter(near))}'?" if near else ""


def no_attribute(module: str, name: str, known: Iterable[str], instead: Mapping[str, str] | None = None) -> str:
    """Return the message for a name that a module does not have.

    Args:
        module: name of the module as users write it, "bd.materials".
        name: requested name.
        known: names of the module.
        instead: replacements of names of other packages.
    """
    other = (instead or {}).get(name)
    hint = f"; use {other}" if other else meant(name, known)
    return f"{module} has no attribute '{name}'{hint}" + ("" if hint else f"; dir({module}) lists its names")


def suggesting(home: str, name: str) -> Any:
    """Return a public class or function whose messages suggest arguments.

    A class keeps its identity and gets another `__init__`; a function is replaced in the module that defines it, so
    that it can be pickled.

    Args:
        home: module that defines it.
        name: name of the class or function.
    """
    module = importlib.import_module(home)
    thing = getattr(module, name)
    if isinstance(thing, type):
        own = vars(thing).get("__init__")
        if isinstance(own, FunctionType) and not hasattr(own, "_suggests"):
            setattr(thing, "__init__", _guarded(own, of_class=True))  # noqa: B010  a method, for type checkers
    elif isinstance(thing, FunctionType) and not hasattr(thing, "_suggests"):
        first, thing = sys.modules[thing.__module__], _guarded(thing, of_class=False)
        for one in (module, first):
            setattr(one, name, thing)
    return thing


def _guarded(function: Callable[..., Any], *, of_class: bool) -> Any:
    """Return a wrapper of the function that suggests arguments if the given ones cannot be bound."""

    @wraps(function)
    def guarded(*args: Any, **named: Any) -> Any:
        try:
            return function(*args, **named)
        except TypeError:
            owner = type(args[0]).__name__ if of_class and args else function.__name__
            message = _refusal(owner, function, args[1:] if of_class else args, named, of_class=of_class)
            if not message:
                raise
        raise ArgumentError(message)

    vars(guarded)["_suggests"] = True
    return guarded


def _refusal(
    owner: str, function: Callable[..., Any], args: tuple[Any, ...], named: dict[str, Any], *, of_class: bool
) -> str:
    """Return the fault in the names or the number of arguments; empty if both are right."""
    every = list(inspect.signature(function).parameters.values())[1 if of_class else 0 :]
    kinds = [one.kind for one in every]
    known = [one.name for one in every if one.kind not in (one.VAR_KEYWORD, one.VAR_POSITIONAL)]
    unknown = [key for key in named if key not in known]
    if unknown and inspect.Parameter.VAR_KEYWORD not in kinds:
        free = [one for one in known if one not in named]
        near = meant(unknown[0], free)
        rest = f" It takes {', '.join(known)}" if near else f"; it takes {', '.join(known)}"
        return f"{owner}: there is no argument '{unknown[0]}'{near}{rest}"
    places = [one.name for one in every if one.kind is one.POSITIONAL_OR_KEYWORD]
    if len(args) > len(places) and inspect.Parameter.VAR_POSITIONAL not in kinds:
        return f"{owner}: {len(args)} arguments without a name{_instead(owner, args, places, known)}"
    return ""


def _instead(owner: str, args: tuple[Any, ...], places: list[str], known: list[str]) -> str:
    """Return advice on too many positional arguments."""
    plain = all(isinstance(one, int | float) for one in args)
    if plain and len(args) == 3 and places == ["size"]:
        return f"; give one tuple: {owner}(({', '.join(f'{one:g}' for one in args)}))"
    rest = [one for one in known if one not in places]
    by_name = f", and by name {', '.join(f'{one}=' for one in rest)}" if rest else ""
    return f"; give at most {len(places)} ({', '.join(places)}){by_name}"


def users_line() -> int:
    """Return the `stacklevel` with which a warning of the caller names the line of the user outside the package."""
    level, frame = 1, sys._getframe(1)
    while frame is not None and _within(str(frame.f_globals.get("__name__"))):
        level, frame = level + 1, frame.f_back
    return level if frame is not None else 2


def _within(module: str) -> bool:
    """Return True if code belongs to the package, or to the decorators between it and its users."""
    return module.startswith("bondem.") or module in ("bondem", "contextlib", "functools")
