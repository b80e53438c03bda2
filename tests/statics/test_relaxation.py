"""Dynamic relaxation against the solvers that store the matrix, and against the elastica."""

import math

import numpy as np
import pytest

import bondem as bd
from bondem.errors import ConvergenceError, InputError
from bondem.model.highest_frequency import stiffest
from bondem.statics.relaxation import masses
from tests.specimens import row

LENGTH = 1.0
THICK = bd.EulerBernoulli(E=200e9, nu=0.3, radius=0.01)
BENDING = 200e9 * math.pi * 0.01**4 / 4.0
# λ = F L² / EI: tip displacement against the axis and across, over L, and slope [rad]; Mattiasson (1981), table 1
ELASTICA = {1.0: (0.05643, 0.30172, 0.46135), 5.0: (0.38763, 0.71379, 1.21537)}


def bar(law, *conditions) -> bd.Model:
    """A bar of 20 × 5 × 5 elements out of line, clamped at one end, and a rattler beside it."""
    rng = np.random.default_rng(3)
    grid = np.stack(np.meshgrid(np.arange(20), *[np.arange(5)] * 2, indexing="ij"), axis=-1).reshape(-1, 3) + 0.5
    position = np.vstack([grid + rng.uniform(-0.2, 0.2, grid.shape), [[10.0, 2.5, 9.0]]])
    particles = bd.Particles(position, 0.35, shape=bd.Box(size=(20.0, 5.0, 5.0)))
    clamp = bd.Fix(bd.Face("x_min", depth=1.0))
    return bd.Model(bd.connect(particles, reach=1.6), law, 1.0, boundary=[clamp, *conditions])


def far(a: np.ndarray, b: np.ndarray) -> float:
    return float(np.abs(a - b).max() / np.abs(b).max())


END = bd.Face("x_max", depth=1.0)


@pytest.mark.parametrize("law", [
    bd.EulerBernoulli(E=1e9, nu=0.3, radius_ratio=0.8),
    bd.ParallelBond(E=1e9, nu=0.3, radius_ratio=0.8),
], ids=lambda law: type(law).__name__)  # fmt: skip
@pytest.mark.parametrize("condition", [
    bd.Load(END, force=(1e3, 0.0, 0.0)),
    bd.Load(END, force=(0.0, 10.0, 7.0), moment=(50.0, 0.0, 0.0)),
    bd.Drive(END, x=1e-5, y=-2e-5),
], ids=["pulled", "bent and twisted", "driven"])  # fmt: skip
def test_small_loads_give_the_linear_answer_to_the_tolerance(law, condition) -> None:
    model = bar(law, condition)
    static = bd.solve_static(model)
    errors = []
    for tolerance in (1e-4, 1e-7):
        relaxed = bd.solve_relaxed(model, tolerance=tolerance)
        errors.append(max(
            far(relaxed.displacement, static.displacement),
            far(relaxed.rotation, static.rotation),
            far(relaxed.reaction, static.reaction),
            abs(relaxed.energy.total / static.energy.total - 1.0),
        ))  # fmt: skip
    # what a force out of balance moves is up to the ratio of stiffnesses larger, ω_max² / ω_min², of the lowest mode
    assert errors[0] < 0.1
    assert errors[1] < 1e-4
    assert (relaxed.displacement[-1] == 0.0).all()


@pytest.mark.parametrize("load", ELASTICA)
def test_a_cantilever_bends_to_the_elastica(load: float) -> None:
    """As far as the same lattice does under Newton's method; and that is the elastica, but for the bonds' length."""
    bonds = 30
    boundary = [bd.Fix(bd.Index(0)), bd.Load(bd.Index(bonds), force=(0.0, load * BENDING / LENGTH**2, 0.0))]
    model = bd.Model(row(bonds + 1, LENGTH / bonds), THICK, 1.0, boundary=boundary)
    relaxed, newton = bd.solve_relaxed(model, tolerance=1e-8), bd.solve_static(model, nonlinear=True)
    assert np.abs(newton.rotation).max() > 0.4
    assert far(relaxed.displacement, newton.displacement) < 1e-5
    assert far(relaxed.rotation, newton.rotation) < 1e-5
    assert far(relaxed.reaction, newton.reaction) < 1e-5
    assert relaxed.energy.total == pytest.approx(newton.energy.total, rel=1e-5)
    tip = np.array([-relaxed.displacement[-1, 0], relaxed.displacement[-1, 1], relaxed.rotation[-1, 2]])
    np.testing.assert_allclose(tip, ELASTICA[load], rtol=3e-3)


def test_a_driven_turn_of_the_support_is_rigid() -> None:
    model = bd.Model(
        row(7, LENGTH / 6), THICK, 1.0, boundary=[bd.Fix(bd.Index(0), rotation="xy"), bd.Drive(bd.Index(0), rz=2.0)]
    )
    relaxed = bd.solve_relaxed(model)
    x = model.lattice.particles.position[:, 0]
    expected = np.stack([x * (math.cos(2.0) - 1.0), x * math.sin(2.0), 0.0 * x], axis=1)
    np.testing.assert_allclose(relaxed.displacement, expected, atol=1e-6)
    np.testing.assert_allclose(relaxed.rotation, np.tile([0.0, 0.0, 2.0], (7, 1)), atol=1e-6)


def test_the_masses_make_a_step_of_one_stable() -> None:
    model = bar(bd.EulerBernoulli(E=1e9, nu=0.3, radius_ratio=0.2))
    mass, inertia = masses(model)
    assert math.sqrt(stiffest(model, mass, inertia)) == pytest.approx(1.8, rel=3e-3)


def test_what_it_cannot_do_is_an_error() -> None:
    boundary = [bd.Fix(bd.Index(0)), bd.Load(bd.Index(6), force=(0.0, 1.0, 0.0))]
    model = bd.Model(row(7, LENGTH / 6), THICK, 1.0, boundary=boundary)
    with pytest.raises(InputError, match="tolerance"):
        bd.solve_relaxed(model, tolerance=0.0)
    with pytest.raises(InputError, match="use solve_explicit"):
        bd.solve_relaxed(bd.Model(row(7, LENGTH / 6), THICK, 1.0, boundary=boundary, contact=bd.LinearContact(E=1e9)))
    with pytest.raises(InputError, match="is held"):
        bd.solve_relaxed(bd.Model(row(7, LENGTH / 6), THICK, 1000.0))
    with pytest.raises(ConvergenceError, match="do not balance after 50 steps"):
        bd.solve_relaxed(model, most=50)
    fold = [bd.Fix(bd.Index(0)), bd.Load(bd.Index(2), moment=(0.0, 0.0, 6.0 * BENDING / LENGTH))]
    with pytest.raises(ConvergenceError, match="more and shorter bonds"):
        bd.solve_relaxed(bd.Model(row(3, LENGTH / 2), THICK, 1.0, boundary=fold))
