"""The report's parts: the renderer, the figures' style and the way numbers are written."""

import math

import numpy as np
import pytest
from matplotlib import rcParams

import bondem as bd
from bondem.report.numbers import measures, percent, quantity, signed, signed_percent
from bondem.report.spheres import View, render, tubes
from bondem.report.style import sheet

FRONT = View(azimuth=0.0, elevation=0.0)
RED, BLUE = [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]


def test_a_sphere_is_a_disc_of_its_area():
    image = render(np.zeros((1, 3)), np.ones(1), np.array([RED]), view=FRONT, width=200)
    side = 2.04 / 200  # the picture leaves a margin of 2 % about the sphere
    assert image[:, :, 3].sum() * side**2 == pytest.approx(math.pi, rel=0.005)
    assert image.shape[0] == pytest.approx(image.shape[1], abs=1)


def test_what_is_nearer_hides_what_is_behind():
    position = np.array([[0.0, 1.0, 0.0], [0.0, -1.0, 0.0]])  # one looks along +y
    image = render(position, np.ones(2), np.array([RED, BLUE]), view=FRONT, width=100)
    middle = image[50, 50]
    assert middle[2] > 3.0 * middle[0]
    behind = render(position, np.ones(2), np.array([RED, BLUE]), view=View(math.pi, 0.0), width=100)
    assert behind[50, 50, 0] > 3.0 * behind[50, 50, 2]


def test_the_view_is_a_right_handed_frame():
    for view in (FRONT, View(0.3, 0.7), View(2.0, -0.4)):
        np.testing.assert_allclose(view.axes @ view.axes.T, np.eye(3), atol=1e-14)
        assert np.linalg.det(view.axes) == pytest.approx(1.0)
    np.testing.assert_allclose(FRONT.axes, [[1, 0, 0], [0, 0, 1], [0, -1, 0]], atol=1e-14)


def test_spheres_do_not_depend_on_their_order():
    random = np.random.default_rng(1)
    position, radius = random.random((40, 3)), random.uniform(0.02, 0.2, 40)
    colour = random.random((40, 3))
    shuffled = random.permutation(40)
    one = render(position, radius, colour, view=View(), width=120)
    other = render(position[shuffled], radius[shuffled], colour[shuffled], view=View(), width=120)
    np.testing.assert_allclose(one, other, atol=1e-12)


def test_tubes_reach_from_end_to_end():
    start, end = np.zeros((2, 3)), np.array([[1.0, 0.0, 0.0], [0.0, 3.0, 0.0]])
    beads, segment = tubes(start, end, 0.1)
    for k in range(2):
        mine = beads[segment == k]
        np.testing.assert_allclose(mine[[0, -1]], [start[k], end[k]])
        assert np.linalg.norm(np.diff(mine, axis=0), axis=1).max() <= 0.1


def test_drawing_leaves_no_global_state(tmp_path):
    before = dict(rcParams)
    with sheet(tmp_path / "a.png", 3.0, 2.0) as (_, axes):
        axes.plot([0, 1], [0, 1])
    assert dict(rcParams) == before
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        (72.5e9, "Pa", "72.50 GPa"),
        (2201.0, "kg/m³", "2201 kg/m³"),
        (5.2e-7, "m", "520.0 nm"),
        (5018.2, "Hz", "5.018 kHz"),
        (5739.3, "m/s", "5739 m/s"),
        (1.5e-4, "rad", "150.0 µrad"),
        (0.7069, "-", "0.7069"),
        (1.23e-7, "-", "1.230·10⁻⁷"),
        (-3.0, "m", "−3.000 m"),
        (0.0, "m", "0 m"),
        (None, "m", "–"),
        (math.nan, "m", "–"),
    ],
)
def test_quantities(value, unit, text):
    assert quantity(value, unit) == text


def test_percentages_and_signs():
    assert percent(0.0663) == "6.63 %"
    assert signed_percent(-0.0663) == "−6.63 %"
    assert signed_percent(1e-9) == "0.00 %"
    assert signed(0.00012) == "+0.0001"


def test_measures_of_a_shape():
    assert measures(bd.Cylinder(5e-3, 40e-3)) == "Ø 10 × 40 mm"
    assert measures(bd.Box((1e-2, 2e-2, 3e-2))) == "10 × 20 × 30 mm"
