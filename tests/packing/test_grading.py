"""Cells of sizes that differ from place to place: sizes, moduli, bits, and what is refused."""

from functools import cache

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from bondem.interactions.cells.cell_strain import CellStrain
from bondem.observables.surface_displacement import surface_displacement
from bondem.packing.grading import MOST_CELLS, cells_of, sites, sizes_by
from tests.bits import most_threads, threads

BAR = (0.2, 0.1, 0.05)
SLOT = bd.Box((2e-3, 0.03, 1.0)).moved((0.099, -1e-6, -0.5))
NOTCHED = bd.Box(BAR).cut(SLOT, name="notch")
LIGAMENT = bd.Box((2e-3, 0.07, 0.05)).moved((0.099, 0.03, 0.0))
FIELD = bd.Graded(fine=4e-3, coarse=16e-3, about=LIGAMENT, growth=0.3)


@cache
def body(shape: bd.Shape, size, seed: int = 1) -> bd.Lattice:
    return bd.connect(bd.pack(shape, size=size, method="even", seed=seed, cache=False), method="laguerre")


def size_of(lattice: bd.Lattice) -> np.ndarray:
    return np.cbrt(lattice.cells.volume)


def test_sizes_are_those_that_were_asked_for():
    """Whole classes of cells within 10 %, single ones within a third; sizes span nearly the whole range."""
    bar = body(NOTCHED, FIELD)
    wanted, found = FIELD(bar.centre), size_of(bar)
    over = found / wanted
    for lower, upper in ((4e-3, 5e-3), (5e-3, 9e-3), (9e-3, 15e-3), (15e-3, 17e-3)):
        some = (wanted >= lower) & (wanted < upper)
        assert some.sum() > 10
        assert over[some].mean() == pytest.approx(1.0, abs=0.1)
    assert np.abs(over - 1.0).max() < 0.35
    assert over.std() < 0.08
    assert found.max() / found.min() > 3.0


def test_there_are_as_many_cells_as_sizes_fill_the_shape_with():
    def slab(x):
        return 4e-3 + 0.2 * np.abs(x[:, 0] - 0.1)

    # ∫ dV / h³ over x from both sides: A / 0.2 · (h0⁻² - h1⁻²)
    expected = BAR[1] * BAR[2] / 0.2 * (4e-3**-2 - 24e-3**-2)
    assert len(body(bd.Box(BAR), slab).particles) == pytest.approx(expected, rel=0.01)


@pytest.mark.parametrize("shape", [NOTCHED, bd.Cylinder(0.05, 0.15), bd.Ball(0.07)], ids=["notch", "bar", "ball"])
def test_cells_fill_the_shape_and_centres_are_at_centroids(shape):
    field = bd.Graded(fine=5e-3, coarse=15e-3, about=(0.05, 0.04, 0.02))
    lattice = body(shape, field)
    assert lattice.cells.volume.sum() == pytest.approx(shape.volume, rel=2e-3)
    off = np.linalg.norm(lattice.cells.centroid - lattice.particles.position, axis=1) / size_of(lattice)
    assert off.mean() < 0.06
    assert off.max() < 0.25
    assert lattice.connected.all()


def test_one_size_is_a_count():
    one = bd.pack(bd.Box(BAR), size=10e-3, method="even", seed=2)
    np.testing.assert_array_equal(one.position, bd.pack(bd.Box(BAR), count=1000, method="even", seed=2).position)
    assert len(bd.pack(bd.Cell((0.1, 0.1, 0.1)), size=10e-3, method="even")) == 1000
    assert len(bd.pack(bd.Box(BAR), size=lambda x: np.ones(len(x)), method="even")) == 1


def test_bits_depend_on_the_seed_and_on_nothing_else():
    def packed(seed, count):
        with threads(count):
            return bd.pack(NOTCHED, size=FIELD, method="even", seed=seed, cache=False)

    first, second, other = packed(1, 1), packed(1, most_threads()), packed(2, most_threads())
    np.testing.assert_array_equal(first.position, second.position)
    np.testing.assert_array_equal(first.radius, second.radius)
    assert len(first) == len(other)
    assert not np.allclose(first.position, other.position)


def test_spheres_can_be_given_again():
    """They do not overlap by half the smaller radius, as `Particles` wants it, and are refused by nothing else."""
    packed = body(NOTCHED, FIELD).particles
    again = bd.Particles(packed.position, packed.radius)
    np.testing.assert_array_equal(again.radius, packed.radius)


@pytest.mark.filterwarnings("ignore:CellBond. E = :bondem.errors.UnitWarning")  # in units of its own
def test_a_uniform_strain_has_its_tractions():
    """The patch test: 1e-12 of E, as in bodies of equal cells."""
    bar = body(NOTCHED, FIELD)
    x = bar.particles.position
    strain = np.array([[1.0, 0.3, -0.2], [0.3, -0.5, 0.4], [-0.2, 0.4, 0.7]])
    model = bd.Model(bar, bd.CellBond(E=3.0, nu=0.0), 1.0)
    moved = x @ strain
    found = CellStrain.of(bar, model.cell_constants, moved, np.zeros_like(x))
    traction = found.forces(bar, model.cell_constants) / bar.facets.area[:, None]
    assert np.abs(traction - 3.0 * bar.facets.normal @ strain).max() <= 2e-12 * 3.0


