"""The command: what it prints, writes and returns."""

import json
import re
import subprocess
import sys
import time
from pathlib import Path

import click
import numpy as np
import pytest

import bondem as bd
from bondem import cli
from bondem.cli import main
from bondem.dynamics.plan import settled
from bondem.errors import UnstableRunError
from bondem.io.runfile import RunFile
from tests.models import loaded_row
from tests.scripts import command
from tests.specimens import spheres

EXAMPLE = Path(__file__).parents[2] / "examples" / "silica.toml"


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    """The silica study, small enough for a test."""
    return in_a_pipe(tmp_path_factory.mktemp("cli"), EXAMPLE.read_text())


def in_a_pipe(folder, text):
    """Run a variant of the silica study; return the folder of its results and the finished process."""
    (folder / "study.toml").write_text(text.replace("count = 10_000", "count = 300"))
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("BONDEM_PROGRESS", "auto")
        done = command("run", "study.toml", "--out", "out", "--seed", "3", "--threads", "1", cwd=folder, process=True)
    return folder / "out", done


def test_a_short_study_succeeds_and_says_its_stages_in_a_pipe(tmp_path):
    one = re.sub(r"tests = \[.*?\]", 'tests = ["static_bending"]', EXAMPLE.read_text(), flags=re.DOTALL)
    one = one.replace("figures = true", "figures = false").replace("packings = 2", "packings = 1")
    out, done = in_a_pipe(tmp_path, one)
    assert done.returncode == 0, done.stderr
    lines = done.stderr.splitlines()
    assert all(line.startswith("bondem: ") for line in lines)
    stages = dict.fromkeys(line.rpartition("  ")[2] for line in lines)
    names = [one for one in stages if not set(one) & set(":,%")]
    assert names == ["pack 1 of 1", "calibrate", "test 1 of 1", "report"]
    assert "\x1b" not in done.stdout
    assert any(line.split()[:1] == ["static_bending"] and "%" in line for line in done.stdout.splitlines())
    assert done.stdout.splitlines()[-1].strip() == str(Path("out") / "report.html")  # what one opens next
    results = json.loads((out / "results.json").read_text())
    assert results["macro"]["E"] == pytest.approx(72.5e9, rel=2e-3)
    report = (out / "report.html").read_text()
    for words in ("static bending", "bondem run study.toml --out out --seed 3 --threads 1"):
        assert words in report


@pytest.mark.validate
def test_run_succeeds_and_says_its_stages_in_a_pipe(finished):
    _, done = finished
    assert done.returncode == 0
    lines = done.stderr.splitlines()
    assert all(line.startswith("bondem: ") for line in lines)
    stages = dict.fromkeys(line.rpartition("  ")[2] for line in lines)
    assert [one for one in stages if not set(one) & set(":,%")] == [  # others say how far one is
        "pack 1 of 2", "pack 2 of 2", "calibrate", "test 1 of 2", "test 2 of 2", "report",
    ]  # fmt: skip
    lines = done.stdout.splitlines()
    assert "\x1b" not in done.stdout
    for name in ("static_bending", "dynamic_torsion", "impact"):
        assert any(line.split()[:1] == [name] and "%" in line for line in lines)
    assert "6.63 %" in done.stdout


@pytest.mark.validate
def test_run_leaves_results_report_and_figures(finished):
    out, _ = finished
    results = json.loads((out / "results.json").read_text())
    assert results["seed"] == 3
    assert results["specimen"]["elements"] == 300
    assert set(results["tests"]) == {
        "static_tension", "static_bending", "static_torsion",
        "dynamic_tension", "dynamic_bending", "dynamic_torsion", "impact",
    }  # fmt: skip
    assert results["macro"]["E"] == pytest.approx(72.5e9, rel=2e-3)
    assert results["macro"]["nu"] == pytest.approx(0.17, abs=1e-3)
    # a coarse specimen, so loosely: theory is met in kind
    assert all(abs(row["error"]) < 0.25 for row in results["tests"].values())
    names = {path.stem for path in (out / "figures").glob("*.png")}
    assert names == {
        "specimen", "geode", "contacts", "layering", "distribution", "calibration", "tension", "profiles", "modes",
        "vibration", "wave", "errors",
    }  # fmt: skip
    assert sorted(path.name for path in out.iterdir()) == ["curves", "figures", "report.html", "results.json"]


