"""Table [failure] of a study: failure criterion of the material."""

from typing import Any

from bondem.damage.bilinear import Bilinear
from bondem.damage.criteria.criterion import Criterion
from bondem.damage.criteria.drucker_prager import DruckerPrager
from bondem.damage.criteria.hydrostatic import Hydrostatic
from bondem.damage.criteria.mohr_coulomb import MohrCoulomb
from bondem.damage.criteria.rankine import Rankine
from bondem.errors import InputError, StudyError
from bondem.labtests.failure_tests import FAILURE_TESTS
from bondem.study.toml_table import TomlTable

#: Criteria by name.
CRITERIA = (Rankine, Hydrostatic, DruckerPrager, MohrCoulomb)


def read_failure(table: TomlTable) -> Criterion:
    """Read the failure criterion of a table.

    Raises:
        StudyError: a key that is unknown, missing or out of range.
    """
    with table:
        name = table.text("criterion")
        if name == DruckerPrager.__name__:
            strengths = ("tension", "compression", "hydrostatic")
            given: dict[str, Any] = {one: table.number(one, default=None) for one in strengths}
            given |= _cracks(table)
            given["fracture_energy_shear"] = table.number("fracture_energy_shear", default=None)
            given["dilatancy"] = table.number("dilatancy", unit="-", default=0.0)
            given["band_width"] = table.number("band_width", default=None)
            return _made(table, DruckerPrager, given)
        given = {"tension": table.number("tension")}
        if name in (Rankine.__name__, Hydrostatic.__name__):
            return _made(table, Rankine if name == Rankine.__name__ else Hydrostatic, given | _cracks(table))
        given["cohesion"] = table.number("cohesion")
        given["friction_angle"] = table.number("friction_angle")
        given["fracture_energy"] = table.number("fracture_energy")
        given["fracture_energy_shear"] = table.number("fracture_energy_shear", default=None)
        given["dilatancy"] = table.number("dilatancy", default=0.0)
        given["band_width"] = table.number("band_width", default=None)
        return _made(table, MohrCoulomb, given | {"curve": _curve(table)})


def _cracks(table: TomlTable) -> dict[str, Any]:
    """Options of facets that crack under the stress of the material."""
    return {
        "fracture_energy": table.number("fracture_energy", default=None),
        "friction": table.number("friction", default=0.0),
        "curve": _curve(table),
    }


def _curve(table: TomlTable) -> Bilinear | None:
    """Softening curve of cracks: linear, or bilinear with Petersson's kink by default."""
    if table.text("curve", default="straight") == "straight":
        return None
    usual = Bilinear()
    kink = {one: table.number(f"kink_{one}", default=getattr(usual, one)) for one in ("stress", "opening")}
    try:
        return Bilinear(**kink)
    except InputError as error:
        raise StudyError(f"'{table.name('curve')}': {error}") from None


def _made(table: TomlTable, kind: type[Criterion], given: dict[str, Any]) -> Criterion:
    try:
        return kind(**given)
    except InputError as error:
        raise StudyError(f"'{table.name('criterion')}': {error}") from None


def require_strength(tests: tuple[str, ...], failure: Criterion | None, cells: bool) -> None:
    """Check that tests to failure have a criterion, and that a criterion has a test.

    Raises:
        StudyError: one without the other, bonds between spheres, or a criterion without shear strength for "ucs" or
            "triaxial".
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
    if not cells:
        raise StudyError('[failure] is an option of bodies of cells; set law = "CellBond" in [bond]')
    softening = failure.softening
    slipping = [name for name in asked if FAILURE_TESTS[name].yields]
    if slipping and (softening is None or softening.slip is None):
        raise StudyError(
            f"'tests' contains {slipping[0]}, which needs a shear strength; set criterion = \"MohrCoulomb\", or"
            ' "DruckerPrager" with a fracture_energy'
        )