def test_a_graded_bar_has_the_moduli_of_its_material():
    """Between smooth platens, by their work and by what its sides do: E and ν within 0.3 %."""
    E, nu, pull = 40e9, 0.2, 1e-6
    field = bd.Graded(fine=4e-3, coarse=16e-3, about=bd.Box((1e-3, 0.1, 0.05)).moved((0.1, 0.0, 0.0)))
    bar = body(bd.Box(BAR), field)
    ends = [bd.Fix(bd.Face("x_min"), translation="x", rotation=""), bd.Drive(bd.Face("x_max"), x=pull)]
    model = bd.Model(bar, bd.CellBond(E=E, nu=nu), 1.0, boundary=ends)
    found = bd.solve_static(model)
    assert 2.0 * found.energy.total * BAR[0] / (BAR[1] * BAR[2] * pull**2) == pytest.approx(E, rel=3e-3)
    free = bar.cells.free
    moved = surface_displacement(model, found.displacement, found.rotation)
    narrowed = []
    for axis, width in ((1, BAR[1]), (2, BAR[2])):
        mean = [np.average(moved[on, axis], weights=free.area[on])
                for on in (bar.on_face(f"{'xyz'[axis]}_{side}") for side in ("min", "max"))]  # fmt: skip
        narrowed.append((mean[0] - mean[1]) / width)
    np.testing.assert_allclose(np.array(narrowed) / (pull / BAR[0]), nu, rtol=3e-3)


def test_work_grows_with_the_cells_whatever_the_sizes():
    """A large range of sizes costs no more a cell: halving into cubes, and looking for neighbours."""
    wide = bd.Graded(fine=1e-3, coarse=40e-3, about=(0.1, 0.05, 0.025), growth=0.5)
    places = sites(bd.Box(BAR), wide)
    assert len(places.cells) < 30 * places.count + 1000
    assert places.cells.sum() == pytest.approx(places.count)
    assert len(body(bd.Box(BAR), wide).particles) == places.count


def test_the_function_is_the_class():
    field = bd.Graded(fine=6e-3, coarse=16e-3, about=[(0.1, 0.05, 0.02), (0.1, 0.08, 0.02)], growth=0.4)
    by_function = bd.pack(bd.Box(BAR), size=lambda x: field(x), method="even", seed=1)
    np.testing.assert_array_equal(by_function.position, body(bd.Box(BAR), field).particles.position)
    np.testing.assert_allclose(field(np.array([(0.1, 0.05, 0.03), (0.0, 0.0, 0.0)])), [10e-3, 16e-3])


BAD = {
    "fine is nothing": ("a positive size", lambda: bd.Graded(0.0, 1.0, (0, 0, 0))),
    "coarse is negative": ("a positive size", lambda: bd.Graded(1.0, -1.0, (0, 0, 0))),
    "fine above coarse": ("above coarse", lambda: bd.Graded(2.0, 1.0, (0, 0, 0))),
    "no growth": ("growth", lambda: bd.Graded(1.0, 2.0, (0, 0, 0), growth=0.0)),
    "too steep": ("up to 1", lambda: bd.Graded(1.0, 2.0, (0, 0, 0), growth=2.0)),
    "no place": ("a shape, or points", lambda: bd.Graded(1.0, 2.0, "ligament")),
    "a plane of points": ("a shape, or points", lambda: bd.Graded(1.0, 2.0, (0.0, 0.0))),
    "everywhere": ("periodic", lambda: bd.Graded(1.0, 2.0, bd.Cell((1, 1, 1)))),
    "neither": ("count=.*or size=", lambda: bd.pack(bd.Box(BAR), method="even")),
    "both": ("either count=", lambda: bd.pack(bd.Box(BAR), count=10, size=0.01, method="even")),
    "another method": ('method="even"', lambda: bd.pack(bd.Box(BAR), size=0.01)),
    "with a spread": ("leave out", lambda: bd.pack(bd.Box(BAR), size=0.01, spread=0.2, method="even")),
    "not a size": ("a positive size", lambda: bd.pack(bd.Box(BAR), size=-0.01, method="even")),
    "text": ("a positive size", lambda: bd.pack(bd.Box(BAR), size="fine", method="even")),
    "too many": ("larger size", lambda: bd.pack(bd.Box(BAR), size=1e-5, method="even")),
    "too many somewhere": (f"more than {MOST_CELLS}", lambda: bd.pack(
        bd.Box(BAR), size=bd.Graded(1e-9, 1e-2, LIGAMENT), method="even")),
    "graded for ever": ("one size", lambda: bd.pack(bd.Cell((0.1,) * 3), size=FIELD, method="even")),
    "one number for all": (r"sizes \(k,\)", lambda: bd.pack(bd.Box(BAR), size=lambda x: 0.01, method="even")),
    "no numbers": ("positive sizes", lambda: bd.pack(bd.Box(BAR), size=lambda x: x[:, 0] - 1.0, method="even")),
    "no function of points": ("failed", lambda: bd.pack(bd.Box(BAR), size=lambda x: x["h"], method="even")),
    "a jump": ("let it change", lambda: bd.pack(
        bd.Box(BAR), size=lambda x: np.where(x[:, 0] < 0.1, 5e-3, 30e-3), method="even")),
}  # fmt: skip


@pytest.mark.parametrize("bad", BAD)
def test_bad_input_is_refused_in_one_line(bad):
    message, made = BAD[bad]
    with pytest.raises(InputError, match=message) as caught:
        made()
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("size", [np.nan, np.inf, 1e-300, 1e300, True, 1j, None.__class__, b"1", [0.01], {}])
def test_no_size_is_refused_in_one_line(size):
    with pytest.raises(InputError) as caught:
        bd.pack(bd.Box(BAR), size=size, method="even")
    assert "\n" not in str(caught.value)


def test_counts_of_sizes():
    assert cells_of(1e-2, 1e-3) == 1000
    assert sizes_by(FIELD)(np.array([[0.1, 0.05, 0.02]])) == pytest.approx(4e-3)
