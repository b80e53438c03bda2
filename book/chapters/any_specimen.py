"""The same bonds in other shapes: cube, slender beam and bracket of five materials against finite elements."""

from book.chapter import Chapter, Figure, Section
from book.forms import COUNT
from book.results import Measurement, record
from book.row import Row
from book.tolerances import AtLeast

ANY = record("any_specimen", drawn=True)
SEED_1 = record("any_specimen", "--seed 1 --fineness ''", kept="any_specimen_seed_1")
MEASUREMENTS = (ANY, SEED_1)

WAYS = {"raw": "bonds as calibrated", "scaled": "one law, `law_for`", "layered": "bonds by layer, experimental"}
OTHERS = (
    "with the constants unchanged, packings of other seeds fail the 3 % (steel beams 0 of 4 pass, alumina and granite"
    " 1 of 4; seed 1, tried before 101, failed too)"
)
SHOWN = f"holds for the packings of seed 101 only: {OTHERS}"


def chapter() -> Chapter:
    """The chapter."""
    return Chapter(
        name="any_specimen",
        title="Calibrated once, used in other shapes",
        summary=(
            "Bonds are calibrated once, in cells without walls, and used in a cube, a slender beam and a bracket "
            "of five materials. The reference is three-dimensional finite elements. Bonds by layer are "
            f"experimental, and their results hold for the seeds shown only: {OTHERS}."
        ),
        misses=(
            "Bonds by layer, which are experimental, do not keep all specimens within the limit on a packing of "
            "another seed."
        ),
        sections=(_shapes(), _seed_1(), _convergence()),
    )


def _shapes() -> Section:
    return Section(
        title="Five materials, three shapes",
        before=(
            f"Each shape has one packing of {ANY.at('count')} elements and seed {ANY.at('seed')}. The limit is 3 % "
            "where the thinnest part is 25 R̄ thick or more (cube and beam), 6 % where it is 12 R̄ (bracket). "
            "These packings have no verdict, because those of other seeds fail (next section). The bonds of the "
            "layers have two empirical factors, found on 8000 elements of seed 1. Clamped specimens are compared "
            "with a continuum held and loaded one R̄ inside."
        ),
        figures=(
            Figure("any_specimen.png", "Errors in cube, beam and bracket, packings of seed 101 only"),
            Figure("any_specimen_bracket.png", "The bracket, and its first mode"),
        ),
    )


def _seed_1() -> Section:
    cases = SEED_1.at("cases")
    rows = [
        Row(case=f"seed 1, {WAYS['layered']}: how many of {len(cases)} are within the limit", form=COUNT,
            ours=SEED_1.of(_within(SEED_1, "layered")), tolerance=AtLeast(len(cases)),
            note="in packings of other seeds, steel beams pass in 0 of 4, alumina and granite in 1 of 4")
    ]  # fmt: skip
    return Section(
        title="Bonds by layer in packings of other seeds",
        before=(
            f"Seed 1 was tried before 101, with the same constants and {SEED_1.at('count')} elements (revision"
            f" {SEED_1.at('revision')}); the error of the steel beam exceeds 3 %. A later review tried other seeds"
            " with the constants unchanged: steel beams pass in 0 of 4, alumina and granite in 1 of 4; their errors"
            " are not recorded. The function is not part of the package."
        ),
        rows=tuple(rows),
    )


def _within(packings: Measurement, way: str) -> int:
    return sum(case[way]["worst"] <= case["limit"] for case in packings.at("cases"))


def _convergence() -> Section:
    return Section(
        title="Convergence with fineness",
        before=(
            "The figure shows the largest error of E, ν and first frequencies; one packing per fineness, seed "
            f"{ANY.at('seed')}. The limitation to the seeds shown holds here too."
        ),
        figures=(Figure("any_specimen_convergence.png", "Errors over the thickness of the thinnest part"),),
    )
