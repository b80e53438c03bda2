"""Commented study templates."""

from importlib.resources import files

#: The files in `templates/`, by what one calls them; copies of the repository's examples/.
TEMPLATES = {
    "silica": "silica.toml", "cells": "silica_cells.toml", "concrete": "concrete.toml", "ucs": "ucs.toml",
    "brazilian": "brazilian.toml", "shear": "shear.toml", "crushing": "sphere_crushing.toml",
    "impact": "sphere_impact.toml", "mesoscale": "mesoscale.toml", "rock": "rock.toml",
}  # fmt: skip


def template(name: str, file: str) -> str:
    """Text of a study template, which contains the name of its file."""
    text = (files("bondem.study") / "templates" / TEMPLATES[name]).read_text(encoding="utf-8")
    return text.replace(f"examples/{TEMPLATES[name]}", file)
