"""Table [failure] of a study: failure criterion of the material."""

from collections.abc import Callable
from dataclasses import MISSING, Field, fields
from typing import Any

from bondem.damage.bilinear import Bilinear
from bondem.damage.criteria.criterion import Criterion
from bondem.damage.criteria.criterion_catalogue import CRITERIA as EVERY
from bondem.damage.criteria.stress_criterion import StressCriterion
from bondem.errors import StudyError
from bondem.labtests.failure_tests import FAILURE_TESTS
from bondem.study.toml_table import NEEDED, TomlTable, made

#: Criteria of studies by name: all but `StressCriterion`, which is a Python function.
CRITERIA = {name: kind for name, kind in EVERY.items() if kind is not StressCriterion}
# Arguments of a criterion that a study does not give.
_LEFT_OUT = ("scatter", "on")
# Keys of arguments that differ from the name of the argument, and units that differ from that of the key.
_KEYS, _UNITS = {"LinearSum.shear": "shear_force"}, {"DruckerPrager.dilatancy": "-"}


def read_failure(table: TomlTable) -> Criterion:
    """Read the failure criterion of a table, whose keys are the arguments of its class.

    Raises:
        StudyError: a key that is unknown, missing or out of range.
    """
    with table:
        kind = CRITERIA[table.text("criterion")]
        given = {one.name: _argument(table, kind, one) for one in fields(kind) if one.name not in _LEFT_OUT}
        return made(table.name("criterion"), lambda: kind(**given))


def _argument(table: TomlTable, kind: type[Criterion], argument: Field[Any]) -> Any:
    """Read an argument of a criterion from its key; the default of the class if the key is not given."""
    if argument.name == "curve":
        return _curve(table)
    name = f"{kind.__name__}.{argument.name}"
    default = NEEDED if argument.default is MISSING else argument.default
    return table.number(_KEYS.get(name, argument.name), unit=_UNITS.get(name), default=default)


def _curve(table: TomlTable) -> Bilinear | None:
    """Read the softening curve of cracks: None for linear, or a bilinear one, by default with Petersson's kink."""
    if table.text("curve", default="straight") == "straight":
        return None
    usual = Bilinear()
    kink = {one: table.number(f"kink_{one}", default=getattr(usual, one)) for one in ("stress", "opening")}
    return made(table.name("curve"), lambda: Bilinear(**kink))


def require_strength(
    tests: tuple[str, ...], failure: Criterion | None, require: Callable[[Criterion, list[str]], None]
) -> None:
    """Check that tests to failure and a criterion are given together and that the bonds support both.

    `require` is the check of the bonds, a function of the criterion and the names of the tests to failure.

    Raises:
        StudyError: tests to failure or the criterion are missing, or the bonds of the study do not support them.
    """
    asked = [name for name in tests if name in FAILURE_TESTS]
    if failure is None:
        if asked:
            raise StudyError(f"'tests' contains {asked[0]}, which needs [failure]; give it, or leave out the test")
        return
    if not asked:
        raise StudyError(
            f"[failure] is given, but no test needs it; add one of {', '.join(FAILURE_TESTS)} to 'tests'"
        )
    require(failure, asked)
