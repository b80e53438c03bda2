"""What models, regions, schedules and solvers are given: used as meant, or refused in one line of `InputError`."""

import math
import typing

import numpy as np
import pytest
from scipy.spatial import KDTree

import bondem as bd
from bondem.errors import FaceWarning, InputError
from tests.specimens import grid, row

GRID = grid((5, 3, 3)).centre
LATTICE = grid((5, 3, 3), walled=True)
LAW = bd.EulerBernoulli(E=70e9, nu=0.3, radius_ratio=0.5)
LEFT, RIGHT = bd.Face("x_min"), bd.Face("x_max")
PARTICLES = LATTICE.particles
CONTACT = bd.LinearContact(E=1e9)


def model_of(*boundary, **options):
    return bd.Model(LATTICE, LAW, 2000.0, boundary=boundary, **options)


HELD = model_of(bd.Fix(LEFT))


def run(**options):
    return bd.solve_explicit(HELD, **({"duration": 1e-6} | options))


REFUSED = {
    "positions as text": ("position = 'x' holds no numbers", lambda: bd.Particles("x", 1.0)),
    "ragged positions": ("holds no numbers", lambda: bd.Particles([[0, 0], [1]], 1.0)),
    "radius as text": ("radius = '1'", lambda: bd.Particles([[0, 0, 0]], "1")),
    "radius 1e300": ("check its units", lambda: bd.Particles([[0, 0, 0]], 1e300)),
    "radius 1e-300": ("check its units", lambda: bd.Particles([[0, 0, 0]], 1e-300)),
    "radii in metres, centres in mm": ("both in metres", lambda: bd.Particles(GRID, 1.0)),
    "a shape by name": ("shape = 'box'", lambda: bd.Particles([[0, 0, 0]], 1.0, shape="box")),
    "a period as text": ("three positive edge", lambda: bd.Particles([[0, 0, 0]], 1.0, period="box")),
    "pairs as text": ("integer element indices", lambda: bd.Lattice(PARTICLES, "pairs")),
    "ragged pairs": ("integer element indices", lambda: bd.Lattice(PARTICLES, [[0, 1], [2]])),
    "pairs of floats": ("integer element indices", lambda: bd.Lattice(PARTICLES, [[0.0, 1.0]])),
    "a lattice of no particles": ("give bd.Particles", lambda: bd.Lattice(3, [[0, 1]])),
    "connect nothing": ("give bd.Particles", lambda: bd.connect("particles")),
    "tolerance as text": ("bonding distance", lambda: bd.connect(PARTICLES, tolerance="0")),
    "tolerance NaN": ("bonding distance", lambda: bd.connect(PARTICLES, tolerance=math.nan)),
    "reach 0": ("positive multiple", lambda: bd.connect(PARTICLES, reach=0)),
    "tolerance below all": ("raise it", lambda: bd.connect(PARTICLES, tolerance=-1e9)),
    "carve by name": ("a shape such as", lambda: bd.carve(LATTICE, "box")),
    "E as text": ("E = '70e9'; give a positive", lambda: bd.EulerBernoulli(E="70e9", nu=0.3, radius=1)),
    "E as truth": ("E = True", lambda: bd.Timoshenko(E=True, nu=0.3, radius=1)),
    "E 1e300": ("beyond any quantity", lambda: bd.Timoshenko(E=1e300, nu=0.3, radius=1)),
    "nu None": ("nu = None", lambda: bd.Timoshenko(E=1e9, nu=None, radius=1)),
    "radius ratio in a list": ("radius_ratio", lambda: bd.Timoshenko(E=1e9, nu=0.3, radius_ratio=[0.5])),
    "alpha_s as text": ("alpha_s = 'a'", lambda: bd.Obermayr(E=1e9, nu=0.3, radius=1, alpha_s="a")),
    "kappa as text": ("kappa = 'a'", lambda: bd.ParallelBond(E=1e9, nu=0.3, radius=1, kappa="a")),
    "gamma as text": ("gamma = 'a'", lambda: bd.LocalDamping("a")),
    "eta as text": ("eta = 'a'", lambda: bd.BondDamping(eta="a")),
    "alpha None": ("alpha = None", lambda: bd.MassDamping(None)),
    "modulus of contact as text": ("E = 'a'", lambda: bd.LinearContact(E="a")),
    "stress_free as text": ("True or False", lambda: bd.LinearContact(E=1.0, stress_free="no")),
    "a model of no lattice": ("give a lattice", lambda: bd.Model(PARTICLES, LAW, 1.0)),
    "a bond law by name": ("bond= is not a bond law", lambda: bd.Model(LATTICE, "EulerBernoulli", 1.0)),
    "bonds by face name": ("bd.Face.'x_min'", lambda: bd.Model(LATTICE, {"x_min": LAW}, 1.0)),
    "no law for a region": ("give a bond law", lambda: bd.Model(LATTICE, {LEFT: 70e9}, 1.0)),
    "three regions a bond": ("3 regions", lambda: bd.Model(LATTICE, {(LEFT, LEFT, RIGHT): LAW}, 1.0)),
    "stiffness that is no number": ("exceed the range of numbers", lambda: bd.Model(
        LATTICE, bd.Timoshenko(E=1e99, nu=0.2, radius=1e90), 1.0)),
    "density None": ("density = None", lambda: bd.Model(LATTICE, LAW, None)),
    "density as text": ("density = '2000'", lambda: bd.Model(LATTICE, LAW, "2000")),
    "density 1e300": ("positive and finite", lambda: bd.Model(LATTICE, LAW, 1e300)),
    "boundary as text": ("boundary = 'fixed'", lambda: model_of("fixed")),
    "boundary in a list too many": ("one or a sequence", lambda: model_of([bd.Fix(LEFT)])),
    "boundary of a twin": ("one or a sequence", lambda: HELD.with_boundary(3)),
    "walls of numbers": ("walls = 3", lambda: model_of(contact=CONTACT, walls=3)),
    "a face by name": ("bd.Face.'x_min'", lambda: bd.Fix("x_min")),
    "axes by number": ("axes as text", lambda: bd.Fix(LEFT, translation=3)),
    "a drive by name": ("bd.Face.'x_max'", lambda: bd.Drive("x_max", x=1.0)),
    "a drive by NaN": ("x = nan", lambda: bd.Drive(RIGHT, x=math.nan)),
    "a drive by text": ("a number, or a schedule", lambda: bd.Drive(RIGHT, vx="1")),
    "a load by name": ("bd.Face.'x_max'", lambda: bd.Load("x_max", force=(1, 0, 0))),
    "a force without direction": ("three finite", lambda: bd.Load(RIGHT, force=5.0)),
    "a force of 1e300": ("three finite", lambda: bd.Load(RIGHT, force=(1e300, 0, 0))),
    "a load over text": ("schedule = '2'", lambda: bd.Load(RIGHT, force=(1, 0, 0), schedule="2")),
    "weight without direction": ("three finite", lambda: bd.BodyForce(9.81)),
    "weight of a name": ("not a region", lambda: bd.BodyForce((0, 0, -9.81), region="all")),
    "pressure as text": ("pressure = '1'", lambda: bd.Pressure(LEFT, "1")),
    "pressure on a name": ("bd.Face.'x_min'", lambda: bd.Pressure("x_min", 1.0)),
    "strain as text": ("strain = 'a'", lambda: bd.Eigenstrain("a")),
    "celerity as text": ("c = 'a'", lambda: bd.Absorbing(LEFT, density=1.0, E=1.0, nu=0.2, c="a")),
    "constant NaN": ("value = nan", lambda: bd.Constant(math.nan)),
    "ramp to NaN": ("end = nan", lambda: bd.Ramp(0, math.nan, 1)),
    "ramp to infinity": ("end = inf", lambda: bd.Ramp(0, math.inf, 1)),
    "ramp of text": ("start = '0'", lambda: bd.Ramp("0", 1, 1)),
    "ramp of no time": ("positive time", lambda: bd.Ramp(0, 1, 0)),
    "ramp lost in rounding": ("lost against", lambda: bd.Ramp(0, 1, 1e-9, begin=1e30)),
    "table with NaN": ("finite", lambda: bd.Table((0, 1), (0, math.nan))),
    "table of text": ("holds no numbers", lambda: bd.Table("a", "b")),
    "a wall moved by a schedule": ("bd.Driven", lambda: bd.PlaneWall((0, 0, 0), (0, 0, 1), motion=bd.Ramp(0, 1, 1))),
    "a wall moved by a number": ("bd.Driven", lambda: bd.CylinderWall(1.0, motion=1.0)),
    "a point as text": ("point = 'a'", lambda: bd.PlaneWall("a", (0, 0, 1))),
    "a servo of text": ("force = 'a'", lambda: bd.Servo("a", speed=1.0)),
    "a gauge by name": ("bd.Face.'x_min'", lambda: bd.Gauge("x_min", "force")),
    "a gauge of 3": ("quantity = 3", lambda: bd.Gauge(LEFT, 3)),
    "wall 1.5": ("number of a wall", lambda: bd.WallGauge(1.5, "force")),
    "index 1.7": ("whole numbers", lambda: bd.Index([1.7])),
    "index text": ("whole numbers", lambda: bd.Index("1")),
    "index None": ("whole numbers", lambda: bd.Index(None)),
    "index -1": ("element -1", lambda: bd.Index([-1])),
    "index half a mask": ("whole numbers", lambda: bd.Index([True, 2])),
    "index out of range": ("element 45 does not exist; .* 0 to 44", lambda: bd.Index([3, 45]).select(LATTICE)),
    "mask of another lattice": ("the mask has 44 elements, but the lattice has 45", lambda: bd.Index(
        np.ones(44, dtype=bool)).select(LATTICE)),
    "a face by number": ("name of a face", lambda: bd.Face(3)),
    "depth as text": ("depth = 'a'", lambda: bd.Face("x_min", "a")),
    "within a name": ("a shape such as", lambda: bd.Within("box")),
    "a face and a name": ("not a region", lambda: LEFT & "x_max"),
    "speed as text": ("speed = 'a'", lambda: bd.AtRest("a")),
    "phi as text": ("phi = 'a'", lambda: bd.TchamwaWielgosz("a")),
    "velocity as text": ("holds no numbers", lambda: HELD.state().set_motion(velocity="a")),
    "pose of one": ("position has shape", lambda: HELD.state().set_pose(position=3.0)),
    "quaternions of length 2": ("unit quaternions", lambda: HELD.state().set_pose(
        orientation=np.tile([2.0, 0, 0, 0], (45, 1)))),
    "run no model": ("give bd.Model", lambda: bd.solve_explicit(LATTICE, duration=1.0)),
    "duration as text": ("duration = '1'", lambda: run(duration="1")),
    "duration 1e300": ("beyond any quantity", lambda: run(duration=1e300)),
    "duration of ages": ("check its units", lambda: run(duration=1e9)),
    "dt as text": ("dt = 'x'", lambda: run(dt="x")),
    "scheme by name": ("scheme = 'verlet'", lambda: run(scheme="verlet")),
    "damping by number": ("damping= takes", lambda: run(damping=0.1)),
    "gauges in a list": ("gauges by name", lambda: run(gauges=[bd.Gauge(LEFT, "displacement")])),
    "a region for a gauge": ("bd.Gauge", lambda: run(gauges={"a": LEFT})),
    "a force gauge on nothing held": ("has none", lambda: run(gauges={"a": bd.Gauge(RIGHT, "force")})),
    "a gauge of a wall of none": ("the model has no walls=", lambda: run(gauges={"a": bd.WallGauge(3, "force")})),
    "every 1.5": ("every = 1.5", lambda: run(every=1.5)),
    "save_every None": ("save_every = None", lambda: run(save_every=None)),
    "until a number": ("until = 3", lambda: run(until=3)),
    "safety as text": ("safety = 's'", lambda: run(safety="s")),
    "a state by number": ("state = 3", lambda: run(state=3)),
    "an unknown device": ("device = 3", lambda: run(device=3)),
    "out by number": ("out = 3", lambda: run(out=3)),
    "no callback": ("callback = 3", lambda: run(callback=3)),
    "static of a lattice": ("give bd.Model", lambda: bd.solve_static(LATTICE)),
    "nonlinear as text": ("True or False", lambda: bd.solve_static(HELD, nonlinear="yes")),
    "a guess by number": ("guess = 3", lambda: bd.solve_static(HELD, guess=3)),
    "a guess for a path": ("guess= has no effect", lambda: bd.solve_static(
        HELD, nonlinear=True, guess=bd.solve_static(HELD))),
    "static with contacts": ("explicit runs only", lambda: bd.solve_static(model_of(bd.Fix(LEFT), contact=CONTACT))),
    "modes with contacts": ("explicit runs only", lambda: bd.solve_modes(model_of(bd.Fix(LEFT), contact=CONTACT))),
    "modes as text": ("count = 'a'", lambda: bd.solve_modes(HELD, count="a")),
    "too many modes": ("but the model has", lambda: bd.solve_modes(HELD, count=10**9)),
    "tolerance of relaxation": ("tolerance = 'a'", lambda: bd.solve_relaxed(HELD, tolerance="a")),
    "resume a number": ("path = 3", lambda: bd.resume(3)),
    "read no run": ("path = None", lambda: bd.read_run(None)),
}  # fmt: skip


