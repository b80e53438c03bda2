"""Specimens far from the origin of coordinates, as in UTM: the digits of strains are not lost."""

import numpy as np
import pytest

import bondem as bd
from tests.specimens import cells, grid

FAR = np.array([5e5, 5e6, 300.0])
LAW = bd.EulerBernoulli(E=70e9, nu=0.3, radius_ratio=0.5)


def beams(shift) -> bd.Lattice:
    # places that are whole multiples of what doubles tell apart at 5e6 m
    return bd.connect(bd.Particles(grid((6, 3, 3), 0.125).centre + shift, 0.0625))


def pulled(lattice: bd.Lattice, law, **options):
    first, last = bd.Face("x_min"), bd.Face("x_max")
    load = bd.Load(last, force=(1e3, 200.0, 0.0), schedule=bd.Ramp(0.0, 1.0, 2e-4))
    model = bd.Model(lattice, law, 2000.0, boundary=[bd.Fix(first), load], **options)
    gauges = {"F": bd.Gauge(first, "force"), "u": bd.Gauge(last, "displacement")}
    run = bd.solve_explicit(model, duration=1e-3, gauges=gauges)
    return model, run


def test_beams_bear_the_same_far_away() -> None:
    (near, here), (far, there) = (pulled(beams(shift), LAW) for shift in (0.0, FAR))
    np.testing.assert_allclose(there.history["F"], here.history["F"], rtol=1e-9, atol=1e-7)
    np.testing.assert_allclose(there.state.displacement, here.state.displacement, rtol=1e-8, atol=1e-15)
    force = bd.bond_forces(far, there.state).force
    expected = bd.bond_forces(near, here.state).force
    np.testing.assert_allclose(force, expected, atol=1e-8 * np.abs(expected).max())  # they were 0.6 % off
    np.testing.assert_allclose(there.state.position, here.state.position + FAR, atol=1e-9)
    assert there.residual == pytest.approx(here.residual, rel=1e-3)


def test_stages_files_and_equilibria_are_the_same_far_away(tmp_path) -> None:
    lattice = beams(FAR)
    model, run = pulled(lattice, LAW)
    whole = bd.solve_explicit(model, duration=2e-4, out=tmp_path / "run.h5")
    kept = bd.read_run(tmp_path / "run.h5").state
    np.testing.assert_array_equal(kept.pose, whole.state.pose)
    np.testing.assert_array_equal(kept.position, whole.state.position)
    again = model.state()
    again.set_pose(position=run.state.position, orientation=run.state.orientation)
    np.testing.assert_allclose(again.displacement, run.state.displacement, atol=2e-9)  # of the places given
    near = pulled(beams(0.0), LAW)[0]
    for nonlinear in (False, True):
        here, there = (bd.solve_static(one, nonlinear=nonlinear).displacement for one in (near, model))
        np.testing.assert_allclose(there, here, rtol=1e-8, atol=1e-8 * np.abs(here).max())


def test_walls_and_breakage_are_the_same_far_away() -> None:
    """A block falls on a plane beside it, and breaks."""
    found = []
    for shift in (np.zeros(3), FAR):
        lattice = beams(shift)
        wall = bd.PlaneWall(tuple(np.array([-0.0625, 0.0, 0.0]) + shift), (1.0, 0.0, 0.0))
        model = bd.Model(
            lattice, LAW, 2000.0, contact=bd.LinearContact(E=1e9), walls=[wall],
            failure=bd.PeripheralStress(tension=2e6, shear=2e6),
        )  # fmt: skip
        state = model.state()
        state.set_motion(velocity=np.tile([-2.0, 0.1, 0.0], (len(lattice.particles), 1)))
        found.append((shift, bd.solve_explicit(model, duration=1.5e-3, state=state)))
    (_, here), (shift, there) = found
    assert len(here.events.time) > 5
    np.testing.assert_array_equal(here.events.bond, there.events.bond)
    np.testing.assert_allclose(here.events.position + shift, there.events.position, atol=2e-9)


def test_a_body_of_cells_bears_the_same_far_away() -> None:
    here = cells(bd.Box((0.5, 0.25, 0.25)), 300, spread=0.2)
    law = bd.CellBond(E=30e9, nu=0.2)
    centre = np.round(here.particles.position * 2.0**25) / 2.0**25
    runs = []
    for shift in (np.zeros(3), np.array([5e5, 5e5, 0.0])):
        box = bd.Box(size=(0.5, 0.25, 0.25)).moved(shift) if shift.any() else here.particles.shape
        particles = bd.Particles(centre + shift, here.particles.radius, shape=box)
        runs.append(pulled(bd.connect(particles, method="laguerre"), law)[1])
    np.testing.assert_allclose(runs[1].history["F"], runs[0].history["F"], rtol=1e-4, atol=0.1)
