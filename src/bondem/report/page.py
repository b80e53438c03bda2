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
from bondem.report.strength_figures import broken_in, draw_broken, draw_curves
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
    findings: Findings, out: Path, *, figures: bool = True, progress: Callable[[float], None] | None = None,
) -> None:  # fmt: skip
    """Write `report.html` and, optionally, `figures/*.png` into a folder.

    A figure that cannot be drawn is left out, with a warning.

    Args:
        findings: results to report.
        out: existing folder.
        figures: True to draw figures.
        progress: callback, called with the completed share [-], 0 … 1, or None.

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
            draw_twice(path, draw)
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


def draw_twice(path: Path, draw: Callable[[Path], None]) -> None:
    """Draw a figure into a PNG, and for phones into a PNG of the same name in the folder `phone` beside it."""
    make_folder(path.parent / PHONE)
    draw(path)
    with narrow():
        draw(path.parent / PHONE / path.name)


def drawings_of(findings: Findings) -> dict[str, Callable[[Path], None]]:
    """Return functions that draw the figures for which a study has data, by the name of the figure."""
    first = findings.specimens[0]
    broken, of_spheres = broken_in(first), first.quality is not None
    compared = any(row["error"] is not None for row in findings.results["tests"].values())
    figures: tuple[tuple[str, Callable[[Path, Any], None], Any, bool], ...] = (
        ("specimen", _SPECIMENS[first.lattice.elements.shape_name], first.lattice, True),
        ("geode", draw_geode, first.quality, of_spheres),
        ("contacts", draw_contacts, first.lattice, of_spheres),
        ("layering", draw_layering, first, bool(first.layering)),
        ("distribution", draw_distribution, first.distribution, first.distribution is not None),
        ("calibration", draw_free_parameter, findings, findings.fit is not None),
        ("tension", draw_tension, findings, first.tension is not None),
        ("profiles", draw_profiles, first, any(name.startswith("static") for name in first.outcomes)),
        ("cells", draw_bent, first, "axial_stress" in getattr(first.outcomes.get("static_bending"), "curves", {})),
        ("modes", draw_modes, first, first.frequencies is not None),
        ("vibration", draw_vibration, first, first.frequencies is not None),
        ("wave", draw_wave, first, "impact" in first.outcomes),
        ("strength", draw_curves, findings, bool(broken)),
        ("broken", draw_broken, first, bool(broken)),
        ("pieces", draw_pieces, first, bool(broken)),
        ("cut_open", draw_cut_open, first, bool(broken) and first.aggregates is not None),
        ("energies", draw_energies, first, any(first.outcomes[name].energy for name in broken)),
        ("errors", draw_errors, findings, compared),
    )
    return {name: lambda path, draw=draw, of=of: draw(path, of) for name, draw, of, has_data in figures if has_data}


@cache
def templates() -> Environment:
    """Return the template environment of the pages, in which undefined names raise errors; made once."""
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
    first = findings.specimens[0]
    shape = first.lattice.elements.shape_name
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
        shape=measures(first.lattice.particles.envelope),
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
            "free_vibration": _mean([one.curves.get("free_vibration") for one in outcomes]),
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


def _mean(values: list[Any]) -> float | None:
    known = [float(value) for value in values if value is not None]
    return sum(known) / len(known) if known else None