@pytest.mark.parametrize(("words", "call"), REFUSED.values(), ids=REFUSED)
def test_refused_in_one_line(words, call):
    with pytest.raises(InputError, match=words) as caught:
        call()
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 400


def test_a_guess_of_another_lattice_is_refused():
    other = bd.solve_static(bd.Model(row(20), LAW, 1.0, boundary=bd.Fix(bd.Index([0]))))
    with pytest.raises(InputError, match="20 elements"):
        bd.solve_static(HELD, guess=other)


def test_overlaps_everywhere_are_refused_before_all_pairs_are_listed(monkeypatch):
    class Listing(KDTree):
        def query_pairs(self, *args, **options):
            raise MemoryError

    monkeypatch.setattr("bondem.specimen.particles.KDTree", Listing)
    with pytest.raises(InputError, match="both in metres"):
        bd.Particles(GRID, 1.0)


def test_bonds_beyond_all_memory_are_refused_before_they_are_listed():
    many = np.random.default_rng(0).uniform(0.0, 1.0, (700, 3))
    with pytest.raises(InputError, match="699 per element"):
        bd.connect(bd.Particles(many, 1e-6), reach=1e7)


def test_density_has_no_default():
    with pytest.raises(TypeError, match="density"):
        bd.Model(LATTICE, LAW)


