"""Bad input: one clear line that says what is wrong and what to do, before any work, nothing half-written."""

import math
import os
import tomllib
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem.campaign.sweep import is_campaign
from bondem.errors import BondemError, DisconnectedError, EmptyRegionError, InputError, StudyError, UnstableStepError
from bondem.study.study_file import parse_study, read_study
from tests.scripts import command
from tests.specimens import chain, row

EXAMPLE = Path(__file__).parents[2] / "examples" / "silica.toml"
LAW = bd.EulerBernoulli(E=70e9, nu=0.3, radius_ratio=0.5)


def with_nan():
    position = row(3).centre.copy()
    position[1, 2] = math.nan
    return position


def model_of(boundary=()):
    return bd.Model(chain(12), LAW, 1000.0, boundary=boundary)


PARTICLES = row(3).particles
TWO_ROWS = np.concatenate([row(12).centre, row(12).centre + 1.0])
NOWHERE = bd.Within(bd.Ball(1e-9))

CASES = {
    "coincident centres": (InputError, "remove doubled", lambda: bd.Particles(np.zeros((2, 3)), 1e-3)),
    "overlap above half the smaller radius": (
        InputError, "more than half the smaller radius",
        lambda: bd.Particles([[0, 0, 0], [1.3e-3, 0, 0]], [1e-3, 1e-3]),
    ),
    "NaN position": (InputError, r"position\[1\]\[2\] is nan", lambda: bd.Particles(with_nan(), 0.5e-3)),
    "NaN radius": (InputError, r"radius\[0\] is nan", lambda: bd.Particles(row(2).centre, [math.nan, 1e-3])),
    "infinite position": (InputError, "finite", lambda: bd.Particles([[math.inf, 0, 0]], 1e-3)),
    "zero radius": (InputError, "must be positive", lambda: bd.Particles(row(2).centre, [0.5e-3, 0.0])),
    "negative radius": (InputError, r"radius\[1\] = -0.0005", lambda: bd.Particles(row(2).centre, [0.5e-3, -0.5e-3])),
    "a second large piece": (DisconnectedError, "pieces of 12 and 12 elements",
                             lambda: bd.connect(bd.Particles(TWO_ROWS, 0.5e-3))),
    "a region that selects nothing": (
        EmptyRegionError, "selects no connected element",
        lambda: model_of([bd.Fix(NOWHERE)]),
    ),
    "a load on nothing": (
        EmptyRegionError, "selects no connected element",
        lambda: model_of([bd.Load(NOWHERE, force=(1, 0, 0))]),
    ),
    "a gauge on nothing": (
        EmptyRegionError, "selects no connected element",
        lambda: bd.solve_explicit(model_of(), duration=1e-6, gauges={"g": bd.Gauge(NOWHERE, "velocity")}),
    ),
    "an unknown face": (InputError, "its faces are", lambda: model_of([bd.Fix(bd.Face("top"))])),
    "dt above the limit": (
        UnstableStepError, "pass dt=None or a smaller dt",
        lambda: bd.solve_explicit(model_of(), duration=1e-3, dt=1e-3),
    ),
    "dt not positive": (
        UnstableStepError, "positive time step",
        lambda: bd.solve_explicit(model_of(), duration=1e-3, dt=0.0),
    ),
    "NaN duration": (InputError, "duration", lambda: bd.solve_explicit(model_of(), duration=math.nan)),
    "a duplicate bond": (InputError, "duplicate", lambda: bd.Lattice(PARTICLES, [[0, 1], [1, 2], [1, 0]])),
    "a bond to itself": (InputError, "to itself", lambda: bd.Lattice(PARTICLES, [[0, 1], [2, 2]])),
    "an index out of range": (InputError, "from 0 to 2", lambda: bd.Lattice(PARTICLES, [[0, 3]])),
    "a negative index": (InputError, "from 0 to 2", lambda: bd.Lattice(PARTICLES, [[-1, 1]])),
    "an index region out of range": (InputError, "from 0 to 11", lambda: model_of([
        bd.Fix(bd.Index([12]))])),
    "E of a material": (InputError, "E = 0.0 Pa", lambda: bd.Material("m", E=0.0, nu=0.2, rho=1.0)),
    "E of a bond": (InputError, "E = -1.0 Pa", lambda: bd.EulerBernoulli(E=-1.0, nu=0.2, radius_ratio=0.5)),
    "NaN E": (InputError, "E = nan", lambda: bd.Timoshenko(E=math.nan, nu=0.2, radius_ratio=0.5)),
    "nu too large": (InputError, r"\(-1, 0.5\)", lambda: bd.Material("m", E=1.0, nu=0.5, rho=1.0)),
    "nu too small": (InputError, r"\(-1, 0.5\)", lambda: bd.EulerBernoulli(E=1.0, nu=-1.0, radius_ratio=0.5)),
    "density": (InputError, "density", lambda: bd.Model(row(12), LAW, density=-1.0)),
    "no radius of the bond": (InputError, "radius_ratio", lambda: bd.EulerBernoulli(E=1.0, nu=0.2)),
}  # fmt: skip


