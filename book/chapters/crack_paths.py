"""Cracks that choose their path."""

import math
from collections.abc import Mapping

from book.forms import RATIO, Form, listed
from book.results import study
from book.row import Row, Rows
from book.tolerances import AtLeast, Between

_INTERFACES = tuple(f"interface_{ahead}_{kind}" for ahead in ("stiffer", "softer") for kind in ("strong", "weak"))
_PLATES = (
    "nooru_mohamed_4a", "nooru_mohamed_4b", "nooru_mohamed_4c", "arrea_ingraffea", "split_cube", *_INTERFACES,
    "hole_arrest",
)  # fmt: skip
PATHS = study("crack_paths", {name: f"paths_{name}" for name in _PLATES})
MEASUREMENTS = (PATHS,)

_LENGTH, _FORCE = Form("mm", 1e-3, ".0f"), Form("kN", 1e3, ".1f")
# Quantities that a row may have: words, and how they are printed.
_QUANTITIES: Mapping[str, tuple[str, Form]] = {
    "apart": ("height that the cracks span at mid-width", _LENGTH),
    "normal force": ("largest normal force", _FORCE),
    "force before": ("normal force before it is pulled", _FORCE),
    "peak": ("largest load", _FORCE),
    "off the notch": ("distance of the crack from the plane of the notch, at 0.75 to 0.95 of the depth", _LENGTH),
    "splitting stress": ("splitting stress 2 P/(π D t) over f_t", RATIO),
    "parted": ("parted length of the interface, both sides, over l", RATIO),
    "beyond": ("how far the crack goes beyond the interface, over l", RATIO),
    "K behind": ("K/K_Ic at which the crack starts behind the hole", RATIO),
    "rise": ("load for that, over the least one after the crack has reached the hole", RATIO),
    "K at the notch": ("K/K_Ic at the largest load before", RATIO),
}


def rows() -> Rows:
    """Claims of all cases."""
    for one in PATHS.at("cases"):
        claims = {claim["quantity"]: claim for claim in one["claims"]}
        if one["name"] in _INTERFACES:  # a crack that parts an interface does not cross it: one claim decides
            decides = "parted" if one["name"].endswith("weak") else "beyond"
            claims = {name: claim for name, claim in claims.items() if name == decides}
        for quantity, values in one["values"].items():
            known = [value for value in values if value is not None and math.isfinite(value)]
            if quantity in _QUANTITIES and quantity in claims and known:
                words, form = _QUANTITIES[quantity]
                claim, seed = claims[quantity], f"seed{'s' * (len(values) > 1)} {listed(one['seed'])}"
                within = AtLeast(claim["low"]) if claim["high"] is None else Between(claim["low"], claim["high"])
                yield Row(f"{one['title']}, {seed}, {max(one['count'])} cells: {words}", PATHS.of(*known), within,
                    form, paper=claim["words"])  # fmt: skip
