"""Scenes of several bodies: joined, moved, rotated and copied lattices, and what statics and runs make of them."""

import h5py
import numpy as np
import pytest

import bondem as bd
from bondem.errors import ContactWarning, DisconnectedError, FloatingBodyError, InputError

LAW = bd.EulerBernoulli(E=1e9, nu=0.2, radius_ratio=0.6)
ROCK = bd.connect(bd.pack(bd.Ball(radius=5e-3), count=120, seed=1), tolerance=0.01)
BRICK = bd.connect(bd.pack(bd.Box((10e-3, 8e-3, 6e-3)), count=60, seed=1, method="even"), method="laguerre")
CELLS = bd.CellBond(E=1e9, nu=0.2)
UP = (0.0, 0.0, 9e-3)


def largest(values: np.ndarray) -> float:
    return float(np.abs(values).max())


def pulled(body: bd.Lattice, ends: tuple[bd.Region, bd.Region], axis: np.ndarray) -> np.ndarray:
    fixed, loaded = ends
    model = bd.Model(body, CELLS, 2500.0, boundary=[bd.Fix(fixed), bd.Load(loaded, force=tuple(100.0 * axis))])
    return bd.solve_static(model).displacement


def test_a_rotated_body_of_cells_deforms_as_before_in_rotated_axes():
    about, angle = (1.0, 2.0, -1.0), 0.7
    turned = BRICK.rotated(about, angle).moved((1e-3, 2e-3, 3e-3))
    line = np.array(about) / np.linalg.norm(about)
    turn = np.stack([e * np.cos(angle) + np.cross(line, e) * np.sin(angle) + line * (line @ e) * (1 - np.cos(angle))
                     for e in np.eye(3)], axis=1)  # fmt: skip
    ends = bd.Face("x_min"), bd.Face("x_max")
    before = pulled(BRICK, ends, np.array([1.0, 0.2, 0.0]))
    after = pulled(turned, ends, turn @ [1.0, 0.2, 0.0])
    # levers of facets are whole numbers of a pitch along the axes
    assert largest(after - before @ turn.T) < 1e-6 * largest(before)
    centre = np.average(turned.centre, axis=0, weights=turned.element_volume)
    was = np.average(BRICK.centre, axis=0, weights=BRICK.element_volume)
    assert np.allclose(centre, was + np.array([1e-3, 2e-3, 3e-3]))


def test_bodies_in_one_scene_deform_as_they_do_alone():
    scene = bd.join(BRICK, BRICK.moved(UP), names=("low", "high"))
    parts = [(bd.Face("x_min", body=name), bd.Face("x_max", body=name)) for name in scene.names]
    force = (100.0, 20.0, 0.0)
    model = bd.Model(
        scene, CELLS, 2500.0, boundary=[c for fix, load in parts for c in (bd.Fix(fix), bd.Load(load, force=force))]
    )
    found = bd.solve_static(model).displacement.reshape(2, -1, 3)
    alone = pulled(BRICK, (bd.Face("x_min"), bd.Face("x_max")), np.array([1.0, 0.2, 0.0]))
    assert largest(found - alone) < 1e-8 * largest(alone)
    assert scene.volume == pytest.approx(2.0 * BRICK.volume, rel=1e-14)
    solid, one = bd.polyhedra(scene), bd.polyhedra(BRICK)
    assert len(solid.cell) == 2 * len(one.cell)
    assert (np.bincount(solid.cell) == np.tile(np.bincount(one.cell), 2)).all()
    inside = solid.neighbour >= 0
    assert (scene.body[solid.neighbour[inside]] == scene.body[solid.cell[inside]]).all()


