"""The report's parts: the renderer, the figures' style and the way numbers are written."""

import base64
import math
from types import SimpleNamespace

import numpy as np
import pytest
from matplotlib import rcParams

import bondem as bd
from bondem.report.findings import Examined, Findings
from bondem.report.numbers import measures, percent, signed, signed_percent, with_unit
from bondem.report.page import drawings_of, page, templates
from bondem.report.quality import quality_rows
from bondem.report.specimen_figures import draw_specimen
from bondem.report.spheres import View, render, tubes
from bondem.report.style import sheet
from bondem.report.turning import turning_of
from tests.specimens import grid

FRONT = View(azimuth=0.0, elevation=0.0)
RED, BLUE = [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]


def test_a_sphere_is_a_disc_of_its_area():
    image = render(np.zeros((1, 3)), np.ones(1), np.array([RED]), view=FRONT, width=200)
    side = 2.04 / 200  # the picture leaves a margin of 2 % about the sphere
    assert image[:, :, 3].sum() * side**2 == pytest.approx(math.pi, rel=0.005)
    assert image.shape[0] == pytest.approx(image.shape[1], abs=1)


def test_what_is_nearer_hides_what_is_behind():
    position = np.array([[0.0, 1.0, 0.0], [0.0, -1.0, 0.0]])  # one looks along +y
    image = render(position, np.ones(2), np.array([RED, BLUE]), view=FRONT, width=100)
    middle = image[50, 50]
    assert middle[2] > 3.0 * middle[0]
    behind = render(position, np.ones(2), np.array([RED, BLUE]), view=View(math.pi, 0.0), width=100)
    assert behind[50, 50, 0] > 3.0 * behind[50, 50, 2]


def test_the_view_is_a_right_handed_frame():
    for view in (FRONT, View(0.3, 0.7), View(2.0, -0.4)):
        np.testing.assert_allclose(view.axes @ view.axes.T, np.eye(3), atol=1e-14)
        assert np.linalg.det(view.axes) == pytest.approx(1.0)
    np.testing.assert_allclose(FRONT.axes, [[1, 0, 0], [0, 0, 1], [0, -1, 0]], atol=1e-14)


def test_spheres_do_not_depend_on_their_order():
    random = np.random.default_rng(1)
    position, radius = random.random((40, 3)), random.uniform(0.02, 0.2, 40)
    colour = random.random((40, 3))
    shuffled = random.permutation(40)
    one = render(position, radius, colour, view=View(), width=120)
    other = render(position[shuffled], radius[shuffled], colour[shuffled], view=View(), width=120)
    np.testing.assert_allclose(one, other, atol=1e-12)


def test_tubes_reach_from_end_to_end():
    start, end = np.zeros((2, 3)), np.array([[1.0, 0.0, 0.0], [0.0, 3.0, 0.0]])
    beads, segment = tubes(start, end, 0.1)
    for k in range(2):
        mine = beads[segment == k]
        np.testing.assert_allclose(mine[[0, -1]], [start[k], end[k]])
        assert np.linalg.norm(np.diff(mine, axis=0), axis=1).max() <= 0.1


def test_drawing_leaves_no_global_state(tmp_path):
    before = dict(rcParams)
    with sheet(tmp_path / "a.png", 3.0, 2.0) as (_, axes):
        axes.plot([0, 1], [0, 1])
    assert dict(rcParams) == before
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        (72.5e9, "Pa", "72.50 GPa"),
        (2201.0, "kg/m³", "2201 kg/m³"),
        (5.2e-7, "m", "520.0 nm"),
        (5018.2, "Hz", "5.018 kHz"),
        (5739.3, "m/s", "5739 m/s"),
        (1.5e-4, "rad", "150.0 µrad"),
        (0.7069, "-", "0.7069"),
        (1.23e-7, "-", "1.230·10⁻⁷"),
        (-3.0, "m", "−3.000 m"),
        (0.0, "m", "0 m"),
        (None, "m", "–"),
        (math.nan, "m", "–"),
    ],
)
def test_quantities(value, unit, text):
    assert with_unit(value, unit) == text


def test_percentages_and_signs():
    assert percent(0.0663) == "6.63 %"
    assert signed_percent(-0.0663) == "−6.63 %"
    assert signed_percent(1e-9) == "0.00 %"
    assert signed(0.00012) == "+0.0001"


def test_measures_of_a_shape():
    assert measures(bd.Cylinder(5e-3, 40e-3)) == "Ø 10 × 40 mm"
    assert measures(bd.Ball(5e-3)) == "Ø 10 mm"
    assert measures(bd.Box((1e-2, 2e-2, 3e-2))) == "10 × 20 × 30 mm"


@pytest.fixture(scope="module")
def examined():
    made = []
    for seed in (1, 2):
        lattice = bd.connect(bd.pack(bd.Cell((1.0, 1.0, 1.0)), count=600, spread=0.0, jamming=True, seed=seed))
        made.append(Examined(seed=seed, lattice=lattice, quality=bd.fabric(lattice)))
    return tuple(made)


