"""Wrappers of public names: their errors suggest arguments and show the line of the user.

Python only names a wrong argument, and the traceback of an input error has up to twenty frames, of which one is the
user's. `guard` wraps public functions, classes and methods once, when a public name is first used. This module
imports the standard library only, as `import bondem` does.
"""

import inspect
import os
import sys
from collections.abc import Callable, Iterable, Mapping
from functools import wraps
from types import FunctionType, TracebackType
from typing import Any

from bondem._names import is_internal, meant, no_member
from bondem.errors import ArgumentError, BondemError

# With this value of BONDEM_TRACEBACK all frames are shown.
_FULL = "full"
# Special methods that can reject values of users.
_SPECIAL = ("__init__", "__and__", "__or__", "__sub__", "__bool__", "__getitem__")
_done: set[str] = set()


def guard(public: Mapping[str, Iterable[str]]) -> None:
    """Wrap the public functions, and the methods of public classes, of all modules imported so far by `_guarded`.

    A class keeps its identity; its `__init__` and methods are replaced. A function is replaced in the module that
    defines it, so that it can be pickled.

    Args:
        public: names of public classes and functions by module.
    """
    for home, names in public.items():
        if home not in sys.modules or home in _done:
            continue
        _done.add(home)
        module = sys.modules[home]
        for name in names:
            thing = getattr(module, name, None)
            if isinstance(thing, type):
                _guard_class(thing)
            elif isinstance(thing, FunctionType) and not hasattr(thing, "_guarded"):
                guarded = _guarded(thing)
                for one in (module, sys.modules[thing.__module__]):
                    setattr(one, name, guarded)


def _guard_class(cls: type) -> None:
    """Wrap the methods of a class and its bases in bondem, and add `_missing`; skip exceptions and protocols."""
    if issubclass(cls, BaseException) or getattr(cls, "_is_protocol", False):
        return
    for one in cls.__mro__:
        if not one.__module__.startswith("bondem."):
            continue
        for name, item in list(vars(one).items()):
            if name.startswith("_") and name not in _SPECIAL:
                continue
            kind = type(item) if isinstance(item, classmethod | staticmethod) else None
            inner = item if kind is None else item.__func__
            if isinstance(inner, FunctionType) and not hasattr(inner, "_guarded"):
                fresh = _guarded(inner, bound=kind is not staticmethod, within=one.__name__)
                setattr(one, name, fresh if kind is None else kind(fresh))
    if not hasattr(cls, "__getattr__"):
        setattr(cls, "__getattr__", _missing)  # noqa: B010  type checkers shall find wrong names themselves


def _missing(self: object, name: str) -> Any:
    """Raise AttributeError with a suggestion, or the error of the property of that name."""
    if not name.startswith("_") and hasattr(type(self), name):
        return object.__getattribute__(self, name)
    raise AttributeError(no_member(self, name), name=name)


def _guarded(function: Callable[..., Any], *, bound: bool = False, within: str = "") -> Any:
    """Return a wrapper of a function that suggests arguments and shortens the traceback of errors.

    Args:
        function: the function.
        bound: True for a method, whose first argument is its object or class.
        within: class of a method.
    """
    construct = function.__name__ == "__init__"

    @wraps(function)
    def guarded(*args: Any, **named: Any) -> Any:
        refusal, shown, frames = "", None, None
        try:
            return function(*args, **named)
        except TypeError:
            owner = function.__name__ if not within else f"{within}.{function.__name__}"
            if construct and args:
                owner = type(args[0]).__name__
            refusal = _refusal(owner, function, args[1:] if bound else args, named, bound=bound)
            if not refusal:
                raise
        except BondemError as error:
            if os.environ.get("BONDEM_TRACEBACK") == _FULL:
                raise
            shown, frames = error, _shortened(error)
        if shown is None:
            raise ArgumentError(refusal)
        raise shown.with_traceback(frames)  # the environment variable BONDEM_TRACEBACK=full shows all frames

    vars(guarded)["_guarded"] = True
    return guarded


def _shortened(error: BaseException) -> TracebackType | None:
    """Return the frames of a traceback outside the package, and shorten those of its causes."""
    cause = error.__cause__ or (None if error.__suppress_context__ else error.__context__)
    if isinstance(cause, BondemError):
        cause.__traceback__ = _shortened(cause)
    frames: list[TracebackType] = []
    here = error.__traceback__
    while here is not None:
        if not is_internal(str(here.tb_frame.f_globals.get("__name__"))):
            frames.append(here)
        here = here.tb_next
    short = None
    for one in reversed(frames):
        short = TracebackType(short, one.tb_frame, one.tb_lasti, one.tb_lineno)
    return short


def _refusal(
    owner: str, function: Callable[..., Any], args: tuple[Any, ...], named: dict[str, Any], *, bound: bool
) -> str:
    """Return the fault in the names or the number of arguments; empty if both are right."""
    every = list(inspect.signature(function).parameters.values())[1 if bound else 0 :]
    kinds = [one.kind for one in every]
    known = [one.name for one in every if one.kind not in (one.VAR_KEYWORD, one.VAR_POSITIONAL)]
    unknown = [key for key in named if key not in known]
    if unknown and inspect.Parameter.VAR_KEYWORD not in kinds:
        if not known:
            return f"{owner}: there is no argument '{unknown[0]}'; it takes none"
        near = meant(unknown[0], [one for one in known if one not in named])
        rest = f" It takes {', '.join(known)}" if near else f"; it takes {', '.join(known)}"
        return f"{owner}: there is no argument '{unknown[0]}'{near}{rest}"
    places = [one.name for one in every if one.kind in (one.POSITIONAL_OR_KEYWORD, one.POSITIONAL_ONLY)]
    if len(args) > len(places) and inspect.Parameter.VAR_POSITIONAL not in kinds:
        count = f"{len(args)} argument{'s' * (len(args) > 1)}"
        return f"{owner}: {count} without a name{_instead(owner, args, places, known)}"
    return ""


def _instead(owner: str, args: tuple[Any, ...], places: list[str], known: list[str]) -> str:
    """Return advice on too many positional arguments."""
    plain = all(isinstance(one, int | float) for one in args)
    if plain and len(args) == 3 and len(places) == 1:
        return f"; give one tuple: {owner}(({', '.join(f'{one:g}' for one in args)}))"
    if not places:
        return f"; give them by name: {', '.join(f'{one}=' for one in known)}" if known else "; it takes none"
    rest = [one for one in known if one not in places]
    by_name = f", and by name {', '.join(f'{one}=' for one in rest)}" if rest else ""
    return f"; give at most {len(places)} ({', '.join(places)}){by_name}"
