"""Cracked plates and beams of several depths: their geometry and formulas, and studies of few cells."""

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from validation.cases import toughness
from validation.cases.gregoire import beam, scaled
from validation.cases.toughness import PLATES, CentreCrack, CompactTension
from validation.frame.runner import run
from validation.measures.size_effect import SizeEffect
from validation.studies.size_effect import SizeEffectStudy
from validation.studies.toughness import Toughness


@pytest.fixture(params=list(PLATES))
def plate(request):
    return PLATES[request.param][0](8.0)


def test_the_compact_specimen_has_the_numbers_of_the_standard():
    """f(a / W) of ASTM E399, table of the compact specimen."""
    found = [CompactTension(16.0).k(alpha) for alpha in (0.45, 0.5, 0.55)]
    np.testing.assert_allclose(found, [8.34, 9.66, 11.36], atol=6e-3)


def test_a_short_central_crack_is_that_of_an_infinite_plate():
    alpha = 0.02
    assert CentreCrack(8.0).k(alpha) == pytest.approx(np.sqrt(np.pi * alpha), rel=1e-3)


def test_plates_have_their_notch_and_fine_cells_ahead_of_it(plate):
    body = plate.body(1)
    size, tip = np.cbrt(body.cells.volume), 0.5 * plate.width
    assert body.cells.volume.sum() == pytest.approx(plate.shape.volume, rel=2e-3)
    inside = plate.shape.contains([[x * tip, 0.0, 0.5 * plate.thickness] for x in (0.97, 1.03)])
    assert inside.tolist() == [False, True]
    assert size[plate.about.contains(body.centre)].mean() == pytest.approx(0.2 * toughness.LENGTH, rel=0.15)
    middle = body.cells.centroid[:, 1]
    crossing = (middle[body.pairs[:, 0]] * middle[body.pairs[:, 1]] < 0.0) & (
        body.facets.centroid[:, 0] < tip - 0.5 * toughness.LENGTH
    )
    across = np.abs(body.facets.normal[:, 1]) > 0.7
    assert not (crossing & across & (np.abs(body.facets.centroid[:, 1]) < 1e-3)).any()


def test_loads_are_in_balance(plate):
    model, _ = plate.model(plate.body(1))
    force = sum(np.asarray(load.nodal(model.lattice)[1])[:, :3].sum(axis=0) for load in model.boundary
                if not isinstance(load, bd.Fix))  # fmt: skip
    assert np.abs(force).max() < 1e-6


def test_larger_plates_break_nearer_to_their_toughness():
    for kind, widths in PLATES.values():
        expected = [kind(over).expected for over in widths]
        assert 0.9 < expected[0] < expected[1] < expected[2] < 1.0
        assert kind(1e6).expected == pytest.approx(1.0, rel=1e-5)


@pytest.mark.validate
def test_compliance_gives_the_stress_intensity(monkeypatch):
    """K from P² dC/da of elastic compact specimens, by notches of 0.4 to 0.6 W; their pins are no holes."""
    alphas, compliance = np.array([0.4, 0.45, 0.5, 0.55, 0.6]), []
    plate = CompactTension(16.0)
    for alpha in alphas:
        monkeypatch.setattr(toughness, "_ALPHA", alpha)
        body = plate.body(1)
        model, _ = plate.model(body)
        elastic = bd.Model(body, model.bond, 2400.0, boundary=model.boundary)
        moved = bd.solve_static(elastic).displacement[:, 1]
        upper, lower = (list(load.region.elements) for load in model.boundary if isinstance(load, bd.Load))
        compliance.append((moved[upper].mean() - moved[lower].mean()) / 1e3)
    curve = np.polyfit(alphas, np.log(compliance), 2)
    slope = compliance[2] * (curve[0] + curve[1]) / plate.width
    K = np.sqrt(0.5 * toughness.PLANE * slope / plate.thickness)
    assert pytest.approx(plate.k(0.5) / (plate.thickness * np.sqrt(plate.width)), rel=0.03) == K


@pytest.mark.validate  # `test_validation_fracture` has a study of quasi-static paths
def test_a_study_of_plates_judges_and_draws(tmp_path, monkeypatch):
    monkeypatch.setitem(PLATES, "centre crack", (CentreCrack, (3.0, 4.0, 5.0)))
    monkeypatch.setattr("validation.rows.toughness._RIPPLE", 0.5)
    monkeypatch.setattr("validation.rows.toughness._TOGETHER", 0.05)
    study = Toughness(plates=("centre crack",), seeds=(1,), cells=0.4)
    found = run(study, tmp_path, processes=1, command="by a test")
    assert [one["over"] for one in found["plates"]] == [3.0, 4.0, 5.0]
    for one, row in zip(found["plates"], found["rows"], strict=True):
        assert 0.5 < one["values"][0] < 1.5
        assert max(row["curve"]) == pytest.approx(one["values"][0], rel=1e-12)
        assert one["verdict"] == ("met" if abs(one["values"][0] - 1.0) <= 0.1 else "missed")
    assert (tmp_path / "figures" / "toughness.png").stat().st_size > 10_000


def test_the_size_effect_law_is_found_again():
    depth = np.array([0.05, 0.1, 0.2, 0.4])
    law = SizeEffect.fitted(depth, SizeEffect(3e6, 0.3).nominal(depth))
    assert (law.strength, law.transition) == (pytest.approx(3e6), pytest.approx(0.3))
    assert law.nominal(np.array([300.0]))[0] == pytest.approx(3e6 * np.sqrt(0.3 / 300.3))


def test_beams_of_other_depths_are_alike():
    case, one = scaled(0.2), beam(0.2)
    np.testing.assert_allclose(case.shape.bounds[1], [0.7, 0.2, 0.05])
    np.testing.assert_allclose([*one.supports, one.loaded, *one.notch], [0.1, 0.6, 0.35, 0.35, 0.1, 2e-3])
    assert case.fine == pytest.approx(0.046 * 0.2)
    assert case.shape.contains([[0.35, 0.099, 0.025], [0.35, 0.101, 0.025]]).tolist() == [False, True]


@pytest.mark.validate
def test_a_study_of_sizes_fits_the_law_and_draws(tmp_path, monkeypatch):
    monkeypatch.setattr("validation.studies.size_effect._DEPTHS", (0.1, 0.2))
    found = run(SizeEffectStudy(depths=(100.0, 200.0), finer=0.7), tmp_path, processes=1, command="by a test")
    small, large = (one["peak"] for one in found["beams"])
    assert 1.0 < large / small < 4.0
    assert found["law"]["over"] == pytest.approx([1.0, 1.0])
    assert found["continuum"]["depth"] == [0.1, 0.2]
    assert (tmp_path / "figures" / "size_effect.png").stat().st_size > 10_000


@pytest.mark.parametrize(
    "bad",
    [lambda: Toughness(plates=("nobody",)), lambda: Toughness(seeds=()), lambda: Toughness(cells=0.0),
     lambda: SizeEffectStudy(depths=(50.0,)), lambda: SizeEffectStudy(seeds=(-1,)),
     lambda: SizeEffectStudy(finer=0.0),
     lambda: SizeEffectStudy(depths=(50.0, 1.0))],
)  # fmt: skip
def test_bad_options_are_refused(bad):
    with pytest.raises(InputError):
        bad()
