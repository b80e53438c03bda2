"""Figures of bodies of cells, from what is kept: dispersion of waves, and convergence of frequencies and stresses."""

import json
from pathlib import Path
from typing import Any

import numpy as np

from bondem.report.style import BLUE, GREEN, GREY, INK, ORANGE, PURPLE, sheet
from validation.frame.record import RESULTS, Record

_CORRECTED = "P, corrected mass"
_WAVES = {"P": (BLUE, "s"), _CORRECTED: (PURPLE, "D"), "S": (GREEN, "^"), "Rayleigh": (ORANGE, "o")}
_SHAPES = ("cube", "beam", "plate", "cylinder", "l_beam", "bracket", "holed_plate")
#: Bodies of fewer elements are not shown.
_LEAST = 2500
_LEVELS = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0)


def kept(name: str) -> dict[str, Any]:
    """What a benchmark left."""
    return json.loads((RESULTS / f"{name}.json").read_text(encoding="utf-8"))


def dispersion(path: Path) -> None:
    """ω / k over theory against the length of the wave, and its error on logarithmic axes."""
    waves = [one for one in kept("cell_waves")["rows"] if one["step"] == 1.0]
    rows = [one for one in waves if one["mass"] == "lumped"]
    rows += [one | {"wave": _CORRECTED} for one in waves if one["mass"] != "lumped" and one["wave"] == "P"]
    rows += [one | {"wave": "Rayleigh"} for one in kept("cell_rayleigh")["rows"]]
    with sheet(path, 9.0, 3.7, 1, 2) as (figure, (left, right)):
        for name, (colour, mark) in _WAVES.items():
            for nu, fill in ((0.2, "full"), (0.4, "none")):
                mine = [one for one in rows if one["wave"] == name and one["nu"] == nu]
                mine.sort(key=lambda one: one["elements"])
                x, y = (np.array([one[key] for one in mine]) for key in ("elements", "ratio"))
                line = {"color": colour, "marker": mark, "ms": 4, "lw": 0.0 if name == "Rayleigh" else 1.0,
                        "fillstyle": fill, "ls": "-" if fill == "full" else "--"}  # fmt: skip
                left.plot(x, y, label=f"{name}, ν = {nu}", **line)
                right.plot(x, 100.0 * np.abs(1.0 - y), **line)
        slope = np.array([8.0, 80.0])
        error = 100.0 * (slope / 2.6) ** -2.0
        right.plot(slope, error, color=GREY, lw=0.8)
        right.annotate("order 2", (slope[0], error[0]), (4, 2), textcoords="offset points", color=GREY)
        left.axhline(1.0, color=GREY, lw=0.8)
        for axis in (left, right):
            axis.set_xscale("log")
            axis.set_xticks([2.5, 5, 10, 20, 40, 80], ["2.5", "5", "10", "20", "40", "80"])
            axis.set_xticks([], minor=True)
            axis.set_xlabel("length of the wave [elements]")
        left.set_ylabel("celerity over theory [-]")
        right.set_yscale("log")
        right.set_ylabel("error of the celerity [%]")
        figure.legend(*left.get_legend_handles_labels(), loc="outside lower center", ncols=4)


def convergence(path: Path) -> None:
    """Errors against the number of elements: free frequencies, the stress at a hole, and the hottest cell."""
    with sheet(path, 11.0, 4.6, 1, 3) as (_, (tones, hole, peak)):
        _tones(tones)
        found = kept("cell_hole")
        _hole(hole, found["rows"])
        _peak(peak, found)
        for axis in (tones, hole, peak):
            axis.legend(fontsize=7, loc="upper center", bbox_to_anchor=(0.5, -0.16), ncols=2)
        for axis, counts in ((tones, (500, 2500, 10_000, 40_000)), (hole, (2500, 10_000, 40_000))):
            axis.set_xscale("log")
            axis.set_yscale("log")
            lower, upper = axis.get_ylim()
            levels = [level for level in _LEVELS if lower <= level <= upper]
            axis.set_yticks(levels, [f"{level:g}" for level in levels])
            axis.set_xticks(counts, [f"{count:,}".replace(",", " ") for count in counts])
            axis.set_xticks([], minor=True)
            axis.set_yticks([], minor=True)
            axis.set_xlim(0.8 * counts[0], 1.25 * counts[-1])
            axis.set_xlabel("elements")
            axis.set_ylabel("error [%]")


