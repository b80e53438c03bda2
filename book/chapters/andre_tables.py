"""André et al. (2012), Tables 1 to 4, and the scatter that the paper quotes: fused silica."""

import json
from pathlib import Path
from typing import Any

import numpy as np

from book.chapter import Chapter, Figure, Section
from book.forms import COUNT, GPA, PERCENT, SIGNED, Form
from book.results import Measurement, record
from book.row import Measured, Row
from book.tolerances import AtMost, Near

# Fused silica, Table 1; Table 2.
E, NU, RHO = 72.5e9, 0.17, 2201.0
E_MU, NU_MU, RADIUS_RATIO = 265e9, 0.3, 0.71
POISSON = Form(style=".4f")
RATIO = Form(style=".3f")

#: Test, words, the error in print (Tables 3 and 4), what is asked of it against theory, of it against Timoshenko.
STATIC = (
    ("static_tension", "tension, displacement of the free face", 0.0120, None, None),
    ("static_bending", "bending, deflection of the free face", 0.0416, None, 0.02),
    ("static_torsion", "torsion, rotation of the free face", 0.0613, None, None),
)
DYNAMIC = (
    ("dynamic_tension", "tension, first axial frequency", 0.0038, 0.035, None),
    ("dynamic_bending", "bending, first frequency", 0.0663, 0.065, None),
    ("dynamic_torsion", "torsion, first frequency", 0.0050, 0.03, None),
    ("impact", "impact, celerity", 0.0040, 0.03, None),
)
#: How far a specimen may be from the continuum that is held and loaded at the same spheres.
NEAR = 0.007
CONSISTENCY = "consistency check with the specimen's own lengths and section"


def condense(folder: Path) -> dict[str, Any]:
    """`results.json` without the profiles of each packing."""
    results = json.loads((folder / "results.json").read_text(encoding="utf-8"))
    for packing in results["packings"]:
        del packing["strata"]
    return results


SILICA = Measurement(
    "silica",
    "bondem run examples/silica.toml --out BUILD/silica --packings 5",
    "75 s",
    condense,
    {f"figures/{name}.png": f"silica_{name}.png" for name in ("errors", "modes", "specimen", "geode", "wave")},
)
FOUR = Measurement("silica_four", "bondem run examples/silica_four.toml --out BUILD/silica_four", "90 s", condense)
PRINTED = record("paper_parameters", takes="1 min")
FEM = record("fem_clamped", takes="20 min")
MEASUREMENTS = (SILICA, FOUR, PRINTED, FEM)


def unseen(results: Measurement, name: str) -> Measured:
    """Distance of E or ν of the packings that did not calibrate from the target: mean and scatter."""
    target = {"E": E, "nu": NU}[name]
    return results.mean([one[name] / target - 1.0 for one in results.at("packings") if not one["calibrating"]])


def scatter(results: Measurement, name: str) -> Measured:
    """Standard deviation of E or ν over the packings that did not calibrate, a share of the target."""
    mean = unseen(results, name)
    return results.of(mean.scatter)


def over_packings(name: str, error: str) -> Measured:
    """An error over all packings: mean and scatter."""
    return SILICA.mean([one["tests"][name][error] for one in SILICA.at("packings")])


def continuum(name: str) -> Measured:
    """The error of the continuum that is held and loaded at the spheres of each packing: mean and scatter."""
    return FEM.mean([_run(FEM.at("common"), one["seed"])["error"][name] for one in SILICA.at("packings")])


def beyond(name: str) -> Measured:
    """Error of each packing less that of its continuum: mean and scatter."""
    return SILICA.mean([
        one["tests"][name]["error"] - _run(FEM.at("common"), one["seed"])["error"][name]
        for one in SILICA.at("packings")
    ])  # fmt: skip


def _run(cells: int, seed: int) -> dict[str, Any]:
    return FEM.at("runs", {"way": "spheres", "cells": cells, "seed": seed})


