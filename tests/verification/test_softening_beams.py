"""Beams that soften: two spheres against closed forms, and the ledger."""

import math

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from bondem.solve.timestep import critical_step

R, L, RADIUS = 0.5e-3, 1.05e-3, 0.35e-3
E, NU = 1e9, 0.3
AREA = math.pi * RADIUS**2
KN = E * AREA / L
FT, G_F, G_II = 1e6, 10.0, 30.0
# N_t² / 2 kn over G_f A: 0.05, so that a beam that is torn opens to 20 times where it begins.
LAW = bd.EulerBernoulli(E=E, nu=NU, radius=RADIUS)
VERLET = bd.VelocityVerlet()
CRITERION = bd.MohrCoulomb(
    tension=FT, cohesion=FT, friction_angle=0.5, fracture_energy=G_F, fracture_energy_shear=G_II
)


def pulled(direction: tuple[float, float], reach: float) -> bd.Model:
    """Two spheres, bonded, one held, the other moved by `reach` [m] without turning."""
    lattice = bd.Lattice(bd.Particles(np.array([[0.0, 0.0, 0.0], [L, 0.0, 0.0]]), R), np.array([[0, 1]]))
    x, y = (bd.Ramp(0.0, reach * part, 1e-3) for part in direction)
    drive = bd.Drive(bd.Index([1]), x=x, y=y, z=0.0, rx=0.0, ry=0.0, rz=0.0)
    return bd.Model(lattice, LAW, density=1000.0, failure=CRITERION, boundary=[bd.Fix(bd.Index([0])), drive])


def test_a_torn_beam_takes_up_its_fracture_energy(one_thread: None) -> None:
    """Peak f_t A; the force falls on a line to 2 G_f / f_t; G_f A in all, and a ledger that closes."""
    last = 2.0 * G_F / FT
    model = pulled((1.0, 0.0), 1.1 * last)
    dt = 0.2 * critical_step(model, VERLET)
    gauges = {"grip": bd.Gauge(bd.Index([0]), "force", "sum")}
    run = bd.solve_explicit(model, duration=1e-3, dt=dt, every=1, gauges=gauges)
    energy = run.history.energy
    force = np.abs(np.asarray(run.history["grip"])[:, 0])
    opened = np.array([bd.Ramp(0.0, 1.1 * last, 1e-3).at(t) for t in run.history.time])
    first = FT * AREA / KN
    line = np.where(opened < first, KN * opened, FT * AREA * (last - opened) / (last - first)).clip(0.0)
    assert force == pytest.approx(line, abs=2e-2 * FT * AREA)
    assert energy["fracture"][-1] == pytest.approx(G_F * AREA, rel=1e-3)
    assert np.abs(energy["balance"]).max() < 1e-4 * G_F * AREA
    assert len(run.events) == 1
    assert run.state.integrity[0] == 0.0


def test_a_sheared_beam_takes_up_that_of_shear(one_thread: None) -> None:
    """G_II A, but for the part that the turning branch opens."""
    model = pulled((0.0, 1.0), 2.5e-4)
    dt = 0.2 * critical_step(model, VERLET)
    run = bd.solve_explicit(model, duration=1e-3, dt=dt, every=1)
    energy = run.history.energy
    assert energy["fracture"][-1] == pytest.approx(G_II * AREA, rel=1e-3)
    assert np.abs(energy["balance"]).max() < 1e-4 * G_II * AREA
    assert run.state.integrity[0] == 0.0


def test_a_bond_that_snaps_back_is_refused() -> None:
    with pytest.raises(InputError, match="snap back above 2 E G_f / f_t²"):
        bd.Model(
            pulled((1.0, 0.0), 1e-6).lattice, LAW, density=1000.0,
            failure=bd.PeripheralStress(tension=1e8, shear=1e8, fracture_energy=G_F),
        )  # fmt: skip