def test_two_halves_that_are_bonded_across_equal_the_whole():
    upper = ROCK.particles.position[:, 2] > 0.0
    number = np.empty(len(upper), dtype=int)
    halves, inner = [], []
    for k, own in enumerate((~upper, upper)):
        number[own] = np.arange(own.sum())
        within = own[ROCK.pairs].all(axis=1)
        inner.append(within)
        particles = bd.Particles(ROCK.particles.position[own], ROCK.particles.radius[own])
        halves.append(bd.Lattice(particles, number[ROCK.pairs[within]]))
        number[own] += k * int((~upper).sum())
    across = number[ROCK.pairs[~(inner[0] | inner[1])]]
    scene = bd.join(*halves, pairs=across)
    velocity = np.random.default_rng(1).normal(size=(len(upper), 3))
    ends = []
    for lattice, order in ((ROCK, np.arange(len(upper))), (scene, number)):
        state = bd.Model(lattice, LAW, 2500.0).state()
        given = np.empty_like(velocity)
        given[order] = velocity
        state.velocity = given
        run = bd.solve_explicit(state.model, duration=2e-5, dt=2e-7, state=state)
        ends.append(run.state.displacement[order])
    assert largest(ends[1] - ends[0]) < 1e-12 * largest(ends[0])


def test_colliding_bodies_keep_their_momenta():
    scene = bd.replicate(ROCK, [(0.0, 0.0, 0.0), (1e-3, 0.0, 11.5e-3)], rotations="random", name="rock", seed=1)
    assert scene.names == ("rock/0", "rock/1")
    assert scene.rattlers == 2 * ROCK.rattlers
    model = bd.Model(scene, LAW, 2500.0, contact=bd.LinearContact(E=1e9, friction=0.3))
    state = model.state()
    state.set_velocity(bd.Body("rock/1"), (0.0, 0.0, -5.0), spin=(10.0, 0.0, 0.0))
    mass, inertia = model.mass[:, None], model.inertia[:, None]

    def momenta(state: bd.State) -> tuple[np.ndarray, np.ndarray, float]:
        turning = mass * np.cross(state.position, state.velocity)
        whole = (turning + inertia * state.angular_velocity).sum(axis=0)
        return (mass * state.velocity).sum(axis=0), whole, float(np.linalg.norm(turning, axis=1).sum())

    before = momenta(state)
    run = bd.solve_explicit(model, duration=6e-4, state=state)
    after = momenta(run.state)
    assert run.state.velocity[scene.body == 0, 2].mean() < -0.5  # they have met
    assert largest(after[0] - before[0]) < 1e-14 * largest(before[0])
    assert largest(after[1] - before[1]) < 1e-13 * before[2]


def test_a_velocity_of_a_region_is_that_of_a_rigid_body():
    scene = bd.join(ROCK, ROCK.moved((0.0, 0.0, 12e-3)))
    state = bd.Model(scene, LAW, 2500.0).state()
    state.set_velocity(bd.Body(1), (1.0, 2.0, 3.0), spin=(0.0, 0.0, 7.0), about=(1e-3, 0.0, 0.0))
    own = scene.body == 1
    x, y, _ = state.position[own].T
    assert np.allclose(state.velocity[own], np.stack([1.0 - 7.0 * y, 2.0 + 7.0 * (x - 1e-3), 3.0 + 0.0 * x], axis=1))
    assert np.allclose(state.angular_velocity[own], [0.0, 0.0, 7.0])
    assert not state.velocity[~own].any()


def test_files_and_fragments_tell_bodies_apart(tmp_path):
    scene = bd.replicate(ROCK, [(0.0, 0.0, 0.0), (0.0, 0.0, 20e-3)])
    model = bd.Model(scene, LAW, 2500.0, failure=bd.PeripheralStress(tension=1e6, shear=1e9))
    state = model.state()
    state.velocity = np.where(scene.body[:, None] == 1, 2e3 * (state.position - [0.0, 0.0, 20e-3]), 0.0)
    run = bd.solve_explicit(model, duration=2e-6, state=state, out=tmp_path / "run.h5", snapshot_every=5)
    found = bd.fragments(scene, run.state)
    assert len(found) > 50
    assert (found.body[found.label] == scene.body).all()
    bd.write_vtkhdf(tmp_path / "scene.vtkhdf", scene, state=run.state)
    for name, place in (("run.h5", "VTKHDF/elements/PointData/body"), ("scene.vtkhdf", "VTKHDF/PointData/body")):
        with h5py.File(tmp_path / name) as file:
            assert (file[place][:] == scene.body).all()


