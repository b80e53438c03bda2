"""What strengths mean with the elements there are: closed forms, warnings, who is nearest to failure."""

import math
import re
import warnings
from collections.abc import Callable

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError, StrengthWarning
from bondem.observables.crack_index import yield_index
from tests.specimens import bar, cubes

STONE = bd.CellBond(E=50e9, nu=0.0)
SIDE, SHAPE = 1e-3, (6, 5, 5)


def cells(failure: bd.Criterion, law: bd.CellBond = STONE, density: float = 2600.0) -> bd.Model:
    return bd.Model(cubes(SHAPE, SIDE), law, density, failure=failure)


def stretched(model: bd.Model, strain: float) -> bd.State:
    """Uniform strain along x."""
    state = model.state()
    place = model.lattice.centre.copy()
    place[:, 0] *= 1.0 + strain
    state.set_pose(position=place)
    return state


def test_a_given_fracture_energy_is_told_with_its_toughness() -> None:
    found = bd.explain(cells(bd.Rankine(tension=10e6, fracture_energy=50.0))).implied
    assert (found.softens, found.strength, found.fracture_energy) == (True, pytest.approx(10e6), 50.0)
    assert pytest.approx(50e9) == found.E
    assert found.density == pytest.approx(2600.0)
    assert found.length == pytest.approx(SIDE)
    assert found.toughness == pytest.approx(math.sqrt(50e9 * 50.0))
    assert found.irwin == pytest.approx(25e-3)
    assert found.extent == pytest.approx(6e-3)


@pytest.mark.parametrize(
    "failure", [bd.Rankine(tension=40e6), bd.MohrCoulomb(tension=40e6, cohesion=90e6, friction_angle=0.6),
                bd.MohrCoulomb(tension=90e6, cohesion=40e6 * math.tan(0.6), friction_angle=0.6)]
)  # fmt: skip
def test_brittle_cells_have_the_toughness_of_their_size(failure: bd.Criterion) -> None:
    """A facet holds f_t² L / 2E, and K_Ic = f_t √L; of a cone whose tip is below the cut-off f_t is the tip."""
    found = bd.explain(cells(failure)).implied
    assert found.bond_energy == pytest.approx((40e6) ** 2 * SIDE / (2.0 * 50e9))
    assert found.toughness == pytest.approx(40e6 * math.sqrt(SIDE))
    assert not found.softens


def test_beams_hold_what_it_takes_to_stretch_them_until_they_break() -> None:
    """A row of springs EA/L that break at N = f A: each holds f² L / 2E of its own area."""
    x = np.zeros((200, 3))
    x[:, 0] = SIDE * (np.arange(200) + 0.5)
    box = bd.Box((200 * SIDE, SIDE, SIDE)).moved((0.0, -0.5 * SIDE, -0.5 * SIDE))
    row = bd.connect(bd.Particles(x, 0.5 * SIDE, shape=box), reach=1.1)
    law = bd.ContactBond(E=1e9, nu=0.2, radius_ratio=0.5, kappa=1e9)
    area, tension = math.pi * (0.25 * SIDE) ** 2, 2e6
    force = tension * area
    kn = 1e9 * area / SIDE
    for failure in (
        bd.PeripheralStress(tension=tension, shear=1e9),
        bd.LinearSum(force=force, shear=1.0, bending=1.0, twisting=1.0),
        bd.Elliptic(elongation=tension / 1e9, rotation=0.1),
    ):
        model = bd.Model(row, law, 1000.0, failure=failure)
        found = bd.explain(model).implied
        assert found.strength == pytest.approx(tension, rel=1e-6)
        assert found.bond_energy == pytest.approx(tension**2 * SIDE / 2e9, rel=1e-6)
        stored = 199 * (0.5 * force**2 / kn) * SIDE
        assert found.fracture_energy == pytest.approx(stored / (2.0 * 200 * SIDE**3), rel=1e-6)
        # E of an isotropic lattice of springs: N/6 with N = Σ L² k_n / V
        assert pytest.approx(199 * SIDE**2 * kn / (200 * SIDE**3) / 6.0, rel=1e-6) == found.E


