"""Facets that soften: one energy and its exact gradient, a fracture energy that is given back, cracks that close."""

import functools
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import bondem as bd
from bondem._tables.columns import CrackStatus, PlasticColumn
from bondem.damage.crack_columns import FACET, LEFT, SLIP, STATUS
from bondem.damage.crack_rows import axes_along, crack_rows, isotropic_left
from bondem.dynamics.core_loop import CoreLoop
from bondem.errors import InputError
from tests.bits import assert_same_fracture, most_threads, threads
from tests.models import slowly_torn, torn_then_pressed
from tests.specimens import bar, cube, cubes, spheres, two_cubes

E, RHO = 40e9, 2500.0
STRENGTH, ENERGY = 4e6, 50.0
SOFT = bd.Rankine(tension=STRENGTH, fracture_energy=ENERGY)
ELASTIC = ("normal", "shear", "bending", "twisting")


def model_of(lattice: bd.Lattice, nu: float, failure: bd.Criterion = SOFT, boundary=()) -> bd.Model:
    law = bd.CellBond(E=E, nu=nu, facet_rotation="full")
    return bd.Model(lattice, law, density=RHO, failure=failure, boundary=boundary)


def cracked(model: bd.Model, integrity: dict[int, float]) -> bd.State:
    """A state with cracks of given integrity, by the kernels' number of their facet."""
    state = model.state()
    facet, s = np.array(list(integrity)), np.array(list(integrity.values()))
    axes = axes_along(model.cell_law.constants.normal[facet])
    state.cracks = crack_rows(facet, STRENGTH, axes, isotropic_left(s), np.ones(len(facet), dtype=bool))
    state.integrity[facet] = s
    return state


def oblique(model: bd.Model, facet: np.ndarray, left: np.ndarray) -> bd.State:
    """A state with cracks of the material of given integrities and grip (c, 4), along axes that are at random."""
    state = model.state()
    axes = Rotation.random(len(facet), random_state=3).as_matrix() * [[[1.0], [1.0], [-1.0]]]
    state.cracks = crack_rows(facet, STRENGTH, axes, left, np.zeros(len(facet), dtype=bool))
    state.integrity[facet] = left[:, :3].min(axis=1)
    return state


def look(model: bd.Model, state: bd.State) -> tuple[float, np.ndarray, np.ndarray]:
    """Elastic energy [J], and forces and torques [N, N·m], kernels' order."""
    state = state.copy()
    state.stale = True
    dt = 1e-9
    plan = bd.Plan(duration=1.0, dt=dt, every=1)
    record = bd.History(CoreLoop(model, plan, state, dt).record_present())
    energy = sum(float(record.energy[part][0]) for part in ELASTIC)
    force = state.acceleration[:, :3] / state.motion[:, 3:4]
    torque = state.acceleration[:, 3:] / state.motion[:, 7:8]
    return energy, force, torque


def turned(q: np.ndarray, vector: np.ndarray) -> np.ndarray:
    """Quaternions turned by rotation vectors [rad] in space."""
    angle = np.linalg.norm(vector, axis=1, keepdims=True)
    axis = vector / np.where(angle > 0.0, angle, 1.0)
    w, v = np.cos(0.5 * angle), np.sin(0.5 * angle) * axis
    p, u = q[:, :1], q[:, 1:]
    return np.hstack([w * p - (v * u).sum(axis=1, keepdims=True), w * u + p * v + np.cross(v, u)])


