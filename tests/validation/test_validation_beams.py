"""Published fracture cases with beam bonds: their strength, rows, how a study judges them, and what it draws."""

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pytest

import bondem as bd
import validation.cases.beam_bonds as bars
import validation.studies.beam_bonds as studies
from bondem.errors import InputError
from tests.specimens import spheres
from validation.cases.gregoire import GREGOIRE
from validation.cases.l_panel import L_PANEL
from validation.rows.beam_bonds import SlowBeamsRun, StruckBeamsRun, _row
from validation.rows.kalthoff import Plate
from validation.studies.beam_bonds import BeamBondsStudy


@dataclass(frozen=True)
class QuickBeamsRun(SlowBeamsRun):
    """Much faster than a test may be: nothing physical is asked of it."""

    traverses: float = 2.0


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Small bars, pulled twice and fast."""
    for name, value in (("COUNT", 300), ("PULLS", 2), ("_TRAVERSES", 6.0)):
        monkeypatch.setattr(bars, name, value)
    bars.beam_bonds.cache_clear()
    monkeypatch.setattr(studies, "SlowBeamsRun", QuickBeamsRun)
    monkeypatch.setattr(studies, "Plate", lambda: Plate(thickness=40e-3))  # three hundred spheres fill no thinner one


@pytest.fixture(autouse=True)
def forgotten() -> Any:
    """Bonds of a small bar are not those of others."""
    yield
    bars.beam_bonds.cache_clear()


@pytest.mark.filterwarnings("ignore::bondem.errors.ImbalanceWarning")  # pulled within six traverses
@pytest.mark.usefixtures("quick")
def test_bonds_are_set_by_the_strength_of_their_bar() -> None:
    """The strength of the bar follows that of its bonds: a second test comes nearer, and both are told."""
    found = bars.beam_bonds(GREGOIRE.E, GREGOIRE.nu, GREGOIRE.rho, GREGOIRE.tension)
    assert found.tension == pytest.approx(GREGOIRE.tension, rel=0.15)
    assert found.factor == pytest.approx(found.tension / found.failure.tension)
    assert found.failure.shear == pytest.approx(2.0 * found.failure.tension)
    # spheres weigh what their bar does
    bar = bd.connect(bd.pack(bd.Box((3.0 * bars.EDGE, bars.EDGE, bars.EDGE)), count=bars.COUNT, seed=bars.SEED))
    solid = bar.particles.volume.sum() / bar.particles.envelope.volume
    assert found.density * solid == pytest.approx(GREGOIRE.rho, rel=0.02)


def test_rollers_hold_a_row_of_spheres_across() -> None:
    body, line = spheres(GREGOIRE.shape, 400), GREGOIRE.driven[0]
    place = body.centre[list(_row(body, line).elements)]
    wide = 2.0 * body.particles.mean_radius
    assert np.ptp(place[:, 2]) > 0.5 * GREGOIRE.shape.bounds[1][2]
    assert np.abs(place[:, 0] - line.x).max() < 0.6 * wide
    assert np.abs(place[:, 1] - line.y).max() < 0.9 * wide
    with pytest.raises(InputError, match="no sphere"):
        _row(body, replace(line, y=-1.0))


def test_bonds_near_rollers_do_not_break() -> None:
    """A thousand times as strong, and only those near: within the reach of the case."""
    body = spheres(GREGOIRE.shape, 400)
    bonds = bars.BeamBonds(bd.EulerBernoulli(E=1e9, nu=0.2, radius_ratio=0.5), 1.0,
                           bd.PeripheralStress(tension=1e6, shear=2e6), 1.0, 1e6)  # fmt: skip
    weak, strong = SlowBeamsRun(GREGOIRE, 1e-5, 1e-4, 1)._failure(body, bonds).items()
    assert weak[1] is bonds.failure
    assert strong[1].tension == pytest.approx(1e9)
    spared = {
        n for line, reach in GREGOIRE.spared for n, (x, y, _) in enumerate(body.centre)
        if math.hypot(x - line.x, y - line.y) < reach
    }  # fmt: skip
    assert set(strong[0].elements) == spared
    assert 0 < len(spared) < 0.3 * len(body.particles)
    assert len(SlowBeamsRun(replace(L_PANEL, spared=()), 1e-5, 1e-4, 1)._failure(body, bonds)) == 1


@pytest.mark.filterwarnings("ignore::bondem.errors.ImbalanceWarning")  # pulled within six traverses
@pytest.mark.usefixtures("quick")
@pytest.mark.filterwarnings("ignore::bondem.errors.NotQuasistaticWarning")
@pytest.mark.filterwarnings("ignore::bondem.errors.StrengthWarning")
def test_a_study_breaks_judges_and_draws(tmp_path: Any) -> None:
    """Three hundred spheres, some hundred times too fast."""
    study = BeamBondsStudy(cases=("gregoire", "kalthoff"), seeds=(1,), count=300, struck=300)
    ((stage, requests),) = study.stages(tmp_path)
    made = [one.asked | one.measured(tmp_path) | {"error": None} for one in requests]
    found = study.results(tmp_path, made)
    slow, weak, strong = found["cases"]
    rows = {row["traverses"]: row for row in made if row["case"] == "gregoire"}
    assert stage == "break"
    assert sorted(rows) == [2.0, 8.0]
    row = rows[2.0]
    assert slow["values"] == [row["peak"]]
    assert slow["slower"] == [rows[8.0]["peak"]]
    assert row["peak"] >= max(row["curve"]["load"]) > 0.9 * row["peak"]
    assert 0.0 <= row["displacement"] <= max(row["curve"]["displacement"])
    assert row["broken"] == len(row["x"]) == len(row["y"]) > 0
    lower, upper = GREGOIRE.shape.bounds
    assert (lower[0] <= np.array(row["x"])).all()
    assert (np.array(row["x"]) <= upper[0]).all()
    assert row["residual"] < 0.05
    assert slow["given_energy"] == GREGOIRE.fracture_energy
    assert slow["given_toughness"] == pytest.approx(math.sqrt(GREGOIRE.E * GREGOIRE.fracture_energy))
    assert slow["verdict"] == GREGOIRE.claim.verdict(slow["values"])
    assert [one["strength"] for one in (weak, strong)] == [844e6, 1900e6]
    # what bonds imply goes with the square of their strength
    assert strong["energy"] / weak["energy"] == pytest.approx(
        (strong["bond_tension"] / weak["bond_tension"]) ** 2, rel=1e-6
    )
    assert strong["toughness"] / weak["toughness"] == pytest.approx(
        strong["bond_tension"] / weak["bond_tension"], rel=1e-6
    )
    (tmp_path / "figures").mkdir()
    study.draw(tmp_path, made, found)
    for name in ("gregoire", "kalthoff"):
        assert (tmp_path / "figures" / f"beams_{name}.png").stat().st_size > 10_000


@pytest.mark.parametrize(("angles", "verdict"), [
    ([66.0, 74.0], "met"), ([64.0, 76.0], "met by the mean"), ([64.0, 64.0], "missed"), ([70.0, None], "missed"),
    ([None], "missed"),
])  # fmt: skip
def test_angles_are_judged(angles: list[float | None], verdict: str) -> None:
    told = dict.fromkeys(
        ("E_mu", "radius_ratio", "density", "bond_tension", "factor", "tension", "length", "toughness", "seed",
         "count", "bonds", "steps", "broken", "residual", "run_seconds", "implied_energy", "given_energy", "E"), 1.0
    )  # fmt: skip
    one = studies._struck([told | {"angle": angle, "strength": 844e6} for angle in angles])
    assert one["verdict"] == verdict
    assert (one["low"], one["high"]) == (65.0, 75.0)


def test_requests_know_what_they_are() -> None:
    first = SlowBeamsRun(GREGOIRE, 1e-5, 1e-4, 1)
    other = [replace(first, seed=2), replace(first, traverses=800.0), replace(first, count=500),
             replace(first, case=L_PANEL), *(StruckBeamsRun(Plate(), one, 1) for one in (844e6, 1900e6))]  # fmt: skip
    assert len({one.name for one in (first, *other)}) == 7
    assert replace(first, traverses=800.0).weight == 2.0 * first.weight


@pytest.mark.parametrize(
    "bad", [{"cases": ("nobody",)}, {"seeds": ()}, {"seeds": (-1,)}, {"count": 299}, {"struck": 9}]
)
def test_bad_options_are_refused(bad: dict[str, Any]) -> None:
    with pytest.raises(InputError):
        BeamBondsStudy(**bad)
