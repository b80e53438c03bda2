"""Contacts beside intact bonds (PFC's unbonded component): forces of the bond and of the contact add."""

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from tests.models import time_step
from tests.specimens import cube, loose, two_spheres

R = 0.5e-3
LAW = bd.EulerBernoulli(E=1e9, nu=0.3, radius=0.35e-3)


def force(bonded: bool, parallel: bool, sign: float, *, begin: float = 1e-4) -> np.ndarray:
    """What holds one of two touching spheres while the other is pressed on or pulled off, then slid, (t, 3)."""
    pair = two_spheres(2.0 * R)
    lattice = pair if bonded else loose(pair.centre, R)
    drive = bd.Drive(
        bd.Index([1]), x=bd.Ramp(0.0, -sign * 2e-3 * R, 1e-4), y=bd.Ramp(0.0, 4e-3 * R, 1e-4, begin=begin),
        z=0.0, rx=0.0, ry=0.0, rz=0.0,
    )  # fmt: skip
    contact = bd.LinearContact(E=3e8, friction=0.4, parallel=parallel)
    boundary = [bd.Fix(bd.Index([0])), drive]
    model = bd.Model(lattice, LAW, density=1000.0, contact=contact, boundary=boundary)
    gauges = {"grip": bd.Gauge(bd.Index([0]), "force", "sum")}
    dt = time_step(bd.Model(pair, LAW, density=1000.0, contact=contact), 0.2)
    run = bd.solve_explicit(model, duration=2e-4, dt=0.5 * dt, every=1, gauges=gauges)
    assert np.abs(run.history.energy["balance"]).max() < 1e-4 * run.history.energy["work"].max()
    return np.asarray(run.history["grip"])


def test_bond_and_contact_add_where_pressed(one_thread: None) -> None:
    both, bond, contact = force(True, True, 1.0), force(True, False, 1.0), force(False, False, 1.0)
    assert len(both) == len(bond) == len(contact)
    assert np.abs(contact).max(axis=0)[:2].min() > 0.05 * np.abs(bond).max()
    assert both == pytest.approx(bond + contact, abs=1e-9 * np.abs(both).max())


def test_a_contact_beside_a_bond_bears_no_tension(one_thread: None) -> None:
    assert force(True, True, -1.0) == pytest.approx(force(True, False, -1.0), abs=1e-15)


def test_contacts_beside_facets_of_cells_are_refused() -> None:
    with pytest.raises(InputError, match="leave out parallel= for cells"):
        bd.Model(cube(20), bd.CellBond(E=1e9, nu=0.2), density=1000.0, contact=bd.LinearContact(E=1e9, parallel=True))