def test_one_condition_or_several():
    one, two = bd.Fix(LEFT), bd.Load(RIGHT, force=(50.0, 0, 0))
    alone = bd.Model(LATTICE, LAW, 1.0, boundary=one)
    assert alone.boundary == (one,)
    assert bd.Model(LATTICE, LAW, 1.0, boundary=iter([one, two])).boundary == (one, two)
    assert alone.with_boundary(two).boundary == (two,)


def test_a_number_is_a_constant_schedule():
    assert bd.Load(RIGHT, force=(1, 0, 0), schedule=2.0) == bd.Load(RIGHT, force=(1, 0, 0), schedule=bd.Constant(2.0))
    double = bd.solve_static(model_of(bd.Fix(LEFT), bd.Load(RIGHT, force=(25.0, 0, 0), schedule=2.0)))
    plain = bd.solve_static(model_of(bd.Fix(LEFT), bd.Load(RIGHT, force=(50.0, 0, 0))))
    np.testing.assert_allclose(double.displacement, plain.displacement, rtol=1e-12)


def test_a_schedule_has_the_value_the_kernels_take():
    table = bd.Table((0.0, 1.0, 1.0, 3.0), (2.0, 4.0, -1.0, 1.0))
    found = [table.at(t) for t in (-1.0, 0.0, 0.5, 1.0, 2.0, 3.0, 9.0)]
    assert found == [2.0, 2.0, 3.0, -1.0, 0.0, 1.0, 1.0]


