"""Lists of the core that follow from its headers: criteria on single bonds, and passes over an index.

`python -m tests.core.tables` writes them beside the headers. A criterion is a `BondCriterion` of
`core/laws/criteria/`; its struct says whether facets of cells have it and whether beams soften by it. A pass over an
index is an `inline void` function of `core/gpu/` whose first argument is an index, or a `constexpr` pointer there: to
a pass of the CPU that is called with the range of one index, or to another function of an index. Functions of other
kinds there are `BONDEM_INLINE`.
"""

import re
from pathlib import Path
from textwrap import wrap

CORE = Path(__file__).resolve().parents[2] / "src/bondem/core"
BOND_CRITERIA, INDEX_PASSES = CORE / "laws/criteria/bond_criteria.hpp", CORE / "gpu/index_passes.hpp"
CRITERION = re.compile(r"^struct (\w+) : BondCriterion \{(.*?)^\};", re.DOTALL | re.MULTILINE)
#: Lists of criteria, with the flag of a criterion that belongs to one.
FLAGS = {"BEAM": "", "FACET": "of_facets = true", "SOFTENING": "softens = true"}
INDEX_PASS = re.compile(r"^inline void (\w+)\(Index\b|^constexpr auto (\w+) = ", re.MULTILINE)
# A pass over an index for each criterion of a list.
BY_CRITERION = re.compile(r"constexpr auto (\w+)##name = .*?^BONDEM_(\w+)_CRITERIA\(", re.DOTALL | re.MULTILINE)


def written() -> dict[Path, str]:
    """Return the lists and their texts."""
    return {BOND_CRITERIA: _text_of_criteria(), INDEX_PASSES: _text_of_index_passes()}


def _beside(header: Path) -> list[Path]:
    return sorted(path for path in header.parent.glob("*.hpp") if path != header)


def _criteria() -> dict[str, list[tuple[str, str]]]:
    """Return name and struct of the criteria of each list."""
    found = [(of.stem, *one) for of in _beside(BOND_CRITERIA) for one in CRITERION.findall(of.read_text())]
    return {title: [(name, kind) for name, kind, body in found if flag in body] for title, flag in FLAGS.items()}


def _index_passes() -> list[str]:
    texts = [path.read_text() for path in _beside(INDEX_PASSES)]
    found = [name for text in texts for names in INDEX_PASS.findall(text) for name in names if name]
    families = [one for text in texts for one in BY_CRITERION.findall(text)]
    return found + [f"{of}{name}" for of, title in families for name, _ in _criteria()[title]]


def _text_of_criteria() -> str:
    lines = [
        "// Lists of criteria on single bonds, which `python -m tests.core.tables` writes from the headers here.",
        "//",
        "// A list expands DO(with, name, Criterion) for each criterion, with the name of its header. The names of",
        "// passes end in that name, as in `judge_beams_by_mohr_coulomb`, by which Python finds the passes.",
        "#pragma once", *(f'#include "{name}.hpp"' for name, _ in _criteria()["BEAM"]), "",
    ]  # fmt: skip
    for title, found in _criteria().items():
        each = (f"DO(with, {name}, {kind})" for name, kind in found)
        lines.append(" \\\n    ".join([f"#define BONDEM_{title}_CRITERIA(DO, with)", *each]))
    return "\n".join([*lines, ""])


def _text_of_index_passes() -> str:
    lines = [
        "// List of the passes for a GPU, in each of which a thread computes a single bond, element or other index.",
        "// Written by `python -m tests.core.tables` from the other headers here. The macro applies X to each pass.",
        "#pragma once", *(f'#include "{path.name}"' for path in _beside(INDEX_PASSES)), "",
        "#define BONDEM_INDEX_PASSES(X) \\",
    ]  # fmt: skip
    calls = wrap(" ".join(f"X({one})" for one in _index_passes()), 110)
    return "\n".join([*lines, " \\\n".join(f"    {row}" for row in calls), ""])
