"""README: short, in order, its pictures there, and each thumbnail made by a script of at most 20 lines."""

import ast
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
              "Six pictures", "Five commands", "Five numbers", "Missed", "Documentation", "Cite"]  # fmt: skip
    places = [TEXT.index(one) for one in wanted]
    assert places == sorted(places)


def test_the_main_job_calibrates_beams_shatters_a_ball_and_cracks_a_beam_once():
    (job,) = [line for line in TEXT.splitlines() if "bondem run examples" in line]
    beams, ball, cells = (read_study(ROOT / one) for one in re.findall(r"examples/\w+\.toml", job))
    assert beams.bond.law is not None
    assert beams.packings > beams.calibrating  # those that do not calibrate are tested
    for study, test in ((ball, "sphere_impact"), (cells, "three_point_bending")):
        assert study.bond.cells is not None
        assert study.failure.fracture_energy > 0.0
        assert study.tests == (test,)


def test_set_up_is_two_commands_after_which_bondem_is_found():
    installs = [line for line in TEXT.splitlines() if "pip install" in line and "venv" in line]
    assert len(installs) == 2
    assert all(". .venv/bin/activate" in line for line in installs)
    extras = re.findall(r'pip install "\.\[(\w+)\]" && bondem (\w+)', TEXT)
    assert extras == [("campaign", "campaign")]


def test_it_states_licence_platform_status_and_what_to_open():
    for words in ("BSD 3-Clause", "Linux x86-64", "alpha", "Open the report"):
        assert words in TEXT, words


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
# Pages whose example a picture stands under, by the script that draws it.
UNDER = {"shattered_ball": "README.md", "pulled_concrete": "docs/index.md"}


@pytest.mark.parametrize("script", [
    pytest.param(path, id=path.stem, marks=[pytest.mark.validate] if path.stem in LONG else []) for path in GALLERY
])  # fmt: skip
def test_a_short_script_draws_a_picture_of_the_gallery(script, tmp_path, monkeypatch, capsys):
    assert len(script.read_text(encoding="utf-8").splitlines()) <= 40
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    monkeypatch.chdir(tmp_path)
    matplotlib.use("agg")
    runpy.run_path(str(script))
    assert capsys.readouterr().out
    with Image.open(tmp_path / f"{script.stem}.png") as made:
        assert min(made.size) >= 400
        assert len(made.convert("RGB").resize((40, 40)).getcolors(1600)) > 5  # more than paper


@pytest.mark.parametrize(("name", "page"), UNDER.items(), ids=UNDER)
def test_a_picture_belongs_to_the_example_it_stands_under(name, page):
    """The script of a picture makes the calls of the code above it, with the same numbers."""
    text = (ROOT / page).read_text(encoding="utf-8")
    found = re.search(rf"^```python\n(.*?)^```$(.*?)gallery/{name}\.png", text, re.MULTILINE | re.DOTALL)
    assert found
    assert "```python" not in found[2]
    assert f"examples/gallery/{name}.py" in text
    script = (ROOT / f"examples/gallery/{name}.py").read_text(encoding="utf-8")
    computed = re.sub(r"^(print|bd\.write).*", "", found[1], flags=re.MULTILINE)
    assert used(computed) <= used(script)


def used(code):
    """The calls of a script, and the numbers and words that it gives them."""
    parts = list(ast.walk(ast.parse(code)))
    numbers = {part.value for part in parts if isinstance(part, ast.Constant)}
    return numbers | {ast.unparse(part.func) for part in parts if isinstance(part, ast.Call)}
