"""The fast part: measured from nothing in less than a minute, at small sizes, and held to what those sizes allow."""

import subprocess
import sys
from pathlib import Path

from book.chapter import Chapter, Section
from book.chapters.andre_tables import CONSISTENCY
from book.chapters.chen_tables import table_3, table_4, table_5
from book.forms import PERCENT, ROUNDING, SIGNED, Form
from book.markdown import counts, page
from book.results import ROOT, Measurement
from book.row import Row, Verdict
from book.small import PACKINGS, measure
from book.tolerances import AtMost, Near, Tolerance

ORDER = "python -m validation energy_drift --elements 500 --steps 2000 --order-steps 500"
CHEN = "python -m validation chen_tables"
#: Standard deviations by which one packing may differ from the mean of sixteen: once in 15 000 by chance.
DEVIATIONS = 4.0


def fast(folder: Path) -> int:
    """Measure, leave JSON and `fast.md` in a folder, and print what is missed; 0 when nothing is, else 1."""
    folder.mkdir(parents=True, exist_ok=True)
    measure(folder / "small.json")
    for name, command in (("chen_tables", CHEN), ("energy_drift", ORDER)):
        words = [sys.executable, *command.split()[1:], "--out", str(folder / f"{name}.json")]
        subprocess.run(words, cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    found = chapter(folder)
    (folder / "fast.md").write_text(page(found), encoding="utf-8")
    missed = [row for row in found.rows if row.verdict is Verdict.MISSED]
    print(counts(found.rows))
    for row in missed:
        asked = row.tolerance.words(row.form) if row.tolerance else ""
        print(f"missed: {row.case}: {row.ours.text(row.form)}, asked {asked}, paper {row.paper_text or '–'}")
    return bool(missed)


def chapter(folder: Path) -> Chapter:
    """The fast part as a chapter, from what `measure` left in a folder."""
    small = Measurement("small", "python -m book --fast", file=folder / "small.json")
    chen = Measurement("chen_tables", CHEN, file=folder / "chen_tables.json")
    drift = Measurement("energy_drift", ORDER, file=folder / "energy_drift.json")
    return Chapter(
        name="fast",
        title="The fast part",
        summary="One packing of 2000 spheres and one cell. Where packings scatter, the tolerance is four standard"
        " deviations of sixteen packings of this size about their mean.",
        sections=(
            _silica(small), _materials(small), _order(drift), table_3(chen), table_4(chen, None), table_5(chen),
        ),
    )  # fmt: skip


def expected(name: str) -> Tolerance:
    """Four standard deviations about the mean of sixteen packings."""
    known = PACKINGS.at("numbers", name)
    return Near(target=known["mean"], absolute=DEVIATIONS * known["std"])


def _silica(small: Measurement) -> Section:
    gpa, plain = Form("GPa", 1e9, ".1f"), Form(style=".4f")
    rows = [
        Row(case="E of the calibrating specimen", source="Table 1", paper=72.5e9, form=gpa,
            ours=small.number("cylinder", "E"), tolerance=Near(relative=0.002)),
        Row(case="ν of the calibrating specimen", source="Table 1", paper=0.17, form=plain,
            ours=small.number("cylinder", "nu"), tolerance=Near(absolute=0.001)),
        Row(case="z", source="§4.3", paper=6.2, form=Form(style=".2f"), tolerance=Near(absolute=0.05),
            ours=small.number("cylinder", "coordination_number")),
        Row(case="e, eq (11)", source="§4.3", paper=0.0032, form=Form(style=".2g"), tolerance=AtMost(),
            ours=small.number("cylinder", "isotropy_error")),
        Row(case="rms excess of the core", form=Form(style=".2f"), tolerance=AtMost(0.3),
            ours=small.number("cylinder", "core_rms_excess")),
    ]  # fmt: skip
    for name, words, form in (
        ("volume_fraction", "φ", plain), ("E_mu", "E_μ, calibrated", gpa), ("radius_ratio", "r̃, calibrated", plain),
        ("E_printed", "E with the bonds of Table 2", gpa), ("nu_printed", "ν with the bonds of Table 2", plain),
        ("tension_error", "tension against theory", SIGNED), ("tension_refined", f"tension: {CONSISTENCY}", SIGNED),
        ("bending_error", "bending against theory", SIGNED), ("bending_refined", f"bending: {CONSISTENCY}", SIGNED),
        ("torsion_error", "torsion against theory", SIGNED), ("torsion_refined", f"torsion: {CONSISTENCY}", SIGNED),
    ):  # fmt: skip
        rows.append(Row(case=words, ours=small.number("cylinder", name), form=form, tolerance=expected(name)))
    rows += [
        Row(case="cell: E over E_μ", ours=small.number("cell", "cell_E_ratio"), form=plain,
            tolerance=expected("cell_E_ratio")),
        Row(case="cell: ν", ours=small.number("cell", "cell_nu"), form=plain, tolerance=expected("cell_nu")),
    ]  # fmt: skip
    return Section(title="Fused silica", rows=tuple(rows))


def _materials(small: Measurement) -> Section:
    rows = []
    for one in small.at("materials"):
        rows += [
            Row(case=f"{one['name']}, {one['law']}: E", ours=small.of(one["E_error"]), form=PERCENT,
                tolerance=AtMost(0.002)),
            Row(case=f"{one['name']}, {one['law']}: ν", ours=small.of(one["nu_error"]), form=ROUNDING,
                tolerance=AtMost(1e-3)),
        ]
    return Section(title="Materials of the library, calibrated", rows=tuple(rows))


def _order(drift: Measurement) -> Section:
    row = Row(case="order of the energy error over dt", ours=drift.of(*drift.at("orders")), form=Form(style=".3f"),
              tolerance=Near(target=2.0, absolute=0.1))  # fmt: skip
    return Section(title="Energy of the bonds", rows=(row,))