@pytest.mark.parametrize(("kind", "words", "call"), CASES.values(), ids=CASES)
def test_the_message_is_one_line_that_says_what_to_do(kind, words, call):
    with pytest.raises(kind, match=words) as caught:
        call()
    assert isinstance(caught.value, BondemError)
    assert "\n" not in str(caught.value)


STUDIES = {
    "unknown key": ("spread = 0.25", "spreed = 0.25", "'specimen.spreed'", "did you mean 'specimen.spread'"),
    "unknown key at the top": ("packings = 2", "colour = 2", "'colour'", "known here"),
    "unknown table": ("[bond]", "[bonds]", "'bonds'", "did you mean 'bond'"),
    "missing key": ("E = 72.5e9", "", "'material.E' is missing", "give a number above 0 [Pa]"),
    "E = 0": ("E = 72.5e9", "E = 0.0", "'material.E' = 0.0", "give a number above 0 [Pa]"),
    "E < 0": ("E = 72.5e9", "E = -72.5e9", "'material.E'", "give a number above 0 [Pa]"),
    "E is NaN": ("E = 72.5e9", "E = nan", "'material.E' = nan", "give a number above 0 [Pa]"),
    "E is text": ("E = 72.5e9", "E = '72.5'", "'material.E' = '72.5' is text", "leave out the quotes"),
    "E is a length": ("E = 72.5e9", "E = '72.5 mm'", "'material.E' = '72.5 mm'", "mm is not a unit of [Pa]"),
    "E in an unknown unit": ("E = 72.5e9", "E = '72.5 Gpa'", "'material.E'", "unit 'Gpa' is not known"),
    "nu = 0.5": ("nu = 0.17", "nu = 0.5", "'material.nu' = 0.5", "between -1 and 0.5"),
    "nu = -1": ("nu = 0.17", "nu = -1", "'material.nu' = -1", "between -1 and 0.5"),
    "nu_mu": ("nu_mu = 0.3", "nu_mu = 0.7", "'bond.nu_mu'", "between -1 and 0.5"),
    "rho": ("rho = 2201.0", "rho = 0", "'material.rho'", "above 0"),
    "negative radius": ("radius = 5e-3", "radius = -5e-3", "'specimen.radius'", "above 0 [m]"),
    "count": ("count = 10_000", "count = 1e4", "'specimen.count'", "whole number"),
    "law": ("EulerBernoulli", "EulerBernouli", "'bond.law'", "did you mean 'EulerBernoulli'"),
    "test": ('"impact"', '"impakt"', "'impakt'", "did you mean 'impact'"),
    "packings": ("packings = 1", "packings = 3", "'calibration.packings' = 3", "increase 'packings'"),
    "both bond rules": ("tolerance = 0.0", "tolerance = 0.0\nreach = 1.1", "'bond.reach'", "not both"),
    "shape": ('"cylinder"', '"cone"', "'specimen.shape'", "cylinder, box"),
    "not TOML": ("[material]", "[material", "not valid TOML", "correct it"),
}


@pytest.mark.parametrize(("old", "new", "key", "advice"), STUDIES.values(), ids=STUDIES)
def test_a_bad_study_names_the_key(tmp_path, old, new, key, advice):
    text = EXAMPLE.read_text()
    assert old in text
    text = text.replace(old, new) if old == "packings = 1" else text.replace(old, new, 1)
    try:
        data = tomllib.loads(text)
    except tomllib.TOMLDecodeError:
        return
    with pytest.raises(StudyError) as caught:
        parse_study(data)
    assert key in str(caught.value)
    assert advice in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16"])
@pytest.mark.parametrize("end", ["\r\n", "\r"])
def test_studies_of_other_editors_read_alike(tmp_path, encoding, end):
    text = EXAMPLE.read_text().replace('name = "fused silica"', 'name = "Glas, geprüft"')
    (tmp_path / "plain.toml").write_text(text, encoding="utf-8")
    (tmp_path / "other.toml").write_bytes(text.replace("\n", end).encode(encoding))
    other, plain = (read_study(tmp_path / name) for name in ("other.toml", "plain.toml"))
    assert other == replace(plain, source=("other.toml", text))
    assert not is_campaign(tmp_path / "other.toml")
    campaign = f"{text}\n[campaign]\nseeds = 2\n".replace("\n", end)
    (tmp_path / "campaign.toml").write_bytes(campaign.encode(encoding))
    assert is_campaign(tmp_path / "campaign.toml")


