"""The pipeline behind `bondem run` of a test programme: each specimen in a folder of its own, and one report."""

import hashlib
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import bondem
from bondem._progress import reported
from bondem.io.atomic import write_text
from bondem.io.commit import commit
from bondem.io.folder import only_writer
from bondem.report.numbers import measures, with_unit
from bondem.report.programme_page import Chapter, write_programme
from bondem.report.strength_figures import DRAWN
from bondem.study.pipeline import Progress, run_study
from bondem.study.programme import Programme, Series
from bondem.study.study import Study

# Written last: what stands beside it is whole.
_FINISHED = "finished.json"


def run_programme(
    programme: Programme, out: str | Path, *, fresh: bool = False, progress: Progress | None = None
) -> dict[str, Any]:
    """Carry out a test programme and leave `results.json`, `report.html` and a folder for each specimen.

    A specimen that was finished in `out` before, by the same file, options and code of bondem, is not run again.

    Args:
        programme: what to do.
        out: folder for the results; made when there is something to put in it.
        fresh: run all specimens again.
        progress: told the specimen with its stage, and the share of it that is done.

    Returns:
        What `results.json` holds: "rows" of the table, and of each specimen its own under "specimens".

    Raises:
        InputError: the folder cannot be written to, another process writes to it, or a study asks for something
            impossible.
        UnstableRunError: a run became unstable. Specimens that were finished before are kept.
    """
    with only_writer(Path(out), "output folder"), reported(progress) as tell:
        return _carry_out(programme, Path(out), fresh, tell)


def _carry_out(programme: Programme, out: Path, fresh: bool, progress: Progress) -> dict[str, Any]:
    found = {one.name: _results(one, out / one.folder, fresh, progress) for one in programme.series}
    rows = [row for one in programme.series for row in _rows(one, found[one.name])]
    study = programme.series[0].study
    assert study.material is not None
    failing = [one.study for one in programme.series if one.study.failure is not None]
    chapters = [_chapter(one, found[one.name]) for one in programme.series]
    results = {"programme": programme.name, "rows": rows, "specimens": found, "version": bondem.__version__,
               "commit": commit()}  # fmt: skip
    write_text(out / "results.json", json.dumps(results, indent=2, allow_nan=False) + "\n")
    failures = failing[0].failures if failing else {}
    write_programme(programme.name, study.material, failures, rows, chapters, out, figures=study.figures,
                    source=programme.source)  # fmt: skip
    return results


def _results(series: Series, folder: Path, fresh: bool, progress: Progress) -> dict[str, Any]:
    """Results of a specimen: those that are there, where they are of the same inputs and code, or new ones."""
    inputs = _inputs(series)
    if not fresh and _read(folder / _FINISHED) == {"inputs": inputs}:
        known = _read(folder / "results.json")
        if known is not None and (folder / "report.html").exists():
            return known
    (folder / _FINISHED).unlink(missing_ok=True)

    def tell(stage: str, share: float) -> None:
        progress(f"{series.name}: {stage}", share)

    run_study(series.study, folder, progress=tell)
    write_text(folder / _FINISHED, json.dumps({"inputs": inputs}) + "\n")
    # As the next time: what a file holds, numbers included.
    return json.loads((folder / "results.json").read_text(encoding="utf-8"))


def _inputs(series: Series) -> str:
    """A hash of all that decides what a specimen leaves: the file, the command line and the code."""
    digest = hashlib.sha256(f"{series.inputs} {series.study.packings} {series.study.seed}".encode())
    digest.update(code_hash().encode())
    return digest.hexdigest()


def code_hash() -> str:
    """Of all of bondem: results of other code are not taken for those of this one."""
    digest = hashlib.sha256()
    for source in sorted(Path(bondem.__file__).parent.rglob("*.py")):
        digest.update(source.read_bytes())
    return digest.hexdigest()


def _read(path: Path) -> dict[str, Any] | None:
    """A JSON file; None where there is none, or a damaged one."""
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None


def _chapter(series: Series, results: Mapping[str, Any]) -> Chapter:
    shape = series.study.specimen.shape
    return Chapter(
        name=series.name,
        folder=series.folder,
        shape=measures(shape) if shape is not None else "particles as they were read",
        results=results,
        labels={test: _label(series.study, test) for test in results["tests"]},
    )


def _rows(series: Series, results: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Rows of the table: E and ν where they were measured, and every test."""
    macro, material = results["macro"], series.study.material
    assert material is not None
    shared = {
        "specimen": series.name, "elements": results["specimen"]["elements"], "packings": len(results["packings"])
    }  # fmt: skip
    rows: list[dict[str, Any]] = []
    if macro["E"] is not None:
        for test, label, unit in (("E", "Young’s modulus E", "Pa"), ("nu", "Poisson’s ratio ν", "-")):
            spread = macro[f"{test}_std"]
            scatter = None if spread is None else spread / abs(macro[test])
            of = {"test": test, "label": label, "unit": unit, "measured": macro[test], "scatter": scatter}
            rows.append(shared | of | _against(macro[test], getattr(material, test), None))
    for test, row in results["tests"].items():
        of = {key: row[key] for key in ("unit", "measured", "scatter")}
        told = {"test": test, "label": _label(series.study, test)}
        rows.append(shared | told | of | _against(row["measured"], series.targets.get(test), row["theory"]))
    return rows


def _against(measured: float, target: float | None, theory: float | None) -> dict[str, float | None]:
    return {
        "target": target, "off_target": None if target is None else measured / target - 1.0,
        "theory": theory, "off_theory": None if theory is None else measured / theory - 1.0,
    }  # fmt: skip


def _label(study: Study, test: str) -> str:
    """A test with the option that makes it what it is."""
    title = DRAWN[test].title if test in DRAWN else test.replace("_", " ").capitalize()
    pressure = study.options.get(test, {}).get("pressure")
    return title if pressure is None else f"{title}, {with_unit(pressure, 'Pa', 3)}"
