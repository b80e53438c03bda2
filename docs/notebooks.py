"""Sphinx extension: each page of the start and the guides that has code is a notebook to download, too.

A notebook has the text and the code of its page, which the tests run; what the code prints and draws is left out.
"""

import re
from pathlib import Path
from typing import Any

import jupytext
import nbformat

DOCS = Path(__file__).parent
_OUTPUT = re.compile(r"(?<=^```\n)\n```text\n.*?^```\n", re.MULTILINE | re.DOTALL)  # of the code above
_DIRECTIVE = re.compile(r"^```\{.*?^```\n|^:::.*?\n", re.MULTILINE | re.DOTALL)
_TITLE = re.compile(r"^# .*$", re.MULTILINE)
_COMMENT = re.compile(r"^<!--.*?-->\n", re.MULTILINE | re.DOTALL)
_PICTURE = re.compile(r"^!\[.*\n(\n\*.*\*\n)?", re.MULTILINE)
_LINK = re.compile(r"\[([^\]]+)\]\((?!http)[^)]*\)")


def pages() -> list[str]:
    """Names of the pages that become notebooks."""
    found = sorted(path for folder in ("start", "guides") for path in (DOCS / folder).glob("*.md"))
    return [
        path.relative_to(DOCS).with_suffix("").as_posix()
        for path in found if "\n```python\n" in path.read_text(encoding="utf-8")
    ]  # fmt: skip


def notebook(page: str) -> Any:
    """The notebook of a page."""
    text = (DOCS / f"{page}.md").read_text(encoding="utf-8")
    for pattern in (_COMMENT, _OUTPUT, _DIRECTIVE, _PICTURE):
        text = pattern.sub("", text)
    made = jupytext.reads(_LINK.sub(r"\1", text), fmt="md")
    made.metadata["kernelspec"] = {"name": "python3", "display_name": "Python 3", "language": "python"}
    return made


def write(app: Any) -> None:
    """Write the notebooks beside their pages, where Sphinx finds them as downloads."""
    for page in pages():
        nbformat.write(notebook(page), DOCS / f"{page}.ipynb")


def offer(app: Any, page: str, source: list[str]) -> None:
    """Put a link to its notebook below the title of a page."""
    if page in pages():
        link = f"\n\n{{download}}`This page as a notebook <{Path(page).name}.ipynb>`\n"
        source[0] = _TITLE.sub(lambda title: title[0] + link, source[0], count=1)


def setup(app: Any) -> dict[str, bool]:
    """Connect to Sphinx."""
    app.connect("builder-inited", write)
    app.connect("source-read", offer)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
