"""Measure again: run the commands behind chapters and take in what they leave."""

import json
import os
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from PIL import Image

from book.dates import keep_dates
from book.errors import BookError
from book.measurements import MEASUREMENTS
from book.printed import PRINTED
from book.quoted import quoted
from book.quoting import TEXTS, templates, written
from book.results import ROOT, Measurement
from validation.frame.sources import commit

BUILD = ROOT / "build" / "book"


def measure(names: list[str], *, build: Path = BUILD, run: bool = True) -> None:
    """Run the commands of some measurements, or of all, and take in their results.

    Args:
        names: of measurements, or pages such as "README.md", which stand for all that they quote; none for all.
        build: folder in which a command leaves its own, as NAME.
        run: False takes in what is there already.

    Raises:
        BookError: no such measurement, or a command that fails.
    """
    known = {one.name: one for one in MEASUREMENTS}
    names = list(dict.fromkeys(one for name in names for one in _meant(name)))
    if unknown := sorted(set(names) - set(known)):
        raise BookError(f"no measurement '{unknown[0]}'; there are {', '.join(known)}, and pages that quote them")
    for name in names or list(known):
        made = commit()
        if run:
            _run(known[name], build)
        _take_in(known[name], build)
        if run:
            sign(known[name], made)
    keep_dates()


def _meant(name: str) -> list[str]:
    """The measurements that a page quotes, and that of what its code prints; else the name itself."""
    template = TEXTS / name
    if template not in templates():
        return [name]
    numbers = quoted()
    asked = written(template, numbers, {"date": str, "older": ""})[1]
    records = [one.record.name for one in numbers if one.name in asked]
    return [*dict.fromkeys(records), PRINTED.name]


def _run(one: Measurement, build: Path) -> None:
    """Run the commands of a measurement anew: cases that they kept in `out`, or in a record they add to, go first."""
    build.mkdir(parents=True, exist_ok=True)
    shutil.rmtree(ROOT / "out" / one.name, ignore_errors=True)
    former = one.path.read_bytes() if one.goes_on and one.path.exists() else None
    if former is not None:
        one.path.unlink()
    try:
        _run_commands(one, build)
    except BaseException:
        if former is not None:
            one.path.write_bytes(former)
        raise


def _run_commands(one: Measurement, build: Path) -> None:
    for command in one.command.split(" && "):
        print(f"{one.name}: {command}", flush=True)
        words = shlex.split(command.replace("BUILD", str(build)))
        words = [*{"python": [sys.executable]}.get(words[0], [str(Path(sys.executable).with_name(words[0]))]),
            *words[1:]]
        # benchmarks import each other
        path = os.pathsep.join(filter(None, (str(ROOT / "benchmarks"), os.environ.get("PYTHONPATH"))))
        done = subprocess.run(words, cwd=ROOT, env=os.environ | {"PYTHONPATH": path}, check=False)
        if done.returncode:
            raise BookError(f"{one.name}: '{command}' ended with status {done.returncode}; see what it printed above")


def sign(one: Measurement, made: str) -> None:
    """Name the command and the commit in results that do not by themselves."""
    text = one.path.read_text(encoding="utf-8")
    if '"commit": "' not in text or '"command": "' not in text:
        signed = {"command": one.command, "commit": made} | json.loads(text)
        one.path.write_text(f"{json.dumps(signed, indent=1, ensure_ascii=False)}\n", encoding="utf-8")


def _take_in(one: Measurement, build: Path) -> None:
    folder = build / one.name
    if one.condense is not None:
        if not folder.exists():
            raise BookError(f"{folder} is not there; run the command too, without --no-run")
        text = json.dumps(one.condense(folder), indent=1, ensure_ascii=False, allow_nan=False)
        one.path.write_text(f"{text}\n", encoding="utf-8")
    for source, target in one.figures.items():
        _take_figure(folder / source, ROOT / "docs" / "figures" / target)


def _take_figure(source: Path, target: Path) -> None:
    """Copy a PNG with 256 colours: a third of the size, and the difference is invisible."""
    target.parent.mkdir(parents=True, exist_ok=True)
    with Image.open(source) as image:
        image.convert("RGB").quantize(256).save(target, optimize=True)
