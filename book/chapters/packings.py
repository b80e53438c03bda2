"""Packings: figures 5 to 8 of André et al. (2012), and what the literature has."""

import math
from typing import Any

from book.forms import COUNT, RATIO, ROUNDING, SECONDS, Form, Said
from book.outcomes import TESTS, holds, range_of
from book.results import Measurement, study
from book.row import Measured, Row, Rows
from book.tolerances import AtLeast, AtMost, Near, So

_DRAWN = {name: f"study_{name}" for name in ("packings", "histograms", "dispersion")}
DISPERSION = study("dispersion", _DRAWN, options="--spreads 0,0.1,0.15,0.2,0.25,0.3", takes="18 min")
WIDE = study("dispersion", {}, options="--spreads 0.4 --seeds 3", kept="dispersion_wide", takes="25 min")
REFINEMENT = study("refinement", {"refinement": "study_refinement"}, takes="20 min")
PACKING = Measurement("packing", "python benchmarks/packing.py", "5 min")
METHODS = Measurement("packing_methods", "python benchmarks/packing.py --methods", "10 min")
MEASUREMENTS = (DISPERSION, WIDE, REFINEMENT, PACKING, METHODS, TESTS)

DENSITY = Form(style=".4f")
CONTACTS = Form(style=".2f")
EXCESS = Form(style=".2f")
YES = Said("rejected", "accepted")


def _runs(shape: str, count: int, target: dict[str, Any], name: str) -> Measured:
    found = PACKING.at("packings", {"library": "bondem", "shape": shape, "count": count, "target": target})
    return PACKING.of(*(run[name] for run in found["runs"]))


def _other(name: str, **request: Any) -> Measured:
    return METHODS.of(*(run[name] for run in METHODS.at("packings", request, "runs")))


def jammed() -> Rows:
    cell = ("cell", 10_000, {"jamming": True})
    density = Near(target=0.636, absolute=0.005)
    row = {"source": "literature", "paper": "0.636 ± 0.005", "form": DENSITY}
    contacts = {
        "source": "isostatic",
        "paper": 6.0,
        "printed": "6",
        "form": CONTACTS,
        "tolerance": Near(absolute=0.1),
    }
    yield Row("φ, default method, 2000, five seeds", range_of("jammed density"), density, **row)
    yield Row("φ, default method, 10 000, three seeds", _runs(*cell, "volume_fraction"), density, **row)
    yield Row("φ, growth", _other("volume_fraction", method="growth"), density, **row)
    yield Row("φ, compression", _other("volume_fraction", method="compression"), density, **row)
    yield Row("z without rattlers, 2000, five seeds", range_of("jammed contacts"), **contacts)
    yield Row("z without rattlers, 10 000, three seeds", _runs(*cell, "backbone_coordination_number"), **contacts)
    yield Row("largest overlap, of the mean radius", _runs(*cell, "largest_overlap"), AtMost(1e-3), ROUNDING)


def cylinder() -> Rows:
    near = {"source": "§4.3", "paper": 0.635, "form": RATIO, "tolerance": Near(absolute=0.008)}
    yield Row("φ, 10 000", _runs("cylinder", 10_000, {}, "volume_fraction"), **near)
    yield Row("φ, 20 000", _other("volume_fraction", shape="cylinder"), **near)
    yield Row("φ, 100 000", _runs("cylinder", 100_000, {}, "volume_fraction"), **near)
    yield Row("z, 10 000 and 100 000", PACKING.of(*(
        z for n in (10_000, 100_000) for z in _runs("cylinder", n, {}, "coordination_number").values)),
        Near(absolute=0.05), CONTACTS, source="§4.3", paper=6.2, printed="6.2")  # fmt: skip
    yield Row("largest overlap when jammed, of the mean radius",
        _runs("cylinder", 10_000, {"jamming": True}, "largest_overlap"), AtMost(1e-3), ROUNDING)  # fmt: skip


def _agreement(target: str, name: str) -> Measured:
    limit = REFINEMENT.at("limits", target, name)
    free = REFINEMENT.at("summary", {"target": target, "periodic": True}, name)
    return REFINEMENT.of((limit["value"] - free["mean"]) / math.hypot(limit["error"], free["std"] or 0.0))