@pytest.mark.validate
def test_the_report_holds_everything_it_shows(finished):
    out, _ = finished
    html = (out / "report.html").read_text()
    assert html.count('src="data:image/webp;base64,') == html.count("<img") == 12
    assert html.count("srcset=") == html.count("--share: ") == 12  # a figure for phones and a width each
    # the study file may contain any text, and so may pictures by chance
    shown = re.sub(r"<pre.*?</pre>|base64,[^\"']*", "", html, flags=re.DOTALL)
    assert "http" not in shown.replace("https://www.w3.org", "")
    for text in ("Fused silica cylinder", "static bending", "6.63 %", "André et al. (2012)", "seed 4"):
        assert text in html


def test_resume_goes_on_to_the_end(tmp_path):
    # a checkpoint at rest, as a run killed at once leaves it
    beam = loaded_row((0.0, -1.0, 0.0))
    plan = settled(beam, bd.Plan(duration=2e-5, gauges={"end": bd.Gauge(bd.Index([11]), "displacement")}, every=10))
    RunFile(tmp_path / "run.h5", beam, plan).checkpoint(beam.state(), bd.History.empty(("end",)))
    whole = bd.solve_explicit(beam, duration=2e-5, gauges=dict(plan.gauges), every=10)
    done = command("resume", "run.h5", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    assert f"step {whole.steps}" in done.stdout
    kept = bd.read_run(tmp_path / "run.h5")
    np.testing.assert_array_equal(kept.state.pose, whole.state.pose)
    np.testing.assert_array_equal(kept.history.records, whole.history.records)


def test_an_unstable_run_returns_three(tmp_path):
    beam = loaded_row((0.0, -1e6, 0.0))
    plan = settled(beam, bd.Plan(duration=1e-3))
    RunFile(tmp_path / "run.h5", beam, plan).checkpoint(beam.state(), bd.History.empty(()))
    before = (tmp_path / "run.h5").read_bytes()
    done = command("resume", "run.h5", cwd=tmp_path)
    assert done.returncode == 3
    assert "unstable" in done.stdout
    assert (tmp_path / "run.h5").read_bytes() == before


@pytest.mark.parametrize("option", ["--version", "--help"])
def test_version_and_help_are_instant_and_load_nothing_heavy(tmp_path, option):
    start = time.perf_counter()
    done = command(option, cwd=tmp_path, process=True)
    assert (bd.__version__ if option == "--version" else "calibrate") in done.stdout.split()
    assert time.perf_counter() - start < 3.0
    code = (
        f"import sys; sys.argv = ['bondem', '{option}']\n"
        "from bondem.cli import main\n"
        "try: main()\n"
        "except SystemExit: pass\n"
        "assert not {'numpy', 'numba', 'scipy', 'matplotlib', 'rich'} & set(sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], cwd=tmp_path).returncode == 0


def test_the_list_of_commands_has_the_first_line_of_each_help():
    context = click.Context(cli.bondem)
    for name, line in cli._COMMANDS.items():
        assert cli.bondem.get_command(context, name).get_short_help_str(200) == line


@pytest.mark.parametrize("arguments", [[], ["run", "--help"]])
def test_help(tmp_path, arguments):
    done = command(*arguments, cwd=tmp_path)
    assert done.returncode == 0
    assert "Usage:" in done.stdout


def test_a_study_that_becomes_unstable_returns_three(monkeypatch, capsys):
    def unstable(*_args, **_options):
        raise UnstableRunError("stopped at step 7: a number is not finite")

    monkeypatch.setattr("bondem.cli.bondem.main", unstable)
    with pytest.raises(SystemExit) as stopped:
        main()
    assert stopped.value.code == 3
    assert capsys.readouterr().err == "bondem: stopped at step 7: a number is not finite\n"


def test_a_test_of_a_specimen_refuses_an_unstable_run():
    # so fast a push turns bonds beyond what a bond can bear
    lattice = spheres(bd.Cylinder(5e-3, 30e-3), 400)
    law = bd.EulerBernoulli(E=200e9, nu=0.3, radius_ratio=0.7)
    with pytest.raises(UnstableRunError, match="turned beyond 90 degrees"):
        bd.labtests.impact(lattice, law, density=3500.0, E=60e9, nu=0.17, rho=2200.0, velocity=2e4)
