"""Cracks of a test to failure and the energy that they took: one crack, several, or none in compression."""

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

import bondem as bd
from bondem.errors import FractureEnergyWarning
from bondem.labtests.cracking import Cracking
from tests.specimens import bar

LAW = bd.CellBond(E=40e9, nu=0.2)
CONCRETE = bd.Rankine(tension=4e6, fracture_energy=20.0)
SECTION = 1e-4


@cache
def torn() -> bd.labtests.StrengthTest:
    """A short prism, which stores f_t² L / (2 E G_f) = 0.2 of the energy of one crack."""
    return bd.labtests.direct_tension(bar(120, 20e-3), LAW, CONCRETE)


def test_a_bar_that_cracks_once_gives_the_fracture_energy_of_its_material() -> None:
    one = torn().cracking
    assert (one.count, one.pieces, one.single, one.mode) == (1, 2, True, "cracks once")
    assert one.section == pytest.approx(SECTION)
    assert one.per_section == pytest.approx(20.0, rel=0.1)
    assert one.stored_ratio == pytest.approx(4e6**2 * 20e-3 / (2.0 * LAW.E * 20.0), rel=0.1)
    assert one.per_crack_area == pytest.approx(one.dissipated / one.projected)
    assert one.projected <= one.surface
    assert one.projected == pytest.approx(SECTION, rel=0.5)


def test_the_work_of_a_bar_that_stores_more_than_one_crack_takes_is_questioned() -> None:
    """5 times: the test returned several times the fracture energy entered, without a word."""
    brittle = bd.Rankine(tension=20e6, fracture_energy=20.0)
    with pytest.warns(FractureEnergyWarning, match=r"stores [45][.\d]* times the energy") as caught:
        test = bd.labtests.direct_tension(bar(120, 40e-3, 10e-3), bd.CellBond(E=80e9, nu=0.2), brittle)
    assert "not a fracture energy" in str(caught[0].message)
    one = test.cracking
    assert one.stored_ratio == pytest.approx(20e6**2 * 40e-3 / (2.0 * 80e9 * 20.0), rel=0.05)
    assert not one.single
    assert test.work > 1.5 * 20.0


def test_a_prism_in_compression_tells_how_it_fails() -> None:
    failure = bd.MohrCoulomb(
        tension=4e6, cohesion=14.3e6, friction_angle=math.radians(35.0), fracture_energy=100.0,
        fracture_energy_shear=2000.0,
    )  # fmt: skip
    one = bd.labtests.uniaxial_compression(bar(120, 20e-3), LAW, failure, reach=1.2).cracking
    assert one.slipped > one.dissipated
    assert one.mode == ("yields in shear and splits" if one.pieces > 1 else "yields in shear and does not split")
    assert not one.sectioned
    assert math.isnan(one.stored_ratio)
    assert one.numbers()["single_crack"] is None


def test_a_test_that_ends_before_a_body_splits_says_so() -> None:
    """A crack through half of a prism in compression, and the load at the end of the test."""
    body = bar(120, 20e-3)
    state = bd.Model(body, LAW, density=2400.0, failure=CONCRETE).state()
    left, low = body.centre[:, 0] < 10e-3, body.centre[:, 1] < 5e-3
    gone = (left[body.pairs[:, 0]] != left[body.pairs[:, 1]]) & low[body.pairs].all(axis=1)
    state.integrity[state.layout.bond_order.argsort()[gone]] = 0.0
    one = Cracking(body, state, 0.1, dissipated=0.01, slipped=0.0, stored=0.005, fracture_energy=100.0)
    assert (one.pieces, one.mode) == (1, "cracks and does not split")
    assert replace(one, ended=0.9).mode == "cracks and does not split before its end at 0.90 of the peak"


def test_pieces_crumbs_and_cracks_are_counted_by_their_sizes() -> None:
    """All facets between x < 10 mm and x > 10 mm broken, and a single cell apart."""
    body = bar(120, 20e-3)
    state = bd.Model(body, LAW, density=2400.0, failure=CONCRETE).state()
    left = body.centre[:, 0] < 10e-3
    corner = int(np.argmax(body.centre.sum(axis=1)))
    gone = left[body.pairs[:, 0]] != left[body.pairs[:, 1]]
    gone |= (body.pairs == corner).any(axis=1)
    state.integrity[state.layout.bond_order.argsort()[gone]] = 0.0
    one = Cracking(body, state, 0.5, dissipated=0.01, slipped=0.0, stored=0.005, fracture_energy=100.0,
                   section=SECTION)  # fmt: skip
    assert (one.pieces, one.crumbs) == (2, 1)
    assert one.surface == pytest.approx(body.facets.area[gone].sum())
    assert one.per_section == pytest.approx(100.0)
    assert one.stored_ratio == pytest.approx(0.5)
