"""Test programme: several specimens of one material, law and criterion, each with its own tests."""

import dataclasses
import hashlib
import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from bondem.errors import StudyError
from bondem.labtests.failure_tests import FAILURE_TESTS
from bondem.study.keys import SEVERAL, STUDY
from bondem.study.study_file import Study, parse_study, read_toml, source_of
from bondem.study.toml_table import TomlTable

# Keys of a specimen of a programme in addition to those of [specimen], and its tables of options of tests.
_OWN, _OPTIONS = ("name", "tests"), tuple(name for name, test in FAILURE_TESTS.items() if test.options)
_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9 _-]{0,59}")
# Names that the results of the programme itself use.
_OWN_NAMES = ("figures",)


@dataclass(frozen=True, kw_only=True)
class Series:
    """Specimen of a test programme with its tests.

    Attributes:
        name: name of the specimen.
        study: packings and tests of the specimen.
        targets: target strengths by test [Pa].
        inputs: hash of the study of the specimen, with its shared tables, and of the files that it names.
    """

    name: str
    study: Study
    targets: Mapping[str, float] = field(default_factory=dict)
    inputs: str = ""

    @property
    def folder(self) -> str:
        """Folder of the results, within that of the programme."""
        return self.name.lower().replace(" ", "-")


@dataclass(frozen=True, kw_only=True)
class Programme:
    """Test programme: specimens of one material and the tests of each; equal names raise StudyError.

    Attributes:
        name: title of the report.
        series: specimens, in the order of the file.
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
                    f"[[specimens]] has two with the name '{one.name}' (case, spaces and hyphens do not distinguish"
                    " names); give each its own name"
                )

    def changed(self, *, packings: int | None = None, seed: int | None = None) -> "Programme":
        """Return a copy with another number of packings or first seed of all specimens; None for no change."""
        series = tuple(
            dataclasses.replace(one, study=one.study.changed(packings=packings, seed=seed)) for one in self.series
        )
        return dataclasses.replace(self, series=series)


def read(path: str | Path) -> Study | Programme:
    """Read a study with one [specimen], or a test programme with several [[specimens]].

    Raises:
        StudyError: no such file, not TOML, or a key that is unknown, missing or out of range.
    """
    path = Path(path)

    def either(data: dict[str, Any]) -> Study | Programme:
        if "campaign" in data:
            raise StudyError("'campaign': the file is a campaign; use bondem campaign")
        if isinstance(data.get("specimen"), list):
            raise StudyError(
                "'specimen' is a list of tables; write [[specimens]] for several specimens, [specimen] for one"
            )
        if "specimens" in data:
            return parse_programme(data, folder=path.parent)
        return parse_study(data, folder=path.parent)

    found = read_toml(path, either)
    return dataclasses.replace(found, source=source_of(path))


def parse_programme(data: Mapping[str, Any], *, folder: Path = Path()) -> Programme:
    """Create the test programme of a TOML document.

    Args:
        data: the document.
        folder: folder of the files that it names.

    Raises:
        StudyError: a key that is unknown, missing or out of range.
    """
    _refuse_keys_of_a_study(data)
    tables = data["specimens"]
    if not isinstance(tables, list) or not tables or not all(isinstance(one, Mapping) for one in tables):
        raise StudyError("'specimens' is not a list of tables; write [[specimens]] above each, at least once")
    shared = {key: value for key, value in data.items() if key not in ("specimens", "targets")}
    top = TomlTable(data, STUDY)
    name, targets = top.text("name"), _targets(top.section("targets"), tuple(FAILURE_TESTS))
    _refuse_bonds(shared)
    series = tuple(_series(name, shared, one, k, targets=targets, folder=folder) for k, one in enumerate(tables))
    _require_tests("failure" in data, targets, [one.study for one in series])
    return Programme(name=name, series=series)


def _refuse_keys_of_a_study(data: Mapping[str, Any]) -> None:
    if "specimen" in data:
        raise StudyError(
            "[specimen] and [[specimens]] are both given; give [specimen] for one, or [[specimens]] for several,"
            " not both"
        )
    if "tests" in data:
        raise StudyError("'tests' belongs to each specimen of a programme; write it under its [[specimens]]")
    for option in _OPTIONS:
        if option in data:
            raise StudyError(f"[{option}] belongs to a specimen of a programme; write [specimens.{option}] below it")


def _refuse_bonds(shared: Mapping[str, Any]) -> None:
    """Raise StudyError for bonds, whose calibration on each specimen would give one material several laws."""
    bond = shared.get("bond", {})
    if not isinstance(bond, Mapping) or bond.get("law") != "CellBond":
        raise StudyError(
            '[[specimens]] share one law, which is not calibrated per specimen; set law = "CellBond" in [bond], or'
            " write a study for each"
        )


def _require_tests(failing: bool, targets: Mapping[str, float], studies: Sequence[Study]) -> None:
    """Check that [failure] and every target have a test, and that a target has equal options in all its tests."""
    asked = {test: [one.options.get(test) for one in studies if test in one.tests] for test in FAILURE_TESTS}
    if failing and not any(asked.values()):
        raise StudyError(
            f"[failure] is given, but no specimen is tested to failure; add one of {', '.join(FAILURE_TESTS)}"
            " to its 'tests'"
        )
    for test in targets:
        if not asked[test]:
            raise StudyError(f"'targets.{test}' is given, but no specimen has this test; add it, or leave it out")
        if any(option != asked[test][0] for option in asked[test]):
            raise StudyError(
                f"'targets.{test}' is given, but the options of this test differ between specimens; give each"
                " specimen its own [specimens.targets]"
            )


def _series(
    title: str, shared: Mapping[str, Any], table: Mapping[str, Any], k: int, *, targets: Mapping[str, float],
    folder: Path,
) -> Series:  # fmt: skip
    """Create the study of specimen k, from its own table and the shared ones."""
    where = TomlTable(table, SEVERAL, f"specimens[{k}]")
    name = where.text("name")
    if not _NAME.fullmatch(name) or name.lower() in _OWN_NAMES:
        raise StudyError(
            f"'specimens[{k}].name' = '{name}': not a folder name for its results; use letters, digits, spaces,"
            f" - and _ only, and not {', '.join(_OWN_NAMES)}"
        )
    tests = where.texts("tests", default=())
    if not tests:
        raise StudyError(
            f"'specimens[{k}].tests' is missing or empty; give the tests of '{name}', or leave out the specimen"
        )
    options = {key: table[key] for key in _OPTIONS if key in table}
    inside = {key: value for key, value in table.items() if key not in (*_OWN, *options, "targets")}
    document = dict(shared) | options | {"name": f"{title}: {name}", "specimen": inside, "tests": list(tests)}
    if not any(test in FAILURE_TESTS for test in tests):
        document.pop("failure", None)
        grains = document.get("aggregates")
        if isinstance(grains, Mapping):
            document["aggregates"] = {key: grains[key] for key in grains if key not in ("failure", "interface")}
    try:
        study = parse_study(document, folder=folder)
    except StudyError as error:
        raise StudyError(f"specimen '{name}': {error}") from None
    wanted = {**targets, **_targets(where.section("targets"), tests)}
    found = {test: wanted[test] for test in tests if test in wanted}
    return Series(name=name, study=study, targets=found, inputs=document_hash(document, folder))


def _targets(table: TomlTable, tests: Sequence[str]) -> dict[str, float]:
    """Read the target strengths of tests to failure, by test [Pa]."""
    with table:
        found = {test: table.number(test, default=None) for test in tests if test in FAILURE_TESTS}
    return {test: value for test, value in found.items() if value is not None}


def document_hash(document: Mapping[str, Any], folder: Path) -> str:
    """Compute the hash of a study as a TOML document, and of the files in `folder` that it names."""
    digest = hashlib.sha256(json.dumps(document, sort_keys=True, default=str).encode())
    for key in ("particles", "file"):
        if key in document["specimen"]:
            digest.update((folder / document["specimen"][key]).read_bytes())
    return digest.hexdigest()
