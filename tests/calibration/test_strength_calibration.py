"""Calibration of strengths: on closed forms it meets targets in few runs, repeats none, and says where it fails."""

import json
import math
import threading
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import bondem as bd
from bondem.cli import bondem as group
from bondem.errors import ConvergenceError, InputError, UnstableRunError
from tests.specimens import bar

TARGETS = {"ucs": (55e6, 0.2e6), "brazilian": (4e6, 0.03e6)}
START = {"tension": 4e6, "cohesion": 7e6}
BOTH = ("tension", "cohesion")


class Laboratory:
    """Two strengths in closed form, proportional to both parameters together, and how often each was asked."""

    def __init__(self, factors=(1.0,)):
        self.factors = factors
        self.asked = []

    def ucs(self, tension, cohesion):
        self.asked.append(("ucs", tension, cohesion))
        return [2.5 * (f * cohesion) ** 0.9 * tension**0.1 for f in self.factors]

    def brazilian(self, tension, cohesion):
        self.asked.append(("brazilian", tension, cohesion))
        return [1.0 / (1.0 / (0.9 * tension) + 1.0 / (0.5 * f * cohesion)) for f in self.factors]

    @property
    def tests(self):
        return {"ucs": self.ucs, "brazilian": self.brazilian}


def test_both_targets_are_met_in_few_runs_with_the_slopes_of_the_closed_form():
    fit = bd.calibrate_strength(Laboratory().tests, TARGETS, START, strengths=BOTH)
    assert fit.reached
    assert len(fit.runs) <= 6
    found = fit.parameters
    t, c = found["tension"], found["cohesion"]
    assert 2.5 * c**0.9 * t**0.1 == pytest.approx(55e6, abs=0.2e6)
    assert 1.0 / (1.0 / (0.9 * t) + 1.0 / (0.5 * c)) == pytest.approx(4e6, abs=0.03e6)
    ucs = fit.sensitivities["ucs"]
    assert ucs["cohesion"] == pytest.approx(0.9, abs=0.02)
    assert ucs["tension"] == pytest.approx(0.1, abs=0.02)
    assert "reached after" in str(fit)


def test_knowing_what_scales_together_saves_a_run():
    with_scale = bd.calibrate_strength(Laboratory().tests, TARGETS, START, strengths=BOTH)
    without = bd.calibrate_strength(Laboratory().tests, TARGETS, START)
    assert without.reached
    assert len(with_scale.runs) <= len(without.runs)
    for name, value in without.parameters.items():
        assert with_scale.parameters[name] == pytest.approx(value, rel=0.02)


def test_a_single_strength_that_scales_needs_no_slope():
    tests = {"tension": lambda strength: 0.31 * strength}
    fit = bd.calibrate_strength(tests, {"tension": (4e6, 4e4)}, {"strength": 9e6}, strengths=("strength",))
    assert len(fit.runs) == 2
    assert fit.parameters["strength"] == pytest.approx(4e6 / 0.31, rel=0.01)


def test_friction_that_does_not_scale_is_found_beside_a_strength():
    tests = {
        "ucs": lambda strength, friction: strength * (8.0 + 6.0 * friction),
        "brazilian": lambda strength, friction: strength * (0.7 + 0.1 * friction),
    }
    fit = bd.calibrate_strength(tests, TARGETS, {"strength": 5e6, "friction": 0.1}, strengths=("strength",),
                                bounds={"friction": (0.01, 0.2)})  # fmt: skip
    assert not fit.reached  # 55 / 4 = 13.75 is more than any friction up to 0.2 gives
    assert "friction at a bound" in fit.message
    assert fit.nearest.parameters["friction"] == pytest.approx(0.2, rel=1e-6)
    with pytest.raises(ConvergenceError, match="not reached after"):
        _ = fit.parameters
    wider = bd.calibrate_strength(tests, TARGETS, {"strength": 5e6, "friction": 0.1}, strengths=("strength",))
    assert wider.reached
    friction = wider.parameters["friction"]
    assert (8.0 + 6.0 * friction) / (0.7 + 0.1 * friction) == pytest.approx(13.75, rel=0.02)


