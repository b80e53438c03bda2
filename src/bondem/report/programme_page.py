"""Report of a test programme: one HTML page that links the reports of its specimens."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from bondem.damage.criteria.criterion import Criterion
from bondem.io.atomic import write_text
from bondem.report.captions import CAPTIONS
from bondem.report.criterion_text import parameter_texts
from bondem.report.page import Picture, draw_twice, templates
from bondem.report.programme_figure import draw_targets
from bondem.specimen.material import Material

#: Figures of the reports of specimens that the report of the programme repeats, in order.
SHOWN = ("strength", "broken", "pieces", "cut_open", "energies")
_TARGETS = """How far each test is off its target [%], and off what the entered strengths imply [%], where that has a
    closed form."""
_BARS = " Bars: standard deviation over the packings."


@dataclass(frozen=True)
class Chapter:
    """Section of the report on one specimen.

    Attributes:
        name: name of the specimen.
        folder: folder of its results, next to the report.
        shape: readable dimensions.
        results: contents of its `results.json`.
        labels: labels of its tests, by name.
    """

    name: str
    folder: str
    shape: str
    results: Mapping[str, Any]
    labels: Mapping[str, str]


def write_programme(
    title: str, material: Material, failures: Mapping[str, Criterion], rows: Sequence[Mapping[str, Any]],
    chapters: Sequence[Chapter], out: Path, *, figures: bool, origin: Mapping[str, Any],
    source: tuple[str, str] | None = None,
) -> None:  # fmt: skip
    """Write `report.html` and, optionally, `figures/targets.png`.

    Args:
        title: title of the programme.
        material: material of all specimens.
        failures: failure criteria by part of the material.
        rows: rows of the table, measured values with their targets.
        chapters: sections of the specimens, in folders within `out`.
        out: existing folder.
        figures: True to draw the summary and to include the figures of the specimens.
        origin: version, commit, command, date and machine of the run.
        source: name and text of the study file, or None.
    """
    summary = None
    if figures and any(row["off_target"] is not None or row["off_theory"] is not None for row in rows):
        file, scattered = out / "figures" / "targets.png", any(row["scatter"] for row in rows)
        draw_twice(file, lambda path: draw_targets(path, rows))
        summary = Picture.of(file, _TARGETS + (_BARS if scattered else ""))
    pictures = {one.name: _pictures(out / one.folder) if figures else [] for one in chapters}
    page = templates().get_template("programme.html").render(
        title=title,
        material=material,
        failures=[(part, type(one).__name__, parameter_texts(one)) for part, one in failures.items()],
        rows=rows,
        chapters=chapters,
        summary=summary,
        pictures=pictures,
        seconds=sum(sum(one.results["timing"].values()) for one in chapters),
        source=source,
        origin=origin,
    )
    write_text(out / "report.html", page)


def _pictures(folder: Path) -> list[Picture]:
    files = [(name, folder / "figures" / f"{name}.png") for name in ("specimen", *SHOWN)]
    drawn = [(name, file) for name, file in files if file.exists()]
    broken = any(name in SHOWN for name, _ in drawn)
    return [Picture.of(file, CAPTIONS[name]) for name, file in drawn if not broken or name != "specimen"]
