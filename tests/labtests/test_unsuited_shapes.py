"""Laboratory tests of cells in shapes that they do not suit: one line, and no result without a meaning."""

import functools
import math
import re

import numpy as np
import pytest

import bondem as bd
from bondem.calibration.response import Response
from bondem.errors import InputError
from bondem.labtests.disc import require_disc

LAW = bd.CellBond(E=1e9, nu=0.2)
SOFT = bd.MohrCoulomb(tension=1e6, cohesion=3e6, friction_angle=0.5, fracture_energy=5.0)
TESTS = {
    "direct_tension": lambda body: bd.labtests.direct_tension(body, LAW, SOFT, density=1e3),
    "uniaxial_compression": lambda body: bd.labtests.uniaxial_compression(body, LAW, SOFT, density=1e3),
    "triaxial": lambda body: bd.labtests.triaxial(body, LAW, SOFT, pressure=1e5, density=1e3),
    "brazilian": lambda body: bd.labtests.brazilian(body, LAW, SOFT, density=1e3),
    "static_tension": lambda body: bd.labtests.static_tension(body, LAW),
    "natural_frequencies": lambda body: bd.labtests.natural_frequencies(body, LAW, density=1e3),
}
TURNED = {
    "shear": lambda body: bd.labtests.shear(body, LAW, SOFT, density=1e3),
    "spall": lambda body: bd.labtests.spall(body, LAW, SOFT, density=1e3, pressure=1e6, rise=1e-6, fall=1e-6),
    "three_point_bending": lambda body: bd.labtests.three_point_bending(body, LAW, SOFT),
}


@functools.cache
def body(shape: bd.Shape) -> bd.Lattice:
    return bd.connect(bd.pack(shape, count=120, method="even", seed=1), method="laguerre")


@pytest.mark.parametrize("shape", [bd.Ball(5e-3), bd.Cell((1e-2, 1e-2, 1e-2))], ids=["ball", "cell"])
@pytest.mark.parametrize("test", TESTS)
def test_a_body_without_ends_is_refused_in_one_line(shape, test):
    """A ball and a periodic cell ended in "tuple.index(x): x not in tuple", and a ball was split as a disc."""
    with pytest.raises(InputError) as caught:
        TESTS[test](body(shape))
    assert "\n" not in str(caught.value)


def test_a_disc_with_a_hole_has_no_brazilian_strength():
    """The strength and E of a solid disc were returned for a ring."""
    ring = bd.Cylinder(radius=25e-3, length=25e-3).cut(bd.Cylinder(radius=5e-3, length=25e-3), name="hole")
    with pytest.raises(InputError, match="has a hole at its centre"):
        TESTS["brazilian"](body(ring))


@pytest.mark.parametrize("angle", [0.3, 0.5 * math.pi, math.pi])
@pytest.mark.parametrize("test", [*TESTS, "shear", "spall", "three_point_bending"])
def test_a_specimen_turned_out_of_the_axis_of_the_load_is_refused(test, angle):
    """Tension at 0.3 rad gave 1.63 MPa for 4.00."""
    turned = body(bd.Cylinder(10e-3, 20e-3)).rotated("z", angle)
    with pytest.raises(InputError, match=rf"face 'x_min' is turned by {angle:.3g} rad from the axis x of the load"):
        TURNED.get(test, TESTS.get(test))(turned)


def test_specimens_of_bonded_spheres_and_calibrations_are_refused_alike():
    turned = bd.connect(bd.pack(bd.Box((2e-2, 1e-2, 1e-2)), count=300, seed=1)).rotated("y", 0.1)
    law = bd.EulerBernoulli(E=1e9, nu=0.2, radius_ratio=0.6)
    weak = bd.PeripheralStress(tension=1e6, shear=1e6)
    for refused in (
        lambda: bd.labtests.uniaxial_compression(turned, law, weak), lambda: bd.labtests.static_tension(turned, law),
        lambda: bd.labtests.static_bending(turned, law, E=1e9, nu=0.2), lambda: Response(turned, law),
    ):  # fmt: skip
        with pytest.raises(InputError, match=r"turned by 0\.1 rad from the axis x"):
            refused()


