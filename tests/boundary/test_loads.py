"""Body forces, pressure, absorbing boundaries and stress-free strain against closed forms."""

import math
import runpy
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem._tables.columns import BONDS_OF_PORTION
from bondem.dynamics.explicit import integrate
from bondem.errors import InputError
from bondem.geometry.face_patches import face_patches
from tests.bits import assert_same_bits, assert_same_run, need_two_threads, threads
from tests.models import time_step, total_energy
from tests.recording import Record
from tests.specimens import NO_BONDS, crooked_block, rod, spheres

LAW = bd.EulerBernoulli(E=2.0e9, nu=0.25, radius_ratio=0.6)
RHO = 1500.0
CYLINDER = bd.Cylinder(radius=5e-3, length=30e-3)
pytestmark = pytest.mark.usefixtures("one_thread")


# ---- body forces


def test_loose_elements_fall_as_galilei_says() -> None:
    particles = bd.Particles([[0.0, 0, 0], [1.0, 0, 0], [0.0, 5, 0]], [0.5, 0.5, 0.4])
    # the third element is a rattler, and region by shape: the force acts on it all the same
    gravity = bd.BodyForce((0.0, 0.0, -9.81))
    side = bd.BodyForce((2.0, 0.0, 0.0), region=bd.Index([0, 1]), schedule=bd.Table((0.0, 0.5, 0.5), (1.0, 1.0, 0.0)))
    model = bd.Model(bd.Lattice(particles, [(0, 1)]), LAW, density=RHO, boundary=[gravity, side])
    dt = 2.0**-14
    assert dt < time_step(model, 1.0)
    run = integrate(model, bd.Plan(duration=1.0, dt=dt, every=2**10))
    moved = run.state.displacement
    np.testing.assert_allclose(moved[:, 2], -0.5 * 9.81, rtol=1e-12)
    np.testing.assert_allclose(moved[:, 0], [0.75, 0.75, 0.0], rtol=2 * dt)
    energy = run.history.energy
    kinetic = 0.5 * float((model.mass * (run.state.velocity**2).sum(axis=1)).sum())
    assert energy["work"][-1] == pytest.approx(kinetic, rel=1e-3)
    assert energy["translation"][-1] > 1.0
    assert np.abs(energy["balance"]).max() < dt * energy["work"][-1]

    grains = bd.Model(bd.Lattice(particles, NO_BONDS), None, density=RHO, boundary=[gravity])
    fallen = integrate(grains, bd.Plan(duration=1.0, dt=0.01, every=0)).state
    np.testing.assert_allclose(fallen.displacement[:, 2], -0.5 * 9.81, rtol=1e-12)


def test_a_hanging_rod_stretches_under_its_weight() -> None:
    model = bd.Model(rod(8), LAW, RHO, boundary=[bd.Fix(bd.Index([0])), bd.BodyForce((9.81, 0.0, 0.0))])
    below = 9.81 * np.cumsum(model.mass[::-1])[::-1]
    expected = np.concatenate([[0.0], np.cumsum(below[1:] / model.stiffness.kn)])
    for nonlinear in (False, True):
        static = bd.solve_static(model, nonlinear=nonlinear)
        np.testing.assert_allclose(static.displacement[:, 0], expected, rtol=1e-6 if nonlinear else 1e-9)
        assert static.reaction[0, 0] == pytest.approx(-below[0], rel=1e-7)
    # left alone it swings about that; the grip bears the weight when it has come to rest
    omega = 2.0 * math.pi * bd.solve_modes(model, count=12, prestress=False).frequency[-1]
    gauges = {"grip": bd.Gauge(bd.Index([0]), "force", "sum")}
    run = bd.solve_explicit(model, duration=2000.0 / omega, damping=bd.MassDamping(0.05 * omega), gauges=gauges)
    np.testing.assert_allclose(run.state.displacement[:, 0], expected, rtol=1e-4, atol=1e-4 * expected[-1])
    assert run.history["grip"][-1, 0] == pytest.approx(-below[0], rel=1e-3)


# ---- faces in patches

_CORNERS = np.array([[0.0, 0, 0], [2, 0, 0], [0, 1.5, 0], [0, 0, 1]])
SHAPES = {
    "box": bd.Box((3.0, 2.0, 1.0)),
    "cylinder": bd.Cylinder(radius=1.0, length=3.0),
    "ball": bd.Ball(1.5),
    "surface": bd.Surface(vertices=_CORNERS, triangles=[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], unit="m"),
    "turned": bd.Cylinder(radius=1.0, length=3.0).rotated("z", 0.7).moved((1.0, 2.0, 3.0)),
    "cut": bd.Box((3.0, 2.0, 1.0)).cut(bd.Ball(0.6).moved((1.5, 1.0, 0.0)), name="pit"),
    "joined": bd.Box((3.0, 2.0, 1.0)) | bd.Box((2.0, 2.0, 1.0)).moved((2.0, 0.0, 0.0)),
    "overlap": bd.Ball(1.5) & bd.Box((3.0, 3.0, 3.0)),
}


