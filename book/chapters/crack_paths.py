"""Cracks that choose their path."""

import math
from collections.abc import Mapping
from typing import Any

from book.chapter import Figure, Section
from book.forms import Form
from book.results import Measurement, study
from book.row import Row
from book.tolerances import AtLeast, Between

_INTERFACES = tuple(f"interface_{ahead}_{kind}" for ahead in ("stiffer", "softer") for kind in ("strong", "weak"))
_PLATES = (
    "nooru_mohamed_4a", "nooru_mohamed_4b", "nooru_mohamed_4c", "arrea_ingraffea", "split_cube", *_INTERFACES,
    "hole_arrest",
)  # fmt: skip
PATHS = study("crack_paths", {name: f"paths_{name}" for name in _PLATES})
MEASUREMENTS: tuple[Measurement, ...] = (PATHS,)

_LENGTH, _FORCE, _RATIO = Form("mm", 1e-3, ".0f"), Form("kN", 1e3, ".1f"), Form(style=".3f")
# Quantities that a row may have: words, and how they are printed.
_QUANTITIES: Mapping[str, tuple[str, Form]] = {
    "apart": ("height that the cracks span at mid-width", _LENGTH),
    "normal force": ("largest normal force", _FORCE),
    "force before": ("normal force before it is pulled", _FORCE),
    "peak": ("largest load", _FORCE),
    "off the notch": ("distance of the crack from the plane of the notch, at 0.75 to 0.95 of the depth", _LENGTH),
    "splitting stress": ("splitting stress 2 P/(π D t) over f_t", _RATIO),
    "parted": ("parted length of the interface, both sides, over l", _RATIO),
    "beyond": ("how far the crack goes beyond the interface, over l", _RATIO),
    "K behind": ("K/K_Ic at which the crack starts behind the hole", _RATIO),
    "rise": ("load for that, over the least one after the crack has reached the hole", _RATIO),
    "K at the notch": ("K/K_Ic at the largest load before", _RATIO),
}


def section() -> Section:
    """The section of the chapter on published fracture tests."""
    cases = PATHS.at("cases")
    return Section(
        title="Cracks that choose their path",
        before=(
            "Slabs of cells, one packing each. `validation/cases` states inputs and corridors. Original reports of"
            " the two published tests could not be read: corridors are those of figures that later simulations"
            " reprint, and therefore wide. Corridors of the other cases are theory, or a continuum with one cohesive"
            " crack."
        ),
        rows=tuple(row for one in cases for row in _rows(one)),
        after=(
            "Nooru-Mohamed 4c: with f_t = 3.0 MPa a shear force of 27.5 kN bends a section 10 mm below the upper edge"
            " by 3.9 MPa. Nothing may fail within 25 mm of the upper and the lower edge, and one crack follows it"
            " below, while none leaves the left notch. The distance between cracks counts that crack and is no"
            " agreement: the pattern of 4c is not that of the test. In 4a the cracks of both notches meet; 4b has one"
            " crack from each notch, as the test. A crack parts a weak interface before a stiffer part and goes"
            " through strong ones, as it should; a weak interface before a softer part it goes through too, by 0.7 l"
            " until the load has fallen to a tenth of its peak. The hole lets the crack start behind it at a lower"
            " load than the criterion of blunt notches gives, and three times that at which the crack reaches it."
            " Both are equilibria."
        ),
        figures=tuple(
            Figure(f"paths_{one['name']}.png", f"{one['title']}: load curve, and the crack") for one in cases
        ),
    )  # fmt: skip


def _rows(one: dict[str, Any]) -> list[Row]:
    """Rows of the claims of a case, and of what is shown beside."""
    claims = {claim["quantity"]: claim for claim in one["claims"]}
    found, seeds = [], ", ".join(map(str, one["seed"]))
    for quantity, values in one["values"].items():
        known = [value for value in values if value is not None and math.isfinite(value)]
        if quantity not in _QUANTITIES or not known:
            continue
        words, form = _QUANTITIES[quantity]
        case = f"{one['title']}, seed{'s' * (len(values) > 1)} {seeds}, {max(one['count'])} cells: {words}"
        claim = claims.get(quantity)
        if one["name"] in _INTERFACES and quantity != ("parted" if one["name"].endswith("weak") else "beyond"):
            claim = None  # a crack that parts an interface does not cross it: one claim decides
        if claim is None:
            continue
        high = claim["high"]
        tolerance = AtLeast(claim["low"]) if high is None else Between(claim["low"], high)
        found.append(Row(case=case, paper=claim["words"], ours=PATHS.of(*known), form=form, tolerance=tolerance))
    return found
