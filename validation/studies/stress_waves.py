"""A blow on the edge of a glass plate: the waves that run from it, at the speeds of the material.

Physics: a plate of 100 × 50 × 1.6 mm is struck on 3 mm of its long edge for 2 µs (half a sine). In a thin plate a
wave of pressure runs at cP = √(E / ρ(1 - ν²)), one of shear at cS = √(G / ρ), and one along the edge at Rayleigh's
speed. Nothing is calibrated: E, ν and ρ of the material go in, and the speeds come out.

Expected: the crest of pressure, 15 to 33 mm below the blow, moves at cP = 5424 m/s within 1 %; the circles of both
speeds lie on the fronts of the pictures. It takes some ten seconds on two cores.
"""

import math
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize

import bondem as bd
from bondem.report.cell_pictures import CellSection, section_through
from bondem.report.style import DIVERGING, INK, sheet
from validation.frame.record import Record

LENGTH, HEIGHT, THICK = 100e-3, 50e-3, 1.6e-3  # m
STRUCK, BLOW, PEAK = 3e-3, 2e-6, 20e6  # m, s, Pa
GLASS = bd.Material("soda-lime glass", E=70e9, nu=0.22, rho=2500.0)
CP = math.sqrt(GLASS.E / (GLASS.rho * (1.0 - GLASS.nu**2)))
CS = math.sqrt(0.5 * GLASS.E / (1.0 + GLASS.nu) / GLASS.rho)
#: When pictures are taken, and the crest is looked for, from the middle of the blow on [s].
SEEN, TIMED = (4.0e-6, 7.5e-6), np.arange(2.8e-6, 6.2e-6, 4e-7)


def struck(count: int) -> tuple[float, bd.Lattice, list[tuple[np.ndarray, np.ndarray]]]:
    """Strike the plate: speed of the crest [m/s], the plate, pressure [Pa] and turns at two times, (n,).

    Args:
        count: cells.
    """
    packed = bd.pack(bd.Box((LENGTH, HEIGHT, THICK)), count=count, method="even", seed=1)
    plate = bd.connect(packed, method="laguerre")
    when = np.linspace(0.0, BLOW, 21)
    blow = bd.Table(tuple(when), tuple(np.sin(math.pi * when / BLOW)))
    middle = bd.Within(bd.Box((STRUCK, 2.0 * HEIGHT, 3.0 * THICK)).moved((0.5 * (LENGTH - STRUCK), 0.0, -THICK)))
    model = bd.Model(
        plate, bd.CellBond(E=GLASS.E, nu=GLASS.nu), GLASS.rho,
        boundary=[bd.Pressure(bd.Face("y_max") & middle, PEAK, schedule=blow)],
    )  # fmt: skip
    x, depth = plate.centre[:, 0] - 0.5 * LENGTH, HEIGHT - plate.centre[:, 1]
    distance, below = np.hypot(x, depth), np.abs(x) < math.tan(math.radians(25.0)) * depth
    state, crests, pictures = model.state(), [], []
    for t in np.unique(np.round(np.append(TIMED, SEEN), 12)):
        state = bd.solve_explicit(model, duration=0.5 * BLOW + t - state.time, state=state).state
        stress, q = bd.cell_stress(model, state), state.orientation
        pressure = -0.5 * (stress[:, 0, 0] + stress[:, 1, 1])
        if t < TIMED[-1] + 1e-9:
            crests.append((t, crest(distance[below], pressure[below], CP * t)))
        if t in SEEN:
            pictures.append((pressure, 2.0 * np.arctan2(q[:, 3], q[:, 0])))
    speed = float(np.polyfit([t for t, _ in crests], [place for _, place in crests], 1)[0])
    print(f"pressure runs at {speed:.0f} m/s, cP = {CP:.0f} m/s; cS = {CS:.0f} m/s")
    return speed, plate, pictures


def draw(_: Record, folder: Path) -> None:
    """Strike a plate of 20 000 cells."""
    draw_waves(folder / "stress_waves.png", *struck(20_000)[1:])


def crest(distance: np.ndarray, pressure: np.ndarray, near: float) -> float:
    """Distance of the largest pressure near where it is expected, from a parabola through the upper cells [m].

    A pulse of 2 µs is 11 mm long; the parabola goes through 5 mm of it.
    """
    for half in (4e-3, 2.5e-3):
        here = np.abs(distance - near) < half
        square, slope, _ = np.polyfit(distance[here] - near, pressure[here], 2)
        near -= 0.5 * slope / square
    return near


def draw_field(ax: Axes, section: CellSection, value: np.ndarray) -> PolyCollection:
    """Draw a section [mm] with the values of its cells, symmetric about zero, and return what a colour bar maps."""
    top = float(np.quantile(np.abs(value), 0.985))  # 1.5 % of the cells exceed it
    field = PolyCollection(
        [1e3 * one for one in section.outline], array=value[section.cell], cmap=DIVERGING,
        norm=Normalize(-top, top), edgecolors="face", linewidths=0.35,
    )  # fmt: skip
    ax.add_collection(field)
    ax.set_aspect("equal")
    ax.grid(visible=False)
    return field


def draw_waves(path: Path, plate: bd.Lattice, pictures: list[tuple[np.ndarray, np.ndarray]]) -> None:
    """Pressure and turns of the cells in a section through the middle of the plate, with the circles of theory."""
    section = section_through(bd.polyhedra(plate), 2, 0.5 * THICK)
    angle = np.linspace(math.pi, 2.0 * math.pi, 90)
    with sheet(path, 11.0, 5.6, 2, 2) as (figure, axes):
        for column, (t, fields) in enumerate(zip(SEEN, pictures, strict=True)):
            of = zip(axes[:, column], fields, ("pressure [MPa]", "turn [µrad]"), (1e-6, 1e6), strict=True)
            for ax, field, what, unit in of:
                figure.colorbar(draw_field(ax, section, unit * field), ax=ax, shrink=0.8, label=what)
                for speed, style, name in ((CP, "-", "c$_P$ t"), (CS, (0, (4, 3)), "c$_S$ t")):
                    arc = 1e3 * speed * t
                    x, y = 50.0 + arc * np.cos(angle), 50.0 + arc * np.sin(angle)
                    ax.plot(x, y, color=INK, lw=0.9, ls=style, label=name)
                ax.set(title=f"{what.split(' [')[0]}, {1e6 * t:.1f} µs", xlim=(0, 100), ylim=(0, 51))
                ax.set(xlabel="x [mm]", ylabel="y [mm]")
        axes[0][0].legend(loc="lower left")
