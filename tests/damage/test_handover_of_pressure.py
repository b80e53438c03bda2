"""Contact where bonds of the non-local law and brittle facets break: it begins with no more than the bond bore."""

import functools
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.explicit import integrate
from bondem.interactions.contact.contact_columns import KIND, NOT_YET, START
from bondem.model.highest_frequency import highest_frequency
from tests.bits import assert_resumes_to, assert_same_bits
from tests.damage.test_non_local_breaking import two
from tests.device_sides import LoopOf, on_device
from tests.models import time_step

E = 70e9
STRENGTH = bd.MohrCoulomb(tension=30e6, cohesion=90e6, friction_angle=0.6)
LAWS = {"non-local": bd.NonLocal(E=E, nu=0.2), "cells": bd.CellBond(E=E, nu=0.2)}
pytestmark = pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")  # fast on purpose
SIDES: dict[str, LoopOf] = {"CPU": CoreLoop, "device": on_device}


@functools.cache
def struck(law: str) -> tuple[bd.Model, bd.State]:
    """A ball that hits a plate and breaks into small pieces, and its state before; nothing else supplies energy."""
    plate = bd.PlaneWall((0.0, 0.0, -10e-3), (0.0, 0.0, 1.0))
    body = bd.connect(bd.pack(bd.Ball(10e-3), count=200, method="even", seed=2), method="laguerre")
    touch = bd.LinearContact(E=E, friction=0.3)
    model = bd.Model(body, LAWS[law], 2500.0, failure=STRENGTH, contact=touch, walls=[plate])
    state = model.state()
    state.velocity = (0.0, 0.0, -60.0)
    return model, state


def strike(law: str, duration: float, *, on: LoopOf | None = None, **options) -> bd.ExplicitResult:
    """The run of the ball, by another loop if one is given."""
    model, state = struck(law)
    damping = bd.BondDamping(0.05)
    how = {"duration": duration, "dt": time_step(model, 0.8, damping), "every": 50, "damping": damping, **options}
    if on is not None:
        return integrate(model, bd.Plan(**how), state=state.copy(), loop_of=on)
    return bd.solve_explicit(model, state=state.copy(), **how)


@pytest.mark.parametrize("law", LAWS)
def test_no_failure_releases_energy_below_zero(law: str, one_thread: None) -> None:
    run = strike(law, 6e-5)
    supplied = 0.5 * (struck(law)[0].mass * 60.0**2).sum()
    assert len(run.events) > 900
    assert run.events.energy.min() > -1e-12 * supplied
    assert run.history.energy["fracture"][-1] > 0.05 * supplied
    assert np.abs(run.history.energy["balance"]).max() < 5e-3 * supplied


@pytest.mark.parametrize("law", LAWS)
def test_the_distance_of_such_a_contact_is_kept(law: str, one_thread: None, tmp_path: Path) -> None:
    """On a device, and by a run resumed where pairs touch at it and others do so later, to the bit."""
    half, whole = strike(law, 8e-6), strike(law, 16e-6)
    memory = half.state.stretch
    assert ((memory[:, START] > 0.0) & (memory[:, KIND] == 0.0)).sum() > 3
    assert (memory[:, KIND] == NOT_YET).any()
    assert_same_bits(whole, strike(law, 16e-6, on=on_device))
    assert_resumes_to(whole, functools.partial(strike, law, 16e-6, save_every=17), tmp_path / "run.h5", 0.5)