def test_an_interrupted_calibration_goes_on_and_repeats_nothing(tmp_path):
    whole = Laboratory()
    bd.calibrate_strength(whole.tests, TARGETS, START, strengths=BOTH)
    broken = Laboratory()
    most = len(whole.asked) - 3

    def killed(tension, cohesion):
        if len(broken.asked) >= most:
            raise KeyboardInterrupt
        return broken.brazilian(tension, cohesion)

    first = {"ucs": broken.ucs, "brazilian": killed}
    with pytest.raises(KeyboardInterrupt):
        bd.calibrate_strength(first, TARGETS, START, strengths=BOTH, out=tmp_path)
    again = Laboratory()
    fit = bd.calibrate_strength(again.tests, TARGETS, START, strengths=BOTH, out=tmp_path)
    assert fit.reached
    assert broken.asked + again.asked == whole.asked
    assert not list(tmp_path.glob(".*"))  # nothing half written
    once_more = Laboratory()
    same = bd.calibrate_strength(once_more.tests, TARGETS, START, strengths=BOTH, out=tmp_path)
    assert same.parameters == fit.parameters
    assert not once_more.asked


def test_runs_about_something_else_are_refused(tmp_path):
    bd.calibrate_strength(Laboratory().tests, TARGETS, START, out=tmp_path, about="packing 1")
    with pytest.raises(InputError, match="about 'packing 1', not 'packing 2'; choose another folder"):
        bd.calibrate_strength(Laboratory().tests, TARGETS, START, out=tmp_path, about="packing 2")
    (tmp_path / "strength_calibration.json").write_text(json.dumps({"about": "", "tests": [{}]}))
    with pytest.raises(InputError, match="not a file of runs"):
        bd.calibrate_strength(Laboratory().tests, TARGETS, START, out=tmp_path)


def test_intervals_come_from_the_scatter_of_packings():
    lab = Laboratory(factors=(0.97, 1.0, 1.03))
    fit = bd.calibrate_strength(lab.tests, TARGETS, START, strengths=BOTH)
    sample = fit.sample("cohesion")
    # a packing with 3 % more of what cohesion gives takes 3 % less cohesion, to first order
    assert sample.values / sample.mean == pytest.approx([1.03, 1.0, 0.97], abs=5e-3)
    assert fit.sample("tension").std / fit.sample("tension").mean < 5e-3
    low, high = fit.interval("cohesion")
    assert low < fit.parameters["cohesion"] < high
    assert math.isclose(math.log(high / low), 2 * 2.484 * np.log(sample.values).std(ddof=1), rel_tol=1e-3)  # t_2 / √3
    least, largest = fit.tolerated("cohesion")
    assert least < fit.parameters["cohesion"] < largest
    assert "by the scatter of packings" in str(fit)
    one = bd.calibrate_strength(Laboratory().tests, TARGETS, START)
    with pytest.raises(InputError, match="single packing has no scatter"):
        one.interval("cohesion")
    unseen = {"ucs": [54e6, 56e6], "brazilian": [4e6, 4e6]}
    assert one.interval("cohesion", unseen)[0] < one.parameters["cohesion"]
    with pytest.raises(InputError, match="choose from tension, cohesion"):
        one.sample("friction")
    with pytest.raises(InputError, match="give ucs, brazilian of the same packings"):
        one.sample("tension", {"ucs": [5e7]})


def test_tests_that_tell_parameters_not_apart_end_early_and_say_so():
    lab = Laboratory()
    tests = {"ucs": lab.ucs, "brazilian": lambda tension, cohesion: 0.1 * lab.ucs(tension, cohesion)[0]}
    fit = bd.calibrate_strength(tests, TARGETS, START)
    assert not fit.reached
    assert len(fit.runs) < 15
    assert "do not determine all parameters" in fit.message


def test_noise_above_the_tolerance_uses_up_its_runs_or_gives_up():
    steps = iter(range(1000))

    def noisy(strength):
        return strength * (1.0 + 0.1 * (-1.0) ** next(steps))

    fit = bd.calibrate_strength({"t": noisy}, {"t": (4e6, 1e3)}, {"strength": 9e6}, strengths=("strength",))
    assert not fit.reached
    assert len(fit.runs) <= 15
    assert "not reached after" in fit.message
    assert abs(fit.nearest.mean("t") / 4e6 - 1.0) < 0.25


