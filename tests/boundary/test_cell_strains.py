"""Stress-free strains of cells that change in an explicit run: heat, shrinkage, and what they break."""

import itertools
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from tests.bits import threads
from tests.elastic_energy import elastic_energy
from tests.specimens import bar
from validation.studies.eigenstrain_fields import bent

E, NU, RHO = 1e9, 0.2, 1e3
LAW = bd.CellBond(E=E, nu=NU)
LENGTH = 3.0
ENDS = [bd.Fix(bd.Face(name), translation="x", rotation="") for name in ("x_min", "x_max")]
NEAR = {"near": bd.Gauge(bd.Face("x_min"), "force")}
WARM = bd.Within(bd.Box((1.4, 9.0, 9.0)).moved((0.9, -4.0, -4.0)))


@pytest.fixture(scope="module")
def body() -> bd.Lattice:
    return bar(300, LENGTH, 1.0)


def heated(strain: float, rise: float, region: bd.Region | None = None) -> bd.Eigenstrain:
    return bd.Eigenstrain(strain, bd.Everything() if region is None else region, schedule=bd.Ramp(0.0, 1.0, rise))


def test_a_bar_between_walls_bears_minus_e_times_strain(body: bd.Lattice) -> None:
    """Cells at the walls reach for them with their own strain: without that 7 % are missing here."""
    static = bd.solve_static(bd.Model(body, LAW, RHO, boundary=[*ENDS, bd.Eigenstrain(1e-3)]))
    assert static.reaction[:, 0].clip(0.0).sum() == pytest.approx(E * 1e-3, rel=1e-3)
    planes = [bd.Fix(bd.Face(f"{axis}_min"), translation=axis, rotation="") for axis in "yz"]
    model = bd.Model(body, LAW, RHO, boundary=[*ENDS, *planes, bd.Eigenstrain(1e-3)])
    bent = bd.solve_static(model, nonlinear=True)
    assert bent.reaction[:, 0].clip(0.0).sum() == pytest.approx(E * 1e-3, rel=3e-3)
    assert bent.energy.total == pytest.approx(0.5 * E * 1e-6 * LENGTH, rel=3e-3)


def test_a_slow_run_ends_in_the_static_solution(body: bd.Lattice) -> None:
    """Heated in the middle between walls, and all around free: displacements, and stresses of the cells."""
    model = bd.Model(body, LAW, RHO, boundary=[*ENDS, heated(1e-3, 0.1, WARM)])
    static = bd.solve_static(model)
    run = bd.solve_explicit(model, duration=0.3, damping=bd.LocalDamping(0.3), every=1000)
    # of the order of the strain, as the run is of large displacements
    far = np.abs((run.state.displacement - static.displacement)[:, 0]).max()
    assert far < 2e-3 * np.abs(static.displacement).max()
    ours, theirs = (bd.cell_stress(model, one)[:, 0, 0] for one in (run.state, static))
    assert np.abs(ours - theirs).max() < 2e-3 * np.abs(theirs).max()
    assert elastic_energy(model, run.state).total == pytest.approx(static.energy.total, rel=1e-3)


def test_energy_is_kept_to_second_order(body: bd.Lattice) -> None:
    """Heated in a time in which waves run to and fro, with one wall that moves."""
    drive = bd.Drive(bd.Face("x_max"), x=bd.Ramp(0.0, 1e-3, 5e-3))
    warm, cold = heated(2e-3, 6e-3, WARM), bd.Eigenstrain(-1e-3, schedule=bd.Ramp(0.0, 1.0, 4e-3))
    model = bd.Model(body, LAW, RHO, boundary=[ENDS[0], drive, warm, cold])
    missed = [bd.solve_explicit(model, duration=1e-2, safety=s, every=1).residual for s in (0.8, 0.4, 0.2)]
    assert missed[0] < 3e-3
    for coarse, fine in itertools.pairwise(missed):
        assert 3.4 < coarse / fine < 4.7


