"""Every key of a study, given anything: taken, or refused in one line that names it; never a traceback."""

import copy
import math
import warnings

import pytest

import bondem as bd
from bondem.errors import StudyError
from bondem.study.study_file import Study, parse_study

WHOLE = {
    "name": "s", "seed": 1, "packings": 2, "tests": ["impact"],
    "material": {"name": "glass", "E": 70e9, "nu": 0.2, "rho": 2500.0, "source": "book"},
    "specimen": {"shape": "cylinder", "radius": 5e-3, "length": 30e-3, "count": 500, "method": "quench",
                 "coordination_number": 6.0, "sizes": {"law": "lognormal", "cv": 0.2, "cut": 2.0}},
    "bond": {"law": "Timoshenko", "nu_mu": 0.2, "tolerance": 0.0, "radius_rule": "mean"},
    "calibration": {"packings": 1},
    "output": {"figures": False, "vtk": False, "run_files": False, "packing_files": False},
    "reference": {"citation": "c", "E_mu": 1e9, "r_mu_ratio": 0.7, "errors": {"impact": 0.1}},
}  # fmt: skip
OTHERS = [
    {"specimen": {"shape": "box", "size": [1e-2, 1e-2, 4e-2], "count": 500, "spread": 0.2, "jamming": True}},
    {"specimen": {"shape": "ball", "radius": 5e-3, "count": 500, "volume_fraction": 0.6}},
    {"specimen": {"shape": "cell", "size": [1e-2, 1e-2, 1e-2], "count": 500,
                  "sizes": {"law": "sieve", "diameters": [1e-3, 2e-3], "mass_passing": [0.0, 1.0]}}},
    {"specimen": {"shape": "surface", "file": "part.stl", "unit": "mm", "count": 500}},
    {"specimen": {"particles": "spheres.csv", "unit": 1e-3, "shape": "ball", "radius": 1.0}},
    {"material": {"preset": "granite", "E": "60 GPa"}, "bond": {"reach": 1.1},
     "specimen": WHOLE["specimen"]},
]  # fmt: skip
VALUES = [math.nan, math.inf, -math.inf, 1e300, 1e-300, -1, 0, 1.5, 10**400, "", "text", "5 mm", "5 s", "70e9",
          "1e999 m", True, [], [1], ["a", "a"], [[]], {}, {"a": 1}, "\n", "x" * 1000]  # fmt: skip


def leaves(table, path=()):
    for key, value in table.items():
        yield (*path, key)
        if isinstance(value, dict):
            yield from leaves(value, (*path, key))


def studies():
    for number, change in enumerate([{}, *OTHERS]):
        whole = {"name": "s", **change} if number else WHOLE
        for path in leaves(whole):
            if number == 0 or path[0] in change:
                yield pytest.param(whole, path, id=f"{number}-{'.'.join(path)}")


@pytest.mark.parametrize(("whole", "path"), list(studies()))
def test_a_key_given_anything_is_taken_or_refused_by_its_name(whole, path, tmp_path):
    for value in VALUES:
        data = copy.deepcopy(whole)
        table = data
        for key in path[:-1]:
            table = table[key]
        table[path[-1]] = value
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", bd.errors.UnitWarning)
                assert isinstance(parse_study(data, folder=tmp_path), Study)
        except StudyError as error:
            told = str(error)
            assert "\n" not in told
            assert len(told) < 600
            assert any(key in told for key in path) or "file" in told, (value, told)
            assert ";" in told or "give" in told, told
        else:
            # what is taken is possible there: nothing that is no number, nor a number where a text belongs
            assert not (isinstance(value, float) and not math.isfinite(value)), value
            assert not isinstance(value, int) or abs(value) < 10**18, value


def test_a_key_that_is_not_known_is_refused():
    for path in leaves(WHOLE):
        if path[-1] in ("law", "shape", "preset"):
            continue
        data = copy.deepcopy(WHOLE)
        table = data
        for key in path[:-1]:
            table = table[key]
        table[path[-1] + "x"] = 1
        with pytest.raises(StudyError, match="unknown key"):
            parse_study(data)
