"""Tests to failure of a study: tables of their options, and the specimen that each needs."""

from collections.abc import Mapping

from bondem.errors import StudyError
from bondem.labtests.strengths import NEEDED, OF_BALLS, STRENGTH_TESTS
from bondem.specimen.geometry import Ball, BoundingBox, Box, Cylinder
from bondem.specimen.shape import Cut, Shape
from bondem.study.toml_table import TomlTable

# Names of the faces that the cuts of specimens have; and of a specimen that is no bar either.
NOTCH, BORING, BALL = "notch", "boring", "ball"


def read_options(top: TomlTable, tests: tuple[str, ...]) -> dict[str, dict[str, float]]:
    """Read the options of the requested tests to failure, by test and name.

    Raises:
        StudyError: a table of a test that is not requested, or a key that is unknown, missing or out of range.
    """
    found: dict[str, dict[str, float]] = {}
    for name, options in STRENGTH_TESTS.items():
        if not options:
            continue
        given = top.has(name)
        if given and name not in tests:
            raise StudyError(
                f"[{name}] is given, but 'tests' does not contain {name}; add it there, or leave out [{name}]"
            )
        if name not in tests:
            continue
        with top.section(name) as table:
            asked = {key: _option(table, name, key, unit) for key, unit in options.items()}
        found[name] = {key: value for key, value in asked.items() if value is not None}
    return found


def _option(table: TomlTable, name: str, key: str, unit: str) -> float | None:
    if (name, key) in NEEDED:
        return table.number(key, unit, above=0.0)
    return table.number(key, unit, default=None, above=0.0)


def broken_only(shape: Shape) -> str | None:
    """Reason why a specimen has no tension test: `NOTCH`, `BORING` or `BALL`; None for others."""
    return BALL if isinstance(shape, Ball) else cut_as(shape)


def cut_as(shape: Shape) -> str | None:
    """Cut of a specimen, `NOTCH` or `BORING`; None for an uncut specimen or other cuts."""
    return shape.name if isinstance(shape, Cut) and shape.name in (NOTCH, BORING) else None


def require_specimen(tests: tuple[str, ...], shape: Shape) -> None:
    """Check that a specimen suits its tests to failure.

    Raises:
        StudyError: the specimen does not suit a test.
    """
    cut = cut_as(shape)
    suits: Mapping[str, tuple[bool, str]] = {
        "brazilian": (isinstance(shape, Cylinder), 'a specimen.shape of "cylinder"'),
        "three_point_bending": (
            isinstance(shape, Box | BoundingBox) or cut == NOTCH, 'a specimen.shape of "box", notched or not'
        ),
        "shear": (cut == BORING, 'specimen.shape = "punch"'),
    } | {name: (isinstance(shape, Ball), 'specimen.shape = "ball"') for name in OF_BALLS}
    for name in tests:
        if name in suits and not suits[name][0]:
            raise StudyError(f"'tests' contains {name}, which does not suit this specimen; use {suits[name][1]}")
        if cut is not None and name not in suits:
            raise StudyError(
                f"'tests' contains {name}, but the specimen has a {cut}; write a study for each"
            )
        if isinstance(shape, Ball) and name not in OF_BALLS:
            raise StudyError(f"'tests' contains {name}, which needs a bar; tests of a ball are {', '.join(OF_BALLS)}")