@pytest.mark.parametrize("name", SHAPES)
def test_patches_of_all_faces_close_the_shape(name: str) -> None:
    # Gauss: ∫ n dA = 0 and ∫ x·n dA = 3 V
    shape = SHAPES[name]
    parts = [face_patches(shape, face, 0.05) for face in shape.faces]
    centre, area = (np.concatenate(arrays) for arrays in zip(*parts, strict=True))
    exact = name in ("box", "cylinder", "ball", "surface", "turned")
    tolerance = 2e-3 if exact else 0.02
    assert np.abs(area.sum(axis=0)).max() < (1e-12 if exact else tolerance) * shape.area
    assert (centre * area).sum() / 3.0 == pytest.approx(shape.volume, rel=tolerance)
    assert np.linalg.norm(area, axis=1).sum() == pytest.approx(shape.area, rel=tolerance)


def test_pressure_has_the_resultant_and_moment_of_its_face() -> None:
    cylinder = spheres(CYLINDER, 1500, spread=0.2, seed=4)
    area = math.pi * 25e-6
    x = cylinder.particles.position
    for region, force, anchor in (
        (bd.Face("x_max"), (-1e6 * area, 0.0, 0.0), (30e-3, 0.0, 0.0)),
        (bd.Face("side"), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)),
    ):
        chosen, nodal = bd.Pressure(region, 1e6).nodal(cylinder)
        np.testing.assert_allclose(nodal[:, :3].sum(axis=0), force, atol=1e-9 * 1e6 * area)
        moment = np.cross(x[chosen] - anchor, nodal[:, :3]).sum(axis=0) + nodal[:, 3:].sum(axis=0)
        np.testing.assert_allclose(moment, 0.0, atol=1e-9 * 1e6 * area * 5e-3)
    inward = -(nodal[:, 1:3] * x[chosen][:, 1:] / np.hypot(*x[chosen][:, 1:].T)[:, None]).sum()
    assert inward == pytest.approx(1e6 * 2.0 * math.pi * 5e-3 * 30e-3, rel=0.03)
    part = bd.Face("side") & bd.Within(bd.Box((15e-3, 20e-3, 20e-3)).moved((0.0, -10e-3, -10e-3)))
    _, half = bd.Pressure(part, 1e6).nodal(cylinder)
    assert np.abs(half[:, 1:3]).sum() == pytest.approx(0.5 * np.abs(nodal[:, 1:3]).sum(), rel=0.05)


def test_pressure_on_the_ends_shortens_by_p_over_e() -> None:
    cylinder = spheres(CYLINDER, 1500, spread=0.2, seed=4)
    E = bd.labtests.static_tension(cylinder, LAW).E
    ends = [bd.Pressure(bd.Face(face), 1e5, schedule=bd.Ramp(0.0, 1.0, 1e-3)) for face in ("x_min", "x_max")]
    moved = bd.solve_static(bd.Model(cylinder, LAW, density=RHO, boundary=ends)).displacement
    x = cylinder.particles.position
    middle = cylinder.connected & (np.abs(x[:, 0] - 15e-3) < 7.5e-3)
    columns = np.column_stack([np.ones(middle.sum()), x[middle]])
    strain = np.linalg.lstsq(columns, moved[middle], rcond=None)[0][1:]
    assert strain[0, 0] == pytest.approx(-1e5 / E, rel=2e-3)
    everywhere = [bd.Pressure(bd.Face(face), 1e5) for face in ("x_min", "x_max", "side")]
    moved = bd.solve_static(bd.Model(cylinder, LAW, density=RHO, boundary=everywhere)).displacement
    squeezed = np.linalg.lstsq(columns, moved[middle], rcond=None)[0][1:]
    assert (np.diag(squeezed) < 0.0).all()
    assert abs(squeezed[0, 0]) < abs(strain[0, 0])


# ---- stress-free strain


