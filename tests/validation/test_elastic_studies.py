"""Elastic constants over the parameters of bonds and the number of elements: the curves of bondem, the studies."""

import csv
import json
import sys
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem.calibration.abacus import Curve, curve
from bondem.errors import InputError, PackingError
from tests.scripts import files
from validation.__main__ import main
from validation.frame.request import kept_row, made_row
from validation.frame.runner import run
from validation.frame.study import Study
from validation.rows.elastic import ElasticRequest, cells_and_bars
from validation.rows.packings import PackingRequest, kept_lattice
from validation.studies.abacus import SWEEPS, Abacus
from validation.studies.assembly import LAW, Assembly, _scatter
from validation.studies.influence import Influence, _linearity

LAWS = tuple(sweep.law for sweep in SWEEPS.values())


@pytest.fixture(scope="module")
def abacus(tmp_path_factory):
    out = tmp_path_factory.mktemp("abacus")
    study = Abacus(count=200, packings=2, bars=1, laws=("ParallelBond",))
    return study, out, run(study, out, processes=1)


@pytest.mark.parametrize("law", LAWS)
def test_every_law_has_a_curve_that_reads_both_ways(law):
    found = curve(law)
    assert found is not None
    assert (found.law, found.parameter) == (law.__name__, law.free.name)
    assert (tuple(found.values), found.fixed) == (law.free.curve, SWEEPS[law.__name__].fixed)
    low, high = found.reach
    for nu in np.linspace(low, high, 23)[1:-1]:
        value = found.value_for(nu)
        assert found.values[0] <= value <= found.values[-1]
        assert found.nu_at(value) == pytest.approx(nu, abs=1e-9)
    for value, nu, ratio in zip(found.values, found.nu, found.stiffness_ratio, strict=True):
        assert found.value_for(nu) == pytest.approx(value, rel=1e-9)
        assert found.stiffness_ratio_at(value) == pytest.approx(ratio, rel=1e-9)
    assert found.value_for(low - 1e-6) is None
    assert found.value_for(high + 1e-6) is None
    assert found.nu_at(0.5 * found.values[0]) is None
    assert found.stiffness_ratio_at(2.0 * found.values[-1]) is None
    assert (found.nu_std < 0.01).all()


def test_a_law_without_a_curve_has_none():
    assert curve(bd.ContactBond) is None


def test_where_poissons_ratio_turns_the_longer_branch_is_read():
    data = {"parameter": "kappa", "fixed": {}, "values": [1.0, 2.0, 4.0, 8.0, 16.0], "nu": [0.2, 0.3, 0.25, 0.2, 0.1],
            "nu_std": [None] * 5, "stiffness_ratio": [1.0] * 5, "stiffness_ratio_std": [None] * 5}  # fmt: skip
    found = Curve.read("ParallelBond", data)
    assert found.value_for(0.2) == pytest.approx(8.0)
    assert found.value_for(0.3) == pytest.approx(2.0)


@pytest.mark.parametrize(("law", "nu"), [(bd.EulerBernoulli, 0.17), (bd.Timoshenko, 0.25), (bd.ParallelBond, 0.05),
                                         (bd.Obermayr, 0.3)])  # fmt: skip
def test_the_curves_foretell_a_packing_they_never_saw(law, nu):
    found = curve(law)
    value = found.value_for(nu)
    cell = bd.connect(bd.pack(bd.Cell(size=(1e-2,) * 3), count=600, spread=0.25, seed=77))
    moduli = bd.bulk_moduli(cell, law(E=1e9, nu=0.3, **found.fixed, **{found.parameter: value}))
    # 600 elements differ by (10 000 / 600)^(1/2) times more than those of the curves
    assert moduli.nu == pytest.approx(nu, abs=0.006)
    ratio = moduli.E / 1e9
    assert ratio == pytest.approx(found.stiffness_ratio_at(value), rel=0.03)


