"""The battery of loading paths: how verdicts come about, which cases there are, and how speeds change on a path."""

import json
from pathlib import Path

import numpy as np
import pytest

from validation.frame.record import Record
from validation.studies import loading_paths as battery
from validation.studies.paths.driving import speeds, travel
from validation.studies.paths.rows import Row, table, verdicts


def test_a_tolerance_is_on_each_row_or_on_their_mean() -> None:
    each = [Row("a", "peak", measured, 2.0, 0.05, seed, 400) for seed, measured in ((1, 2.0), (2, 2.12))]
    mean = [Row("a", "work", measured, 2.0, 0.05, seed, 400, mean=True) for seed, measured in ((1, 2.0), (2, 2.12))]
    lost = [Row("a", "nothing", float("nan"), 1.0, 0.05, 1, 400)]
    exact = [Row("b", "peak", 1.0, 1.0, 0.0, 1, 400)]
    found = verdicts([*each, *mean, *lost, *exact])
    assert [(one.case, one.name, one.verdict, one.on) for one in found] == [
        ("a", "peak", "missed", "each"), ("a", "work", "met", "mean"), ("a", "nothing", "missed", "each"),
        ("b", "peak", "met", "each"),
    ]  # fmt: skip
    assert found[0].worst == pytest.approx(1.06)
    assert found[0].mean == pytest.approx(1.03)
    with pytest.raises(ValueError, match="one tolerance"):
        verdicts([each[0], Row("a", "peak", 2.0, 2.0, 0.06, 3, 400)])


def test_where_nothing_is_expected_a_tolerance_is_in_the_unit_and_a_stated_number_is_not_judged() -> None:
    left = [Row("a", "left", measured, 0.0, 0.05, seed, 400) for seed, measured in ((1, -0.06), (2, 0.04))]
    told = [Row("a", "pressure", float("nan"), 3.0, None, 1, 400), Row("a", "pressure", 1.5, 3.0, None, 2, 400)]
    found = verdicts([*left, *told])
    assert [one.verdict for one in found] == ["missed", "stated"]
    assert found[0].worst == pytest.approx(-0.06)
    assert found[0].mean == pytest.approx(-0.01)
    assert (found[1].mean, found[1].worst) == (None, None)
    before = verdicts([Row("a", name, 0.3, 0.0, 0.05, 1, 400) for name in ("left", "slip")])
    text = table(found, [*left, *told], before)
    assert text.endswith("not measured again: a: slip\n")
    assert "| a | left | 2 | -0.010 | -0.060 | 1 | 0.300 | 0.300 | 5 % | each | missed |" in text
    assert "| a | pressure | 2 | – | – | – | – | – | – | each | stated |" in text
    assert "0 of 1 quantities met" in text


def test_a_quick_run_does_one_packing_and_the_smallest_bodies() -> None:
    assert "many_cycles" not in battery.USUAL
    assert battery.tasks(["cross", "plain"], battery.SEEDS, (), quick=True) == [("cross", 1, 400), ("plain", 1, 200)]
    whole = battery.tasks(battery.USUAL, battery.SEEDS, (), quick=False)
    assert {name for name, _, _ in whole} == set(battery.USUAL)
    assert {seed for _, seed, _ in whole} == {1, 2, 3, 4, 5}
    assert battery.tasks(["plain"], [3], [50], quick=False) == [("plain", 3, 50)]


def test_results_are_summed_up_from_what_was_kept(tmp_path: Path) -> None:
    row = Row("cross", "strength", 0.64, 1.0, 0.05, 1, 400)
    record = Record(tmp_path / "loading_paths.json")
    kept = {"task": "cross", "seed": 1, "count": 400, "seconds": 1.0, "commit": "c", "rows": [row.as_json()]}
    record.keep(cases=[kept])
    battery.measure(record, cases=("cross",), seeds=(1,))
    found = json.loads(record.path.read_text())
    assert found["cases"] == [kept]
    assert [one["verdict"] for one in found["verdicts"]] == ["missed"]
    text = (tmp_path / "loading_paths.md").read_text()
    assert "| cross | strength | 1 | 0.640 | 0.640 | 5 % | each | missed |" in text
    assert "0 of 1 quantities met" in text


def test_a_path_goes_through_its_points_without_jumps_of_speed() -> None:
    times, values = travel([(0.0, 0.0), (8.0, -2.0), (8.0, -2.0), (7.9, 0.0)], speed=2.0, rise=0.5, begin=3.0)
    assert times[0] == 3.0
    assert (np.diff(times) > 0.0).all()
    assert values[-1] == pytest.approx((7.9, 0.0))
    rate = np.diff(values, axis=0) / np.diff(times)[:, None]
    assert np.abs(rate).max() == pytest.approx(2.0)
    assert np.abs(np.diff(rate, axis=0)).max() < 0.3
    # a leg takes its way over the speed and the time in which the speed changes; a rest three times that
    assert times[-1] - 3.0 == pytest.approx((4.0 + 0.5) + 1.5 + (1.0 + 0.5))
    way = np.concatenate([[values[0]], values[0] + np.cumsum(
        0.5 * np.diff(times)[:, None] * (speeds(times, values)[1:] + speeds(times, values)[:-1]), axis=0
    )])  # fmt: skip
    assert way == pytest.approx(values, abs=1e-12)
    assert np.abs(speeds(times, values)).max() == pytest.approx(2.0)
    assert speeds(times, values)[-1] == pytest.approx((0.0, 0.0), abs=1e-9)
