"""Contents of a study file as frozen data, and the functions that read it."""

import dataclasses
import math
import sys
import tomllib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

from bondem.damage.criteria.criterion import Criterion
from bondem.errors import StudyError
from bondem.geometry.elementary_shapes import BoundingBox, Box, Cylinder, Shape
from bondem.io.text_file import read_text
from bondem.labtests.elastic_tests import ELASTIC_TESTS
from bondem.labtests.failure_tests import FAILURE_TESTS
from bondem.labtests.requirements import broken_only
from bondem.packing import EVEN, SEED
from bondem.specimen import materials
from bondem.specimen.material import Material
from bondem.study.aggregate_grains import AggregatePlan, read_aggregates
from bondem.study.bond_plan import BondPlan, read_bond
from bondem.study.failure import read_failure, require_strength
from bondem.study.keys import STUDY
from bondem.study.lines import located
from bondem.study.specimen_step import ImportPlan, SpecimenPlan, read_specimen
from bondem.study.strength_tests import read_options, require_specimen
from bondem.study.toml_table import NEEDED, TomlTable

Read = TypeVar("Read")
# Quotation marks that word processors substitute for the straight ones of TOML.
_CURLY = {*"\N{LEFT DOUBLE QUOTATION MARK}\N{RIGHT DOUBLE QUOTATION MARK}\N{DOUBLE LOW-9 QUOTATION MARK}"}
#: Elastic tests, which a study runs unless it has its own.
TESTS = tuple(ELASTIC_TESTS)


@dataclass(frozen=True, kw_only=True)
class Reference:
    """Published values with which the report compares the results.

    Attributes:
        citation: source of the values.
        E_mu, r_mu_ratio: bond modulus [Pa] and radius ratio [-], or None.
        errors: error of each test, measured / theory - 1 [-].
        peaks: lowest and highest measured peak of the curve of a test to failure, in its SI unit.
    """

    citation: str
    E_mu: float | None = None
    r_mu_ratio: float | None = None
    errors: Mapping[str, float] = field(default_factory=dict)
    peaks: Mapping[str, tuple[float, float]] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True)
