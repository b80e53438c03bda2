"""Report of a study: one self-contained HTML page, and its figures as PNG files."""

import base64
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape
from PIL import Image

from bondem.errors import ReportWarning, RunFileError
from bondem.interactions.law_catalogue import named
from bondem.io.atomic import make_folder, write_text
from bondem.labtests.failure_tests import FAILURE_TESTS
from bondem.labtests.outcome import Outcome
from bondem.report.breakage_figures import draw_energies, draw_pieces
from bondem.report.captions import CAPTIONS, OF_CELLS
from bondem.report.cell_figures import draw_bent, draw_body
from bondem.report.criterion_text import parameter_texts
from bondem.report.dynamic_figures import draw_modes, draw_vibration, draw_wave
from bondem.report.fabric_figures import draw_distribution, draw_layering
from bondem.report.findings import Findings
from bondem.report.mesoscale_figure import draw_cut_open
from bondem.report.numbers import (
    area,
    between,
    in_unit,
    many,
    measures,
    off_between,
    percent,
    pieces_and_crumbs,
    signed,
    signed_percent,
    with_unit,
)
from bondem.report.quality import quality_rows
from bondem.report.specimen_figures import draw_contacts, draw_geode, draw_specimen
from bondem.report.static_figures import draw_free_parameter, draw_profiles, draw_tension
from bondem.report.strength_figures import draw_broken, draw_curves
from bondem.report.style import narrow
from bondem.report.summary_figures import draw_errors
from bondem.report.turning import turning_of
from bondem.report.turning_cells import turning_cells_of

#: Folder of the figures for phones within that of the figures.
PHONE = "phone"
# Figures of the specimen by the shape of its elements.
_SPECIMENS = {"spheres": draw_specimen, "cells": draw_body}
_TURNING = {"spheres": turning_of, "cells": turning_cells_of}
# Width of a figure that fills the page, 8.2 inches [pixels].
_PAGE = 1804


@dataclass(frozen=True)
class Picture:
    """Figure embedded in the page.

    Attributes:
        caption: text below the figure.
        data: picture as base64, in WebP, which needs a fifth of the size of a PNG.
        narrow: picture for phones as base64, or "".
        share: width over that of the page [-], so that the texts of all figures have one size.
    """

    caption: str
    data: str
    narrow: str = ""
    share: float = 1.0

    @classmethod
    def of(cls, file: Path, caption: str) -> "Picture":
        """Read a PNG from a folder of figures, with its version for phones if there is one."""
        slim = file.parent / PHONE / file.name
        with Image.open(file) as picture:
            share = min(picture.width / _PAGE, 1.0)
        data = (_embedded(one) if one.exists() else "" for one in (file, slim))
        return cls(" ".join(caption.split()), *data, share=share)


def _embedded(file: Path) -> str:
    """Return a picture as WebP in base64."""
    stream = BytesIO()
    with Image.open(file) as picture:
        picture.convert("RGB").save(stream, "WEBP", quality=90)
    return base64.b64encode(stream.getvalue()).decode("ascii")


def write_report(
    findings: Findings,
    out: Path,
    *,
    figures: bool = True,
    progress: Callable[[float], None] | None = None,
) -> None:
    """Write `report.html` and, optionally, `figures/*.png` into a folder.

    A figure that cannot be drawn is left out, with a warning.

    Args:
        findings: results to report.
        out: existing folder.
        figures: True to draw figures.
        progress: callback, called with the completed share [-], 0 … 1.

    Raises:
        RunFileError: a file cannot be written, such as on a full disk.

    Warns:
        ReportWarning: a figure was not drawn.
    """
    drawings = drawings_of(findings) if figures else {}
    pictures: dict[str, Picture] = {}
    undrawn: dict[str, str] = {}
    for done, (name, draw) in enumerate(drawings.items()):
        if progress is not None:
            progress(done / len(drawings))
        path = out / "figures" / f"{name}.png"
        try:
            make_folder(path.parent / PHONE)
            draw(path)
            with narrow():
                draw(path.parent / PHONE / path.name)
        except RunFileError:  # a full disk has no room for the others either
            raise
        except Exception as error:  # results are worth more than a figure
            undrawn[name] = f"{type(error).__name__}: {error}"
            warnings.warn(f"figure {name} was not drawn ({undrawn[name]}); the report lacks it", ReportWarning,
                          stacklevel=2)  # fmt: skip
            continue
        caption = OF_CELLS.get(name, CAPTIONS[name]) if findings.specimens[0].lattice.cells else CAPTIONS[name]
        if name == "errors" and findings.published:
            caption += " Ticks: published errors (unsigned)."
        pictures[name] = Picture.of(path, caption)
    write_text(out / "report.html", page(findings, pictures, undrawn))
    if progress is not None:
        progress(1.0)


def drawings_of(findings: Findings) -> dict[str, Callable[[Path], None]]:
    """Return functions that draw the figures for which a study has data, of the first packing."""
    first = findings.specimens[0]
    drawings: dict[str, Callable[[Path], None]] = {
        "specimen": lambda path: _SPECIMENS[first.lattice.elements.shape_name](path, first.lattice),
    }
    quality = first.quality
    if quality is not None:
        drawings["geode"] = lambda path: draw_geode(path, quality)
        drawings["contacts"] = lambda path: draw_contacts(path, first.lattice)
    if quality is not None and first.layering:
        drawings["layering"] = lambda path: draw_layering(path, first.layering, quality.core_volume_fraction)
    distribution = first.distribution
    if distribution is not None:
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
    if any(name in first.outcomes for name in FAILURE_TESTS):
        drawings["strength"] = lambda path: draw_curves(path, findings)
        drawings["broken"] = lambda path: draw_broken(path, first)
        drawings["pieces"] = lambda path: draw_pieces(path, first)
        if first.aggregates is not None:
            drawings["cut_open"] = lambda path: draw_cut_open(path, first)
        if any(first.outcomes[name].energy for name in FAILURE_TESTS if name in first.outcomes):
            drawings["energies"] = lambda path: draw_energies(path, first)
    if any(row["error"] is not None for row in findings.results["tests"].values()):
        drawings["errors"] = lambda path: draw_errors(path, findings)
    return drawings


