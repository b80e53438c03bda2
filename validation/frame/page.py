"""The page of a study: its figures and numbers in one HTML file."""

import base64
from collections.abc import Mapping
from datetime import date
from pathlib import Path
from typing import Any

from jinja2 import ChoiceLoader, Environment, FileSystemLoader, PackageLoader, StrictUndefined, select_autoescape

from bondem.io.atomic import write_text
from validation.frame.study import Study

_TEMPLATES = Path(__file__).parents[1] / "templates"


def write_page(out: Path, study: Study, results: Mapping[str, Any]) -> None:
    """Write `report.html`, with the figures and `table.md` of the folder in it.

    Args:
        out: folder of the study, its figures and tables drawn.
        study: whose page it is.
        results: what `results.json` holds.
    """
    pictures = {
        path.stem: base64.b64encode(path.read_bytes()).decode("ascii") for path in (out / "figures").glob("*.png")
    }
    text = _environment().get_template(study.template).render(
        title=study.title,
        results=results,
        pictures=pictures,
        tables=markdown_tables((out / "table.md").read_text(encoding="utf-8")),
        seconds=sum(row["seconds"] or 0.0 for row in results["rows"]),
        today=date.today().isoformat(),
        **study.page(results),
    )
    write_text(out / "report.html", text)


def _environment() -> Environment:
    """Templates: strict about what they are told; the style is that of the package's own reports."""
    return Environment(
        loader=ChoiceLoader([FileSystemLoader(_TEMPLATES), PackageLoader("bondem.report")]),
        autoescape=select_autoescape(), undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True,
    )  # fmt: skip


def markdown_tables(markdown: str) -> list[dict[str, Any]]:
    """Tables of a Markdown text, each with the line of text above it."""
    tables: list[dict[str, Any]] = []
    caption = ""
    for line in markdown.splitlines():
        if not line.startswith("|"):
            caption = line or caption
            continue
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if set(line) <= set("|-: "):
            continue
        if not tables or tables[-1]["caption"] != caption:
            tables.append({"caption": caption, "head": cells, "rows": []})
        else:
            tables[-1]["rows"].append(cells)
    return tables