def test_until_takes_one_event_or_several():
    load = model_of(bd.Fix(LEFT), bd.Load(RIGHT, force=(50.0, 0, 0)))
    stop, never = bd.AtRest(1e3, after=2e-7), bd.AtRest(1e-30)
    for until in (stop, [never, stop], (stop, never)):
        done = bd.solve_explicit(load, duration=1e-5, every=1, until=until)
        assert done.status is bd.Status.STOPPED
        assert 2e-7 <= done.state.time < 2e-7 + 1.01 * done.dt


def test_gauges_of_walls_pass_a_type_checker():
    assert (
        bd.WallGauge
        in typing.get_args(typing.get_args(typing.get_type_hints(bd.solve_explicit)["gauges"])[0])[1].__args__
    )


def test_a_force_gauge_sums_unless_told_otherwise():
    """The force on a face of nine elements is what was applied, not a ninth of it."""
    pulled = model_of(bd.Fix(LEFT), bd.Load(RIGHT, force=(50.0, 0, 0)))
    gauges = {"force": bd.Gauge(RIGHT, "force"), "mean": bd.Gauge(RIGHT, "force", "mean"),
              "shift": bd.Gauge(RIGHT, "displacement")}  # fmt: skip
    history = bd.solve_explicit(pulled, duration=2e-6, every=5, gauges=gauges).history
    np.testing.assert_allclose(history["force"][:, 0], 50.0, rtol=1e-12)
    np.testing.assert_allclose(history["mean"][:, 0], 50.0 / 9.0, rtol=1e-12)
    assert gauges["shift"].reduction == "mean"


