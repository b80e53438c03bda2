"""Strengths and fracture energies of bodies of cells: what is put in, and what tests to failure give back."""

from book.chapter import Chapter, Section
from book.forms import PLAIN, Form
from book.results import Measurement
from book.row import Row
from book.tolerances import Near

STRENGTH = Measurement("strength", "python benchmarks/strength.py", "2 h")
MEASUREMENTS = (STRENGTH,)

#: What is asked for: of strengths, of the mean of the fracture energies, and of each of them [-].
LIMIT, EACH = 0.05, 0.08
_TITLES = {
    "tension": "plain bar", "notched": "notched bar", "brittle": "plain bar, brittle facets",
    "compression": "uniaxial compression", "triaxial": "triaxial compression",
}  # fmt: skip
RATIO = Form(style=".3f")


def chapter() -> Chapter:
    """The chapter."""
    return Chapter(
        name="strength",
        title="Strength and fracture energy as put in",
        summary=(
            "Concrete of E = 40 GPa, ν = 0.2, f_t = 4 MPa, c = 14.3 MPa, φ = 35° in prisms 60 × 30 × 30 mm of cells."
            " Nothing is calibrated, and every packing that was tried is in the tables."
        ),
        sections=(_tension(), _compression()),
    )


def _tension() -> Section:
    return Section(
        title="Direct tension",
        before=(
            "Peak over f_t, and work of the platens over the ligament and G_f. Notched bars: a third of the width"
            " from one side. The limit for the energy is 5 % for the mean of a size and 8 % for each specimen."
        ),
        rows=(*_rows(("tension", "notched", "brittle"), "strength"), *_rows(("tension", "notched"), "energy")),
    )


def _compression() -> Section:
    return Section(
        title="Compression between smooth platens",
        before=(
            "Peak over (2 c cos φ + p (1 + sin φ)) / (1 − sin φ), what a Mohr–Coulomb continuum bears under a"
            " pressure p on its sides. G_II is the fracture energy of slip; none of its values was chosen afterwards."
        ),
        rows=tuple(_rows(("compression", "triaxial"), "strength")),
    )


def _rows(kinds: tuple[str, ...], quantity: str) -> list[Row]:
    rows = []
    groups: dict[tuple, list[dict]] = {}
    for one in STRENGTH.at("cases"):
        if one["kind"] in kinds and quantity in one["ratios"]:
            group = kinds.index(one["kind"]), one["energy"], one["pressure"], one["count"]
            groups.setdefault(group, []).append(one)
    for (kind, energy, pressure, count), ones in sorted(groups.items()):
        told = [_TITLES[kinds[kind]]]
        if energy:
            told.append(f"G_{'f' if kinds[kind] in ('tension', 'notched') else 'II'} = {PLAIN.bare(energy)} J/m²")
        if pressure:
            told.append(f"{PLAIN.bare(pressure / 1e6)} MPa")
        seeds = ", ".join(str(one["seed"]) for one in ones)
        case = f"{quantity}: {', '.join(told)}, {count} elements, seeds {seeds}"
        values = [one["ratios"][quantity] for one in ones]
        if quantity == "energy":
            mean = sum(values) / len(values)
            rows.append(Row(case=f"{case}, mean", form=RATIO, tolerance=Near(absolute=LIMIT, target=1.0),
                            ours=STRENGTH.of(mean)))  # fmt: skip
        rows.append(Row(case=case, form=RATIO, ours=STRENGTH.of(*values),
                        tolerance=Near(absolute=EACH if quantity == "energy" else LIMIT, target=1.0)))  # fmt: skip
    return rows
