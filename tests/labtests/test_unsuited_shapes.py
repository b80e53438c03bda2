"""Laboratory tests of cells in shapes that they do not suit: one line, and no result without a meaning."""

import functools

import pytest

import bondem as bd
from bondem.errors import InputError

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


@pytest.mark.parametrize("shape", [bd.Ball(5e-3), bd.Cell((1e-2, 1e-2, 1e-2))], ids=["ball", "cell"])
def test_a_missing_face_has_no_centre(shape):
    with pytest.raises(InputError, match="has no face 'x_min'"):
        shape.face_centre("x_min")
