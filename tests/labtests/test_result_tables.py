"""Results of laboratory tests as figures and tables: every class of result is drawn and written."""

import csv
import math
import sys
from dataclasses import is_dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import bondem as bd
from bondem._drawing import Plotted, of_one_unit
from bondem.boundary.gauges import units_of
from bondem.errors import InputError
from bondem.labtests.ball import FragmentSizes
from bondem.labtests.cracking import Cracking
from tests.models import pulled, torn_row
from tests.specimens import bar, cells, crystal

LAW = bd.CellBond(E=40e9, nu=0.2)
SLOT = bd.Box((3e-3, 4e-3, 30e-3)).moved((18.5e-3, 0.0, -10e-3))


@cache
def run() -> bd.ExplicitResult:
    gauges = {"one": bd.Gauge(bd.Index([0]), "displacement")}
    return bd.solve_explicit(torn_row(), duration=2e-4, every=20, imbalance=None, gauges=gauges)


@cache
def strength() -> bd.labtests.StrengthTest:
    """A result with the records of a short run."""
    k = len(run().history)
    curve = np.column_stack([np.linspace(0.0, 1e-3, k), np.linspace(0.0, 4e6, k)])
    state = run().state
    cracking = Cracking(state.model.lattice, state, 0.5, 0.0, 0.0, 1.0, 100.0)
    return bd.labtests.StrengthTest(4e6, 4e9, curve, 1.0, 0.0, 0.0, 0.0, 0.0, cracking, run())


@cache
def bending(notched: bool) -> bd.labtests.BendingTest:
    shape: bd.Shape = bd.Box((40e-3, 10e-3, 10e-3))
    body = cells(shape.cut(SLOT, name="notch") if notched else shape, 250)
    failure = bd.Rankine(tension=4e6, fracture_energy=20.0)
    return bd.labtests.three_point_bending(body, LAW, failure, most=3)


def small() -> bd.Lattice:
    return bar(100)


def held() -> bd.Model:
    return replace(pulled(small()), failure=None)


def broken_ball() -> bd.labtests.BrokenBall:
    pieces = bd.fragments(run().state.model.lattice, run().state)
    return bd.labtests.BrokenBall(pieces, FragmentSizes(np.array([1e-3, 2e-3]), np.array([0.2, 1.0])), 0.0, 0.0)


def spalled() -> bd.labtests.SpallTest:
    thin, time = bd.labtests.ThinBar(40e9, 2400.0, 1e6, 1e-6, 1e-6), run().history.time
    none = np.zeros(1)
    return bd.labtests.SpallTest(thin, time, 0.0 * time, 0.0, None, None, none, np.zeros(2), none, 0.0, run())


def ringing() -> bd.labtests.FreeVibration:
    time = np.linspace(0.0, 1e-3, 50)
    signal = {kind: np.cos(2e4 * time) for kind in ("tension", "bending", "torsion")}
    return bd.labtests.FreeVibration(time, signal, {"work": 0.0 * time}, 0.0, 1e-6, 50)


def crushed() -> bd.labtests.SphereCrushing:
    return bd.labtests.SphereCrushing(1e3, 1e-2, strength().curve, 1.0, broken_ball(), 0.0, 0.0, 0.0, run())


def struck() -> bd.labtests.SphereImpact:
    time = run().history.time
    return bd.labtests.SphereImpact(
        (0.0, 0.0, -1.0), (0.0, 0.0, 1.0), time, 1e3 * time, broken_ball(), 0.5, 0.0, 0.0, run()
    )


def of_signal(**curves: Any) -> bd.labtests.Outcome:
    return bd.labtests.Outcome("test", 1.0, 1.1, "Hz", curves=curves)


# Every class of result, with names of columns and the number of panels of its figure.
RESULTS: dict[str, tuple[Any, set[str], int]] = {
    "StrengthTest": (strength, {"strain [-]", "stress [Pa]", "time [s]", "work [J]"}, 2),
    "TriaxialTest": (lambda: bd.labtests.TriaxialTest(strength(), 5e6), {"stress [Pa]"}, 2),
    "BrazilianTest": (lambda: bd.labtests.BrazilianTest(strength(), 1.0, 1.0, 0.1), {"stress [Pa]"}, 2),
    "BendingTest": (lambda: bending(True), {"CMOD [m]", "load [N]", "deflection [m]"}, 2),
    "BendingTest of a plain beam": (lambda: bending(False), {"deflection [m]", "load [N]"}, 2),
    "QuasistaticResult": (lambda: bending(True).path, {"displacement [m]", "load [N]", "cmod x [m]"}, 2),
    "SphereCrushing": (crushed, {"approach over diameter [-]", "2.8 F / (π D²) [Pa]"}, 2),
    "SphereImpact": (struck, {"time [s]", "force [N]"}, 2),
    "SpallTest": (spalled, {"time [s]", "velocity of the free end [m/s]"}, 2),
    "FreeVibration": (ringing, {"time [s]", "torsion [rad]", "work [J]"}, 1),
    "BrokenBall": (broken_ball, {"diameter [m]"}, 1),
    "FragmentSizes": (lambda: broken_ball().sizes, {"diameter [m]"}, 1),
    "ExplicitResult": (run, {"time [s]", "work [J]", "balance [J]", "one x [m]"}, 2),
    "Outcome without curve": (of_signal, {"measured [Hz]", "theory [Hz]"}, 1),
    "Outcome": (lambda: of_signal(x=np.arange(3.0), profile=np.arange(3.0)), {"x [m]"}, 1),
    "Tension": (lambda: bd.labtests.static_tension(small(), LAW), {"E [Pa]", "nu [-]", "strain xx [-]"}, 3),
    "UniformStress": (lambda: bd.labtests.uniform_stress(small(), LAW), {"row [-]", "stiffness xx [Pa]"}, 1),
    "BulkModuli": (lambda: bd.bulk_moduli(bd.connect(crystal(), reach=1.1),
                                          bd.Timoshenko(E=1e9, nu=0.2, radius_ratio=0.5)), {"stiffness xx [Pa]"}, 1),
    "NaturalFrequencies": (lambda: bd.labtests.natural_frequencies(small(), LAW, density=2400.0, count=6),
                           {"frequency [Hz]", "effective mass share x [-]"}, 2),
    "ModesResult": (lambda: bd.solve_modes(held(), count=2), {"mode [-]", "frequency [Hz]"}, 2),
    "StaticResult": (lambda: bd.solve_static(held()), {"x [m]", "von Mises stress [Pa]"}, 2),
}  # fmt: skip


