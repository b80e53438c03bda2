"""What Celigueta et al. (2020) leave open: speed and friction of plates, gaps, size; and what it does."""

from typing import Any

from book.chapter import Section
from book.forms import Form
from book.results import Measurement, record, study
from book.row import Row
from book.tolerances import AtMost, Near

SLOWER = study("celigueta", {}, options="--seeds 1 --areas weighted --slower 1,2,4", kept="celigueta_slower")
FULL_SLOWER = study(
    "celigueta", {}, options="--count 0 --seeds 1 --areas weighted --slower 1,2 --processes 1",
    kept="celigueta_full_slower",
)  # fmt: skip
REACH = record("non_local_reach", "", "--failure Mohr-Coulomb --counts 3000 --reaches 1.3,1.5", takes="12 min")
PLATENS = study(
    "celigueta", {}, kept="celigueta_platens",
    options="--count 1000 --seeds 1,2,3 --areas weighted --failures Rankine --platens 0,0.1,0.3 --processes 1",
)  # fmt: skip
NOISE = record("non_local_noise", takes="3 min")
FORCES = record("plate_forces", takes="15 min")
MEASUREMENTS = SLOWER, FULL_SLOWER, PLATENS, NOISE, REACH, FORCES

#: What is asked of plates half as fast: how far peaks may change, and forces of both plates differ.
OF_SPEED, OF_PLATES = 0.03, 0.02
STRESS, SHARE, RATIO = Form("MPa", 1e6, ".2f"), Form(style=".3f"), Form(style=".2f")
AREAS = {"weighted": "the authors' areas", "facet": "Laguerre facets"}


def packings(one: dict[str, Any]) -> str:
    """The packings of a case, as words."""
    seeds = ", ".join(str(seed) for seed in one["seed"])
    return f"packing{'s' if len(one['seed']) > 1 else ''} {seeds}"


def sections() -> tuple[Section, ...]:
    """All of it."""
    return _speed(), _forces(), _platens(), _noise(), _reach()


def _slower(kept: Measurement) -> list[Row]:
    cases = kept.at("cases")
    first = {(one["test"], one["failure"]): one["peak"][0] for one in cases if one["slower"] == 1.0}
    rows = []
    for one in cases:
        speed = "the paper's speed" if one["slower"] == 1.0 else f"{one['slower']:g} times slower"
        words = f"{one['test']}, {one['failure']}, {one['count'][0]} elements, {speed}"
        if one["slower"] != 1.0:
            change = one["peak"][0] / first[one["test"], one["failure"]] - 1.0
            rows.append(Row(case=f"{words}: change of the peak", ours=kept.of(change), form=Form("%", 1e-2, "+.1f"),
                            tolerance=AtMost(OF_SPEED) if one["slower"] == 2.0 else None))  # fmt: skip
        rows.append(Row(case=f"{words}: force on the other plate over that at the peak", form=SHARE,
                        ours=kept.of(*one["other"]), tolerance=Near(absolute=OF_PLATES, target=1.0)))  # fmt: skip
    return rows


def _speed() -> Section:
    """Plates more slowly."""
    rows = [row for kept in (SLOWER, FULL_SLOWER) for row in _slower(kept)]
    return Section(
        title="Speed of the plates",
        before=(
            f"The rows compare the speed of the paper with half and a quarter of it, for {SLOWER.at('count')} "
            "elements and the paper's sizes, packing 1 and the authors' areas. In splitting, plates at the paper's "
            "speed make the disc oscillate (its curves have waves), so the forces of both plates differ."
        ),
        rows=tuple(rows),
    )


