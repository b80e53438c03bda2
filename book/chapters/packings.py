"""Packings: figures 5 to 8 of André et al. (2012), and what the literature has."""

import math
from typing import Any

from book.chapter import Chapter, Figure, Section
from book.forms import COUNT, PLAIN, ROUNDING, SECONDS, Form, Said
from book.outcomes import TESTS, holds, range_of
from book.results import Measurement, study
from book.row import Measured, Row
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


def chapter() -> Chapter:
    """The chapter."""
    return Chapter(
        name="packings",
        title="Packings: figures 5 to 8",
        summary=(
            "Random packings have the density and contacts of the literature, crystals are distinguished from "
            "them, and with increasing numbers of elements density and contacts approach those of packings without "
            "walls. Figures and tables of all sizes are in [studies.md](studies.md)."
        ),
        misses=(
            "The density of infinitely many elements exceeds the value that the paper reads at 20 000 elements. "
            "Packings with 15 and 20 % spread of radii are still ordered, where the paper sees no order."
        ),
        sections=(_jammed(), _cylinder(), _refinement(), _dispersion(), _rejected(), _time()),
    )


def _runs(shape: str, count: int, target: dict[str, Any], name: str) -> Measured:
    found = PACKING.at("packings", {"library": "bondem", "shape": shape, "count": count, "target": target})
    return PACKING.of(*(run[name] for run in found["runs"]))


def _other(name: str, **request: Any) -> Measured:
    return METHODS.of(*(run[name] for run in METHODS.at("packings", request, "runs")))


def _jammed() -> Section:
    cell = ("cell", 10_000, {"jamming": True})
    density = Near(target=0.636, absolute=0.005)
    row = {"source": "literature", "paper": "0.636 ± 0.005", "form": DENSITY}
    contacts = {"source": "isostatic", "paper": 6.0, "printed": "6", "form": CONTACTS,
        "tolerance": Near(absolute=0.1)}
    return Section(
        title="Equal spheres, jammed, in a periodic cell",
        rows=(
            Row(case="φ, default method, 2000, five seeds", ours=range_of("jammed density"),
                tolerance=density, **row),
            Row(case="φ, default method, 10 000, three seeds", ours=_runs(*cell, "volume_fraction"),
                tolerance=density, **row),
            Row(case="φ, growth", ours=_other("volume_fraction", method="growth"), tolerance=density, **row),
            Row(case="φ, compression", ours=_other("volume_fraction", method="compression"),
                tolerance=density, **row),
            Row(case="z without rattlers, 2000, five seeds", ours=range_of("jammed contacts"), **contacts),
            Row(case="z without rattlers, 10 000, three seeds", ours=_runs(*cell, "backbone_coordination_number"),
                **contacts),
            Row(case="largest overlap, of the mean radius", ours=_runs(*cell, "largest_overlap"), form=ROUNDING,
                tolerance=AtMost(1e-3)),
        ),
    )


def _cylinder() -> Section:
    near = {"source": "§4.3", "paper": 0.635, "form": Form(style=".3f"), "tolerance": Near(absolute=0.008)}
    return Section(
        title="κ = 25 % in the rigid cylinder at z = 6.2",
        before="The paper's 0.635 is for 10 000 elements; ± 0.008 is required for N ≥ 10 000.",
        rows=(
            Row(case="φ, 10 000", ours=_runs("cylinder", 10_000, {}, "volume_fraction"), **near),
            Row(case="φ, 20 000", ours=_other("volume_fraction", shape="cylinder"), **near),
            Row(case="φ, 100 000", ours=_runs("cylinder", 100_000, {}, "volume_fraction"), **near),
            Row(case="z, 10 000 and 100 000", source="§4.3", paper=6.2, printed="6.2", form=CONTACTS,
                tolerance=Near(absolute=0.05), ours=PACKING.of(*(
                    z for n in (10_000, 100_000) for z in _runs("cylinder", n, {}, "coordination_number").values))),
            Row(case="largest overlap when jammed, of the mean radius", form=ROUNDING, tolerance=AtMost(1e-3),
                ours=_runs("cylinder", 10_000, {"jamming": True}, "largest_overlap")),
        ),
    )  # fmt: skip


def _limit(target: str, name: str) -> Measured:
    found = REFINEMENT.at("limits", target, name)
    return REFINEMENT.of(found["value"], scatter=found["error"])


def _free(target: str, name: str) -> Measured:
    found = REFINEMENT.at("summary", {"target": target, "periodic": True})[name]
    return REFINEMENT.of(found["mean"], scatter=found["std"])


def _agreement(target: str, name: str) -> Measured:
    limit, free = _limit(target, name), _free(target, name)
    error = math.hypot(limit.scatter or 0.0, free.scatter or 0.0)
    return REFINEMENT.of((limit.values[0] - free.values[0]) / error)