class Study:
    """Contents of a study file, the input of `bondem run`; contents that conflict raise StudyError.

    Attributes:
        name: title of the report.
        material: continuum to reproduce; None to pack and check only.
        specimen: plan of a packing, or of particles to read from a file.
        bond: plan of the bonds and their law.
        failure: failure criterion of the material in tests to failure, or None.
        packings: number of specimens; packing k uses seed + k.
        calibrating: number of packings for the calibration, the first ones.
        tests: names of the tests of each packing.
        options: options of tests to failure by test and name, in SI.
        seed: seed of the first packing.
        figures: True to draw figures.
        vtk: True to write the first packing for ParaView.
        run_files: True to write every specimen with its law, at rest, as a run file for later runs.
        packing_files: True to write every packing with its bonds as a particle file.
        reference: published values, or None.
        aggregates: aggregates in the material, which is their matrix, or None.
        source: name and text of the study file, or None.
    """

    name: str
    material: Material | None
    specimen: SpecimenPlan | ImportPlan
    bond: BondPlan = BondPlan()
    failure: Criterion | None = None
    packings: int = 2
    calibrating: int = 1
    tests: tuple[str, ...] = TESTS
    options: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    seed: int = SEED
    figures: bool = True
    vtk: bool = False
    run_files: bool = False
    packing_files: bool = False
    reference: Reference | None = None
    aggregates: AggregatePlan | None = None
    source: tuple[str, str] | None = None

    def __post_init__(self) -> None:
        if not 1 <= self.calibrating <= self.packings:
            raise StudyError(
                f"'calibration.packings' = {self.calibrating}: more than the {self.packings} packings of the study;"
                " calibrate on fewer, or increase 'packings'"
            )
        if isinstance(self.specimen, ImportPlan) and self.packings > 1:
            raise StudyError(
                f"'packings' = {self.packings}, but 'specimen.particles' is one packing; set packings = 1"
            )
        if self.material is None:
            for key, asked in (("tests", bool(self.tests)), ("output.run_files", self.run_files)):
                if asked:
                    raise StudyError(f"'{key}' needs calibrated bonds; give [material], or leave out '{key}'")
        require_strength(self.tests, self.failure, self.bond.require_criterion)
        if self.tests and isinstance(self.specimen, SpecimenPlan) and self.specimen.method == EVEN:
            self.bond.require_centres()
        if self.aggregates is not None:
            self._require_matrix(self.aggregates)
        if self.specimen.shape is not None:
            self.require_testable(self.specimen.shape)

    def _require_matrix(self, plan: AggregatePlan) -> None:
        """Raise StudyError if specimen, law, tests or criteria do not support the aggregates."""
        if not self.bond.of_cells or isinstance(self.specimen, ImportPlan) or self.specimen.method != EVEN:
            raise StudyError(
                f'[aggregates] is an option of bodies of cells; set law = "CellBond" in [bond], and method = "{EVEN}"'
                " in [specimen]"
            )
        if "spall" in self.tests:
            raise StudyError("'tests' contains spall, which needs a single material; leave out spall or [aggregates]")
        plan.require_room(self.specimen.shape, self.specimen.count)
        plan.require_criteria(self.failure)

    def require_testable(self, shape: Shape) -> None:
        """Check that the requested tests are possible with a shape.

        Raises:
            StudyError: the shape is not a bar along x, or not suitable for a test to failure.
        """
        if broken_only(shape) is not None and self.bond.of_cells and self.tests:
            require_specimen(self.tests, shape)
            return
        if self.material is not None and not _is_prism(shape):
            raise StudyError(
                f"'specimen.shape': a {type(shape).__name__} without flat ends x_min and x_max, or without one"
                " section from end to end, cannot be calibrated; leave out [material] and 'tests' to pack and check"
                " only, or use a cylinder or a box"
            )
        if self.tests and not _is_bar(shape):
            raise StudyError(
                f"'tests' contains {self.tests[0]}, but a {type(shape).__name__} is not a bar along x; set tests ="
                " [], or use a cylinder or box as 'specimen.shape'"
            )
        require_specimen(self.tests, shape)

    @property
    def failures(self) -> dict[str, Criterion]:
        """Failure criteria of the parts of the material, by name; empty without a failure criterion."""
        if self.failure is None:
            return {}
        if self.aggregates is None:
            return {"Failure": self.failure}
        own, between = self.aggregates.failure, self.aggregates.interface
        return {"Matrix": self.failure, "Aggregates": own or self.failure, "Interface": between or self.failure}

    def changed(self, *, packings: int | None = None, seed: int | None = None) -> "Study":
        """Return a copy with another number of packings or first seed; None for no change."""
        given = {"packings": packings, "seed": seed}
        return dataclasses.replace(self, **{key: value for key, value in given.items() if value is not None})


def _is_prism(shape: Shape) -> bool:
    """Return True for a shape of constant section along x, as E is evaluated with the section at mid-length."""
    # volumes of composed shapes are integrated numerically, to about 1e-3
    prism = {"x_min", "x_max"} <= set(shape.faces)
    return prism and math.isclose(shape.volume, shape.section() * shape.extent, rel_tol=0.01)


def _is_bar(shape: Shape) -> bool:
    """Return True for a bar along x whose section has formulas of beam theory."""
    return isinstance(shape, Cylinder | Box | BoundingBox)


def read_study(path: str | Path) -> Study:
    """Read a study file.

    Raises:
        StudyError: no such file, not TOML, a test programme, or a key that is unknown, missing or out of range.
    """
    path = Path(path)

    def one(data: dict[str, Any]) -> Study:
        if "specimens" in data:
            raise StudyError(f"'{path}' has [[specimens]] and is a test programme; give a file with one [specimen]")
        return parse_study(data, folder=path.parent)

    return dataclasses.replace(read_toml(path, one), source=source_of(path))


def source_of(path: Path) -> tuple[str, str]:
    """Return the name and the text of a study file, for its report."""
    return path.name, read_text(path)


