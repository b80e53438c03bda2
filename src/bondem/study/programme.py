"""A test programme: one material, law and failure, and several specimens, each with its own tests."""

import dataclasses
import hashlib
import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from bondem.errors import StudyError
from bondem.labtests.strengths import STRENGTH_TESTS
from bondem.study.study import TESTS, Study, parse_study, read_toml, source_of
from bondem.study.toml_table import TomlTable

# What a specimen of a programme says beside the keys of [specimen], and what a study has in their place.
_OWN, _OPTIONS = ("name", "tests"), tuple(name for name, options in STRENGTH_TESTS.items() if options)
_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9 _-]{0,59}")
# Files of the programme itself.
_TAKEN = ("figures",)


@dataclass(frozen=True, kw_only=True)
class Series:
    """One specimen of a test programme and its tests.

    Attributes:
        name: of the specimen.
        study: its packings and tests.
        targets: strengths to compare with, by test [Pa].
        inputs: a hash of what the file says of it, and of the files that it names.
    """

    name: str
    study: Study
    targets: Mapping[str, float] = field(default_factory=dict)
    inputs: str = ""

    @property
    def folder(self) -> str:
        """Where its results go, within those of the programme."""
        return self.name.lower().replace(" ", "-")


@dataclass(frozen=True, kw_only=True)
class Programme:
    """Specimens of one material, and the tests of each.

    Attributes:
        name: title of the report.
        series: the specimens, in the order of the file.
        source: name and text of the study file, or None.
    """

    name: str
    series: tuple[Series, ...]
    source: tuple[str, str] | None = None

    def __post_init__(self) -> None:
        folders = [one.folder for one in self.series]
        for k, one in enumerate(self.series):
            if one.folder in folders[:k]:
                raise StudyError(
                    f"[[specimens]] has two named '{one.name}' (upper and lower case, spaces and hyphens are one):"
                    " give each a name of its own"
                )

    def changed(self, *, packings: int | None = None, seed: int | None = None) -> "Programme":
        """The same programme with what the command line overrules."""
        series = tuple(
            dataclasses.replace(one, study=one.study.changed(packings=packings, seed=seed)) for one in self.series
        )
        return dataclasses.replace(self, series=series)


def read(path: str | Path) -> Study | Programme:
    """Read a file with one [specimen], a study, or with several [[specimens]], a test programme.

    Raises:
        StudyError: no such file, not TOML, or a key that is unknown, missing or out of range.
    """
    path = Path(path)

    def either(data: dict[str, Any]) -> Study | Programme:
        if "campaign" in data:
            raise StudyError("'campaign': this is a campaign; use bondem campaign")
        if isinstance(data.get("specimen"), list):
            raise StudyError("'specimen' is a list of tables; several specimens are [[specimens]], one is [specimen]")
        if "specimens" in data:
            return parse_programme(data, folder=path.parent)
        return parse_study(data, folder=path.parent)

    found = read_toml(path, either)
    return dataclasses.replace(found, source=source_of(path))


def parse_programme(data: Mapping[str, Any], *, folder: Path = Path()) -> Programme:
    """The test programme a TOML document describes.

    Args:
        data: the document.
        folder: where the files it names are looked for.

    Raises:
        StudyError: a key that is unknown, missing or out of range.
    """
    _refuse_keys_of_a_study(data)
    tables = data["specimens"]
    if not isinstance(tables, list) or not tables or not all(isinstance(one, Mapping) for one in tables):
        raise StudyError("'specimens' is a list of tables; write [[specimens]] above each, at least once")
    shared = {key: value for key, value in data.items() if key not in ("specimens", "targets")}
    top = TomlTable(data)
    name, targets = top.text("name"), _targets(top.section("targets"), tuple(STRENGTH_TESTS))
    _refuse_bonds(shared)
    series = tuple(_series(name, shared, one, k, targets=targets, folder=folder) for k, one in enumerate(tables))
    _require_tests("failure" in data, targets, [one.study for one in series])
    return Programme(name=name, series=series)


