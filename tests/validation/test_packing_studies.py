"""Studies of packings: what they leave, how they go on where they were, and what they say of what is wrong."""

import csv
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError, PackingError
from tests.scripts import command, files
from validation.__main__ import main
from validation.figures.packing_curves import LARGEST_POSSIBLE, PRINTED_THRESHOLD
from validation.frame.failures import complain
from validation.frame.request import kept_row, made_row
from validation.frame.tables import summary
from validation.measures.limit import limit
from validation.rows.packings import PackingRequest, kept_lattice, random_isotropy_error
from validation.studies.dispersion import Dispersion
from validation.studies.refinement import Refinement

SMALL = ("--counts", "200,260,340", "--packings", "2", "--targets", "jamming", "--periodic", "0")


ROOT = Path(__file__).parents[2]
# validation is no part of what is installed
HERE = os.environ | {"PYTHONPATH": os.pathsep.join(filter(None, (str(ROOT), os.environ.get("PYTHONPATH"))))}


def validation(*arguments, cwd, **options):
    return command(*arguments, cwd=cwd, package="validation", **options)


def without_time(rows):
    return [{name: value for name, value in row.items() if name != "seconds"} for row in rows]


@pytest.fixture(scope="module")
def refined(tmp_path_factory):
    folder = tmp_path_factory.mktemp("refinement")
    return folder / "out", validation("refinement", "--out", "out", *SMALL, "--processes", "2", cwd=folder, env=HERE)


def request(folder, **changed):
    (folder / "rows").mkdir(exist_ok=True)
    (folder / "packings").mkdir(exist_ok=True)
    told = {"count": 60, "spread": 0.25, "method": "quench", "target": "jamming", "seed": 1} | changed
    return PackingRequest(**told)


@pytest.mark.validate
def test_refinement_leaves_rows_packings_tables_figure_and_page(refined):
    out, done = refined
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    results = json.loads((out / "results.json").read_text())
    assert [row["count"] for row in results["rows"]] == [200, 200, 260, 260, 340, 340]
    assert len(list((out / "rows").iterdir())) == len(list((out / "packings").iterdir())) == 6
    by_size = {row["count"]: row for row in results["summary"]}
    assert 0.52 < by_size[200]["volume_fraction"]["mean"] < by_size[340]["volume_fraction"]["mean"] < 0.6
    assert (out / "figures" / "refinement.png").stat().st_size > 10_000
    with open(out / "table.csv", newline="") as file:
        table = list(csv.DictReader(file))
    assert [float(row["volume_fraction"]) for row in table] == [row["volume_fraction"] for row in results["rows"]]
    assert f"| {table[-1]['count']} |" in (out / "table.md").read_text()


@pytest.mark.validate
def test_rows_say_what_is_in_the_packings(refined):
    out, _ = refined
    row = json.loads((out / "results.json").read_text())["rows"][-1]
    one = PackingRequest(row["count"], row["spread"], row["method"], row["target"], row["seed"])
    lattice = kept_lattice(one, out)
    quality = bd.fabric(lattice)
    assert len(lattice.pairs) == row["bonds"]
    assert quality.volume_fraction == row["volume_fraction"]
    assert quality.rms_excess == row["rms_excess"]
    x = bd.pack(lattice.particles.shape, count=340, spread=0.25, jamming=True, seed=2).position
    np.testing.assert_array_equal(x, lattice.particles.position)


@pytest.mark.validate
def test_a_second_run_packs_only_what_is_missing(refined):
    out, _ = refined
    before = files(out)
    rows = json.loads((out / "results.json").read_text())["rows"]
    (lost, *_) = (out / "rows").glob("*_count260_*_seed1_*")
    lost.unlink()
    (other, *_) = (out / "packings").glob("*_count200_*_seed2_*")
    other.unlink()
    done = validation("refinement", "--out", "out", *SMALL, "--processes", "1", cwd=out.parent)
    assert done.returncode == 0, done.stderr
    after = files(out)
    assert set(after) == set(before)
    written = {path for path in after if after[path] != before[path] and path.parent.name in ("rows", "packings")}
    assert {path.stem for path in written} == {lost.stem, other.stem}
    # by another number of processes, too
    assert without_time(json.loads((out / "results.json").read_text())["rows"]) == without_time(rows)


