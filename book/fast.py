"""The fast part: measured from nothing in less than a minute, at small sizes, and held to what those sizes allow."""

import subprocess
import sys
from pathlib import Path

from book.chapter import Chapter, Section
from book.chapters.andre_tables import CONSISTENCY
from book.chapters.chen_tables import table_4, table_5
from book.forms import PERCENT, RATIO, ROUNDING, SIGNED, Form
from book.markdown import counts, page, required
from book.results import ROOT, Measurement
from book.row import Row, Rows, Verdict
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
        ours = row.ours.text(row.form)
        print(f"missed: {row.case}: {ours}, required {required(row)}, paper {row.paper_text or '–'}")
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
            *(Section(title=title, rows=tuple(rows)) for title, rows in (
                ("Fused silica", _silica(small)), ("Materials of the library, calibrated", _materials(small)),
                ("Energy of the bonds", _order(drift)),
                ("Table 4: tip deflection of case 1", table_4(chen, None)),
                ("Table 5: stiffness of a bond in case 3", table_5(chen)),
            )),
        ),
    )  # fmt: skip


def expected(name: str) -> Tolerance:
    """Four standard deviations about the mean of sixteen packings."""
    known = PACKINGS.at("numbers", name)
    return Near(target=known["mean"], absolute=DEVIATIONS * known["std"])


def _silica(small: Measurement) -> Rows:
    gpa, plain = Form("GPa", 1e9, ".1f"), Form(style=".4f")
    yield Row("E of the calibrating specimen", small.number("cylinder", "E"), Near(relative=0.002), gpa,
        source="Table 1", paper=72.5e9)  # fmt: skip
    yield Row("ν of the calibrating specimen", small.number("cylinder", "nu"), Near(absolute=0.001), plain,
        source="Table 1", paper=0.17)  # fmt: skip
    yield Row("z", small.number("cylinder", "coordination_number"), Near(absolute=0.05), Form(style=".2f"),
        source="§4.3", paper=6.2)  # fmt: skip
    yield Row("e, eq (11)", small.number("cylinder", "isotropy_error"), AtMost(), Form(style=".2g"), source="§4.3",
        paper=0.0032)  # fmt: skip
    yield Row("rms excess of the core", small.number("cylinder", "core_rms_excess"), AtMost(0.3), Form(style=".2f"))
    for name, words, form in (
        ("volume_fraction", "φ", plain), ("E_mu", "E_μ, calibrated", gpa), ("radius_ratio", "r̃, calibrated", plain),
        ("E_printed", "E with the bonds of Table 2", gpa), ("nu_printed", "ν with the bonds of Table 2", plain),
        ("tension_error", "tension against theory", SIGNED), ("tension_refined", f"tension: {CONSISTENCY}", SIGNED),
        ("bending_error", "bending against theory", SIGNED), ("bending_refined", f"bending: {CONSISTENCY}", SIGNED),
        ("torsion_error", "torsion against theory", SIGNED), ("torsion_refined", f"torsion: {CONSISTENCY}", SIGNED),
    ):  # fmt: skip
        yield Row(words, small.number("cylinder", name), expected(name), form)
    yield Row("cell: E over E_μ", small.number("cell", "cell_E_ratio"), expected("cell_E_ratio"), plain)
    yield Row("cell: ν", small.number("cell", "cell_nu"), expected("cell_nu"), plain)


def _materials(small: Measurement) -> Rows:
    for one in small.at("materials"):
        yield Row(f"{one['name']}, {one['law']}: E", small.of(one["E_error"]), AtMost(0.002), PERCENT)
        yield Row(f"{one['name']}, {one['law']}: ν", small.of(one["nu_error"]), AtMost(1e-3), ROUNDING)


def _order(drift: Measurement) -> Rows:
    yield Row("order of the energy error over dt", drift.of(*drift.at("orders")), Near(target=2.0, absolute=0.1),
        RATIO)  # fmt: skip
