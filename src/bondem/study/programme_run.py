"""Pipeline of `bondem run` for a test programme: a folder for each specimen and one report."""

import hashlib
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import bondem
from bondem._core_build import source_digest
from bondem._progress import reported
from bondem.io.atomic import write_text
from bondem.io.folder import only_writer
from bondem.labtests.failure_tests import FAILURE_TESTS
from bondem.report.numbers import measures, with_unit
from bondem.report.programme_page import Chapter, write_programme
from bondem.study.pipeline import Progress, report_last, run_study
from bondem.study.programme import Programme, Series
from bondem.study.provenance import provenance
from bondem.study.study_file import Study

# Name of the file that is written last, so that its presence marks complete results.
_FINISHED = "finished.json"


def run_programme(
    programme: Programme, out: str | Path, *, fresh: bool = False, progress: Progress | None = None
) -> dict[str, Any]:
    """Run a test programme and write `results.json`, `report.html` and a folder for each specimen.

    Specimens finished in `out` with equal inputs, options and code of bondem are not run again.

    Args:
        programme: the test programme.
        out: folder for the results, created with the first result.
        fresh: True to run all specimens again.
        progress: callback, called with the specimen and its stage, and the share of the stage [-], or None.

    Returns:
        Contents of `results.json`: "rows" of the table, and the results of each specimen under "specimens".

    Raises:
        InputError: the folder cannot be written to, another process writes to it, or a study is not feasible.
        PackingError: a packing did not reach its target.
        RunFileError: a file cannot be written, such as on a full disk.
        UnstableRunError: a run became unstable or lost its energy balance. Finished specimens are kept.
        RunInterrupted: Ctrl-C was pressed during a run. Finished specimens are kept.
    """
    with only_writer(Path(out), "output folder"), reported(progress) as on_stage:
        return _carry_out(programme, Path(out), fresh, on_stage)


def _carry_out(programme: Programme, out: Path, fresh: bool, progress: Progress) -> dict[str, Any]:
    found = {one.name: _results(one, out / one.folder, fresh, progress) for one in programme.series}
    rows = [row for one in programme.series for row in _rows(one, found[one.name])]
    study = programme.series[0].study
    material = study.material
    assert material is not None
    failing = [one.study for one in programme.series if one.study.failure is not None]
    chapters = [_chapter(one, found[one.name]) for one in programme.series]
    origin = provenance()
    results = {"programme": programme.name, "rows": rows, "specimens": found} | origin
    write_text(out / "results.json", json.dumps(results, indent=2, allow_nan=False) + "\n")
    failures = failing[0].failures if failing else {}
    report_last(out, lambda: write_programme(
        programme.name, material, failures, rows, chapters, out, figures=study.figures, origin=origin,
        source=programme.source,
    ))  # fmt: skip
    return results


def _results(series: Series, folder: Path, fresh: bool, progress: Progress) -> dict[str, Any]:
    """Return the stored results of a specimen if inputs and code are equal, or else those of a new run."""
    study = series.study
    made_of = f"{series.inputs} {study.packings} {study.seed} {code_hash()}"  # file, command line and code
    inputs = hashlib.sha256(made_of.encode()).hexdigest()
    if not fresh and read_json(folder / _FINISHED) == {"inputs": inputs}:
        known = read_json(folder / "results.json")
        if known is not None and (folder / "report.html").exists():
            return known
    (folder / _FINISHED).unlink(missing_ok=True)

    def on_stage(stage: str, share: float) -> None:
        progress(f"{series.name}: {stage}", share)

    run_study(study, folder, progress=on_stage)
    write_text(folder / _FINISHED, json.dumps({"inputs": inputs}) + "\n")
    # read from the file, so that new and stored results are equal
    return json.loads((folder / "results.json").read_text(encoding="utf-8"))


def code_hash() -> str:
    """Compute the hash of the source code of bondem, by which results of other versions are recognised."""
    digest = hashlib.sha256()
    for source in sorted(Path(bondem.__file__).parent.rglob("*.py")):
        digest.update(source.read_bytes())
    digest.update(source_digest().encode())
    return digest.hexdigest()


def read_json(path: Path) -> dict[str, Any] | None:
    """Read a JSON file; None if it is missing or damaged."""
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None


def _chapter(series: Series, results: Mapping[str, Any]) -> Chapter:
    shape = series.study.specimen.shape
    return Chapter(
        name=series.name, folder=series.folder, results=results,
        shape=measures(shape) if shape is not None else "particles as they were read",
        labels={test: _label(series.study, test) for test in results["tests"]},
    )  # fmt: skip


def _rows(series: Series, results: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Collect the rows of a specimen for the table: measured E and ν, and every test."""
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
        named = {"test": test, "label": _label(series.study, test)}
        rows.append(shared | named | of | _against(row["measured"], series.targets.get(test), row["theory"]))
    return rows


def _against(measured: float, target: float | None, theory: float | None) -> dict[str, float | None]:
    return {
        "target": target, "off_target": None if target is None else measured / target - 1.0,
        "theory": theory, "off_theory": None if theory is None else measured / theory - 1.0,
    }  # fmt: skip


def _label(study: Study, test: str) -> str:
    """Return the title of a test, with its confining pressure if there is one."""
    title = FAILURE_TESTS[test].figure.title if test in FAILURE_TESTS else test.replace("_", " ").capitalize()
    pressure = study.options.get(test, {}).get("pressure")
    return title if pressure is None else f"{title}, {with_unit(pressure, 'Pa', 3)}"