@pytest.mark.validate
def test_a_run_that_is_killed_keeps_what_is_there_and_leaves_no_process(tmp_path):
    arguments = ["refinement", "--out", "out", "--counts", "60,30000", "--packings", "2", "--targets", "jamming",
                 "--periodic", "0"]  # fmt: skip
    # largest first: two processes are in the large ones, the third packs the small ones
    words = [sys.executable, "-m", "validation", *arguments, "--processes", "3"]
    run = subprocess.Popen(words, cwd=tmp_path, env=HERE)
    try:
        deadline = time.monotonic() + 120.0
        while not list(tmp_path.glob("out/rows/*.json")):
            assert run.poll() is None
            assert time.monotonic() < deadline
            time.sleep(0.05)
        children = Path(f"/proc/{run.pid}/task/{run.pid}/children")
        packers = [int(child) for child in children.read_text().split()] if children.exists() else []
    finally:
        run.send_signal(signal.SIGKILL)
        run.wait()
    while any(alive(packer) for packer in packers):
        assert time.monotonic() < deadline
        time.sleep(0.05)
    assert not (tmp_path / "out" / "results.json").exists()
    kept = [json.loads(path.read_text()) for path in tmp_path.glob("out/rows/*.json")]
    assert {row["count"] for row in kept} == {60}


def alive(process):
    try:
        os.kill(process, 0)
        state = Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[0]
    except (OSError, IndexError):
        return False
    return state != "Z"


@pytest.mark.validate
@pytest.mark.filterwarnings("ignore:this process forks")  # as it does for preexec_fn
def test_an_interrupted_run_ends_at_once(tmp_path):
    arguments = ["refinement", "--out", "out", "--counts", "60,30000", "--packings", "1", "--targets", "jamming",
                 "--periodic", "0"]  # fmt: skip
    run = subprocess.Popen(
        [sys.executable, "-m", "validation", *arguments, "--processes", "2"],
        cwd=tmp_path, env=HERE, stderr=subprocess.PIPE, text=True,
        # tests started in the background of a shell would hand on that ^C is ignored
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )  # fmt: skip
    deadline = time.monotonic() + 120.0
    while not list(tmp_path.glob("out/rows/*.json")):
        assert run.poll() is None
        assert time.monotonic() < deadline
        time.sleep(0.05)
    run.send_signal(signal.SIGINT)
    _, told = run.communicate(timeout=20)
    assert (run.returncode, told.strip()) == (130, "bondem: interrupted")


@pytest.mark.validate
def test_dispersion_goes_on_after_a_packing_that_fails(tmp_path):
    # six contacts for each of 12 spheres in a cube cannot be had without overlaps beyond measure
    done = validation(
        "dispersion", "--out", "out", "--count", "12", "--spreads", "0.25", "--method", "quench", "--processes", "1",
        cwd=tmp_path,
    )  # fmt: skip
    assert done.returncode == 2
    assert done.stderr.startswith("bondem: 1 of 1 packings failed")
    assert done.stderr.count("\n") == 1
    results = json.loads((tmp_path / "out" / "results.json").read_text())
    assert results["failed"] == 1
    assert results["rows"][0]["error"]


@pytest.mark.validate
def test_dispersion_draws_and_judges(tmp_path):
    done = validation(
        "dispersion", "--out", "out", "--count", "500", "--spreads", "0,0.25", "--method", "quench",
        "--processes", "2", cwd=tmp_path,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    results = json.loads((tmp_path / "out" / "results.json").read_text())
    equal, spread = results["rows"]
    assert equal["rms_excess"] > spread["rms_excess"]
    assert results["isotropy_error_in_print"] > results["isotropy_error_largest_possible"] > equal["isotropy_error"]
    names = {path.stem for path in (tmp_path / "out" / "figures").glob("*.png")}
    assert names == {"packings", "histograms", "dispersion"}


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["dispersion"], "--out"),
        (["dispersion", "--out", "out", "--spreads", "a"], "commas"),
        (["dispersion", "--out", "out", "--spreads", "2.5", "--method", "quench"], "less than 2"),
        (["dispersion", "--out", "out", "--spreads", "0,0", "--method", "quench"], "twice"),
        (["dispersion", "--out", "out", "--method", "shake"], "shake"),
        (["dispersion", "--out", "out", "--processes", "0"], "--processes"),
        (["refinement", "--out", "out", "--counts", "5"], "at least 10"),
        (["refinement", "--out", "out", "--counts", "1e3"], "commas"),
        (["refinement", "--out", "file", "--counts", "100"], "folder"),
        (["refinement", "--out", "out", "--seeds", "3"], "--seeds"),
        (["refinement", "--out", "out", "--targets", "dense"], "dense"),
    ],
)
def test_what_cannot_be_done_is_told_in_one_line(tmp_path, monkeypatch, capsys, arguments, told):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").touch()
    monkeypatch.setattr(sys, "argv", ["validation", *arguments])
    with pytest.raises(SystemExit) as stopped:
        main()
    said = capsys.readouterr().err
    assert stopped.value.code == 2
    assert said.count("\n") == 1
    assert told in said
    assert not (tmp_path / "out").exists()


