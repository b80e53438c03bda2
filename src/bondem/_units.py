"""Quantities with units as text, such as "72.5 GPa", "5 mm", "2.2 g/cm^3", "35 deg" or "25 %".

Quantities are read exactly, as fractions, and then rounded: "72.5 GPa" is the float 72.5e9, "5 mm" the float 5e-3.
"""

import math
import re
from dataclasses import dataclass
from fractions import Fraction

from bondem._checks import number, shown
from bondem.errors import InputError

# Exponents of kg, m, s and rad.
_Dimension = tuple[int, int, int, int]
_NONE: _Dimension = (0, 0, 0, 0)

_PREFIXES = {
    "": 0, "n": -9, "u": -6, "µ": -6, "μ": -6, "m": -3, "c": -2, "d": -1, "h": 2, "k": 3, "M": 6, "G": 9, "T": 12,
}  # fmt: skip
# Size in SI units, and dimension, of units with and without prefixes.
_PREFIXED: dict[str, tuple[Fraction, _Dimension]] = {
    "m": (Fraction(1), (0, 1, 0, 0)),
    "g": (Fraction(1, 1000), (1, 0, 0, 0)),
    "s": (Fraction(1), (0, 0, 1, 0)),
    "Hz": (Fraction(1), (0, 0, -1, 0)),
    "N": (Fraction(1), (1, 1, -2, 0)),
    "Pa": (Fraction(1), (1, -1, -2, 0)),
    "J": (Fraction(1), (1, 2, -2, 0)),
    "rad": (Fraction(1), (0, 0, 0, 1)),
}
_POUND = Fraction(45_359_237, 100_000_000) * Fraction(980_665, 100_000)  # force [N]
_PLAIN: dict[str, tuple[Fraction, _Dimension]] = {
    "in": (Fraction(254, 10_000), (0, 1, 0, 0)),
    "inch": (Fraction(254, 10_000), (0, 1, 0, 0)),
    "ft": (Fraction(3048, 10_000), (0, 1, 0, 0)),
    "t": (Fraction(1000), (1, 0, 0, 0)),
    "min": (Fraction(60), (0, 0, 1, 0)),
    # the weight of a pound at standard gravity on a square inch
    "psi": (_POUND / Fraction(254, 10_000) ** 2, (1, -1, -2, 0)),
    "ksi": (1000 * _POUND / Fraction(254, 10_000) ** 2, (1, -1, -2, 0)),
    "bar": (Fraction(100_000), (1, -1, -2, 0)),
    # share of half a turn: the factor π, which is no fraction, is applied last
    "deg": (Fraction(1, 180), (0, 0, 0, 1)),
    "°": (Fraction(1, 180), (0, 0, 0, 1)),
    "%": (Fraction(1, 100), _NONE),
    "-": (Fraction(1), _NONE),
}
_EXAMPLES = {
    "m": "5 mm", "Pa": "72.5 GPa", "kg/m³": "2.2 g/cm^3", "s": "2 ms", "m/s": "10 cm/s", "-": "25 %", "rad": "35 deg",
}  # fmt: skip

_NUMBER = re.compile(r"[+-]?(\d+(_\d+)*\.?\d*|\.\d+)([eE][+-]?\d{1,3})?")
_FACTOR = re.compile(r"(?P<symbol>[^\W\d_]+|%|°|-)(\^|\*\*)?(?P<power>-?\d)?")
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
_LONGEST = 64  # characters of a quantity


@dataclass(frozen=True)
class _Unit:
    size: Fraction
    dimension: _Dimension
    degrees: bool = False

    def times(self, other: "_Unit", power: int) -> "_Unit":
        a, b, c, d = (mine + power * theirs for mine, theirs in zip(self.dimension, other.dimension, strict=True))
        return _Unit(self.size * other.size**power, (a, b, c, d), self.degrees or other.degrees)


