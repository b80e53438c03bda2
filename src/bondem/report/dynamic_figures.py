"""Figures of mode shapes, free vibration and the wave of an impact."""

import math
from pathlib import Path

import numpy as np
from matplotlib import colormaps

from bondem._types import Floats
from bondem.report.cell_pictures import draw_cells
from bondem.report.findings import Examined
from bondem.report.numbers import with_unit
from bondem.report.spheres import View, render
from bondem.report.style import BLUE, GREEN, GREY, INK, ORANGE, PURPLE, for_phones, sheet
from bondem.specimen.lattice import Lattice
from bondem.specimen.tessellation.polyhedra import polyhedra

_KINDS = (
    ("bending", "dynamic_bending", 1, GREEN),
    ("torsion", "dynamic_torsion", 3, PURPLE),
    ("tension", "dynamic_tension", 0, BLUE),
)
# Labels of the curve of the struck face: a body of cells is driven by a wall, and its cells lie behind the face.
_STRUCK = {"spheres": "struck face, held", "cells": "cells behind the struck face"}
_VIEW = View(azimuth=math.radians(28.0), elevation=math.radians(24.0))


def draw_modes(path: Path, specimen: Examined) -> None:
    """Draw the first bending, torsional and axial mode, exaggerated and coloured by the displacement of elements."""
    lattice, modes = specimen.lattice, [_mode(specimen, kind, column) for kind, _, column, _ in _KINDS]
    if lattice.cells is not None:
        _draw_cell_modes(path, lattice, modes)
        return
    chosen = lattice.connected
    position, radius = lattice.centre[chosen], lattice.particles.radius[chosen]
    images = [
        render(position + shape[chosen, :3], radius, colour[chosen], view=_VIEW, width=520)
        for _, shape, colour in modes
    ]
    tallest = max(len(image) for image in images)
    with sheet(path, 8.2, 8.2 / 3.0 * tallest / 520 + 0.42, 1, 3) as (_, axes):
        for ax, (title, *_), image in zip(axes, modes, images, strict=True):
            room = tallest - len(image)
            padded = np.pad(image, ((room // 2, room - room // 2), (0, 0), (0, 0)))
            ax.imshow(padded, interpolation="lanczos")
            ax.set_title(title)
            ax.axis("off")


def _mode(specimen: Examined, kind: str, column: int) -> tuple[str, Floats, Floats]:
    """Return title, exaggerated shape, (n, 6), and colours, (n, 3), of the first mode of a `kind`.

    It has the largest effective mass in a `column` of `NaturalFrequencies.mass_share`, for bending that along z.
    A bending mode deflects upwards.
    """
    frequencies, lattice = specimen.frequencies, specimen.lattice
    assert frequencies is not None
    best = int(np.argmax(frequencies.mass_share[:, 2 if kind == "bending" else column]))
    shape = frequencies.modes.shape[best]
    if kind == "bending":
        shape = shape * np.sign(shape[np.argmax(np.abs(shape[:, 2])), 2])
    far, size = np.linalg.norm(shape[:, :3], axis=1), np.ptp(lattice.centre[lattice.connected], axis=0)
    most = far[lattice.connected].max()
    # largest drawn displacement, as a share of the length, or of the width for torsion
    reach = 0.4 * size[1] if kind == "torsion" else 0.2 * size[0]
    title = f"{kind}: {with_unit(float(frequencies.modes.frequency[best]), 'Hz')}"
    return title, reach / most * shape, colormaps["viridis"](far / most)[:, :3]


def _draw_cell_modes(path: Path, body: Lattice, modes: list[tuple[str, Floats, Floats]]) -> None:
    """Draw modes, with the titles, shapes and colours of `_mode`, as motions of rigid polyhedra."""
    solid = polyhedra(body)
    owner = np.repeat(solid.cell, np.diff(solid.start))
    arm = solid.vertex - body.centre[owner]
    with sheet(path, 8.2, 2.5, 1, 3) as (_, axes):
        for ax, (title, shape, colour) in zip(axes, modes, strict=True):
            moved = shape[owner, :3] + np.cross(shape[owner, 3:], arm)
            draw_cells(ax, solid, colour, view=_VIEW, moved=moved)
            ax.set_title(title)


def draw_vibration(path: Path, specimen: Examined) -> None:
    """Draw the signals of the free vibration and their spectra, with the theoretical frequencies."""
    rows = [row for row in _KINDS if "signal" in getattr(specimen.outcomes.get(row[1]), "curves", {})]
    with sheet(path, 8.2, 2.0 * len(rows) + 0.3, len(rows), 2, squeeze=False, width_ratios=(3, 2)) as (_, axes):
        for (left, right), (kind, name, _, colour) in zip(axes, rows, strict=True):
            outcome = specimen.outcomes[name]
            curves = outcome.curves
            signal = curves["signal"] / np.abs(curves["signal"]).max()
            left.plot(curves["time"] * 1e6, signal, color=colour, linewidth=1.0)
            left.set(title=kind, xlabel="time [µs]", ylabel="end / largest [-]", ylim=(-1.15, 1.15))
            frequency, amplitude = curves["frequency"] / 1e3, curves["amplitude"] / curves["amplitude"].max()
            right.plot(frequency, amplitude, color=colour, linewidth=1.2, label="spectrum")
            right.axvline(outcome.measured / 1e3, color=ORANGE, linewidth=1.2, label="mode")
            right.axvline(outcome.theory / 1e3, color=INK, linestyle=(0, (4, 3)), linewidth=1.1, label="theory")
            if outcome.theory_timoshenko is not None:
                right.axvline(outcome.theory_timoshenko / 1e3, color=GREY, linestyle=(0, (1, 1.5)), linewidth=1.6,
                              label="Timoshenko")  # fmt: skip
            right.set(xlabel="frequency [kHz]", ylabel="amplitude [-]", xlim=(0.0, 2.9 * outcome.theory / 1e3))
            right.legend(loc="upper right")


def draw_wave(path: Path, specimen: Examined) -> None:
    """Draw the velocities of the struck and of the far face, and the arrival of the wave."""
    outcome = specimen.outcomes["impact"]
    curves = outcome.curves
    time = curves["time"] * 1e6
    arrival, plateau = float(curves["arrival"]) * 1e6, float(curves["plateau"])
    expected = arrival * outcome.measured / outcome.theory
    struck = _STRUCK[specimen.lattice.elements.shape_name]
    with sheet(path, 8.2, 4.4 if for_phones() else 3.1) as (figure, ax):
        ax.plot(time, curves["near"], color=GREY, label=struck)
        ax.plot(time, curves["far"], color=BLUE, label="far face")
        ax.axhline(0.5 * plateau, color=PURPLE, linewidth=1.0, linestyle=(0, (1, 1.5)), label="half of the plateau")
        ax.axvline(expected, color=INK, linewidth=1.0, linestyle=(0, (4, 3)),
                   label=f"theory √(E/ρ): {with_unit(outcome.theory, 'm/s')}")  # fmt: skip
        ax.plot([arrival], [0.5 * plateau], "D", color=ORANGE, markersize=7,
                label=f"arrival: {with_unit(outcome.measured, 'm/s')}", zorder=5)  # fmt: skip
        ax.set(xlabel="time [µs]", ylabel="mean velocity of a face [m/s]", xlim=(0.0, time[-1]))
        if for_phones():
            figure.legend(loc="outside lower center")
        else:
            ax.legend(loc="upper left")