def tests(table: str, entries: tuple[tuple[str, str, float, float | None, float | None], ...]) -> tuple[Row, ...]:
    """Rows of Table 3 or 4: as the paper measures, against what is asked, and against better theories."""
    rows = []
    for name, words, paper, asked, shear in entries:
        raw = over_packings(name, "error")
        reason = _reason(name)
        rows.append(Row(case=words, source=table, paper=paper, ours=raw, tolerance=AtMost(), form=SIGNED,
            reason=reason))
        if asked is not None:
            rows.append(Row(case=f"{words}: asked", ours=raw, tolerance=AtMost(asked), form=SIGNED))
        if shear is not None or name == "dynamic_bending":
            ours = over_packings(name, "error_timoshenko")
            limit = AtMost(shear) if shear is not None else None
            rows.append(Row(case=f"{words}: Timoshenko theory", ours=ours, tolerance=limit, form=SIGNED))
    return tuple(rows)


def _reason(name: str) -> str:
    """Why a test is farther from theory than the paper's, where that is known; what the clamps do of it."""
    clamps = f"a continuum held and loaded at the same spheres is {continuum(name).text(SIGNED)} off theory"
    rest = f"the specimen {beyond(name).text(SIGNED)} off that continuum"
    if name in ("static_tension", "dynamic_tension"):
        return (
            "the elements held and loaded have their centres one radius inside the walls, so the bar that deforms is"
            f" shorter than the paper's length: {clamps}, {rest}"
        )
    if name == "static_bending":
        return f"the skin of the specimen is compliant between rigid walls: {clamps}, {rest}"
    return ""


def chapter() -> Chapter:
    """The chapter."""
    return Chapter(
        name="andre_tables",
        title="André et al. (2012): fused silica, Tables 1 to 4",
        summary=(
            "The specimen is a cylinder of 10 mm × 40 mm with 10 000 spheres, κ = 25 %, Euler–Bernoulli bonds at "
            "contacts (z = 6.2) and ν_μ = 0.3. Fused silica has E = 72.5 GPa, ν = 0.17 and ρ = 2201 kg/m³. In the "
            "first run one packing calibrates and four are unseen; in the second run four calibrate and twelve are "
            "unseen. Errors are means over all five packings of the first run. Calibration sets E and ν of the "
            "calibrating packing, and ρ by eq (19); these numbers are not compared here, because tests require "
            "them to 1e-3."
        ),
        misses=(
            "The calibrated bond modulus and the moduli with the printed bonds differ from the paper, because the "
            "packing differs. In tension, in bending and in the first axial frequency the errors against theory "
            "exceed the published ones. Compared with a continuum that is held and loaded at the same spheres, the "
            "specimen is too compliant in bending and torsion, and its wave is too slow."
        ),
        sections=(_parameters(), _static(), _dynamic(), _continuum(), _scatter(), _packing()),
    )


def _parameters() -> Section:
    z = SILICA.at("specimen", "coordination_number")
    E_contacts, E_jamming = (PRINTED.at(target, "mean", "E") / 1e9 for target in ("contacts", "jamming"))
    packing = (
        f"the packing decides: with the paper's bonds E ranges from {E_jamming:.1f} GPa at the onset of jamming to"
        f" {E_contacts:.1f} GPa at 6.2 contacts, and the paper's 72.5 GPa lies between; the paper states only"
        " that z of its packing is higher than 6.2"
    )
    rows = [
        Row(case=f"E_μ, calibrated on one packing at z = {z:.2f}", paper=E_MU, printed="265 GPa", form=GPA,
            ours=SILICA.number("micro", "E_mu"), tolerance=Near(relative=0.02), reason=packing, source="Table 2"),
        Row(case=f"r̃, calibrated on one packing at z = {z:.2f}", paper=RADIUS_RATIO, printed="0.71",
            ours=SILICA.number("micro", "r_mu_ratio"), form=RATIO, tolerance=Near(relative=0.02), source="Table 2"),
        Row(case="E_μ, calibrated on four packings", paper=E_MU, printed="265 GPa", form=GPA,
            ours=FOUR.number("micro", "E_mu"), tolerance=Near(relative=0.02), reason=packing, source="Table 2"),
        Row(case="r̃, calibrated on four packings", paper=RADIUS_RATIO, printed="0.71",
            ours=FOUR.number("micro", "r_mu_ratio"), form=RATIO, tolerance=Near(relative=0.02), source="Table 2"),
    ]  # fmt: skip
    for target, words in (("contacts", "6.2 contacts"), ("jamming", "onset of jamming")):
        mean, std = PRINTED.at(target, "mean"), PRINTED.at(target, "std")
        where = f"with the paper's bonds, {words}, z = {mean['coordination_number']:.2f}"
        # as far apart as packings of one kind are in the paper, §5.4
        rows += [
            Row(case=f"E {where}", source="Tables 1, 2", paper=E, form=GPA, tolerance=Near(relative=0.07),
                reason=packing, ours=PRINTED.of(mean["E"], scatter=std["E"])),
            Row(case=f"ν {where}", source="Tables 1, 2", paper=NU, printed="0.17", form=POISSON,
                tolerance=Near(relative=0.05), reason=packing, ours=PRINTED.of(mean["nu"], scatter=std["nu"])),
        ]  # fmt: skip
    return Section(
        title="Table 2: parameters of the bonds",
        before=(
            "Calibrated parameters must lie within 2 % of the paper. E and ν with the paper's own bonds must lie "
            "within the scatter that the paper states, 7 % and 5 %."
        ),
        rows=tuple(rows),
    )


