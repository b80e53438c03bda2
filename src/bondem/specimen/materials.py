"""Library of materials with their sources, such as `bd.materials.granite` or `bd.materials.get("granite")`.

The values are nominal elastic constants at room temperature. Brittle materials scatter; the source of each material
states by how much. Replace values that you know better: `dataclasses.replace(bd.materials.granite, E=60e9)`.
"""

from typing import TYPE_CHECKING

from bondem._checks import instance, shown
from bondem._names import meant, no_attribute
from bondem.errors import InputError
from bondem.specimen.material import Material

fused_silica = Material(
    "fused silica", E=72.5e9, nu=0.17, rho=2201.0,
    source="André et al. (2012), Comput. Methods Appl. Mech. Engrg. 213-216, Table 1, density of section 6."
    " Makers' data sheets: E 72 to 73 GPa, ν 0.16 to 0.17, ρ 2200 to 2203 kg/m³",
)  # fmt: skip

soda_lime_glass = Material(
    "soda-lime glass", E=70e9, nu=0.2, rho=2500.0,
    source="EN 572-1, general properties of soda-lime silicate glass in building."
    " Other compositions and measurements: E 69 to 74 GPa, ν 0.20 to 0.24, ρ 2440 to 2530 kg/m³",
)  # fmt: skip

alumina = Material(
    "alumina", E=416e9, nu=0.231, rho=3984.0,
    source="Munro (1997), J. Am. Ceram. Soc. 80, 1919-1928 (NIST SRD 150): sintered α-Al₂O₃, at least 99.5 % pure and"
    " 98 % dense, at 20 °C; E ± 30 GPa. Less pure or dense grades: E 300 to 400 GPa, ρ 3600 to 3950 kg/m³",
)  # fmt: skip

concrete = Material(
    "concrete", E=40e9, nu=0.2, rho=2400.0,
    source="Celigueta et al. (2020), concrete of 50 MPa: E measured, ν assumed there. No density printed: 2400 kg/m³"
    " is usual for plain concrete. Other concretes: E 25 to 45 GPa, ν 0.15 to 0.22, ρ 2000 to 2600 kg/m³ (EN 206)",
)  # fmt: skip

granite = Material(
    "granite", E=69e9, nu=0.26, rho=2630.0,
    source="Lac du Bonnet granite in Potyondy and Cundall (2004), Int. J. Rock Mech. Min. Sci. 41, 1329-1364:"
    " E 69 ± 5.8 GPa, ν 0.26 ± 0.04. Other granites: E 40 to 75 GPa, ν 0.15 to 0.30, ρ 2600 to 2700 kg/m³",
)  # fmt: skip

steel = Material(
    "steel", E=210e9, nu=0.3, rho=7850.0,
    source="EN 1993-1-1, 3.2.6 (E, ν) and EN 1993-1-2, 3.2.2 (density): design values of structural steel."
    " Carbon and low-alloy steels: E 200 to 215 GPa, ν 0.27 to 0.30, ρ 7750 to 7870 kg/m³",
)  # fmt: skip

_LIBRARY = {key: value for key, value in globals().items() if isinstance(value, Material)}


def names() -> tuple[str, ...]:
    """Return the names of all materials in the library.

    `get` accepts these names, and so does the key `preset` in the table `[material]` of a study.
    """
    return tuple(sorted(_LIBRARY))


def get(name: str) -> Material:
    """Return the material of a given name. Spaces, hyphens and capitals do not matter.

    Raises:
        InputError: The library has no material of this name.
    """
    instance("materials.get", "name", name, str, "the name of a material, as text")
    key = name.strip().lower().replace(" ", "_").replace("-", "_")
    if key not in _LIBRARY:
        hint = meant(key, _LIBRARY) or f"; choose from {', '.join(names())}"
        raise InputError(f"no material {shown(name)} in the library{hint} (or give your own: bd.Material)")
    return _LIBRARY[key]


if not TYPE_CHECKING:  # type checkers detect wrong names themselves

    def __getattr__(name: str) -> None:
        raise AttributeError(no_attribute("bd.materials", name, __dir__()), name=name)


def __dir__() -> list[str]:
    return [*names(), "get", "names"]