def test_loose_grains_are_a_body_with_weight():
    grains = bd.Particles([(0.0, 0.0, 9e-3), (3e-3, 0.0, 9e-3)], 1e-3)
    scene = bd.join(ROCK, grains, names=("rock", "grains"))
    assert bd.Body("grains").select(scene).tolist() == [len(ROCK.particles), len(ROCK.particles) + 1]
    model = bd.Model(scene, LAW, 2500.0, boundary=[bd.Gravity(region=bd.Body("grains"))])
    run = bd.solve_explicit(model, duration=1e-4)
    assert np.allclose(run.state.velocity[scene.body == 1], [0.0, 0.0, -9.81 * run.state.time], rtol=1e-12)
    assert largest(run.state.velocity[scene.body == 0]) < 1e-9 * 9.81 * run.state.time  # rounding of branch vectors


def test_bodies_survive_a_run_file(tmp_path):
    scene = bd.join(BRICK, BRICK.rotated("z", 0.3).moved((0.0, 0.0, 10e-3)), names=("low", "high"))
    model = bd.Model(scene, CELLS, 2500.0, boundary=[bd.Fix(bd.Face("z_min", body="low"))])
    bd.solve_explicit(model, duration=1e-6, out=tmp_path / "run.h5")
    back = bd.read_run(tmp_path / "run.h5").model
    assert back.lattice.names == scene.names
    assert (back.lattice.body == scene.body).all()
    high = bd.Face("x_max", body="high")
    assert (high.select(back.lattice) == high.select(scene)).all()
    assert back.boundary == model.boundary


@pytest.mark.parametrize(("make", "words"), [
    (lambda: bd.join(ROCK), "at least two"),
    (lambda: bd.join(BRICK, BRICK.moved((0.0, 0.0, 5e-3)), names=("a", "b")), "'a' and 'b' overlap by .* move them"),
    (lambda: bd.join(ROCK, BRICK.moved((0.0, 0.0, 0.1))), "argument 0 has spheres, argument 1 has cells"),
    (lambda: bd.join(ROCK, ROCK.moved(UP), names=("a", "a")), "two bodies are called 'a'"),
    (lambda: bd.join(ROCK, ROCK.moved((0, 0, 0.02)), names=("a",)), "give 2 names"),
    (lambda: bd.replicate(ROCK, (0.0, 0.0, 0.0)), r"\(k, 3\)"),
    (lambda: bd.replicate(ROCK, [(0.0, 0.0, 0.0)], [(2.0, 0.0, 0.0, 0.0)]), "1 unit quaternions"),
    (lambda: ROCK.rotated((0.0, 0.0, 0.0), 1.0), "has no length"),
    (lambda: bd.Gravity(direction=(0.0, 0.0, 0.0)), "has no length"),
    (lambda: bd.Body("hgih").select(bd.join(BRICK, BRICK.moved(UP), names=("low", "high"))), "did you mean 'high'"),
    (lambda: bd.Body(2).select(ROCK), "from 0 to 0"),
    (lambda: bd.Face("x_min").select(bd.join(BRICK, BRICK.moved(UP))), "name one, such as body='body 0'"),
    (lambda: bd.Face("side", body=1).select(bd.join(BRICK, BRICK.moved(UP))), "side"),
])  # fmt: skip
def test_bad_scenes_are_refused_in_one_line(make, words):
    with pytest.raises(InputError, match=words) as error:
        make()
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("make", [
    lambda scene: bd.fabric(scene),
    lambda scene: bd.carve(scene, bd.Ball(radius=1.0)),
    lambda scene: bd.replicate(scene, [(0.0, 0.0, 0.0)]),
    lambda scene: bd.calibrate(scene, bd.materials.granite),
    lambda scene: bd.Response(scene, LAW),
    lambda scene: bd.labtests.static_tension(scene, LAW),
])  # fmt: skip
def test_what_takes_one_body_refuses_a_scene_in_one_line(make):
    with pytest.raises(InputError, match="takes one body, not a scene of 2; give the body before") as error:
        make(bd.join(ROCK, ROCK.moved((0.0, 0.0, 0.02))))
    assert "\n" not in str(error.value)


def test_bricks_stand_face_to_face_without_force():
    scene = bd.join(BRICK, BRICK.moved((0.0, 0.0, 6e-3)))
    model = bd.Model(scene, CELLS, 2500.0, contact=bd.LinearContact(E=1e9))
    with pytest.warns(ContactWarning, match="plane faces"):
        run = bd.solve_explicit(model, duration=1e-5)
    assert largest(run.state.displacement) < 1e-15


