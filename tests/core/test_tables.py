"""Tables of the core: what the library says of them is what Python has, and arrays that do not fit are refused."""

from typing import NamedTuple

import numpy as np
import pytest

from bondem import _core
from bondem._core import compiled_level, run_pass, table_fields, with_room
from bondem._passes import Call, calls
from bondem._tables.packing_tables import NeighbourLists, SphereGrid
from bondem._tables.surface_tables import Nearest, TriangleTree
from bondem.errors import InputError


def find_nearest(*tables, threads: int = 1) -> str:
    return run_pass(calls.find_nearest_triangles(*tables), threads=threads)


def tree() -> TriangleTree:
    corner = np.array([[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]])
    side = np.roll(corner, -1, axis=1) - corner
    low, high = np.vstack([np.zeros(3), corner.min(axis=1)]), np.vstack([np.zeros(3), corner.max(axis=1)])
    return TriangleTree(low, high, np.zeros(1, np.int64), corner, side, np.array([[0.0, 0.0, 1.0]]))


def nearest(points: np.ndarray) -> Nearest:
    return Nearest(points, np.empty(len(points), np.int64))


def test_a_level_is_loaded():
    assert compiled_level() in ("x86_64_v2", "x86_64_v3", "x86_64_v4", "aarch64")


def test_tables_have_the_fields_that_the_headers_declare():
    assert table_fields("SphereGrid") == SphereGrid._fields
    assert table_fields("TriangleTree") == TriangleTree._fields


def test_a_pass_runs():
    found = nearest(np.array([[0.2, 0.2, 3.0], [5.0, 5.0, 5.0]]))
    found.triangle[:] = 7
    assert find_nearest(tree(), found, threads=2) == ""
    assert found.triangle.tolist() == [0, 0]


def test_other_tables_are_refused_when_a_pass_is_run():
    class Nearest(NamedTuple):
        triangle: np.ndarray
        points: np.ndarray

    with pytest.raises(ImportError, match="has the fields points, triangle"):
        find_nearest(tree(), Nearest(np.zeros((1, 3)), np.zeros(1)))
    with pytest.raises(ImportError, match="NeighbourLists stands for Nearest"):
        find_nearest(tree(), NeighbourLists(np.zeros(1, np.uint32)))
    with pytest.raises(KeyError, match="find_no_triangles"):
        run_pass(Call("find_no_triangles", (tree(),)))


def test_a_layout_other_than_word_by_word_is_refused():
    field = _core.Field("x", np.dtype(float), None, (), 8)
    with pytest.raises(ImportError, match=r"Table.x is at byte 8, not at 0"):
        _core._check_layout("Table", (field,), 16)
    with pytest.raises(ImportError, match="has 16 bytes, not 8"):
        _core._check_layout("Table", (_core.Field("x", np.dtype(float), None, (), 0),), 16)


POINTS = np.zeros((2, 3))
READ_ONLY = np.zeros(2, np.int64)
READ_ONLY.setflags(write=False)


@pytest.mark.parametrize(
    ("points", "triangle", "message"),
    [
        (POINTS.astype(np.float32), np.zeros(2, np.int64), r"Nearest.points = array of float32 of shape \(2, 3\)"),
        (POINTS[:, :2].copy(), np.zeros(2, np.int64), "an axis has to be 3 long"),
        (np.zeros((3, 2)).T, np.zeros(2, np.int64), "not contiguous"),
        (np.zeros(2), np.zeros(2, np.int64), "the core cannot read it"),
        (POINTS, np.zeros(3, np.int64), r"has to be 2 long \(points, as of Nearest.points\)"),
        (POINTS, np.zeros(2, np.int32), "pass a contiguous array of int64"),
        (POINTS, READ_ONLY, "read-only array: the core writes to it"),
        (POINTS.tolist(), np.zeros(2, np.int64), "not an array"),
        (None, np.zeros(2, np.int64), "not an array"),
    ],
)  # fmt: skip
def test_arrays_that_do_not_fit_are_refused(points, triangle, message):
    with pytest.raises(InputError, match=message):
        find_nearest(tree(), Nearest(points, triangle))


def test_random_tables_give_errors_of_bondem_only():
    random = np.random.default_rng(0)
    kinds = [np.float64, np.float32, np.int64, np.uint32, np.int32, bool]
    refused = 0
    for _ in range(300):
        shapes = [random.integers(0, 4, random.integers(0, 4)) for _ in range(8)]
        arrays = [np.zeros(tuple(shape), kinds[random.integers(len(kinds))]) for shape in shapes]
        try:
            find_nearest(TriangleTree(*arrays[:6]), Nearest(*arrays[6:]))
        except InputError:
            refused += 1
    assert refused == 300


def test_points_that_are_no_numbers_have_some_triangle():
    found = nearest(np.full((1, 3), np.nan))
    find_nearest(tree(), found)
    assert found.triangle[0] == 0


def test_longer_copies_begin_as_the_array_does():
    found = nearest(np.arange(6.0).reshape(2, 3))
    longer = with_room(found, "points")
    assert longer.points.shape == (4, 3)
    assert longer.triangle is found.triangle
    np.testing.assert_array_equal(longer.points[:2], found.points)