def _static() -> Section:
    return Section(
        title="Table 3: quasi-static tests",
        before="Theory uses the paper's lengths, from wall to wall. The paper prints errors without signs.",
        rows=tests("Table 3", STATIC),
    )


def _dynamic() -> Section:
    largest = np.max([abs(one["free_vibration"] / one["measured"] - 1.0) for packing in SILICA.at("packings")
                      for one in packing["tests"].values() if one["free_vibration"]])  # fmt: skip
    return Section(
        title="Table 4: dynamic tests",
        rows=(
            *tests("Table 4", DYNAMIC),
            Row(case="free vibration against natural modes, largest", ours=SILICA.of(largest),
                form=Form(style=".1g"), tolerance=AtMost(1e-3)),
        ),
        after=(
            "Theory with the specimen's own lengths (between the held and loaded sets) and its own section (from "
            "its tension test) checks only that the seven tests are consistent with each other. It takes the "
            "compliance of the specimen from the specimen itself, so these numbers have no verdict. An independent "
            "reference is the continuum of the next section; [decision 0004](decisions/0004-measures.md) describes "
            "both."
        ),
        figures=(
            Figure("silica_errors.png", "Errors of the seven tests beside the paper's"),
            Figure("silica_modes.png", "Specimen and first modes"),
        ),
    )  # fmt: skip


def _continuum() -> Section:
    rows = []
    for table, entries in (("Table 3", STATIC), ("Table 4", DYNAMIC)):
        for name, words, paper, *_ in entries:
            rows.append(
                Row(case=f"{words}: specimen less continuum", source=table, ours=beyond(name), form=SIGNED,
                    paper=f"{PERCENT.text(paper)} off theory", tolerance=AtMost(NEAR))
            )  # fmt: skip
    return Section(
        title="The same bar as a continuum",
        before=(
            "Finite elements are held, loaded and measured at the spheres of each of the five packings. Theory is "
            "that of the tables above, Euler–Bernoulli in bending. The paper's number is an error against theory; "
            "the paper has no continuum."
        ),
        rows=tuple(rows),
        after=_convergence(),
    )


def _convergence() -> str:
    """What the rows of the continuum come to, and how far they are from those of finer meshes."""
    common, face = FEM.at("common"), FEM.at("runs", {"way": "face"})["error"]
    meshes = [_run(cells, 1) for cells in FEM.at("cells")]
    finest = meshes[-1]["cells"]
    tests = [(name, words) for name, words, *_ in (*STATIC, *DYNAMIC)]
    moved = max(abs(meshes[-1]["error"][name] - _run(common, 1)["error"][name]) for name, _ in tests)
    lines = [
        f"| seed 1, off theory | {' | '.join(_spaced(one['unknowns']) + ' unknowns' for one in meshes)} |",
        f"|---|{'--:|' * len(meshes)}",
    ]
    for name, words in tests:
        lines.append(f"| {words} | {' | '.join(SIGNED.text(one['error'][name]) for one in meshes)} |")
    return (
        "In bending and torsion the clamps stiffen the bar and the specimen is too compliant: the errors of the"
        " tables above are the sum of both (in bending, against Timoshenko's theory). The front of the wave arrives"
        " later in the specimen than in the continuum; the cause is not known.\n\n"
        + "\n".join(lines)
        + f"\n\nThe rows use {_spaced(_run(common, 1)['unknowns'])} unknowns, {4 * common} elements across the"
        f" diameter at the ends. With {4 * finest} elements the results of seed 1 change by {PERCENT.text(moved)} at"
        " most, all away from the specimens. If this change is proportional to the size of the elements, the limit"
        f" is {PERCENT.text(moved * finest / (finest - common))} from the rows. With the whole face held and loaded,"
        f" the continuum is off theory by {SIGNED.text(face['static_tension'])} in tension,"
        f" {SIGNED.text(face['static_bending_timoshenko'])} in bending (Timoshenko) and"
        f" {SIGNED.text(face['static_torsion'])} in torsion."
    )


