"""The cracked hinge: the plastic limit, what snaps back, and the curve of softening."""

from dataclasses import replace

import pytest

import bondem as bd
from bondem.errors import InputError
from validation.cases.gregoire import BEAM, GREGOIRE
from validation.measures.hinge import hinge_peak


def moment(load: float) -> float:
    """Of the section above the notch, over f_t b h² / 6 [-]."""
    span, height = BEAM.supports[1] - BEAM.supports[0], BEAM.depth - BEAM.notch[1]
    return 0.25 * load * span * 6.0 / (GREGOIRE.tension * BEAM.width * height**2)


def test_a_hinge_that_snaps_back_is_refused():
    with pytest.raises(InputError, match="snaps back"):
        hinge_peak(replace(GREGOIRE, fracture_energy=4.0), BEAM, None)


def test_a_hinge_that_hardly_softens_is_plastic():
    """Tension f_t over the whole height, and pressure at its edge: three times the elastic moment."""
    tough = replace(GREGOIRE, fracture_energy=1e6, E=1e13)
    assert moment(hinge_peak(tough, BEAM, None)) == pytest.approx(3.0, abs=0.1)


def test_two_lines_bear_less_than_one():
    assert 1.02 < hinge_peak(GREGOIRE, BEAM, None) / hinge_peak(GREGOIRE, BEAM, bd.Bilinear()) < 1.2