def test_a_free_body_grows_without_stress(body: bd.Lattice) -> None:
    model = bd.Model(body, LAW, RHO, boundary=[heated(1e-2, 0.1)])
    run = bd.solve_explicit(model, duration=0.4, damping=bd.LocalDamping(0.7))
    # local damping may turn it as a whole: what it has been stretched by, along its three main axes
    before, after = (one - one.mean(axis=0) for one in (body.centre, body.centre + run.state.displacement))
    stretch = np.linalg.svd(np.linalg.lstsq(before, after, rcond=None)[0], compute_uv=False)
    np.testing.assert_allclose(stretch - 1.0, 1e-2, rtol=1e-6)
    assert np.abs(bd.cell_stress(model, run.state)).max() < 1e-6 * E * 1e-2


@pytest.mark.validate
def test_shrinkage_cracks_a_bar_between_walls(body: bd.Lattice) -> None:
    """It cracks as E times the strain is its strength, through one section, for G_f times that."""
    strength, energy = 1e6, 900.0
    failure = bd.Rankine(tension=strength, fracture_energy=energy)
    model = bd.Model(body, LAW, RHO, failure=failure, boundary=[*ENDS, heated(-5e-3, 1.0)])
    run = bd.solve_explicit(model, duration=1.0, gauges=NEAR, damping=bd.LocalDamping(0.3), every=20)
    pull = np.abs(run.history["near"][:, 0])
    assert pull.max() == pytest.approx(strength, rel=0.03)
    assert run.history.time[np.argmax(pull)] == pytest.approx(strength / E / 5e-3, rel=0.05)
    assert run.history.released[-1] == pytest.approx(energy, rel=0.25)
    assert run.residual < 1e-3
    assert pull[-1] < 0.1 * strength


def test_heat_makes_cells_yield_between_walls(body: bd.Lattice) -> None:
    """The reaction stays at the strength of uniaxial compression, 2 c cos φ / (1 - sin φ)."""
    failure = bd.MohrCoulomb(tension=1e6, cohesion=1e6, friction_angle=0.5, fracture_energy=900.0,
                             fracture_energy_shear=1e9)  # fmt: skip
    model = bd.Model(body, LAW, RHO, failure=failure, boundary=[*ENDS, heated(6e-3, 0.5)])
    run = bd.solve_explicit(model, duration=0.6, gauges=NEAR, damping=bd.LocalDamping(0.3), every=20)
    push = np.abs(run.history["near"][:, 0])
    assert push.max() == pytest.approx(2e6 * np.cos(0.5) / (1.0 - np.sin(0.5)), rel=0.02)
    assert run.state.slipped.max() > 1e-3
    assert run.residual < 1e-4


@pytest.mark.parametrize("failure", [None, bd.MohrCoulomb(tension=1e6, cohesion=1e6, friction_angle=0.5,
                                                          fracture_energy=900.0)])  # fmt: skip
def test_pauses_files_and_threads_leave_no_trace(
    body: bd.Lattice, tmp_path: Path, failure: bd.Criterion | None
) -> None:
    strains = [heated(4e-3, 0.02, WARM), bd.Eigenstrain(-2e-3, schedule=bd.Ramp(0.0, 1.0, 0.01))]
    model = bd.Model(body, LAW, RHO, failure=failure, boundary=[*ENDS, *strains])
    whole = bd.solve_explicit(model, duration=0.02)
    bd.solve_explicit(
        model, duration=0.02, out=tmp_path / "run.h5", save_every=7, every=7,
        callback=lambda state, _: state.time > 0.0099,
    )  # fmt: skip
    with threads(1):
        rest = bd.resume(tmp_path / "run.h5")
    np.testing.assert_array_equal(rest.state.pose, whole.state.pose)
    np.testing.assert_array_equal(rest.state.work, whole.state.work)
    if failure is not None:
        assert len(whole.state.cracks) > 0


