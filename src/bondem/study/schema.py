"""JSON schema of study files for editors: keys, types and units.

The schema is less strict than `bondem check`, which also knows the dependencies between keys. A test ensures that
both have equal keys.
"""

from collections.abc import Iterable, Mapping
from typing import Any

from bondem.labtests.failure_record import TestOption
from bondem.labtests.failure_tests import FAILURE_TESTS
from bondem.laws.bond import RADIUS_RULES
from bondem.laws.catalogue import CALIBRATED, CELL_LAWS
from bondem.laws.cell_bond import FACET_ROTATIONS
from bondem.packing import METHODS
from bondem.specimen import materials
from bondem.study.failure import CRITERIA
from bondem.study.specimen import SHAPES, SIZE_LAWS
from bondem.study.study import TESTS

Schema = dict[str, Any]
_DRAFT = "https://json-schema.org/draft/2020-12/schema"


def schema() -> Schema:
    """JSON schema of a study, a test programme or a campaign."""
    shared = {
        "name": _text("title of the report"), "seed": _count("of the first packing", least=0),
        "packings": _count("number of packings; packing k has seed + k"), "material": _material(),
        "bond": _bond(), "failure": _failure(), "aggregates": _aggregates(),
        "calibration": _table({"packings": _count("that calibrate")}),
        "output": _table({
            "figures": _flag("draw figures"), "vtk": _flag("the first packing for ParaView"),
            "run_files": _flag("every specimen as a run file"),
            "packing_files": _flag("every packing with its bonds"),
        }),
        "reference": _table({
            "citation": _text("what published values are from"), "E_mu": _number("Pa", "published"),
            "r_mu_ratio": _number("-", "published"),
            "errors": _table({name: _number("-", "published error") for name in TESTS}),
        }, needed=["citation"]),
        "campaign": _campaign(),
    }  # fmt: skip
    options = {name: _options(test.options) for name, test in FAILURE_TESTS.items() if test.options}
    targets = _table({name: _number("Pa", "strength to compare with") for name in FAILURE_TESTS})
    several = _specimen() | {"name": _text("of the specimen"), "tests": _tests(), "targets": targets} | options
    properties = shared | options | {
        "tests": _tests(), "specimen": _table(_specimen()), "targets": targets,
        "specimens": {"type": "array", "minItems": 1, "items": _table(several, needed=["name", "tests"])},
    }  # fmt: skip
    both = {"oneOf": [{"required": ["specimen"]}, {"required": ["specimens"]}]}
    head = {"$schema": _DRAFT, "title": "bondem study"}
    return head | _table(properties, needed=["name"]) | both


def _table(properties: Mapping[str, Schema], *, needed: Iterable[str] = ()) -> Schema:
    made: Schema = {"type": "object", "properties": dict(properties), "additionalProperties": False}
    return made | ({"required": list(needed)} if needed else {})


def _number(unit: str, words: str) -> Schema:
    return {"type": ["number", "string"], "description": f"{words} [{unit}]; a text may bring another unit along"}


def _count(words: str, *, least: int = 1) -> Schema:
    return {"type": "integer", "minimum": least, "description": words}


def _text(words: str, choices: Iterable[str] = ()) -> Schema:
    return {"type": "string", "description": words} | ({"enum": list(choices)} if choices else {})


def _flag(words: str) -> Schema:
    return {"type": "boolean", "description": words}


def _list(item: Schema, words: str, **more: Any) -> Schema:
    return {"type": "array", "items": item, "description": words} | more


def _tests() -> Schema:
    return _list(_text("a test", (*TESTS, *FAILURE_TESTS)), "tests of each packing", uniqueItems=True)


def _options(options: Mapping[str, TestOption]) -> Schema:
    return _table({key: _number(one.unit, "option of the test") for key, one in options.items()})


def _material() -> Schema:
    return _table({
        "name": _text("of the material"), "preset": _text("of the library", materials.names()),
        "E": _number("Pa", "Young's modulus"), "nu": _number("-", "Poisson's ratio"),
        "rho": _number("kg/m³", "density"),
        "source": _text("where the numbers are from"),
    })  # fmt: skip