def test_a_test_that_fails_on_the_way_halves_the_step():
    def fragile(strength):
        if strength > 11.8e6:
            raise UnstableRunError("the run became unstable")
        return 0.31 * strength * (strength / 4e6) ** 0.1

    fit = bd.calibrate_strength({"t": fragile}, {"t": (4e6, 4e4)}, {"strength": 6e6}, strengths=("strength",))
    assert fit.reached
    assert any(run.failed for run in fit.runs)
    with pytest.raises(UnstableRunError, match="at the start, t: the run became"):
        bd.calibrate_strength({"t": fragile}, {"t": (4e6, 4e4)}, {"strength": 15e6})


def test_tests_of_all_packings_at_once_are_those_one_by_one():
    """Four functions, each of which goes on only when all four are under way."""
    whole = bd.calibrate_strength(Laboratory((0.9, 1.1)).tests, TARGETS, START, strengths=BOTH)
    meeting = threading.Barrier(4, timeout=20.0)

    def of(test, factor):
        def strength(tension, cohesion):
            meeting.wait()
            return getattr(Laboratory((factor,)), test)(tension, cohesion)[0]

        return strength

    apart = {test: [of(test, factor) for factor in (0.9, 1.1)] for test in TARGETS}
    with ThreadPoolExecutor(4) as executor:
        fit = bd.calibrate_strength(apart, TARGETS, START, strengths=BOTH, executor=executor)
    assert fit.runs == whole.runs
    assert len(fit.runs[0].measured["ucs"]) == 2


def test_a_dask_cluster_calibrates():
    distributed = pytest.importorskip("distributed")
    with distributed.Client(processes=False, n_workers=1, threads_per_worker=2, dashboard_address=None) as client:
        fit = bd.calibrate_strength(
            Laboratory().tests, TARGETS, START, strengths=BOTH, executor=client.get_executor()
        )
    assert fit.runs == bd.calibrate_strength(Laboratory().tests, TARGETS, START, strengths=BOTH).runs


def test_of_tests_at_once_those_that_are_done_are_kept_where_another_fails(tmp_path):
    lab = Laboratory()

    def falls(tension, cohesion):
        raise UnstableRunError("the run became unstable")

    with ThreadPoolExecutor(2) as executor, pytest.raises(UnstableRunError, match="at the start, brazilian"):
        bd.calibrate_strength({"brazilian": falls, "ucs": lab.ucs}, TARGETS, START, out=tmp_path, executor=executor)
    kept = json.loads((tmp_path / "strength_calibration.json").read_text())["tests"]
    assert [(row["test"], bool(row["failed"])) for row in kept] == [("brazilian", True), ("ucs", False)]


def test_what_failed_before_spares_the_tests_after_it(tmp_path):
    def falls(tension, cohesion):
        raise UnstableRunError("the run became unstable")

    lab = Laboratory()
    for _ in range(2):  # the second time the failure is in the file
        with pytest.raises(UnstableRunError, match="at the start, ucs"):
            bd.calibrate_strength({"ucs": falls, "brazilian": lab.brazilian}, TARGETS, START, out=tmp_path)
    assert lab.asked == []


def test_one_run_says_what_is_found_with_nothing_calibrated():
    fit = bd.calibrate_strength(Laboratory().tests, TARGETS, START, most=1)
    assert len(fit.runs) == 1
    assert fit.runs[0].mean("ucs") == pytest.approx(2.5 * 7e6**0.9 * 4e6**0.1)
    assert fit.sensitivities is None
    with pytest.raises(InputError, match="these runs have no slopes"):
        fit.tolerated("tension")


