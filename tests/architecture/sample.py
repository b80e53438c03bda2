"""Draw docstrings and comments of headers at random, to be read by a person.

    python -m tests.architecture.sample --seed 1

A reader decides of each text whether it stands alone and uses the terms of `docs/glossary.md`.
"""

import argparse
import ast
import random
import re
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "src/bondem"
DEFINITION = ast.FunctionDef | ast.ClassDef


def docstrings(root: Path = PACKAGE) -> Iterator[tuple[str, str]]:
    """Place and text of every docstring of the package, private ones included, generated files left out."""
    for path in sorted(root.rglob("*.py")):
        if not {"_tables", "_passes"} & set(path.parts):  # generated
            tree = ast.parse(path.read_text(encoding="utf-8"))
            for node in ast.walk(tree):
                if isinstance(node, DEFINITION | ast.Module) and (text := ast.get_docstring(node)):
                    name = node.name if isinstance(node, DEFINITION) else "module"
                    yield f"{path.relative_to(root)}: {name}", text


def header_comments(root: Path = PACKAGE / "core") -> Iterator[tuple[str, str]]:
    """Place and text of every comment of the core that fills lines of its own; consecutive lines are one comment."""
    for path in sorted([*root.rglob("*.hpp"), *root.rglob("*.cpp"), *root.rglob("*.cu")]):
        if path.parent.name == "build":
            continue
        source = path.read_text(encoding="utf-8")
        for found in re.finditer(r"(?m)(?:^[ \t]*//.*\n)+", source):
            text = re.sub(r"(?m)^[ \t]*//+ ?", "", found[0]).strip()
            if text:
                yield f"{path.relative_to(root)}:{source.count(chr(10), 0, found.start()) + 1}", text


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, required=True, help="number that fixes the draw")
    parser.add_argument("--docstrings", type=int, default=60, help="docstrings to draw")
    parser.add_argument("--comments", type=int, default=20, help="comments of headers to draw")
    options = parser.parse_args()
    draw = random.Random(options.seed)
    for kind, texts, count in (
        ("docstring", list(docstrings()), options.docstrings),
        ("comment", list(header_comments()), options.comments),
    ):
        print(f"{count} of {len(texts)} {kind}s")
        for number, (place, text) in enumerate(draw.sample(texts, count), 1):
            print(f"\n[{number}] {place}\n{text}")


if __name__ == "__main__":
    main()
