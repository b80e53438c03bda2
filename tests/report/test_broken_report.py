"""Report of a body that broke: one value and name for each number, nothing of a packing, and no lost results."""

import json
import re
from pathlib import Path
from typing import Any

import pytest
from matplotlib.axes import Axes

import bondem as bd
from bondem.errors import ReportWarning
from bondem.report import page
from bondem.report.numbers import between, in_unit, off_between
from bondem.report.strength_figures import reach_of
from bondem.study import pipeline
from bondem.study.pipeline import run_study
from bondem.study.study_file import parse_study
from tests.drawings import only
from tests.specimens import bar

STUDY: dict[str, Any] = {
    "name": "prism", "packings": 1, "seed": 3, "tests": ["direct_tension"],
    "material": {"name": "concrete", "E": 40e9, "nu": 0.2, "rho": 2400.0},
    "failure": {"criterion": "Rankine", "tension": "4 MPa", "fracture_energy": 20.0},
    "specimen": {"shape": "box", "size": [20e-3, 10e-3, 10e-3], "count": 100, "method": "even"},
    "bond": {"law": "CellBond"}, "output": {"figures": True},
    "reference": {"citation": "Somebody 1999", "peaks": {"direct_tension": ["4.5 MPa", "5 MPa"]}},
}  # fmt: skip


@pytest.fixture(scope="module")
def finished(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, dict[str, Any], list[str]]:
    """Folder and results of a study, and the titles of its figures."""
    out, titles = tmp_path_factory.mktemp("broken"), list[str]()
    usual = Axes.set_title

    def noted(ax: Axes, label: str, *given: Any, **named: Any) -> Any:
        titles.append(label)
        return usual(ax, label, *given, **named)

    with only("broken", "strength", "pieces"), pytest.MonkeyPatch.context() as patch:
        patch.setattr(Axes, "set_title", noted)
        results = run_study(parse_study(STUDY), out)
    return out, results, titles


def text_of(out: Path) -> str:
    """What a reader sees: no scripts, pictures and tags."""
    html = (out / "report.html").read_text(encoding="utf-8")
    bare = re.sub(r"<(script|style|pre)\b.*?</\1>|<[^>]*>", " ", html, flags=re.DOTALL)
    return re.sub(r"\s+", " ", bare.replace("&nbsp;", " "))


def test_cracks_pieces_and_their_energy_have_one_value_everywhere(finished: Any) -> None:
    out, results, titles = finished
    one, text = results["packings"][0]["tests"]["direct_tension"]["failure"], text_of(out)
    assert (one["cracks"], one["pieces"], one["crumbs"], one["single_crack"]) == (1, 2, 0, True)
    assert set(re.findall(r"(\d+) pieces?\b", text + " ".join(titles))) == {"2"}
    assert not re.search(r"\d crumb", text)
    per_section = f"{one['dissipated_per_section']:.2f} J/m²"
    assert text.count(per_section) >= 2  # in the first paragraph and in the table
    assert f"{one['stored_over_one_crack']:.3g}" in text
    assert "not a fracture energy" not in text


def test_one_motion_has_one_magnification(finished: Any) -> None:
    out, _, titles = finished
    stated = re.findall(r"motion × ([\d.]+)", text_of(out) + " ".join(titles))
    assert len(stated) >= 2
    assert len(set(stated)) == 1
    body = bar(60, 20e-3)
    assert reach_of(body, bd.Model(body, bd.CellBond(E=1.0, nu=0.2), 1.0).state().displacement) == 1.0


def test_a_body_of_cells_has_no_statistics_of_a_packing(finished: Any) -> None:
    out, results, _ = finished
    text = text_of(out)
    for words in ("φ", "loose elements", "g(r)", "Quality of the packing", "coordination", "overlap"):
        assert words not in text, words
    assert results["specimen"]["volume_fraction"] is None
    assert "loose" not in results["packings"][0]


def test_ratios_are_no_differences_and_the_measured_range_is_named(finished: Any) -> None:
    out, results, _ = finished
    text = text_of(out)
    assert "E / target" not in text
    off = results["tests"]["direct_tension"]["measured"] / 4.5e6 - 1.0
    assert f"{-100.0 * off:.2f} % below the measured 4.5 to 5 MPa (Somebody 1999)" in text
    assert between(933.0, 1114.0, "N") == "0.933 to 1.114 kN"
    assert in_unit("peak load [N]", 1237.0) == ("peak load", "1.237 kN")
    assert off_between([0.98, 1.01], 1.0) == "−2.00 to +1.00 %"
    assert off_between(None, 1.0) == "–"


def test_the_report_states_where_it_comes_from(finished: Any) -> None:
    out, results, _ = finished
    text = text_of(out)
    for name in ("version", "machine", "date", "python"):
        assert str(results[name]) in text, name
    for words in ("seeds 3", f"threads of this run {results['threads']}", "command"):
        assert words in text, words


def test_tables_fold_on_a_phone(finished: Any) -> None:
    html = (finished[0] / "report.html").read_text(encoding="utf-8")
    assert html.count("<table") == html.count('<div class="scroll"><table')
    assert "dataset.head" in html
    assert "@media screen and (max-width: 46rem)" in html
    assert html.count("<picture>") == html.count("<source media=")


def test_a_figure_or_a_page_that_fails_loses_no_result(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(*given: Any, **named: Any) -> None:
        raise ValueError("no ink")

    whole = {key: value for key, value in STUDY.items() if key not in ("failure", "reference")}
    asked = parse_study(whole | {"tests": ["static_tension"]})
    monkeypatch.setattr(page, "drawings_of", lambda findings: {"tension": broken})
    with pytest.warns(ReportWarning, match=r"figure tension was not drawn \(ValueError: no ink\)"):
        results = run_study(asked, tmp_path)
    assert "was not drawn: ValueError: no ink" in text_of(tmp_path)
    monkeypatch.setattr(pipeline, "write_report", broken)
    with pytest.warns(ReportWarning, match=r"the report was not written \(ValueError: no ink\); all numbers are in"):
        run_study(asked, tmp_path)
    kept = json.loads((tmp_path / "results.json").read_text())
    assert kept["tests"] == results["tests"]
    assert not (tmp_path / "report.html").exists()  # that of the first run