def test_the_sizes_are_those_of_the_paper():
    study = Refinement(targets=("jamming",), periodic=0)
    assert len(study.counts) == 22
    assert max(study.counts) == 50_000
    assert len(study.requests) == 110
    with pytest.raises(InputError, match="at least 1"):
        Refinement(packings=0)
    assert len(Dispersion().requests) == 9


def test_a_changed_request_or_version_is_not_taken_for_the_old(tmp_path, monkeypatch):
    one = request(tmp_path)
    row = made_row(one, tmp_path)
    assert kept_row(one, tmp_path) == row
    others = [request(tmp_path, **change) for change in (
        {"count": 61}, {"spread": 0.2}, {"method": "growth"}, {"target": "contacts"}, {"seed": 2}, {"periodic": True},
    )]  # fmt: skip
    assert len({other.name for other in others} | {one.name}) == 7
    assert all(kept_row(other, tmp_path) is None for other in others)
    monkeypatch.setattr("validation.frame.request.code_hash", lambda module: "another version")
    assert kept_row(one, tmp_path) is None


def test_half_a_row_is_no_row(tmp_path):
    one = request(tmp_path)
    made_row(one, tmp_path)
    text = one.row_file(tmp_path).read_text()
    for damaged in (text[: len(text) // 2], "[]", "{}", ""):
        one.row_file(tmp_path).write_text(damaged)
        assert kept_row(one, tmp_path) is None


def test_a_failed_packing_is_a_row_and_is_told(tmp_path):
    one = request(tmp_path, method="shake")
    row = made_row(one, tmp_path)
    assert "shake" in row["error"]
    assert kept_row(one, tmp_path) == row
    with pytest.raises(PackingError, match=r"1 of 1 packings failed.*shake"):
        complain([row], tmp_path)
    found = summary([row], ("count",))[0]
    assert (found["packings"], found["failed"]) == (1, 1)
    assert found["volume_fraction"] == {"mean": None, "std": None}


def test_the_threshold_in_print_excludes_nothing():
    counts = np.zeros(320)
    counts[7] = 1.0
    assert float(np.mean((counts - 1.0 / 320.0) ** 2)) == pytest.approx(LARGEST_POSSIBLE, rel=1e-12)
    assert LARGEST_POSSIBLE < PRINTED_THRESHOLD


def test_e_of_a_random_fabric():
    # bonds of random direction between pairs of spheres far apart
    random = np.random.default_rng(1)
    found = []
    for _ in range(20):
        direction = random.normal(size=(2000, 3))
        direction /= np.linalg.norm(direction, axis=1)[:, None]
        start = 10.0 * np.arange(2000)[:, None] * [1.0, 0.0, 0.0]
        sphere = bd.Particles(np.stack([start, start + direction], axis=1).reshape(-1, 3), 0.5)
        pairs = np.arange(4000).reshape(-1, 2)
        found.append(bd.fabric(bd.Lattice(sphere, pairs)).isotropy_error)
    expected = random_isotropy_error(2000)
    assert np.mean(found) == pytest.approx(expected, abs=4.0 * np.std(found) / np.sqrt(20))
    assert np.std(found) / np.sqrt(20) < 0.05 * expected


def test_the_limit_is_found_with_its_uncertainty():
    random = np.random.default_rng(3)
    count = np.repeat(np.geomspace(1000, 50_000, 12), 5)
    pulls = []
    for _ in range(40):
        noise = 0.02 / np.sqrt(count) * random.normal(size=len(count))
        fit = limit(count, 0.64 - 0.4 * count ** (-1 / 3) + 0.3 * count ** (-2 / 3) + noise)
        pulls.append((fit.value - 0.64) / fit.error)
        assert fit.error < 0.001
    assert 0.6 < np.std(pulls) < 1.4
    assert abs(np.mean(pulls)) < 0.5
    assert limit(count[:20], count[:20]) is None
