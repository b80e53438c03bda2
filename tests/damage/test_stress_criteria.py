"""Criteria of the stress tensor: strengths come out as they went in in homogeneous stress, cells yield on a cone."""

import functools
import math
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem._tables.columns import PlasticColumn
from bondem.damage.cohesive_softening import StressIndex
from bondem.errors import InputError, RunFileError
from tests.bits import assert_same_fracture, most_threads, threads
from tests.core.law_samples import stress_bounds
from tests.models import slowly_torn, time_step, torn_then_pressed
from tests.specimens import bar

E, RHO = 40e9, 2500.0
ROOT = math.sqrt(3.0)
GLASS = bd.DruckerPrager(tension=40e6, hydrostatic=27.8e6)
CONE = bd.DruckerPrager(tension=4e6, compression=40e6, fracture_energy=20.0)
MEAN = bd.Hydrostatic(tension=2e6)


def largest(stress, tension):
    return np.linalg.eigvalsh(stress)[:, 2] / tension


def mises(stress, limit):
    p = np.trace(stress, axis1=1, axis2=2) / 3.0
    return np.sqrt(1.5 * ((stress - p[:, None, None] * np.eye(3)) ** 2).sum(axis=(1, 2))) / limit


def undefined(stress, limit):
    """No number at some stresses that are not tried as it is made."""
    _, two, three = np.linalg.eigvalsh(stress).T
    return np.where((0.5 * limit < two) & (two < limit) & (three > 1.2 * two), np.nan, three / limit)


def test_the_largest_pressure_is_the_least_eigenvalue() -> None:
    rng = np.random.default_rng(3)
    some = [rng.standard_normal(6) + shift for shift in (-3.0, 0.0, 3.0) for _ in range(50)]
    alike = [np.array([-1.0, -1.0, p, 0.0, 0.0, 0.0]) for p in (-1.0, -1.0 + 1e-9, -2.0, 5.0)]
    for s in (*some, *alike, np.zeros(6), np.array([1.0, 1.0, -2.0, 0.0, 0.0, 0.0]) * 1e7):
        least, size = np.linalg.eigvalsh(s[[[0, 3, 4], [3, 1, 5], [4, 5, 2]]])[0], np.abs(s).max()
        bent = 10.0 * size
        opened = stress_bounds(s[:, None], np.array([bent]))[2, 0]  # less the largest pressure
        assert bent - opened == pytest.approx(max(-least, 0.0), abs=1e-7 * size)


def test_the_cone_through_two_strengths_has_the_others_of_its_closed_form() -> None:
    """Soda-lime glass, uniaxial 40 MPa and hydrostatic 27.8 MPa: biaxial 27.0, compression 981 MPa."""
    slope, k = GLASS.slope, GLASS.strength
    assert slope == pytest.approx(40.0 / (ROOT * (3.0 * 27.8 - 40.0)), rel=1e-14)
    assert k / (3.0 * slope) == pytest.approx(27.8e6, rel=1e-14)
    compression, biaxial = k / (1.0 / ROOT - slope), k / (1.0 / ROOT + 2.0 * slope)
    assert compression == pytest.approx(981.18e6, rel=1e-4)
    assert biaxial == pytest.approx(27.034e6, rel=1e-4)
    cone = StressIndex(function="cone", values=(slope, k, 0.0))
    for stress in (40e6, 0, 0), (0, biaxial, biaxial), (27.8e6, 27.8e6, 27.8e6), (0, 0, -compression), (k, 0, -k):
        assert cone.indices(np.diag(stress)[None]) == pytest.approx(1.0, rel=1e-12)
    sheared = np.array([[0.0, k, 0.0], [k, 0.0, 0.0], [0.0, 0.0, 0.0]])
    assert cone.indices(sheared[None]) == pytest.approx(1.0, rel=1e-12)
    for pair in (
        {"tension": 40e6, "compression": compression}, {"compression": compression, "hydrostatic": 27.8e6},
    ):  # fmt: skip
        other = bd.DruckerPrager(**pair)
        assert other.slope == pytest.approx(slope, rel=1e-12)
        assert other.strength == pytest.approx(k, rel=1e-12)
        assert other.softening.tension == pytest.approx(40e6, rel=1e-12)
    (slip,) = CONE.softening.slips
    assert slip.compressive() == pytest.approx(40e6, rel=1e-12)
    # on the cone under a pressure on the sides
    loaded = slip.compressive(7e6)
    stress = np.diag([-loaded, -7e6, -7e6])[None]
    cone = StressIndex(function="cone", values=(slip.slope, slip.strength, 0.0))
    assert cone.indices(stress) == pytest.approx(1.0, rel=1e-12)


