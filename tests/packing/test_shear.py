"""Shear compaction: the walls do what they are told, grains stay within, energy closes; order is found out."""

import importlib.util
import math
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from bondem.packing.shear import Compaction, compact

BOX = bd.Box(size=(1.0, 0.8, 0.8))
CYLINDER = bd.Cylinder(radius=0.4, length=1.0)
BOTH = [pytest.param(BOX, id="box"), pytest.param(CYLINDER, id="cylinder", marks=pytest.mark.validate)]
CYCLES = 3
# of the recipe: strain to either side, inertial number, pressure over modulus, cycles after the radii are fitted
STRAIN, INERTIAL, SOFT, FITTING = 0.1, 0.01, 1e-3, 2


def draw(seed: int = 1) -> np.random.Generator:
    return np.random.Generator(np.random.Philox(seed))


@pytest.fixture(scope="module", params=BOTH)
def compacted(request) -> tuple[bd.Box | bd.Cylinder, Compaction]:
    random = draw()
    return request.param, compact(request.param, bd.Uniform(0.25).radii(300, random), random, cycles=CYCLES)


def stages(done: Compaction) -> list[slice]:
    """Records of the first run, and of that with the radii that fill the shape: the time stands still between."""
    second = 1 + int(np.flatnonzero(np.diff(done.history.time) == 0.0)[0])
    return [slice(0, second), slice(second, None)]


