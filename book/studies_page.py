"""The tables of `docs/studies.md`, between `<!-- NAME -->` and `<!-- end -->`: from the results of studies."""

import re
from pathlib import Path
from typing import Any

from book.chapters.packings import DISPERSION, REFINEMENT
from book.errors import BookError


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
    counts = f'{results["made"]} packings, {results["failed"]} failed, method "{results["method"]}"'
    parts = [f"<!-- {name} -->", f"{counts}, bondem {results['version']}.", _limits(results), results["table"],
        "<!-- end -->"]
    return "\n\n".join(part.strip() for part in parts if part)


def _limits(results: dict[str, Any]) -> str:
    """The limits of a refinement as a table, beside what packings without walls have; "" for another study."""
    lines = ["| target | quantity | N → ∞ | without walls | a | b | χ²/dof of the fit |", f"|{'---|' * 7}"]
    for target, found in results.get("limits", {}).items():
        for quantity, fit in found.items():
            if fit is None:
                continue
            free = [one[quantity] for one in results["summary"] if one["periodic"] and one["target"] == target]
            wall_free = " ".join(f"{one['mean']:.4f} ± {one['std'] or 0.0:.4f}" for one in free) or "–"
            lines.append(
                f"| {target} | {quantity.replace('_', ' ')} | {fit['value']:.4f} ± {fit['error']:.4f} | {wall_free}"
                f" | {fit['walls']:+.3f} | {fit['edges']:+.3f} | {fit['misfit']:.1f} |"
            )
    return "\n".join(lines) if len(lines) > 2 else ""