def strained(failure: bd.Criterion, stress: tuple[float, float, float], nu: float) -> list[tuple[float, int, int]]:
    """A box whose walls and cells move so that its stress grows evenly and is `stress` at 1.

    Returns:
        Share of that stress, cracks, and cells that have yielded, after each step.
    """
    lattice, law, steps = bar(120), bd.CellBond(E=E, nu=nu), 400
    wanted = np.array(stress)
    strain = ((1.0 + nu) * wanted - nu * wanted.sum()) / E
    dt = time_step(bd.Model(lattice, law, density=RHO), 0.5)
    rate, walls = strain / (steps * dt), []
    for a, axis in enumerate("xyz"):
        for end, place in zip(("min", "max"), lattice.particles.envelope.bounds, strict=True):
            walls.append(bd.Drive(bd.Face(f"{axis}_{end}"), **{f"v{axis}": rate[a] * place[a]}))
    state = (model := bd.Model(lattice, law, density=RHO, failure=failure, boundary=walls)).state()
    state.set_motion(velocity=lattice.centre * rate)
    seen = []

    def look(now: bd.State, _: bd.History) -> bool:
        yielded = int((now.plastic[:, PlasticColumn.GAMMA] > 0.0).sum()) if len(now.plastic) else 0
        seen.append((now.step / steps, len(now.cracks), yielded))
        return False

    bd.solve_explicit(model, duration=1.05 * steps * dt, dt=dt, every=1, state=state, callback=look)
    return seen


def begins(seen: list[tuple[float, int, int]], column: int = 1) -> float:
    """Share of the stress at which the first facets crack, or cells yield (2); inf where none does."""
    return next((row[0] for row in seen if row[column] > 0), math.inf)


BIAXIAL, TIP = GLASS.strength / (1.0 / ROOT + 2.0 * GLASS.slope), GLASS.strength / (3.0 * GLASS.slope)
CRUSHED = GLASS.strength / (1.0 / ROOT - GLASS.slope)
STATES = {
    "bar": (GLASS, (40e6, 0.0, 0.0)), "bar across": (GLASS, (0.0, 40e6, 0.0)),
    "plane": (GLASS, (BIAXIAL, BIAXIAL, 0.0)), "all sides": (GLASS, (TIP, TIP, TIP)),
    "shear": (GLASS, (GLASS.strength, -GLASS.strength, 0.0)), "crushed": (GLASS, (-CRUSHED, 0.0, 0.0)),
    "mean, bar": (MEAN, (6e6, 0.0, 0.0)), "mean, plane": (MEAN, (3e6, 0.0, 3e6)),
    "mean, all sides": (MEAN, (2e6, 2e6, 2e6)), "largest": (bd.Rankine(tension=4e6), (4e6, 1e6, 2e6)),
    "own": (bd.StressCriterion(mises, limit=4e6), (4e6, 0.0, 0.0)),
    "own, no number": (bd.StressCriterion(undefined, limit=4e6), (3e6, 2e6, 0.0)),
    "own, shear": (bd.StressCriterion(mises, limit=4e6), (4e6 / ROOT, -4e6 / ROOT, 0.0)),
}  # fmt: skip


