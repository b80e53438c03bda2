"""`bondem info`, `watch`, `check`; who may write where; lines in messages; what is the user's own is no markup."""

import json
import math
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

import bondem as bd
from bondem._lock import sole
from bondem.errors import InputError, RunFileError, StudyError
from bondem.io.folder import only_writer
from bondem.io.runfile import RunFile
from bondem.study.lines import line_of
from bondem.study.programme import read
from tests.models import loaded_row
from tests.scripts import command

EXAMPLES = Path(__file__).parents[2] / "examples"


def finished(folder: Path) -> Path:
    place = folder / "run.h5"
    bd.solve_explicit(
        loaded_row((0.0, -1.0, 0.0)), duration=2e-4, every=100, save_every=1000, snapshot_every=500, out=place
    )
    return place


def test_contents_are_those_of_the_run(tmp_path: Path) -> None:
    place = finished(tmp_path)
    found, kept = bd.read_contents(place), bd.read_run(place)
    assert (found.elements, found.bonds, found.cells) == (12, 11, False)
    assert found.step == found.steps == kept.state.step
    assert found.time == kept.state.time
    assert found.records == len(kept.history)
    assert found.snapshots == 1 + math.ceil(found.steps / 500)  # the last one is the end
    assert found.imbalance == pytest.approx(kept.history.imbalance)
    assert found.broken == 0
    assert not found.written
    assert found.seconds > 0.0
    assert found.left == 0.0
    assert {"bondem", "numpy", "h5py", "python", "machine", "started"} == set(found.provenance)
    assert json.loads(found.as_json())["steps"] == found.steps


def test_contents_of_what_is_no_run_file(tmp_path: Path) -> None:
    with pytest.raises(RunFileError, match="there is no run file"):
        bd.read_contents(tmp_path / "none.h5")
    (tmp_path / "text.h5").write_text("hello")
    with pytest.raises(RunFileError, match="not a run file"):
        bd.read_contents(tmp_path / "text.h5")


def test_info_and_watch_tell_of_a_run(tmp_path: Path) -> None:
    place = finished(tmp_path)
    done = command("info", place, cwd=tmp_path)
    assert done.returncode == 0
    for words in ("finished", "12 spheres, 11 bonds", "ParaView opens the file", "error of the energy balance"):
        assert words in done.stdout
    told = json.loads(command("info", place, "--json", cwd=tmp_path).stdout)
    assert told["step"] == told["steps"]
    watched = command("watch", place, cwd=tmp_path)
    assert watched.returncode == 0
    assert watched.stdout.count("step ") == 1
    missing = command("watch", "none.h5", "--patience", "0", "--interval", "0.05", cwd=tmp_path)
    assert missing.returncode == 2
    assert missing.stderr.count("\n") == 1


def test_a_file_that_is_written_says_so(tmp_path: Path) -> None:
    place = finished(tmp_path)
    kept = bd.read_run(place)
    with RunFile(place, kept.model, kept.plan, goes_on=kept):
        assert bd.read_contents(place).written
    assert not bd.read_contents(place).written


@pytest.mark.parametrize("example", sorted(EXAMPLES.glob("*.toml")), ids=lambda path: path.stem)
def test_check_tells_what_every_example_does(example: Path, monkeypatch, capsys) -> None:
    from bondem.cli.check import command as check

    check.main([str(example)], standalone_mode=False)
    told = capsys.readouterr().out
    assert "is valid" in told
    for words in ("elements", "memory", "packings", "material", "law", "tests"):
        assert words in told


@pytest.mark.parametrize(
    ("wrong", "right", "words"),
    [
        ("nuu = 0.2", "nu = 0.2", "did you mean 'material.nu'"),
        ('radius = "50 MPa"', 'radius = "50 mm"', "MPa is not a unit of"),
        ('pressure = "5 mm"', 'pressure = "5 MPa"', "mm is not a unit of"),
        ('criterion = "MohrColoumb"', 'criterion = "MohrCoulomb"', "did you mean 'MohrCoulomb'"),
    ],
)
def test_messages_name_the_line(tmp_path: Path, wrong: str, right: str, words: str) -> None:
    text = (EXAMPLES / "concrete.toml").read_text(encoding="utf-8")
    line = 1 + next(k for k, one in enumerate(text.splitlines()) if one.startswith(right))
    place = tmp_path / "study.toml"
    place.write_text(text.replace(right, wrong, 1), encoding="utf-8")
    with pytest.raises(StudyError, match=f"study.toml, line {line}: .*{words}"):
        read(place)


def test_lines_of_keys() -> None:
    text = 'name = "x"\n[a]\nb = 1\n[[c]]\nd = 2\n[c.e]\nf = 3\n[[c]] # second\n"d" = 4\n[c.e]\nf = 5\n'
    wanted = {"name": 1, "a": 2, "a.b": 3, "c[0].d": 5, "c[0].e.f": 7, "c[1].d": 9, "c[1].e.f": 11, "a.z": 2}
    assert {key: line_of(text, key) for key in wanted} == wanted
    assert line_of(text, "unknown") is None


def test_one_process_writes_a_folder(tmp_path: Path) -> None:
    out = tmp_path / "out"
    with only_writer(out, "output folder"):
        done = command("run", EXAMPLES / "ucs.toml", "--out", out, cwd=tmp_path)
        assert done.returncode == 2
        assert "is being written by another process" in done.stderr
        assert done.stderr.count("\n") == 1
        with pytest.raises(InputError, match="another process"), only_writer(out, "output folder"):
            pass
    assert list(tmp_path.iterdir()) == []
    with only_writer(out, "output folder"):
        pass


