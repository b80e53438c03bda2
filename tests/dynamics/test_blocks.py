"""The same bits over threads where a specimen has more than one block, which domains cut otherwise."""

import hashlib

import numpy as np
import pytest

import bondem as bd
from bondem._tables.columns import BONDS_OF_PORTION
from tests.bits import threads
from tests.scripts import python
from tests.specimens import crooked_block

EDGES = (30, 20, 16)
ON = (1, 2, 3)
STEPS = 50
CONTACT = bd.LinearContact(E=1e7, friction=0.4, damping=0.1)


def crooked(*, contacts: bool) -> bd.Model:
    """A block of elements that move about: bonded and pulled, or a shaken mix of bonded and loose ones on a floor."""
    radius, reach = ((0.45, 0.52), 1.06) if contacts else ((0.3, 0.4), 1.62)
    lattice = crooked_block(EDGES, radius=radius, reach=reach, seed=4)
    law = bd.EulerBernoulli(E=1e7, nu=0.2, radius_ratio=0.6)
    if contacts:
        floor = bd.PlaneWall((0.0, 0.0, -0.5), (0.0, 0.0, 1.0), motion=bd.Driven(vz=1.0))
        return bd.Model(lattice, law, density=1000.0, contact=CONTACT, walls=[floor])
    boundary = [bd.Fix(bd.Face("x_min", depth=0.5)), bd.Load(bd.Face("x_max", depth=0.5), force=(3e5, 0.0, 1e5))]
    return bd.Model(lattice, law, density=1000.0, boundary=boundary)


def bits(*, contacts: bool, count: int) -> tuple[str, bd.Model, object]:
    """A hash of all that a run on `count` threads leaves."""
    model = crooked(contacts=contacts)
    rest = bd.solve_explicit(model, duration=0.0, every=0)  # chooses the step, and gives a state to set in motion
    state, dt = rest.state, rest.dt
    speed = 5.0 if contacts else 0.5
    state.set_motion(velocity=np.random.default_rng(7).uniform(-speed, speed, (len(model.lattice.particles), 3)))
    gauges = {"turned": bd.Gauge(bd.Everything(), "rotation")}
    if not contacts:  # nothing is held or loaded there
        gauges["force"] = bd.Gauge(bd.Everything(), "force", "sum")
    with threads(count):
        run = bd.solve_explicit(model, duration=STEPS * dt, dt=dt, every=20, state=state, gauges=gauges)
    assert run.steps == STEPS, run.message
    found = b"".join(getattr(run.state, name).tobytes() for name in run.state.ARRAYS) + run.history.records.tobytes()
    return hashlib.sha256(found).hexdigest(), model, run.state


CODE = """
from tests.dynamics.test_blocks import ON, bits

for contacts in (False, True):
    print(*(bits(contacts=contacts, count=count)[0] for count in ON))
"""


@pytest.mark.validate
def test_blocks_and_domains_change_no_bit() -> None:
    """Elastic, and with contacts, on 1, 2 and 3 threads; in a process of its own, which may have that many."""
    assert np.prod(EDGES) > 2 * BONDS_OF_PORTION
    lines = python(CODE, threads=max(ON))
    elastic, contacts = (line.split() for line in lines)
    assert len(elastic) == len(contacts) == len(ON)
    assert len(set(elastic)) == 1
    assert len(set(contacts)) == 1
    assert elastic[0] != contacts[0]


@pytest.mark.parametrize("contacts", [False, True])
def test_those_runs_have_something_to_disagree_on(contacts: bool) -> None:
    """Bonds work, and where there are contacts, many elements touch."""
    _, model, state = bits(contacts=contacts, count=1)
    assert len(model.lattice.pairs) > 1.6 * len(model.lattice.particles)
    assert np.abs(state.displacement).max() > 0.1 * model.lattice.particles.mean_radius
    assert (len(state.touching) > 300) == contacts
