"""The page of a study: what came out, its figures and its tables in one HTML file."""

import base64
from collections.abc import Mapping
from datetime import date
from pathlib import Path
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape

from bondem import __version__
from bondem.io.atomic import write_text


def write_study_page(
    out: Path, *, title: str, about: str, verdict: str, captions: Mapping[str, str], note: str = ""
) -> None:
    """Write `report.html`, with the figures and `table.md` of the folder in it.

    Args:
        out: folder of the study, its figures and tables written.
        title: headline.
        about: line below it.
        verdict: what came out, in a few sentences.
        captions: of the figures, by the name of their file in `figures/`, in the order of the page.
        note: below the tables.
    """
    figures = [
        {"caption": caption, "data": base64.b64encode(path.read_bytes()).decode("ascii")}
        for name, caption in captions.items()
        if (path := out / "figures" / f"{name}.png").is_file()
    ]
    text = environment().get_template("dynamic_study.html").render(
        title=title,
        about=about,
        verdict=verdict,
        figures=figures,
        tables=markdown_tables((out / "table.md").read_text(encoding="utf-8")),
        note=note,
        version=__version__,
        today=date.today().isoformat(),
    )
    write_text(out / "report.html", text)


def environment() -> Environment:
    """Templates of pages: strict about what they are told."""
    return Environment(
        loader=PackageLoader("bondem.report"), autoescape=select_autoescape(), undefined=StrictUndefined,
        trim_blocks=True, lstrip_blocks=True,
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
