"""The face of a specimen with its sections, the profile of stress over the radius, and bending with each section."""

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.patches import Circle

from bondem.report.spheres import View, render
from bondem.report.style import BLUE, GREEN, GREY, INK, ORANGE, PURPLE, sheet
from bondem.specimen.lattice import Lattice
from validation.figures.axes import draw_bars

_DASHED = (0, (4, 3))
_ALONG_X = View(azimuth=0.5 * math.pi, elevation=0.0)
# How deep one looks into the face, in mean radii: what is behind is hidden anyway.
_DEEP = 6.0
_SHOWN = {
    "walls": ("max section: walls", INK, "-"),
    "centres": ("effective section: hull of the centres", PURPLE, (0, (1, 1.2))),
    "force": ("effective section: ⟨r²⟩ of the axial force", ORANGE, _DASHED),
}
# Of the sections in the order of the study, and of the test of which the paper speaks.
_COLOURS = (GREY, PURPLE, "#c9b3d3", BLUE, GREEN)
_JUDGED = "bending_frequency"


def draw_section(
    path: Path, lattice: Lattice, own: Mapping[str, float], mean: Mapping[str, float], profile: Mapping[str, Any]
) -> None:
    """The face x_max as in figure 22, and what lies and is carried over the radius.

    Args:
        path: PNG to write.
        lattice: the specimen on show.
        own: its radii [m], by the names of `SectionRadii`.
        mean: the same, means over all packings.
        profile: "edge" [m] and mean and std of "stress" and "solid", as in `results.json`.
    """
    particles = lattice.particles
    face = particles.envelope.bounds[1][0]
    chosen = (particles.position[:, 0] > face - _DEEP * particles.mean_radius) & lattice.connected
    position, radius = particles.position[chosen], particles.radius[chosen]
    touching = position[:, 0] + radius > face - 0.02 * particles.mean_radius
    colour = np.where(touching[:, None], to_rgb("#9ec5dd"), to_rgb("#d5dbe1"))
    image = render(position, radius, colour, view=_ALONG_X, width=700)
    margin = 1.02 * radius.max()
    extent = [
        1e3 * bound
        for axis in (1, 2)
        for bound in (position[:, axis].min() - margin, position[:, axis].max() + margin)
    ]
    with sheet(path, 8.2, 4.3, 1, 2, width_ratios=(1, 1.15)) as (_, (left, right)):
        left.imshow(image, extent=extent, interpolation="lanczos")
        for name, (label, ink, style) in _SHOWN.items():
            circle = Circle((0.0, 0.0), 1e3 * own[name], fill=False, color=ink, linestyle=style, linewidth=1.8)
            left.add_patch(circle)
            circle.set_label(f"{label}, {1e3 * own[name]:.2f} mm")
        edge = 1.05e3 * own["walls"]
        left.set(xlim=(-edge, edge), ylim=(-edge, edge), xlabel="y [mm]", ylabel="z [mm]", title="face x_max")
        left.set_aspect("equal")
        left.grid(visible=False)
        left.legend(loc="upper center", bbox_to_anchor=(0.5, -0.16), handlelength=2.6)
        edges = 1e3 * np.array(profile["edge"])
        middle = 0.5 * (edges[1:] + edges[:-1])
        for key, label, ink in (("stress", "axial stress", BLUE), ("solid", "volume fraction", GREEN)):
            values, scatter = (np.array(profile[key][part]) for part in ("mean", "std"))
            # over the mean of the whole section, so that both have the area of the walls below them
            scale = 1.0 if key == "stress" else (values * np.diff(edges**2)).sum() / edges[-1] ** 2
            right.plot(middle, values / scale, color=ink, linewidth=1.3, label=label)
            right.fill_between(middle, (values - scatter) / scale, (values + scatter) / scale, color=ink, alpha=0.18,
                               linewidth=0.0)  # fmt: skip
        for name, (_, ink, style) in _SHOWN.items():
            right.axvline(1e3 * mean[name], color=ink, linestyle=style, linewidth=1.3)
        right.axhline(1.0, color=GREY, linewidth=0.8)
        right.set(xlabel="distance from the axis [mm]", ylabel="over the mean of the section [-]",
                  title="tension, middle half of the length", xlim=(0.0, 1.03 * edges[-1]))  # fmt: skip
        right.set_ylim(bottom=0.0)
        right.legend(loc="upper left")


def draw_section_errors(
    path: Path,
    error: Mapping[str, Mapping[str, Mapping[str, float | None]]],
    sections: Mapping[str, str],
    tests: Mapping[str, str],
    printed: Mapping[str, float],
) -> None:
    """Error with each section: of the bending frequency of which the paper speaks, and of the other tests.

    Args:
        path: PNG to write.
        error: {"mean", "std"} by section and test [-].
        sections: names of the sections.
        tests: names of the tests, that of the bending frequency among them.
        printed: what the paper prints for the bending frequency, unsigned, by section [-].
    """
    others = {test: name for test, name in tests.items() if test != _JUDGED}
    with sheet(path, 9.6, 4.4, 1, 2, width_ratios=(1, 2.6)) as (figure, (left, right)):
        for k, (section, label) in enumerate(sections.items()):
            draw_bars(left, np.array([float(k)]), [error[section][_JUDGED]], 0.8, _COLOURS[k], None)
            width = 0.84 / len(sections)
            place = np.arange(float(len(others))) + (k - 0.5 * (len(sections) - 1)) * width
            draw_bars(right, place, [error[section][test] for test in others], 0.92 * width, _COLOURS[k], label)
        for k, section in enumerate(sections):
            for sign in (-1.0, 1.0) if section in printed else ():
                left.plot([k - 0.46, k + 0.46], [sign * 100.0 * printed[section]] * 2, color=ORANGE, linewidth=2.2)
        right.plot([], [], color=ORANGE, linewidth=2.2, label="paper, unsigned")
        left.set_xticks([])
        left.set(title="(a) bending frequency", ylabel="measured / theory − 1 [%]",
                 xlabel=tests[_JUDGED].partition(", ")[2])  # fmt: skip
        names = [name.replace(", ", ",\n").replace(" ", "\n", 1) for name in others.values()]
        right.set_xticks(range(len(others)), names, fontsize=8.5)
        right.set(title="(b) the other tests")
        for ax in (left, right):
            ax.axhline(0.0, color=INK, linewidth=0.8)
            ax.grid(axis="x", visible=False)
            ax.margins(y=0.08)
        figure.legend(*right.get_legend_handles_labels(), loc="outside upper left", ncols=2, fontsize=8.5)