DOUBTED = {
    "more than about a tenth": bd.Rankine(tension=6e9, fracture_energy=1e6),
    "fracture energy of 5.1e+04 J/m²": bd.Rankine(tension=1.6e9),
    "hardly anything will break": bd.Rankine(tension=10e6, fracture_energy=2000.0),
}


@pytest.mark.parametrize("message", DOUBTED)
def test_strengths_that_no_stone_has_are_doubted_before_the_run(message: str) -> None:
    with pytest.warns(StrengthWarning, match=re.escape(message)) as told:
        model = cells(DOUBTED[message])
    assert [one.filename for one in told] == [__file__]
    assert "\n" not in str(told[0].message)
    assert message in str(bd.explain(model))


def test_what_is_usual_or_no_stone_is_not_doubted() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        cells(bd.Rankine(tension=4e6, fracture_energy=100.0))
        cells(bd.Rankine(tension=1e30))  # meant never to break
        cells(bd.Rankine(tension=50e6, fracture_energy=5e3), bd.CellBond(E=2e9, nu=0.0))  # a polymer
        cells(bd.Rankine(tension=500e6, fracture_energy=1e5), bd.CellBond(E=210e9, nu=0.0), 7850.0)  # steel


@pytest.mark.filterwarnings("ignore:Rankine. fracture_energy = 0.1:bondem.errors.UnitWarning")  # doubted here too
def test_doubts_name_what_is_not_resolved_and_what_governs() -> None:
    def of(**strength: float) -> str:
        return " ".join(bd.explain(cells(bd.Rankine(**strength))).doubts)

    assert "not resolved" in of(tension=50e6, fracture_energy=50.0)  # 1 mm, an element
    assert "strength governs" in of(tension=10e6, fracture_energy=50.0)  # 25 mm of 6
    assert of(tension=25e6, fracture_energy=50.0) == ""  # 4 mm
    assert "surfaces of a solid" in of(tension=1e6, fracture_energy=0.1)
    assert "without a fracture energy" in of(tension=40e6)
    assert "32 J/m² per mm" in of(tension=40e6)


def test_who_is_nearest_is_named() -> None:
    """Uniform tension at ν = 0: facets of inner cells across it bear E ε; levers are multiples of 2e-9 of a cell."""
    model = cells(bd.Rankine(tension=10e6, fracture_energy=50.0))
    state = stretched(model, 1e-4)
    index = bd.failure_index(model, state)
    i, j = model.lattice.pairs.T
    x = model.lattice.centre / SIDE
    inner = ((x > 1.0) & (x < [5.0, 4.0, 4.0])).all(axis=1)
    across = np.abs(model.lattice.facets.normal[:, 0]) > 0.5
    both = inner[i] & inner[j]
    np.testing.assert_allclose(index[both & across], 0.5, rtol=1e-7)
    np.testing.assert_allclose(index[both & ~across], 0.0, atol=1e-7)  # not pulled
    told = bd.explain(model, state, most=3)
    np.testing.assert_allclose(told.index, np.sort(index)[:-4:-1])
    np.testing.assert_allclose(index[told.nearest], told.index)
    np.testing.assert_array_equal(told.position, model.lattice.facets.centroid[told.nearest])
    assert (told.broken, told.softening, told.yielding) == (0, 0, 0.0)
    for facet in told.nearest:
        assert f"facet {facet} between {i[facet]} and {j[facet]}" in str(told)
    assert len(bd.explain(model, model.state()).nearest) == 0
    assert "no facet is pulled" in str(bd.explain(model, model.state()))