def _forces() -> Section:
    """Return the section on the lower load of the other plate."""
    rows = []
    kinds: dict[tuple[str, float, bool], list[dict[str, Any]]] = {}
    for one in FORCES.at("cases"):
        kinds.setdefault((one["test"], one["damping"], one["both"]), []).append(one)
    for (test, damping, both), some in kinds.items():
        seeds = packings({"seed": [one["seed"] for one in some]})
        words = (
            f"{test}, local damping {damping:g}, {'both plates move' if both else 'one plate moves'},"
            f" {some[0]['count']} elements, {seeds}"
        )
        rows.append(
            Row(case=f"{words}: force on the other plate over that at the peak", form=SHARE,
                ours=FORCES.of(*(one["at_peak"] for one in some)),
                tolerance=Near(absolute=OF_PLATES, target=1.0))
        )  # fmt: skip
    return Section(
        title="Forces of both plates",
        before=(
            "The tests use Rankine at the paper's size and speed. From a fifth of the peak on, 2 to 3 % of the "
            "impulse are missing at the fixed plate. The momentum of the elements accounts for at most 0.4 %; the "
            "rest is local damping, which opposes the motion of a body that follows one plate: 1.5 % with a "
            "damping of 0.1, 0.6 % with 0.03. At the peak the oscillation of the disc is superposed, more so with "
            "less damping. If both plates move, each at half the speed, the damping of both sides cancels, and the "
            "forces agree within 1 % with the same damping and the same strengths. The paper states the relative "
            "velocity of the plates, and not which of them moves."
        ),
        rows=tuple(rows),
    )


def _platens() -> Section:
    """Friction of the plates alone."""
    return Section(
        title="Friction of the plates",
        before=(
            f"Packings have {PLATENS.at('count')} elements, Rankine's criterion and the authors' areas; friction "
            "between elements is 0.1. Smooth plates lower the compressive strength by a fifth, friction above 0.1 "
            "adds nothing, and the splitting strength does not depend on it."
        ),
    )


def _noise() -> Section:
    """Why a Rankine criterion breaks what is pressed."""
    return Section(
        title="Scatter of stresses and Rankine's criterion in compression",
        before=(
            "In a uniform body in uniaxial compression σ1 is zero, and no pressure violates Rankine's criterion. "
            "These stresses are those of bonds in the middle half of the cylinder at 20 MPa, before failure. With "
            "the authors' areas one bond in eighty has σ1 above 6 / 55 of the stress, so 6 MPa correspond to 55 "
            "MPa. With Laguerre facets no bond has; stresses scatter a quarter to a sixth as much, and the same "
            "criterion gives 2.5 times the strength at full size. The compressive strength of this law with "
            "Rankine's criterion therefore follows from the scatter of its stresses, and the ratio of both "
            "strengths is a property of the construction."
        ),
    )


def _reach() -> Section:
    """Sizes by gaps over which spheres are bonded."""
    every = REACH.at("cases")
    cases = [one for one in every if one["failure"] == "Rankine"]
    counts, reaches = (sorted({one[key] for one in cases}) for key in ("count", "reach"))
    head = ("elements", *(f"reach {reach:g}: z" + " | E [GPa] | peak [MPa]" for reach in reaches))
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * (1 + 3 * len(reaches))]
    for count in counts:
        cells = [str(count)]
        for reach in reaches:
            some = [one for one in cases if (one["count"], one["reach"]) == (count, reach)]
            cells += [_of(some, "z", 1.0, ".1f"), _of(some, "E_plates", 1e9, ".1f"), _of(some, "peak", 1e6, ".1f")]
        lines.append("| " + " | ".join(cells) + " |")
    numbers = sorted({one["seed"] for one in cases})
    seeds = ", ".join(map(str, numbers))
    return Section(
        title="Sizes of packings and gaps of bonds",
        before=(
            "The tests are compression with Rankine (6 MPa) and the authors' areas. Spheres are bonded up to a"
            " distance of reach × (R1 + R2), and z is the coordination number; entries are packings"
            f" {seeds}. The paper does not print the gaps that it bonds. 40 GPa were entered, and 55 MPa were"
            " measured. Mohr–Coulomb with 14.5 MPa and 60° has a lower strength than Rankine at both gaps, so no gap"
            " gives both"
            " criteria 55 MPa.\n\n" + "\n".join(lines)
        ),
    )


def _of(some: list[dict[str, Any]], key: str, unit: float, style: str) -> str:
    return ", ".join("–" if one[key] is None else format(one[key] / unit, style) for one in some)
