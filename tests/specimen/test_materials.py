"""The library of materials: values that are physical and sourced, names that are found, and its use in a study."""

import dataclasses
import math
import re

import pytest

import bondem as bd
from bondem.errors import InputError, StudyError
from bondem.study.study_file import parse_study
from tests.specimens import bar

SPECIMEN = {"shape": "cylinder", "radius": 5e-3, "length": 40e-3, "count": 500}


def study_of(material: dict):
    return parse_study({"name": "s", "material": material, "specimen": SPECIMEN})


def test_the_library_holds_what_it_should_and_every_name_is_an_attribute():
    assert set(bd.materials.names()) == {"alumina", "concrete", "fused_silica", "granite", "soda_lime_glass", "steel"}
    for name in bd.materials.names():
        assert getattr(bd.materials, name) is bd.materials.get(name)


@pytest.mark.parametrize("name", bd.materials.names())
def test_every_material_is_sourced_and_near_what_its_waves_are_known_to_be(name: str):
    material = bd.materials.get(name)
    # a standard or a year, and the range to expect
    assert re.search(r"\(\d{4}\)|EN \d+", material.source)
    assert re.search(r"E \d+ to \d+ GPa", material.source)
    # longitudinal celerity √(M/ρ) in the handbooks [m/s], within 6 %: catches a wrong unit or a slipped digit
    known = {"alumina": 10_900, "concrete": 4_300, "fused_silica": 5_950, "granite": 5_600, "soda_lime_glass": 5_700,
             "steel": 5_920}  # fmt: skip
    E, nu = material.E, material.nu
    celerity = math.sqrt(E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / material.rho)
    assert celerity == pytest.approx(known[name], rel=0.06)


def test_fused_silica_is_that_of_andre_table_1():
    silica = bd.materials.fused_silica
    assert (silica.E, silica.nu, silica.rho) == (72.5e9, 0.17, 2201.0)


def test_names_are_found_as_people_write_them():
    assert bd.materials.get("Soda-lime glass") is bd.materials.soda_lime_glass
    assert bd.materials.get(" STEEL ") is bd.materials.steel


def test_a_misspelt_name_says_which_was_meant_and_a_strange_one_what_there_is():
    with pytest.raises(InputError, match="did you mean 'granite'"):
        bd.materials.get("granit")
    with pytest.raises(InputError, match=r"choose from alumina, concrete.*bd\.Material"):
        bd.materials.get("xyzzy")
    with pytest.raises(AttributeError):
        _ = bd.materials.granit


def test_source_is_optional_and_last():
    material = bd.Material("mine", 1e9, 0.2, 1000.0)
    assert material.source == ""
    assert dataclasses.replace(bd.materials.granite, E=60e9).source == bd.materials.granite.source


def test_a_study_takes_a_material_of_the_library():
    assert study_of({"preset": "granite"}).material == bd.materials.granite


def test_single_values_of_a_library_material_may_be_overruled_and_the_source_says_so():
    material = study_of({"preset": "granite", "name": "Westerly", "E": 56e9}).material
    assert material is not None
    assert (material.name, material.E) == ("Westerly", 56e9)
    assert (material.nu, material.rho) == (bd.materials.granite.nu, bd.materials.granite.rho)
    assert material.source.endswith("E overruled by the study")


def test_bad_library_keys_of_a_study_are_named():
    with pytest.raises(StudyError, match=r"material\.preset.*did you mean 'granite'"):
        study_of({"preset": "granit"})
    with pytest.raises(StudyError, match=r"material\.nu"):
        study_of({"preset": "granite", "nu": 0.6})
    with pytest.raises(StudyError, match=r"did you mean 'material\.preset'"):
        study_of({"name": "x", "E": 1e9, "nu": 0.2, "rho": 1e3, "presset": "granite"})


def test_a_material_stands_for_its_constants_wherever_they_are_numbers():
    granite = bd.materials.granite
    E, nu, rho = granite.E, granite.nu, granite.rho
    assert bd.CellBond(granite) == bd.CellBond(E=granite, nu=granite) == bd.CellBond(E=E, nu=nu)
    assert bd.CellBond(granite, facet_rotation="none").facet_rotation == "none"
    assert bd.CellBond(granite, nu=0.1) == bd.CellBond(E=E, nu=0.1)
    assert bd.NonLocal(granite, lever="contact") == bd.NonLocal(E=E, nu=nu, lever="contact")
    assert bd.HertzMindlin(granite, friction=0.2) == bd.HertzMindlin(E, nu, friction=0.2)
    assert bd.Absorbing(bd.Face("x_min"), granite) == bd.Absorbing(bd.Face("x_min"), rho, E, nu)
    body = bar(60, 60e-3, 8e-3)
    assert bd.Model(body, bd.CellBond(granite), granite).density == rho
    pulse = {"pressure": 1e6, "rise": 4e-6, "fall": 6e-6, "duration": 2e-6}
    law = bd.CellBond(granite)
    one, other = (bd.labtests.spall(body, law, None, density=given, **pulse).velocity for given in (granite, rho))
    assert (one == other).all()
    one, other = (bd.labtests.natural_frequencies(body, law, density=given).tension for given in (granite, rho))
    assert one == other
    # a bond's own modulus is not that of a material
    with pytest.raises(InputError, match="Timoshenko: E"):
        bd.Timoshenko(E=granite, nu=nu, radius_ratio=0.5)
    with pytest.raises(InputError, match="CellBond: 2 arguments without a name"):
        bd.CellBond(granite, granite)