def test_what_loads_no_turned_face_accepts_a_turned_body():
    """Turned about the axis of the load, a box has the same E; a uniform stress suits any direction."""
    beam = body(bd.Box((2e-2, 1e-2, 1e-2)))
    turned = beam.rotated("x", 0.3)
    whole, other = (bd.labtests.static_tension(one, LAW) for one in (beam, turned))
    assert (other.E, other.nu) == pytest.approx((whole.E, whole.nu), rel=1e-6)
    with pytest.raises(InputError, match=r"the face 'y_min' is turned by 0\.3 rad from the axis y"):
        TURNED["three_point_bending"](turned)
    tilted = bd.labtests.uniform_stress(beam.rotated("z", 0.3), LAW)
    assert pytest.approx(1e9, rel=1e-6) == tilted.E


def test_a_disc_turned_about_its_axis_has_the_same_diameter():
    """Its strength was 6.08 MPa for 8.60, as its diameter was that of the box around the turned box."""
    disc = body(bd.Cylinder(10e-3, 10e-3))
    for angle in (0.3, 0.25 * math.pi):
        found = require_disc(disc.rotated("x", angle))
        assert (found.diameter, found.thickness, found.flat) == (pytest.approx(20e-3), pytest.approx(10e-3), None)
    shape = bd.Cylinder(10e-3, 10e-3)
    for name, y in (("top", 9.8e-3), ("bottom", -29.8e-3)):
        shape = shape.cut(bd.Box((10e-3, 20e-3, 20e-3)).moved((0.0, y, -10e-3)), name=name)
    assert require_disc(body(shape)).flat == pytest.approx(math.acos(0.98), rel=1e-3)
    with pytest.raises(InputError, match=r"the face 'top' is turned by 0\.3 rad from the axis y"):
        require_disc(body(shape).rotated("x", 0.3))


@pytest.mark.parametrize("shape", [bd.Ball(5e-3), bd.Cell((1e-2, 1e-2, 1e-2))], ids=["ball", "cell"])
def test_a_missing_face_has_no_centre(shape):
    with pytest.raises(InputError, match="has no face 'x_min'"):
        shape.face_centre("x_min")


def test_a_core_of_a_file_along_z_is_turned_as_the_message_says():
    """Faces keep their names when a shape is turned, so that turning the surface or the cells did not help."""
    place = bd.Box((1e-2, 1e-2, 2e-2))
    corners = np.array([[x, y, z] for x in (-5e-3, 5e-3) for y in (-5e-3, 5e-3) for z in (0.0, 2e-2)])
    corners[:, :2] = corners[:, :2] @ np.array([[0.8, 0.6], [-0.6, 0.8]])  # no sides along x and y
    triangles = [[0, 1, 3], [0, 3, 2], [4, 7, 5], [4, 6, 7], [0, 5, 1], [0, 4, 5], [2, 3, 7], [2, 7, 6],
                 [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]  # fmt: skip
    part = bd.Surface(vertices=corners, triangles=triangles)
    assert part.volume == pytest.approx(place.volume)
    core = body(part)
    for refused in (core, core.rotated("y", 0.5 * math.pi)):
        with pytest.raises(InputError, match=r"uniaxial_compression: the ends are z_min and z_max") as caught:
            TESTS["uniaxial_compression"](refused)
    told = re.search(r"bd\.Surface\(.*\)$", str(caught.value))
    assert told is not None
    turned = eval(told[0], {"bd": bd, "part": part})
    assert turned.volume == pytest.approx(place.volume)
    assert pytest.approx(LAW.E, rel=1e-6) == TESTS["static_tension"](body(turned)).E


def test_flat_ends_are_cut_as_the_message_says():
    round_part = bd.Ball(5e-3)
    with pytest.raises(InputError, match=r"has no face 'x_min'; .* bd\.Box\(\.\.\.\) & part"):
        TESTS["direct_tension"](body(round_part))
    flat = bd.Box((6e-3, 2e-2, 2e-2)).moved((-3e-3, -1e-2, -1e-2)) & round_part
    assert {"x_min", "x_max"} <= set(flat.faces)