def _refinement() -> Section:
    ended = "the paper's value is that of 20 000 elements, where its curve still increases"
    overlaps = [one["largest_overlap"]["mean"] for one in REFINEMENT.at("summary") if one["target"] == "jamming"]
    rows = [
        Row(case="φ, cube, limit in N at z = 6.2", source="fig. 8a", paper=0.635, printed="0.635",
            ours=_limit("contacts", "volume_fraction"), form=DENSITY, tolerance=Near(absolute=0.008), reason=ended),
    ]  # fmt: skip
    rows += [
        Row(case=f"{symbol}, {words}: limit less that without walls, in standard errors",
            ours=_agreement(target, name), form=Form(style="+.1f"), tolerance=AtMost(2.0))
        for symbol, words, target, name in (
            ("φ", "z = 6.2", "contacts", "volume_fraction"),
            ("φ", "jamming", "jamming", "volume_fraction"),
            ("z", "jamming", "jamming", "coordination_number"),
        )
    ]  # fmt: skip
    at = {"target": "contacts", "periodic": False, "count": 10_000}
    found = REFINEMENT.at("summary", at)
    rows += [
        Row(case="φ, cube of 10 000 at z = 6.2", source="fig. 8a", paper=0.635, printed="0.635", form=DENSITY,
            tolerance=Near(absolute=0.008),
            ours=REFINEMENT.of(found["volume_fraction"]["mean"], scatter=found["volume_fraction"]["std"])),
        Row(case="z, cube of 10 000 at z = 6.2", source="fig. 8b", paper=6.2, printed="6.2", form=CONTACTS,
            tolerance=Near(absolute=0.05),
            ours=REFINEMENT.of(found["coordination_number"]["mean"], scatter=found["coordination_number"]["std"])),
        Row(case="e, cube of 10 000 at z = 6.2, eq (11)", source="fig. 8c", paper=0.0032, form=Form(style=".2g"),
            tolerance=AtMost(),
            ours=REFINEMENT.of(found["isotropy_error"]["mean"], scatter=found["isotropy_error"]["std"]),
            note="vacuous: no fabric can exceed 0.003115"),
        Row(case="largest overlap of jamming targets, of the mean radius",
            ours=REFINEMENT.of(min(overlaps), max(overlaps)), form=Form(style=".2g"), tolerance=AtMost(1e-3)),
        Row(case="packings that failed", ours=REFINEMENT.number("failed"), form=COUNT, tolerance=AtMost(0.0)),
    ]  # fmt: skip
    return Section(
        title="Number of elements: figure 8",
        rows=tuple(rows),
        figures=(Figure("study_refinement.png",
            "Volume fraction, coordination number and isotropy over the number of elements"),),
    )


def _dispersion() -> Section:
    luding = "Luding's ω₀ ≈ 0.15, which the paper cites, is half a range: κ = 30 %"
    rows = []
    for spread, tolerance, paper, reason in (
        (0.0, AtLeast(0.3), "ordered", ""), (0.1, AtLeast(0.3), "ordered", ""), (0.15, AtMost(0.3), "none from here",
        luding),
        (0.2, AtMost(0.3), "none", luding), (0.25, AtMost(0.3), "none", ""), (0.3, AtMost(0.3), "none", ""),
    ):  # fmt: skip
        ours = DISPERSION.number("summary", {"spread": spread}, "core_rms_excess", "mean")
        rows.append(Row(case=f"order at κ = {100 * spread:.0f} %: rms excess of the core", source="fig. 7",
            paper=paper, ours=ours,
                        form=EXCESS, tolerance=tolerance, reason=reason))  # fmt: skip
    at = "summary", {"spread": 0.4}, "core_rms_excess"
    rows.append(Row(case="order at κ = 40 %, seeds 1 to 3: rms excess of the core", source="fig. 7", paper="none",
        ours=WIDE.number(*at, "mean", scatter=(*at, "std")), form=EXCESS, tolerance=AtMost(0.3)))
    return Section(
        title="Dispersion of the radii: figures 5 to 7",
        before=(
            "The packings have 3000 spheres and are made by shear compaction, the paper's recipe. A packing is "
            "accepted up to an rms excess of 0.3."
        ),
        rows=tuple(rows),
        figures=(
            Figure("study_packings.png", "Spheres, and bonds of a slice, at κ = 0 and 25 % (figure 5)"),
            Figure("study_histograms.png", "Bonds on the faces of the geode (figure 6)"),
            Figure("study_dispersion.png", "e and rms excess over κ (figure 7)"),
        ),
    )


def _rejected() -> Section:
    sheared = DISPERSION.of(float(DISPERSION.at("summary", {"spread": 0.0}, "passed") == 0))
    found = (
        ("an FCC crystal", holds("FCC crystal is rejected")), ("sheared equal spheres", sheared),
        ("a layered packing", holds("layered packing is rejected")),
    )  # fmt: skip
    rows = tuple(Row(case=f"{words}, with the reason", ours=ours, form=YES, tolerance=So()) for words, ours in found)
    return Section(title="Packings that must be rejected", rows=rows)


def _time() -> Section:
    loose = PACKING.at("against_spheropack", {"target": {"volume_fraction": 0.6}})
    jammed = PACKING.at("against_spheropack", {"target": {"jamming": True}})
    return Section(
        title="Time",
        rows=(
            Row(case="cylinder of 10 000, median of three", ours=_seconds(10_000), form=SECONDS,
                tolerance=AtMost(8.0)),
            Row(case="cylinder of 100 000, median of three", ours=_seconds(100_000), form=SECONDS,
                tolerance=AtMost(120.0)),
            Row(case="2000 spheres to φ = 0.6: spheropack's time over ours, median",
                ours=PACKING.of(loose["ratio_median"]), form=PLAIN, tolerance=AtLeast(1.0)),
            Row(case="2000 spheres to jamming: spheropack's time over ours, median",
                ours=PACKING.of(jammed["ratio_median"]), form=PLAIN, tolerance=AtLeast(1.0)),
        ),
    )  # fmt: skip


def _seconds(count: int) -> Measured:
    return PACKING.number("packings", {"shape": "cylinder", "count": count, "target": {}}, "seconds_median")