def refinement() -> Rows:
    ended = "the paper's value is that of 20 000 elements, where its curve still increases"
    overlaps = [one["largest_overlap"]["mean"] for one in REFINEMENT.at("summary") if one["target"] == "jamming"]
    found = REFINEMENT.at("limits", "contacts", "volume_fraction")
    yield Row("φ, cube, limit in N at z = 6.2", REFINEMENT.of(found["value"], scatter=found["error"]),
        Near(absolute=0.008), DENSITY, source="fig. 8a", paper=0.635, printed="0.635", reason=ended)  # fmt: skip
    for symbol, words, target, name in (
        ("φ", "z = 6.2", "contacts", "volume_fraction"), ("φ", "jamming", "jamming", "volume_fraction"),
        ("z", "jamming", "jamming", "coordination_number"),
    ):  # fmt: skip
        yield Row(f"{symbol}, {words}: limit less that without walls, in standard errors", _agreement(target, name),
            AtMost(2.0), Form(style="+.1f"))  # fmt: skip
    at = {"target": "contacts", "periodic": False, "count": 10_000}
    yield Row("φ, cube of 10 000 at z = 6.2", REFINEMENT.summary(at, "volume_fraction"), Near(absolute=0.008),
        DENSITY, source="fig. 8a", paper=0.635, printed="0.635")  # fmt: skip
    yield Row("z, cube of 10 000 at z = 6.2", REFINEMENT.summary(at, "coordination_number"), Near(absolute=0.05),
        CONTACTS, source="fig. 8b", paper=6.2, printed="6.2")  # fmt: skip
    yield Row("e, cube of 10 000 at z = 6.2, eq (11)", REFINEMENT.summary(at, "isotropy_error"), AtMost(),
        Form(style=".2g"), source="fig. 8c", paper=0.0032, note="vacuous: no fabric can exceed 0.003115")  # fmt: skip
    yield Row("largest overlap of jamming targets, of the mean radius", REFINEMENT.of(min(overlaps), max(overlaps)),
        AtMost(1e-3), Form(style=".2g"))  # fmt: skip
    yield Row("packings that failed", REFINEMENT.number("failed"), AtMost(0.0), COUNT)


def dispersion() -> Rows:
    luding = "Luding's ω₀ ≈ 0.15, which the paper cites, is half a range: κ = 30 %"
    for spread, tolerance, paper, reason in (
        (0.0, AtLeast(0.3), "ordered", ""), (0.1, AtLeast(0.3), "ordered", ""),
        (0.15, AtMost(0.3), "none from here", luding), (0.2, AtMost(0.3), "none", luding),
        (0.25, AtMost(0.3), "none", ""), (0.3, AtMost(0.3), "none", ""),
    ):  # fmt: skip
        ours = DISPERSION.number("summary", {"spread": spread}, "core_rms_excess", "mean")
        yield Row(f"order at κ = {100 * spread:.0f} %: rms excess of the core", ours, tolerance, EXCESS,
            source="fig. 7", paper=paper, reason=reason)  # fmt: skip
    yield Row("order at κ = 40 %, seeds 1 to 3: rms excess of the core",
        WIDE.summary({"spread": 0.4}, "core_rms_excess"), AtMost(0.3), EXCESS, source="fig. 7",
        paper="none")  # fmt: skip


def rejected() -> Rows:
    sheared = DISPERSION.of(float(DISPERSION.at("summary", {"spread": 0.0}, "passed") == 0))
    yield Row("an FCC crystal, with the reason", holds("FCC crystal is rejected"), So(), YES)
    yield Row("sheared equal spheres, with the reason", sheared, So(), YES)
    yield Row("a layered packing, with the reason", holds("layered packing is rejected"), So(), YES)


def time() -> Rows:
    for count, words, limit in ((10_000, "10 000", 8.0), (100_000, "100 000", 120.0)):
        cylinder = {"shape": "cylinder", "count": count, "target": {}}
        yield Row(f"cylinder of {words}, median of three", PACKING.number("packings", cylinder, "seconds_median"),
            AtMost(limit), SECONDS)  # fmt: skip
    for words, target in (("φ = 0.6", {"volume_fraction": 0.6}), ("jamming", {"jamming": True})):
        yield Row(f"2000 spheres to {words}: spheropack's time over ours, median",
            PACKING.number("against_spheropack", {"target": target}, "ratio_median"), AtLeast(1.0))  # fmt: skip