@pytest.mark.parametrize("case", [
    pytest.param(case, marks=pytest.mark.validate) if case in ("bar across", "mean, plane", "own, shear") else case
    for case in STATES
])  # fmt: skip
def test_facets_begin_to_crack_at_the_strength_put_in(case: str) -> None:
    """ν = 0, where stresses of cells and tractions are those of the continuum: in the very step, one behind."""
    failure, stress = STATES[case]
    first = begins(strained(failure, stress, 0.0))
    assert 1.0 < first <= 1.0051


@pytest.mark.parametrize("case", [
    "bar", "mean, all sides", *(pytest.param(one, marks=pytest.mark.validate) for one in ("plane", "all sides"))
])  # fmt: skip
def test_with_poissons_ratio_the_first_facet_cracks_a_little_earlier(case: str) -> None:
    """ν = 0.22: the stresses of 120 cells scatter, and the first of 611 facets cracks."""
    failure, stress = STATES[case]
    assert begins(strained(failure, stress, 0.22)) == pytest.approx(1.0, abs=0.06)


def test_the_cone_has_a_side_that_cracks_and_one_that_yields() -> None:
    k, slope = CONE.strength, CONE.slope
    for stress in (4e6, 0.0, 0.0), (k / (3 * slope),) * 3:
        seen = strained(CONE, stress, 0.0)
        assert 1.0 < begins(seen) <= 1.0051
        assert begins(seen, 2) == math.inf
    for stress in (-40e6, 0.0, 0.0), (-40e6 - 3e6 * (1 / ROOT + 2 * slope) / (1 / ROOT - slope), -3e6, -3e6):
        seen = strained(CONE, stress, 0.0)
        assert 1.0 < begins(seen, 2) <= 1.0051
        assert begins(seen) == math.inf


@functools.cache
def torn(failure: bd.Criterion, share: float = 0.9) -> bd.ExplicitResult:
    """A bar that is pulled apart, slowly enough for its crack."""
    softening = failure.softening
    assert softening is not None
    model, dt = slowly_torn(failure, share)
    opening = 1.2 * 2.0 * softening.fracture_energy / softening.tension or 1e-6
    return bd.solve_explicit(model, duration=(softening.tension / E * 16e-3 + opening) / 0.1, dt=dt, every=50)


OWN = bd.StressCriterion(largest, tension=4e6, fracture_energy=50.0)
SOFT = [
    bd.DruckerPrager(tension=4e6, compression=40e6, fracture_energy=50.0),
    bd.Hydrostatic(tension=4e6 / 3.0, fracture_energy=50.0), OWN,
]  # fmt: skip
ABRUPT = [bd.DruckerPrager(tension=4e6, compression=40e6), bd.Hydrostatic(tension=4e6 / 3.0)]


@pytest.mark.validate
@pytest.mark.parametrize("failure", [*SOFT[:2], OWN], ids=lambda one: type(one).__name__)
def test_a_bar_gives_back_its_fracture_energy(failure: bd.Criterion) -> None:
    """And has the strength of its closed form, slowly torn between smooth platens (as `test_strength`)."""
    test = bd.labtests.direct_tension(bar(250, 20e-3), bd.CellBond(E=E, nu=0.2), failure)
    assert test.peak == pytest.approx(4e6, rel=0.05)
    assert test.work == pytest.approx(50.0, rel=0.08)


@pytest.mark.parametrize(
    "failure", [SOFT[0], *(pytest.param(one, marks=pytest.mark.validate) for one in (*SOFT[1:], *ABRUPT))],
    ids=lambda one: type(one).__name__,
)  # fmt: skip
def test_the_ledger_closes_and_is_of_second_order(failure: bd.Criterion) -> None:
    """A quarter of the step: what breaks at once breaks otherwise in another step, and scatters from half to half."""
    coarse, fine = torn(failure), torn(failure, 0.225)
    assert len(coarse.state.cracks) > 20
    assert coarse.residual < (2e-4 if failure in SOFT else 2e-3)
    assert fine.residual < 0.35**2 * coarse.residual


