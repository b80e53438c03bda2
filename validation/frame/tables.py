"""Rows of packings as tables: means over seeds, CSV, Markdown, and `results.json`."""

import csv
import io
import json
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from bondem import __version__
from bondem.io.atomic import write_text
from validation.frame.files import plain

# Parts of results that tables leave out, and numbers of a list that a cell shows, at most.
_LEFT_OUT, _LISTED = ("rows", "curves", "profile", "code", "commit", "version"), 8

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


def _summarised(group: dict[str, Any], members: list[Mapping[str, Any]], measured: Sequence[str]) -> dict[str, Any]:
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


def _is_cell(name: str, value: object) -> bool:
    return name == "reasons" or not isinstance(value, dict | list)


def tables(results: Mapping[str, Any]) -> str:
    """Tables of what a study found, in Markdown: of single values by their path, and of lists with a line a member.

    Args:
        results: as `results.json` has them; rows, curves and profiles are left out.
    """
    single = list(_values({name: part for name, part in results.items() if name not in _LEFT_OUT}))
    groups = {name: part for name, part in single if isinstance(part, list) and part and _has_names(part[0])}
    found = [_table("Results", ("quantity", "value"), [(name, _cell(part)) for name, part in single
                                                      if name not in groups])]  # fmt: skip
    for name, members in groups.items():
        lines = [dict(_values(one)) for one in members]
        head = list(dict.fromkeys(column for line in lines for column in line))
        found.append(_table(name, head, [[_cell(line.get(column)) for column in head] for line in lines]))
    return "\n".join(found)


def _values(part: Mapping[str, Any], path: str = "") -> Iterator[tuple[str, Any]]:
    """Values of nested dictionaries with their paths; a mean and its scatter are one value."""
    for name, value in part.items():
        if _has_names(value):
            yield from _values(value, f"{path}{name}.")
        else:
            yield f"{path}{name}", value


def _has_names(value: Any) -> bool:
    return isinstance(value, dict) and set(value) != {"mean", "std"}


def _table(caption: str, head: Sequence[str], lines: Sequence[Sequence[str]]) -> str:
    rule = "|".join(["---"] * len(head))
    return "\n".join([caption, "", f"| {' | '.join(head)} |", f"|{rule}|",
                      *(f"| {' | '.join(line)} |" for line in lines), ""])  # fmt: skip


def _cell(value: Any) -> str:
    if isinstance(value, dict):
        return " ± ".join(_cell(part) for part in value.values() if part is not None) or "–"
    if isinstance(value, list):
        return ", ".join(map(_cell, value)) if len(value) <= _LISTED else f"{len(value)} values"
    if value is None:
        return "–"
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def keep_results(out: Path, results: Mapping[str, Any]) -> dict[str, Any]:
    """Write `results.json`, `table.csv` with a line a row, and `table.md` with what was found.

    Returns:
        What `results.json` holds: the results and the version.
    """
    whole = plain({**results, "version": __version__})
    rows = whole["rows"]
    write_text(out / "results.json", json.dumps(whole, indent=1, allow_nan=False) + "\n")
    write_text(out / "table.md", tables(whole))
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
