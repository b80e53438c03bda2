"""When records were made: by their own date, or by the commit of the code that made them.

Results of studies name a commit and no date. `benchmarks/results/commits.json` has the date of every commit that a
record names, so that pages are the same in a clone without history.
"""

import json
import re
import subprocess
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from typing import Any

from book.results import RESULTS, ROOT, Measurement

COMMITS = RESULTS / "commits.json"
_NAMED = re.compile(r'"(?:commit|kept_with)": "([0-9a-f]{7,40})\+?"')

#: Changes of results, by what they are called in a sentence: when the code had them, and where they are described.
CHANGES = {
    "the compiled core": ("2026-11-26T13:24", "0029-core.md"),
    "softening along present directions": ("2026-11-26T10:54", "0028-softening-along-present-directions.md"),
    "the balanced shares": ("2026-11-27T22:20", "0036-balanced-shares.md"),
    "cracks that keep directions": ("2026-11-28T10:14", "0045-cracks-that-keep-directions.md"),
    "one set of axes for a crack": ("2026-11-29T11:45", "0063-one-set-of-axes-for-a-crack.md"),
    "pressure along cracks of equilibria": ("2026-11-29T17:36", "0069-pressure-along-cracks-of-equilibria.md"),
    "pressure that contacts take over": ("2026-11-29T22:40", "0071-pressure-that-contacts-take-over.md"),
}

#: Records of bodies of cells whose facets fail; of others a change of their softening is no change.
FAILING = frozenset({
    "strength", "brazilian", "load_factors", "concrete", "bending_energy", "mesoscale", "strength_calibration",
    "laws_side_by_side", "concrete_beams", "granite", "glass", "fracture", "size_effect", "fracture_coarse",
    "fracture_fine", "toughness", "kalthoff", "weibull", "ring", "ring_fine", "ring_thin", "branching",
    "branching_fine", "crack_paths", "spall", "kinds_of_loss", "loading_paths",
    "breaking_cells", "breaking_cells_contact",
})  # fmt: skip

#: Those of equilibria alone.
EQUILIBRIA = frozenset({
    "bending_energy", "concrete_beams", "fracture", "fracture_coarse", "fracture_fine", "size_effect", "toughness",
    "weibull",
})  # fmt: skip
#: Those in which bonds of the non-local law, or brittle facets, press on each other after they have failed.
TOUCHING = frozenset({
    "celigueta", "celigueta_full", "celigueta_full_facets", "celigueta_full_slower", "celigueta_platens",
    "celigueta_shear", "celigueta_shear_cone", "celigueta_shear_smaller", "celigueta_slower", "non_local_noise",
    "non_local_reach", "strength_calibration",
})  # fmt: skip
#: Records that a change concerns; all of `FAILING` for others.
_CONCERNED = {
    "cracks that keep directions": FAILING - EQUILIBRIA,
    "one set of axes for a crack": FAILING - EQUILIBRIA,
    "pressure along cracks of equilibria": EQUILIBRIA | {"crack_paths"},
    "pressure that contacts take over": TOUCHING,
}


def keep_dates() -> None:
    """Look up the commits that records name and that have no date yet."""
    known = dict(_dates()) if COMMITS.exists() else {}
    records = set(RESULTS.glob("*.json")) - {COMMITS}
    named = {one for path in records for one in _NAMED.findall(path.read_text(encoding="utf-8"))}
    for commit in sorted(named - set(known)):
        words = ["git", "show", "-s", "--format=%cI", commit]
        done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=False)
        if done.returncode == 0:
            known[commit] = done.stdout.strip()
    made = {"command": "python -m book --measure", "commit": _head(), "dates": dict(sorted(known.items()))}
    if not COMMITS.exists() or known != dict(_dates()):
        COMMITS.write_text(json.dumps(made, indent=1) + "\n", encoding="utf-8")
        _dates.cache_clear()


def date(one: Measurement) -> str:
    """The day on which a record was made; of its commit where it names no day."""
    return _moment(one.made)[:10]


def commit(one: Measurement) -> str:
    """The commit of the code that made a record, or with which it was stored."""
    entry = one.made
    return str(entry.get("commit") or entry.get("kept_with") or "")


def is_older(one: Measurement, change: str) -> bool:
    """Whether a record, or any row of it, was made before a change of `CHANGES`."""
    return any(moment < CHANGES[change][0] for moment in _moments(one.data))


def older_results(chapters: Sequence[tuple[str, Sequence[Measurement]]]) -> dict[str, str]:
    """For each change of the facets that fail, the chapters with results that are older than it.

    Args:
        chapters: a link to each chapter, and its measurements.

    Returns:
        The chapters and their older records in words, by change; changes that all results have are left out.
    """
    found = {}
    for change in list(CHANGES)[1:]:  # the first is no change of facets that fail
        lines, asked = [], _CONCERNED.get(change, FAILING)
        for link, records in chapters:
            names = [one.name for one in records if one.name in asked and is_older(one, change)]
            if names:
                lines.append(f"{link} ({', '.join(f'`{name}`' for name in names)})")
        if lines:
            found[change] = ", ".join(lines)
    return found


def _moments(found: Any) -> Iterator[str]:
    """The moment of each row of a record that names a commit; that of the whole record where no row does."""
    inner = list(_inner(found)) if isinstance(found, Mapping) else []
    if inner:
        yield from inner
    elif isinstance(found, Mapping):
        yield _moment(found)


def _inner(found: Any) -> Iterator[str]:
    for one in found.values() if isinstance(found, Mapping) else found:
        if isinstance(one, Mapping) and ("commit" in one or "kept_with" in one):
            yield _moment(one)
        elif isinstance(one, Mapping | list):
            yield from _inner(one)


def _moment(entry: Mapping[str, Any]) -> str:
    named = str(entry.get("commit") or entry.get("kept_with") or "").rstrip("+")
    return str(entry.get("started") or entry.get("date") or _dates().get(named, ""))


@cache
def _dates() -> Mapping[str, str]:
    return json.loads(COMMITS.read_text(encoding="utf-8"))["dates"]


def _head() -> str:
    words = ["git", "rev-parse", "--short=12", "HEAD"]
    return subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=True).stdout.strip()