def quantity(name: str, text: str, unit: str) -> float:
    """Convert a number with a unit to SI.

    Args:
        name: name of the quantity, for messages.
        text: a number and a unit: m, g, s, Hz, N, Pa, J, rad with prefixes, t, in, ft, psi, ksi, bar, min, deg, °, %;
            products (·, * or a blank), quotients (/) and powers (^2, ², 2).
        unit: the SI unit of the result, which also defines the dimension; "-" for a plain number or a percentage.

    Returns:
        The float nearest to the exact value, infinite if it exceeds all floats; degrees become π times a float [rad].

    Raises:
        InputError: The text has no number or no unit, or its unit is unknown or of another dimension.
    """
    wanted = _unit(unit)
    assert wanted is not None
    example = f'"{_EXAMPLES.get(unit, f"1 {unit}")}"'
    written = text.strip()
    found = _NUMBER.match(written)
    if found is None or len(written) > _LONGEST:
        raise InputError(f"{name} = {shown(text)} is not a number with a unit; give one such as {example}")
    rest = written[found.end() :].strip()
    if not rest:
        raise InputError(f"{name} = {shown(text)} is text without a unit; leave out the quotes, or write {example}")
    given = _unit(rest)
    if given is None and rest[0] == "," and rest[1:2].isdigit():
        raise InputError(f"{name} = {shown(text)} has a comma; write decimals with a point, such as {example}")
    if given is None:
        raise InputError(f"{name} = {shown(text)}: unit '{rest}' is not known; give {_kind(unit)} such as {example}")
    if given.dimension != wanted.dimension:
        raise InputError(
            f"{name} = {shown(text)}: {rest} is not a unit of [{unit}]; give {_kind(unit)} such as {example}"
        )
    try:
        value = float(Fraction(found.group().replace("_", "")) * given.size / wanted.size)
    except OverflowError:
        return math.copysign(math.inf, -1.0 if written.startswith("-") else 1.0)
    return value * math.pi if given.degrees else value


def length_unit(owner: str, unit: str | float) -> float:
    """Return a unit of length in metres, given by name or as a number; "mm" and 1e-3 are equivalent.

    Raises:
        InputError: The value is neither a unit of length nor a positive number.
    """
    advice = "the unit of length: 'm', 'cm', 'mm', 'um', 'in' ..., or its size in metres, 1e-3 for millimetres"
    if not isinstance(unit, str):
        return number(owner, "unit", unit, above=0.0, advice=advice)
    known = _unit(unit)
    if known is None or known.dimension != (0, 1, 0, 0):
        raise InputError(f"{owner}: unit = {shown(unit)}; give {advice}")
    return float(known.size)


def _kind(unit: str) -> str:
    return "a plain number or a percentage" if unit == "-" else f"a value in {unit} or a multiple,"


def _unit(text: str) -> _Unit | None:
    """Return the size and dimension of a unit, or None if it is unknown."""
    whole = _Unit(Fraction(1), _NONE)
    for place, quotient in enumerate(text.translate(_RAISED).split("/")):
        factors = [part for part in re.split(r"[·*\s]+", quotient.replace("**", "^").strip()) if part]
        if not factors:
            return None
        for factor in factors:
            found = _FACTOR.fullmatch(factor)
            known = _symbol(found["symbol"]) if found else None
            if found is None or known is None:
                return None
            power = int(found["power"] or 1)
            whole = whole.times(known, -power if place else power)
    # degrees cannot be part of a compound unit
    return None if whole.degrees and whole.dimension != (0, 0, 0, 1) else whole


def _symbol(symbol: str) -> _Unit | None:
    if symbol in _PLAIN:
        return _Unit(*_PLAIN[symbol], degrees=symbol in ("deg", "°"))
    for base, (size, dimension) in _PREFIXED.items():
        prefix = symbol[: -len(base)]
        if symbol.endswith(base) and prefix in _PREFIXES:
            return _Unit(size * Fraction(10) ** _PREFIXES[prefix], dimension)
    return None