@pytest.mark.parametrize("nu", [-0.2, 0.0, 0.2, 0.45])
@pytest.mark.parametrize("alike", [True, False], ids=["planes", "material"])
@pytest.mark.parametrize(("mean", "turn"), [(-2e-3, 1e-4), (2e-3, 1e-4), (-0.03, 0.1)])
def test_forces_are_the_gradient_of_one_energy(nu: float, mean: float, turn: float, alike: bool) -> None:
    """With open, closed and half-broken facets, at large rotations; forces and torques sum to nothing.

    In the last case cells are turned against each other, so that the faces of closed cracks are far from parallel.
    """
    rng = np.random.default_rng(5)
    model = model_of(bar(60), nu)
    m, n = len(model.lattice.pairs), 60
    some = rng.choice(m, size=m // 2, replace=False)
    if alike:
        state = cracked(model, dict(zip(some.tolist(), rng.choice([0.0, 0.3, 0.9], len(some)).tolist(), strict=True)))
    else:
        left = np.sort(rng.choice([0.0, 0.3, 0.9, 1.0], (len(some), 3)), axis=1)
        state = oblique(model, some, np.column_stack([left, rng.choice([0.0, 0.5, 1.0], len(some))]))
    moved = state.pose[:, :3] * (1.0 + mean) + 5e-7 * rng.standard_normal((n, 3))
    far = np.tile([0.3, -0.2, 0.5], (n, 1))
    q = turned(np.tile([1.0, 0.0, 0.0, 0.0], (n, 1)), far)
    R = turned_matrix(q[0])
    state.pose[:, :3] = moved @ R.T
    state.pose[:, 4:] = turned(q, turn * rng.standard_normal((n, 3)))
    _, force, torque = look(model, state)
    scale = np.abs(force).max()
    assert np.abs(force.sum(axis=0)).max() < 1e-11 * scale * n
    moment = (np.cross(state.pose[:, :3], force) + torque).sum(axis=0)
    assert np.abs(moment).max() < 1e-11 * scale * 16e-3 * n
    # friction has slipped where cracks press: what is left is elastic only where it bears nothing
    for _ in range(4):
        dx, dr = 1e-10 * rng.standard_normal((n, 3)), 1e-7 * rng.standard_normal((n, 3))
        ends = []
        for sign in (-1.0, 1.0):
            other = state.copy()
            other.pose[:, :3] += sign * dx
            other.pose[:, 4:] = turned(state.pose[:, 4:], sign * dr)
            ends.append(look(model, other)[0])
        work = float((force * dx).sum() + (torque * dr).sum())
        size = float(np.abs(force * dx).sum() + np.abs(torque * dr).sum())
        assert 0.5 * (ends[0] - ends[1]) == pytest.approx(work, abs=3e-6 * size)


def turned_matrix(q: np.ndarray) -> np.ndarray:
    """Rotation matrix of a quaternion."""
    w, x, y, z = q
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ])  # fmt: skip


@pytest.mark.parametrize("nu", [0.0, 0.2, 0.4])
def test_a_closed_crack_bears_pressure_as_whole_material_does(nu: float) -> None:
    """All facets broken, and pressed from all sides or along one: forces as if nothing were broken."""
    lattice = cubes((4, 3, 3), 1e-3)
    model = model_of(lattice, nu)
    broken = cracked(model, dict.fromkeys(range(len(lattice.pairs)), 0.0))
    whole = model.state()
    for strain in (np.diag([-1e-4, -1e-4, -1e-4]), np.diag([-1e-4, 0.0, 0.0])):
        poses = whole.pose[:, :3] + whole.pose[:, :3] @ strain
        for state in (broken, whole):
            state.pose[:, :3] = poses
        one, force, _ = look(model, broken)
        other, wanted, _ = look(model, whole)
        assert np.abs(force - wanted).max() < 1e-9 * np.abs(wanted).max()
        assert one == pytest.approx(other, rel=1e-9)
    whole.pose[:, :3] = broken.pose[:, :3] = poses + 2.0 * (poses - whole.rest) * -1.0  # pulled
    assert np.abs(look(model, broken)[1]).max() < 1e-6 * np.abs(look(model, whole)[1]).max()


