"""Rows of packings as tables: means over seeds, CSV, Markdown, and `results.json`."""

import csv
import io
import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from bondem import __version__
from bondem.io.atomic import write_text
from validation.frame.files import plain

#: Column of a Markdown table: name of the quantity, how to print it, and a factor on it.
Column = tuple[str, str, float]

_MEASURED = (
    "volume_fraction", "core_volume_fraction", "coordination_number", "core_coordination_number",
    "backbone_coordination_number", "loose_share", "isotropy_error", "isotropy_error_random", "chi2_per_dof",
    "rms_excess", "core_rms_excess", "stretch", "core_stretch", "largest_overlap", "seconds",
)  # fmt: skip


def summary(
    rows: Sequence[Mapping[str, Any]], by: tuple[str, ...], measured: Sequence[str] = _MEASURED
) -> list[dict[str, Any]]:
    """Mean and standard deviation of what was measured over the rows that agree in `by`, in order of appearance.

    Returns:
        A dictionary a group: `by`, the number of packings, of those that failed and of those whose fabric passed
        (all, where it was not looked at), and {"mean", "std"} of each quantity, null where there is no number or no
        second one.
    """
    groups: dict[tuple[Any, ...], list[Mapping[str, Any]]] = {}
    for row in rows:
        groups.setdefault(tuple(row[name] for name in by), []).append(row)
    return [_summarised(dict(zip(by, group, strict=True)), members, measured) for group, members in groups.items()]


def _summarised(
    group: dict[str, Any], members: list[Mapping[str, Any]], measured: Sequence[str]
) -> dict[str, Any]:
    good = [row for row in members if not row["error"]]
    found: dict[str, Any] = {
        "packings": len(members),
        "failed": len(members) - len(good),
        "passed": sum(row.get("passed", True) for row in good),
    }
    for name in measured:
        values = np.array([row[name] for row in good if row[name] is not None], dtype=float)
        found[name] = {
            "mean": float(values.mean()) if len(values) else None,
            "std": float(values.std(ddof=1)) if len(values) > 1 else None,
        }
    return group | found


def markdown(columns: Mapping[str, Column], groups: Sequence[Mapping[str, Any]]) -> str:
    """A table of a summary: mean ± standard deviation."""
    lines = [f"| {' | '.join(columns)} |", f"|{'---|' * len(columns)}"]
    lines += [f"| {' | '.join(_cell(group, column) for column in columns.values())} |" for group in groups]
    return "\n".join(lines) + "\n"


def _cell(group: Mapping[str, Any], column: Column) -> str:
    name, pattern, factor = column
    value = group[name]
    if not isinstance(value, Mapping):
        return pattern.format(factor * value)
    if value["mean"] is None:
        return "–"
    mean = pattern.format(factor * value["mean"])
    return mean if value["std"] is None else f"{mean} ± {pattern.format(factor * value['std'])}"


def _is_cell(name: str, value: object) -> bool:
    return name == "reasons" or not isinstance(value, dict | list)


def keep_results(out: Path, results: Mapping[str, Any], table: str) -> dict[str, Any]:
    """Write `results.json`, `table.csv` with a line a row, and `table.md` with the means.

    Returns:
        What `results.json` holds: the results and the version.
    """
    whole = plain({**results, "version": __version__})
    rows = whole["rows"]
    write_text(out / "results.json", json.dumps(whole, indent=1, allow_nan=False) + "\n")
    write_text(out / "table.md", table)
    columns = list(dict.fromkeys(name for row in rows for name, value in row.items() if _is_cell(name, value)))
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(columns)
    for row in rows:
        writer.writerow(["; ".join(row["reasons"]) if name == "reasons" and name in row else row.get(name)
                         for name in columns])  # fmt: skip
    write_text(out / "table.csv", text.getvalue())
    (out / "figures").mkdir(exist_ok=True)
    return whole
