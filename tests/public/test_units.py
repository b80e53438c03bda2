"""Quantities with units: read to the bit, refused by dimension, and doubted where they cannot be meant."""

import json
import math
import warnings

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as some

import bondem as bd
from bondem._plausibility import _USUAL
from bondem._units import length_unit, quantity
from bondem.errors import InputError, StudyError, UnitWarning
from bondem.specimen import materials
from bondem.study.pipeline import run_study
from bondem.study.study_file import parse_study
from tests.scripts import command
from tests.specimens import row

SAME = {
    ("72.5 GPa", "Pa"): 72.5e9,
    ("69000 N/mm^2", "Pa"): 69e9,
    ("1 bar", "Pa"): 1e5,
    ("3 kg m^-1 s^-2", "Pa"): 3.0,
    ("5 mm", "m"): 5e-3,
    ("5mm", "m"): 5e-3,
    ("0.1 µm", "m"): 1e-7,
    ("0.1 um", "m"): 1e-7,
    ("1 in", "m"): 0.0254,
    ("0.25 inch", "m"): 0.00635,
    ("1 psi", "Pa"): 6894.757293168362,
    ("10 ksi", "Pa"): 68947572.93168362,
    ("-1_000.5e-3 m", "m"): -1.0005,
    ("2.201 g/cm^3", "kg/m³"): 2201.0,
    ("2.201 g/cm³", "kg/m³"): 2201.0,
    ("2.201 t/m3", "kg/m³"): 2201.0,
    ("2 ms", "s"): 2e-3,
    ("5 min", "s"): 300.0,
    ("10 cm/s", "m/s"): 0.1,
    ("12 kHz", "Hz"): 12e3,
    ("1.5 N·m", "J"): 1.5,
    ("100 J/m^2", "J/m²"): 100.0,
    ("25 %", "-"): 0.25,
    ("25%", "-"): 0.25,
    ("35 deg", "rad"): math.radians(35),
    ("35°", "rad"): math.radians(35),
    ("0.61 rad", "rad"): 0.61,
    ("1e999 m", "m"): math.inf,
    ("-1e999 m", "m"): -math.inf,
}


@pytest.mark.parametrize(("asked", "value"), SAME.items(), ids=lambda item: str(item))
def test_a_quantity_is_the_float_one_would_write_in_si(asked, value):
    assert quantity("q", *asked) == value


@given(some.integers(1, 10**15), some.integers(-12, 6), some.sampled_from([("GPa", 9), ("MPa", 6), ("kPa", 3)]))
@settings(max_examples=200, deadline=None)
def test_any_decimal_number_is_rounded_once(digits, exponent, unit):
    name, shift = unit
    # Python's own reading of the decimal text with the exponent moved
    assert quantity("E", f"{digits}e{exponent} {name}", "Pa") == float(f"{digits}e{exponent + shift}")


@pytest.mark.parametrize(
    ("text", "unit", "words"),
    [
        ("5 mm", "Pa", "mm is not a unit of [Pa]"),
        ("70e9", "Pa", "leave out the quotes"),
        ("0.25", "-", "leave out the quotes"),
        ("5 mm", "-", "a plain number or a percentage"),
        ("5 m^2", "m", "m^2 is not a unit of [m]"),
        ("5 parsec", "m", "'parsec' is not known"),
        ("72,5 GPa", "Pa", "has a comma; write decimals with a point"),
        ("72.5 Gpa", "Pa", "'Gpa' is not known"),
        ("GPa", "Pa", "not a number with a unit"),
        ("nan Pa", "Pa", "not a number with a unit"),
        ("", "m", "not a number with a unit"),
        ("1" * 99 + " m", "m", "not a number with a unit"),
        ("5 m//s", "m/s", "is not known"),
        ("35 deg/s", "rad", "is not known"),
    ],
)
def test_what_is_no_such_quantity_is_refused_in_a_line(text, unit, words):
    with pytest.raises(InputError, match=r"'material\.E'") as refused:
        quantity("'material.E'", text, unit)
    assert words in str(refused.value)
    assert "\n" not in str(refused.value)


