"""Plates, thin bodies and nearly incompressible tubes of cells: new packings against finite elements and Lamé."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from book.forms import PERCENT, SIGNED, grid
from book.results import grouped, record
from book.row import Row, Rows
from book.tolerances import AtMost

FOUND = record("second_order", takes="20 min")
MEASUREMENTS = (FOUND,)

#: Required of plates (mean of six frequencies), of beams (mean and largest), of bodies one cell thick (largest) by
#: their cells, and of the finer tube: mean displacement and hoop stress of the inner fifth [-].
PLATE, BEAM_MEAN, BEAM_LARGEST, U_R, HOOP = 4e-3, 2e-3, 6e-3, 7e-3, 1.5e-2
THIN = {"cubes": 2e-2, "moved": 4e-2}
FINE = 2000
OURS, FORMER = "bondem", "before"
PLATES = ("plate", "beam")
THIN_BODIES = ("sheet", "clamped sheet", "strip", "column")
STATED = ("clamped plate", "sheet of two layers", "strip of two layers", "L-beam", "square tube")
_CELLS = {"cubes": "cubes", "moved": "moved cells", "quench": "packing", "even": "even packing"}


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


def _range(values: Sequence[float]) -> str:
    """Least and largest in percent, to two digits."""
    ends = dict.fromkeys(PERCENT.bare(value) for value in (min(values), max(values)))
    return ("–" if min(values) >= 0.0 else " … ").join(ends)


def _of_law(found: Sequence[dict[str, Any]], law: str) -> list[dict[str, Any]]:
    return [one for one in found if one["law"] == law]


def both_laws(*names: str) -> str:
    """Table of the mean and the largest of six errors with both laws."""
    lines = []
    for (*_, nu), some in grouped(_modes(*names), "name", "kind", "count", "nu").items():
        line = [_where(some[0]), f"{nu:g}"]
        for law in (OURS, FORMER):
            mine = _of_law(some, law)
            line += [_range(_means(mine)), _range(_largest(mine))]
        lines.append(line)
    heads = ("body", "ν", "mean [%]", "largest [%]", "mean, former law [%]", "largest, former law [%]")
    return grid(heads, lines, " --- |")


def plates() -> Rows:
    for (name, _, nu), some in grouped(_of_law(_modes(*PLATES), OURS), "name", "count", "nu").items():
        where = f"{_where(some[0])}, ν = {nu:g}"
        limit = PLATE if name == "plate" else BEAM_MEAN
        yield Row(f"{where}: mean error of six frequencies", FOUND.of(*_means(some)), AtMost(limit), PERCENT)
        if name == "beam":
            yield Row(f"{where}: largest error of six frequencies", FOUND.of(*_largest(some)), AtMost(BEAM_LARGEST),
                PERCENT)  # fmt: skip


def thin() -> Rows:
    for (_, kind, nu), some in grouped(_of_law(_modes(*THIN_BODIES), OURS), "name", "kind", "nu").items():
        errors = [error for one in some for error in one["errors"]]
        yield Row(f"{_where(some[0])}, ν = {nu:g}: errors of six frequencies", FOUND.of(*errors), AtMost(THIN[kind]),
            SIGNED)  # fmt: skip


def meshes(finer: bool) -> list[dict[str, Any]]:
    """Comparisons of meshes of finite elements with finer ones, or with coarser ones."""
    return [one for one in FOUND.at("meshes") if (one["fine"] > 1.0) is finer]


def _tubes() -> list[dict[str, Any]]:
    return [one for one in FOUND.at("lame") if "u_r" in one]


def tube() -> Rows:
    words = {"u_r": ("mean radial displacement", U_R), "hoop": ("mean hoop stress of the inner fifth", HOOP)}
    fine = [one for one in _of_law(_tubes(), OURS) if one["count"] == FINE]
    for (nu,), some in grouped(fine, "nu").items():
        for key, (what, limit) in words.items():
            yield Row(f"{FINE} cells, ν = {nu:g}: error of the {what}", FOUND.each(some, key), AtMost(limit), SIGNED)


def both_sizes() -> str:
    """A table of the tubes of both laws and sizes."""
    lines = []
    for (count, law, nu), some in sorted(grouped(_tubes(), "count", "law", "nu").items()):
        numbers = [_range([one[key] for one in some]) for key in ("u_r", "hoop", "rms")]
        lines.append([str(count), "former" if law == FORMER else "bondem", f"{nu:g}", *numbers])
    heads = ("cells", "law", "ν", "displacement [%]", "hoop stress, inner fifth [%]", "hoop stress, rms [%]")
    return grid(heads, lines, " --- |")
