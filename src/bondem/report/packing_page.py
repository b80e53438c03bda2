"""The page of a study of packings: its figures and numbers in one HTML file."""

import base64
from collections.abc import Mapping
from datetime import date
from pathlib import Path
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape

from bondem.io.atomic import write_text

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
    environment = Environment(
        loader=PackageLoader("bondem.report"), autoescape=select_autoescape(), undefined=StrictUndefined,
        trim_blocks=True, lstrip_blocks=True,
    )  # fmt: skip
    pictures = {
        path.stem: base64.b64encode(path.read_bytes()).decode("ascii") for path in (out / "figures").glob("*.png")
    }
    text = environment.get_template(f"{study}.html").render(
        title=_TITLES[study],
        results=results,
        pictures=pictures,
        tables=_tables((out / "table.md").read_text(encoding="utf-8")),
        seconds=sum(row["seconds"] or 0.0 for row in results["rows"]),
        today=date.today().isoformat(),
    )
    write_text(out / "report.html", text)


def _tables(markdown: str) -> list[dict[str, Any]]:
    """Tables of a Markdown text, each with the line of text above it."""
    tables: list[dict[str, Any]] = []
    caption = ""
    for line in markdown.splitlines():
        if not line.startswith("|"):
            caption = line or caption
        elif line.startswith("|---"):
            continue
        else:
            cells = [cell.strip() for cell in line.strip("|").split("|")]
            if not tables or tables[-1]["caption"] != caption:
                tables.append({"caption": caption, "head": cells, "rows": []})
            else:
                tables[-1]["rows"].append(cells)
    return tables
