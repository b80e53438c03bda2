"""`bondem new silica`, `bondem new ucs` …: write a study template."""

import os
from pathlib import Path

import click

from bondem.errors import InputError
from bondem.io.atomic import require_writable, write_text
from bondem.study.template_files import TEMPLATES, template


@click.command("new")
@click.argument("kind", metavar="|".join(TEMPLATES), type=click.Choice(tuple(TEMPLATES)))
@click.argument("file", metavar="[FILE]", type=click.Path(path_type=Path), required=False)
def command(kind: str, file: Path | None) -> None:
    """Write a commented study file as a template.

    The templates silica and rock have beam bonds, which are calibrated; rock also has tests to failure. All others
    have cells, which need no calibration. The templates concrete and mesoscale are test programmes of several
    specimens; ucs, brazilian, shear, crushing and impact are single tests to failure.
    """
    path = file or Path(TEMPLATES[kind])
    if os.path.lexists(path):
        raise InputError(f"FILE = '{path}': the file exists; give another FILE, or move the file")
    require_writable(path, "study file")
    write_text(path, template(kind, str(path)))
    click.echo(f"{path} was written; edit the file, then run  bondem run {path} --out out/")