def test_a_linear_field_of_strain_bends_a_free_body_without_stress(body: bd.Lattice) -> None:
    """ε* = g z: u = g (x z, y z, (z² - x² - y²) / 2) is compatible with it, the curvature being g."""
    g = 1e-3

    def field(centre: np.ndarray) -> np.ndarray:
        return g * centre[:, 2]

    static = bd.solve_static(bd.Model(body, LAW, RHO, boundary=bd.Eigenstrain(field)))
    x, y, z = (body.centre - body.centre.mean(axis=0)).T
    one = np.ones_like(x)
    basis = np.stack([x * z, x, y, z, one], axis=1)
    fitted = np.linalg.lstsq(basis, static.displacement[:, 0], rcond=None)[0]
    assert fitted[0] == pytest.approx(g, rel=0.06)  # four cells across the depth
    clamped = 0.5 * E * (g * body.centre[:, 2]) ** 2 @ body.cells.volume / (1.0 - 2.0 * NU)
    assert static.energy.total < 0.05 * clamped


def test_what_a_linear_field_lacks_is_the_rest_rotation_of_facets() -> None:
    """The docstring, the guide and the limits state the errors; with rest rotations there would be none."""
    free = bd.connect(bd.pack(bd.Box((40e-3, 10e-3, 10e-3)), count=300, method="even", seed=4), method="laguerre")
    found = bent(free, NU)
    assert 0.91 < found["across"] < found["along"] < 0.96
    assert 0.02 < found["stress"] < 0.06
    assert found["turned"] == pytest.approx(1.0, abs=1e-9)
    assert found["moment"] == pytest.approx(1.0, abs=2e-3)


def test_a_field_of_strain_by_element_is_that_of_a_function_and_follows_its_schedule(body: bd.Lattice) -> None:
    values = 1e-3 * np.sin(body.centre[:, 0])
    rise = bd.Ramp(0.0, 1.0, 4e-3)
    array = bd.Eigenstrain(values, WARM, schedule=rise)
    function = bd.Eigenstrain(lambda centre: 1e-3 * np.sin(centre[:, 0]), WARM, schedule=rise)
    np.testing.assert_array_equal(array.parts(body), function.parts(body))
    inside = np.where(WARM.mask(body), values, 0.0)
    np.testing.assert_allclose(array.parts(body), inside[body.pairs].mean(axis=1), atol=1e-18)
    state = bd.Model(body, LAW, RHO, boundary=array).state()
    for time, share in ((0.0, 0.0), (1e-3, 0.25), (1.0, 1.0)):
        state.time = time
        np.testing.assert_allclose(state.stress_free_strain, share * array.parts(body), atol=1e-18)


def test_a_uniform_array_is_a_number(body: bd.Lattice) -> None:
    same = [bd.Eigenstrain(1e-3), bd.Eigenstrain(np.full(len(body.particles), 1e-3))]
    moved = [bd.solve_static(bd.Model(body, LAW, RHO, boundary=one)).displacement for one in same]
    np.testing.assert_array_equal(*moved)


@pytest.mark.parametrize(
    ("strain", "words"),
    [
        (np.zeros((2, 3)), r"shape \(2, 3\)"), ([0.0, np.nan], "not finite"), ([0.0, -1.5], "above -1"),
        ([1e-3, 2e-3], r"values have shape \(2,\)"), (lambda centre: centre, "one value per element"),
        (lambda centre: -2.0 + 0.0 * centre[:, 0], "above -1"),
    ],
)  # fmt: skip
def test_other_fields_of_strain_are_refused(body: bd.Lattice, strain, words: str) -> None:
    with pytest.raises(bd.errors.InputError, match=words) as caught:
        bd.Model(body, LAW, RHO, boundary=bd.Eigenstrain(strain)).constraints  # noqa: B018  made at first use
    assert "\n" not in str(caught.value)