@pytest.mark.parametrize(("text", "encoding", "words"), [
    ("name = 'a'\n# Prüfkörper\n", "latin-1", r"line 2: the text is not UTF-8; save it with that encoding"),
    ("name = “granite”\n", "utf-8", "texts need straight quotes"),
])  # fmt: skip
def test_a_study_that_is_no_text_says_what_to_do(tmp_path, text, encoding, words):
    (tmp_path / "bad.toml").write_bytes(text.encode(encoding))
    with pytest.raises(StudyError, match=words):
        read_study(tmp_path / "bad.toml")


@pytest.mark.parametrize("name", ["unknown key", "E < 0", "nu = 0.5", "not TOML"])
def test_the_command_refuses_a_bad_study_in_one_line(tmp_path, name):
    old, new, key, advice = STUDIES[name]
    (tmp_path / "bad.toml").write_text(EXAMPLE.read_text().replace(old, new, 1))
    done = command("run", "bad.toml", "--out", "out", cwd=tmp_path)
    assert done.returncode == 2
    assert done.stdout == ""
    assert len(done.stderr.splitlines()) == 1
    assert key in done.stderr
    assert advice in done.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == ["bad.toml"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["run", "missing.toml", "--out", "out"], "study 'missing.toml' cannot be read"),
        (["run", EXAMPLE], "--out"),
        (["run", EXAMPLE, "--out", "out", "--packings", "0"], "packings"),
        (["run", EXAMPLE, "--out", "out", "--threads", "9999"], "threads"),
        (["run", EXAMPLE, "--out", "file/out"], "output folder 'file/out' cannot be written"),
        (["run", EXAMPLE, "--out", "file"], "output folder 'file' is a file"),
        (["resume", "missing.h5"], "'missing.h5': there is no run file"),
        (["resume", "file"], "not a run file"),
        (["walk"], "walk"),
        (["run", EXAMPLE, "--out", "out", "--colour", "red"], "--colour"),
    ],
    ids=lambda value: " ".join(map(str, value[:1] + value[2:])) if isinstance(value, list) else "",
)
def test_the_command_refuses_bad_arguments_in_one_line(tmp_path, arguments, words):
    (tmp_path / "file").write_text("")
    done = command(*arguments, cwd=tmp_path)
    assert done.returncode == 2
    assert len(done.stderr.splitlines()) == 1
    assert words in done.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == ["file"]


@pytest.mark.skipif(os.name != "posix" or os.geteuid() == 0, reason="permissions do not bind the superuser")
def test_no_permission_to_write(tmp_path):
    (tmp_path / "locked").mkdir(mode=0o500)
    done = command("run", EXAMPLE, "--out", "locked/out", cwd=tmp_path)
    assert done.returncode == 2
    assert "cannot be written (Permission denied)" in done.stderr
    with pytest.raises(InputError, match="Permission denied"):
        bd.solve_explicit(model_of(), duration=1e-6, out=tmp_path / "locked" / "run.h5")


@pytest.mark.skipif(not Path("/proc/self").is_dir(), reason="needs a file system on which nobody may write")
def test_not_even_the_superuser_may_write(tmp_path):
    done = command("run", EXAMPLE, "--out", "/proc/bondem", cwd=tmp_path)
    assert done.returncode == 2
    assert "output folder '/proc/bondem' cannot be written" in done.stderr
    assert len(done.stderr.splitlines()) == 1
    with pytest.raises(InputError, match="choose a place you may write to"):
        bd.solve_explicit(model_of(), duration=1e-6, out="/proc/run.h5")


def test_an_unreachable_target_leaves_nothing_behind(tmp_path):
    text = EXAMPLE.read_text().replace("nu = 0.17", "nu = -0.5").replace("count = 10_000", "count = 300")
    (tmp_path / "study.toml").write_text(text)
    done = command("run", "study.toml", "--out", "out", "--packings", "1", cwd=tmp_path)
    assert done.returncode == 2
    assert "nu = -0.5: outside" in done.stderr
    assert len(done.stderr.splitlines()) == 1
    assert sorted(path.name for path in tmp_path.iterdir()) == ["study.toml"]