@pytest.mark.validate
def test_the_abacus_leaves_curves_as_data(abacus):
    _, out, results = abacus
    data = json.loads((out / "abacus.json").read_text())
    assert set(data) == {"packing", "nu_mu", "laws", "version"}
    assert data["packing"] == {"shape": "periodic cell", "count": 200, "packings": 2, "spread": 0.25, "z": 6.2,
                               "seeds": [1, 2]}  # fmt: skip
    own = Curve.read("ParallelBond", data["laws"]["ParallelBond"])
    np.testing.assert_allclose(own.values, SWEEPS["ParallelBond"].values)
    assert (np.diff(own.nu) > 0.0).all()
    assert (np.diff(own.stiffness_ratio) < 0.0).all()
    alone = json.loads((out / "curves" / "ParallelBond.json").read_text())
    assert alone == {name: value for name, value in data.items() if name != "laws"} | data["laws"]["ParallelBond"]
    with open(out / "abacus.csv", newline="") as file:
        lines = list(csv.DictReader(file))
    assert [float(line["nu"]) for line in lines if line["shape"] == "periodic cell"] == list(own.nu)
    assert len(lines) == 2 * len(own.values)
    assert {path.stem for path in (out / "figures").glob("*.png")} == {"abacus", "reach"}
    assert "| silica.periodic cell.ParallelBond.nu_low |" in (out / "table.md").read_text()
    assert results["failed"] == 0
    assert len(results["rows"]) == 3 * len(own.values)
    silica = results["silica"]["periodic cell"]["ParallelBond"]
    assert silica["E_mu"] == pytest.approx(72.5e9 / own.stiffness_ratio_at(silica["value"]))


@pytest.mark.validate
def test_rows_are_what_the_tests_measure(abacus):
    _, out, results = abacus
    for packing in cells_and_bars(200, 0.25, cells=1, bars=1):
        row = next(one for one in results["rows"] if one["periodic"] is packing.periodic and one["kappa"] == 4.0)
        law = bd.ParallelBond(E=row["E_mu"], nu=0.3, radius_ratio=1.0, kappa=4.0)
        lattice = kept_lattice(packing, out)
        found = bd.bulk_moduli(lattice, law) if packing.periodic else bd.labtests.static_tension(lattice, law)
        assert (row["E"], row["nu"]) == pytest.approx((found.E, found.nu), rel=1e-9)
        assert row["stiffness_ratio"] == pytest.approx(found.E / law.E, rel=1e-9)
        if not packing.periodic:
            assert (row["E_paper"], row["nu_paper"]) == pytest.approx((found.E_paper, found.nu_paper), rel=1e-9)


@pytest.mark.validate
def test_a_second_run_makes_only_what_is_missing(abacus):
    study, out, results = abacus
    before = files(out)
    lost = next(path for path in sorted((out / "rows").iterdir()) if "ParallelBond" in path.name)
    lost.unlink()
    again = run(study, out, processes=1)
    after = files(out)
    made = [path for path in after if path.parent.name in ("rows", "packings")]
    written = {path.name for path in made if after[path] != before[path]}
    assert written == {lost.name}
    without = [{name: value for name, value in row.items() if name != "seconds"} for row in again["rows"]]
    assert without == [{name: value for name, value in row.items() if name != "seconds"} for row in results["rows"]]


def test_another_law_packing_or_way_to_measure_is_another_row(tmp_path, monkeypatch):
    (tmp_path / "rows").mkdir()
    (tmp_path / "packings").mkdir()
    cell, bar = cells_and_bars(150, 0.25, cells=1, bars=1)
    one = ElasticRequest(cell, LAW)
    made_row(cell, tmp_path)
    row = made_row(one, tmp_path)
    assert kept_row(one, tmp_path) == row
    changed = bd.EulerBernoulli(E=LAW.E, nu=LAW.nu, radius_ratio=0.72)
    others = [ElasticRequest(bar, LAW), ElasticRequest(cell, changed), ElasticRequest(cell, LAW, True)]
    assert len({other.name for other in others} | {one.name}) == 4
    monkeypatch.setattr("validation.frame.request.code_hash", lambda module: "measured otherwise")
    assert kept_row(one, tmp_path) is None


class Doomed(Study):
    """One packing by a method that does not exist, and one that does."""

    name = "doomed"

    def stages(self, out):
        packings = [PackingRequest(150, 0.25, method, "contacts", 1, True) for method in ("shake", "quench")]
        yield "pack", packings
        yield "solve", [ElasticRequest(one, LAW) for one in packings]

    def results(self, out, rows):
        return {"tested": [row["method"] for row in rows]}

    def draw(self, out, rows, results):
        assert [row["method"] for row in rows] == ["quench"]


