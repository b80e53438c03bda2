"""Pictures of what fracture leaves and of waves, and the scripts that draw them."""

import importlib.util
import re
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from matplotlib.figure import Figure

import bondem as bd
from bondem.labtests.cracking import Cracking
from bondem.report.crack_pictures import corners_moved, draw_cracks, draw_fragments, piece_colours
from bondem.report.piece_colours import piece_palette
from bondem.report.spheres import View
from bondem.report.turning_cells import turning_cells_of
from tests.models import parted
from tests.specimens import cells, cubes
from validation.studies import stress_waves

ROOT = Path(__file__).parents[2]
LAW = bd.CellBond(E=1e9, nu=0.2)


def script(path: str):
    name = Path(path).stem
    spec = importlib.util.spec_from_file_location(name, ROOT / path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


def broken() -> tuple[bd.Lattice, bd.State]:
    """Cubic cells, 4 × 3 × 2, parted in the middle and drawn 0.5 apart."""
    body = cubes((4, 3, 2))
    x = body.particles.position
    side = x[:, 0] > 2.0
    state = parted(body, side)
    state.set_pose(position=x + 0.5 * side[:, None] * [1.0, 0.0, 0.0])
    return body, state


@pytest.mark.validate
def test_a_plate_breaks_with_branches_and_is_drawn(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    """A crack starts once the waves have been at the notch, 20 mm / 3.8 km/s, and stays below Rayleigh's speed."""
    growth = script("examples/cracks.py").main(count=1000, folder=tmp_path)
    assert 0.25 < growth.speed / 2125.0 < 0.6
    assert 5e-6 < growth.time[0] < 25e-6
    assert growth.length[-1] == pytest.approx(50e-3, abs=4e-3)
    for file, least in (("cracks.png", 50_000), ("plate.vtkhdf", 10_000)):
        assert (tmp_path / file).stat().st_size > least
    text = capsys.readouterr().out
    assert "Fracture of 1000 cells" in text
    assert re.search(r"surfaces: [1-3],", text)  # the crack, and at most crumbs beside it


@pytest.mark.validate
def test_a_bar_that_snaps_back_is_drawn(tmp_path: Path) -> None:
    path, largest = script("examples/snap_back.py").main(count=400, folder=tmp_path)
    assert path.peak == pytest.approx(largest, rel=0.03)
    half = path.displacement[path.load > 0.3 * path.peak]
    assert half[-1] < 0.9 * path.displacement.max()
    assert (tmp_path / "snap_back.png").stat().st_size > 20_000


def test_corners_go_with_their_cells() -> None:
    body, state = broken()
    solid = bd.polyhedra(body)
    owner = np.repeat(solid.cell, np.diff(solid.start))
    moved = corners_moved(solid, body, state.displacement, state.orientation, reach=3.0)
    np.testing.assert_allclose(moved, 3.0 * state.displacement[owner], atol=1e-12)
    half = np.sqrt(0.5)
    state.set_pose(position=body.centre, orientation=np.tile([half, 0.0, 0.0, half], (24, 1)))
    arm = solid.vertex - body.centre[owner]
    quarter = np.stack([-arm[:, 1], arm[:, 0], arm[:, 2]], axis=1)
    plain = corners_moved(solid, body, state.displacement, state.orientation)
    np.testing.assert_allclose(plain, quarter - arm, atol=1e-12)


def test_every_piece_has_a_colour_of_its_own() -> None:
    body, state = broken()
    pieces = bd.fragments(body, state)
    colour = piece_colours(pieces)
    assert len(np.unique(colour, axis=0)) == 2
    assert all(len(np.unique(colour[pieces.label == k], axis=0)) == 1 for k in range(2))
    state.integrity[:] = 0.0
    assert len(np.unique(piece_colours(bd.fragments(body, state)), axis=0)) == 24
    many = np.unique(np.rint(255.0 * piece_palette(500)), axis=0)
    assert len(many) == 500
    steps = np.linalg.norm(np.diff(piece_palette(300), axis=0), axis=1)
    assert steps.min() > 0.15  # pieces of similar masses have different colours


def test_surfaces_of_cracks_are_drawn_facet_by_facet() -> None:
    body, state = broken()
    ax = Figure().subplots()
    scale = draw_cracks(ax, body, bd.cracks(body, state), view=View(), top=1.0)
    polygons, box = ax.collections
    assert len(polygons.get_paths()) == 6
    assert len(box.get_paths()) == 12
    assert scale.get_clim() == (0.0, 1e6)
    whole = bd.Model(body, LAW, 1e3).state()
    bare = Figure().subplots()
    draw_cracks(bare, body, bd.cracks(body, whole), view=View())
    assert len(bare.collections[-1].get_paths()) == 12
    draw_fragments(Figure().subplots(), body, whole, bd.fragments(body, whole), view=View())


@pytest.mark.validate
def test_waves_of_a_struck_plate_run_at_the_speed_of_the_material(tmp_path: Path) -> None:
    """9 elements in the pulse: waves of pressure are slow by 2 % there, and the crest is found to some per cent."""
    speed, plate, pictures = stress_waves.struck(5000)
    stress_waves.draw_waves(tmp_path / "stress_waves.png", plate, pictures)
    assert speed == pytest.approx(np.sqrt(70e9 / 2500.0 / (1.0 - 0.22**2)), rel=0.03)
    first, second = [(np.abs(p) < 1e-3 * np.abs(p).max()).mean() for p, _ in pictures]
    assert first > 0.4 > second
    assert (tmp_path / "stress_waves.png").stat().st_size > 50_000


@pytest.mark.validate
def test_cracks_go_round_the_stones_of_the_mesoscale_example(tmp_path: Path, monkeypatch) -> None:
    """A small prism with few stones: between the strengths of the interface and of mortar, and no stone breaks."""
    example = script("examples/mesoscale.py")
    monkeypatch.setattr(example, "SIDE", 24e-3)
    monkeypatch.setattr(example, "FRACTION", 0.15)
    monkeypatch.setattr(example, "SIEVE", bd.Sieve((7e-3, 10e-3), (0.0, 1.0)))
    monkeypatch.setattr(example, "TIME", 1.2e-3)
    strength, share = example.main(size=2.4e-3, folder=tmp_path)
    assert 2e6 < strength < 4e6
    assert share["aggregate"] == 0.0
    assert share["interface"] > 0.3
    assert (tmp_path / "mesoscale.png").stat().st_size > 20_000


def test_a_body_in_pieces_is_shown_from_the_side_of_its_small_pieces():
    """A corner cell and its neighbour apart, on the far side of the usual view; two halves keep that view."""
    body = cells(bd.Box((4e-3, 2e-3, 2e-3)), 60)
    state = bd.Model(body, LAW, 1e3).state()
    toward = View(azimuth=np.radians(28.0), elevation=np.radians(24.0)).axes[2] * (1.0, 1.0, 0.0)
    far = np.argsort(body.centre @ toward)[:2]
    for apart, usual in ((far[:1], True), (far, False)):
        state.integrity[:] = np.where(np.isin(body.pairs, apart).any(axis=1), 0.0, 1.0)[state.layout.bond_order]
        cracking = Cracking(body, state, 0.0, 0.0, 0.0, 0.0, 1.0)
        test = SimpleNamespace(cracking=cracking)
        axes = np.array(turning_cells_of(SimpleNamespace(lattice=body, outcomes={"ucs": test})).axes)
        assert (axes[2] @ toward > 0.0) == usual
