"""Plausibility of values: warnings about values that are possible but so unusual that their unit may be wrong."""

import math
import re
import sys
from dataclasses import dataclass, replace

from bondem._checks import number
from bondem._names import is_internal, warn_user
from bondem.errors import StrengthWarning, UnitWarning

# Young's modulus [Pa] and density [kg/m³], to the order of magnitude, by a word in the name of a material.
_USUAL: dict[str, tuple[float, float]] = {
    "alumina": (400e9, 3950.0), "aluminium": (70e9, 2700.0), "aluminum": (70e9, 2700.0), "basalt": (70e9, 2900.0),
    "brass": (100e9, 8500.0), "concrete": (35e9, 2400.0), "copper": (120e9, 8900.0), "diamond": (1050e9, 3500.0),
    "glass": (70e9, 2500.0), "granite": (60e9, 2650.0), "ice": (9e9, 917.0), "iron": (150e9, 7500.0),
    "limestone": (40e9, 2500.0), "marble": (50e9, 2700.0), "mortar": (25e9, 2100.0), "quartz": (75e9, 2500.0),
    "rock": (40e9, 2600.0), "sandstone": (20e9, 2300.0), "silica": (72e9, 2200.0), "steel": (205e9, 7850.0),
    "titanium": (115e9, 4500.0), "wood": (10e9, 600.0),
}  # fmt: skip
# Materials of these kinds contain any amount of air or water and may be a million times softer and lighter.
_SOFT = ("aerogel", "foam", "gel", "hydrogel", "powder", "porous", "rubber", "wool")
# Least factor of a wrong unit: 10³ over the differences between materials of one name.
_FAR = 300.0


@dataclass(frozen=True)
class _Range:
    """Range of a quantity, beyond which its unit may be wrong.

    Attributes:
        unit: SI unit.
        advice: advice on a value that is not positive.
        low, high: lowest and highest plausible value; those of all usual solids are between.
        slips: units of data sheets in which a value beyond the range may have been given, and their sizes in SI
            units, the more likely one first.
    """

    unit: str
    advice: str
    low: float
    high: float
    slips: tuple[tuple[str, float], ...] = ()

    def doubt(self, name: str, value: float, *, explained: bool = True, written: str = "") -> str:
        """Return a sentence about an implausible value, or "".

        The value 1, usual in dimensionless models, raises no doubt. Values that no unit of data sheets explains raise
        doubt only with `explained=False`. `written` is the text with a unit from which the value was read, if any.
        """
        meant = self.meant(value)
        if self.low <= value <= self.high or value == 1.0 or (explained and not meant):
            return ""
        words = f"{self.low:.2g} to {self.high:.2g} {self.unit}"
        if math.isinf(self.high):
            words = f"{self.low:.2g} {self.unit} or more"
        meant = self.capitals(written) if written else meant
        return f"{name} = {value:.4g} {self.unit}; solids have {words}{meant or self.check}"

    def meant(self, value: float) -> str:
        """Return the value in SI units that was likely meant, as the end of a sentence, or ""."""
        for unit, size in self.slips:
            if self.low <= value * size <= self.high:
                return f"; if {unit} is meant, write {value * size:.4g}"
        return ""

    def capitals(self, written: str) -> str:
        """Return the end of a sentence about a text such as "4 mPa": advice to write "4 MPa" or check the unit."""
        for unit, _ in self.slips:
            if written.lower().endswith(unit.lower()) and not written.endswith(unit):
                return f'; if {unit} is meant, write "{written[: -len(unit)]}{unit}"'
        return self.check

    @property
    def check(self) -> str:
        """Advice on a value that no other unit explains."""
        return f"; check its unit ({self.unit})"


