"""`bondem check` refuses all that `bondem run` refuses before its first step, in the same words."""

import pytest

from tests.scripts import command

STUDY = """
name = "bar"
packings = 1
tests = ["{test}"]
[material]
name = "concrete"
E = "40 GPa"
nu = 0.2
rho = 2400.0
[failure]
criterion = "Rankine"
tension = {tension}
fracture_energy = 100.0
[specimen]
shape = "cylinder"
radius = {radius}
length = {length}
count = {count}
method = "even"
[bond]
law = "CellBond"
[output]
figures = false
{options}
"""
RIGHT = {"test": "direct_tension", "tension": '"4 MPa"', "radius": '"50 mm"', "length": '"200 mm"', "count": 100,
         "options": ""}  # fmt: skip
PULSE = '[spall]\npressure = "10 MPa"\nrise = "{0}"\nfall = "{0}"'
REFUSED = {
    "a strength in GPa": ({"tension": '"4 GPa"'}, "check the units of the strength"),
    "a radius in millimetres": ({"radius": "50", "length": "200"}, "use smaller elements"),
    "a pulse longer than the bar": ({"test": "spall", "options": PULSE.format("1 ms")}, "give a shorter pulse"),
}  # fmt: skip


def checked(tmp_path, **changes):
    (tmp_path / "study.toml").write_text(STUDY.format(**RIGHT | changes))
    return command("check", "study.toml", cwd=tmp_path)


@pytest.mark.parametrize(("changes", "words"), REFUSED.values(), ids=REFUSED)
def test_what_a_run_refuses_is_refused_by_check_in_the_same_words(changes, words, tmp_path) -> None:
    told = checked(tmp_path, **changes)
    run = command("run", "study.toml", "--out", "out", cwd=tmp_path)
    assert (told.returncode, run.returncode) == (2, 2)
    assert words in told.stderr
    assert told.stderr.splitlines()[-1] == run.stderr.splitlines()[-1]
    assert "is valid" not in told.stdout


def test_a_specimen_too_large_to_be_packed_by_check_is_judged_by_its_volume(tmp_path) -> None:
    told = checked(tmp_path, tension='"4 GPa"', count=1_000_000)
    assert told.returncode == 2
    assert "check the units of the strength" in told.stderr
    told = checked(tmp_path, count=1_000_000)
    assert told.returncode == 0
    assert "element sizes only" in told.stdout


def test_a_right_study_is_begun_and_one_in_other_units_is_warned_of_by_its_keys(tmp_path) -> None:
    told = checked(tmp_path)
    assert (told.returncode, told.stderr) == (0, "")
    assert "the first specimen is packed, and direct_tension began" in told.stdout
    told = checked(tmp_path, tension="4.0")
    assert told.returncode == 2  # a test of 10^15 steps
    assert "warning: 'failure.tension' = 4 Pa" in told.stderr
    assert "if MPa is meant, write 4e+06" in told.stderr
    told = checked(tmp_path, tension='"4 mPa"')
    assert "'failure.tension' = 0.004 Pa; solids have 1e+03 Pa or more" in told.stderr
    assert 'if MPa is meant, write "4 MPa"' in told.stderr
    told = checked(tmp_path, tension='"0.0004 MPa"')
    assert "400 Pa; solids have 1e+03 Pa or more; check its unit (Pa)" in told.stderr
