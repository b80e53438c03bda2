"""Plausibility of values: warnings about values that are possible but so unusual that their unit may be wrong."""

import math
import re
import warnings

from bondem._names import users_line
from bondem.errors import StrengthWarning, UnitWarning

# Young's modulus [Pa] and density [kg/m³], to the order of magnitude, by a word in the name of a material.
_USUAL: dict[str, tuple[float, float]] = {
    "alumina": (400e9, 3950.0),
    "aluminium": (70e9, 2700.0),
    "aluminum": (70e9, 2700.0),
    "basalt": (70e9, 2900.0),
    "brass": (100e9, 8500.0),
    "concrete": (35e9, 2400.0),
    "copper": (120e9, 8900.0),
    "diamond": (1050e9, 3500.0),
    "glass": (70e9, 2500.0),
    "granite": (60e9, 2650.0),
    "ice": (9e9, 917.0),
    "iron": (150e9, 7500.0),
    "limestone": (40e9, 2500.0),
    "marble": (50e9, 2700.0),
    "mortar": (25e9, 2100.0),
    "quartz": (75e9, 2500.0),
    "rock": (40e9, 2600.0),
    "sandstone": (20e9, 2300.0),
    "silica": (72e9, 2200.0),
    "steel": (205e9, 7850.0),
    "titanium": (115e9, 4500.0),
    "wood": (10e9, 600.0),
}
# Materials of these kinds contain any amount of air and may be a thousand times softer and lighter.
_POROUS = ("aerogel", "foam", "powder", "porous", "wool")
# Three orders of magnitude, less what materials of one name differ by.
_FAR = 300.0

# All solids: gels to diamond, aerogels to osmium; and the speed √(E/ρ) of a wave in a rod, in which a wrong unit of
# either shows.
_MODULUS, _DENSITY, _SPEED = (1e3, 2e12), (0.1, 3e4), (0.3, 5e4)

# Extent from which the numbers of a shape look like millimetres [m].
_LARGE = 10.0

# Radius of a bond over the mean radius of the elements.
_BOND_RADIUS = (1e-3, 30.0)

# Stone, glass, ceramics, concrete: stiffer than this [Pa] and lighter than that [kg/m³]; and what they take at most
# to part, with a margin of three [J/m²].
_STIFF, _LIGHT, _TOUGH = 1e10, 5e3, 1e3
# Strength over E: a tenth of it tears atoms apart; what is beyond the other is meant never to break.
_IDEAL, _NEVER = 0.1, 10.0


def question_material(name: str, E: float, rho: float) -> None:
    """Warn about a modulus [Pa] or density [kg/m³] that no solid has, or off by 10³ for the named material."""
    words = re.findall(r"[a-z]+", name.lower())
    named = [word for word in words if word in _USUAL]
    if named and not any(word in _POROUS for word in words):
        for symbol, value, usual, unit in zip("Eρ", (E, rho), _USUAL[named[-1]], ("Pa", "kg/m³"), strict=True):
            if not 1.0 / _FAR < value / usual < _FAR:
                _question(
                    f"material '{name}': {symbol} = {value:.4g} {unit}, but {named[-1]} has about {usual:.2g} {unit}"
                    "; check its unit (SI)"
                )
                return
    for symbol, value, (low, high), unit in (
        ("E", E, _MODULUS, "Pa"), ("ρ", rho, _DENSITY, "kg/m³"), ("√(E/ρ)", math.sqrt(E / rho), _SPEED, "m/s"),
    ):  # fmt: skip
        if not low <= value <= high:
            _question(
                f"material '{name}': {symbol} = {value:.4g} {unit}; solids have {low:.2g} to {high:.2g} {unit}"
                "; check the units of E and ρ (SI)"
            )
            return


def question_size(owner: str, extent: float) -> None:
    """Warn about a shape so large that its lengths are likely millimetres.

    Args:
        owner: class of the shape.
        extent: largest extent of the shape along an axis [m].
    """
    if extent >= _LARGE:
        _question(
            f"{owner}: the shape is {extent:.4g} m long; lengths are in metres: if its numbers are millimetres, write"
            " 10e-3 instead of 10"
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
        _question(text, StrengthWarning)


def strength_doubts(strength: float, E: float, density: float, energy: float) -> list[str]:
    """Return doubts about strength and fracture energy, one sentence each; none for soft or heavy materials."""
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


def _question(text: str, category: type[Warning] = UnitWarning) -> None:
    warnings.warn(text, category, stacklevel=users_line())