@cache
def templates() -> Environment:
    """Template environment of the pages, in which undefined names raise errors; a template is compiled once."""
    environment = Environment(
        loader=PackageLoader("bondem.report"), autoescape=select_autoescape(), undefined=StrictUndefined,
        trim_blocks=True, lstrip_blocks=True,
    )  # fmt: skip
    environment.filters |= {
        "quantity": with_unit, "percent": percent, "signed": signed_percent, "difference": signed, "area": area,
        "pieces_and_crumbs": pieces_and_crumbs, "many": many, "off_between": off_between,
    }  # fmt: skip
    return environment


def page(findings: Findings, pictures: dict[str, Picture], undrawn: Mapping[str, str] | None = None) -> str:
    """Render the report as HTML text, with `pictures` and the errors of `undrawn` figures by name."""
    rows = rows_of(findings)
    first, shape = findings.specimens[0], findings.specimens[0].lattice.elements.shape_name
    turning = dict.fromkeys(_TURNING) | ({shape: _TURNING[shape](first)} if pictures else {})
    law = findings.bonds.law if findings.bonds is not None else None
    return templates().get_template("report.html").render(
        findings=findings,
        results=findings.results,
        pictures=pictures,
        turning=turning["spheres"], cells=turning["cells"],
        contents=_contents(findings, rows, pictures),
        rows=[row for row in rows if not row["failing"]],
        broken=[row for row in rows if row["failing"]],
        bonds=named(type(law).__name__) if law is not None else None,
        free=findings.fit.law.free if findings.fit is not None else None,
        worst=max(
            (row for row in rows if row["error"] is not None and not row["failing"]),
            key=lambda row: abs(row["error"]), default=None,
        ),
        quality=quality_rows(findings.specimens),
        shape=measures(findings.specimens[0].lattice.particles.envelope),
        failures=[(part, type(one).__name__, parameter_texts(one)) for part, one in findings.failures.items()],
        undrawn=undrawn,
    )


def _contents(
    findings: Findings, rows: Sequence[Mapping[str, Any]], pictures: Mapping[str, Picture]
) -> list[tuple[str, str]]:
    """Return anchors and titles of the sections for which the page has contents."""
    macro = findings.results["macro"]
    known = (
        ("failure", "Tests to failure", any(row["failing"] for row in rows)),
        ("theory", "Tests against theory", any(not row["failing"] for row in rows)),
        ("elasticity", "Calibration" if findings.fit else "Elasticity, measured", macro and macro["E"] is not None),
        ("static", "Static tests", "profiles" in pictures), ("vibration", "Vibration", "modes" in pictures),
        ("impact", "Impact", "wave" in pictures),
        ("packing", "Quality of the packing", findings.specimens[0].quality is not None),
        ("study", "Study file", findings.source is not None), ("origin", "Origin", True),
    )  # fmt: skip
    return [(anchor, title) for anchor, title, there in known if there]


def rows_of(findings: Findings) -> list[dict[str, Any]]:
    """Return the rows of the table of tests: mean results, errors against theories, and published errors."""
    rows = []
    for name, row in findings.results["tests"].items():
        outcomes = [one.outcomes[name] for one in findings.specimens]
        rows.append({
            "name": FAILURE_TESTS[name].figure.title if name in FAILURE_TESTS else name.replace("_", " "),
            "key": name,
            "failing": name in FAILURE_TESTS,
            "interval": off_between(None if row["error_95"] is None else [1.0 + one for one in row["error_95"]], 1.0),
            "quantity": FAILURE_TESTS[name].figure.quantity if name in FAILURE_TESTS else "",
            "cracking": outcomes[0].cracking,
            "peak": _peak(name, outcomes, findings.peaks.get(name)),
            **row,
            "error_timoshenko": _mean([one.error_timoshenko for one in outcomes]),
            "error_refined": _mean([one.error_refined for one in outcomes]),
            "free_vibration": _mean([_number(one.curves.get("free_vibration")) for one in outcomes]),
            "published": findings.published.get(name),
            "told": [in_unit(key, _mean([one.told.get(key) for one in outcomes])) for key in outcomes[0].told],
        })  # fmt: skip
    return rows


def _peak(name: str, outcomes: Sequence[Outcome], band: tuple[float, float] | None) -> dict[str, Any] | None:
    """Compare the mean peak of the curves with a measured range; return None without a range."""
    if band is None:
        return None
    found, style = float(np.mean([one.curves["stress"].max() for one in outcomes])), FAILURE_TESTS[name].figure
    off = 0.0 if band[0] <= found <= band[1] else found / (band[0] if found < band[0] else band[1]) - 1.0
    return {"name": f"peak {style.stress}", "value": found, "unit": style.units[1], "off": off,
            "measured": between(*band, style.units[1])}  # fmt: skip


def _number(value: object) -> float | None:
    return None if value is None else float(np.asarray(value))


def _mean(values: list[float | None]) -> float | None:
    known = [value for value in values if value is not None]
    return sum(known) / len(known) if known else None
