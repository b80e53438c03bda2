"""Pictures of lattices, models, runs and tests from Python."""

from pathlib import Path

import numpy as np
import pytest
from matplotlib.collections import PolyCollection

import bondem as bd
from bondem.errors import InputError
from bondem.labtests.cracking import Cracking
from tests.models import torn_row, turned_cubes
from tests.specimens import two_spheres


def words(figure) -> str:
    """All that is written in a figure."""
    figure.draw_without_rendering()
    texts = [text.get_text() for ax in figure.axes for text in ax.texts]
    texts += [ax.get_title() + ax.get_title("left") + ax.get_xlabel() + ax.get_ylabel() for ax in figure.axes]
    legends = [ax.get_legend() for ax in figure.axes]
    return " ".join([*texts, *(text.get_text() for one in legends if one for text in one.get_texts())])


def test_a_lattice_is_drawn(tmp_path: Path) -> None:
    body = turned_cubes()[0].lattice
    figure = body.plot(tmp_path / "body.png")
    for picture in ((tmp_path / "body.png").read_bytes(), figure._repr_png_()):
        assert picture.startswith(b"\x89PNG")
    assert "2 cells, 1 facets" in words(figure)
    assert "x 0 … 2000, y 0 … 1000, z 0 … 1000 mm" in words(figure)
    spheres = two_spheres()
    coloured = spheres.plot(tmp_path / "two.svg", values=[1.0, 3.0], label="load [N]", view=(0.0, 0.0))
    assert "load [N]" in words(coloured)
    for wrong, message in (
        ({"values": [1.0]}, r"values has shape \(1,\); give \(2,\)"), ({"view": (1.0,)}, "give azimuth"),
        ({"path": tmp_path / "a.jpg"}, "ends in .png, .pdf, .svg"), ({"path": tmp_path / "no/a.png"}, "no/a.png"),
    ):  # fmt: skip
        with pytest.raises(InputError, match=message):
            spheres.plot(**wrong)


def test_a_model_shows_supports_loads_and_walls() -> None:
    held, state = turned_cubes()
    ends = [bd.Fix(bd.Index([0]), rotation=""), bd.Load(bd.Index([1]), force=(0.0, 0.0, -5.0))]
    model = bd.Model(held.lattice, held.bond, 1e3, boundary=ends, contact=held.contact, walls=held.walls)
    text = words(model.plot())
    assert "fixed x y z" in text
    assert "load 5 N" in text
    pushed = bd.Pressure(bd.Face("x_max"), 1e3, bd.Table((0.0, 1e-3), (0.0, 2e3))), bd.Pressure(bd.Face("x_min"), 5e5)
    pressed = words(bd.Model(held.lattice, held.bond, 1e3, boundary=pushed).plot())
    assert "pressure 0 Pa … 2.00 MPa" in pressed
    assert "pressure 500 kPa" in pressed
    polygons = [one for one in model.plot().axes[0].collections if isinstance(one, PolyCollection)]
    assert len(polygons) == 3  # the cells and both walls
    driven = bd.Model(held.lattice, held.bond, 1e3, boundary=[bd.Drive(bd.Index([1]), vx=1.0)])
    assert "driven vx" in words(driven.plot())
    assert "motion × 2" in words(held.plot(solution=state, reach=2.0))
    with pytest.raises(InputError, match="has no displacement of 2 elements"):
        held.plot(solution=torn_row().state())


@pytest.mark.parametrize("every", [0, 1])
def test_a_run_without_records_or_energy_shows_its_body(every: int) -> None:
    model = turned_cubes()[0]
    still = bd.Model(model.lattice, model.bond, 1e3)
    figure = bd.solve_explicit(still, duration=1e-6, dt=2e-7, every=every).plot()
    assert [ax.get_title("left") for ax in figure.axes] == ["motion × 1", ""]  # the body and its colour bar


def test_a_window_needs_a_display() -> None:
    with pytest.raises(InputError, match="no display is available"):
        turned_cubes()[0].lattice.plot().show()


def test_runs_and_tests_are_drawn() -> None:
    run = bd.solve_explicit(torn_row(), duration=2e-4, every=20, imbalance=None)
    text = words(run.plot())
    assert "energy [µJ]" in text
    assert "pieces, motion × " in text
    assert "integrity" not in text
    run.state.integrity[run.state.integrity == 0.0] = 0.05  # parted facets that still hold a little
    assert "pieces (integrity ≤ 0.1), motion × " in words(run.plot())
    curve = np.column_stack([np.linspace(0.0, 1e-3, 5), np.linspace(0.0, 4e6, 5)])
    cracking = Cracking(run.state.model.lattice, run.state, 0.0, 0.0, 0.0, 1.0, 100.0)
    test = bd.labtests.StrengthTest(
        peak=4e6, E=4e9, curve=curve, work=1.0, asymmetry=0.0, unbalance=0.0, kinetic=0.0, residual=0.0,
        cracking=cracking, run=run,
    )  # fmt: skip
    figure = test.plot(reach=1.0, view=(0.0, 0.0))
    assert "stress [MPa]" in words(figure)
    (line,) = figure.axes[0].get_lines()
    np.testing.assert_allclose(line.get_xydata(), curve * [1e3, 1e-6])
    every = (
        bd.ExplicitResult, bd.QuasistaticResult, bd.labtests.BendingTest, bd.labtests.BrazilianTest,
        bd.labtests.TriaxialTest, bd.labtests.SphereCrushing, bd.labtests.SphereImpact, bd.labtests.SpallTest,
        bd.labtests.FreeVibration, bd.labtests.Outcome,
    )  # fmt: skip
    assert all(callable(kind.plot) for kind in every)