def _spaced(number: int) -> str:
    return COUNT.text(float(number))


def _scatter() -> Section:
    rows = []
    for name, symbol, liao, hentz, paper in (("E", "E", 0.28, 0.12, 0.07), ("nu", "ν", 0.16, 0.10, 0.05)):
        for ours, which in ((scatter(SILICA, name), "four unseen packings"), (scatter(FOUR, name),
        "twelve unseen packings")):
            case = f"{symbol}, {which}"
            if which.startswith("twelve"):
                rows += [
                    Row(case=f"{case}: Liao's calibration of springs (Hentz)", source="§5.4, ref. 39", paper=liao,
                        printed=f"{100 * liao:.0f} %", ours=ours, tolerance=AtMost(), form=PERCENT),
                    Row(case=f"{case}: Hentz's energy criterion", source="§5.4, ref. 7", paper=hentz,
                        printed=f"{100 * hentz:.0f} %", ours=ours, tolerance=AtMost(), form=PERCENT),
                ]  # fmt: skip
            rows += [
                Row(case=f"{case}: the paper's bonds, above 7500 elements", source="§5.4, fig. 17", paper=paper,
                    printed=f"{100 * paper:.0f} %", ours=ours, tolerance=AtMost(), form=PERCENT),
                Row(case=f"{case}: asked", ours=ours, tolerance=AtMost(0.02), form=PERCENT),
            ]  # fmt: skip
        rows += [
            Row(case=f"{symbol}, mean of four unseen packings, calibrated on one", ours=unseen(SILICA, name),
                form=SIGNED, tolerance=AtMost(0.02)),
            Row(case=f"{symbol}, mean of twelve unseen packings, calibrated on four", ours=unseen(FOUR, name),
                form=SIGNED, tolerance=AtMost(0.01)),
        ]  # fmt: skip
    return Section(
        title="Scatter over packings",
        before=(
            "The rows show the standard deviation over packings that did not calibrate. The paper does not define "
            "\"fluctuates around 7 %\"."
        ),
        rows=tuple(rows),
        after=(
            "The means are samples too: one packing of 10 000 elements has a standard deviation of about 1.1 % in "
            "E and ν, the mean of four 0.6 %. With an earlier version of the packing algorithm (other spheres for "
            "the same seeds) the same study with four packings gave −0.28 ± 0.90 % in E and +1.27 ± 1.15 % in ν, "
            "outside the required 1 %. Groups of four other seeds gave −0.6 % and −0.4 %. A mean within 1 % in "
            "nineteen of twenty cases takes five or six calibrating packings."
        ),
    )  # fmt: skip


def _packing() -> Section:
    first = SILICA.at("packings", 0)
    printed = (
        "the printed bound is vacuous: no fabric can exceed 0.003115"
        " ([why](studies.md#what-is-wrong-with-the-published-threshold))"
    )
    return Section(
        title="The packing",
        rows=(
            Row(case="volume fraction", source="§4.3", paper=0.635,
                ours=SILICA.number("specimen", "volume_fraction"), form=RATIO, tolerance=Near(absolute=0.008),
                note="rigid cylinder; 0.64 in the bulk"),
            Row(case="coordination number", source="§4.3", paper=6.2, printed="6.2",
                ours=SILICA.number("specimen", "coordination_number"), form=Form(style=".2f"),
                tolerance=Near(absolute=0.05)),
            Row(case="isotropy error e, eq (11)", source="§4.3, eq (11)", paper=0.0032, form=Form(style=".2g"),
                note=printed, ours=SILICA.number("specimen", "isotropy_error"), tolerance=AtMost()),
            Row(case="rms excess over chance", ours=SILICA.of(first["rms_excess"]), form=Form(style=".2f"),
                tolerance=AtMost(0.3)),
            Row(case="rms excess over chance, in the core", ours=SILICA.of(first["core_rms_excess"]),
                form=Form(style=".2f"), tolerance=AtMost(0.3)),
        ),
    )  # fmt: skip