def _bond() -> Schema:
    return _table({
        "law": _text("of the bonds, or CellBond for cells", (*CALIBRATED, *CELL_LAWS)),
        "facet_rotation": _text("of CellBond", FACET_ROTATIONS), "nu_mu": _number("-", "Poisson's ratio of a bond"),
        "radius_rule": _text("radius of a bond", RADIUS_RULES),
        "tolerance": _number("-", "bond where gap <= tolerance times the mean radius"),
        "reach": _number("-", "bond where L <= reach (Ri + Rj)"),
    })  # fmt: skip


def _failure() -> Schema:
    numbers = {
        "tension": ("Pa", "strength in tension"), "compression": ("Pa", "strength in compression"),
        "hydrostatic": ("Pa", "strength in hydrostatic tension"), "cohesion": ("Pa", "c"),
        "friction_angle": ("rad", "φ"),
        "fracture_energy": ("J/m²", "G_f"), "fracture_energy_shear": ("J/m²", "G_II"), "dilatancy": ("rad", "ψ"),
        "friction": ("-", "of closed cracks"), "kink_stress": ("-", "of the bilinear curve"),
        "kink_opening": ("-", "of the bilinear curve"),
    }  # fmt: skip
    return _table({
        "criterion": _text("when it fails", [kind.__name__ for kind in CRITERIA]),
        "curve": _text("how cracks soften", ("straight", "bilinear")),
    } | {key: _number(unit, words) for key, (unit, words) in numbers.items()}, needed=["criterion"])  # fmt: skip


def _aggregates() -> Schema:
    length = {"type": ["number", "string"]}
    return _table({
        "diameters": _list(length, "openings of the sieves [m]", minItems=2),
        "mass_passing": _list(length, "share of the mass that passes each, from 0 to 1 [-]", minItems=2),
        "fraction": _number("-", "of the volume"), "E": _number("Pa", "Young's modulus"),
        "nu": _number("-", "Poisson's ratio"), "gap": _number("m", "between two of them, at least"),
        "failure": _failure(), "interface": _failure(),
    }, needed=["diameters", "mass_passing", "fraction", "E", "nu"])  # fmt: skip


def _specimen() -> dict[str, Schema]:
    length = {"type": ["number", "string"]}
    lengths = ("radius", "length", "diameter", "height", "ring", "width", "depth")
    sizes = {
        "law": _text("of the radii", SIZE_LAWS), "spread": _number("-", "κ"),
        "cv": _number("-", "coefficient of variation"),
        "cut": _number("-", "standard deviations kept"), "diameters": _list(length, "of the sieves [m]"),
        "mass_passing": _list(length, "share of the mass [-]"),
    }  # fmt: skip
    return {
        "particles": _text("file of spheres packed elsewhere"), "unit": {"type": ["string", "number"]},
        "method": _text("of packing", METHODS), "shape": _text("what elements fill", SHAPES),
        "file": _text("surface of triangles"), "count": _count("number of elements", least=100),
        "size": _list(length, "edges of a box or cell [m]", minItems=3, maxItems=3),
        "notch": _table({"width": _number("m", "along x"), "depth": _number("m", "from below")}),
        "spread": _number("-", "full range of the radii over their mean, κ"), "sizes": _table(sizes, needed=["law"]),
        "coordination_number": _number("-", "target"), "volume_fraction": _number("-", "target"),
        "jamming": _flag("until the packing jams"),
    } | {key: _number("m", f"{key} of the shape") for key in lengths}  # fmt: skip


def _campaign() -> Schema:
    whole = {"type": "integer", "minimum": 0}
    return _table({
        "seeds": {"description": "how many, or which", "anyOf": [_count("how many"), _list(whole, "which")]},
        "vary": {"type": "object", "description": "lists of the values that a key of the study takes"},
        "slurm": _table({
            "queue": _text("partition"), "account": _text("to charge"), "cores": _count("of a job, each a worker"),
            "memory": _text("of a job"), "walltime": _text("of a job"), "jobs": _count("how many"),
            "directives": _list({"type": "string"}, "further lines after #SBATCH"),
        }),
    })  # fmt: skip