def test_laws_and_stresses_of_a_body_are_those_of_the_body_alone():
    half = bd.Particles(0.5 * ROCK.particles.position, 0.5 * ROCK.particles.radius, shape=bd.Ball(radius=2.5e-3))
    small = bd.connect(half, tolerance=0.01)
    scene = bd.join(ROCK, small.moved((0.0, 0.0, 9e-3)), names=("large", "small"))
    own = scene.body == 0
    whole, alone = (bd.Model(lattice, LAW, 2500.0) for lattice in (scene, ROCK))
    np.testing.assert_array_equal(whole.stiffness.kn[own[scene.pairs[:, 0]]], alone.stiffness.kn)  # bonds of R̄
    assert np.allclose(whole.stiffness.kn[~own[scene.pairs[:, 0]]], 0.5 * alone.stiffness.kn, rtol=1e-12)
    stresses = []
    for model in (whole, alone):
        state = model.state()
        state.displacement = np.where(own[: len(state.position), None], 1e-3 * state.position, 0.0)
        stresses.append(bd.element_stress(model, state).stress[: len(ROCK.particles)])
    assert largest(stresses[0] - stresses[1]) < 1e-12 * largest(stresses[1])
    assert scene.volume == pytest.approx(1.125 * ROCK.volume, rel=1e-12)


def test_statics_name_the_body_that_floats():
    scene = bd.join(BRICK, BRICK.moved(UP), names=("low", "high"))
    held = bd.Fix(bd.Face("x_min", body="low"))
    with pytest.raises(FloatingBodyError, match="nothing holds 'high' of the 2 bodies"):
        bd.solve_static(bd.Model(scene, CELLS, 2500.0, boundary=[held, bd.Gravity()]))
    with pytest.raises(FloatingBodyError, match="nothing holds 'high'"):
        bd.solve_modes(bd.Model(scene, CELLS, 2500.0, boundary=[held]), count=2)
    # a body on a hinge turns about it; grains without bonds never rest; size does not matter
    for scale in (1.0, 1e-6):
        small = bd.Lattice(bd.Particles(scale * ROCK.particles.position, scale * ROCK.particles.radius), ROCK.pairs)
        scene = bd.join(small, small.moved((0.0, 0.0, 0.02 * scale)), names=("low", "high"))
        ends = [bd.Fix(bd.Body(name), rotation="") for name in scene.names]
        hinge = bd.Fix(bd.Body("high") & bd.Index([len(ROCK.particles) + 7]), rotation="")
        assert bd.solve_static(bd.Model(scene, LAW, 2500.0, boundary=ends)).displacement.max() == 0.0
        for solve in (bd.solve_static, bd.solve_relaxed):
            with pytest.raises(FloatingBodyError, match="nothing holds 'high' of the 2 bodies"):
                solve(bd.Model(scene, LAW, 2500.0, boundary=[ends[0], hinge]))
    grains = bd.Particles(0.03 + 3e-3 * np.indices((10, 10, 10)).reshape(3, -1).T, 1e-3)
    scene = bd.join(ROCK, grains, names=("rock", "grains"))
    with pytest.raises(FloatingBodyError, match="nothing holds 'grains' of the 2 bodies"):
        bd.solve_static(bd.Model(scene, LAW, 2500.0, boundary=[bd.Fix(bd.Body("rock"))]))


def test_a_body_in_two_pieces_is_named():
    far = ROCK.moved((0.0, 0.0, 0.02))
    both = [one.particles for one in (ROCK, far)]
    two = bd.Particles(np.concatenate([p.position for p in both]), np.concatenate([p.radius for p in both]))
    bodies = bd.Bodies(np.append(np.zeros(len(two) - 1, dtype=int), 1), ("rock", "rest"), (None, None))
    with pytest.raises(DisconnectedError, match="body 'rock' consists of pieces of"):
        bd.Lattice(two, np.concatenate([ROCK.pairs, ROCK.pairs + len(ROCK.particles)]), bodies=bodies)
