"""The report: one HTML page that holds everything it shows, and the figures beside it as PNG files."""

import base64
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from datetime import date
from pathlib import Path
from typing import Any

import numpy as np
from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape

from bondem.errors import InputError
from bondem.io.atomic import write_text
from bondem.laws.catalogue import named
from bondem.report.breakage_figures import draw_energies, draw_pieces
from bondem.report.cell_figures import draw_bent, draw_body
from bondem.report.criterion_told import told
from bondem.report.dynamic_figures import draw_modes, draw_vibration, draw_wave
from bondem.report.fabric_figures import draw_distribution, draw_layering
from bondem.report.findings import Findings
from bondem.report.mesoscale_figure import draw_cut_open
from bondem.report.numbers import measures, percent, signed, signed_percent, with_unit
from bondem.report.quality import quality_rows
from bondem.report.specimen_figures import draw_contacts, draw_geode, draw_specimen
from bondem.report.static_figures import draw_free_parameter, draw_profiles, draw_tension
from bondem.report.strength_figures import DRAWN, draw_broken, draw_curves
from bondem.report.summary_figures import draw_errors
from bondem.report.turning import turning_of
from bondem.specimen.layering import wall_layering
from bondem.specimen.radial_distribution import radial_distribution

#: Of the figures, by name.
CAPTIONS = {
    "specimen": "The specimen: its elements, coloured by radius, on one half; its bonds alone on the other.",
    "geode": """Directions of the bonds, counted on the 320 faces of a geode and divided by what an isotropic fabric
        would have there. Inside, a good packing shows noise and no pattern; next to the walls elements line up.""",
    "contacts": """Left: bonds of an element, with their mean, the coordination number z. Right: radii of the
        elements.""",
    "layering": """Solid fraction against the distance from each wall. Walls order spheres into layers, which die out
        within some two diameters; what lies beyond is the same as deep inside.""",
    "distribution": """How often centres lie at a distance from each other, over what chance would do: spheres in
        touch at one diameter, a second shell (in two parts where all are of one size), and ever less order further
        out. Sharp peaks there would be a crystal.""",
    "calibration": """Calibration: Poisson's ratio depends on one parameter of the bonds, and the modulus is
        proportional to that of the bonds; so one root and one division do.""",
    "tension": """Tension of the free specimen. Left: stress over strain along and across the pull, every packing.
        Right: displacement of every element of the first; E and ν are read from the affine field (line) that fits
        the middle half best.""",
    "profiles": """Motion of the cross-sections of the clamped specimen under an axial force, a transverse force and
        a torque, against Euler–Bernoulli theory.""",
    "cells": """The body under a transverse force: its cells as polyhedra, which move as rigid pieces, and a section
        along the axis, coloured by the mean axial stress of each cell.""",
    "modes": "First natural modes of the clamped specimen, exaggerated; bright elements move farthest.",
    "vibration": """Free vibration after release from a combined load: mean motion of the free end, and its spectrum
        with the frequency of the mode and those of theory.""",
    "wave": """Impact: one face is pushed at a held velocity; the wave has arrived when the far face, free and so
        twice as fast, passes half of its plateau.""",
    "strength": """Tests to failure: stress over strain as each test has them (below), every packing, and the strength
        that was put in, where that has a closed form.""",
    "broken": """The first specimen as it broke, its motion exaggerated: cells as polyhedra, coloured by the damage of
        their facets, or by their plastic slip.""",
    "pieces": """Cracks are facets that have lost half of their strength or more. Left: what the others join, each
        piece in a colour of its own, its motion exaggerated. Right: surfaces of cracks, coloured by their opening.""",
    "cut_open": """Sections of the first specimen: aggregates in grey, matrix in sand. Red: facets that have cracked,
        the wider the more of their strength is lost.""",
    "energies": """Energies of the first specimen as its curve goes: what the work of the load (dashed) has turned
        into.""",
    "errors": "All tests at a glance: means over the packings with their scatter.",
}


# Where these say something else of a body of cells.
_OF_CELLS = {
    "specimen": "The specimen: its cells, coloured by size; one half is cut open along the axis.",
    "geode": """Directions of the lines between neighbouring cells, counted on the 320 faces of a geode and divided by
        what an isotropic fabric would have there.""",
    "contacts": """Left: facets of a cell with its neighbours, with their mean. Right: radii of the spheres that
        cells were cut from.""",
    "layering": "Solid fraction of the spheres the cells were cut from, against the distance from each wall.",
    "distribution": """How often centres of the spheres the cells were cut from lie at a distance from each other,
        over what chance would do.""",
}


@dataclass(frozen=True)
class Picture:
    """A figure as the page embeds it: its caption and its PNG as base64."""

    caption: str
    data: str


