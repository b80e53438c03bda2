"""The JSON schema knows the keys that the reader knows, no more and no fewer, and takes every example."""

import copy
import json
import re
import tomllib
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from click.testing import CliRunner

from bondem.campaign.sweep import parse_campaign, read_campaign
from bondem.cli.schema import command
from bondem.errors import StudyError
from bondem.labtests.failure_tests import FAILURE_TESTS
from bondem.study.keys import schema
from bondem.study.programme import read
from bondem.study.study_file import parse_study
from bondem.study.toml_table import TomlTable
from tests.study.test_hostile_studies import OTHERS, WHOLE

FILES = [*sorted(Path("examples").glob("*.toml")), *sorted(Path("src/bondem/study/templates").glob("*.toml"))]
# Of keys that no example has: enough of a study that the reader comes to ask for them.
CELL = {"shape": "cell", "size": [0.01, 0.01, 0.01], "count": 500}
CRITERIA: list[dict[str, Any]] = [
    {"criterion": "DruckerPrager"}, {"criterion": "Rankine", "tension": 1.0, "curve": "bilinear"},
    {"criterion": "MohrCoulomb", "tension": 1.0, "cohesion": 3.0, "friction_angle": 0.6, "fracture_energy": 1.0},
    {"criterion": "PeripheralStress", "tension": 1.0, "shear": 1.0},
    {"criterion": "LinearSum", "force": 1.0, "shear_force": 1.0, "bending": 1.0, "twisting": 1.0},
    {"criterion": "Elliptic", "elongation": 1e-3, "rotation": 1e-3},
]  # fmt: skip
GRAINS = {"diameters": [1.0, 2.0], "mass_passing": [0.0, 1.0], "fraction": 0.1, "E": 1.0, "nu": 0.1, "gap": 1.0}
SHAPES: list[dict[str, Any]] = [
    {"shape": "ball", "radius": 0.01, "count": 500}, {"shape": "punch"},
    {"shape": "cylinder", "radius": 0.01, "length": 0.02, "count": 500},
    {"shape": "box", "size": [0.03, 0.01, 0.01], "count": 500, "notch": {"width": 1e-3, "depth": 3e-3}},
]  # fmt: skip
MORE: list[dict[str, Any]] = [
    *({"specimen": shape, "tests": [test.name], test.name: dict.fromkeys(test.options, 1.0)}
      for shape in SHAPES for test in FAILURE_TESTS.values()),
    {"specimen": CELL | {"sizes": {"law": "uniform", "spread": 0.1}}},
    *({"specimen": CELL, "failure": one} for one in CRITERIA),
    *({"specimen": CELL, "aggregates": GRAINS | {part: one}}
      for part in ("failure", "interface") for one in CRITERIA),
]  # fmt: skip


def keys_of(table: dict[str, Any], path: str = "") -> set[str]:
    found = set()
    for key, value in table.get("properties", {}).items():
        name = f"{path}.{key}" if path else key
        found |= {name} | keys_of(value.get("items", value), name)
    return found


@pytest.mark.filterwarnings("ignore::bondem.errors.UnitWarning")
def test_it_knows_what_the_reader_knows(monkeypatch, tmp_path):
    asked: set[str] = set()
    get, has = TomlTable._get, TomlTable.has

    def of(table: TomlTable, key: str) -> None:
        asked.add(re.sub(r"\[\d+\]", "", table.name(key)))

    def get_told(self, key, default, wanted):
        of(self, key)
        return get(self, key, default, wanted)

    def has_told(self, key):
        of(self, key)
        return has(self, key)

    monkeypatch.setattr(TomlTable, "_get", get_told)
    monkeypatch.setattr(TomlTable, "has", has_told)
    for file in FILES:
        read_campaign(file) if "[campaign]" in file.read_text() else read(file)
    (tmp_path / "part.stl").write_bytes(Path("examples/bracket.stl").read_bytes())
    (tmp_path / "spheres.csv").write_text("x,y,z,radius\n0,0,0,1\n")
    parse_campaign({"name": "s", "specimen": CELL, "campaign": {"slurm": {"cores": 2}}})
    for data in [WHOLE, *OTHERS, *MORE]:
        for law in (data.get("bond", {}), {"law": "CellBond"}):
            try:
                parse_study({"name": "s", **copy.deepcopy(data), "bond": law}, folder=tmp_path)
            except StudyError:
                continue
    known = keys_of(schema())
    ours = {key for key in asked if not key.startswith("specimens.")}
    assert ours - known == set()
    assert {key for key in known if not key.startswith("specimens")} - ours == set()
    specimens = {key.removeprefix("specimens.") for key in known if key.startswith("specimens.")}
    assert specimens >= {key.removeprefix("specimen.") for key in known if key.startswith("specimen.")}


@pytest.mark.parametrize("file", FILES, ids=str)
def test_it_takes_every_example(file):
    jsonschema.validate(tomllib.loads(file.read_text()), schema())


@pytest.mark.parametrize("wrong", [
    {"specimen": {"cuont": 100}}, {"specimen": {"count": 10}}, {"tests": ["pull"]}, {"seed": "one"},
    {"output": {"figures": 1}}, {"specimens": []},
])  # fmt: skip
def test_it_refuses_what_is_wrong(wrong):
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate({"name": "s", "specimen": {"count": 500}} | wrong, schema())


def test_the_command_prints_it():
    printed = CliRunner().invoke(command)
    assert json.loads(printed.output) == schema()
    jsonschema.Draft202012Validator.check_schema(schema())
