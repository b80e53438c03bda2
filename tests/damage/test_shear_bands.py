"""Shear bands of cells that yield: how wide they are, what they dissipate, and what they bear after slip."""

import math

import numpy as np
import pytest

import bondem as bd
from bondem.damage.shear_bands import USUAL_WIDTH
from bondem.errors import InputError
from tests.core.law_samples import yielding

LAW = bd.CellBond(E=30e9, nu=0.2)


def rock(*, energy: float = 300.0, band: float | None = None) -> bd.MohrCoulomb:
    return bd.MohrCoulomb(
        tension=2e6, cohesion=10e6, friction_angle=math.pi / 6, fracture_energy=100.0, fracture_energy_shear=energy,
        band_width=band,
    )  # fmt: skip


def prism(count: int, seed: int = 4, size: tuple[float, float, float] = (30.8e-3, 14e-3, 14e-3)) -> bd.Lattice:
    return bd.connect(bd.pack(bd.Box(size), count=count, method="even", seed=seed), method="laguerre")


@pytest.mark.parametrize("width", [None, 6e-3], ids=["four cells", "in metres"])
def test_a_thin_band_has_its_slip_over_its_width_as_mean_slip(width):
    """κ = s / B in cells of a flat band, whatever its direction: so that it dissipates G_II per area."""
    edge = 1e-3
    body = prism(2000, size=(12.5 * edge, 12.8 * edge, 12.5 * edge))
    model = bd.Model(body, LAW, 2400.0, failure=rock(band=width))
    (slip,) = model.yielding
    B = USUAL_WIDTH * edge if width is None else width
    order = model.layout.order
    offset = body.centre[order] - 0.5 * np.ptp(body.centre, axis=0) - body.centre.min(axis=0)
    rng = np.random.default_rng(1)
    found = []
    for normal in rng.standard_normal((40, 3)):
        inside = np.abs(offset @ normal) < 0.2 * B * np.linalg.norm(normal)
        full = inside & (np.linalg.norm(offset, axis=1) < 6.25 * edge - 0.55 * B)
        mean = slip.spent(1e-9 * inside / (0.4 * B)) / (slip.fade * 1e-9)  # a band 0.4 B thick slips by 1e-9
        found.append(mean[full].mean())
    assert np.mean(found) == pytest.approx(1.0 / B, rel=0.04)


def test_the_work_per_volume_is_that_of_the_width():
    """B c / 2 G_II: the same for all cells of a width in metres, and in the ratio of cells without it."""
    fades = []
    for count, width in ((300, None), (300, 12e-3), (600, None), (600, 12e-3)):
        model = bd.Model(prism(count), LAW, 2400.0, failure=rock(band=width))
        (slip,) = model.yielding
        fades.append(slip.fade.mean())
    assert fades[1::2] == pytest.approx([12e-3 * 10e6 / 600.0] * 2)
    assert fades[2] / fades[0] == pytest.approx(0.5 ** (1 / 3), rel=0.01)


def test_bands_thinner_than_three_cells_are_refused():
    with pytest.raises(InputError, match=r"less than three cells of .* give smaller cells"):
        bd.Model(prism(500), LAW, 2400.0, failure=rock(band=5e-3)).softening  # noqa: B018
    with pytest.raises(InputError, match="band_width apply to cells"):
        bd.MohrCoulomb(tension=1e6, cohesion=1e6, friction_angle=0.5, band_width=1e-3)
    with pytest.raises(InputError, match="band_width"):
        bd.DruckerPrager(tension=1e6, compression=9e6, fracture_energy=10.0, band_width=-1.0)


@pytest.mark.parametrize("cone", [False, True], ids=["mohr-coulomb", "drucker-prager"])
def test_slip_returns_to_the_yield_surface_without_a_lag(cone):
    """Pure shear that grows at a constant rate: F tends to zero as n 0.8^n, and the slip to that of the strain."""
    G, rate, cohesion = 1e10, 1e-5, 5e6
    shear, held, excess, slips = cohesion, 0.0, [], []
    for _ in range(60):
        shear += G * rate
        stress = np.array([[shear - 1.0], [-shear - 1.0], [-1.0], [0.0], [0.0], [0.0]])  # compressed
        found = yielding(stress, np.array([[cohesion], [0.0], [0.0], [G], [held]]), cone=cone)[:, 0]
        excess.append((shear - cohesion) / (G * rate))
        slips.append(found[1] / rate)
        held, shear = found[2], shear - G * found[1]
    n = np.arange(1, 61)
    np.testing.assert_allclose(excess, n * 0.8 ** (n - 1), atol=1e-5)
    assert slips[-1] == pytest.approx(1.0, abs=1e-3)


@pytest.mark.parametrize("pressure", [5e6, pytest.param(20e6, marks=pytest.mark.validate)])
def test_residual_strength_is_that_of_friction(pressure):
    """A prism on a rough base with free sides bears p (1 + sin φ) / (1 - sin φ) within a tenth after slip."""
    width, aspect = 14e-3, 2.2
    length, speed = aspect * width, math.sqrt(30e9 / 2400.0)
    rest = 3.0 * pressure
    peak = rest + 4.0 * 10e6 * math.cos(math.pi / 6)
    sixth = 40.0 * length / speed
    way = peak / 30e9 * length + 400e-6
    faces = [bd.Face(name) for name in ("y_min", "y_max", "z_min", "z_max")]
    path = bd.Table([0.0, sixth, 6.0 * sixth, 12.0 * sixth], [0.0, -pressure / 30e9 * 0.6 * length, -way, -way])
    model = bd.Model(prism(500), LAW, density=2400.0, failure=rock(energy=600.0), boundary=[
        bd.Fix(bd.Face("x_min"), translation="xyz", rotation=""),
        *(bd.Pressure(face, pressure, schedule=bd.Ramp(0.0, 1.0, sixth)) for face in faces),
        bd.Drive(bd.Face("x_max"), x=path),
    ])  # fmt: skip
    run = bd.solve_explicit(
        model, duration=6.0 * sixth, every=20, damping=bd.MassDamping(0.01 * math.pi * speed / length),
        gauges={"force": bd.Gauge(bd.Face("x_max"), "force")}, safety=0.6,
    )  # fmt: skip
    stress = -run.history["force"][:, 0] / width**2
    assert stress.max() == pytest.approx(peak, rel=0.02)
    assert stress[-len(stress) // 6 :].mean() == pytest.approx(rest, rel=0.1)
    assert run.history.imbalance < 1e-4
