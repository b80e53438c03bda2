"""The cohesive crack in a continuum: its mesh, its energy, and the limits of small and of no process zones."""

from dataclasses import replace

import numpy as np
import pytest

import bondem as bd
from validation.cases import gregoire, petersson
from validation.measures.cohesive_crack import cohesive_crack

PETERSSON, BEAM = petersson.PETERSSON, petersson.BEAM


@pytest.mark.parametrize("curve", [
    pytest.param(None, id="straight", marks=pytest.mark.validate), pytest.param(bd.Bilinear(), id="two lines"),
])  # fmt: skip
def test_peaks_do_not_depend_on_the_mesh(curve):
    for one, beam in ((PETERSSON, BEAM), (gregoire.GREGOIRE, gregoire.BEAM)):
        coarse, fine = (cohesive_crack(one, beam, curve, across).peak for across in (40, 80))
        assert coarse == pytest.approx(fine, rel=0.003)


@pytest.mark.validate
@pytest.mark.parametrize("curve", [
    pytest.param(None, id="straight"), pytest.param(bd.Bilinear(), id="two lines", marks=pytest.mark.validate),
])  # fmt: skip
def test_the_work_is_the_fracture_energy_of_the_ligament(curve):
    """With a tail P δ where a hinge is left, as its load falls with the square of its way; of first order."""
    errors = []
    for across in (80, 160):
        found = cohesive_crack(PETERSSON, BEAM, curve, across)
        way, load = np.append(0.0, found.deflection), np.append(0.0, found.load)
        work = float(np.trapezoid(load, way)) + load[-1] * way[-1]
        errors.append(work / (PETERSSON.fracture_energy * BEAM.ligament) - 1.0)
    assert abs(errors[1]) < 0.03
    assert abs(errors[1]) < 0.6 * abs(errors[0])


@pytest.mark.validate
def test_a_small_process_zone_is_linear_elastic_fracture():
    """K = √(E G_f) at the peak, pure bending after Tada; the zone, E G_f / f_t² = 11 mm, lengthens a crack of 100."""
    brittle = replace(PETERSSON, fracture_energy=4.0)
    load = cohesive_crack(brittle, BEAM, None, 160).peak
    a, span = BEAM.notch[1], BEAM.supports[1] - BEAM.supports[0]
    nominal = 1.5 * load * span / (BEAM.width * BEAM.depth**2)
    shape = 1.122 - 1.40 * 0.5 + 7.33 * 0.5**2 - 13.08 * 0.5**3 + 14.0 * 0.5**4
    K = nominal * np.sqrt(np.pi * a) * shape
    toughness = np.sqrt(brittle.E * brittle.fracture_energy)
    assert toughness == pytest.approx(K, rel=0.08)


def test_it_bends_as_beams_do_before_it_cracks():
    """Hardly notched: P L³ / 48 EI and shear; a point load dents what it presses on."""
    beam = replace(BEAM, notch=(BEAM.notch[0], BEAM.depth / 40, BEAM.notch[2]))
    found = cohesive_crack(PETERSSON, beam, None, 40)
    span, inertia = 2.0, BEAM.width * BEAM.depth**3 / 12.0
    slender = span**3 / (48.0 * PETERSSON.E * inertia)
    sheared = 0.3 * span * 2.0 * (1.0 + PETERSSON.nu) / (PETERSSON.E * BEAM.width * BEAM.depth)
    assert found.deflection[0] / found.load[0] == pytest.approx(slender + sheared, rel=0.04)
