"""Figures of the laboratory's tests of one concrete: the broken specimen, and the curves of all seeds."""

import math
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from bondem.errors import InputError
from bondem.labtests.failure_tests import FAILURE_TESTS
from bondem.report.strength_figures import draw_failed
from bondem.report.style import BLUE, INK, ORANGE, sheet

#: Tests as figures have them: name, kind of the rows, pressure on the sides [Pa].
PANELS = (
    ("ucs", "ucs", 0.0), ("direct_tension", "tension", 0.0), ("triaxial", "triaxial", 5e6),
    ("brazilian", "brazilian", 0.0), ("three_point_bending", "bending", 0.0),
    ("three_point_bending", "notched", 0.0), ("shear", "shear", 0.0),
)  # fmt: skip


def draw_all(
    rows: Sequence[tuple[Path, dict[str, Any]]], out: Path, specimen: Callable[[str, int, int], bd.Lattice]
) -> None:
    """Draw, for each test, its largest specimen as it broke and the curves of all that are kept.

    Args:
        rows: of the record, each with the file of its curves.
        out: folder for `concrete_KIND.png`.
        specimen: makes the body of a kind, number of cells and seed.
    """
    if not any(file.exists() for file, _ in rows):
        raise InputError(f"{rows[0][0].parent} has no curves; measure them first")
    for name, kind, pressure in PANELS:
        asked = {"kind": kind, "pressure": pressure}
        found = [(file, row) for file, row in rows if file.exists() and asked.items() <= row.items()]
        if found:
            _draw(out / f"concrete_{kind}.png", name, found, specimen)


def _draw(
    path: Path, name: str, found: list[tuple[Path, dict[str, Any]]], specimen: Callable[[str, int, int], bd.Lattice]
) -> None:
    told = FAILURE_TESTS[name].figure
    file, row = max(found, key=lambda one: (one[1]["count"], -one[1]["seed"]))
    body = specimen(row["kind"], row["count"], row["seed"])
    with sheet(path, 9.4, 3.6, 1, 2) as (figure, (left, right)), np.load(file) as kept:
        curves = {key: kept[key] for key in ("displacement", "orientation", "damage")}
        draw_failed(figure, left, body, curves | {"slip": np.zeros(len(body.particles))}, told)
        notched = ", notched" * (row["kind"] == "notched")
        left.set_title(f"{told.title}{notched}, {row['count']} cells, seed {row['seed']}", color=INK)
        for other, one in sorted(found, key=lambda pair: pair[1]["count"]):
            with np.load(other) as beside:
                x, y = beside["curve"].T
            alpha, width = (1.0, 1.4) if one is row else (0.45, 0.9)
            label = f"{one['count']} cells, seed {one['seed']}"
            right.plot(1e3 * x, y / 1e6, color=BLUE, alpha=alpha, linewidth=width, label=label)
        if row["theory"] is not None and math.isfinite(row["theory"]):
            right.axhline(row["theory"] / 1e6, color=ORANGE, linestyle=(0, (4, 3)), label="put in")
        bent = name == "three_point_bending"
        strain, stress = ("deflection / span", "flexural stress") if bent else (told.strain, told.stress)
        right.set(xlabel=f"{strain} [10$^{{-3}}$]", ylabel=f"{stress} [MPa]")
        right.set_ylim(bottom=0.0)
        right.legend(loc="best")
