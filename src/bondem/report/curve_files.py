"""Export of the curves of a report as CSV files with names and SI units in their first line."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from bondem.io.atomic import make_folder
from bondem.io.csv_table import write_csv
from bondem.report.findings import Examined, Findings

#: Folder of the files within that of the results.
CURVES = "curves"
_Columns = Mapping[str, Any]


def write_curves(findings: Findings, out: Path) -> dict[str, list[str]]:
    """Write the curves of a study into `curves/`.

    Each test has a file per curve and packing. The layering and the distribution of centres are those of the first
    packing. The calibration has one file, and so have the stresses and strains in tension of all packings.

    Args:
        findings: contents of the report.
        out: folder of the results.

    Returns:
        Files by the test or figure that they belong to, relative to `out`.
    """
    tables = _of_specimen(findings.specimens[0]) | _of_calibration(findings)
    written = {name: [_write(out, name, columns)] for name, columns in tables.items()}
    for one in findings.specimens:
        for name, outcome in one.outcomes.items():
            for ending, columns in outcome.tables.items():
                written.setdefault(name, []).append(_write(out, f"{name}{ending}_seed_{one.seed}", columns))
    return written


def _of_specimen(one: Examined) -> dict[str, _Columns]:
    """Return columns of the layering at walls and of the radial distribution of centres by file; none for cells."""
    found: dict[str, _Columns] = {}
    for face, layers in one.layering.items():
        found[f"layering_{face}"] = {
            "distance over mean diameter [-]": layers.distance, "solid fraction [-]": layers.volume_fraction
        }  # fmt: skip
    centres = one.distribution
    if centres is not None:
        found["distribution"] = {"distance over mean diameter [-]": centres.distance, "g(r) [-]": centres.density}
    return found


def _of_calibration(findings: Findings) -> dict[str, _Columns]:
    """Return columns of the calibration curve, and of stress and strains of each packing in tension, by file."""
    found: dict[str, _Columns] = {}
    if findings.fit is not None:
        trials = sorted(findings.chart or findings.fit.table, key=lambda one: one.value)
        found["calibration"] = {
            f"{findings.fit.parameter} [-]": [one.value for one in trials],
            "E / E_mu [-]": [one.stiffness_ratio for one in trials], "nu [-]": [one.nu for one in trials],
        }  # fmt: skip
    pulled = [(one.seed, one.tension) for one in findings.specimens if one.tension is not None]
    if pulled:
        found["tension"] = {
            "seed": [seed for seed, _ in pulled], "stress [Pa]": [one.stress for _, one in pulled],
            "strain along x [-]": [one.strain[0, 0] for _, one in pulled],
            "strain across [-]": [0.5 * (one.strain[1, 1] + one.strain[2, 2]) for _, one in pulled],
        }  # fmt: skip
    return found


def _write(out: Path, name: str, columns: _Columns) -> str:
    make_folder(out / CURVES)
    file = f"{CURVES}/{name}.csv"
    write_csv(out / file, columns, owner="report")
    return file
