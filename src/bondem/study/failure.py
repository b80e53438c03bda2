"""Table [failure] of a study: failure criterion of the material."""

from typing import Any

from bondem.damage.bilinear import Bilinear
from bondem.damage.criteria.criterion import BondCriterion, Criterion
from bondem.damage.criteria.drucker_prager import DruckerPrager
from bondem.damage.criteria.elliptic import Elliptic
from bondem.damage.criteria.hydrostatic import Hydrostatic
from bondem.damage.criteria.linear_sum import LinearSum
from bondem.damage.criteria.mohr_coulomb import MohrCoulomb
from bondem.damage.criteria.peripheral_stress import PeripheralStress
from bondem.damage.criteria.rankine import Rankine
from bondem.errors import InputError, StudyError
from bondem.labtests.failure_tests import FAILURE_TESTS
from bondem.study.toml_table import TomlTable

#: Criteria of bonds between spheres, with their keys; the first ones are needed.
_OF_BONDS: dict[type[BondCriterion], tuple[str, ...]] = {
    PeripheralStress: ("tension", "shear"), LinearSum: ("force", "shear_force", "bending", "twisting"),
    Elliptic: ("elongation", "rotation"),
}  # fmt: skip
#: Criteria by name.
CRITERIA = (Rankine, Hydrostatic, DruckerPrager, MohrCoulomb, *_OF_BONDS)


def read_failure(table: TomlTable) -> Criterion:
    """Read the failure criterion of a table.

    Raises:
        StudyError: a key that is unknown, missing or out of range.
    """
    with table:
        name = table.text("criterion")
        for kind, keys in _OF_BONDS.items():
            if name == kind.__name__:
                given: dict[str, Any] = {key.removesuffix("_force"): table.number(key) for key in keys}
                if kind is PeripheralStress:
                    given["beta"] = table.number("beta", default=PeripheralStress.beta)
                    given |= {key: table.number(key, default=None) for key in _ENERGIES}
                return _made(table, kind, given)
        if name == DruckerPrager.__name__:
            strengths = ("tension", "compression", "hydrostatic")
            given = {one: table.number(one, default=None) for one in strengths}
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
        given["fracture_energy"] = table.number("fracture_energy", default=None)
        given["fracture_energy_shear"] = table.number("fracture_energy_shear", default=None)
        given["dilatancy"] = table.number("dilatancy", default=0.0)
        given["band_width"] = table.number("band_width", default=None)
        return _made(table, MohrCoulomb, given | {"curve": _curve(table)})


# Fracture energies of bonds that soften.
_ENERGIES = ("fracture_energy", "fracture_energy_shear")


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
        StudyError: one without the other, a criterion of cells for bonds between spheres or vice versa, a test of
            cells only, or cells without shear strength for "ucs" or "triaxial".
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
    name = type(failure).__name__
    if not cells:
        if not isinstance(failure, BondCriterion):
            raise StudyError(
                f'\'failure.criterion\' = "{name}" is one of cells; set law = "CellBond" in [bond], or a criterion of'
                f" bonds: {', '.join(kind.__name__ for kind in _OF_BONDS)} or MohrCoulomb"
            )
        only = [one for one in asked if not FAILURE_TESTS[one].bonded]
        if only:
            raise StudyError(f"'tests' contains {only[0]}, a test of cells; set law = \"CellBond\" in [bond]")
        return
    if isinstance(failure, BondCriterion) and failure.needs_beams:
        raise StudyError(
            f"'failure.criterion' = \"{name}\" is one of bonds between spheres; leave out law = \"CellBond\" in"
            ' [bond], or set criterion = "MohrCoulomb"'
        )
    softening = failure.softening
    if softening is None and isinstance(failure, MohrCoulomb):
        raise StudyError("key 'failure.fracture_energy' is missing; cells need it to crack and to yield")
    slipping = [name for name in asked if FAILURE_TESTS[name].yields]
    if slipping and (softening is None or softening.slip is None):
        raise StudyError(
            f"'tests' contains {slipping[0]}, which needs a shear strength; set criterion = \"MohrCoulomb\", or"
            ' "DruckerPrager" with a fracture_energy'
        )