def test_a_unit_of_length_is_a_name_or_a_number(tmp_path):
    assert length_unit("q", "mm") == length_unit("q", 1e-3) == 1e-3
    (tmp_path / "two.csv").write_text("x,y,z,r\n0,0,0,1\n2,0,0,1\n")
    for unit in ("mm", 1e-3, np.float64(1e-3)):
        np.testing.assert_array_equal(bd.read_particles(tmp_path / "two.csv", unit=unit).radius, 1e-3)
    corner = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    sides = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]
    named, numbered = (bd.Surface(vertices=corner, triangles=sides, unit=unit) for unit in ("mm", 1e-3))
    np.testing.assert_array_equal(named.vertices, numbered.vertices)
    assert named.extent == 1e-3
    for table in ({"particles": "two.csv", "unit": "mm"}, {"particles": "two.csv", "unit": 1e-3}):
        assert parse_study({"name": "s", "specimen": table}, folder=tmp_path).specimen.unit == 1e-3
    for bad in ("furlong", "Pa", 0.0, math.nan, [], True):
        with pytest.raises(InputError, match="unit of length"):
            length_unit("q", bad)
        with pytest.raises(StudyError, match=r"'specimen\.unit'"):
            parse_study({"name": "s", "specimen": {"particles": "two.csv", "unit": bad}}, folder=tmp_path)


SI = {
    "name": "bar", "packings": 1, "tests": ["static_tension", "dynamic_bending"],
    "material": {"name": "glass", "E": 72.5e9, "nu": 0.17, "rho": 2201.0},
    "specimen": {"shape": "cylinder", "radius": 5e-3, "length": 30e-3, "count": 300, "spread": 0.25},
    "bond": {"nu_mu": 0.3, "tolerance": 0.02},
    "output": {"figures": False},
}  # fmt: skip
WITH_UNITS = SI | {
    "material": {"name": "glass", "E": "72.5 GPa", "nu": "17 %", "rho": "2.201 g/cm^3"},
    "specimen": {"shape": "cylinder", "radius": "5 mm", "length": "3 cm", "count": 300, "spread": "25 %"},
    "bond": {"nu_mu": "30 %", "tolerance": "2 %"},
}


def test_a_study_in_gpa_and_mm_has_the_bits_of_the_one_in_si(tmp_path):
    texts = []
    for name, data in (("si", SI), ("units", WITH_UNITS)):
        run_study(parse_study(data), tmp_path / name)
        found = json.loads((tmp_path / name / "results.json").read_text())
        del found["timing"], found["date"]
        texts.append(json.dumps(found))
    assert texts[0] == texts[1]


def test_every_quantity_of_a_study_takes_a_unit():
    def specimen(**keys):
        return parse_study({"name": "s", "specimen": {"count": 500} | keys}).specimen

    assert specimen(shape="box", size=["10 mm", 1e-2, "4 cm"]).shape == bd.Box((1e-2, 1e-2, 4e-2))
    assert specimen(shape="ball", radius="5 mm").shape == bd.Ball(5e-3)
    box = {"shape": "cell", "size": ["1 mm"] * 3}
    sieve = {"law": "sieve", "diameters": ["1 mm", "2 mm"], "mass_passing": [0, "100 %"]}
    assert specimen(**box, sizes=sieve).sizes == bd.Sieve((1e-3, 2e-3), (0.0, 1.0))
    assert specimen(**box, sizes={"law": "lognormal", "cv": "20 %"}).sizes == bd.Lognormal(0.2)
    assert specimen(**box, volume_fraction="60 %").target == {"volume_fraction": 0.6}
    told = {"citation": "c", "E_mu": "265 GPa", "r_mu_ratio": "71 %", "errors": {"impact": "0.4 %"}}
    reference = parse_study(SI | {"reference": told}).reference
    assert (reference.E_mu, reference.r_mu_ratio, reference.errors) == (265e9, 0.71, {"impact": 0.004})


@pytest.mark.parametrize(
    ("table", "keys", "name"),
    [
        ("material", {"E": "5 mm"}, "material.E"),
        ("material", {"E": "70e9"}, "material.E"),
        ("material", {"rho": "2.2 g"}, "material.rho"),
        ("material", {"nu": "10 deg"}, "material.nu"),
        ("material", {"E": "-1 GPa"}, "material.E"),
        ("material", {"E": "1e999 GPa"}, "material.E"),
        ("specimen", {"radius": "5 MPa"}, "specimen.radius"),
        ("specimen", {"radius": 1e300}, "specimen.radius"),
        ("specimen", {"radius": 1e-300}, "specimen.radius"),
        ("specimen", {"radius": 1e45}, "specimen.radius"),
        ("specimen", {"radius": True}, "specimen.radius"),
        ("specimen", {"spread": "5 mm"}, "specimen.spread"),
        ("specimen", {"volume_fraction": "nan %"}, "specimen.volume_fraction"),
        ("bond", {"tolerance": "2"}, "bond.tolerance"),
        ("bond", {"reach": []}, "bond.reach"),
        ("bond", {"law": 3}, "bond.law"),
    ],
)
def test_a_wrong_unit_is_refused_by_its_key(table, keys, name):
    with pytest.raises(StudyError) as refused:
        parse_study(SI | {table: SI[table] | keys})
    assert f"'{name}" in str(refused.value)
    assert "\n" not in str(refused.value)


