"""Keys of study files, test programmes and campaigns, with units, ranges and choices, declared once.

The reader (`TomlTable`) checks values by them, and `schema()` is their JSON schema for editors. The schema is less
strict than `bondem check`, which also knows how keys depend on each other.
"""

import math
from functools import partial
from typing import get_args

from bondem.interactions.beams.bond_law import RadiusRule
from bondem.interactions.cells.cell_bond import FacetRotation
from bondem.interactions.law_catalogue import CALIBRATED, CELL_LAWS
from bondem.labtests.elastic_tests import ELASTIC_TESTS
from bondem.labtests.failure_tests import FAILURE_TESTS
from bondem.packing import METHODS, MOST
from bondem.specimen import materials
from bondem.study.declared import (
    Count,
    Counts,
    Flag,
    Key,
    KeyTable,
    KeyTables,
    Lengths,
    Number,
    Numbers,
    Schema,
    Text,
    Texts,
    Unit,
)
from bondem.study.failure import CRITERIA
from bondem.study.specimen_step import SHAPES, SIZE_LAWS

_DRAFT = "https://json-schema.org/draft/2020-12/schema"


# Declarations of numbers by their descriptions.
_poisson = partial(Number, unit="-", above=-1.0, below=0.5)
_stress = partial(Number, unit="Pa", above=0.0)
_strength = partial(Number, unit="Pa", above=0.0, quantity="tension")
_energy = partial(Number, unit="J/m²", above=0.0, quantity="fracture_energy")
_length = partial(Number, unit="m", above=0.0)
_spread = partial(Number, unit="-", above=0.0, below=2.0, closed=True)

