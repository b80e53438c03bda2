"""Dynamic relaxation by the core: numbers of the former loop, bits at any pause, and equilibrium."""

import numpy as np
import pytest

import bondem as bd
from bondem._cache_lines import lines
from bondem._tables.statics_tables import DynamicRelaxation
from bondem._tables.step_tables import BeamSums
from bondem.interactions.beams.beam_tables import beam_tables
from bondem.model.state import State
from bondem.statics.relaxation import masses, relaxed
from tests.core.former_loop import FormerLoop
from tests.core.test_steps import LAWS, X_MAX, X_MIN, crooked

RAMP, LENGTH, TOLERANCE, NOISE = 10, 0.35, 1e-6, 1e-9


def loaded(law: str) -> bd.Model:
    pull, lift = bd.Load(X_MAX, force=(30.0, -10.0, 20.0)), bd.Drive(bd.Index([60]), z=bd.Constant(1e-3))
    return bd.Model(crooked((6, 4, 4)), LAWS[law], density=1e3, boundary=[bd.Fix(X_MIN), pull, lift])


def parts_of(model: bd.Model) -> tuple[np.ndarray, ...]:
    """Load, 1 / mass and 1 / inertia, free degrees of freedom, prescribed motion."""
    n, constraints = len(model.layout.order), model.constraints
    inverse = 1.0 / np.column_stack(masses(model))
    return constraints.final_load(n), inverse, ~constraints.prescribed(n), constraints.final_motion(n)


def by_core(model: bd.Model, chunk: int, steps: int = 2000) -> tuple[np.ndarray, int, bool]:
    """Poses, steps and whether forces balance."""
    load, inverse, free, motion = parts_of(model)
    state, n = State(model), len(load)
    beams, uniform = beam_tables(model.bonds, model.layout, model.period, state.integrity)
    sums = BeamSums(beams.i, beams.j, lines(n))
    table = DynamicRelaxation(
        state.pose, np.zeros((n, 6)), np.zeros((n, 6)), load, inverse, free.astype(np.uint8), motion, np.zeros(2),
        RAMP, LENGTH, TOLERANCE, NOISE,
    )  # fmt: skip
    done, balanced = 0, False
    while done < steps and not balanced:
        gone, _, balanced = relaxed(beams, uniform, sums, table, done, min(chunk, steps - done))
        done += gone
    return state.pose, done, balanced


@pytest.mark.parametrize("law", ["Timoshenko", "Euler–Bernoulli"])
def test_steps_are_those_of_the_former_loop(law):
    model, former = loaded(law), FormerLoop("steps", f"relaxed, {law}")
    assert (model.bonds.uniform is None) == (law == "Timoshenko")
    pose, steps, balanced = by_core(model, 2000)
    assert balanced
    assert steps == former.numbers["steps"] > 0
    former.assert_close(1e-14, pose=pose)


def test_pauses_change_no_bit():
    whole, pieces = by_core(loaded("Timoshenko"), 2000), by_core(loaded("Timoshenko"), 7)
    np.testing.assert_array_equal(whole[0], pieces[0])
    assert whole[1:] == pieces[1:]


def test_small_loads_have_the_displacements_of_linear_statics():
    model = loaded("parallel")
    found, linear = bd.solve_relaxed(model), bd.solve_static(model)
    size = np.abs(linear.displacement).max()
    np.testing.assert_allclose(found.displacement, linear.displacement, rtol=0, atol=1e-2 * size)