def test_two_cells_soften_along_a_straight_line_and_give_back_their_energy(one_thread: None) -> None:
    """One facet between two cubes, ν = 0: traction falls linearly to nothing at 2 G_f / f_t; the work is G_f A."""
    size = 10e-3
    lattice = two_cubes(size)
    opening = 2.0 * ENERGY / STRENGTH
    speed, rise = 0.004, 2e-4
    ends = ("x_min", -0.5 * speed), ("x_max", 0.5 * speed)
    pull = [bd.Drive(bd.Face(face), vx=bd.Ramp(0.0, end, rise)) for face, end in ends]
    model = model_of(lattice, 0.0, boundary=pull)
    run = bd.solve_explicit(
        model, duration=1.2 * opening / speed, dt=5e-7, every=2, damping=bd.MassDamping(alpha=2e4),
        gauges={"pull": bd.Gauge(bd.Face("x_max"), "force")},
    )  # fmt: skip
    traction = run.history["pull"][:, 0] / size**2
    moved = speed * np.maximum(run.history.time - 0.5 * rise, 0.0)
    assert traction.max() == pytest.approx(STRENGTH, rel=5e-3)
    # cells give way by f L / E beside the crack
    crack = moved - traction * 2.0 * size / E
    falling = (crack > 0.02 * opening) & (crack < 0.9 * opening)
    np.testing.assert_allclose(traction[falling], STRENGTH * (1.0 - crack[falling] / opening), atol=0.01 * STRENGTH)
    assert run.history.released[-1] == pytest.approx(ENERGY * size**2, rel=2e-3)
    assert run.events.energy.sum() == pytest.approx(run.history.released[-1], rel=1e-12)
    assert list(run.events.mode) == ["tension"]
    assert run.residual < 1e-5


def test_a_hinge_cracks_and_gives_back_its_energy(one_thread: None) -> None:
    """Two cubes turned against each other: it begins at f_t = E ρ / √12, and takes G_f A, as in tension."""
    size = 10e-3
    lattice = two_cubes(size)
    last = 2.0 * ENERGY / STRENGTH * np.sqrt(12.0) / size
    speed, rise = 1.2, 2e-4
    rates = {"vy": 0.25 * size * speed, "vz": 0.0, "wx": 0.0, "wy": 0.0}
    turns = [
        bd.Drive(bd.Index([p]), wz=bd.Ramp(0.0, sign * 0.5 * speed, rise), **{
            name: bd.Ramp(0.0, rate, rise) for name, rate in rates.items()
        })
        for p, sign in ((0, -1.0), (1, 1.0))
    ]  # fmt: skip
    run = bd.solve_explicit(
        model_of(lattice, 0.0, boundary=turns), duration=1.2 * last / speed, dt=5e-7, every=2,
        damping=bd.MassDamping(alpha=2e4),
    )  # fmt: skip
    turned = speed * np.maximum(run.history.time - 0.5 * rise, 0.0)
    begins = turned[np.flatnonzero(run.history.released > 0.0)[0]]
    assert begins == pytest.approx(np.sqrt(12.0) * STRENGTH / E, rel=0.02)
    assert run.history.released[-1] == pytest.approx(ENERGY * size**2, rel=5e-3)
    assert list(run.events.mode) == ["tension"]
    assert run.residual < 1e-4


def test_cracks_that_are_wide_open_rest() -> None:
    """Nothing is left of the crack from 25 µm on; it lets go of what acts along it below a tenth of a cell."""
    model, dt = slowly_torn(SOFT)
    state = bd.solve_explicit(model, duration=30e-6 / 0.1, dt=dt, every=0).state
    broken = state.cracks[:, LEFT] == 0.0
    assert broken.sum() > 20
    assert not (state.cracks[broken, STATUS] == CrackStatus.RESTING).any()
    state = bd.solve_explicit(model, duration=300e-6 / 0.1, dt=dt, every=0, state=state).state
    assert (state.cracks[broken, LEFT + 3] == 0.0).mean() > 0.9
    assert (state.cracks[broken, STATUS] == CrackStatus.RESTING).mean() > 0.9


@functools.cache
def torn(share: float = 0.9, energy: float | None = ENERGY) -> bd.ExplicitResult:
    """A bar that is pulled apart, slowly enough for its crack; without a fracture energy it breaks at once."""
    model, dt = slowly_torn(bd.Rankine(tension=STRENGTH, fracture_energy=energy), share)
    far = STRENGTH / E * 16e-3 + (1.2 * 2.0 * energy / STRENGTH if energy else 1e-6)
    return bd.solve_explicit(model, duration=far / 0.1, dt=dt, every=50)


