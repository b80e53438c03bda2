"""The cell law: one energy, its exact gradient, the material's own moduli, walls that hold the surface."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import bondem as bd
from bondem.interactions.cells.cell_strain import CellStrain
from bondem.observables.facet_loads import loads_on_facets
from bondem.observables.surface_displacement import surface_displacement
from bondem.statics.nonlinear import tangent_matrix
from tests.bits import threads
from tests.elastic_energy import elastic_energy
from tests.models import clamped, time_step
from tests.specimens import crooked_cells


def shaken(model, *, shift=0.05, turn=0.3, seed=0):
    """A state with large relative motions."""
    state, rng = model.state(), np.random.default_rng(seed)
    state.pose[:, :3] += shift * rng.standard_normal((len(state.pose), 3))
    turned = Rotation.from_rotvec(turn * rng.standard_normal((len(state.pose), 3)))
    state.pose[:, 4:] = turned.as_quat()[:, [3, 0, 1, 2]]
    return state


def forces(model, state):
    """Force and torque of the facets on each cell, internal order, (n, 6)."""
    return -model.interaction.gradient(state.pose)[0]


LONG = (12, 4, 4)
LAWS = [{"nu": 0.3}, {"nu": -0.3}, {"nu": 0.45, "facet_rotation": "full"}, {"nu": 0.2, "facet_rotation": "none"}]


@pytest.mark.parametrize("law", LAWS, ids=str)
def test_forces_are_the_gradient_of_the_energy_at_large_rotations(law):
    model = bd.Model(crooked_cells((4, 4, 4)), bd.CellBond(E=1.0, **law), 1.0)
    state = shaken(model)
    found, step = forces(model, state), 1e-5
    for dof in range(0, 6 * len(state.pose), 13):
        e, d = divmod(dof, 6)
        energy = []
        for sign in (1.0, -1.0):
            moved = state.copy()
            if d < 3:
                moved.pose[e, d] += sign * step
            else:
                old = Rotation.from_quat(moved.pose[e, [5, 6, 7, 4]])
                new = Rotation.from_rotvec(sign * step * np.eye(3)[d - 3]) * old
                moved.pose[e, 4:] = new.as_quat()[[3, 0, 1, 2]]
            energy.append(elastic_energy(model, moved).total)
        assert (energy[1] - energy[0]) / (2.0 * step) == pytest.approx(found[e, d], abs=1e-8 * np.abs(found).max())


@pytest.mark.parametrize("law", LAWS, ids=str)
def test_momentum_rigid_motion_and_the_matrix_at_rest(law):
    model = bd.Model(crooked_cells((4, 4, 4)), bd.CellBond(E=1.0, **law), 1.0)
    state = shaken(model)
    load, x = forces(model, state), state.pose[:, :3]
    size = np.abs(load).max()
    assert np.abs(load[:, :3].sum(axis=0)).max() <= 1e-13 * size * len(x)
    assert np.abs((load[:, 3:] + np.cross(x, load[:, :3])).sum(axis=0)).max() <= 1e-13 * size * len(x)
    # the same energy in any rigid place
    turn, energy = Rotation.from_rotvec([1.0, -0.4, 2.0]), elastic_energy(model, state).total
    state.pose[:, :3] = turn.apply(state.pose[:, :3]) + np.array([3.0, -2.0, 1.0])
    state.pose[:, 4:] = (turn * Rotation.from_quat(state.pose[:, [5, 6, 7, 4]])).as_quat()[:, [3, 0, 1, 2]]
    assert elastic_energy(model, state).total == pytest.approx(energy, rel=1e-12)
    rest = model.state()
    rest.pose[:, :3] = turn.apply(rest.pose[:, :3])
    rest.pose[:, 4:] = turn.as_quat()[[3, 0, 1, 2]]
    assert elastic_energy(model, rest).total <= 1e-25
    # small motions answer with K u
    motion, h = np.random.default_rng(1).standard_normal((len(x), 6)), 1e-7
    small = model.state()
    small.pose[:, :3] += h * motion[:, :3]
    small.pose[:, 4:] = Rotation.from_rotvec(h * motion[:, 3:]).as_quat()[:, [3, 0, 1, 2]]
    expected = (model.interaction.stiffness() @ motion.ravel()).reshape(-1, 6)
    assert np.abs(-forces(model, small) / h - expected).max() <= 3e-6 * np.abs(expected).max()


def test_six_rigid_motions_and_no_more_are_without_energy():
    for law in LAWS[:3]:
        model = bd.Model(crooked_cells((4, 4, 4)), bd.CellBond(E=1.0, **law), 1.0)
        K = model.interaction.stiffness().tocsc().toarray()
        value = np.linalg.eigvalsh(K)
        assert np.abs(value[:6]).max() <= 1e-13 * value[-1]
        assert value[6] >= 1e-4 * value[-1]


@pytest.mark.filterwarnings("ignore:CellBond. E = :bondem.errors.UnitWarning")  # in units of its own
@pytest.mark.parametrize(
    "shape",
    [
        bd.Box((5, 5, 5)),
        bd.Box((5, 5, 5)) - bd.Box((2, 2, 9)).moved((2, -1, -1)),
        bd.Cylinder(2.4, 5).moved((0, 2.5, 2.5)),
        bd.Ball(2.4).moved((2.5, 2.5, 2.5)),
    ],
    ids=["box", "notch", "cylinder", "ball"],
)
def test_uniform_strain_gives_exact_tractions_without_poisson_effect(shape):
    x = crooked_cells((5, 5, 5), jitter=0.15).particles.position
    x = x[shape.depth(x) > 0.3]
    body = bd.connect(bd.Particles(x, 0.3, shape=shape), method="laguerre")
    model = bd.Model(body, bd.CellBond(E=3.0, nu=0.0), 1.0)
    strain = np.array([[1.0, 0.3, -0.2], [0.3, -0.5, 0.4], [-0.2, 0.4, 0.7]])
    found = CellStrain.of(body, model.cell_constants, x @ strain, np.zeros_like(x))
    traction = found.forces(body, model.cell_constants) / body.facets.area[:, None]
    assert np.abs(traction - 3.0 * body.facets.normal @ strain).max() <= 1e-12 * 3.0


@pytest.mark.parametrize("nu", [-0.3, 0.2, 0.4, 0.49])
def test_uniform_strain_has_its_dilatation_in_every_cell_inside(nu):
    body = crooked_cells((5, 5, 5), spread=0.0, periodic=True)
    model = bd.Model(body, bd.CellBond(E=1.0, nu=nu), 1.0)
    strain = np.diag([1.0, 0.5, -0.2])
    branch = body.particles.separation(*body.pairs.T)
    still = np.zeros((len(body.particles), 3))
    found = CellStrain.of(body, model.cell_constants, still, still, slip=branch @ strain)
    assert found.swelling == pytest.approx(1.3 * body.cells.volume, rel=2.0**-23)  # shares are of single precision


def test_bulk_moduli_are_those_of_the_material():
    body = crooked_cells((6, 6, 6), spread=0.0, periodic=True)
    for nu in (-0.3, 0.0, 0.2, 0.4, 0.49):
        moduli = bd.bulk_moduli(body, bd.CellBond(E=40e9, nu=nu))
        assert pytest.approx(1.0, rel=1e-3) == moduli.E / 40e9
        assert moduli.nu == pytest.approx(nu, abs=1e-3)


@pytest.mark.filterwarnings("ignore::bondem.errors.ThinBodyWarning")
@pytest.mark.filterwarnings("ignore:CellBond. E = :bondem.errors.UnitWarning")  # in units of its own
def test_plane_stress_of_a_plate_one_cell_thick():
    """Free facets on both sides open until they bear no traction: E and ν are those of plane stress."""
    body = crooked_cells((6, 6, 1), spread=0.0, seed=3)
    x = body.particles.position
    held = [bd.Fix(bd.Face("x_min"), translation="x", rotation=""), bd.Drive(bd.Face("x_max"), x=6e-3)]
    middle = bd.Index([int(np.abs(x - 3.0)[:, :2].sum(axis=1).argmin())])
    held.append(bd.Fix(middle, translation="yz", rotation="x"))
    static = bd.solve_static(bd.Model(body, bd.CellBond(E=2.0, nu=0.4), 1.0, boundary=held))
    pulled = static.reaction[x[:, 0] > 3.0, 0].sum()
    assert pulled / 6.0 / 1e-3 == pytest.approx(2.0, rel=5e-3)
    inside = (np.abs(x[:, :2] - 3.0) < 2.0).all(axis=1)
    lateral = np.polyfit(x[inside, 1], static.displacement[inside, 1], 1)[0]
    assert lateral / 1e-3 == pytest.approx(-0.4, abs=5e-3)


def confined(body, law):
    """Static solution of a body between smooth walls on all sides, pressed by 1e-3 of its length along x."""
    length = body.particles.envelope.extent
    sides = [bd.Fix(bd.Face(f"{a}_{end}"), translation=a, rotation="") for a in "yz" for end in ("min", "max")]
    ends = [bd.Fix(bd.Face("x_min"), translation="x", rotation=""), bd.Drive(bd.Face("x_max"), x=-1e-3 * length)]
    return bd.solve_static(bd.Model(body, law, 1.0, boundary=[*ends, *sides]))


def test_walls_hold_the_surface():
    """Confined compression: stress (λ + 2G) ε on every platen; the error of random cells falls with their size."""
    law, error = bd.CellBond(E=1.0, nu=0.3), []
    for k in (1, 2):
        body = crooked_cells((6 * k, 2 * k, 2 * k))
        static, stress = confined(body, law), 1e-3 * (law.lame + 2.0 * law.G)
        error.append(static.energy.total / (0.5e-3 * stress * body.cells.volume.sum()) - 1.0)
        far = body.centre[:, 0] > 3.0 * k
        pressed = -static.reaction[far, 0].sum() / (4 * k * k)
        assert pressed * 0.5e-3 == pytest.approx(static.energy.total / body.cells.volume.sum(), rel=1e-8)
        assert np.abs(static.reaction.sum(axis=0)[:3]).max() <= 1e-9
    assert abs(error[0]) < 0.015
    assert abs(error[1]) < 0.6 * abs(error[0])
    assert (
        abs(confined(crooked_cells((6, 6, 6)), bd.CellBond(E=1.0, nu=0.0)).energy.total / (0.5e-6 * 216) - 1.0) < 1e-9
    )


def test_work_of_loads_is_energy_and_reactions_balance():
    model = clamped(crooked_cells(LONG), bd.CellBond(E=1.0, nu=0.3), force=(1.0, 2.0, 3.0), moment=(0.5, 0.0, 1.0))
    static = bd.solve_static(model)
    force = loads_on_facets(model)
    traction = force / crooked_cells(LONG).cells.free.area[:, None]
    moved = surface_displacement(model, static.displacement, static.rotation, traction=traction)
    assert 0.5 * (force * moved).sum() == pytest.approx(static.energy.total, rel=1e-12)
    assert static.reaction[:, :3].sum(axis=0) == pytest.approx([-1.0, -2.0, -3.0], rel=1e-8)
    about = np.cross(model.lattice.centre, static.reaction[:, :3]) + static.reaction[:, 3:]
    wanted = -np.array([0.5, 0.0, 1.0]) - np.cross([12.0, 2.0, 2.0], [1.0, 2.0, 3.0])
    assert about.sum(axis=0) == pytest.approx(wanted, rel=1e-8)


@pytest.mark.filterwarnings("ignore:CellBond. E = :bondem.errors.UnitWarning")  # in units of its own
def test_tractions_reach_the_cells_that_they_act_on():
    """Uniform pressure on all faces: the stress of every cell is -p, though its own facets bear part of the load."""
    body, nu = crooked_cells((6, 6, 6)), 0.3
    faces = [bd.Pressure(bd.Face(name), 1.0) for name in body.particles.envelope.faces]
    model = bd.Model(body, bd.CellBond(E=10.0, nu=nu), 1.0, boundary=faces)
    stress = bd.cell_stress(model, bd.solve_static(model))
    mean = np.einsum("n,nab->ab", body.cells.volume, stress) / body.cells.volume.sum()
    assert np.abs(mean + np.eye(3)).max() <= 1e-9
    assert np.abs(np.einsum("naa->n", stress) / 3.0 + 1.0).max() <= 0.05
    strain = np.polyfit(body.particles.position[:, 0], bd.solve_static(model).displacement[:, 0], 1)[0]
    # half of these cells are at the surface; without the term the error is tens of per cent
    assert strain == pytest.approx(-(1.0 - 2.0 * nu) / 10.0, rel=0.015)


def test_work_of_tractions_that_change_is_in_the_ledger():
    law, face = bd.CellBond(E=1.0, nu=0.4), bd.Face("x_max")
    pull = bd.Load(face, force=(0.05, 0.0, 0.002), schedule=bd.Ramp(0.0, 1.0, 5.0))
    loads = [pull, bd.Pressure(bd.Face("z_max"), 2e-4)]
    model = bd.Model(crooked_cells(LONG), law, 1.0, boundary=[bd.Fix(bd.Face("x_min")), *loads])
    step, missed = time_step(model, 0.5), []
    for part in (1, 2):
        missed.append(bd.solve_explicit(model, duration=20.0, dt=step / part, every=5 * part).residual)
    assert 3.4 < missed[0] / missed[1] < 4.7
    end = bd.solve_explicit(model, duration=900.0, damping=bd.MassDamping(0.05), every=1000).state
    static = bd.solve_static(model, nonlinear=True)
    assert np.abs(end.displacement - static.displacement).max() <= 1e-6 * np.abs(static.displacement).max()


def test_free_expansion_bears_no_stress():
    model = bd.Model(crooked_cells(LONG), bd.CellBond(E=1.0, nu=0.3), 1.0, boundary=[bd.Eigenstrain(1e-3)])
    static = bd.solve_static(model)
    assert static.energy.total <= 1e-20
    gradient = np.polyfit(crooked_cells(LONG).centre[:, 0], static.displacement[:, 0], 1)[0]
    assert gradient == pytest.approx(1e-3, rel=1e-9)


def test_energy_is_kept_to_second_order_with_a_wall_that_moves():
    law = bd.CellBond(E=1.0, nu=0.3)
    drive = bd.Drive(bd.Face("x_max"), x=bd.Ramp(0.0, 0.1, 8.0), vz=bd.Ramp(0.0, 0.2, 8.0))
    boundary = [bd.Fix(bd.Face("x_min")), drive]
    model = bd.Model(crooked_cells(LONG), law, 1.0, boundary=boundary)
    step, missed = time_step(model, 0.5), []
    for part in (1, 2, 4):
        run = bd.solve_explicit(model, duration=20.0, dt=step / part, every=5 * part)
        missed.append(run.residual)
    assert 3.4 < missed[0] / missed[1] < 4.7
    assert 3.4 < missed[1] / missed[2] < 4.7


def test_a_slow_run_ends_in_the_static_solution():
    law, face = bd.CellBond(E=1.0, nu=0.3), bd.Face("x_max")
    model = bd.Model(
        crooked_cells(LONG), law, 1.0, boundary=[bd.Fix(bd.Face("x_min")), bd.Drive(face, x=bd.Ramp(0, 1e-4, 50.0))]
    )
    gauges = {"wall": bd.Gauge(face, "force", "sum")}
    run = bd.solve_explicit(model, duration=600.0, damping=bd.MassDamping(0.5), gauges=gauges)
    static = bd.solve_static(model)
    assert np.abs(run.state.displacement - static.displacement).max() <= 1e-7
    pulled = static.reaction[crooked_cells(LONG).centre[:, 0] > 6.0, 0].sum()
    assert run.history["wall"][-1, 0] == pytest.approx(pulled, rel=1e-4)


@pytest.mark.parametrize("pauses", [1, 3])
def test_the_same_bits_for_any_threads_and_pauses(pauses):
    body = crooked_cells((9, 9, 9))
    boundary = [bd.Fix(bd.Face("x_min")), bd.Drive(bd.Face("x_max"), x=bd.Ramp(0.0, 0.1, 8.0))]
    model = bd.Model(body, bd.CellBond(E=1.0, nu=0.3), 1.0, boundary=boundary)
    state = model.state()
    state.set_motion(velocity=1e-2 * np.random.default_rng(0).standard_normal((len(body.particles), 3)))
    found = []
    for count, every in ((1, 0), (2, pauses)):
        with threads(count):
            run = bd.solve_explicit(model, duration=20 * 0.05, dt=0.05, every=every, state=state)
        found.append(run.state)
    for name in ("pose", "motion"):
        assert np.array_equal(getattr(found[0], name), getattr(found[1], name))


def test_bad_input_is_refused_in_one_line():
    spheres = bd.connect(crooked_cells((4, 4, 4)).particles, reach=2.0)
    with pytest.raises(bd.errors.InputError, match="laguerre"):
        bd.Model(spheres, bd.CellBond(E=1.0, nu=0.3), 1.0)
    with pytest.raises(bd.errors.InputError, match="Poisson"):
        bd.CellBond(E=1.0, nu=0.5)
    with pytest.raises(bd.errors.InputError, match="facet_rotation"):
        bd.CellBond(E=1.0, nu=0.3, facet_rotation="half")
    beam = bd.EulerBernoulli(E=1.0, nu=0.3, radius_ratio=0.5)
    with pytest.raises(bd.errors.InputError, match="for all cells"):
        bd.Model(crooked_cells((4, 4, 4)), {bd.Everything(): bd.CellBond(E=1.0, nu=0.3), bd.Face("x_min"): beam}, 1.0)
    with pytest.raises(bd.errors.InputError, match="follow no law"):
        bd.Model(crooked_cells((4, 4, 4)), {bd.Face("x_min"): bd.CellBond(E=1.0, nu=0.3)}, 1.0)


@pytest.mark.validate
def test_a_nonlinear_path_ends_where_a_damped_run_comes_to_rest():
    law = bd.CellBond(E=1.0, nu=0.3)
    drive = bd.Drive(bd.Face("x_max"), x=bd.Ramp(0.0, -0.4, 60.0), z=bd.Ramp(0.0, 3.0, 60.0))
    model = bd.Model(crooked_cells(LONG), law, 1.0, boundary=[bd.Fix(bd.Face("x_min")), drive])
    bent = bd.solve_static(model, nonlinear=True)
    assert bent.residual <= 1e-8
    run = bd.solve_explicit(model, duration=900.0, damping=bd.MassDamping(0.3), every=1000)
    assert np.abs(run.state.displacement - bent.displacement).max() <= 1e-5
    assert run.history.energy["normal"][-1] == pytest.approx(bent.energy.normal, rel=1e-4)
    linear = bd.solve_static(model)
    assert np.abs(linear.displacement - bent.displacement).max() >= 0.05  # else nothing is shown


def test_the_tangent_is_the_derivative_of_the_forces_in_any_pose():
    model = bd.Model(crooked_cells(LONG), bd.CellBond(E=1.0, nu=0.3), 1.0, boundary=[bd.Fix(bd.Face("x_min"))])
    state = shaken(model, shift=0.02, turn=0.1)
    model.interaction.gradient(state.pose)  # leaves the stresses there
    tangent = tangent_matrix(model, model.interaction.stiffness().bonds, state.pose)
    motion = np.random.default_rng(1).standard_normal((len(state.pose), 6))
    change = model.interaction.product(state.pose, np.ones(len(model.layout.i)), model.bonds)(motion)
    expected = (tangent @ motion.ravel()).reshape(-1, 6)
    # torques are no gradient in spins taken one after the other: that part is as large as the torques themselves
    free = np.abs(forces(model, state)[:, 3:]).max() * np.abs(motion[:, 3:]).max()
    assert np.abs(change - expected)[:, :3].max() <= 1e-14 * np.abs(change).max()
    assert np.abs(change - expected)[:, 3:].max() <= free
