"""Packings of two very different sizes, whose large spheres are separated first where "quench" fails."""

from typing import Any

import numpy as np
import pytest

import bondem as bd
from bondem import packing
from bondem.errors import PackingError
from bondem.packing.separated import parting

# 1 : 5 with half of the mass each: 4 of 500 spheres are large, and 8 of 1000. Four do not fit into the cylinder.
TWO = bd.Sieve((1e-3, 1.0001e-3, 5e-3, 5.0001e-3), (0.0, 0.5, 0.5, 1.0))
SHAPES: dict[str, bd.Shape] = {"box": bd.Box((3.0, 2.0, 2.0)), "cylinder": bd.Cylinder(radius=1.0, length=4.0)}
COUNT = {"box": 500, "cylinder": 1000}


def refused(*_: Any) -> Any:
    raise PackingError("not at rest")


@pytest.fixture
def failing(monkeypatch: pytest.MonkeyPatch) -> None:
    """The usual start fails, as it does at this ratio after a minute."""
    monkeypatch.setitem(packing._METHODS, "quench", refused)


@pytest.mark.usefixtures("failing")
@pytest.mark.parametrize(("shape", "seed"), [
    ("box", 1), *(pytest.param(*one, marks=pytest.mark.validate) for one in (("box", 2), ("cylinder", 1))),
])  # fmt: skip
def test_two_sizes_reach_a_coordination_number(shape: str, seed: int) -> None:
    made = bd.pack(SHAPES[shape], count=COUNT[shape], sizes=TWO, seed=seed, coordination_number=5.0)
    lattice = bd.connect(made)
    assert lattice.coordination_number == pytest.approx(5.0, abs=0.011)
    assert made.volume.sum() / SHAPES[shape].volume > 0.6
    assert lattice.rattlers < 0.15 * len(made)
    large = made.radius > 2.0 * made.radius.min()
    assert made.radius[large].mean() / made.radius[~large].mean() == pytest.approx(5.0, rel=1e-3)
    assert (SHAPES[shape].depth(made.position) > (1.0 - 1e-9) * made.radius).all()


@pytest.mark.usefixtures("failing")
@pytest.mark.parametrize("shape", SHAPES)
def test_two_sizes_are_as_dense_as_asked(shape: str) -> None:
    """Below jamming they barely touch."""
    made = bd.pack(SHAPES[shape], count=COUNT[shape], sizes=TWO, seed=1, volume_fraction=0.6)
    assert made.volume.sum() / SHAPES[shape].volume == pytest.approx(0.6, rel=1e-9)
    assert bd.fabric(bd.connect(made, tolerance=0.1)).largest_overlap < 1e-3


@pytest.mark.usefixtures("failing")
def test_sizes_without_a_gap_fail_as_before() -> None:
    with pytest.raises(PackingError, match="not at rest"):
        bd.pack(SHAPES["box"], count=200, sizes=bd.Lognormal(0.3), seed=1)


def test_what_can_be_packed_is_packed_as_before(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(packing, "separated", refused)
    three = bd.Sieve((1.0, 1.001, 2.5, 2.501), (0.0, 0.5, 0.5, 1.0))
    assert len(bd.pack(SHAPES["box"], count=300, sizes=three, seed=1, volume_fraction=0.5)) == 300


def test_large_spheres_are_those_beyond_the_widest_gap() -> None:
    assert parting(np.array([1.0, 1.1, 5.0, 5.2])) == pytest.approx(5.5**0.5)
    assert parting(np.linspace(1.0, 10.0, 50)) is None
    assert parting(np.ones(5)) is None
