"""Bodies that collide: what runs keep, and the time step that resolves their contacts."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import bondem as bd
from tests.bits import assert_resumes_to
from tests.models import momenta
from tests.scripts import scripts
from tests.specimens import cells, spheres

GAP = 2e-4
BOX = bd.Box((10e-3, 10e-3, 10e-3))
BRICKS = [cells(BOX, 60, seed=seed) for seed in (1, 2)]
ROCKS = [spheres(bd.Ball(radius=5e-3), 150, seed=seed, reach=1.01) for seed in (1, 2)]
BEAMS = bd.EulerBernoulli(E=50e9, nu=0.2, radius_ratio=0.6)
ROUGH = bd.LinearContact(E=40e9, friction=0.3)
SPEED = 5.0


def facing(shift: tuple[float, float] = (0.3e-3, -0.4e-3)) -> bd.Lattice:
    """Two bodies of cells whose faces are parallel, one above the other."""
    return bd.join(BRICKS[0], BRICKS[1].moved((*shift, 10e-3 + GAP)), names=("low", "high"))


def falling(model: bd.Model) -> bd.State:
    """The second body moves towards the first."""
    state = model.state()
    state.set_velocity(bd.Body(1), (0.0, 0.0, -SPEED))
    return state


def of_cells(contact: bd.ContactLaw = ROUGH) -> bd.Model:
    return bd.Model(facing(), bd.CellBond(E=40e9, nu=0.2), 2500.0, contact=contact)


def of_beams(contact: bd.ContactLaw = ROUGH) -> bd.Model:
    scene = bd.join(ROCKS[0], ROCKS[1].moved((1e-3, 0.5e-3, 10.3e-3)), names=("low", "high"))
    return bd.Model(scene, BEAMS, 2500.0, contact=contact)


@pytest.mark.parametrize(("model", "duration"), [
    (of_cells(), 2e-5), (of_cells(bd.HertzMindlin(E=40e9, nu=0.2, friction=0.3)), 2e-5), (of_beams(), 2.5e-4),
], ids=["cells", "cells, Hertz", "beams"])  # fmt: skip
def test_elastic_bodies_collide(model, duration):
    lattice, state = model.lattice, falling(model)
    linear, angular = momenta(model, state)
    size = np.linalg.norm(state.position, axis=1) * model.mass * np.linalg.norm(state.velocity, axis=1)
    run = bd.solve_explicit(model, duration=duration, state=state)
    after = momenta(model, run.state)
    assert run.state.velocity[lattice.body == 0, 2].mean() < -0.3 * SPEED  # they have met …
    assert run.history.energy["contact"][-1] == 0.0  # … and parted
    assert np.abs(after[0] - linear).max() < 1e-15 * np.abs(linear).max()
    assert np.abs(after[1] - angular).max() < 1e-14 * size.sum()
    assert run.residual < 1e-4


def test_the_ledger_of_a_collision_is_of_second_order():
    model = of_cells(bd.LinearContact(E=40e9))
    dt = bd.solve_explicit(model, duration=0.0, state=falling(model)).dt
    coarse, fine = (
        bd.solve_explicit(model, duration=4e-5, dt=k * dt, state=falling(model), every=10).residual for k in (2, 1)
    )
    assert 3.5 < coarse / fine < 4.5


def default_step(lattice: bd.Lattice, **options) -> float:
    law = BEAMS if lattice.cells is None else bd.CellBond(E=40e9, nu=0.2)
    model = bd.Model(lattice, law, 2500.0, contact=ROUGH, **options)
    return bd.solve_explicit(model, duration=0.0).dt


def collision(model: bd.Model, chosen: np.ndarray) -> float:
    """Duration of the shortest collision of two equal elements [s], π √(m / 2 k) with k = π E R / 2."""
    stiffness = 0.5 * np.pi * ROUGH.E * model.contact_radius[chosen]
    return float((np.pi * np.sqrt(0.5 * model.mass[chosen] / stiffness)).min())


@pytest.mark.filterwarnings("ignore:plane faces:bondem.errors.ContactWarning")
def test_the_default_step_resolves_collisions_of_bodies():
    one = default_step(BRICKS[0])
    assert one == pytest.approx(default_step(BRICKS[0].moved((1.0, 0.0, 0.0))), rel=1e-6)
    model = of_cells()
    free = model.lattice.cells.free_area > 0.0
    assert default_step(model.lattice) == pytest.approx(collision(model, free) / 50, rel=1e-12)
    assert default_step(model.lattice) < 0.5 * one
    # cells that were inside may touch once bonds break
    inside = default_step(model.lattice, failure=bd.Rankine(tension=4e6, fracture_energy=20.0))
    assert inside == pytest.approx(collision(model, np.ones_like(free)) / 50, rel=1e-12)
    model = of_beams()
    every = np.ones(len(model.mass), dtype=bool)
    assert default_step(model.lattice) == pytest.approx(collision(model, every) / 20, rel=1e-12)


def test_a_body_of_a_scene_moves_and_breaks_as_it_does_alone():
    rock, ends = ROCKS[0], []
    for lattice in (rock, bd.join(rock, ROCKS[1].moved((0.0, 0.0, 20e-3)))):
        failure = bd.PeripheralStress(tension=60e6, shear=120e6)
        state = bd.Model(lattice, BEAMS, 2500.0, contact=ROUGH, failure=failure).state()
        velocity = np.zeros((len(lattice.particles), 3))
        velocity[: len(rock.particles)] = np.random.default_rng(1).normal(0.0, 3.0, (len(rock.particles), 3))
        state.velocity = velocity
        ends.append(bd.solve_explicit(state.model, duration=2e-5, dt=2e-8, state=state).state)
    alone, within = ends
    assert 10 < (alone.bond_integrity < 1.0).sum() < len(rock.pairs)
    # R̄ of a body, of which bonds have their radius, is its own; sums have another order
    apart = np.abs(within.displacement[: len(rock.particles)] - alone.displacement).max()
    assert apart < 1e-10 * np.abs(alone.displacement).max()
    np.testing.assert_array_equal(within.bond_integrity[: len(rock.pairs)], alone.bond_integrity)


def test_a_scene_that_breaks_has_the_same_bits_where_it_is_cut_off(tmp_path):
    model = replace(of_beams(), failure=bd.PeripheralStress(tension=5e6, shear=10e6))

    def run(**options: Any) -> bd.ExplicitResult:
        return bd.solve_explicit(model, duration=1.5e-4, state=falling(model), save_every=500, **options)

    assert_resumes_to(run(), run, tmp_path / "run.h5", 0.9)


def test_bars_that_collide_exchange_their_velocities():
    bars: Any = scripts("examples", bars="colliding_bars")["bars"]
    found = bars.collide(count=120)
    assert found.velocity == pytest.approx((0.0, bars.SPEED), abs=0.02 * bars.SPEED)
    assert found.contact == pytest.approx(2.0 * bars.LENGTH / bars.CELERITY, rel=0.05)
    assert found.run.residual < 1e-4


def test_the_floor_takes_the_momentum_of_rocks_that_break():
    rocks: Any = scripts("examples", rocks="falling_rocks")["rocks"]
    found = rocks.fall(2.0, duration=6e-3)
    assert 0.1 < found.broken < 0.6
    assert found.impulse == pytest.approx(found.expected, rel=5e-3)
    assert found.run.residual < 5e-4


def test_a_wall_of_bricks_takes_the_momentum_of_the_ball():
    bricks: Any = scripts("examples", bricks="brick_wall")["bricks"]
    run, lost, gained = bricks.shot(2, 2, 1.5e-3)
    assert len(run.events) > 100
    assert lost > 0.05 * bricks.MASS * bricks.SPEED
    assert gained == pytest.approx(lost, rel=0.01)
