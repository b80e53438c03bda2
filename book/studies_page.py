"""The tables of `docs/studies.md`, between `<!-- NAME -->` and `<!-- end -->`: from the results of studies."""

import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from book.chapters.packings import DISPERSION, REFINEMENT
from book.errors import BookError
from book.forms import grid
from validation.figures.packing_curves import NAMES

#: Column of a table: name of the quantity, how to print it, and a factor on it.
Column = tuple[str, str, float]

# Of both studies, behind the columns that name a packing; digits of e are for the second.
_DENSITY: dict[str, Column] = {
    "φ": ("volume_fraction", "{:.4f}", 1), "φ of the core": ("core_volume_fraction", "{:.4f}", 1),
    "z": ("coordination_number", "{:.3f}", 1),
}  # fmt: skip
_LAST: dict[str, Column] = {"largest overlap / R̄": ("largest_overlap", "{:.1e}", 1)}
_EXCESS: dict[str, Column] = {
    "rms excess": ("rms_excess", "{:.3f}", 1), "of the core": ("core_rms_excess", "{:.3f}", 1),
}  # fmt: skip
_SECONDS: dict[str, Column] = {"time [s]": ("seconds", "{:.1f}", 1)}
COLUMNS: dict[str, dict[str, Column]] = {
    "dispersion": {
        "κ": ("spread", "{:.0f} %", 100.0), **_DENSITY,
        "z without rattlers": ("backbone_coordination_number", "{:.3f}", 1),
        "e (11), 1e-6": ("isotropy_error", "{:.2f}", 1e6), "e random, 1e-6": ("isotropy_error_random", "{:.2f}", 1e6),
        "χ²/dof": ("chi2_per_dof", "{:.1f}", 1), **_EXCESS, "stretch of the core": ("core_stretch", "{:.3f}", 1),
        **_LAST, "passed": ("passed", "{:d}", 1), "of": ("packings", "{:d}", 1), **_SECONDS,
    },
    "refinement": {
        "elements": ("count", "{:d}", 1), **_DENSITY, "z of the core": ("core_coordination_number", "{:.3f}", 1),
        "e (11), 1e-6": ("isotropy_error", "{:.3f}", 1e6), "e random, 1e-6": ("isotropy_error_random", "{:.3f}", 1e6),
        **_EXCESS, **_LAST, **_SECONDS,
    },
}  # fmt: skip


def filled(page: Path) -> str:
    """The page with its tables as the results have them."""
    text = page.read_text(encoding="utf-8")
    for study in (DISPERSION, REFINEMENT):
        block = _block(study.name, study.data)
        text, found = re.subn(rf"<!-- {study.name} -->.*?<!-- end -->", lambda _, new=block: new, text,
        flags=re.DOTALL)
        if found != 1:
            marks = f"<!-- {study.name} --> and <!-- end -->"
            raise BookError(f"{page} has {found} places for {study.name}; give it {marks}, once")
    return text


def _block(name: str, results: dict[str, Any]) -> str:
    groups = results["summary"]
    made = sum(one["packings"] for one in groups)
    counts = f'{made} packings, {results["failed"]} failed, method "{results["method"]}"'
    tables = _by_target(groups) if name == "refinement" else [_table(name, groups)]
    parts = [f"<!-- {name} -->", f"{counts}, bondem {results['version']}.", _limits(results), *tables, "<!-- end -->"]
    return "\n\n".join(part.strip() for part in parts if part)


def _limits(results: dict[str, Any]) -> str:
    """The limits of a refinement as a table, beside what packings without walls have; "" for another study."""
    lines = []
    for target, found in results.get("limits", {}).items():
        for quantity, fit in found.items():
            if fit is None:
                continue
            free = [one[quantity] for one in results["summary"] if one["periodic"] and one["target"] == target]
            lines.append((
                target, quantity.replace("_", " "), f"{fit['value']:.4f} ± {fit['error']:.4f}",
                " ".join(f"{one['mean']:.4f} ± {one['std'] or 0.0:.4f}" for one in free) or "–",
                f"{fit['walls']:+.3f}", f"{fit['edges']:+.3f}", f"{fit['misfit']:.1f}",
            ))  # fmt: skip
    heads = ("target", "quantity", "N → ∞", "without walls", "a", "b", "χ²/dof of the fit")
    return grid(heads, lines) if lines else ""


def _by_target(groups: Sequence[Mapping[str, Any]]) -> Iterator[str]:
    """Tables of packings of each target, between walls and without."""
    for target in dict.fromkeys(one["target"] for one in groups):
        for periodic, where in ((False, "cube"), (True, "periodic cell, no walls")):
            chosen = [one for one in groups if one["target"] == target and one["periodic"] is periodic]
            if chosen:
                yield f"{NAMES[target].capitalize()}, {where}\n\n{_table('refinement', chosen)}"


def _table(name: str, groups: Sequence[Mapping[str, Any]]) -> str:
    """A table of the means of a study: mean ± standard deviation."""
    columns = COLUMNS[name]
    return grid(list(columns), ([_cell(group, column) for column in columns.values()] for group in groups))


def _cell(group: Mapping[str, Any], column: Column) -> str:
    name, pattern, factor = column
    value = group[name]
    if not isinstance(value, Mapping):
        return pattern.format(factor * value)
    if value["mean"] is None:
        return "–"
    mean = pattern.format(factor * value["mean"])
    return mean if value["std"] is None else f"{mean} ± {pattern.format(factor * value['std'])}"