def test_a_free_body_grows_without_stress() -> None:
    cylinder = spheres(CYLINDER, 1500, spread=0.2, seed=4)
    model = bd.Model(cylinder, LAW, density=RHO, boundary=[bd.Eigenstrain(2e-3)])
    static = bd.solve_static(model)
    x = cylinder.particles.position[cylinder.connected]
    grown = 2e-3 * (x - x.mean(axis=0))
    moved = static.displacement[cylinder.connected]
    np.testing.assert_allclose(moved - moved.mean(axis=0), grown, atol=1e-6 * np.abs(grown).max())
    assert np.abs(static.rotation).max() < 1e-8
    reference = 0.5 * (model.stiffness.kn * (2e-3 * cylinder.length) ** 2).sum()
    assert static.energy.total < 1e-12 * reference


def test_a_held_chain_bears_the_closed_form_in_every_solver(record: Record) -> None:
    ends = bd.Fix(bd.Index([0, 7]))
    strain = bd.Eigenstrain(1e-3, schedule=bd.Ramp(0.0, 1.0, 0.05))
    model = bd.Model(rod(8), LAW, RHO, boundary=[ends, strain])
    kn, L = model.stiffness.kn, model.lattice.length
    thrust = 1e-3 * L.sum() / (1.0 / kn).sum()
    linear, bent = (bd.solve_static(model, nonlinear=nonlinear) for nonlinear in (False, True))
    assert linear.reaction[0, 0] == pytest.approx(thrust, rel=1e-9)
    assert linear.reaction[7, 0] == pytest.approx(-thrust, rel=1e-9)
    assert bent.reaction[0, 0] == pytest.approx(thrust, rel=1e-6)
    stored = 0.5 * thrust**2 * (1.0 / kn).sum()
    assert linear.energy.total == pytest.approx(stored, rel=1e-9)
    record("heated chain", *np.abs(linear.reaction[[0, 7], 0] / [thrust, -thrust] - 1.0))
    record("heated chain", abs(linear.energy.total / stored - 1.0))
    assert bent.energy.total == pytest.approx(linear.energy.total, rel=1e-6)
    relaxed = bd.solve_relaxed(model, tolerance=1e-9)
    assert relaxed.reaction[0, 0] == pytest.approx(thrust, rel=1e-6)
    gauges = {"wall": bd.Gauge(bd.Index([0]), "force")}
    run = bd.solve_explicit(model, duration=0.2, damping=bd.MassDamping(200.0), gauges=gauges, every=20)
    assert run.history["wall"][-1, 0] == pytest.approx(thrust, rel=1e-3)
    energy = run.history.energy
    assert energy["work"][-1] > energy["normal"][-1] > 0.9 * linear.energy.total


def test_a_clamped_bar_bears_minus_e_times_the_strain() -> None:
    cylinder = spheres(CYLINDER, 1500, spread=0.2, seed=4)
    E = bd.labtests.static_tension(cylinder, LAW).E
    hold = [bd.Fix(bd.Face(face), translation="x", rotation="") for face in ("x_min", "x_max")]
    steady = bd.Fix(bd.Index(np.flatnonzero(bd.Face("x_min").mask(cylinder))[:2]), translation="yz", rotation="")
    model = bd.Model(cylinder, LAW, density=RHO, boundary=[*hold, steady, bd.Eigenstrain(1e-3)])
    static = bd.solve_static(model)
    thrust = static.reaction[bd.Face("x_min").select(cylinder), 0].sum()
    # between the centres of the end elements the bar is shorter than its shape by a diameter
    x = cylinder.particles.position[:, 0]
    apart = x[bd.Face("x_max").select(cylinder)].mean() - x[bd.Face("x_min").select(cylinder)].mean()
    assert thrust == pytest.approx(1e-3 * E * math.pi * 25e-6 * apart / 30e-3, rel=0.06)


SCHEDULES = {"ramp": bd.Ramp(0.0, 1.0, 0.25), "table": bd.Table((0, 0.125, 0.25, 0.5), (0, 1.0, 1.0, -0.5))}