def read_toml(path: Path, parse: Callable[[dict[str, Any]], Read]) -> Read:
    """Apply a function to the TOML document of a file; its StudyErrors then state the line of their key.

    Raises:
        StudyError: no such file, not TOML, or an error of the function.
    """
    text = ""
    try:
        text = read_text(path)
        data = tomllib.loads(text)
    except OSError as error:
        raise StudyError(f"study '{path}' cannot be read ({error.strerror}); check the path") from None
    except UnicodeDecodeError as error:
        line = error.object.count(b"\n", 0, error.start) + 1
        raise StudyError(f"study '{path}', line {line}: the text is not UTF-8; save it with that encoding") from None
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        advice = 'texts need straight quotes: "granite"' if _CURLY & {*text} else "correct it there"
        raise StudyError(f"study '{path}' is not valid TOML ({error}); {advice}") from None
    except ValueError:  # the integer has more digits than Python reads
        digits = sys.get_int_max_str_digits()
        raise StudyError(f"study '{path}' has a number of more than {digits} digits; correct it") from None
    try:
        return parse(data)
    except StudyError as error:
        raise located(error, text, str(path)) from None


def parse_study(data: Mapping[str, Any], *, folder: Path = Path()) -> Study:
    """Create the study of a TOML document.

    Args:
        data: the document.
        folder: folder of the files that it names.

    Raises:
        StudyError: a key that is unknown, missing or out of range.
    """
    with TomlTable(data, STUDY) as top:
        name = top.text("name")
        specimen = read_specimen(top.section("specimen"), folder)
        material = top.optional("material", _material)
        bond = read_bond(top.section("bond"))
        bar = specimen.shape is None or _is_bar(specimen.shape)
        tests = top.texts("tests", default=TESTS if material is not None and bar else ())
        study = partial(
            Study, name=name, material=material, specimen=specimen, bond=bond, tests=tests,
            seed=top.count("seed", default=Study.seed),
            packings=top.count("packings", default=1 if isinstance(specimen, ImportPlan) else Study.packings),
            failure=top.optional("failure", read_failure), calibrating=_calibrating(top, bond),
            options=read_options(top, tests), **_output(top.section("output")),
            reference=top.optional("reference", _reference), aggregates=top.optional("aggregates", read_aggregates),
        )  # fmt: skip
    return study()  # an unknown key comes before what its absence brings about


def _material(table: TomlTable) -> Material:
    """Read the material, from all its values or from the library with overridden values."""
    with table:
        usual: dict[str, Any] = {"source": ""}
        if table.has("preset"):
            known = materials.get(table.text("preset"))
            own = [key for key in ("E", "nu", "rho") if table.has(key)]
            remark = f"; {', '.join(own)} overruled by the study" if own else ""
            usual = {**vars(known), "source": known.source + remark}
        name = table.text("name", default=usual.get("name", NEEDED))
        E, nu, rho = (table.number(key, default=usual.get(key, NEEDED)) for key in ("E", "nu", "rho"))
        return Material(name, E=E, nu=nu, rho=rho, source=table.text("source", default=usual["source"]))


def _calibrating(top: TomlTable, bond: BondPlan) -> int:
    if top.has("calibration"):
        bond.require_calibrated()
    with top.section("calibration") as table:
        return table.count("packings", default=Study.calibrating)


def _output(table: TomlTable) -> dict[str, Any]:
    """Read which files to write, by the names of attributes of `Study`."""
    with table:
        names = ("figures", "vtk", "run_files", "packing_files")
        return {name: table.flag(name, default=getattr(Study, name)) for name in names}


def _range(table: TomlTable, name: str) -> tuple[float, float]:
    """Read the lowest and the highest published value of a test.

    Raises:
        StudyError: not two values in ascending order.
    """
    values = table.numbers(name)
    if len(values) != 2 or values[0] > values[1]:
        raise StudyError(f"'{table.name(name)}': not a range; give the lowest and the highest value")
    return values[0], values[1]


def _reference(table: TomlTable) -> Reference:
    with table:
        citation = table.text("citation")
        with table.section("errors") as errors:
            published = {name: errors.number(name) for name in TESTS if errors.has(name)}
        with table.section("peaks") as peaks:
            ranges = {name: _range(peaks, name) for name in FAILURE_TESTS if peaks.has(name)}
        E_mu, ratio = (table.number(key, default=None) for key in ("E_mu", "r_mu_ratio"))
        return Reference(citation=citation, E_mu=E_mu, r_mu_ratio=ratio, errors=published, peaks=ranges)
