"""Checks of input values. Each check returns the value in the required form, or raises an error of one line.

`owner` is the class or function that was called and `name` the argument, for the message.
"""

import errno
import math
import os
import stat
import sys
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, TypeVar, get_args

import numpy as np

from bondem._types import Floats
from bondem.errors import BondemError, InputError

# Largest magnitude of quantities in SI units, far beyond any physical one; products of larger ones may overflow.
_LARGEST = 1e100

# Texts with units belong to study files and the command line.
_NOT_TEXT = "; in Python quantities are numbers in SI units, such as 70e9 for '70 GPa'"

Kind = TypeVar("Kind")


def shown(value: object) -> str:
    """Format a value for a message as one line of at most 80 characters; objects of bondem by their first line."""
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, np.ndarray) and value.ndim:
        return f"array of {value.dtype}, shape {value.shape}"
    try:
        written = repr(value)
    except ValueError:  # Python writes no integers of more digits than this
        written = f"an integer of more than {sys.get_int_max_str_digits()} digits"
    if type(value).__module__.startswith("bondem."):
        written = written.partition("\n")[0]
    text = " ".join(written.split())
    return text if len(text) <= 80 else f"{text[:77]}..."


def number(
    owner: str, name: str, value: object, *, unit: str = "", above: float | None = None, least: float | None = None,
    below: float | None = None, advice: str = "",
) -> float:  # fmt: skip
    """Return a finite number within bounds.

    Args:
        owner: class or function that was called; may be empty.
        name: name of the argument.
        value: value of the argument.
        unit: unit of the number, for the message.
        above, least: lower bound, exclusive or inclusive.
        below: upper bound, exclusive.
        advice: end of the message, after "give"; made from the bounds by default.

    Raises:
        InputError: The value is no number (text, truth values), NaN, infinite, beyond 10^±100, or out of bounds.
    """
    found = _real(value)
    if (
        found is not None
        and possible(np.array(found))
        and (above is None or found > above)
        and (least is None or found >= least)
        and (below is None or found < below)
    ):
        return found
    measure = f" {unit}" if unit and found is not None else ""
    wanted = advice or _bounds(above, least, below) + (f" [{unit}]" if unit else "")
    if isinstance(value, str) and value.strip()[:1].isdigit():
        wanted += _NOT_TEXT
    if found is not None and math.isfinite(found) and not possible(np.array(found)):
        measure += ", beyond any quantity in SI units"
    raise _fault(owner, name, value, wanted, measure)


def _fault(owner: str, name: str, value: object, wanted: str, remark: str = "") -> InputError:
    """Return the error for an unfit value; its message has the value, the `remark`, and what is `wanted` instead."""
    where = f"{owner}: {name}" if owner else name
    return InputError(f"{where} = {shown(value)}{remark}; give {wanted}")


def _real(value: object) -> float | None:
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value.item()
    if isinstance(value, bool | np.bool_) or not isinstance(value, int | float | np.integer | np.floating):
        return None
    try:
        return float(value) if math.isfinite(value) else math.nan
    except OverflowError:
        return math.inf


def _bounds(above: float | None, least: float | None, below: float | None) -> str:
    if below is not None:
        bracket, low = ("(", above) if above is not None else ("[", least)
        return f"a number below {below:g}" if low is None else f"a number in {bracket}{low:g}, {below:g})"
    if above is not None:
        return "a positive number" if above == 0.0 else f"a number above {above:g}"
    if least is not None:
        return "a number of zero or more" if least == 0.0 else f"a number of at least {least:g}"
    return "a finite number"


def count(owner: str, name: str, value: object, *, least: int = 0, advice: str = "") -> int:
    """Return an argument that must be a whole number.

    Raises:
        InputError: The value is not a whole number, is below `least`, or is 2^62 or more.
    """
    found = _real(value)
    if found is None or not abs(found) < 2.0**62 or found != round(found) or found < least:
        raise _fault(owner, name, value, advice or f"a whole number of at least {least}")
    return int(found)


def vector(owner: str, name: str, value: object, *, unit: str = "", advice: str = "") -> tuple[float, float, float]:
    """Return an argument that must be three finite components.

    Raises:
        InputError: The value is not three finite components.
    """
    wanted = advice or "three finite components" + (f" [{unit}]" if unit else "")
    found = _numbers(value)
    if found is None or found.shape != (3,) or not possible(found):
        raise _fault(owner, name, value, wanted)
    x, y, z = found.tolist()
    return x, y, z


