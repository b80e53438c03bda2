"""Strengths calibrated on one packing and seen on others, and all laws side by side."""

from functools import reduce
from operator import getitem
from typing import Any

from book.forms import COUNT, MPA, Form, listed
from book.results import grouped, record
from book.row import Row, Rows
from book.tolerances import AtMost, Near

CALIBRATED = record("strength_calibration", takes="40 min")
BESIDE = record("laws_side_by_side", takes="20 min")
NOTCHED = record("notched_bars", "", "--count 1500", takes="35 min")
MEASUREMENTS = (CALIBRATED, BESIDE, NOTCHED)

_TWO = Form(style=".2f")
#: What a Mohr–Coulomb continuum of c = 14.3 MPa, φ = 35°, f_t = 4 MPa has [-].
CONTINUUM = 54.94 / 4.0
#: Of calibrations: runs, and what unseen packings may be off.
RUNS, UNSEEN = 15, {"ucs": 0.05, "brazilian": 0.10}
_NAMES = {"ucs": "UCS", "brazilian": "Brazilian"}
_SOURCE = {"ucs": ("§4.1", "55 MPa"), "brazilian": ("§4.2", "4 MPa")}


def calibrated() -> Rows:
    targets = CALIBRATED.at("targets")
    for one in CALIBRATED.at("cases"):
        words = f"{one['words']}, {one['count'] or '12 000 and 9000'} elements"
        if one["reached"]:
            yield Row(f"{words}: runs of two tests each", CALIBRATED.of(len(one["runs"])), AtMost(RUNS), COUNT)
        best = one["runs"][one["best"] - 1]["measured"]
        ratios = [run["measured"]["ucs"] / run["measured"]["brazilian"] for run in one["runs"] if not run["failed"]]
        reason = "" if one["reached"] else (
            f"of {len(ratios)} runs UCS is {_TWO.bare(min(ratios))} to {_TWO.bare(max(ratios))} times the Brazilian"
            " strength, where a factor of 13.75 is required"
        )  # fmt: skip
        for test, name in _NAMES.items():
            target, tolerance = targets[test]
            source, printed = _SOURCE[test]
            yield Row(f"{words}: {name} of packing 1", CALIBRATED.of(best[test]), Near(absolute=tolerance), MPA,
                source=source, paper=target, printed=printed, reason=reason)  # fmt: skip
            if unseen := one["unseen"]:
                packings = listed(other["seed"] for other in unseen)
                yield Row(f"{words}: {name} of packings {packings}, not seen", CALIBRATED.each(unseen, test),
                    Near(relative=UNSEEN[test]), MPA, source=source, paper=target, printed=printed)  # fmt: skip


def specimens() -> list[list[dict[str, Any]]]:
    """Results of each law, one per packing, with ratios of strengths and the share of broken bonds."""
    found = [
        one
        | {
            "ratio": one["ucs"]["peak"] / one["tension"]["peak"],
            "broken": one["ucs"]["broken_at_peak"] / one["bonds"],
        }
        for one in BESIDE.at("cases")
    ]
    return list(grouped(found, "words").values())


def beside() -> Rows:
    for ones in specimens():
        if ones[0]["law"] == "cells_soft":
            packings = f"{ones[0]['count']} elements, packings {listed(one['seed'] for one in ones)}"
            yield Row(f"UCS over direct tension: {ones[0]['words']}, {packings}", BESIDE.each(ones, "ratio"),
                Near(relative=0.05, target=CONTINUUM), _TWO)  # fmt: skip


def several(ones: list[dict[str, Any]], place: str, style: str, unit: float = 1.0) -> str:
    """Different numbers of packings at a place such as "ucs peak"."""
    found: list[Any] = [reduce(getitem, place.split(), one) for one in ones]
    return listed(dict.fromkeys(format(value / unit, style) for value in found))


def value(number: float) -> str:
    """A parameter: a stress in MPa, or as it is."""
    return f"{number / 1e6:.2f}" if number > 1e3 else f"{number:.3g}"


def interval(pair: list[float] | None) -> str:
    """The ends of an interval of a parameter."""
    return "–" if pair is None else f"{value(pair[0])} … {value(pair[1])}"


def slope(case: dict[str, Any], test: str, name: str) -> str:
    """Sensitivity of a strength to a parameter, where it is known."""
    known = case["sensitivities"]
    return "–" if known is None else Form(style="+.2f").bare(known[test][name])
