"""Cracks that run, a bar that spalls, and a granite from one input."""

import math
from collections.abc import Mapping
from typing import Any

from book.chapters.strength import BRAZILIAN, DISCS
from book.forms import MPA, RATIO, Form, seeds
from book.results import grouped, record, study
from book.row import Row, Rows
from book.tolerances import AtLeast, AtMost, Between

BRANCHING = study("branching", {f"branching_{case}": f"branching_{case}" for case in ("A", "B30")})
FINE = study("branching", {"branching_B40": "branching_B40"}, options="--cases B40 --seeds 1", kept="branching_fine")
SPALL = study("spall", {"spall": "spall"})
GRANITE = study("granite", {"granite": "granite"})
LOSSES = record("kinds_of_loss", takes="20 min")
MEASUREMENTS = (BRANCHING, FINE, SPALL, LOSSES, GRANITE)

_NONE: Mapping[str, str] = {}
_RATIO = Form(style=".2f")
_FORMS = {"ucs": Form("MPa", 1e6, ".1f"), "direct_tension": MPA, "brazilian": MPA,
          "toughness": Form("MPa√m", 1e6, ".2f")}  # fmt: skip


def branching() -> Rows:
    """Plate A, sizes and packings."""
    runs = [one for one in BRANCHING.at("runs") if one["case"] == "A"]
    limit, counts = BRANCHING.at("limit"), list(dict.fromkeys(one["count"] for one in runs))
    branched = BRANCHING.of(sum(one["branched"] is not None for one in runs))
    bodies = f"A, {len(runs)} bodies of {min(counts)} to {max(counts)} cells"
    yield Row(f"{bodies}: the crack branches", branched, AtLeast(len(runs)), Form(f"of {len(runs)}", style=".0f"))
    yield Row(f"{bodies}: fastest 10 µs, over Rayleigh's {runs[0]['rayleigh']:.0f} m/s", BRANCHING.each(runs, "over"),
        AtMost(limit), _RATIO, paper=f"below {limit:g} (from memory)")  # fmt: skip


def losses() -> Rows:
    """Fracture, and crushing beyond it."""
    for (shape,), some in grouped(LOSSES.at("bars"), "shape").items():
        which = f"{shape} bars of {' and '.join(str(n) for n in dict.fromkeys(one['count'] for one in some))} cells"
        yield Row(f"{which}, {seeds([one['seed'] for one in some])}: crushing over fracture",
            LOSSES.each(some, "crushing"), AtMost(0.02), RATIO)  # fmt: skip


def granite(reasons: Mapping[str, str] = _NONE, beam: str = "beam of ") -> Rows:
    for one in GRANITE.at("cases"):
        deep = f", {beam}W = {1e3 * one['depth']:g} mm" if "depth" in one else ""
        if one["verdict"] != "–":
            yield Row(f"{one['quantity']}{deep}; {one['count']} cells, {seeds(one['seeds'])}",
                GRANITE.of(*one["values"]), Between(one["low"], one["high"]), _FORMS[one["test"]], paper=one["words"],
                reason=reasons.get(one["test"], ""))  # fmt: skip


def longest_discs() -> list[dict[str, Any]]:
    """Discs of the longest process zone."""
    longest = max(one["length"] for one in BRAZILIAN.at("cases"))
    return [one for one in BRAZILIAN.at("cases") if one["length"] == longest]


def split_of(share: float) -> float:
    """Strength of a disc by finite elements, over f_t."""
    return next(one["strength"] for one in DISCS.at("discs") if math.isclose(one["share"], share))