def unit_vector(owner: str, name: str, value: object) -> Floats:
    """Return a direction as a unit vector, (3,).

    Raises:
        InputError: The value is not three finite components, or has no length.
    """
    found = np.array(vector(owner, name, value))
    size = float(np.linalg.norm(found))
    if size == 0.0:
        raise InputError(f"{owner}: {name} has no length; give a direction such as (1, 0, 0)")
    return found / size


def array(owner: str, name: str, value: object, *, wanted: str) -> Floats:
    """Return a copy of an argument that must be numbers, as an array of any shape; `wanted` ends the message.

    Raises:
        InputError: The value is no array of real numbers: text, truth values, a ragged list or an object.
    """
    found = _numbers(value)
    if found is None:
        raise _fault(owner, name, value, wanted, " holds no numbers")
    return found


def _numbers(value: object) -> Floats | None:
    try:
        found = np.asarray(value)
    except (TypeError, ValueError, OverflowError):
        return None
    if found.size == 0 and found.dtype.kind in "fiu":
        return found.astype(float)
    return np.array(found, dtype=float, order="C") if found.dtype.kind in "fiu" else None


def possible(values: Floats) -> bool:
    """Return True if all values are finite, and 0 or of a magnitude between 10^-100 and 10^100."""
    size = np.abs(values)
    return bool((np.isfinite(values) & (size <= _LARGEST) & ((size == 0.0) | (size >= 1.0 / _LARGEST))).all())


def instance(owner: str, name: str, value: object, kinds: type[Kind] | tuple[type[Kind], ...], wanted: str) -> Kind:
    """Return an argument that must have one of the given types; `wanted` ends the message.

    Raises:
        InputError: The value has another type.
    """
    if not isinstance(value, kinds):
        raise _fault(owner, name, value, wanted)
    return value


def several(
    owner: str, name: str, value: object, kinds: type[Kind] | tuple[type[Kind], ...], wanted: str
) -> tuple[Kind, ...]:
    """Return one value or several values of the given types as a tuple, empty for None; `wanted` ends the message.

    Raises:
        InputError: A value has another type.
    """
    if value is None:
        return ()
    if isinstance(value, kinds) or not isinstance(value, Iterable) or isinstance(value, str | Mapping):
        return (instance(owner, name, value, kinds, wanted),)
    items = value.ravel() if isinstance(value, np.ndarray) else value
    return tuple(instance(owner, name, item, kinds, wanted) for item in items)


def choice(owner: str, name: str, value: object, words: Any) -> Any:
    """Return an argument that must be one of several words.

    Args:
        owner: class or function that was called.
        name: name of the argument.
        value: value of the argument.
        words: the `Literal` type with which a signature declares them, or a sequence.

    Raises:
        InputError: The value is not one of the words.
    """
    options = get_args(words) or words
    if not isinstance(value, str) or value not in options:
        raise InputError(f"{owner}: {name} = {shown(value)}; choose from {', '.join(filter(None, options))}")
    return value


def place(name: str, value: object) -> Path:
    """Return an argument that must be a path.

    Raises:
        InputError: The value is neither text nor a path, or contains a null character.
    """
    if not isinstance(value, str | Path) or "\0" in str(value):
        raise InputError(f"{name} = {shown(value)}; give a path, as text or pathlib.Path")
    return Path(value)


def require_file(path: Path, what: str, error: type[BondemError] = InputError) -> None:
    """Check that a file exists and can be read, before a reader opens it.

    Args:
        path: the file.
        what: name of the kind of file, such as "run file".
        error: type of the error.

    Raises:
        BondemError: there is no such file, it is a folder or a pipe, or it cannot be read.
    """
    try:
        found = stat.S_ISREG(os.stat(path).st_mode)
        reason = None if os.access(path, os.R_OK) else os.strerror(errno.EACCES)
    except (FileNotFoundError, NotADirectoryError):
        found, reason = False, None
    except OSError as refused:  # a folder that may not be entered, a loop of links, a name that is too long
        found, reason = True, refused.strerror
    if not found:
        raise error(f"path = '{path}': there is no {what}; check the path")
    if reason is not None:
        raise error(f"path = '{path}': the {what} cannot be read ({reason}); check the path and its permissions")