@pytest.mark.validate
def test_what_needs_a_packing_that_failed_is_left_out_and_told(tmp_path, monkeypatch):
    with pytest.raises(PackingError, match=r"1 of 2 packings and tests failed.*shake"):
        run(Doomed(), tmp_path, processes=1)
    results = json.loads((tmp_path / "results.json").read_text())
    assert (results["failed"], results["tested"]) == (1, ["quench"])


def test_the_exponent_of_the_radius_is_the_share_of_the_energy():
    # kn goes with r̃², all else with r̃⁴, and the energy is stationary in the motions
    bar = bd.connect(bd.pack(bd.Cylinder(5e-3, 40e-3), count=300, spread=0.25, seed=3))

    def energy(radius_ratio):
        law = bd.EulerBernoulli(E=1e9, nu=0.3, radius_ratio=radius_ratio)
        return bd.labtests.static_tension(bar, law).solution.energy

    step = 1e-3
    slope = np.log(energy(0.5 * np.exp(step)).total / energy(0.5 * np.exp(-step)).total) / (2.0 * step)
    middle = energy(0.5)
    assert -slope == pytest.approx(4.0 - 2.0 * middle.normal / middle.total, abs=1e-5)
    assert 2.2 < -slope < 3.8


@pytest.mark.validate
def test_influence_judges_the_statements_of_the_paper(tmp_path):
    results = run(Influence(count=300, packings=1, bars=1), tmp_path, processes=1)
    for found in results["verdicts"].values():
        assert max(found["E_mu"].values()) < 1e-9
        beam, shear = found["nu_mu"]["EulerBernoulli"], found["nu_mu"]["Timoshenko"]
        assert max(beam["E_change_high"], -beam["E_change_low"]) < 0.01
        assert shear["E_change_high"] > 0.02
        power = found["radius_ratio"]
        assert 2.2 < power["exponent_low"] < power["power"] < power["exponent_high"] < 3.2
        assert power["power_misfit"] < power["E_parabola_misfit_relative"] < power["square_misfit"]
    assert "| verdicts.periodic cell.radius_ratio.power |" in (tmp_path / "table.md").read_text()
    names = {path.stem for path in (tmp_path / "figures").glob("*.png")}
    assert names == {"nu_mu", "E_mu", "radius_ratio", "exponent"}
    _judges_families(results)
    cells = [row for row in results["rows"] if row["periodic"] and row["exponent"] is not None]
    E = {row["radius_ratio"]: np.log(row["E"]) for row in cells}
    middle = next(row["exponent"] for row in cells if row["radius_ratio"] == 0.5)
    assert (E[0.6] - E[0.4]) / np.log(0.6 / 0.4) == pytest.approx(middle, abs=0.02)


def _judges_families(results):
    """Figures 13 and 14: every E_μ is there at every r̃ and in every shape, and a solution of its own decides."""
    moduli, radii = results["moduli"], results["radius_ratios"]
    assert (len(moduli), len(radii)) == (5, 10)
    for periodic in (True, False):
        family = [row for row in results["rows"] if row["periodic"] is periodic and row["law"] == "EulerBernoulli"
                  and row["nu_mu"] == 0.3 and row["radius_ratio"] in radii]  # fmt: skip
        assert sorted((row["E_mu"], row["radius_ratio"]) for row in family) == [(E, r) for E in moduli for r in radii]
        assert len({row["E"] for row in family}) == len(family)
        assert max(_linearity(family, periodic).values()) < 1e-9
        # one row that is off is seen, in E and in ν, wherever in the family it is
        for k in (0, 23, len(family) - 1):
            stiff, wide = list(family), list(family)
            stiff[k] = family[k] | {"stiffness_ratio": 1.001 * family[k]["stiffness_ratio"]}
            wide[k] = family[k] | {"nu": family[k]["nu"] + 1e-3}
            assert _linearity(stiff, periodic)["E"] == pytest.approx(1e-3, rel=2e-3)
            assert _linearity(wide, periodic)["nu"] == pytest.approx(1e-3, rel=1e-6)
    E = {(row["periodic"], row["radius_ratio"]): (row["E"], row["nu"]) for row in results["rows"] if row["exponent"]}
    walls = results["cylinder_over_cell"]
    for radius, ratio, change in zip(*walls.values(), strict=True):
        (cell, cell_nu), (bar, bar_nu) = E[True, radius], E[False, radius]
        assert ratio == pytest.approx(bar / cell - 1.0)
        assert change == pytest.approx(bar_nu - cell_nu)
    assert walls["radius_ratio"] == radii