def _tones(axis: Any) -> None:
    """Worst error of the first six free frequencies."""
    rows = kept("cell_inertia")["rows"]
    for name, colour, mark in (("centre of mass, third of the trace", BLUE, "o"),
                               ("generator, third of the trace", GREY, "x")):  # fmt: skip
        mine = [one for one in rows if one["inertia"] == name]
        axis.plot([one["count"] for one in mine], [100.0 * max(map(abs, one["errors"])) for one in mine], mark,
                  color=colour, ms=5, mfc="none", label=f"beam, {name.split(',')[0]}")  # fmt: skip
    cases = [one for one in kept("cell_bodies")["cases"] if one["count"] >= _LEAST]
    for shape, colour, mark in zip(_SHAPES, (INK, BLUE, GREEN, ORANGE, PURPLE, INK, ORANGE), "s^vD<>P", strict=True):
        mine = [one for one in cases if one["shape"] == shape]
        y = [100.0 * max(abs(one["errors"][f"f{k}"]) for k in range(1, 7)) for one in mine]
        if mine:
            axis.plot([one["count"] for one in mine], y, mark, color=colour, ms=4, label=shape.replace("_", " "))
    axis.set_title("first six free frequencies, worst")


def _hole(axis: Any, rows: list[dict[str, Any]]) -> None:
    for key, colour, mark, words in (
        ("rms", BLUE, "o", "cells about the hole, rms"), ("hot_mean", ORANGE, "s", "hottest hundredth, mean"),
        ("hot_worst", PURPLE, "^", "hottest hundredth, worst"), ("hottest_error", INK, "x", "hottest cell"),
    ):  # fmt: skip
        for nu, fill in ((0.2, "full"), (0.4, "none")):
            mine = [one for one in rows if one["nu"] == nu]
            axis.plot([one["count"] for one in mine], [100.0 * abs(one[key]) for one in mine], mark, color=colour,
                      ms=5, fillstyle=fill, label=words if nu == 0.2 else None)  # fmt: skip
    axis.axhline(5.0, color=GREY, lw=1.0, ls="--")
    axis.annotate("limit", (rows[0]["count"], 5.0), (0, 3), textcoords="offset points", color=GREY)
    axis.set_title("stress at the hole (hollow: ν = 0.4)")


def _peak(axis: Any, found: dict[str, Any]) -> None:
    """The hottest cell, what finite elements have on the same cells, and their peak at the rim."""
    for nu, fill in ((0.2, "full"), (0.4, "none")):
        mine = [one for one in found["rows"] if one["nu"] == nu]
        x = [1.0 / one["radius"] for one in mine]
        axis.plot(x, [one["hottest_wanted"] for one in mine], "s", color=GREY, ms=6, fillstyle=fill,
                  label="finite elements, mean over cells" if nu == 0.2 else None)  # fmt: skip
        axis.plot(x, [one["hottest"] for one in mine], "o", color=ORANGE, ms=4, fillstyle=fill,
                  label="cells" if nu == 0.2 else None)  # fmt: skip
        axis.plot(0.0, found["peaks"][str(nu)]["largest"], "D", color=INK, ms=6, fillstyle=fill, clip_on=False,
                  label="continuum, at the rim" if nu == 0.2 else None)  # fmt: skip
    axis.set_xlim(0.0, None)
    axis.set_xlabel("edge of an element over radius of the hole [-]")
    axis.set_ylabel("stress over that of the end [-]")
    axis.set_title("the hottest cell and the peak")


def draw(_: Record, folder: Path) -> None:
    """Both figures, from records of five studies of cells."""
    dispersion(folder / "cell_dispersion.png")
    convergence(folder / "cell_convergence.png")