@pytest.mark.filterwarnings("ignore::bondem.errors.TurnedPressureWarning")
@pytest.mark.parametrize("schedule", SCHEDULES.values(), ids=SCHEDULES.keys())
def test_the_ledger_of_all_loads_closes_to_second_order(schedule: bd.Ramp | bd.Table, record: Record) -> None:
    boundary = [
        bd.Fix(bd.Index([0])),
        bd.Eigenstrain(0.02, region=bd.Index([2, 3, 4]), schedule=schedule),
        bd.Eigenstrain(-0.01, schedule=bd.Ramp(0.0, 1.0, 0.5, begin=0.125)),
        bd.BodyForce((3.0, 4.0, 0.0), schedule=schedule),
        bd.Pressure(bd.Face("x_max", depth=0.5), 3e4, schedule=bd.Ramp(0.0, 1.0, 0.125)),
        bd.Absorbing(bd.Face("x_max", depth=0.5), density=900.0, E=1e6, nu=0.2),
    ]
    model = bd.Model(rod(6), LAW, RHO, boundary=boundary)
    law = bd.EulerBernoulli(E=2e6, nu=0.25, radius_ratio=0.6)
    soft = bd.Model(model.lattice, law, density=RHO, boundary=boundary)
    errors = []
    for k in (64, 128, 256):
        dt = 1.0 / 16.0 / k
        history = integrate(soft, bd.Plan(duration=0.75, dt=dt, every=k)).history
        size = np.abs(history.energy["work"]).max()
        errors.append(np.abs(history.energy["balance"]).max() / size)
    assert history.energy["loss"][-1] > 1e-3 * size
    rates = np.log2(np.array(errors[:-1]) / errors[1:])
    np.testing.assert_allclose(rates, 2.0, atol=0.4)
    record("order of the ledger", *rates)


def test_the_example_of_a_heated_bar(record: Record) -> None:
    path = Path(__file__).parents[2] / "examples" / "thermal_bar.py"
    answer = runpy.run_path(str(path))["main"](1500)
    assert answer.growth == pytest.approx(1e-3, rel=1e-6)
    assert answer.stress == pytest.approx(1.0, abs=0.08)
    record("heated bar, free", answer.growth / 1e-3)
    record("heated bar, clamped", answer.stress)


# ---- absorbing boundary


def remaining_share(model: bd.Model, duration: float, dt: float) -> tuple[float, float]:
    """Energy at the end over the work put in, and the largest so far over it."""
    history = integrate(model, bd.Plan(duration=duration, dt=dt, every=50)).history
    held, energy = total_energy(history), history.energy
    return held[-1] / energy["work"][-1], held.max() / energy["work"][-1]


@pytest.mark.parametrize(("confined", "pulse", "count", "bound"), [
    pytest.param(False, 0.45, 10_500, 0.02, id="thin bar", marks=pytest.mark.validate),
    pytest.param(True, 0.25, 10_500, 0.02, id="plane wave", marks=pytest.mark.validate),
    pytest.param(True, 0.25, 4000, 0.04, id="plane wave, coarse"),
])  # fmt: skip
def test_a_pulse_leaves_through_an_absorbing_end(
    confined: bool, pulse: float, count: int, bound: float, record: Record
) -> None:
    # In a thin bar only pulses far longer than it is thick travel at √(E/ρ); shorter ones disperse. Spheres of 1.4
    # times the size disperse twice as much, so that the coarse bar may give back twice as much.
    box = bd.Box((0.6, 0.1, 0.1))
    lattice = spheres(box, count, spread=0.2, seed=2)
    tension = bd.labtests.static_tension(lattice, LAW)
    rho = RHO * lattice.particles.volume[lattice.connected].sum() / box.volume
    E, nu = tension.E, tension.nu
    plane = math.sqrt(E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / rho)
    c = plane if confined else math.sqrt(E / rho)
    width = pulse / c
    t = np.linspace(0.0, width, 41)
    push = bd.Table(tuple(t), tuple(np.sin(np.pi * t / width) ** 2))
    sides = [bd.Fix(bd.Face(f"{a}_{s}"), translation=a, rotation="") for a in "yz" for s in ("min", "max")]
    pushed = [bd.Load(bd.Face("x_min"), force=(1.0, 0.0, 0.0), schedule=push), *(sides if confined else [])]
    absorbing = bd.Absorbing(bd.Face("x_max"), density=rho, E=E, nu=nu, c=None if confined else c)
    model = bd.Model(lattice, LAW, density=RHO, boundary=[*pushed, absorbing])
    dt = time_step(model, 0.9)
    # all energy that is still in the bar when the pulse has gone counts as reflected
    duration = (0.6 + pulse) / c * 1.25
    left, most = remaining_share(model, duration, dt)
    kept, _ = remaining_share(model.with_boundary(pushed), duration, dt)
    print(f"confined={confined}: {left:.4%} of the energy comes back; without dashpots {kept:.2%}")
    assert most > 0.9
    assert kept > 0.95
    assert left < bound
    if count > 10_000:
        record(f"energy that comes back, {'plane wave' if confined else 'thin bar'}", left)


# ---- the same bits


