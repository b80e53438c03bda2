"""One packing measured from nothing, held to sixteen packings of its size, to its targets, and to printed tables."""

import json

import pytest

import bondem as bd
from validation.frame.record import RESULTS, Record
from validation.studies import chen_tables, small

NUMBERS = json.loads((RESULTS / "small.json").read_text(encoding="utf-8"))["numbers"]
#: Standard deviations by which one packing may differ from the mean of sixteen: once in 15 000 by chance.
DEVIATIONS = 4.0
TARGETS = {
    "E": pytest.approx(72.5e9, rel=0.002), "nu": pytest.approx(0.17, abs=0.001),
    "coordination_number": pytest.approx(6.2, abs=0.05), "isotropy_error": pytest.approx(0.0, abs=0.0032),
    "core_rms_excess": pytest.approx(0.0, abs=0.3),
}  # fmt: skip

pytestmark = pytest.mark.validate


def unlike(found: dict[str, float]) -> set[str]:
    """Return the names of numbers that sixteen packings, or a target, do not allow."""
    allowed = TARGETS | {
        name: pytest.approx(known["mean"], abs=DEVIATIONS * known["std"])
        for name, known in NUMBERS.items() if name not in TARGETS
    }  # fmt: skip
    assert set(found) == set(allowed)
    return {name for name, value in found.items() if value != allowed[name]}


@pytest.fixture(scope="module")
def cell() -> bd.Lattice:
    return small.cell(1)


def test_a_packing_is_one_of_sixteen_and_wrong_physics_is_none(cell) -> None:
    found = small.cylinder(1) | small.moduli(cell)
    assert not unlike(found)
    for name, factor in (("cell_E_ratio", 1.02), ("nu_printed", 1.1), ("E_printed", 0.85)):
        assert unlike(found | {name: factor * found[name]}) == {name}


@pytest.mark.parametrize("name", bd.materials.names())
def test_the_cell_is_calibrated_for_every_material_with_the_recommended_law(cell, name) -> None:
    material = bd.materials.get(name)
    fit = bd.calibrate(cell, material)
    assert pytest.approx(material.E, rel=0.002) == fit.E
    assert fit.nu == pytest.approx(material.nu, abs=1e-3)


def test_the_tables_of_chen_are_those_of_the_record(tmp_path) -> None:
    again = Record(tmp_path / "tables.json")
    chen_tables.measure(again)
    kept = json.loads((RESULTS / "chen_tables.json").read_text(encoding="utf-8"))
    for table in ("table4", "table5"):
        for found, known in zip(again.data[table], kept[table], strict=True):
            assert found == {name: value if isinstance(value, str) else pytest.approx(value, rel=1e-6)
                             for name, value in known.items()}  # fmt: skip