def test_a_mask_selects_what_it_marks():
    mask = np.zeros(45, dtype=bool)
    mask[[2, 7, 30]] = True
    np.testing.assert_array_equal(bd.Index(mask).select(LATTICE), [2, 7, 30])
    np.testing.assert_array_equal(bd.Index(mask.tolist()).select(LATTICE), [2, 7, 30])
    assert bd.Index(mask) == bd.Index([2, 7, 30])
    np.testing.assert_array_equal(bd.Index(4).select(LATTICE), [4])
    first = bd.Index(PARTICLES.position[:, 0] < 0.6e-3)
    np.testing.assert_array_equal(first.select(LATTICE), LEFT.select(LATTICE))


def rough(shape=None):
    """Spheres off a grid, so that no two reach equally far."""
    random = np.random.default_rng(1)
    grid = np.stack(np.meshgrid(np.arange(8), np.arange(6), np.arange(6), indexing="ij"), axis=-1).reshape(-1, 3)
    position = 1e-3 * (grid + 0.5) + 5e-5 * random.standard_normal(grid.shape)
    return bd.connect(bd.Particles(position, 0.45e-3, shape=shape), reach=1.5)


def test_a_face_of_particles_without_a_shape_is_a_layer_or_says_that_it_is_none():
    """Two elements of 36 bear the load of the face: its displacement is many times that of the face."""
    lattice = rough()
    with pytest.warns(FaceWarning, match=r"selects 2 of the 36 elements .* depth=1.0"):
        assert len(bd.Face("x_max").select(lattice)) == 2
    layer = bd.Face("x_max", depth=1.0).select(lattice)
    assert len(layer) == 36
    held = bd.Fix(bd.Face("x_min", depth=1.0))
    face = bd.Load(bd.Face("x_max", depth=1.0), force=(50.0, 0, 0))
    spread = bd.solve_static(bd.Model(lattice, LAW, 1.0, boundary=[held, face]))
    with pytest.warns(FaceWarning):
        alone = bd.Model(lattice, LAW, 1.0, boundary=[held, bd.Load(bd.Face("x_max"), force=(50.0, 0, 0))])
    assert np.abs(bd.solve_static(alone).displacement).max() > 4.0 * np.abs(spread.displacement).max()


def test_a_face_of_a_shape_or_of_a_grid_is_what_it_was():
    shaped = rough(bd.Box((8e-3, 6e-3, 6e-3)))
    gap = 8e-3 - shaped.particles.position[:, 0] - 0.45e-3
    np.testing.assert_array_equal(bd.Face("x_max").select(shaped), np.flatnonzero(gap <= 0.02 * 0.45e-3))
    plain = grid((5, 3, 3))
    assert len(bd.Face("x_max").select(plain)) == 9