def test_the_pressure_wall_holds_the_pressure(compacted):
    shape, done = compacted
    pressure = done.history["pressure"][:, 0] * shape.bounds[1][0] / shape.volume
    last = pressure[-len(pressure) // 3 :]
    assert last.mean() == pytest.approx(1.0, abs=0.03)
    assert last.std() < 0.3
    # and goes on giving way: it is pushed out where the shear walls come in
    end = stages(done)[1]
    wall, shear = done.history["pressure wall"][end, 0], done.history["shear wall"][end]
    inwards = shear[:, 0 if isinstance(shape, bd.Cylinder) else 1]
    assert np.corrcoef(wall, inwards)[0, 1] < -0.9
    assert done.length == pytest.approx(shape.bounds[1][0], rel=0.03)


def test_the_shear_walls_move_as_a_sine(compacted):
    shape, done = compacted
    across = shape.bounds[1][1] - shape.bounds[0][1]
    amplitude = 0.5 * STRAIN * across * (0.5 if isinstance(shape, bd.Cylinder) else 1.0)
    column = 0 if isinstance(shape, bd.Cylinder) else 1
    # the rate is set by the radii of the first run, which fill 64 % of the shape
    scale = (0.64 * shape.volume / (4.0 / 3.0 * math.pi * (done.radius**3).sum())) ** (1.0 / 3.0)
    period = 2.0 * math.pi * STRAIN / INERTIAL * 2.0 * scale * done.radius.mean()
    for part, cycles in zip(stages(done), (CYCLES - FITTING, FITTING), strict=True):
        time, moved = done.history.time[part], done.history["shear wall"][part][:, column]
        # begins where the first chord of 32 a cycle, on which the first record lies, leaves zero
        first = np.flatnonzero(moved)[0]
        begin = time[first] + moved[first] / amplitude / math.sin(2.0 * math.pi / 32.0) * period / 32.0
        phase = np.clip((time - begin) / period, 0.0, cycles)
        # a chord is (2 π / 32)² / 8 off the sine
        assert moved == pytest.approx(-amplitude * np.sin(2.0 * math.pi * phase), abs=0.006 * amplitude)
        # and rest for a period, less what is left of a record
        assert (time[-1] - begin) / period == pytest.approx(cycles + 1, abs=0.05)
    assert np.abs(done.history["shear"]).max() > 0.0


def test_no_sphere_gets_out_and_overlaps_are_those_of_the_pressure(compacted):
    shape, done = compacted
    mean, x = done.radius.mean(), done.position[:, 0]
    beside = np.column_stack([np.full(len(x), 0.5 * shape.bounds[1][0]), done.position[:, 1:]])
    depth = np.minimum(np.minimum(x, done.length - x), shape.depth(beside))
    assert ((depth - done.radius) / mean).min() > -20.0 * SOFT
    lattice = bd.connect(bd.Particles(done.position, done.radius))
    # a contact bears p d² with a stiffness of π E R / 2
    typical = 8.0 / math.pi * SOFT
    overlap = (done.radius[lattice.pairs].sum(axis=1) - lattice.length) / mean
    assert 0.5 * typical < overlap.mean() < 2.0 * typical
    assert overlap.max() < 10.0 * typical


def test_the_energy_ledger_closes(compacted):
    _, done = compacted
    for part in stages(done):
        energy = {name: values[part] for name, values in done.history.energy.items()}
        balance = energy["balance"] - energy["balance"][0]
        assert np.abs(balance).max() < 0.03 * np.abs(energy["work"]).max()
        assert energy["loss"][-1] == pytest.approx(energy["work"][-1], rel=0.1)
        assert energy["translation"][-1] < 1e-3 * energy["contact"][-1]


@pytest.mark.validate
def test_same_seed_same_bits_and_the_share_done_rises():
    def once(seed: int, shares: list[float]) -> Compaction:
        random = draw(seed)
        return compact(BOX, bd.Uniform(0.25).radii(40, random), random, cycles=1, on_share=shares.append)

    shares: list[float] = []
    one, two = once(3, shares), once(3, [])
    np.testing.assert_array_equal(one.position, two.position)
    np.testing.assert_array_equal(one.history.records, two.history.records)
    assert shares[-1] == 1.0
    assert (np.diff(shares) >= 0.0).all()


@pytest.mark.validate
@pytest.mark.parametrize("shape", BOTH)
def test_a_packing_by_shear_is_on_target_and_in_the_shape(shape, monkeypatch):
    monkeypatch.setitem(compact.__kwdefaults__, "cycles", CYCLES)
    packed = bd.pack(shape, count=250, spread=0.25, method="shear", seed=2)
    assert len(packed) == 250
    assert bd.connect(packed).coordination_number == pytest.approx(6.2, abs=0.02)
    gap = (shape.depth(packed.position) - packed.radius) / packed.mean_radius
    assert gap.min() > -1e-12
    assert np.ptp(packed.radius / packed.mean_radius) == pytest.approx(0.25, rel=0.02)


@pytest.mark.parametrize(
    ("shape", "count", "says"),
    [
        (bd.Ball(1.0), 300, "fills Box and Cylinder, .* use another method"),
        (bd.Cell((1.0, 1.0, 1.0)), 300, "fills Box and Cylinder, .* use another method"),
        (bd.Box((1.0, 0.1, 0.1)), 12, "too large .* ask for more spheres or a wider shape"),
        (bd.Cylinder(0.05, 1.0), 12, "too large .* ask for more spheres or a wider shape"),
    ],
)
def test_what_it_cannot_do_is_said(shape, count, says):
    with pytest.raises(InputError, match=says):
        bd.pack(shape, count=count, spread=0.25, method="shear")


def by_shear(kappa: float, count: int, seed: int) -> bd.Fabric:
    packed = bd.pack(bd.Box((1.0, 1.0, 1.0)), count=count, spread=kappa, method="shear", seed=seed)
    return bd.fabric(bd.connect(packed))


@pytest.mark.validate
@pytest.mark.parametrize("seed", [1, 2])
def test_dispersed_spheres_pass_where_equal_ones_are_refused(seed):
    """André et al. (2012), §4.2: a dispersion of radii is what keeps order away. In a cube of 1000; a minute each."""
    equal, dispersed = by_shear(0.0, 1000, seed), by_shear(0.25, 1000, seed)
    assert not equal.passed
    assert equal.core_rms_excess > 1.0
    assert dispersed.passed, dispersed.reasons


@pytest.mark.validate
def test_the_example_shows_the_walls_at_work(tmp_path):
    path = Path(__file__).parents[2] / "examples" / "shear_compaction.py"
    spec = importlib.util.spec_from_file_location("shear_compaction", path)
    example = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(example)
    course = example.main(count=200, cycles=2, folder=tmp_path)
    assert course.fraction[0] < 0.4
    assert 0.52 < course.fraction[-1] < 0.62
    assert course.reached[0] == pytest.approx(1.0, abs=0.05)
    for part, centre in zip(course.parts, course.frames[1:], strict=True):
        wide = course.width + part["sway"][-1, 0], course.width, course.top + part["platen"][-1, 2]
        out = np.maximum(course.radius[:, None] - centre, centre + course.radius[:, None] - wide)
        assert out.max() < 0.05 * example.RADIUS
    assert len(list(tmp_path.glob("grains_*.vtkhdf"))) == 3
    kept = bd.read_particles(tmp_path / "grains_02.vtkhdf")
    np.testing.assert_allclose(kept.position, course.frames[-1])
    example.draw_compaction(tmp_path / "course.png", course)
    assert (tmp_path / "course.png").stat().st_size > 50_000
