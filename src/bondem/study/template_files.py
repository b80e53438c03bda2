"""Access to the commented templates of study files."""

from importlib.resources import files

#: Files in `templates/` by template name; copies of the repository's examples/.
TEMPLATES = {
    "silica": "silica.toml", "cells": "silica_cells.toml", "concrete": "concrete.toml", "ucs": "ucs.toml",
    "brazilian": "brazilian.toml", "shear": "shear.toml", "crushing": "sphere_crushing.toml",
    "impact": "sphere_impact.toml", "mesoscale": "mesoscale.toml", "rock": "rock.toml",
}  # fmt: skip


def template(name: str, file: str) -> str:
    """Return the text of a study template, in whose commands the study file has the name `file`."""
    text = (files("bondem.study") / "templates" / TEMPLATES[name]).read_text(encoding="utf-8")
    return text.replace(f"examples/{TEMPLATES[name]}", file)
