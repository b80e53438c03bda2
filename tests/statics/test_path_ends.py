"""Where a path of load factors ends: in two parts that hardly anything holds, and where motions are not small."""

import math
import warnings

import numpy as np
import pytest

import bondem as bd
from bondem.errors import StrengthWarning
from bondem.statics.quasistatic.load_response import MeasuringPoints, PointGauges
from tests.models import pulled
from tests.specimens import bar, crooked_cells, cubes, two_cubes

E, STRENGTH, SIZE = 40e9, 4e6, 1e-3


@pytest.mark.parametrize("count", [20, 400])
def test_a_slender_body_in_two_parts_has_parted(count: int) -> None:
    """A cantilever of cubes breaks at its root: what stands for none has L / 3 h times 1e-7 of its stiffness."""
    body, tip = cubes((count, 1, 1), SIZE), bd.Index([count - 1])
    ends = [bd.Fix(bd.Index([0])), bd.Load(tip, force=(0.0, 1e-3, 0.0))]
    law = bd.CellBond(E=E, nu=0.0, facet_rotation="full")
    model = bd.Model(body, law, 2500.0, failure=bd.Rankine(tension=STRENGTH), boundary=ends)
    found = bd.solve_quasistatic(model, tip, together=0.0, until=0.0, most=5)
    assert found.end == "parted"
    assert found.bond.tolist() == [0]


@pytest.mark.parametrize("turn", [0.08, 0.12])
def test_a_path_ends_where_it_folds(turn: float) -> None:
    """Two cubes so soft that their facet begins to crack at a turn that is small, or not small any more."""
    law, last = bd.CellBond(E=np.sqrt(12.0) * STRENGTH / turn, nu=0.0, facet_rotation="full"), bd.Index([1])
    failure = bd.Rankine(tension=STRENGTH, fracture_energy=5e10)
    drive = bd.Drive(last, x=0.0, y=0.5e-4 * SIZE, z=0.0, rx=0.0, ry=0.0, rz=1e-4)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # a fracture energy without bounds
        model = bd.Model(two_cubes(SIZE), law, 2500.0, failure=failure, boundary=[bd.Fix(bd.Index([0])), drive])
    with warnings.catch_warnings(record=True) as given:
        warnings.simplefilter("always")
        found = bd.solve_quasistatic(model, last, together=0.0, until=0.0, most=20)
    assert found.end == "folded"
    expected = f"first facet would fail at {1e4 * turn:.3g} times the loads and drives"
    assert [expected in str(one.message) for one in given] == ([True] if turn > 0.1 else [])
    assert (1e-4 * found.factor <= 0.1).all()
    assert len(found.factor) == 0 if turn > 0.1 else found.factor[0] == pytest.approx(1e4 * turn, rel=1e-6)


def test_a_path_on_which_nothing_fails_has_no_peak() -> None:
    """Pressed facets of a row of cubes carry no shear, which friction would add strength to at any load."""
    last = bd.Index([3])
    ends = [bd.Fix(bd.Index([0])), bd.Drive(last, x=-1e-6 * SIZE)]
    failure = bd.MohrCoulomb(tension=STRENGTH, cohesion=STRENGTH, friction_angle=0.6)
    model = bd.Model(cubes((4, 1, 1), SIZE), bd.CellBond(E=E, nu=0.0), 2500.0, failure=failure, boundary=ends)
    with pytest.warns(StrengthWarning, match="has no peak: nothing fails at any load; check the signs"):
        found = bd.solve_quasistatic(model, last)
    assert found.end == "strong"
    assert math.isnan(found.peak)


def test_progress_does_not_run_backwards() -> None:
    """Loads of single events rise and fall; the completed share is that of the highest of the last events."""
    shares: list[float] = []
    found = bd.solve_quasistatic(
        pulled(bar(40)), bd.Face("x_max"), ripple=0.5, together=0.05, until=0.5, progress=shares.append
    )
    assert found.end == "unloaded"
    assert (np.diff(found.load) > 0.1 * found.peak).any()
    assert (np.diff(shares) >= 0.0).all()
    assert shares[0] == 0.0
    assert shares[-1] == 1.0
    assert len(set(shares)) > 3


def test_points_of_a_gauge_move_with_their_elements() -> None:
    """A body that turns as a whole about any axis moves each point by ω × x, wherever it is in its element."""
    body = crooked_cells((3, 2, 2))
    model = bd.Model(body, bd.CellBond(E=1e9, nu=0.2), 2500.0)
    rng, turn = np.random.default_rng(1), np.array([1e-6, -2e-6, 3e-6])
    ends = [MeasuringPoints(element := np.arange(k, 12, 2), body.centre[element] + rng.normal(size=(6, 3)),
                            np.full(6, 1.0 / 6.0)) for k in (0, 1)]  # fmt: skip
    motion = np.empty((12, 6))
    motion[model.layout.rank] = np.hstack([np.cross(turn, body.centre), np.tile(turn, (12, 1))])
    read = PointGauges(model, {"opening": (ends[0], ends[1])}).read(motion.ravel())["opening"]
    apart = ends[1].position.mean(axis=0) - ends[0].position.mean(axis=0)
    np.testing.assert_allclose(read, np.cross(turn, apart), rtol=0.0, atol=1e-18)