def everything(n: tuple[int, int, int]) -> bd.Model:
    lattice = crooked_block(n, jitter=0.05, radius=(0.4, 0.5), reach=1.3)
    return bd.Model(lattice, LAW, density=RHO, boundary=[
        bd.Fix(bd.Face("x_min", depth=0.5)),
        bd.BodyForce((0.0, 0.0, -9.81)),
        bd.BodyForce((1.0, 0.0, 0.0), region=bd.Face("y_max", depth=0.5), schedule=bd.Ramp(0.0, 1.0, 0.01)),
        bd.Pressure(bd.Face("z_max", depth=0.5), 1e4, schedule=bd.Ramp(0.0, 1.0, 0.02)),
        bd.Absorbing(bd.Face("x_max", depth=0.5), density=900.0, E=1e9, nu=0.2),
        bd.Eigenstrain(1e-3, region=bd.Face("y_min", depth=2.0), schedule=bd.Ramp(0.0, 1.0, 0.01, begin=0.004)),
    ])  # fmt: skip


DAMPING = (bd.BondDamping(0.05), bd.MassDamping(3.0), bd.LocalDamping(0.02))


def test_threads_change_no_bit(record: Record) -> None:
    need_two_threads()
    model = everything((12, 9, 9))
    assert len(model.lattice.pairs) > BONDS_OF_PORTION
    dt = time_step(model, 0.5, DAMPING)
    runs = []
    for count in (1, 2):
        with threads(count):
            runs.append(integrate(model, bd.Plan(duration=150 * dt, dt=dt, damping=DAMPING, every=25)))
    assert_same_run(*runs)
    assert runs[0].history.energy["loss"][-1] > 0.0
    record("same bits", True)


def test_pauses_and_a_restart_change_no_bit(tmp_path, record: Record) -> None:
    model = everything((5, 2, 3))
    dt = time_step(model, 0.5, DAMPING)
    plan = bd.Plan(duration=300 * dt, dt=dt, damping=DAMPING, every=25)
    whole = integrate(model, plan)
    cut = integrate(model, bd.Plan(duration=110 * dt, dt=dt, damping=DAMPING, every=25))
    assert_same_run(whole, integrate(model, plan, state=cut.state.copy(), history=cut.history))
    often = integrate(model, bd.Plan(duration=300 * dt, dt=dt, damping=DAMPING, every=1))
    assert_same_bits(whole, often)
    out = tmp_path / "run.h5"
    stop = (bd.AtRest(speed=1e9, after=100 * dt),)
    bd.solve_explicit(model, duration=300 * dt, dt=dt, damping=DAMPING, every=25, until=stop, out=out)
    kept = bd.read_run(out)
    assert kept.model.boundary == model.boundary
    assert kept.plan.damping == DAMPING
    assert_same_run(whole, integrate(kept.model, plan, state=kept.state, history=kept.history))
    record("same bits", True)


def test_loads_that_make_no_sense_are_refused() -> None:
    model = bd.Model(rod(3), LAW, RHO)
    pulse = bd.Table([0.0, 1e-5], [0.0, 1e8])
    for make, message in (
        (lambda: bd.BodyForce((0.0, 1.0)), "three finite"),
        (lambda: bd.Pressure(bd.Index([0]), 1.0), "is not a face"),
        (lambda: bd.Pressure(bd.Face("x_min"), math.nan), "finite"),
        (lambda: bd.Absorbing(bd.Face("x_min"), density=-1.0, E=1e9, nu=0.2), "positive"),
        (lambda: bd.Absorbing(bd.Face("x_min"), density=1.0, E=1e9, nu=0.5), "Poisson"),
        (lambda: bd.Eigenstrain(0.5, schedule=bd.Ramp(0.0, -2.5, 1.0)), "above -1"),
        (lambda: model.with_boundary([bd.Pressure(bd.Face("side"), 1.0)]), "no face 'side'"),
        (lambda: bd.Pressure(bd.Face("x_min"), pulse), "pressure = .*schedule=bd.Table"),
        (lambda: bd.Load(bd.Face("x_min"), force=(pulse, 0.0, 0.0)), "force = .*schedule=bd.Table"),
        (lambda: bd.BodyForce((0.0, 0.0, pulse)), "acceleration = .*schedule=bd.Table"),
        (lambda: bd.Eigenstrain(pulse), "strain = .*schedule=bd.Table"),
    ):
        with pytest.raises(InputError, match=message):
            make()
    steps = bd.EulerBernoulli(E=2e9, nu=0.2, radius_ratio=0.5, formulation="incremental")
    with pytest.raises(InputError, match="formulation='total'"):
        bd.Model(model.lattice, steps, density=RHO, boundary=[bd.Eigenstrain(1e-3)])
    with pytest.raises(InputError, match="free"):
        bd.solve_static(bd.Model(rod(3), LAW, RHO, boundary=[bd.BodyForce((0.0, 0.0, -9.81))]))


# ---- body forces that vary in space
