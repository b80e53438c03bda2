"""The page of a study of packings: its figures and numbers in one HTML file."""

import base64
from collections.abc import Mapping
from datetime import date
from pathlib import Path
from typing import Any

from bondem.io.atomic import write_text
from bondem.report.study_page import environment, markdown_tables

_TITLES = {
    "abacus": "Calibration curves",
    "assembly": "Elastic constants and the number of elements",
    "dispersion": "Packings and the dispersion of radii",
    "influence": "Elastic constants and the parameters of bonds",
    "refinement": "Packings and their number of spheres",
    "surface": "Bodies against the bulk",
}


def write_page(out: Path, study: str, results: Mapping[str, Any]) -> None:
    """Write `report.html`, with the figures and `table.md` of the folder in it.

    Args:
        out: folder of the study, its figures and tables drawn.
        study: its name, which is also that of the template.
        results: what `results.json` holds.
    """
    pictures = {
        path.stem: base64.b64encode(path.read_bytes()).decode("ascii") for path in (out / "figures").glob("*.png")
    }
    text = environment().get_template(f"{study}.html").render(
        title=_TITLES[study],
        results=results,
        pictures=pictures,
        tables=markdown_tables((out / "table.md").read_text(encoding="utf-8")),
        seconds=sum(row["seconds"] or 0.0 for row in results["rows"]),
        today=date.today().isoformat(),
    )
    write_text(out / "report.html", text)