@pytest.mark.parametrize("name", RESULTS)
def test_a_result_is_drawn_and_written(name: str, tmp_path: Path) -> None:
    make, wanted, panels = RESULTS[name]
    result = make()
    figure = result.plot(tmp_path / "figure.png")
    assert (tmp_path / "figure.png").stat().st_size > 5_000
    assert len([ax for ax in figure.axes if ax.get_label() != "<colorbar>"]) == panels
    result.to_csv(tmp_path / "table.csv")
    with open(tmp_path / "table.csv", encoding="utf-8", newline="") as stream:
        header, *rows = csv.reader(stream)
    assert wanted <= set(header)
    assert all(name.endswith("]") for name in header)
    read = np.array(rows, dtype=float)
    np.testing.assert_allclose(read, np.column_stack(list(result.table.values())), rtol=1e-9, atol=1e-300)


def test_every_class_of_result_is_here() -> None:
    found, left, shared = {Plotted}, [Plotted], {"OfOneTest"}  # what several results share is none by itself
    while left:
        more = left.pop().__subclasses__()
        found.update(more)
        left += more
    named = {name.split()[0] for name in RESULTS}
    kinds = {one.__name__ for one in found if one.__module__.startswith("bondem.") and is_dataclass(one)}
    assert kinds - shared == named


def test_a_table_needs_neither_pandas_nor_a_place_that_is_none(tmp_path: Path, monkeypatch: Any) -> None:
    monkeypatch.setitem(sys.modules, "pandas", None)
    ringing().to_csv(tmp_path / "table.csv")
    with pytest.raises(InputError, match=r"table '.*' is a folder"):
        ringing().to_csv(tmp_path)
    with pytest.raises(InputError, match=r"FreeVibration\.to_csv: path = 3"):
        ringing().to_csv(3)  # pyrefly: ignore[bad-argument-type]


@pytest.mark.parametrize(("gauge", "units"), [
    (bd.Gauge(bd.Everything(), "angular_velocity"), ("rad/s",) * 3), (bd.StrainGauge(bd.Everything()), ("-",) * 3),
    (bd.WallGauge(0, "growth"), ("m", "N", "N")), (bd.WallGauge(0, "torque"), ("N·m",) * 3),
    (bd.WallGauge(0, "power"), ("W",) * 3), (bd.Gauge(bd.Everything(), "force"), ("N",) * 3),
])  # fmt: skip
def test_columns_of_gauges_have_the_unit_of_their_quantity(gauge: Any, units: tuple[str, ...]) -> None:
    assert units_of(gauge) == units


def test_a_path_that_goes_back_has_the_envelope_that_a_laboratory_measures() -> None:
    """Loads and openings by hand: the events at 1 and 4 are below others, and the row of 9 N goes back."""
    mouth, load = np.array([0.0, 2.0, 1.0, 4.0, 3.0, 3.5, 5.0]), np.array([0.0, 8.0, 5.0, 10.0, 7.0, 9.0, 6.0])
    base = bending(True)
    curve = np.column_stack([mouth, load])
    found = replace(base, load=load, cmod=mouth, deflection=mouth, curve=curve)
    np.testing.assert_array_equal(found.envelope["CMOD [m]"], [0.0, 2.0, 4.0, 5.0])
    np.testing.assert_array_equal(found.envelope["load [N]"], [0.0, 8.0, 10.0, 6.0])
    assert list(found.envelope) == list(found.table)
    lines = {str(one.get_label()): one for one in found.plot().axes[0].get_lines()}
    assert set(lines) == {"every failure event", "envelope"}
    assert (len(lines["every failure event"].get_xdata()), len(lines["envelope"].get_xdata())) == (7, 5)


def test_tests_of_balls_and_spalled_bars_show_their_results_first() -> None:
    for result, first in ((struck(), "  damage: "), (crushed(), "  peak: "), (spalled(), "  peak: ")):
        assert repr(result).split("\n")[1].startswith(first)
    assert "peak: 0.199922 N" in repr(struck())  # 1e3 times the time of the last record


def test_columns_of_one_unit_are_drawn_together() -> None:
    table = {"time [s]": np.ones(2), "a [J]": np.ones(2), "b [N]": np.ones(2), "c [J]": np.ones(2)}
    assert list(of_one_unit(table)) == ["time [s]", "a [J]", "c [J]"]


def test_moduli_by_direction_are_those_along_the_axes() -> None:
    found = bd.labtests.uniform_stress(small(), LAW)
    drawn = found.drawn
    assert drawn["E from x to y [Pa]"][0] == pytest.approx(found.along("x")[0], rel=1e-12)
    assert drawn["E from x to y [Pa]"][90] == pytest.approx(found.along("y")[0], rel=1e-12)
    assert drawn["E from y to z [Pa]"][90] == pytest.approx(found.along("z")[0], rel=1e-12)
    assert math.isclose(drawn["angle in the plane [degree]"][90], 90.0)