def test_a_bar_gives_back_its_fracture_energy() -> None:
    """Work to tear it apart, over its section: within 3 % of what was put in, where few cracks begin beside it."""
    model, dt = slowly_torn(SOFT, speed=0.03)
    run = bd.solve_explicit(model, duration=(STRENGTH / E * 16e-3 + 2.4 * ENERGY / STRENGTH) / 0.03, dt=dt, every=100)
    assert run.history.energy["work"][-1] / 64e-6 == pytest.approx(ENERGY, rel=0.03)
    assert len(bd.fragments(model.lattice, run.state)) >= 2


@pytest.mark.parametrize(("energy", "closes"), [(ENERGY, 2e-4), (None, 1e-3)], ids=["softening", "at once"])
def test_the_ledger_closes_and_is_of_second_order(energy: float | None, closes: float) -> None:
    coarse, fine = torn(0.9, energy), torn(0.225, energy)
    assert len(coarse.events) > 20
    assert coarse.residual < closes
    # what breaks at once falls by a bounded share in a step, whatever its size: first order
    assert fine.residual < (0.35**2 if energy else 0.5) * coarse.residual


#: Cracks open, close and rub, and cells yield.
MIXED = bd.MohrCoulomb(
    tension=2e6, cohesion=4e6, friction_angle=0.6, fracture_energy=2.0, scatter=bd.Weibull(modulus=8.0, volume=1e-9),
)  # fmt: skip


def impact(model: bd.Model, steps: int, dt: float, state: bd.State | None = None, **options) -> bd.ExplicitResult:
    return bd.solve_explicit(model, duration=steps * dt, dt=dt, every=0, state=state, **options)


@pytest.mark.validate
def test_bits_do_not_depend_on_threads_pauses_or_restarts(tmp_path: Path) -> None:
    model, dt = torn_then_pressed(MIXED)
    steps = 240
    with threads(1):
        one = impact(model, steps, dt).state
    assert len(one.cracks) > 500
    assert len(one.broken) > 20
    assert (one.plastic[:, PlasticColumn.GAMMA] > 0.0).sum() > 20
    for count in (2, 4):
        if count <= most_threads():
            with threads(count):
                other = impact(model, steps, dt).state
            assert_same_fracture(one, other)
    paused = bd.solve_explicit(model, duration=steps * dt, dt=dt, every=7).state
    assert_same_fracture(one, paused)
    kept = tmp_path / "run.h5"
    seen = []

    def stop(state: bd.State, _: bd.History) -> bool:
        seen.append(state.step)
        return state.step >= 150

    bd.solve_explicit(model, duration=steps * dt, dt=dt, every=50, save_every=50, out=kept, callback=stop)
    again = bd.resume(kept).state
    assert seen[-1] == 150
    assert again.step == steps
    assert_same_fracture(one, again)


def test_the_first_record_of_a_run_that_goes_on_has_all_that_cells_dissipated() -> None:
    """The last increment of strain is booked by half when it comes, and by half with the stress a step later."""
    model, dt = torn_then_pressed(MIXED)
    start = impact(model, 150, dt).state
    went_on = bd.solve_explicit(model, duration=10 * dt, dt=dt, every=1, state=start).history.energy
    increment = np.diff(went_on["plastic"])
    assert increment.min() > 0.0
    assert went_on["plastic"][0] == pytest.approx(0.5 * increment[0], rel=0.2)


@pytest.mark.parametrize("pressure", [1e6, 6e6])
def test_a_pressed_facet_cracks_by_its_own_shear(pressure: float) -> None:
    """σ_zz of the strength everywhere: facets across x, under (-p, τ), crack from τ² = f_t (f_t + p) on."""
    model = model_of(cubes((3, 3, 3), 1e-3), 0.0)
    lattice, least = model.lattice, np.sqrt(STRENGTH * (STRENGTH + pressure))
    assert lattice.facets is not None
    across = (np.abs(lattice.facets.normal[:, 0]) > 0.5) & (lattice.pairs == 13).any(axis=1)  # of the cell amidst
    for shear, begins in ((0.98 * least, 0), (1.02 * least, 2)):
        stress = np.array([[-pressure, shear, 0.0], [shear, 0.0, 0.0], [0.0, 0.0, 1.02 * STRENGTH]])
        state = model.state()
        state.set_pose(position=lattice.centre @ (np.eye(3) + stress / E))
        run = bd.solve_explicit(model, duration=2e-10, dt=1e-10, state=state)
        facet = model.layout.bond_order[run.state.cracks[:, FACET].astype(int)]
        assert across[facet].sum() == begins
        assert len(facet) > 0