def doubted(call):
    """What is warned of, in a line each."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        call()
    assert all(one.category is UnitWarning and "\n" not in str(one.message) for one in caught)
    # the user's line is named, not one of ours
    assert all(one.filename == __file__ for one in caught)
    return " ".join(str(one.message) for one in caught)


def test_moduli_and_densities_off_by_a_thousand_are_doubted():
    assert "granite has about 6e+10 Pa" in doubted(lambda: bd.Material("granite", E=69, nu=0.26, rho=2630))
    assert "granite has about" in doubted(lambda: bd.Material("Lac du Bonnet Granite", E=69e9, nu=0.26, rho=2.63))
    assert "solids have" in doubted(lambda: bd.Material("it", E=69, nu=0.26, rho=2630))
    assert "solids have" in doubted(lambda: bd.Material("it", E=69e9, nu=0.26, rho=2.63))  # √(E/ρ) = 162 km/s
    assert "solids have" in doubted(lambda: bd.Material("it", E=72.5e3, nu=0.17, rho=2.2e-9))  # N, mm, t
    for name, E, rho in (("silica aerogel", 1e6, 100.0), ("rubber", 2e6, 1000.0), ("gel", 5e3, 1000.0),
                         ("diamond", 1.1e12, 3515.0), ("tungsten", 4e11, 19_300.0), ("ice", 9e9, 917.0)):  # fmt: skip
        assert doubted(lambda E=E, rho=rho, name=name: bd.Material(name, E=E, nu=0.2, rho=rho)) == ""
    for name in materials.names():
        known = materials.get(name)
        E, rho = _USUAL[name.split("_")[-1]]
        assert E / 3.0 < known.E < 3.0 * E
        assert rho / 1.5 < known.rho < 1.5 * rho


def test_millimetres_taken_for_metres_are_doubted_unless_metres_are_said(tmp_path):
    def study(**keys):
        return parse_study({"name": "s", "specimen": {"shape": "cylinder", "count": 500} | keys})

    with pytest.warns(UnitWarning, match=r"'specimen\.shape': the cylinder is 40 m long"):
        study(radius=5, length=40)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        study(radius="5 m", length="40 m")
        study(radius=5e-3, length=40e-3)
    (tmp_path / "two.csv").write_text("x,y,z,r\n0,0,0,1\n2,0,0,1\n")
    assert "is taken to be 2 m long" in doubted(lambda: bd.read_particles(tmp_path / "two.csv"))
    assert doubted(lambda: bd.read_particles(tmp_path / "two.csv", unit="m")) == ""
    rows = ["solid part"]
    corner = 5.0 * np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    for face in ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)):
        vertices = ["vertex {} {} {}".format(*corner[k]) for k in face]
        rows += ["facet normal 0 0 0", "outer loop", *vertices, "endloop", "endfacet"]
    (tmp_path / "part.stl").write_text("\n".join([*rows, "endsolid part\n"]))
    assert "is assumed to be 5 m long" in doubted(lambda: bd.Surface(tmp_path / "part.stl"))
    assert doubted(lambda: bd.Surface(tmp_path / "part.stl", unit="m")) == ""
    assert doubted(lambda: bd.Surface(tmp_path / "part.stl", unit="mm")) == ""


def test_bonds_far_thicker_or_thinner_than_elements_are_doubted():
    lattice = row(12)
    for radius, word in ((0.3, "thicker"), (0.3e-7, "thinner")):
        law = bd.EulerBernoulli(E=70e9, nu=0.3, radius=radius)
        with pytest.warns(UnitWarning, match=word):
            bd.Model(lattice, law, 2500.0)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        bd.Model(lattice, bd.EulerBernoulli(E=70e9, nu=0.3, radius=0.3e-3), 2500.0)


def test_the_command_warns_in_a_line_and_reads_units(tmp_path):
    small = ("--count", "200", "--packings", "1")
    done = command("calibrate", "--material", "granite", "--E", "69", *small, cwd=tmp_path)
    assert done.returncode == 0
    (line,) = done.stderr.splitlines()
    assert line.startswith("bondem: warning: material 'granite': E = 69 Pa, but granite has about 6e+10 Pa")
    done = command("calibrate", "--E", "5 mm", "--nu", "0.2", "--rho", "2.2 g/cm^3", cwd=tmp_path)
    assert done.returncode == 2
    (line,) = done.stderr.splitlines()
    assert "--E = '5 mm': mm is not a unit of [Pa]" in line
    done = command("calibrate", "--E", "nan", "--nu", "0.2", "--rho", "2200", cwd=tmp_path)
    assert (done.returncode, len(done.stderr.splitlines())) == (2, 1)
