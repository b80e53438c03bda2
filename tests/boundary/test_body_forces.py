"""Body forces that vary in space: closed forms of a spinning rod and of loose elements, and what is refused."""

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError, RunFileError
from tests.recording import Record
from tests.specimens import loose, rod

LAW = bd.EulerBernoulli(E=2.0e9, nu=0.25, radius_ratio=0.6)
RHO = 1500.0
pytestmark = pytest.mark.usefixtures("one_thread")


def test_a_body_force_that_varies_is_force_over_mass_at_each_element() -> None:
    """A rod in uniform spin: ρ ω² x pulls it, and N falls with the square of the radius."""
    omega, n = 200.0, 41
    spin = bd.BodyForce(lambda x: omega**2 * x * [1.0, 0.0, 0.0])
    model = bd.Model(rod(n), LAW, RHO, boundary=[bd.Fix(bd.Index([0])), spin])
    x = model.lattice.particles.position[:, 0]
    pull = omega**2 * model.mass * x
    static = bd.solve_static(model)
    beyond = np.cumsum(pull[::-1])[::-1]
    expected = np.concatenate([[0.0], np.cumsum(beyond[1:] / model.stiffness.kn)])
    np.testing.assert_allclose(static.displacement[:, 0], expected, rtol=1e-9, atol=1e-9 * expected[-1])
    values = bd.BodyForce(omega**2 * np.column_stack([x, 0 * x, 0 * x]))
    listed = bd.solve_static(model.with_boundary([bd.Fix(bd.Index([0])), values]))
    np.testing.assert_array_equal(listed.displacement, static.displacement)
    constant = [bd.Fix(bd.Index([0])), bd.BodyForce(np.tile([9.81, 0.0, 0.0], (n, 1)), bd.Index(range(5, n)))]
    uniform = [bd.Fix(bd.Index([0])), bd.BodyForce((9.81, 0.0, 0.0), bd.Index(range(5, n)))]
    a, b = (bd.solve_static(model.with_boundary(each)).displacement for each in (constant, uniform))
    np.testing.assert_allclose(a, b, rtol=1e-12)


def test_loose_elements_follow_a_field_over_time(record: Record) -> None:
    random = np.random.default_rng(0)
    places = 1e-2 * np.stack(np.meshgrid(*[np.arange(3)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    falling = loose(places, 1e-3)
    field = random.standard_normal((27, 3))
    half = bd.Index(range(13))
    model = bd.Model(falling, None, 2000.0, boundary=[
        bd.BodyForce(field, schedule=bd.Ramp(0.0, 2.0, 1.0)), bd.BodyForce((0.0, 0.0, -9.81), half)])  # fmt: skip
    run = bd.solve_explicit(model, duration=1.0, dt=1e-3, every=100)
    weight = np.zeros((27, 3))
    weight[:13, 2] = -9.81
    np.testing.assert_allclose(run.state.velocity, field + weight, rtol=1e-9, atol=1e-9)
    assert run.residual < 1e-6


def test_body_forces_that_make_no_sense_are_refused(tmp_path) -> None:
    def of(given):
        return bd.Model(rod(9), LAW, RHO, boundary=[bd.Fix(bd.Index([0])), bd.BodyForce(given)])

    for given, words in (
        (np.zeros((7, 3)), r"shape \(7, 3\) or are not finite; give \(9, 3\)"),
        (np.zeros((9, 2)), r"shape \(9, 2\)"),
        (np.full((9, 3), np.nan), "not finite"),
        (lambda x: x[:, 0], r"shape \(9,\) or are not finite; give \(9, 3\)"),
        (lambda x: x / 0.0 * np.nan, "not finite"),
    ):
        with pytest.raises(InputError, match=words), np.errstate(all="ignore"):
            of(given)
    kept = of(np.ones((9, 3)))
    run = bd.solve_explicit(kept, duration=1e-3, out=tmp_path / "run.h5")
    again = bd.read_run(tmp_path / "run.h5").model
    np.testing.assert_array_equal(again.constraints.final_load(9), kept.constraints.final_load(9))
    assert run.status is bd.Status.COMPLETED
    with pytest.raises(RunFileError, match="function"):
        bd.solve_explicit(of(lambda x: x), duration=1e-3, out=tmp_path / "other.h5")