MATERIAL = KeyTable("material of the specimen", {
    "name": Text("name of the material"), "preset": Text("material of the library", tuple(materials.names())),
    "E": _stress("Young's modulus"), "nu": _poisson("Poisson's ratio"),
    "rho": Number("density", "kg/m³", above=0.0), "source": Text("source of the values"),
})  # fmt: skip
BOND = KeyTable("bonds of spheres, or cells", {
    "law": Text("law of the bonds, or of the cells", (*CALIBRATED, *CELL_LAWS)),
    "facet_rotation": Text("option of the cell law", get_args(FacetRotation)),
    "nu_mu": _poisson("Poisson's ratio of a bond"), "radius_rule": Text("radius of a bond", get_args(RadiusRule)),
    "tolerance": Number("largest gap of a bond over the mean radius"),
    "reach": Number("largest length of a bond over the sum of both radii", "-", above=0.0),
})  # fmt: skip
FAILURE = KeyTable("failure criterion", {
    "criterion": Text("kind of criterion", tuple(CRITERIA)),
    "tension": _strength("strength in tension"), "compression": _strength("strength in compression"),
    "hydrostatic": _strength("strength in hydrostatic tension"), "cohesion": _strength("cohesion c"),
    "friction_angle": Number("friction angle φ", "rad", above=0.0, below=0.5 * math.pi, closed=True),
    "shear": _strength("shear strength of a bond"), "beta": Number("share of the bending moment that counts, β", "-"),
    "force": Number("largest tensile force of a bond", "N", above=0.0),
    "shear_force": Number("largest shear force of a bond", "N", above=0.0),
    "bending": Number("largest bending moment of a bond", "N·m", above=0.0),
    "twisting": Number("largest twisting moment of a bond", "N·m", above=0.0),
    "elongation": Number("elongation at which a straight beam breaks", "-", above=0.0),
    "rotation": Number("angle of its end at which a beam breaks", "rad", above=0.0),
    "fracture_energy": _energy("fracture energy G_f"),
    "fracture_energy_shear": _energy("fracture energy in shear G_II"),
    "dilatancy": Number("dilatancy: the angle ψ of MohrCoulomb, the factor of DruckerPrager", "rad"),
    "band_width": _length("width of shear bands"),
    "friction": Number("friction of closed cracks", "-", above=0.0, closed=True),
    "curve": Text("softening curve", ("straight", "bilinear")),
    "kink_stress": Number("stress at the kink of the bilinear curve, over the strength"),
    "kink_opening": Number("opening at the kink of the bilinear curve, over the last opening"),
}, needed=("criterion",))  # fmt: skip
AGGREGATES = KeyTable("aggregates in the material, which is their matrix", {
    "diameters": Numbers("openings of the sieves", "m", 2),
    "mass_passing": Numbers("share of the mass that passes each sieve, from 0 to 1", "-", 2),
    "fraction": Number("volume fraction of the aggregates", "-", above=0.0, below=0.6),
    "E": Number("Young's modulus", "Pa", above=0.0, quantity="E"), "nu": _poisson("Poisson's ratio"),
    "gap": _length("smallest distance between two aggregates"), "failure": FAILURE, "interface": FAILURE,
}, needed=("diameters", "mass_passing", "fraction", "E", "nu"))  # fmt: skip
_SIZES = KeyTable("law of the radii", {
    "law": Text("kind of law", SIZE_LAWS),
    "spread": _spread("full range over the mean, κ"),
    "cv": Number("coefficient of variation"), "cut": Number("standard deviations that are kept"),
    "diameters": Numbers("openings of the sieves", "m"), "mass_passing": Numbers("share of the mass"),
}, needed=("law",))  # fmt: skip
_SPECIMEN: dict[str, Key] = {
    "particles": Text("file of packed spheres"), "unit": Unit("unit of length of the file"),
    "method": Text("packing method", tuple(METHODS)), "shape": Text("shape that the elements fill", SHAPES),
    "file": Text("file of a surface: STL, OBJ, 3MF, PLY or OFF"), "count": Count("number of elements", 100, MOST),
    "size": Lengths("edges of the box or cell"),
    "notch": KeyTable("notch of a box", {"width": _length("width along x"), "depth": _length("depth from below")}),
    "spread": _spread("full range of the radii over their mean, κ"), "sizes": _SIZES,
    "coordination_number": Number("target coordination number", "-", above=0.0, below=12.0),
    "volume_fraction": Number("target volume fraction", "-", above=0.0, below=0.8),
    "jamming": Flag("pack until the packing jams"),
    "radius": _length("radius of the shape"), "length": _length("length of the shape"),
    "diameter": _length("diameter of the shape"), "height": _length("height of the shape"),
    "ring": _length("mean diameter of the borings"), "width": _length("width of the borings"),
    "depth": _length("depth of the borings"),
}
_TESTS = Texts("tests of each packing", (*ELASTIC_TESTS, *FAILURE_TESTS))
_TARGETS = KeyTable("strengths to compare with", {
    name: _strength("strength to compare with") for name in FAILURE_TESTS
})  # fmt: skip
_QUANTITY = {"Pa": "pressure"}
_OPTIONS: dict[str, Key] = {
    name: KeyTable(f"options of {name}", {
        key: Number("option of the test", one.unit, 0.0, one.below, _QUANTITY.get(one.unit, ""), one.closed)
        for key, one in test.options.items()
    })
    for name, test in FAILURE_TESTS.items() if test.options
}  # fmt: skip
CAMPAIGN = KeyTable("many specimens of one study", {
    "seeds": Counts("number of seeds, or the seeds"),
    "vary": KeyTable("lists of the values that a key of the study takes", free=True),
    "slurm": KeyTable("jobs of a SLURM cluster", {
        "queue": Text("partition"), "account": Text("account to charge"),
        "cores": Count("cores of a job, a worker each"), "memory": Text("memory of a job"),
        "walltime": Text("time limit of a job"), "jobs": Count("number of jobs"),
        "directives": Texts("further lines after #SBATCH"),
    }),
})  # fmt: skip
#: Keys of a specimen of a test programme.
SEVERAL = KeyTable("specimen of a test programme", _SPECIMEN | _OPTIONS | {
    "name": Text("name of the specimen"), "tests": _TESTS, "targets": _TARGETS,
}, needed=("name", "tests"))  # fmt: skip
STUDY = KeyTable("", {
    "name": Text("title of the report"), "seed": Count("seed of the first packing", 0),
    "packings": Count("number of packings; packing k has the seed seed + k"), "material": MATERIAL, "bond": BOND,
    "failure": FAILURE, "aggregates": AGGREGATES,
    "calibration": KeyTable("calibration of the bonds", {"packings": Count("number of packings that calibrate")}),
    "output": KeyTable("files to write", {
        "figures": Flag("draw figures"), "vtk": Flag("write the first packing for ParaView"),
        "run_files": Flag("write every specimen as a run file"),
        "packing_files": Flag("write every packing with its bonds"),
    }),
    "reference": KeyTable("published values", {
        "citation": Text("source of the values"), "E_mu": _stress("published bond modulus"),
        "r_mu_ratio": Number("published radius ratio", "-", above=0.0),
        "errors": KeyTable("published errors", {name: Number("published error") for name in ELASTIC_TESTS}),
        "peaks": KeyTable("lowest and highest measured peak of the curve of a test", {
            name: Numbers("lowest and highest peak", one.figure.units[1], 2) for name, one in FAILURE_TESTS.items()
        }),
    }, needed=("citation",)),
    "campaign": CAMPAIGN, "tests": _TESTS, "specimen": KeyTable("specimen", _SPECIMEN), "targets": _TARGETS,
    "specimens": KeyTables("specimens of a test programme", SEVERAL), **_OPTIONS,
}, needed=("name",))  # fmt: skip


def schema() -> Schema:
    """Return the JSON schema of a study, a test programme or a campaign."""
    both = {"oneOf": [{"required": ["specimen"]}, {"required": ["specimens"]}]}
    return {"$schema": _DRAFT, "title": "bondem study"} | STUDY.schema() | both
