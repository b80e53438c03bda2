"""Sphinx: `sphinx-build -W docs BUILD`, in a clone with `pip install -e ".[docs]"`; it needs no network."""

import os
import sys
from pathlib import Path

import bondem

os.environ["BONDEM_PROGRESS"] = "off"  # of the scripts of the gallery
sys.path.insert(0, str(Path(__file__).parent))

import reference_pages

project = "bondem"
copyright = "the bondem developers"
release = bondem.__version__
extensions = [
    "myst_parser", "sphinx.ext.autodoc", "sphinx.ext.autosummary", "sphinx.ext.napoleon", "sphinx_copybutton",
    "sphinx_gallery.gen_gallery", "formulas", "notebooks", "reference_pages",
]  # fmt: skip
templates_path = ["_templates"]
html_static_path = ["_static"]
html_css_files = ["pages.css"]
html_theme = "furo"
html_title = f"bondem {release}"
html_theme_options = {"top_of_page_buttons": []}
html_show_sourcelink = False
html_math_renderer = "mathml"
# What sphinx-gallery writes beside its pages, of which docs/gallery.md includes the first.
exclude_patterns = ["build", "_templates", "examples/index.rst"]

myst_enable_extensions = ["dollarmath", "amsmath", "colon_fence"]
myst_heading_anchors = 3
# Links from here to the code, the examples and the results lead somewhere in a clone, and nowhere in these pages.
suppress_warnings = ["myst.xref_missing"]

autosummary_generate = True
autosummary_context = {"internal": reference_pages.internal()}
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


sphinx_gallery_conf = {
    "examples_dirs": "../examples/gallery",
    "gallery_dirs": "examples",
    "filename_pattern": r"\.py$",
    "image_scrapers": ("written_pictures",),
    "capture_repr": (),
    "show_memory": False,
    "show_signature": False,
    "write_computation_times": False,
    "download_all_examples": True,
    "copyfile_regex": "",
    "reset_modules": (),
    "within_subsection_order": "FileNameSortKey",
}

linkcheck_timeout = 20
linkcheck_anchors = False
