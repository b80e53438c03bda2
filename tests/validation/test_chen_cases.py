"""The specimens of the study of Chen et al. (2022) are those of its Table 3."""

import pytest

from validation.studies.chen import static_cases
from validation.studies.chen_tables import cases

# Length [m], bond slenderness λ_b, radii of particles and of bonds [m] of each case, from the least to the largest,
# and whether particles have gaps. Slendernesses of case 3 end at 5 in Table 3; its one bond in Table 5, 4 m long with
# a radius of 0.2 m, has 10.
TABLE_3 = {
    "1": ((4, 4), (1, 1), (0.2, 0.2), (0.2, 0.2), False),
    "2": ((0.4, 4), (1, 1), (0.2, 0.2), (0.2, 0.2), False),
    "3": ((4, 4), (1, 10), (0.2, 0.2), (0.2, 0.2), True),
    "4": ((4, 4), (2, 20), (0.2, 2), (0.1, 0.1), False),
    "5": ((4, 4), (5, 5), (0.2, 0.8), (0.2, 0.2), True),
}


@pytest.fixture(scope="module")
def found():
    return cases()


@pytest.mark.parametrize("case", TABLE_3)
def test_specimens_are_those_of_the_table(found, case):
    *spans, gap = TABLE_3[case]
    for name, span in zip(("length", "slenderness", "element_radius", "bond_radius"), spans, strict=True):
        assert found[case][name] == pytest.approx(span, rel=1e-9), name
    assert found[case]["gap"] is gap


def test_theories_have_the_deflections_that_the_paper_prints():
    laws = {one["law"]: one for one in static_cases() if one["case"] == "1"}
    timoshenko, euler = laws["TBBM"]["timoshenko"], laws["EBBM"]["exact"]
    assert timoshenko == pytest.approx(8.534e-3, abs=0.5e-6)  # eq (29)
    assert euler == pytest.approx(8.488e-3, abs=0.5e-6)
    assert 1.0 - euler / timoshenko == pytest.approx(0.0054, abs=5e-5)