_STRESS = ("GPa", 1e9), ("MPa", 1e6)
# Moduli from rubber to diamond, of contacts also less for larger time steps; densities from foam to osmium; strengths
# from weak joints, without an upper limit, as users prevent failure by huge ones; fracture energies from cleavage;
# largest extent of a specimen.
_MODULUS = _Range("Pa", "a positive Young's modulus in Pa", 1e6, 1e13, _STRESS)
_CONTACT = _Range("Pa", "a positive modulus of the contact in Pa", 1e3, 1e13, _STRESS)
_DENSITY = _Range("kg/m³", "a positive density in kg/m³", 25.0, 3e4, (("g/cm³", 1e3), ("t/mm³", 1e12)))
_STRENGTH = _Range("Pa", "a positive strength in Pa", 1e3, math.inf, _STRESS[1:])
_ENERGY = _Range("J/m²", "a positive energy in J/m²", 0.25, math.inf, (("N/mm", 1e3),))
_LONG = 1.0  # [m]
# Ranges of materials named by one of the words for soft materials.
_SOFT_MODULUS, _SOFT_DENSITY = replace(_MODULUS, low=1e3), replace(_DENSITY, low=0.1)
# Range of the wave speed √(E/ρ) of a rod, which reveals a wrong unit of E or ρ [m/s].
_SPEED = 0.3, 5e4
#: Quantities by the usual name of their argument; "contact" is the E of a contact law.
_RANGES: dict[str, _Range] = {
    "E": _MODULUS, "contact": _CONTACT, "density": _DENSITY, "tension": _STRENGTH, "compression": _STRENGTH,
    "hydrostatic": _STRENGTH, "cohesion": _STRENGTH, "shear": _STRENGTH, "pressure": _STRENGTH,
    "fracture_energy": _ENERGY, "fracture_energy_shear": _ENERGY,
}  # fmt: skip

# Functions and modules between the call of a class and the check of its values.
_MAKING = ("physical", "check_crack", "check_energies", "check_slip", "__post_init__", "__init__", "make", "guarded")
_COPYING = ("copy", "dataclasses")

# Range of the radius of a bond over the mean radius of the elements [-].
_BOND_RADIUS = (1e-3, 30.0)

# Stone, glass, ceramics and concrete: least modulus [Pa], largest density [kg/m³], and largest fracture energy with
# a margin of three [J/m²].
_STIFF, _LIGHT, _TOUGH = 1e10, 5e3, 1e3
# Strength over E [-]: that of perfect crystals, and the least one by which users prevent failure.
_IDEAL, _NEVER = 0.1, 10.0


def physical(owner: str, name: str, value: object, *, quantity: str = "", advice: str = "") -> float:
    """Return a positive value of a quantity of `_RANGES`; warn if the user's code gave it and its unit may be wrong.

    Args:
        owner: class or function that was called.
        name: name of the argument.
        value: value of the argument, in SI units.
        quantity: name in `_RANGES`; that of the argument by default.
        advice: end of the message about a value that is not positive; that of the quantity by default.

    Raises:
        InputError: The value is not a positive number.
    """
    known = _RANGES[quantity or name]
    found = number(owner, name, value, unit=known.unit, above=0.0, advice=advice or known.advice)
    if _by_user():
        question(owner, name, found, quantity=quantity)
    return found


def question(owner: str, name: str, value: float, *, quantity: str = "", written: str = "") -> None:
    """Warn about a positive value whose unit may be wrong; arguments as in `physical` and `_Range.doubt`."""
    doubt = _RANGES[quantity or name].doubt(name, value, written=written)
    if doubt:
        _question(f"{owner}: {doubt}" if owner else doubt)


def _by_user() -> bool:
    """Return True if code of the user creates the object under construction, False if code of bondem does."""
    frame = sys._getframe(1)
    while frame.f_back is not None and (
        frame.f_code.co_name in _MAKING or frame.f_globals.get("__name__") in _COPYING
    ):
        frame = frame.f_back
    return not is_internal(str(frame.f_globals.get("__name__")))