def write_report(
    findings: Findings,
    out: Path,
    *,
    figures: bool = True,
    progress: Callable[[float], None] | None = None,
) -> None:
    """Write `report.html` and, where wanted, `figures/*.png` into a folder.

    Args:
        findings: what to report.
        out: an existing folder.
        figures: whether to draw.
        progress: told the share done, 0 … 1.
    """
    drawings = drawings_of(findings) if figures else {}
    pictures: dict[str, Picture] = {}
    if drawings:
        (out / "figures").mkdir(exist_ok=True)
    for done, (name, draw) in enumerate(drawings.items()):
        if progress is not None:
            progress(done / len(drawings))
        path = out / "figures" / f"{name}.png"
        draw(path)
        caption = _OF_CELLS.get(name, CAPTIONS[name]) if findings.specimens[0].lattice.cells else CAPTIONS[name]
        if name == "errors" and findings.published:
            caption += " Ticks: what is in print (unsigned)."
        data = base64.b64encode(path.read_bytes()).decode("ascii")
        pictures[name] = Picture(" ".join(caption.split()), data)
    write_text(out / "report.html", page(findings, pictures))
    if progress is not None:
        progress(1.0)


def drawings_of(findings: Findings) -> dict[str, Callable[[Path], None]]:
    """What draws each figure a study has the data for; the first packing stands for all."""
    first = findings.specimens[0]
    drawings: dict[str, Callable[[Path], None]] = {
        "specimen": lambda path: (draw_specimen if first.lattice.cells is None else draw_body)(path, first.lattice),
        "geode": lambda path: draw_geode(path, first.quality),
        "contacts": lambda path: draw_contacts(path, first.lattice),
    }
    layering = wall_layering(first.lattice.particles)
    if layering:
        drawings["layering"] = lambda path: draw_layering(path, layering, first.quality.core_volume_fraction)
    with suppress(InputError):  # too few elements away from the walls
        distribution = radial_distribution(first.lattice.particles)
        drawings["distribution"] = lambda path: draw_distribution(path, distribution)
    if findings.fit is not None:
        drawings["calibration"] = lambda path: draw_free_parameter(path, findings)
    if first.tension is not None:
        drawings["tension"] = lambda path: draw_tension(path, findings)
    if any(name.startswith("static") for name in first.outcomes):
        drawings["profiles"] = lambda path: draw_profiles(path, first)
    if "axial_stress" in getattr(first.outcomes.get("static_bending"), "curves", {}):
        drawings["cells"] = lambda path: draw_bent(path, first)
    if first.frequencies is not None:
        drawings["modes"] = lambda path: draw_modes(path, first)
        drawings["vibration"] = lambda path: draw_vibration(path, first)
    if "impact" in first.outcomes:
        drawings["wave"] = lambda path: draw_wave(path, first)
    if any(name in first.outcomes for name in DRAWN):
        drawings["strength"] = lambda path: draw_curves(path, findings)
        drawings["broken"] = lambda path: draw_broken(path, first)
        drawings["pieces"] = lambda path: draw_pieces(path, first)
        if first.aggregates is not None:
            drawings["cut_open"] = lambda path: draw_cut_open(path, first)
        if any(first.outcomes[name].energy for name in DRAWN if name in first.outcomes):
            drawings["energies"] = lambda path: draw_energies(path, first)
    if any(row["error"] is not None for row in findings.results["tests"].values()):
        drawings["errors"] = lambda path: draw_errors(path, findings)
    return drawings


def templates() -> Environment:
    """Where pages are made from; a name that is not there raises."""
    return Environment(
        loader=PackageLoader("bondem.report"), autoescape=select_autoescape(), undefined=StrictUndefined,
        trim_blocks=True, lstrip_blocks=True,
    )  # fmt: skip


def page(findings: Findings, pictures: dict[str, Picture]) -> str:
    """The HTML of the report."""
    environment = templates()
    environment.filters |= {
        "quantity": with_unit,
        "percent": percent,
        "signed": signed_percent,
        "difference": signed,
    }
    rows = rows_of(findings)
    law = findings.bonds.law if findings.bonds is not None else None
    return environment.get_template("report.html").render(
        findings=findings,
        results=findings.results,
        pictures=pictures,
        turning=turning_of(findings.specimens[0]) if pictures else None,
        rows=rows,
        bonds=named(type(law).__name__) if law is not None else None,
        free=findings.fit.law.free if findings.fit is not None else None,
        worst=max((row for row in rows if row["error"] is not None), key=lambda row: abs(row["error"]), default=None),
        quality=quality_rows(findings.specimens),
        shape=measures(findings.specimens[0].lattice.particles.envelope),
        failures=[(part, type(one).__name__, told(one)) for part, one in findings.failures.items()],
        today=date.today().isoformat(),
    )


def rows_of(findings: Findings) -> list[dict[str, Any]]:
    """Rows of the table of tests: the aggregate, the other theories and the published error."""
    rows = []
    for name, row in findings.results["tests"].items():
        outcomes = [one.outcomes[name] for one in findings.specimens]
        rows.append({
            "name": name.replace("_", " "),
            **row,
            "error_timoshenko": _mean([one.error_timoshenko for one in outcomes]),
            "error_refined": _mean([one.error_refined for one in outcomes]),
            "free_vibration": _mean([_number(one.curves.get("free_vibration")) for one in outcomes]),
            "published": findings.published.get(name),
            "told": {key: _mean([one.told.get(key) for one in outcomes]) for key in outcomes[0].told},
        })  # fmt: skip
    return rows


def _number(value: object) -> float | None:
    return None if value is None else float(np.asarray(value))


def _mean(values: list[float | None]) -> float | None:
    known = [value for value in values if value is not None]
    return sum(known) / len(known) if known else None
