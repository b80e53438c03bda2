"""Bring the figures and tables of finished studies of packings into `docs/studies.md`.

    bondem study refinement --out DIR
    python docs/fill_studies.py DIR [DIR ...]

Between `<!-- dispersion -->` and `<!-- end -->` goes the table of that study, likewise for refinement; figures go to
`docs/figures`.
"""

import json
import re
import sys
from pathlib import Path

from PIL import Image

DOCS = Path(__file__).resolve().parent


def fill(study: Path) -> None:
    """Take in one study."""
    results = json.loads((study / "results.json").read_text(encoding="utf-8"))
    name = results["study"]
    for figure in sorted((study / "figures").glob("*.png")):
        # 256 colours: a third of the size, and nobody sees the difference.
        Image.open(figure).convert("RGB").quantize(256).save(DOCS / "figures" / f"study_{figure.name}", optimize=True)
    page = DOCS / "studies.md"
    table = (study / "table.md").read_text(encoding="utf-8")
    counts = f"{len(results['rows'])} packings, {results['failed']} failed, method \"{results['method']}\""
    block = "\n\n".join([f"<!-- {name} -->", f"{counts}, bondem {results['version']}.", limits(results), table])
    text, found = re.subn(
        rf"<!-- {name} -->.*?<!-- end -->",
        lambda _: re.sub(r"\n{3,}", "\n\n", f"{block}\n<!-- end -->"),
        page.read_text(encoding="utf-8"),
        flags=re.DOTALL,
    )
    if not found:
        sys.exit(f"{page} has no place for {name}; add <!-- {name} --> and <!-- end -->")
    page.write_text(text, encoding="utf-8")


def limits(results: dict) -> str:
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


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit("give the folders of finished studies: python docs/fill_studies.py DIR [DIR ...]")
    for folder in sys.argv[1:]:
        fill(Path(folder))
