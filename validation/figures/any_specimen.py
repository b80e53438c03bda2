"""Figures of any_specimen.py: errors with their limits, convergence, and the bracket in its first mode."""

from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from bondem.report.spheres import View, render
from bondem.report.style import BLUE, GREEN, GREY, INK, ORANGE, PALE, PURPLE, sheet

_MARKS = ((BLUE, "o"), (GREEN, "s"), (ORANGE, "^"), (PURPLE, "D"), (INK, "v"))
_NAMES = {"E": "E", "nu": "ν"}
# For the errors of all materials: how marks are filled.
_FILL = {"raw": "none", "layered": "full"}


def draw(summary: dict[str, Any], bracket: bd.Lattice, mode: np.ndarray, folder: Path) -> None:
    """All figures.

    Args:
        summary: what benchmarks/results/any_specimen.json holds.
        bracket: its lattice.
        mode: displacements in its first free mode, any scale, (n, 3).
        folder: where to write any_specimen*.png.
    """
    errors(summary["cases"], folder / "any_specimen.png")
    convergence(summary["convergence"], folder / "any_specimen_convergence.png")
    ringing(bracket, mode, folder / "any_specimen_bracket.png")


def _ways(one: dict[str, Any]) -> list[str]:
    return [way for way in _FILL if way in one]


def errors(cases: list[dict[str, Any]], path: Path) -> None:
    """Error of every quantity, a panel for each shape; hollow raw, filled with layers."""
    shapes = list(dict.fromkeys(one["shape"] for one in cases))
    materials = list(dict.fromkeys(one["material"] for one in cases))
    with sheet(path, 8.4, 2.2 * len(shapes) + 0.7, len(shapes), 1, squeeze=False) as (figure, axes):
        for axis, shape in zip(axes[:, 0], shapes, strict=True):
            mine = [one for one in cases if one["shape"] == shape]
            keys = [key for key, row in mine[0][_ways(mine[0])[-1]].items() if isinstance(row, dict)]
            allowed, thickness = mine[0]["limit"], mine[0]["thickness"]
            judged = [k for k, key in enumerate(keys) if key in _NAMES or key[0] == "f"]
            if allowed:
                axis.fill_between([-0.5, judged[-1] + 0.5], -100 * allowed, 100 * allowed, color=PALE, lw=0)
            for one in mine:
                number = materials.index(one["material"])
                colour, mark = _MARKS[number % len(_MARKS)]
                x = np.arange(len(keys)) + 0.13 * (number - 0.5 * (len(materials) - 1))
                for way in _ways(one):
                    y = [100 * one[way][key]["error"] for key in keys]
                    axis.plot(x, y, mark, ms=4.5, mec=colour, mfc=colour if _FILL[way] == "full" else "none", mew=0.9)
            axis.axhline(0.0, color=GREY, lw=0.8)
            axis.set_xticks(range(len(keys)), [_label(key, mine[0]) for key in keys])
            axis.grid(visible=False, axis="x")
            axis.set_xlim(-0.5, len(keys) - 0.5)
            axis.set_ylabel("error [%]")
            band = f", limit ±{100 * allowed:.0f} % (band)" if allowed else ""
            axis.set_title(f"{shape}: thinnest part {thickness:.1f} R̄{band}")
        handles = [
            axes[0, 0].plot([], [], mark, color=colour, ms=5, label=name)[0]
            for name, (colour, mark) in zip(materials, _MARKS, strict=False)
        ]
        for fill, label in (("none", "bonds of the cell, raw"), (GREY, "with layers at walls")):
            handles.append(axes[0, 0].plot([], [], "o", mec=GREY, mfc=fill, ms=5, label=label)[0])
        figure.legend(handles=handles, loc="outside lower center", ncols=4)


def _label(key: str, one: dict[str, Any]) -> str:
    row = one[_ways(one)[-1]][key]
    if "modes" in row:
        first, last = row["modes"][0], row["modes"][-1]
        return f"mode {first}" if first == last else f"modes {first}-{last}"
    return _NAMES.get(key, f"clamped\n{key}")


def convergence(cases: list[dict[str, Any]], path: Path) -> None:
    """E, ν and the frequencies against the surface of the specimen, R̄ S / V."""
    shapes = list(dict.fromkeys(one["shape"] for one in cases))
    ways = _ways(cases[0])
    height = 3.0 * len(ways) + 0.6
    with sheet(path, 10.0, height, len(ways), len(shapes), sharex=True, sharey=True, squeeze=False) as (figure, axes):
        for row, way in enumerate(ways):
            for axis, shape in zip(axes[row], shapes, strict=True):
                mine = sorted((one for one in cases if one["shape"] == shape), key=lambda one: one["surface"])
                x = np.array([one["surface"] for one in mine])
                tones = [key for key in mine[0][way] if key[0] == "f"]
                values = np.array([[100 * one[way][key]["error"] for key in tones] for one in mine])
                axis.fill_between(x, values.min(axis=1), values.max(axis=1), color=BLUE, alpha=0.25, lw=0)
                axis.plot(x, values.mean(axis=1), "o-", color=BLUE, ms=4, label="free frequencies: mean, range")
                for key, colour, mark in (("E", ORANGE, "s"), ("nu", GREEN, "^")):
                    y = [100 * one[way][key]["error"] for one in mine]
                    axis.plot(x, y, mark + "-", color=colour, ms=4, label=_NAMES[key])
                allowed = [100 * one["limit"] if one["limit"] else np.nan for one in mine]
                for sign in (-1, 1):
                    axis.step(x, sign * np.array(allowed), where="mid", color=GREY, lw=1.0, ls="--")
                axis.axhline(0.0, color=GREY, lw=0.8)
                axis.set_xlim(0.0, 1.05 * max(one["surface"] for one in cases))
                axis.locator_params(axis="x", nbins=5)
                axis.set_title(f"{shape}, {way}")
                if row == len(ways) - 1:
                    axis.set_xlabel("R̄ S / V [-]")
            axes[row, 0].set_ylabel("error [%]")
        axes[0, 0].plot([], [], color=GREY, lw=1.0, ls="--", label="limit")
        figure.legend(*axes[0, 0].get_legend_handles_labels(), loc="outside lower center", ncols=4)


def ringing(lattice: bd.Lattice, mode: np.ndarray, path: Path) -> None:
    """The first free mode of the bracket at both ends of its swing, coloured by how far it moves."""
    from matplotlib import colormaps
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize

    particles, inside = lattice.particles, lattice.connected
    position, radius, mode = particles.position[inside], particles.radius[inside], mode[inside]
    far = np.linalg.norm(mode, axis=1)
    swing = 4e-3 / far.max() * mode
    colour = colormaps["cividis"](far / far.max())[:, :3]
    view = View(azimuth=-0.35, elevation=0.3)
    with sheet(path, 5.6, 2.3, 1, 3) as (figure, axes):
        frames = ((-1.0, "one end"), (0.0, "at rest"), (1.0, "other end"))
        for axis, (share, title) in zip(axes, frames, strict=True):
            tint = colour if share else np.full_like(colour, 0.75)
            image = render(position + share * swing, radius, tint, view=view, width=300)
            axis.imshow(image)
            axis.set_axis_off()
            axis.set_anchor("S")
            axis.set_title(title)
        scale = ScalarMappable(Normalize(0.0, 1.0), "cividis")
        figure.colorbar(scale, ax=axes, shrink=0.75, label="displacement / largest [-]")
