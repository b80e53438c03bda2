"""Cracks that choose their path as a study: geometry, the continuum of a split plate, rows and verdicts."""

import math
from dataclasses import replace

import numpy as np
import pytest

from bondem.errors import InputError
from validation.cases import split_cube
from validation.cases.arrea_ingraffea import ARREA_INGRAFFEA, INNER, LENGTH
from validation.cases.hole_arrest import HOLE_ARREST, RADIUS, blunt
from validation.cases.interface_crack import INTERFACES
from validation.cases.nooru_mohamed import EDGE, NOORU_MOHAMED, NOTCH, SLAB, SLIT
from validation.frame.runner import run
from validation.measures.split_plate import split_plate
from validation.studies.crack_paths import CASES, CrackPaths


def test_plates_have_the_stated_geometry():
    shape = NOORU_MOHAMED[0].shape
    assert shape.volume == pytest.approx((EDGE**2 - 2.0 * NOTCH * SLIT) * SLAB, rel=2e-3)
    assert not shape.contains([[0.02, 0.1, 0.5 * SLAB], [0.18, 0.1, 0.5 * SLAB]]).any()
    assert shape.contains([[0.03, 0.1, 0.5 * SLAB]]).all()
    assert [one.shear for one in NOORU_MOHAMED] == [5e3, 10e3, 27.5e3]


def test_forces_of_the_shear_beam_balance_and_shear_its_notch():
    lines = ARREA_INGRAFFEA.lines.values()
    assert sum(by for _, by in lines) == pytest.approx(0.0, abs=1e-12)
    assert sum(by * line.x for line, by in lines) == pytest.approx(0.0, abs=1e-12)
    left = [(line.x, by) for line, by in lines if line.x < 0.5 * LENGTH]
    moment = sum(by * (x - 0.5 * LENGTH) for x, by in left)
    assert abs(moment) < 0.05 * INNER  # next to the shear force of 0.86 F


def test_a_blunt_crack_needs_what_theory_says():
    assert blunt(0.0) == 1.0
    assert blunt(1e6) == pytest.approx(0.5 * math.sqrt(math.pi * 1e6), rel=1e-5)  # Creager and Paris
    middle = np.array([[HOLE_ARREST.far - RADIUS * 0.052, 0.0, 0.5 * HOLE_ARREST.plate.thickness]])
    assert not HOLE_ARREST.shape.contains(middle).any()


def test_a_split_plate_is_that_of_elasticity_until_it_cracks():
    """The first facet cracks at 1.08 of 2 P/(π D t) (strips of 0.16 D), later where it is tougher."""
    brittle, tough = (split_plate(length, 0.16, 0.2, 25) for length in (0.1, 0.5))
    assert brittle.elastic == tough.elastic == pytest.approx(1.08, abs=0.01)
    assert brittle.elastic <= brittle.peak < 1.03 * brittle.elastic
    assert tough.peak > brittle.peak
    assert split_plate(0.5, 0.16, 0.2, 50).peak == pytest.approx(tough.peak, rel=0.01)
    length = split_cube.E * split_cube.ENERGY / split_cube.TENSION**2 / split_cube.EDGE
    peak = split_plate(length, split_cube.STRIP / split_cube.EDGE, split_cube.NU).peak
    assert pytest.approx(peak, rel=1e-6) == split_cube._EXPECTED
    assert split_plate(0.02, 0.02, 0.2, 50).elastic == pytest.approx(1.0, abs=0.06)


@pytest.mark.validate  # a plate of 120 cells and a specimen of 300
def test_the_study_judges_each_claim(tmp_path):
    names = ("nooru_mohamed_4a", "arrea_ingraffea")
    found = run(CrackPaths(cases=names, finer=0.4), tmp_path, processes=1, command="by a test")
    assert [one["name"] for one in found["cases"]] == list(names)
    assert [claim["quantity"] for claim in found["cases"][1]["claims"]] == ["peak", "off the notch"]
    assert 8e4 < found["cases"][1]["values"]["peak"][0] < 2e5
    assert (tmp_path / "figures" / "arrea_ingraffea.png").stat().st_size > 10_000


def test_a_crack_goes_through_a_strong_interface_or_along_a_weak_one():
    assert [one.weak for one in INTERFACES] == [False, True, False, True]
    body = replace(INTERFACES[0], finer=0.5).body(1)
    assert body.facets is not None
    side = INTERFACES[0].behind.mask(body)
    across = side[body.pairs[:, 0]] != side[body.pairs[:, 1]]
    np.testing.assert_allclose(body.facets.centroid[across, 0], INTERFACES[0].at, rtol=1e-6)


@pytest.mark.parametrize("bad", [{"cases": ("none",)}, {"seeds": ()}, {"finer": 0.0}])
def test_bad_options_are_refused(bad):
    assert len(CASES) == 10
    with pytest.raises(InputError):
        CrackPaths(**bad)
