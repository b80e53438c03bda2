"""Pieces that touch: bonds that break under pressure hand it to a contact, with a ledger that closes, bit by bit."""

import math
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from tests.models import momenta, moving, time_step
from tests.scripts import python
from tests.specimens import NO_BONDS, crooked_block

R, L, RADIUS = 0.5e-3, 1.05e-3, 0.35e-3
E, NU = 1e9, 0.3
KN = E * math.pi * RADIUS**2 / L
LAW = bd.EulerBernoulli(E=E, nu=NU, radius=RADIUS)
VERLET = bd.VelocityVerlet()
PERIODIC = (6e-3, 6e-3, 6e-3)
CONTACTS = {
    "linear": bd.LinearContact(E=3e8, friction=0.4),
    "stiff": bd.LinearContact(E=5e9, friction=0.4),
    "Hertzian": bd.HertzMindlin(E=1e9, nu=0.2, friction=0.4),
}


def pressed(contact: bd.ContactLaw, *, failure: bd.Criterion | None = None, period=None) -> bd.Model:
    """Two spheres a little apart, bonded, pressed together, then sheared until the bond breaks."""
    position = np.array([[0.0, 0.0, 0.0], [L, 0.0, 0.0]])
    if period is not None:
        position = np.array([[period[0] - 0.5 * L, 1e-3, 1e-3], [0.5 * L, 1e-3, 1e-3]])
    lattice = bd.Lattice(bd.Particles(position, R, period=period), [[0, 1]])
    drive = bd.Drive(
        bd.Index([1]), x=bd.Ramp(0.0, -2e-3 * L, 1e-4), y=bd.Ramp(0.0, 1e-2 * L, 2e-4, begin=1e-4),
        rx=0.0, ry=0.0, rz=0.0,
    )  # fmt: skip
    return bd.Model(
        lattice, LAW, density=1000.0, failure=failure, contact=contact, boundary=[bd.Fix(bd.Index([0])), drive]
    )


SHEARED = bd.PeripheralStress(tension=1e30, shear=1e6)


@pytest.mark.parametrize(("contact", "period"), [
    pytest.param("linear", None, id="linear-free"),
    pytest.param("stiff", PERIODIC, id="stiff-periodic"),
    pytest.param("Hertzian", None, id="Hertzian-free"),
    pytest.param("linear", PERIODIC, id="linear-periodic", marks=pytest.mark.validate),
    pytest.param("stiff", None, id="stiff-free", marks=pytest.mark.validate),
    pytest.param("Hertzian", PERIODIC, id="Hertzian-periodic", marks=pytest.mark.validate),
])  # fmt: skip
def test_the_normal_force_goes_on_where_a_pressed_bond_breaks(contact: str, period, one_thread: None) -> None:
    """It is kn (L - l) before, at and after breakage, along the branch; the shear force is gone at once."""
    law = CONTACTS[contact]
    model = pressed(law, failure=SHEARED, period=period)
    dt = time_step(model, 0.2)
    gauges = {"grip": bd.Gauge(bd.Index([0]), "force", "sum")}
    run = bd.solve_explicit(model, duration=3e-4, dt=dt, every=1, gauges=gauges)
    assert len(run.events) == 1
    step = int(run.events.step[0])
    moved = np.stack([bd.Ramp(0.0, -2e-3 * L, 1e-4).at(t) for t in run.history.time])
    slid = np.stack([bd.Ramp(0.0, 1e-2 * L, 2e-4, begin=1e-4).at(t) for t in run.history.time])
    branch = np.column_stack([L + moved, slid, 0.0 * slid])
    length = np.linalg.norm(branch, axis=1)
    axis = branch / length[:, None]
    # the grip holds the first sphere against what pushes it away
    normal = np.einsum("tk,tk->t", run.history["grip"], axis)
    np.testing.assert_allclose(normal[1:], KN * (L - length[1:]), rtol=1e-9, atol=1e-9 * KN * L * 2e-3)
    across = np.linalg.norm(run.history["grip"] - normal[:, None] * axis, axis=1)
    assert across[step - 1] > 0.05 * normal[step]
    assert across[step] < 1e-3 * across[step - 1]
    # sheared on, friction holds as the spring does that starts with nothing
    soft = law.parameters[1]
    slip = slid[step + 20] - slid[step]
    assert across[step + 20] == pytest.approx(soft * KN * slip, rel=0.05)
    assert (across <= law.friction * normal * (1 + 1e-9))[step:].all()
    # what the contact took over is not released
    energy = run.history.energy
    assert energy["contact"][step] == pytest.approx(0.5 * KN * (L - length[step]) ** 2, rel=1e-9)
    assert energy["contact"][step - 1] == 0.0
    sideways = energy["shear"][step - 1] + energy["bending"][step - 1]
    assert run.events.energy[0] == pytest.approx(sideways, rel=0.05)
    assert run.residual < 1e-3