@pytest.mark.validate
def test_influence_without_bars_compares_no_shapes(tmp_path):
    study = Influence(count=150, packings=1, bars=0)
    results = run(study, tmp_path, processes=1)
    assert results["cylinder_over_cell"] is None
    assert set(results["verdicts"]) == {"periodic cell"}


@pytest.mark.validate  # the abacus is a study with the same rows
def test_assembly_leaves_scatter_limits_and_specimens(tmp_path):
    study = Assembly(counts=(300, 360), packings=2, cells=1)
    results = run(study, tmp_path, processes=1)
    assert [row["count"] for row in results["rows"]] == [300, 300, 360, 360, 360]
    bars = [row for row in results["rows"] if not row["periodic"]]
    found = results["targets"]["contacts"]
    assert found["limits"] == {"E": None, "nu": None, "E_paper": None, "nu_paper": None}
    sd = [np.std([row["E"] for row in pair], ddof=1) / np.mean([row["E"] for row in pair]) for pair in
          (bars[:2], bars[2:])]  # fmt: skip
    assert found["scatter"]["E"]["c"] == pytest.approx(np.sqrt((300 * sd[0] ** 2 + 360 * sd[1] ** 2) / 2.0))
    assert {path.stem for path in (tmp_path / "figures").glob("*.png")} == {"assembly", "scatter", "fineness"}
    assert "| in_print.springs, Liao.E | 0.28 |" in (tmp_path / "table.md").read_text()


def test_scatter_is_found_again():
    random = np.random.default_rng(5)
    found = [
        _scatter([{"count": count, "E": 70e9 * (1.0 + 1.5 / np.sqrt(count) * random.normal())}
                  for count in (500, 1000, 2000, 4000, 8000, 16_000) for _ in range(4)], "E")
        for _ in range(60)
    ]  # fmt: skip
    pulls = [(one["c"] - 1.5) / one["c_error"] for one in found]
    assert abs(np.mean(pulls)) < 0.5
    assert 0.7 < np.std(pulls) < 1.4
    pulls = [(one["exponent"] + 0.5) / one["exponent_error"] for one in found]
    assert abs(np.mean(pulls)) < 0.5
    assert 0.7 < np.std(pulls) < 1.6
    assert found[0]["large"] == 8
    assert all(one["std"] < one["peak_to_peak"] for one in found)
    assert np.mean([one["within"] ** 2 for one in found]) == pytest.approx(1.5**2 * 1.5 / 16_000, rel=0.25)


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["abacus"], "--out"),
        (["abacus", "--out", "out", "--laws", "NonLocal"], "NonLocal"),
        (["abacus", "--out", "out", "--count", "20"], "at least 100"),
        (["influence", "--out", "out", "--packings", "0"], "at least 1"),
        (["influence", "--out", "file"], "folder"),
        (["assembly", "--out", "out", "--counts", "100,200"], "at least 300"),
        (["assembly", "--out", "out", "--counts", "1000,1000"], "different"),
        (["assembly", "--out", "out", "--counts", "many"], "commas"),
        (["assembly", "--out", "out", "--packings", "1"], "at least 2"),
    ],
)
def test_what_cannot_be_done_is_told_in_one_line(tmp_path, monkeypatch, capsys, arguments, told):
    monkeypatch.chdir(tmp_path)
    Path("file").touch()
    monkeypatch.setattr(sys, "argv", ["validation", *arguments])
    with pytest.raises(SystemExit) as stopped:
        main()
    said = capsys.readouterr().err
    assert stopped.value.code == 2
    assert said.count("\n") == 1
    assert told in said
    assert not Path("out").exists()


def test_studies_refuse_what_makes_no_sense():
    for wrong in (lambda: Abacus(laws=("NonLocal",)), lambda: Abacus(packings=0), lambda: Influence(bars=-1),
                  lambda: Assembly(cells=-1)):  # fmt: skip
        with pytest.raises(InputError):
            wrong()