@pytest.mark.parametrize("side", SIDES)
def test_cells_of_an_open_bond_touch_at_their_distance_until_they_part(side: str) -> None:
    """The second cell turns about their facet, so that its centre is nearer than at rest, and pulls until it breaks.

    Pressed again, they touch at the distance of the break; once farther apart than at rest, at that of rest.
    """
    angle, along = 0.2, [0.0, 0.0, 5e-4, -1e-3, 1e-2, -1e-3]
    start = two(bd.Rankine(tension=1e5), bd.Drive(bd.Index([1]), rx=0.0)).interaction.by_user
    arm = -start.lever_j[0]  # from the facet to the second centre
    time = np.linspace(0.0, 1.0, 101)
    turned = angle * time
    place = np.column_stack([np.cos(turned) * arm[0], np.sin(turned) * arm[0], 0.0 * time]) - arm
    later = np.array([1.0, 1.2, 1.4, 2.2, 3.0])
    way = place[-1] + np.outer(along[1:], [np.cos(0.5 * angle), np.sin(0.5 * angle), 0.0])
    times, ways = np.append(time, later[1:]), np.vstack([place, way[1:]])
    x, y = (bd.Table(times.tolist(), ways[:, c].tolist()) for c in (0, 1))
    turn = bd.Ramp(0.0, angle, 1.0)
    model = two(
        bd.Rankine(tension=1e5), bd.Drive(bd.Index([1]), x=x, y=y, z=0.0, rx=0.0, ry=0.0, rz=turn),
        bd.LinearContact(E=1e9, friction=0.0),
    )  # fmt: skip
    dt = 0.2 * 2.0 / highest_frequency(model)
    gauges = {"grip": bd.Gauge(bd.Index([0]), "force", "sum")}
    run = integrate(model, bd.Plan(duration=3.0, dt=dt, every=1, gauges=gauges), loop_of=SIDES[side])
    assert len(run.events) == 1
    assert run.events.gap[0] > 0.0

    def branch_at(t: np.ndarray) -> np.ndarray:
        moved = np.column_stack([np.interp(t, times, ways[:, c]) for c in range(3)])
        return moved + model.lattice.branch[0]

    kn, rest = model.interaction.by_user.kn[0], model.lattice.length[0]
    after = run.history.time > run.events.time[0]
    branch, begun = branch_at(run.history.time[after]), np.linalg.norm(branch_at(run.events.time))
    length = np.linalg.norm(branch, axis=1)
    assert begun < 0.997 * rest
    reach = np.where(np.maximum.accumulate(length) < rest, begun, rest)
    pressed = np.einsum("tk,tk->t", run.history["grip"][after], branch / length[:, None])
    np.testing.assert_allclose(pressed, kn * np.maximum(reach - length, 0.0), rtol=1e-6, atol=1e-6 * kn * 1e-3)
    for distance in (begun, rest):
        assert ((reach == distance) & (pressed > 0.0)).sum() > 10


def test_pressure_stays_where_a_facet_breaks_by_shear() -> None:
    """Two cubes at ν = 0, pressed by E A u / L and slid until their facet breaks: the contact has the same force."""
    particles = bd.Particles([(0.5, 0.5, 0.5), (1.5, 0.5, 0.5)], 0.5, shape=bd.Box((2.0, 1.0, 1.0)))
    slide = bd.Table([0.0, 1.0, 2.0], [0.0, 0.0, 1e-4])
    drive = bd.Drive(bd.Index([1]), x=bd.Ramp(0.0, -1e-6, 1.0), y=slide, z=0.0, rx=0.0, ry=0.0, rz=0.0)
    model = bd.Model(
        bd.connect(particles, method="laguerre"), bd.CellBond(E=1e9, nu=0.0), 2500.0,
        failure=bd.MohrCoulomb(tension=1e5, cohesion=1e4, friction_angle=0.01),
        contact=bd.LinearContact(E=1e9, friction=0.0), boundary=[bd.Fix(bd.Index([0])), drive],
    )  # fmt: skip
    gauges = {"grip": bd.Gauge(bd.Index([0]), "force", "sum")}
    plan = bd.Plan(duration=2.0, dt=0.4 / highest_frequency(model), every=1, gauges=gauges)
    run = integrate(model, plan, loop_of=CoreLoop)
    assert len(run.events) == 1
    broken = np.searchsorted(run.history.time, run.events.time[0])
    np.testing.assert_allclose(run.history["grip"][broken - 2 : broken + 3, 0], 1e3, rtol=1e-3)