def test_facets_begin_to_crack_where_their_index_is_one() -> None:
    """In a run: below 1 before anything cracks, and what cracks first was within a few steps' loading of it."""
    body = bar(60, 8e-3)
    pull = bd.Drive(bd.Face("x_max"), vx=bd.Ramp(0.0, 0.02, 2e-5))
    soft = bd.Rankine(tension=5e6, fracture_energy=50.0)
    model = bd.Model(
        body, bd.CellBond(E=50e9, nu=0.2), 2600.0, [bd.Fix(bd.Face("x_min"), translation="x", rotation=""), pull],
        failure=soft,
    )  # fmt: skip
    states = []

    def watch(state: bd.State, _: bd.History) -> bool:
        states.append(state.copy())
        return bool((state.integrity < 1.0).any())

    bd.solve_explicit(model, duration=1e-3, every=1, callback=watch)
    before, after = states[-2:]
    index = bd.failure_index(model, before)
    assert 0.99 < index.max() < 1.01
    first = after.layout.bond_order[after.integrity < 1.0]
    assert (index[first] > 0.99).all()
    assert (bd.failure_index(model, states[len(states) // 2]) < 0.9).all()


def test_softening_and_broken_facets_are_counted() -> None:
    model = cells(bd.Rankine(tension=10e6, fracture_energy=50.0))
    state = model.state()
    state.integrity[:3], state.integrity[3:5] = 0.0, 0.4
    told = bd.explain(model, state)
    assert (told.broken, told.softening) == (3, 2)
    assert told.index[:2].tolist() == [1.0, 1.0]
    assert set(told.nearest[:2]) == set(state.layout.bond_order[3:5])


def test_cells_nearest_to_yielding_are_told() -> None:
    """Uniaxial compression at ν = 0: |σ| (1 - sin φ) / 2 c cos φ."""
    c, phi = 10e6, 0.5
    model = cells(bd.MohrCoulomb(tension=50e6, cohesion=c, friction_angle=phi, fracture_energy=200.0))
    index = yield_index(model, stretched(model, -2e-4))
    x = model.lattice.centre / SIDE
    inner = ((x > 1.0) & (x < [5.0, 4.0, 4.0])).all(axis=1)
    wanted = 10e6 * (1.0 - math.sin(phi)) / (2.0 * c * math.cos(phi))
    np.testing.assert_allclose(index[inner], wanted, rtol=1e-7)
    assert bd.explain(model, stretched(model, -2e-4)).yielding >= wanted * (1.0 - 1e-7)


def test_bonds_are_explained_by_their_own_index() -> None:
    body = cubes(SHAPE, SIDE)
    lattice = bd.Lattice(body.particles, body.pairs)
    model = bd.Model(
        lattice, bd.EulerBernoulli(E=1e9, nu=0.2, radius_ratio=0.5), 1000.0,
        failure=bd.PeripheralStress(tension=1e6, shear=1e6),
    )  # fmt: skip
    told = bd.explain(model, stretched(model, 5e-4))
    np.testing.assert_allclose(told.index, 0.5, rtol=1e-2)
    assert "bond" in str(told)
    assert "facet" not in str(told)


REFUSED: dict[str, tuple[str, Callable[[], object]]] = {
    "no criterion": ("give it failure=", lambda: bd.explain(bd.Model(cubes(SHAPE, SIDE), STONE, 2600.0))),
    "no model": ("give bd.Model", lambda: bd.explain(None)),
    "another state": (
        "another lattice",
        lambda: bd.explain(cells(bd.Rankine(tension=1e6)), bd.Model(cubes((3, 3, 3), SIDE), STONE, 2600.0).state()),
    ),
    "no count": ("most = -1", lambda: bd.explain(cells(bd.Rankine(tension=1e6)), most=-1)),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_cannot_be_explained_is_refused_in_one_line(name: str) -> None:
    message, ask = REFUSED[name]
    with pytest.raises(InputError, match=message) as caught:
        ask()
    assert "\n" not in str(caught.value)