@pytest.mark.parametrize(("changed", "told"), [
    ({"tests": {}}, "give functions by name"),
    ({"tests": {"ucs": Laboratory().ucs}}, "give a target for each test"),
    ({"tests": {"ucs": 1.0, "brazilian": 2.0}}, "give a function of the parameters"),
    ({"targets": {"ucs": 55e6, "brazilian": 4e6}}, "give target and tolerance"),
    ({"targets": {"ucs": (55e6, 0.0), "brazilian": (4e6, 1e5)}}, "tolerance of ucs"),
    ({"targets": {"ucs": (-55e6, 1e6), "brazilian": (4e6, 1e5)}}, "target of ucs"),
    ({"start": {"tension": 4e6, "cohesion": 0.0}}, r"start\['cohesion'\]"),
    ({"start": {"tension": 4e6, "friction": 0.1}}, "does not take tension, friction as keywords"),
    ({"start": {"a": 1.0, "b": 1.0, "c": 1.0}}, "3 parameters for 2 tests"),
    ({"strengths": ("sigma",)}, "give names out of tension, cohesion"),
    ({"bounds": {"tension": (5e6, 9e6)}}, "start between its bounds"),
    ({"bounds": {"sigma": (5e6, 9e6)}}, "give two values for some of tension, cohesion"),
    ({"most": 0}, "most = 0"),
    ({"executor": 4}, "give one of concurrent.futures"),
    ({"tests": {"ucs": [], "brazilian": Laboratory().brazilian}}, "give a function of the parameters, or a list"),
    ({"tests": {"ucs": [Laboratory().ucs, 3], "brazilian": Laboratory().brazilian}}, "or a list"),
    ({"tests": {"ucs": [Laboratory((1.0, 1.0)).ucs], "brazilian": Laboratory().brazilian}}, "one for each packing"),
    ({"about": 3}, "give a text"),
    ({"tests": {"ucs": lambda tension, cohesion: -tension, "brazilian": Laboratory().brazilian}},
     "return a positive strength"),
    ({"tests": {"ucs": lambda tension, cohesion: None, "brazilian": Laboratory().brazilian}},
     "return a positive strength"),
])  # fmt: skip
def test_what_does_not_fit_is_refused_in_one_line(changed, told):
    given = {"tests": Laboratory().tests, "targets": TARGETS, "start": START} | changed
    with pytest.raises(InputError, match=told) as refused:
        bd.calibrate_strength(**given)
    assert "\n" not in str(refused.value)


def test_the_tensile_strength_of_a_prism_of_cells_is_found(tmp_path):
    body = bar(60, 20e-3)
    law = bd.CellBond(E=40e9, nu=0.2)

    def pulled(tension):
        failure = bd.Rankine(tension=tension, fracture_energy=20.0)
        return bd.labtests.direct_tension(body, law, failure, traverses=20.0).peak

    fit = bd.calibrate_strength({"tension": pulled}, {"tension": (4e6, 4e4)}, {"tension": 3e6},
                                strengths=("tension",), out=tmp_path)  # fmt: skip
    assert fit.reached
    assert len(fit.runs) <= 3
    assert fit.parameters["tension"] == pytest.approx(4e6, rel=0.03)


@pytest.mark.validate
def test_the_command_calibrates_cells_and_goes_on_where_it_was(tmp_path, capsys):
    words = ["strength", "--E", "40 GPa", "--nu", "0.2", "--ucs", "55 MPa", "--brazilian", "4 MPa", "--count", "200",
             "--friction-angle", "35 deg", "--fracture-energy", "20", "--diameter", "0.05", "--length", "0.05",
             "--brazilian-within", "0.6 MPa", "--out", str(tmp_path)]  # fmt: skip
    group.main(words, standalone_mode=False)
    told = capsys.readouterr().out
    assert "reached after" in told
    assert "bd.MohrCoulomb(tension=" in told
    kept = json.loads((tmp_path / "strength_calibration.json").read_text())["tests"]
    assert {row["test"] for row in kept} == {"ucs", "brazilian"}
    group.main(words, standalone_mode=False)
    assert "run 1, ucs" not in capsys.readouterr().out
    with pytest.raises(InputError, match="choose another folder"):
        group.main([*words, "--seed", "2"], standalone_mode=False)
    with pytest.raises(ConvergenceError, match="not reached after 1 run"):
        group.main([*words[:-4], "--brazilian-within", "1 Pa", "--most", "1", *words[-2:]], standalone_mode=False)