def test_friction_holds_a_closed_crack_until_it_slips() -> None:
    """Two cubes, their facet broken and pressed: it bears shear up to μ times the pressure."""
    size, pressed, across = 1e-3, 1e-8, 2e-8
    lattice = two_cubes(size)
    for friction in (0.0, 0.3, 5.0):
        model = model_of(lattice, 0.0, bd.Rankine(tension=STRENGTH, fracture_energy=ENERGY, friction=friction))
        state = cracked(model, {0: 0.0})
        state.pose[1, :3] += [-pressed, across, 0.0]
        _, force, _ = look(model, state)
        k = E * size  # 2 G A / L
        assert force[0, 0] == pytest.approx(-k * pressed, rel=1e-6)
        assert force[0, 1] == pytest.approx(min(k * across, friction * k * pressed), rel=1e-6)
    state.cracks[0, SLIP : SLIP + 3] = [0.0, across, 0.0]  # it has slipped that far: nothing is stretched
    assert abs(look(model, state)[1][0, 1]) < 1e-9 * E * size * across


def test_long_elements_are_refused_with_the_length_that_would_do() -> None:
    brittle = bd.Rankine(tension=20e6, fracture_energy=3.0)
    with pytest.raises(InputError, match=r"snap back above 2 E G_f / f_t² = 0\.0006 m"):
        bd.Model(bar(250), bd.CellBond(E=E, nu=0.2), density=RHO, failure=brittle)


def test_softening_is_for_bodies_of_cells() -> None:
    lattice = spheres(bd.Box((4e-3, 4e-3, 4e-3)), 300)
    with pytest.raises(InputError, match=r"use bd\.CellBond"):
        bd.Model(lattice, bd.EulerBernoulli(E=1e9, nu=0.3, radius_ratio=0.7), density=RHO, failure=SOFT)


def test_a_closed_crack_slides_under_friction_as_far_as_it_is_driven() -> None:
    """A cube torn, pressed by f_t and slid by two last openings: it bears μ p, and that is friction, no fracture."""
    edge, last, friction = 16e-3, 2.0 * ENERGY / STRENGTH, 0.5
    press, time = STRENGTH / E * edge, np.array([0.0, 2.0, 4.0, 10.0]) * 1e-4
    x = bd.Table(time, np.array([0.0, 1.2 * last, -press, -press]))
    y = bd.Table(time, np.array([0.0, 0.0, 0.0, 2.0 * last]))
    ends = [bd.Fix(bd.Face("x_min"), translation="xy"), bd.Drive(bd.Face("x_max"), x=x, y=y)]
    failure = bd.Rankine(tension=STRENGTH, fracture_energy=ENERGY, friction=friction)
    model = bd.Model(cube(60, edge), bd.CellBond(E=E, nu=0.2), density=RHO, failure=failure, boundary=ends)
    run = bd.solve_explicit(
        model, duration=time[-1], damping=bd.MassDamping(alpha=1e5), every=10,
        gauges={"far": bd.Gauge(bd.Face("x_max"), "force")},
    )  # fmt: skip
    record = run.history
    late = record.time > 8e-4  # after a slide of 4/3 of the last opening
    normal, shear = record["far"][late, 0].mean(), record["far"][late, 1].mean()
    assert shear == pytest.approx(-friction * normal, rel=0.1)
    spent = {kind: float(np.ptp(record.energy[kind][late])) for kind in ("friction", "loss", "fracture", "crushing")}
    # damping takes 4 % of the work of the slide
    assert spent["friction"] == pytest.approx(shear * 2.0 / 3.0 * last - spent["loss"], rel=0.1)
    assert spent["fracture"] + spent["crushing"] < 0.1 * spent["friction"]
