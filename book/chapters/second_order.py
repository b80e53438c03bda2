"""Plates, thin bodies and nearly incompressible tubes of cells: new packings against finite elements and Lamé."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from book.chapter import Chapter, Section
from book.forms import PERCENT, SIGNED
from book.results import record
from book.row import Row
from book.tolerances import AtMost

FOUND = record("second_order", takes="20 min")
MEASUREMENTS = (FOUND,)

#: Required of plates (mean of six frequencies), of beams (mean and largest), of bodies one cell thick (largest) by
#: their cells, and of the finer tube: mean displacement and hoop stress of the inner fifth [-].
PLATE, BEAM_MEAN, BEAM_LARGEST, U_R, HOOP = 4e-3, 2e-3, 6e-3, 7e-3, 1.5e-2
THIN = {"cubes": 2e-2, "moved": 4e-2}
FINE = 2000
OURS, FORMER = "bondem", "before"
_THIN_BODIES = ("sheet", "clamped sheet", "strip", "column")
_STATED = ("clamped plate", "sheet of two layers", "strip of two layers", "L-beam", "square tube")
_CELLS = {"cubes": "cubes", "moved": "moved cells", "quench": "packing", "even": "even packing"}


def chapter() -> Chapter:
    """The chapter."""
    return Chapter(
        name="second_order",
        title="Plates, thin bodies and nearly incompressible tubes",
        summary=(
            "The cell law has balanced shares, facets that twist beside free walls, and gradients of the dilatation "
            "([decision 0036](decisions/0036-balanced-shares.md)). These terms were derived and chosen on other "
            "packings; those of this page (seeds 31 to 35) were made afterwards. Nothing is calibrated. The former"
            " law, with the shares A w M⁻¹n, twist in layers one cell thick only and no gradients, was "
            "run on the packings of seeds 31 and 32."
        ),
        misses=MISSES,
        sections=(_plates(), _thin(), _stated(), _tube()),
    )


#: What failed, in words.
MISSES = (
    "Torsion of square bars is too stiff: the largest error of bars 4.4 cells thick is just above its limit in most "
    "packings, and bars 3.5 cells thick exceed both limits at every ν. Some strips one cell thick of moved cells "
    "exceed their limit, the most in torsion."
)
#: What the tables show.
PLATES_FOUND = (
    "- **Plates**: mean errors of the former law were 0.6 to 1.3 % at a thickness of 2.7 cells and 0.3 to 0.8 % at "
    "3.4, nearly all too soft. The errors that remain are largest at ν = 0, where all modes of the thinnest plate "
    "are too stiff, and at ν = 0.4 in the fourth and sixth mode, where they do not become smaller between 2500 and "
    "3900 cells.\n"
    "- **Beams**: bending is closer than with the former law for ν > 0, and further off at ν = 0. The largest error "
    "is that of torsion in all of them, and it is positive: 1.1 to 1.4 % at a thickness of 3.5 cells, 0.5 to 0.7 % "
    "at 4.4 and 0.2 % at 6.3. The former law is closer in torsion. No rule for the twist was "
    "found that helps plates and leaves bars as they were."
)
THIN_FOUND = (
    "The former law lacks the gradient of the dilatation across the layer, so that bending is too soft by up to 22 "
    "%. Torsion of the former column is 7 to 9 % too stiff. Bodies of moved cells are mostly too stiff."
)
STATED_FOUND = (
    "- **Two layers**: torsion of the strip is 7 to 8 % too soft (moved cells) and 13 % (cubes); no other error of "
    "this strip is above 1.1 %. Its edges have cells at two walls, where facets do not resist twist. Errors of "
    "sheets are 2.5 % or less.\n"
    "- **Clamped plate**: at ν = 0.4 all modes are too soft, by up to 1 %.\n"
    "- **L-beam and square tube**: mean errors are 8 to 64 % of those of the former law. One mode of the "
    "tube at ν = 0.4 changes from 1 % too soft to 1 % too stiff. Frequencies of its finite elements fell by more "
    "than a percent when the mesh was refined at the inner corners, so that a few tenths of a percent are uncertain. "
    "The tube is packed evenly, because a random packing of this size could not be made with every seed."
)
TUBE_FOUND = (
    "In the tube of 2000 cells the errors of the displacement and of the hoop stress at the inner wall hardly depend "
    "on ν from 0.45 to 0.4999: no locking and no loss of stiffness. The scatter of the hoop stress of single cells "
    "grows with ν, and is smaller than with the former law."
)


def _modes(*names: str) -> list[dict[str, Any]]:
    return [one for one in FOUND.at("modes") if one["name"] in names and "errors" in one]


def _means(found: Sequence[dict[str, Any]]) -> list[float]:
    """Mean sizes of six errors, one per packing."""
    return [float(np.abs(one["errors"]).mean()) for one in found]


def _largest(found: Sequence[dict[str, Any]]) -> list[float]:
    """Largest sizes of six errors, one per packing."""
    return [float(np.abs(one["errors"]).max()) for one in found]


def _where(one: dict[str, Any]) -> str:
    """Body of a case in words."""
    many = f"{one['cells']} cells, {one['thick']:.1f} thick" if one["count"] else _CELLS[one["kind"]]
    return f"{one['name']}, {many}"


def _by(found: Sequence[dict[str, Any]], *keys: str) -> dict[tuple[Any, ...], list[dict[str, Any]]]:
    """Cases by the values of keys."""
    groups: dict[tuple[Any, ...], list[dict[str, Any]]] = {}
    for one in found:
        groups.setdefault(tuple(one[key] for key in keys), []).append(one)
    return groups


def _table(heads: Sequence[str], lines: Sequence[Sequence[str]]) -> str:
    return "\n".join(f"| {' | '.join(line)} |" for line in (heads, ["---"] * len(heads), *lines))


def _range(values: Sequence[float]) -> str:
    """Least and largest in percent, to two digits."""
    ends = dict.fromkeys(PERCENT.bare(value) for value in (min(values), max(values)))
    return ("–" if min(values) >= 0.0 else " … ").join(ends)


def _of_law(found: Sequence[dict[str, Any]], law: str) -> list[dict[str, Any]]:
    return [one for one in found if one["law"] == law]


def _both_laws(found: Sequence[dict[str, Any]]) -> str:
    """Table of the mean and the largest of six errors with both laws."""
    lines = []
    for (*_, nu), some in _by(found, "name", "kind", "count", "nu").items():
        line = [_where(some[0]), f"{nu:g}"]
        for law in (OURS, FORMER):
            mine = _of_law(some, law)
            line += [_range(_means(mine)), _range(_largest(mine))]
        lines.append(line)
    heads = ("body", "ν", "mean [%]", "largest [%]", "mean, former law [%]", "largest, former law [%]")
    return _table(heads, lines)


def _plates() -> Section:
    found, rows = _modes("plate", "beam"), []
    for (name, _, nu), some in _by(_of_law(found, OURS), "name", "count", "nu").items():
        where = f"{_where(some[0])}, ν = {nu:g}"
        limit = PLATE if name == "plate" else BEAM_MEAN
        rows.append(
            Row(case=f"{where}: mean error of six frequencies", form=PERCENT, tolerance=AtMost(limit),
                ours=FOUND.of(*_means(some)))
        )  # fmt: skip
        if name == "beam":
            rows.append(
                Row(case=f"{where}: largest error of six frequencies", form=PERCENT, tolerance=AtMost(BEAM_LARGEST),
                    ours=FOUND.of(*_largest(some)))
            )  # fmt: skip
    return Section(
        title="Free plates and beams",
        before=(
            "The first six free frequencies of plates 9.6 × 6.4 × 1 and beams 8 × 1 × 1, κ = 25 %, against "
            "triquadratic finite elements. Every packing must meet the limits: five of each body, and two of the "
            "plate of 3900 cells."
        ),
        rows=tuple(rows),
        after=f"Both laws:\n\n{_both_laws(found)}\n\n{PLATES_FOUND}",
    )


def _thin() -> Section:
    found, rows = _modes(*_THIN_BODIES), []
    for (_, kind, nu), some in _by(_of_law(found, OURS), "name", "kind", "nu").items():
        errors = [error for one in some for error in one["errors"]]
        rows.append(
            Row(case=f"{_where(some[0])}, ν = {nu:g}: errors of six frequencies", form=SIGNED,
                tolerance=AtMost(THIN[kind]), ours=FOUND.of(*errors))
        )  # fmt: skip
    return Section(
        title="One cell thick",
        before=(
            "A sheet 8 × 7 × 1, free and clamped at one edge, a free strip 12 × 2 × 1 and a free column 14 × 1 × 1: "
            "of cubes, and of five bodies whose centres are moved by up to 0.2 edges along every axis, also across "
            "the layer."
        ),
        rows=tuple(rows),
        after=f"Both laws:\n\n{_both_laws(found)}\n\n{THIN_FOUND}",
    )


def _stated() -> Section:
    found = _modes(*_STATED)
    return Section(
        title="Other thin-walled bodies",
        before=(
            "Bodies without a requirement: a plate 9.6 × 6.4 × 1 clamped at one edge, a sheet 16 × 14 × 2, a strip "
            "24 × 3 × 2, an L-beam 10 × 3 × 3 with legs of 1, and a square tube 16 × 6 × 6 with a wall of 1. Errors "
            f"of six frequencies.\n\n{_both_laws(found)}\n\n{STATED_FOUND}\n{_references()}"
        ),
    )


def _references() -> str:
    """Accuracy of the finite elements in words."""
    found = FOUND.at("meshes")
    finer, coarser = ([one for one in found if (one["fine"] > 1.0) is way] for way in (True, False))
    most, least = (PERCENT.text(max(one["difference"] for one in some)) for some in (finer, coarser))
    names = " and the ".join(one["name"] for one in coarser)
    return (
        f"- **Finite elements**: frequencies differ by {most} or less from those of meshes 1.5 times finer. Those of "
        f"the {names} have finer meshes than the others; they differ by {least} or less from those of meshes 1.5 "
        "times coarser. Meshes of the L-beam and the square tube were not compared with others."
    )


def _tube() -> Section:
    found, rows, lines = [one for one in FOUND.at("lame") if "u_r" in one], [], []
    words = {"u_r": ("mean radial displacement", U_R), "hoop": ("mean hoop stress of the inner fifth", HOOP)}
    for (count, nu), some in _by(_of_law(found, OURS), "count", "nu").items():
        if count == FINE:
            rows += [
                Row(case=f"{count} cells, ν = {nu:g}: error of the {what}", form=SIGNED, tolerance=AtMost(limit),
                    ours=FOUND.of(*(one[key] for one in some)))
                for key, (what, limit) in words.items()
            ]  # fmt: skip
    for (count, law, nu), some in sorted(_by(found, "count", "law", "nu").items()):
        numbers = [_range([one[key] for one in some]) for key in ("u_r", "hoop", "rms")]
        lines.append([str(count), "former" if law == FORMER else "bondem", f"{nu:g}", *numbers])
    heads = ("cells", "law", "ν", "displacement [%]", "hoop stress, inner fifth [%]", "hoop stress, rms [%]")
    return Section(
        title="Nearly incompressible thick tube",
        before=(
            "A tube with an outer radius of twice the inner one, in plane strain between smooth platens, under a "
            "pressure on the inner wall, against Lamé's solution. Packings are even; seeds 31 to 33 for the finer "
            "tube, 31 to 35 for the coarser one."
        ),
        rows=tuple(rows),
        after=f"Both laws and sizes:\n\n{_table(heads, lines)}\n\n{TUBE_FOUND}",
    )