def _refuse_keys_of_a_study(data: Mapping[str, Any]) -> None:
    if "specimen" in data:
        raise StudyError("give [specimen], for one, or [[specimens]], for several, not both")
    if "tests" in data:
        raise StudyError("'tests' belongs to each specimen of a programme; write it under its [[specimens]]")
    for option in _OPTIONS:
        if option in data:
            raise StudyError(f"[{option}] belongs to a specimen of a programme; write [specimens.{option}] below it")


def _refuse_bonds(shared: Mapping[str, Any]) -> None:
    """Bonds would be calibrated anew on each specimen, so that one material had several laws."""
    bond = shared.get("bond", {})
    if not isinstance(bond, Mapping) or bond.get("law") != "CellBond":
        raise StudyError(
            '[[specimens]] share one law, which no specimen may calibrate anew: set law = "CellBond" in [bond], or'
            " make a study of each"
        )


def _require_tests(failing: bool, targets: Mapping[str, float], studies: Sequence[Study]) -> None:
    """Make sure that [failure] and every target have a test, and every target one test only."""
    asked = {test: [one.options.get(test) for one in studies if test in one.tests] for test in STRENGTH_TESTS}
    if failing and not any(asked.values()):
        raise StudyError(
            f"[failure] is given, but no specimen is tested to failure; add one of {', '.join(STRENGTH_TESTS)}"
            " to its 'tests'"
        )
    for test in targets:
        if not asked[test]:
            raise StudyError(f"'targets.{test}' is given, but no specimen has this test; add it, or leave it out")
        if any(option != asked[test][0] for option in asked[test]):
            raise StudyError(
                f"'targets.{test}' is given, but the options of this test differ from specimen to specimen; give each"
                " its own [specimens.targets]"
            )


def _series(
    title: str,
    shared: Mapping[str, Any],
    table: Mapping[str, Any],
    k: int,
    *,
    targets: Mapping[str, float],
    folder: Path,
) -> Series:
    """Specimen k, read as a study of its own."""
    where = TomlTable(table, f"specimens[{k}]")
    name = where.text("name")
    if not _NAME.fullmatch(name) or name.lower() in _TAKEN:
        raise StudyError(
            f"'specimens[{k}].name' = '{name}'; its results go to a folder of this name: letters, digits, spaces,"
            f" - and _ only, and not {', '.join(_TAKEN)}"
        )
    tests = where.texts("tests", choices=(*TESTS, *STRENGTH_TESTS), default=())
    if not tests:
        raise StudyError(f"'specimens[{k}].tests' is missing or empty; give what '{name}' is for, or leave it out")
    options = {key: table[key] for key in _OPTIONS if key in table}
    inside = {key: value for key, value in table.items() if key not in (*_OWN, *options, "targets")}
    document = dict(shared) | options | {"name": f"{title}: {name}", "specimen": inside, "tests": list(tests)}
    if not any(test in STRENGTH_TESTS for test in tests):
        document.pop("failure", None)
        grains = document.get("aggregates")
        if isinstance(grains, Mapping):
            document["aggregates"] = {key: grains[key] for key in grains if key not in ("failure", "interface")}
    try:
        study = parse_study(document, folder=folder)
    except StudyError as error:
        raise StudyError(f"specimen '{name}': {error}") from None
    own = _targets(where.section("targets"), tests)
    wanted = {**targets, **own}
    found = {test: wanted[test] for test in tests if test in wanted}
    return Series(name=name, study=study, targets=found, inputs=_hash(document, folder))


def _targets(table: TomlTable, tests: Sequence[str]) -> dict[str, float]:
    """Strengths to compare with [Pa]."""
    with table:
        found = {test: table.number(test, "Pa", default=None, above=0.0) for test in tests if test in STRENGTH_TESTS}
    return {test: value for test, value in found.items() if value is not None}


def _hash(document: Mapping[str, Any], folder: Path) -> str:
    """Of what decides the results of a specimen: the document, and the files that it names."""
    digest = hashlib.sha256(json.dumps(document, sort_keys=True, default=str).encode())
    for key in ("particles", "file"):
        if key in document["specimen"]:
            digest.update((folder / document["specimen"][key]).read_bytes())
    return digest.hexdigest()
