"""Sphinx: `sphinx-build -W docs BUILD`, from `pip install ".[docs]"`."""

from typing import Any

import bondem

project = "bondem"
copyright = "the bondem developers"
release = bondem.__version__
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx.ext.mathjax"]
html_theme = "furo"
html_title = f"bondem {release}"
exclude_patterns = ["build"]

myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 3
# Links from here to the code, the examples and the results lead somewhere in a clone, and nowhere in these pages.
suppress_warnings = ["myst.xref_missing"]

autodoc_typehints = "none"  # docstrings give types, shapes and units
autodoc_member_order = "bysource"
napoleon_google_docstring = True
napoleon_use_ivar = True
napoleon_use_rtype = False


def escape_bars(app: object, what: str, name: str, thing: object, options: object, lines: list[str]) -> None:
    """|M| is a magnitude and x**2 a power here: to docutils they would be a substitution and bold."""
    lines[:] = [line.replace("|", "\\|").replace("**", "\\*\\*") for line in lines]


def setup(app: Any) -> None:
    """Called by Sphinx."""
    app.connect("autodoc-process-docstring", escape_bars)
