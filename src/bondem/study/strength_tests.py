"""Tests to failure of a study: reading of their options, and check of the specimen that each needs."""

from bondem.errors import StudyError
from bondem.geometry.shape import Shape
from bondem.labtests.failure_tests import FAILURE_TESTS, OF_BALLS
from bondem.labtests.requirements import BALL, broken_only, cut_as
from bondem.study.toml_table import NEEDED, TomlTable


def read_options(top: TomlTable, tests: tuple[str, ...]) -> dict[str, dict[str, float]]:
    """Read the options of the requested tests to failure, by test and name, in SI.

    Raises:
        StudyError: a table of a test that is not requested, or a key that is unknown, missing or out of range.
    """
    found: dict[str, dict[str, float]] = {}
    for name, test in FAILURE_TESTS.items():
        if not test.options:
            continue
        if top.has(name) and name not in tests:
            raise StudyError(
                f"[{name}] is given, but 'tests' does not contain {name}; add it there, or leave out [{name}]"
            )
        if name in tests:
            with top.section(name) as table:
                usual = {key: NEEDED if one.needed else None for key, one in test.options.items()}
                asked = {key: table.number(key, default=default) for key, default in usual.items()}
            found[name] = {key: value for key, value in asked.items() if value is not None}
    return found


def require_specimen(tests: tuple[str, ...], shape: Shape) -> None:
    """Check that a specimen suits its tests to failure.

    Raises:
        StudyError: the specimen does not suit a test.
    """
    cut, reason = cut_as(shape), broken_only(shape)
    for name in tests:
        required = FAILURE_TESTS[name].requirements if name in FAILURE_TESTS else None
        if required is not None and not required.fits(shape):
            raise StudyError(f"'tests' contains {name}, which does not suit this specimen; use {required.advice}")
        if cut is not None and required is None:
            raise StudyError(f"'tests' contains {name}, but the specimen has a {cut}; write a study for each")
        if reason == BALL and name not in OF_BALLS:
            raise StudyError(f"'tests' contains {name}, which needs a bar; tests of a ball are {', '.join(OF_BALLS)}")