def test_measured_from_the_spheres_a_gap_stays_open(one_thread: None) -> None:
    """Without `stress_free` a broken pair is a pair as any other: here its spheres are apart."""
    law = bd.LinearContact(E=1e9, stress_free=False)
    run = bd.solve_explicit(pressed(law, failure=SHEARED), duration=3e-4, every=1)
    assert len(run.events) == 1
    assert len(run.state.contacts) == 0
    energy = run.history.energy
    assert energy["contact"].max() == 0.0
    assert energy["fracture"][-1] > 0.5 * KN * (2e-3 * L) ** 2


def block(count: int, failure: bd.Criterion | None, contact: bd.ContactLaw | None, boundary=()) -> bd.Model:
    """Block of count³ elements that nearly touch, off a grid; crushed, its pieces rub."""
    rng = np.random.default_rng(1)
    grid = np.indices((count, count, count)).reshape(3, -1).T.astype(float)
    particles = bd.Particles(grid + rng.uniform(-0.1, 0.1, grid.shape), rng.uniform(0.4, 0.5, len(grid)))
    lattice, law = bd.connect(particles, reach=1.5), bd.Timoshenko(E=1e7, nu=0.2, radius_ratio=0.6)
    return bd.Model(lattice, law, density=1000.0, failure=failure, contact=contact, boundary=boundary)


WEAK = bd.PeripheralStress(tension=2e5, shear=3e5, scatter=bd.Weibull(modulus=5.0, volume=0.1))


def crushing(time: float) -> tuple[bd.Fix, bd.Drive]:
    """Pressed along x and sheared along y."""
    ends = bd.Face("x_min", depth=0.5), bd.Face("x_max", depth=0.5)
    return bd.Fix(ends[0]), bd.Drive(ends[1], vx=bd.Ramp(0.0, -6.0, time), vy=bd.Ramp(0.0, 3.0, time))


@pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")  # crushed far
@pytest.mark.parametrize(
    "contact",
    [
        bd.LinearContact(E=1e7, friction=0.5, damping=0.05),
        bd.HertzMindlin(E=1e7, nu=0.2, friction=0.5, restitution=0.9, overlap=0.1),
    ],
    ids=["linear", "Hertzian"],
)
def test_the_ledger_is_second_order_through_crushing(contact: bd.ContactLaw, one_thread: None) -> None:
    """Halving the step quarters what the ledger misses, through a hundred breaks and the friction after them."""
    model = block(5, WEAK, contact=contact, boundary=crushing(0.02))
    dt = time_step(model, 0.4)
    steps, missed = round(0.08 / dt), []
    for halvings in range(4):
        count = 2**halvings
        run = bd.solve_explicit(model, duration=steps * dt, dt=dt / count, every=count)
        energy = run.history.energy
        assert len(run.events) > 100
        assert len(run.state.contacts) > 50
        turned = energy["work"][-1]
        assert energy["friction"][-1] > 0.02 * turned
        assert energy["fracture"][-1] == pytest.approx(run.events.energy.sum(), rel=1e-12)
        assert (run.events.energy > 0.0).all()
        missed.append(float(np.sqrt((energy["balance"] ** 2).mean())) / turned)
    assert missed[-1] < 1e-4
    assert np.log2(missed[0] / missed[-1]) / 3.0 > 1.8


@pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")  # soft grains at high speed
def test_momentum_is_kept_where_pieces_touch(one_thread: None) -> None:
    model = block(5, WEAK, contact=bd.LinearContact(E=1e7, friction=0.5, damping=0.05))
    inwards = 2.0 - model.lattice.centre
    state = moving(model, 8.0 * inwards + np.cross((0.0, 0.0, 5.0), inwards))
    dt = time_step(model, 0.3)
    scale = np.abs(model.mass[:, None] * state.velocity).sum() * 5.0
    run = bd.solve_explicit(model, duration=800 * dt, dt=dt, every=10, state=state)
    assert len(run.events) > 100
    assert run.history.energy["friction"][-1] > 0.01 * run.history.energy["translation"][0]
    change = np.subtract(momenta(model, run.state), momenta(model, state))
    assert np.abs(change).max() < 1e-13 * scale


# --- weak bonds and none ----------------------------------------------------------------------------------------


def heap(*, bonded: bool, failure: bd.Criterion | None = None, E: float = 1e7) -> tuple[bd.Model, bd.State]:
    """Grains on a crooked grid that do not overlap, thrown together; with bonds between neighbours or without."""
    rng = np.random.default_rng(2)
    grid = np.indices((4, 4, 4)).reshape(3, -1).T
    block = crooked_block((4, 4, 4), jitter=0.05, radius=(0.4, 0.44), reach=1.35, seed=2)
    lattice = block if bonded else bd.Lattice(block.particles, NO_BONDS)
    contact = bd.LinearContact(E=1e7, friction=0.4, damping=0.05, stress_free=False)
    law = bd.EulerBernoulli(E=E, nu=0.2, radius=0.3) if bonded else None
    model = bd.Model(lattice, law, density=1000.0, contact=contact, failure=failure)
    return model, moving(model, 3.0 * (1.5 - grid) + rng.normal(size=grid.shape))


def test_a_broken_bond_is_no_bond_to_the_bit() -> None:
    loose, thrown = heap(bonded=False)
    dt = time_step(loose, 0.1)
    plain = bd.solve_explicit(loose, duration=600 * dt, dt=dt, every=10, state=thrown)
    assert len(plain.state.contacts) > 30
    for failure in (None, WEAK):
        model, state = heap(bonded=True, failure=failure)
        state.integrity[:] = 0.0
        run = bd.solve_explicit(model, duration=600 * dt, dt=dt, every=10, state=state)
        for name in ("position", "velocity", "angular_velocity", "contacts"):
            np.testing.assert_array_equal(getattr(plain.state, name), getattr(run.state, name), err_msg=name)
        np.testing.assert_array_equal(plain.history.energy["friction"], run.history.energy["friction"])


def test_a_bond_without_strength_bears_for_one_step() -> None:
    """It is judged by what it bears, so it bears once: the impulse of one step falls with its square."""
    off = []
    loose, thrown = heap(bonded=False)
    coarse = time_step(loose, 0.1)
    for dt in (coarse, 0.5 * coarse, 0.25 * coarse):
        steps = round(20 * coarse / dt)
        plain = bd.solve_explicit(loose, duration=steps * dt, dt=dt, state=thrown)
        model, state = heap(bonded=True, failure=bd.PeripheralStress(tension=1e-6, shear=1e-6, beta=1.0))
        run = bd.solve_explicit(model, duration=steps * dt, dt=dt, state=state)
        # bonds that are pressed alone are broken by no stress of this criterion
        assert (run.state.bond_integrity == 0.0).mean() > 0.95
        assert (run.events.step == 1).mean() > 0.95
        gone = run.state.bond_integrity == 0.0
        ends = np.unique(model.lattice.pairs[~gone])
        free = np.setdiff1d(np.arange(64), ends)
        off.append(np.abs(run.state.velocity - plain.state.velocity)[free].max())
    assert off[0] < 1e-2
    assert off[1] == pytest.approx(off[0] / 4.0, rel=0.1)
    assert off[2] == pytest.approx(off[1] / 4.0, rel=0.1)