def question_material(name: str, E: float, rho: float) -> None:
    """Warn about a modulus E [Pa], density ρ [kg/m³] or wave speed √(E/ρ) that no solid has.

    A name of a known material also gives a warning if E or ρ differs from its usual value by a factor of 300.
    """
    words = re.findall(r"[a-z]+", name.lower())
    named = [word for word in words if word in _USUAL]
    soft = any(word in _SOFT for word in words)
    ranges = (_SOFT_MODULUS, _SOFT_DENSITY) if soft else (_MODULUS, _DENSITY)
    if named and not soft:
        for symbol, value, usual, known in zip("Eρ", (E, rho), _USUAL[named[-1]], ranges, strict=True):
            if not 1.0 / _FAR < value / usual < _FAR:
                _question(
                    f"material '{name}': {symbol} = {value:.4g} {known.unit}, but {named[-1]} has about {usual:.2g}"
                    f" {known.unit}{known.meant(value) or known.check}"
                )
                return
    for symbol, value, known in zip("Eρ", (E, rho), ranges, strict=True):
        doubt = known.doubt(symbol, value, explained=False)
        if doubt:
            _question(f"material '{name}': {doubt}")
            return
    low, high = _SPEED
    speed = math.sqrt(E / rho)
    if not low <= speed <= high:
        _question(
            f"material '{name}': √(E/ρ) = {speed:.4g} m/s; solids have {low:.2g} to {high:.2g} m/s; check the"
            " units of E and ρ (SI)"
        )


def is_long(extent: float) -> bool:
    """Return True if lengths of a specimen of this extent [m] are likely millimetres."""
    return extent > _LONG


def question_size(owner: str, extent: float) -> None:
    """Warn about a shape so large that its lengths are likely millimetres.

    Args:
        owner: class of the shape.
        extent: largest extent of the shape along an axis [m].
    """
    if is_long(extent):
        _question(
            f"{owner}: the shape is {extent:.4g} m long; lengths are in metres: if its numbers are millimetres, write"
            " 10e-3 instead of 10; for metres, ignore bd.errors.UnitWarning"
        )


def question_bond_radius(radius: float, mean_radius: float) -> None:
    """Warn about bonds that are far thicker or thinner than the elements that they join [m]."""
    low, high = _BOND_RADIUS
    if not low <= radius / mean_radius <= high:
        thick = "thicker" if radius > mean_radius else "thinner"
        _question(
            f"bonds of radius {radius:.3g} m are {max(radius / mean_radius, mean_radius / radius):.2g} times {thick}"
            f" than their elements, of mean radius {mean_radius:.3g} m; check the units of radius= and of the"
            " particles (metres)"
        )


def question_strength(strength: float, E: float, density: float, energy: float) -> None:
    """Warn about a tensile strength [Pa] or fracture energy [J/m²] that no stone, glass, ceramic or concrete has."""
    for text in strength_doubts(strength, E, density, energy):
        warn_user(text, StrengthWarning)


def strength_doubts(strength: float, E: float, density: float, energy: float) -> list[str]:
    """List doubts about strength [Pa] or energy [J/m²]; none if E < 10 GPa, density > 5000 kg/m³, strength > 10 E."""
    if E < _STIFF or density > _LIGHT or strength > _NEVER * E:
        return []
    if strength > _IDEAL * E:
        return [
            f"strength {strength:.3g} Pa is {strength / E:.2g} of E = {E:.3g} Pa, and no solid carries more than"
            " about a tenth: nothing will break; check the units of the strengths (Pa)"
        ]
    if energy > _TOUGH:
        return [
            f"a strength of {strength:.3g} Pa implies a fracture energy of {energy:.2g} J/m² and K_Ic ="
            f" {math.sqrt(E * energy) / 1e6:.2g} MPa√m with these elements; glass has about 8 J/m², ceramics 20 to"
            " 50, rock and concrete 10 to 300: hardly anything will break; print(bd.explain(model)) explains this"
        ]
    return []


def _question(text: str) -> None:
    warn_user(text, UnitWarning)