def test_the_quality_table_says_what_fabric_measured(examined):
    rows = {row.name: row for row in quality_rows(examined)}
    first, second = (one.quality for one in examined)
    assert rows["φ of the core"].first == with_unit(first.core_volume_fraction)
    low, high = sorted((first.backbone_coordination_number, second.backbone_coordination_number))
    assert rows["z of the backbone"].range == f"{with_unit(low)} … {with_unit(high)}"
    assert rows["loose elements"].first == percent(first.loose / 600)
    assert rows["fineness"].first == with_unit(first.fineness, digits=3)
    assert rows["strata of size"].first == rows["strata of size"].range == "0.00 %"  # all of one size
    assert rows["strata of density"].first == percent(np.nanmax(first.strata.density))
    change = first.strata.density_gradient[np.argmax(np.abs(first.strata.density_gradient))]
    assert rows["change of density"].first == signed_percent(change)
    limits = {name: rows[name].limit for name in ("anisotropy of the core", "layers", "fineness")}
    assert list(limits.values()) == ["30 %", "60 %", ""]
    assert all(row.range == "" for row in quality_rows(examined[:1]))


def test_the_limits_shown_are_those_of_the_verdict():
    crystal = grid((9, 9, 9), 1.0, periodic=True)
    quality = bd.fabric(crystal)
    rows = {row.name: row for row in quality_rows([Examined(seed=0, lattice=crystal, quality=quality)])}
    for name, value in (("anisotropy of the core", quality.core_rms_excess), ("layers", quality.strata.layers.max())):
        assert 100.0 * value > float(rows[name].limit.split()[0])
        assert any(rows[name].limit.replace(" ", "") in reason.replace(" ", "") for reason in quality.reasons)


def test_a_report_without_a_material(examined, tmp_path):
    results = {
        "specimen": {"elements": 600, "bonds": len(examined[0].lattice.pairs), "volume_fraction": 0.64,
                     "coordination_number": 5.9, "isotropy_error": 1e-6, "rattlers": 1},
        "micro": None, "macro": None, "tests": {}, "unseen": None, "seed": 1, "version": "1", "commit": None,
        "command": "bondem run s.toml", "date": "2026-01-02T03:04:05", "machine": "M", "python": "3", "threads": 1,
        "timing": {"pack_s": 1.0, "calibrate_s": 0.0, "tests_s": 0.1},
        "packings": [{"seed": 1, "fabric_reasons": []}, {"seed": 2, "fabric_reasons": ["it is in strata"]}],
    }  # fmt: skip
    findings = Findings(
        title="Cell", material=None, bonds=None, chart=(), calibrating=1, specimens=examined, results=results
    )  # fmt: skip
    html = page(findings, {})
    for text in ("1 of 2 packings are", "<b>fit</b>", "seed 2: it is in strata", "φ of the core", "what it says"):
        assert text in html
    assert "Young" not in html
    drawings = drawings_of(findings)
    assert list(drawings) == ["specimen", "geode", "contacts", "distribution"]  # no walls, so no layers at them
    drawings["distribution"](tmp_path / "distribution.png")
    assert (tmp_path / "distribution.png").stat().st_size > 10_000


def test_the_specimen_to_turn_is_the_specimen(examined):
    """Centres to the last of 16 bits, radii to the last of 8; the page asks nobody for anything."""
    one, lattice = turning_of(examined[0]), examined[0].lattice
    place = np.frombuffer(base64.b64decode(one.place), dtype="<i2").reshape(-1, 3) / 32_000.0
    lower, upper = lattice.centre.min(axis=0), lattice.centre.max(axis=0)
    half = 0.5 * (upper - lower).max()
    np.testing.assert_allclose(place, (lattice.centre - 0.5 * (lower + upper)) / half, atol=0.6 / 32_000.0)
    size = one.largest * np.frombuffer(base64.b64decode(one.size), dtype=np.uint8) / 255.0
    np.testing.assert_allclose(size * half, lattice.particles.radius, atol=one.largest * half / 255.0)
    colour = np.frombuffer(base64.b64decode(one.colour), dtype=np.uint8)
    assert colour.max() < len(one.colours)
    html = templates().get_template("turning.html").render(turning=one)
    assert one.place in html
    assert "http" not in html
    assert "src=" not in html


def test_after_a_test_to_failure_elements_have_moved(examined):
    moved = np.zeros((600, 3))
    moved[7] = 0.0, 0.0, 1e-3
    test = SimpleNamespace(curves={"displacement": moved})
    broken = SimpleNamespace(lattice=examined[0].lattice, outcomes={"ucs": test})
    one = turning_of(broken)
    colour = np.frombuffer(base64.b64decode(one.colour), dtype=np.uint8)
    assert colour[7] == len(one.colours) - 1
    assert np.delete(colour, 7).max() == 0
    assert "coloured by how far each has moved" in one.caption


def test_bonds_over_the_border_of_a_cell_are_drawn_to_the_nearest_image(examined, tmp_path, monkeypatch):
    drawn = []
    monkeypatch.setattr("bondem.report.specimen_figures.tubes", lambda *ends: drawn.append(ends) or tubes(*ends))
    monkeypatch.setattr("bondem.report.specimen_figures.render", lambda *_, **__: np.ones((10, 10, 4)))
    draw_specimen(tmp_path / "cell.png", examined[0].lattice)
    start, end, _ = drawn[0]
    assert np.linalg.norm(end - start, axis=1).max() < 2.1 * examined[0].lattice.particles.radius.max()