# --- bits -------------------------------------------------------------------------------------------------------

MANY = """
import hashlib, sys
import numpy as np
from pathlib import Path
import bondem as bd
from bondem.dynamics import neighbour_list as lists
from tests.bits import threads
from tests.models import time_step
from tests.damage.test_breaking_contacts import block, crushing

failure = bd.PeripheralStress(tension=4e5, shear=6.4e5, scatter=bd.Weibull(modulus=5.0, volume=0.1))
contact = bd.LinearContact(E=1e7, friction=0.5, damping=0.05)
walls = [bd.PlaneWall((0, -0.6, 0), (0, 1, 0), friction=0.3)]
model = block(14, failure, contact=contact, boundary=crushing(0.01))
model = bd.Model(model.lattice, model.bond, 1000.0, boundary=model.boundary, contact=contact, failure=failure,
                 walls=walls)
damping = bd.LocalDamping(0.02)
dt = time_step(model, 0.5, damping)
state = model.state()
state.set_motion(velocity=2.0 * (6.5 - model.lattice.particles.position))


def bits(state):
    kept = b"".join(getattr(state, name).tobytes() for name in bd.State.ARRAYS)
    return hashlib.sha256(kept).hexdigest()


def run(count, every, **options):
    with threads(count):
        return bd.solve_explicit(
            model, duration=720 * dt, dt=dt, every=every, damping=damping, state=state.copy(), **options
        )


class EnoughError(Exception):
    pass


def stop(share):
    if share > 0.6:
        raise EnoughError


for count, every in ((1, 100), (2, 7), (4, 1), (2, 0)):
    done = run(count, every)
    print(bits(done.state), len(done.events), len(done.state.contacts))
lists._SKIN_LEAST = 0.3
done = run(2, 50)
print(bits(done.state), len(done.events), len(done.state.contacts))
place = Path(sys.argv[1]) / "run.h5"
try:
    run(2, 100, save_every=31, out=place, progress=stop)
except EnoughError:
    pass
found = bd.read_run(place).state
assert 0 < len(found.broken) < len(done.events)
assert len(found.touching) > 100
resumed = bd.resume(place)
assert len(resumed.state.touching) > 1000  # so threads share them
print(bits(resumed.state), len(resumed.events), len(resumed.state.contacts))
"""


@pytest.mark.validate
def test_same_bits_after_thousands_of_breaks_with_contact(tmp_path: Path) -> None:
    """On 1, 2 and 4 threads, recorded often or never, with another list, saved and resumed; in its own process."""
    lines = python(MANY, tmp_path)
    assert len(lines) == 6
    assert len(set(lines)) == 1, lines
    _, broken, touching = lines[0].split()
    assert int(broken) > 2000
    assert int(touching) > 1000


# --- what cannot be ---------------------------------------------------------------------------------------------


def test_the_step_is_made_for_friction_between_what_was_bonded() -> None:
    """Shear springs of contacts may be stiffer than slender bonds: the step counts whichever is."""
    slender = bd.EulerBernoulli(E=1e7, nu=0.2, radius=0.1)

    def limit(contact: bd.ContactLaw | None, failure: bd.Criterion | None) -> float:
        model = block(4, failure, contact=contact)
        return time_step(bd.Model(model.lattice, slender, 1000.0, contact=contact, failure=failure), 1.0)

    soft = bd.LinearContact(E=1.0, friction=0.5, kappa=0.5)
    assert limit(soft, WEAK) < 0.7 * limit(soft, None)
    assert limit(bd.LinearContact(E=1.0), WEAK) == pytest.approx(limit(None, WEAK), rel=1e-3)


def test_what_cannot_be_is_refused_in_a_line() -> None:
    contact = bd.LinearContact(E=1e7)
    with pytest.raises(InputError, match="Eigenstrain") as refused:
        block(3, WEAK, contact=contact, boundary=[bd.Eigenstrain(1e-4)])
    assert "\n" not in str(refused.value)
