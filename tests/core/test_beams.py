"""Passes over beams in any poses: their loads, energies and turns."""

import numpy as np
import pytest

import bondem as bd
from bondem._tables.step_tables import BeamSums
from bondem.interactions.beams.beam_tables import beam_energies, beam_tables, count_turned, load_beams, loads_of_each
from bondem.model.state import State
from tests.core.test_steps import LAWS, crooked


def displaced(law: str) -> tuple[bd.Model, State]:
    model = bd.Model(crooked((4, 3, 2)), LAWS[law], density=1e3)
    rng, state = np.random.default_rng(2), State(model)
    state.pose[:, :3] += 0.01 * rng.standard_normal((len(state.pose), 3))
    state.pose[:, 5:] = 0.02 * rng.standard_normal((len(state.pose), 3))
    state.pose[:, 4:] /= np.linalg.norm(state.pose[:, 4:], axis=1)[:, None]
    return model, state


@pytest.mark.parametrize("law", LAWS)
def test_loads_of_single_beams_add_up_to_the_sums(law):
    model, state = displaced(law)
    state.integrity[::3] = 0.5
    beams, _ = beam_tables(model.bonds, model.layout, model.period, state.integrity, may_share=False)
    on_i, on_j = loads_of_each(state.pose, beams, len(model.layout.i))
    sums = np.zeros((len(state.pose), 8))
    np.add.at(sums, model.layout.i, on_i)
    np.add.at(sums, model.layout.j, on_j)
    found = np.zeros_like(sums)
    load_beams(state.pose, beams, BeamSums(beams.i, beams.j, found))
    np.testing.assert_allclose(found, sums, rtol=1e-10, atol=1e-9 * np.abs(sums).max())
    np.testing.assert_array_equal(on_i[:, :3], -on_j[:, :3])


@pytest.mark.parametrize("law", LAWS)
def test_energies_go_with_the_integrity_and_vanish_at_rest(law):
    model, state = displaced(law)
    beams, _ = beam_tables(model.bonds, model.layout, model.period, state.integrity, may_share=False)
    whole = np.array(beam_energies(state.pose, beams))
    half = np.array(beam_energies(state.pose, beams._replace(integrity=0.5 * beams.integrity)))
    assert (whole > 0.0).all()
    np.testing.assert_allclose(half, 0.5 * whole, rtol=1e-14)
    rest = np.array(beam_energies(State(model).pose, beams))
    np.testing.assert_allclose(rest, 0.0, atol=1e-20 * whole.sum() + 1e-25)


def test_unbroken_beams_that_are_turned_too_far_are_counted():
    model, _ = displaced("Timoshenko")
    state = State(model)
    beams, _ = beam_tables(model.bonds, model.layout, model.period, state.integrity)
    of_first = int(((model.layout.i == 0) | (model.layout.j == 0)).sum())
    for angle, expected in ((0.5, (0, 0)), (1.2, (of_first, 0)), (2.4, (of_first, of_first))):
        state.pose[0, 4:] = [np.cos(angle / 2), 0.0, 0.0, np.sin(angle / 2)]
        wide, lost, sick = count_turned(state.pose, beams)
        assert (wide, lost, sick) == (*expected, False)
    broken = beams._replace(integrity=np.zeros_like(beams.integrity))
    assert count_turned(state.pose, broken) == (0, 0, False)
    state.pose[0, 0] = np.nan
    assert count_turned(state.pose, beams)[2]
