"""The variant of Mka3D beside the cell law, on the same bodies."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from book.chapter import Chapter, Figure, Section
from book.forms import SIGNED, Form
from book.results import Measurement
from book.row import Row
from book.tolerances import AtMost

FOUND = Measurement("mka3d", "python benchmarks/mka3d.py", "30 min")
MEASUREMENTS = (FOUND,)

#: What is asked of bondem's own law [-]: of E and ν as for other bodies of cells, of frequencies as for bodies that
#: are four elements thick.
E_LIMIT, NU_LIMIT, FREQUENCY_LIMIT = 3e-3, 2e-3, 2e-2
OURS = "bondem"
#: Variants and the headings of their columns.
VARIANTS = {
    OURS: "bondem", "bondem, facets with twist": "full", "M⁻¹ with facets of Mka3D": "M⁻¹ and Mka3D",
    "Mka3D": "Mka3D",
}  # fmt: skip
FINE = Form("%", 1e-2, "+.3f")
DIFFERENCE = Form(style="+.5f")
SIZE = Form("%", 1e-2, ".2f")

#: A quantity: what it is, how it is printed, and its number in a result.
Quantity = tuple[str, Form, Callable[[dict[str, Any]], float]]


def chapter() -> Chapter:
    """The chapter."""
    return Chapter(
        name="mka3d",
        title="The cell law beside Mka3D",
        summary=(
            "For M = 1 the elastic cell law is that of Mka3D (Mariotti 2007; Monasse and Mariotti 2012), whose "
            "facets bend with E I/L and twist with G I_p/L ([relation to other models](cell_law.md)). Four variants "
            "were run on the same bodies with the same masses, walls and solvers: bondem as it is; bondem with "
            '`facet_rotation="full"`; M⁻¹ with the facets of Mka3D; and Mka3D, with M = 1. This compares '
            "formulas inside bondem; the code Mka3D was not run, and its walls and time integration are not compared."
        ),
        misses=MISSES,
        sections=(_moduli(), _thin(), _bodies(), _waves()),
    )


#: What failed, in words.
MISSES = (
    "Bodies one cell thick bend too softly, and sheets of two and four cells twist too softly; the facets of Mka3D "
    "are closer to finite elements in both. In some bars of 300 cells the largest ν is just outside its limit."
)
#: What the tables show.
MODULI_FOUND = (
    "E and ν are close to those entered with all variants. Without M⁻¹ a uniform strain has another dilatation in "
    "each cell: the stress of cells scatters more, 3.5 times as much at ν = 0.4, and as each cell is held by "
    "its neighbours E is a little too high. ν hardly changes, because the shear modulus rises with E. How facets "
    "resist rotation does not matter here. In a lattice of cubes M is 1, so that all variants have the entered "
    "moduli."
)
THIN_FOUND = (
    "- **Bending of one layer** is by its facets alone: E I/L is right for a strip, and 2G I/L makes the frequency "
    "too low by the factor 1/√(1 + ν). Neither has the coupling of the two curvatures of a sheet, so that the third "
    "mode at ν = 0.4 is too low with all variants.\n"
    "- **Bending of two and four layers** also has the dilatation of cells: E I/L is mostly closer at ν = 0.2 and 2G "
    "I/L at ν = 0.4, where E I/L is too stiff.\n"
    "- **Twist**: G I_p/L is the twist of a layer of cubes. bondem adds the twist of a layer only to bodies one cell "
    'thick, so that sheets of two and four cells lack it; `facet_rotation="full"` counts it twice. Of these '
    "variants only the facets of Mka3D have the right twist at every thickness.\n"
    "- **M⁻¹** changes thin bodies by 0.3 % or less; for cubes and for one layer it changes nothing."
)
BODIES_FOUND = (
    "bondem is a little too soft and the facets of Mka3D are a little too stiff. In the plate the mean error is "
    "smaller with the facets of Mka3D at ν = 0.2 and with those of bondem at ν = 0.4. In the beam G I_p/L makes "
    "torsion too stiff, which is the largest error; bending is closer with E I/L at ν = 0.2 and with 2G I/L at ν "
    "= 0.4."
)
WAVES_FOUND = (
    "Waves of pressure are slow by nearly the same amount with all variants. Long waves of shear have the "
    "celerity of the material with M⁻¹; without it they are slightly too fast, as the shear modulus is too high. "
    "Facets that twist have smaller errors in short waves of shear. These numbers contain the error of the time "
    "step."
)


def _tables(
    found: Sequence[dict[str, Any]], keys: Sequence[str], heads: Sequence[str], quantities: Sequence[Quantity]
) -> str:
    """A table of each quantity: means over seeds, a line for values of `keys` and a column for each variant."""
    parts = []
    for what, form, value in quantities:
        lines = [[*heads, *VARIANTS.values()], ["---"] * (len(heads) + len(VARIANTS))]
        groups = dict.fromkeys(tuple(one[key] for key in keys) for one in found)
        for group in sorted(groups):
            line = [part if isinstance(part, str) else f"{part:g}" for part in group]
            for name in VARIANTS:
                mine = [
                    value(one) for one in found
                    if one["variant"] == name and tuple(one[key] for key in keys) == group
                ]  # fmt: skip
                line.append(form.bare(float(np.mean(mine))))
            lines.append(line)
        unit = f" [{form.unit or '-'}]"
        parts += [f"{what}{unit}:", "\n".join(f"| {' | '.join(line)} |" for line in lines)]
    return "\n\n".join(parts)


def _seeds(found: Sequence[dict[str, Any]]) -> str:
    """The seeds in words."""
    seeds = sorted({one["seed"] for one in found if one["seed"] is not None})
    return f"seed {seeds[0]}" if len(seeds) == 1 else f"means of seeds {', '.join(map(str, seeds))}"


def _moduli() -> Section:
    found = FOUND.at("moduli")
    rows = []
    for count in sorted({one["count"] for one in found}):
        for nu in sorted({one["nu"] for one in found}):
            mine = [one for one in found if (one["nu"], one["variant"], one["count"]) == (nu, OURS, count)]
            for part, words in (("bulk", "periodic cell"), ("bar", "bar")):
                where = f"{words}, {count} cells, ν = {nu:g}"
                rows += [
                    Row(case=f"{where}: error of E", form=FINE, tolerance=AtMost(E_LIMIT),
                        ours=FOUND.of(*(one[part]["E"] - 1.0 for one in mine))),
                    Row(case=f"{where}: ν less that entered", form=DIFFERENCE, tolerance=AtMost(NU_LIMIT),
                        ours=FOUND.of(*(one[part]["nu"] - nu for one in mine))),
                ]  # fmt: skip
    most = max(one["count"] for one in found)
    quantities: list[Quantity] = []
    for part, words in (("bulk", "Periodic cell"), ("bar", "Bar")):
        quantities += [
            (f"{words}: error of E", FINE, lambda one, part=part: one[part]["E"] - 1.0),
            (f"{words}: error of ν", DIFFERENCE, lambda one, part=part: one[part]["nu"] - one["nu"]),
        ]
    quantities += [
        ("Bar: tractions off σ n", SIZE, lambda one: one["bar"]["traction"]),
        ("Bar: scatter of the stress of cells", SIZE, lambda one: one["bar"]["stress"]),
    ]
    return Section(
        title="E and ν",
        before=(
            "A periodic cell, and a free bar 4 × 1 × 1 between smooth platens. Packings have κ = 25 %. The same "
            "centres are cut into Laguerre cells and into Voronoi cells, which Mka3D uses."
        ),
        rows=tuple(rows),
        after=(
            f"All variants, {most} cells, {_seeds(found)}:\n\n"
            + _tables(
                [one for one in found if one["count"] == most], ("nu", "cells"), ("ν", "cells"), quantities
            )
            + "\n\n" + MODULI_FOUND
        ),
    )  # fmt: skip


def _thin() -> Section:
    found = FOUND.at("thin")
    rows = []
    for body, thick, nu in dict.fromkeys((one["body"], one["thick"], one["nu"]) for one in found):
        mine = [
            one for one in found
            if (one["body"], one["thick"], one["nu"], one["variant"]) == (body, thick, nu, OURS)
        ]  # fmt: skip
        rows.append(
            Row(case=f"{body}, {thick} cell{'s' * (thick > 1)} thick, ν = {nu:g}: errors of frequencies", form=SIGNED,
                tolerance=AtMost(FREQUENCY_LIMIT), ours=FOUND.of(*(error for one in mine for error in one["errors"])))
        )  # fmt: skip
    strips, sheets = ([one for one in found if one["body"] == body] for body in ("strip", "sheet"))
    keys, heads = ("thick", "nu", "cells"), ("layers", "ν", "cells")
    kinds: list[Quantity] = [
        (f"{word} of the sheet", SIGNED, lambda one, k=k: one["errors"][k])
        for k, word in enumerate(("Twist", "First bending", "Second bending"))
    ]
    return Section(
        title="Thin bodies",
        before=(
            "A clamped strip 12 times as long as thick, and a free sheet 8 × 7 times as wide as thick, of cubes, "
            "which the mesh generator of Mka3D makes, and of unequal Voronoi cells. Required is what is "
            "required of other bodies that are four elements thick, at every thickness."
        ),
        rows=tuple(rows),
        after=(
            f"Errors against triquadratic finite elements, {_seeds(strips)}; for the sheet four cells thick seed 1 "
            "alone.\n\n"
            + _tables(strips, keys, heads, [("First bending of the strip", SIGNED, lambda one: one["errors"][0])])
            + "\n\n" + _tables(sheets, keys, heads, kinds) + "\n\n" + THIN_FOUND
        ),
        figures=(
            Figure(
                "mka3d.png",
                "Errors of the first frequencies of a strip and a sheet of unequal cells, and the scatter of the "
                "stress of cells in a pulled bar. Filled marks: ν = 0.2, hollow: ν = 0.4",
            ),
        ),
    )  # fmt: skip


def _bodies() -> Section:
    found = FOUND.at("bodies")
    return Section(
        title="Free frequencies",
        before=(
            "The first six free frequencies of a beam of 40 × 5 × 5 mm and a plate of 24 × 16 × 2.5 mm of Laguerre "
            f"cells against those of triquadratic finite elements; {_seeds(found)}.\n\n"
            + _tables(found, ("shape", "count", "nu"), ("body", "cells", "ν"), [
                ("Mean error", SIGNED, lambda one: float(np.mean(one["errors"]))),
                ("Largest error", SIZE, lambda one: float(np.abs(one["errors"]).max())),
            ])
            + "\n\n" + BODIES_FOUND
        ),
    )  # fmt: skip


def _waves() -> Section:
    found = FOUND.at("waves")
    most = max(one["count"] for one in found)
    mine = [one | {"elements": round(one["elements"], 1)} for one in found if one["count"] == most]
    return Section(
        title="Dispersion",
        before=(
            f"Plane waves in a periodic cell of {most} Laguerre cells; {_seeds(found)}.\n\n"
            + _tables(mine, ("wave", "nu", "elements"), ("wave", "ν", "elements"),
                     [("Error of the celerity, by elements per wave", SIGNED, lambda one: one["ratio"] - 1.0)])
            + "\n\n" + WAVES_FOUND
        ),
    )  # fmt: skip
