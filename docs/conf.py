"""Sphinx: `sphinx-build -W docs BUILD`, in a clone with `pip install -e ".[docs]"`."""

import sys
from pathlib import Path

import bondem

sys.path.insert(0, str(Path(__file__).parent))

project = "bondem"
copyright = "the bondem developers"
release = bondem.__version__
extensions = [
    "myst_parser", "sphinx.ext.autodoc", "sphinx.ext.autosummary", "sphinx.ext.napoleon", "sphinx.ext.mathjax",
    "reference_pages",
]  # fmt: skip
templates_path = ["_templates"]
html_static_path = ["_static"]
html_css_files = ["pages.css"]
html_theme = "furo"
html_title = f"bondem {release}"
html_theme_options = {"top_of_page_buttons": []}
exclude_patterns = ["build", "_templates"]

myst_enable_extensions = ["dollarmath", "amsmath", "colon_fence"]
myst_heading_anchors = 3
# Links from here to the code, the examples and the results lead somewhere in a clone, and nowhere in these pages.
suppress_warnings = ["myst.xref_missing"]

autosummary_generate = True
autosummary_imported_members = True
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
python_use_unqualified_type_names = True
python_maximum_signature_line_length = 80  # one argument per line where a signature is longer
autodoc_member_order = "bysource"
napoleon_google_docstring = True
napoleon_use_ivar = True
napoleon_use_rtype = False
napoleon_attr_annotations = False  # types of arrays as Python prints them; the text has their shapes

linkcheck_timeout = 20
linkcheck_anchors = False