def test_a_lock_goes_with_its_owner(tmp_path: Path) -> None:
    place = tmp_path / ".lock"
    code = "import time\nfrom pathlib import Path\nfrom bondem._lock import sole\n"
    code += f"with sole(Path({str(place)!r})) as mine:\n    print(mine, flush=True)\n    time.sleep(60)"
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True) as owner:
        assert owner.stdout is not None
        assert owner.stdout.readline() == "True\n"
        with sole(place) as mine:
            assert not mine
        owner.send_signal(signal.SIGKILL)
        owner.wait()
    with sole(place) as mine:
        assert mine
    assert not place.exists()


def test_names_of_the_user_are_no_markup(tmp_path: Path) -> None:
    study = tmp_path / "study.toml"
    study.write_text(
        'name = "Beam [/8] [bold]"\nseed = 1\n[specimen]\nshape = "box"\nsize = [0.01, 0.01, 0.02]\ncount = 200\n'
        "[output]\nfigures = false\n"
    )
    done = command("run", study, "--out", "out [/b]", "--log", "run.log", cwd=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    lines = [line.partition(" ")[2] for line in (tmp_path / "run.log").read_text().splitlines()]
    assert (lines[0], lines[-1]) == ("started", "ended")
    assert {"pack 1 of 2 100 %", "test 2 of 2 100 %"} <= set(lines)
    elsewhere = command("run", study, "--out", "out", "--log", "none/run.log", cwd=tmp_path)
    assert (elsewhere.returncode, elsewhere.stderr.count("\n")) == (2, 1)
    assert "--log = 'none/run.log': cannot be written" in elsewhere.stderr
    assert "Beam [/8] [bold]" in done.stdout
    assert "out [/b]" in done.stdout


def test_a_shell_completes_commands(tmp_path: Path) -> None:
    done = command("completion", "fish", cwd=tmp_path)
    assert done.returncode == 0
    assert "_BONDEM_COMPLETE=fish_complete" in done.stdout
    asked = os.environ | {"_BONDEM_COMPLETE": "bash_complete", "COMP_WORDS": "bondem re", "COMP_CWORD": "1"}
    code = "import sys; sys.argv = ['bondem']; from bondem.cli import main; main()"
    told = subprocess.run([sys.executable, "-c", code], env=asked, capture_output=True, text=True, timeout=60).stdout
    assert told.split() == ["plain,render", "plain,resume"]


@pytest.mark.parametrize("options", [{}, {"field": "velocity", "show": "bonds"}, {"field": "fragment"}], ids=str)
def test_a_picture_of_a_run(tmp_path: Path, options: dict[str, str]) -> None:
    scenes = pytest.importorskip("bondem.report.scenes")
    image = pytest.importorskip("PIL.Image")
    place = finished(tmp_path)
    if options.get("show") == "bonds":
        with pytest.raises(InputError, match=r"field = 'velocity': no such field; choose from .*integrity, length"):
            scenes.render_run(place, tmp_path / "run.png", **options)
        options = options | {"field": "integrity"}
    out = scenes.render_run(place, tmp_path / "run.png", size=(300, 200), **options)
    with image.open(out) as picture:
        assert picture.size == (300, 200)
        assert len(picture.getcolors(1 << 20)) > 10
    with pytest.raises(InputError, match="snapshot = 9999"):
        scenes.render_run(place, tmp_path / "run.png", snapshot=9999)
    with pytest.raises(InputError, match=r"ends in .png"):
        scenes.render_run(place, tmp_path / "run.jpg")
    with pytest.raises(InputError, match="camera = 'above' is unknown; give one of iso, x"):
        scenes.render_run(place, tmp_path / "run.png", camera="above")


@pytest.mark.parametrize(("camera", "front"), [("iso", 1.0), ("-x", -1.0)])
def test_a_section_removes_the_half_in_front(tmp_path: Path, camera: str, front: float) -> None:
    scene = pytest.importorskip("bondem.report.scene")
    drawn = scene.Scene(finished(tmp_path), field=None, show="auto", section="x", warp=1.0, camera=camera, walls=True,
                        axes=True)  # fmt: skip
    body = drawn._body(drawn._pieces(0))
    assert front * (body.center[0] - drawn._middle[0]) < 0.0


def test_a_window_needs_a_display(tmp_path: Path, monkeypatch) -> None:
    pytest.importorskip("bondem.report.scenes")
    place = finished(tmp_path)
    monkeypatch.delenv("DISPLAY", raising=False)
    done = command("view", place, cwd=tmp_path)
    assert done.returncode == 2
    assert "no display is available" in done.stderr
    assert done.stderr.count("\n") == 1


@pytest.mark.validate
@pytest.mark.parametrize("number", range(6))
def test_an_interrupt_is_one_line(tmp_path: Path, number: int) -> None:
    study = tmp_path / "study.toml"
    study.write_text((EXAMPLES / "silica.toml").read_text(encoding="utf-8"), encoding="utf-8")
    with subprocess.Popen(
        [sys.executable, "-m", "bondem", "run", str(study), "--out", str(tmp_path / "out")],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=os.environ | {"BONDEM_PACKING_CACHE": "off"},
    ) as process:  # fmt: skip
        time.sleep(0.5 + 1.3 * number)
        process.send_signal(signal.SIGINT)
        _, told = process.communicate(timeout=60)
    assert process.returncode == 130
    assert told.strip() == "bondem: interrupted"