def pulled(failure: bd.Criterion, steps: int = 240, **options) -> bd.ExplicitResult:
    """A body torn fast, and then pressed."""
    model, dt = torn_then_pressed(failure)
    return bd.solve_explicit(model, duration=steps * dt, dt=dt, every=0, **options)


@pytest.mark.parametrize("energy", [None, 2.0], ids=["at once", "softening"])
def test_a_function_that_repeats_rankine_breaks_the_same(energy: float | None) -> None:
    steps = 160 if energy is None else 100  # rounding grows where cracks open and close
    one = pulled(bd.Rankine(tension=4e6, fracture_energy=energy), steps).events
    other = pulled(bd.StressCriterion(largest, tension=4e6, fracture_energy=energy), steps).events
    assert len(one) > 100
    np.testing.assert_array_equal(other.bond, one.bond)
    np.testing.assert_array_equal(other.step, one.step)
    np.testing.assert_allclose(other.energy.sum(), one.energy.sum(), rtol=1e-6)


MIXED = bd.DruckerPrager(
    tension=2e6, compression=8e6, fracture_energy=2.0, dilatancy=0.1, scatter=bd.Weibull(modulus=8.0, volume=1e-9),
)  # fmt: skip


@pytest.mark.validate
def test_bits_do_not_depend_on_threads_or_restarts(tmp_path: Path) -> None:
    with threads(1):
        one = pulled(MIXED).state
    assert len(one.cracks) > 500
    assert len(one.broken) > 20
    assert (one.plastic[:, PlasticColumn.GAMMA] > 0.0).sum() > 20
    if most_threads() > 1:
        with threads(2):
            assert_same_fracture(one, pulled(MIXED).state)
    pulled(MIXED, out=tmp_path / "run.h5", save_every=100)
    assert_same_fracture(one, bd.read_run(tmp_path / "run.h5").state)


def test_a_run_by_a_function_goes_on_when_it_is_given_again(tmp_path: Path) -> None:
    kept, steps = tmp_path / "run.h5", 120
    own = bd.StressCriterion(largest, tension=2e6, scatter=bd.Normal(deviation=0.1))
    whole = pulled(own, steps).state
    assert len(whole.broken) > 20
    model = whole.model
    assert isinstance(model, bd.Model)
    dt = time_step(model, 0.9)
    bd.solve_explicit(
        model, duration=steps * dt, dt=dt, every=50, save_every=50, out=kept, callback=lambda now, _: now.step >= 50
    )
    with pytest.raises(RunFileError, match=r"largest, which a file cannot store; give it again: failure=bd\.Stress"):
        bd.resume(kept)
    other = bd.StressCriterion(largest, tension=3e6, scatter=bd.Normal(deviation=0.1))
    for wrong in (other, bd.Rankine(tension=2e6)):
        with pytest.raises(RunFileError, match="not the criterion of the run"):
            bd.resume(kept, failure=wrong)
    with pytest.raises(InputError, match="the criterion of the run"):
        bd.resume(kept, failure=largest)  # type: ignore[arg-type]
    assert_same_fracture(whole, bd.resume(kept, failure=own).state)


@pytest.mark.parametrize(
    "failure", [bd.DruckerPrager(tension=4e6, hydrostatic=2.78e6), bd.Rankine(tension=4e6)], ids=["cone", "Rankine"]
)
def test_the_facets_of_calm_cells_are_let_be_without_a_miss(
    failure: bd.Criterion, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The same cracks as where every facet is judged in every step."""
    few = pulled(failure, 100).state
    monkeypatch.setattr("bondem.damage.softening_table._WIDER", 1e-9)
    monkeypatch.setattr("bondem.damage.softening_table._NEARER", 0.0)
    monkeypatch.setattr("bondem.damage.softening_table._MARGIN", -1e6)
    every = pulled(failure, 100).state
    assert len(every.cracks) > 1000
    assert_same_fracture(few, every)
