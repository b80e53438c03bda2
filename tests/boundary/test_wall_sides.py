"""Walls that face away from the elements, or have elements behind them, are not silent."""

import warnings

import pytest

import bondem as bd
from bondem.errors import ContactWarning, InputError
from tests.specimens import row

# A row of spheres along x from 0 with centres on the axis.
ROW = row(6, 1.0)
FAR = float(ROW.particles.position[:, 0].max())
AWAY = {
    "a plane": (bd.PlaneWall((-2.0, 0, 0), (-1, 0, 0)), r"PlaneWall faces away from all 6 .* normal=\(1, 0, 0\)"),
    "a rod": (bd.CylinderWall(5.0, outside=True), "CylinderWall faces away .* outside=False"),
    "a ball": (bd.SphereWall(50.0), "SphereWall faces away .* inside=True"),
    "half of them": (bd.PlaneWall((0.5 * FAR, 0, 0), (1, 0, 0)), "has 3 of 6 elements behind it at the start"),
    "a vessel": (bd.SphereWall(0.6 * FAR, inside=True), "elements behind it at the start"),
}  # fmt: skip
FACING = (
    bd.PlaneWall((-2.0, 0, 0), (1, 0, 0)), bd.CylinderWall(5.0), bd.SphereWall(50.0, inside=True),
    bd.SphereWall(1.0, (-3.0, 0, 0)), bd.PlaneWall((0.5 * FAR, 5.0, 0), (1, 0, 0), outer=1.0),
)  # fmt: skip


def started(*walls: bd.Wall) -> bd.ExplicitResult:
    law, contact = bd.EulerBernoulli(E=1e9, nu=0.2, radius_ratio=0.5), bd.LinearContact(E=1e7)
    model = bd.Model(ROW, law, 2000.0, contact=contact, walls=walls)
    return bd.solve_explicit(model, duration=1e-2)


@pytest.mark.parametrize(("wall", "words"), AWAY.values(), ids=AWAY)
def test_a_wall_on_the_wrong_side_gives_a_warning_that_names_it(wall, words) -> None:
    with pytest.warns(ContactWarning, match=rf"walls\[1\]: the {words}" if words[0].isupper() else words):
        started(FACING[0], wall)


def test_walls_that_face_the_elements_are_silent() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        started(*FACING)


def test_a_wall_that_is_given_twice_is_refused() -> None:
    """It would double its forces."""
    with pytest.raises(InputError, match=r"walls\[2\] is walls\[0\] again"):
        started(FACING[0], FACING[1], bd.PlaneWall((-2.0, 0, 0), (1, 0, 0)))
