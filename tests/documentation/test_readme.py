"""README: short, in order, its pictures there, and each thumbnail made by a script of at most 20 lines."""

import re
import runpy
from pathlib import Path

import matplotlib
import pytest
from PIL import Image

from bondem.study.study_file import read_study

ROOT = Path(__file__).parents[2]
TEXT = (ROOT / "README.md").read_text(encoding="utf-8")
GALLERY = sorted((ROOT / "examples" / "gallery").glob("*.py"))


def test_it_has_at_most_600_words():
    assert len(TEXT.split()) <= 600


def test_it_says_what_a_reader_asks_in_this_order():
    wanted = ["![", "git clone", "bondem run", "pytest", "one minute", "Who it is for", "MUSEN", "Which law",
              "twenty lines", "Five commands", "Five numbers", "Missed", "Documentation", "Cite"]  # fmt: skip
    places = [TEXT.index(one) for one in wanted]
    assert places == sorted(places)


def test_the_main_job_calibrates_beams_and_breaks_cells():
    (job,) = [line for line in TEXT.splitlines() if "bondem run examples" in line]
    beams, cells = (read_study(ROOT / one) for one in re.findall(r"examples/\w+\.toml", job))
    assert beams.bond.law is not None
    assert cells.bond.cells is not None
    assert cells.failure is not None
    assert "direct_tension" in cells.tests
    assert {*beams.tests} < {*cells.tests}
    assert beams.packings == cells.packings == 1


def test_a_body_is_broken_in_eight_lines():
    (code,) = re.findall(r"^```python\n(.*?)^```$", TEXT, re.MULTILINE | re.DOTALL)
    assert len(code.splitlines()) == 8


def test_links_and_pictures_are_there():
    for page in [ROOT / "README.md", *(ROOT / "docs").rglob("*.md")]:
        if page.name == "README.md" or "validation" not in page.parts:
            outside = re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
            for target in re.findall(r"\]\(([^)#\s]+)", outside):
                if not target.startswith("http"):
                    assert (page.parent / target).exists(), f"{page.name}: {target}"


def test_there_are_six_thumbnails_each_of_a_script():
    shown = re.findall(r"\[!\[\]\(docs/figures/gallery/(\w+)\.png\)\]\(examples/gallery/(\w+)\.py\)", TEXT)
    assert sorted(one for one, _ in shown) == sorted(path.stem for path in GALLERY)
    assert all(one == other for one, other in shown)
    assert len(shown) == 6


# Scripts of two to eight seconds of a core.
LONG = {"pulled_concrete", "shattered_ball", "snapping_bar"}


@pytest.mark.parametrize("script", [
    pytest.param(path, id=path.stem, marks=[pytest.mark.validate] if path.stem in LONG else []) for path in GALLERY
])  # fmt: skip
def test_a_thumbnail_takes_twenty_lines(script, tmp_path, monkeypatch, capsys):
    assert len(script.read_text(encoding="utf-8").splitlines()) <= 20
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    monkeypatch.chdir(tmp_path)
    matplotlib.use("agg")
    runpy.run_path(str(script))
    assert capsys.readouterr().out
    with Image.open(tmp_path / f"{script.stem}.png") as made:
        assert made.size == (400, 400)
        assert len(made.convert("RGB").resize((40, 40)).getcolors(1600)) > 5  # more than paper
