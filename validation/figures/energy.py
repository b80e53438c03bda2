"""Energies over time: slow tension (André et al. 2012, figs 10, 12) and free vibration (fig. 19)."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from scipy.ndimage import maximum_filter1d

from bondem._types import Floats
from bondem.labtests.vibration import FreeVibration
from bondem.report.style import BLUE, GREEN, GREY, INK, ORANGE, PURPLE, sheet
from validation.figures.axes import draw_bars
from validation.measures.explicit_tension import ExplicitTension

_KINDS = {"normal": BLUE, "shear": ORANGE, "bending": GREEN, "twisting": PURPLE}
_DASHED = (0, (4, 3))
# Records over which a swing is looked at.
_WINDOW = 15


def draw_quasistatic(path: Path, run: ExplicitTension, *, kinetic: float) -> None:
    """Deformation and kinetic energy, on a linear and on a logarithmic scale.

    Args:
        path: PNG to write.
        run: the test.
        kinetic: energy of a bar stretched at the rate of the ramp [J].
    """
    time = run.time * 1e3
    with sheet(path, 8.2, 3.3, 1, 2) as (_, (left, right)):
        unit, name = _unit(float(run.elastic.max()))
        left.plot(time, run.elastic * unit, color=BLUE, label="deformation")
        left.plot(time, run.kinetic * unit, color=ORANGE, label="kinetic")
        left.set(xlabel="time [ms]", ylabel=f"energy [{name}]", title="as in the paper", xlim=(0.0, time[-1]))
        left.legend(loc="center right")
        late = run.time > 0.0
        right.semilogy(time[late], run.elastic[late], color=BLUE, label="deformation")
        right.semilogy(time[late], run.kinetic[late], color=ORANGE, linewidth=0.9, label="kinetic")
        right.plot([0.0, run.ramp * 1e3], [kinetic, kinetic], color=INK, linestyle=_DASHED, linewidth=1.2,
                   label="bar stretched evenly")  # fmt: skip
        low = np.quantile(run.kinetic[late], 0.02)
        right.set(xlabel="time [ms]", ylabel="energy [J]", title="logarithmic", xlim=(0.0, time[-1]),
                  ylim=(0.1 * low, 10.0 * run.elastic.max()))  # fmt: skip
        right.legend(loc="center right")
        for ax in (left, right):
            ax.axvline(run.ramp * 1e3, color=GREY, linewidth=0.9, linestyle=(0, (1, 1.5)))
        left.annotate("load full", (run.ramp * 1e3, 0.25), xycoords=("data", "axes fraction"), xytext=(4, 0),
                      textcoords="offset points", color=GREY)  # fmt: skip


def draw_breakdown(
    path: Path,
    time: Floats,
    energy: Mapping[str, Floats],
    *,
    mark: float,
    mark_name: str,
    window: tuple[float, float] | None = None,
) -> None:
    """Elastic energy by kind: as the paper splits it, and in four shares.

    Args:
        path: PNG to write.
        time: [s], (s,).
        energy: ledger [J], (s,) each.
        mark: a moment to point out [s].
        mark_name: what happened then.
        window: from when to when the left half shows [s]; all of it unless given.
    """
    three = {
        "tension": (energy["normal"], BLUE),
        "bending (shear + bending)": (energy["shear"] + energy["bending"], ORANGE),
        "torsion": (energy["twisting"], PURPLE),
    }
    whole = sum((energy[name] for name in _KINDS), np.zeros(1))
    unit, name = _unit(float(whole.max()))
    some = whole > 1e-4 * whole.max()
    with sheet(path, 8.2, 3.4, 1, 2) as (_, (left, right)):
        left.plot(time * 1e3, whole * unit, color=INK, linewidth=1.0, linestyle=_DASHED, label="all")
        for kind, (values, colour) in three.items():
            left.plot(time * 1e3, values * unit, color=colour, linewidth=1.3, label=kind)
        left.set(xlabel="time [ms]", ylabel=f"elastic energy [{name}]", title="as the paper splits it")
        left.set_ylim(0.0, 1.5 * float(whole.max()) * unit)
        left.legend(loc="upper left", ncols=2, columnspacing=1.0, handlelength=1.4)
        for kind, colour in _KINDS.items():
            share = 100.0 * energy[kind][some] / whole[some]
            label = f"{kind}: {share[-(len(share) // 4) :].mean():.2g} %"
            right.plot(time[some] * 1e3, share, color=colour, linewidth=1.3, label=label)
        right.set(xlabel="time [ms]", ylabel="share of the elastic energy [%]", title="in four", ylim=(0.0, 100.0))
        right.legend(loc="upper left", ncols=2, title="mean of the last quarter", alignment="left")
        for ax in (left, right):
            ax.axvline(mark * 1e3, color=GREY, linewidth=0.9, linestyle=(0, (1, 1.5)))
            ax.set_xlim(0.0, time[-1] * 1e3)
        if window is not None:
            left.set_xlim(1e3 * window[0], 1e3 * window[1])
        right.annotate(mark_name, (mark * 1e3, 0.48), xycoords=("data", "axes fraction"), xytext=(4, 0),
                       textcoords="offset points", color=GREY)  # fmt: skip


def draw_settling(path: Path, runs: Sequence[ExplicitTension], E: float) -> None:
    """How far stress over strain is from the static modulus once the load is full, for runs of different length."""
    with sheet(path, 8.2, 3.3) as (_, ax):
        for run, colour in zip(runs, (PURPLE, ORANGE, BLUE), strict=False):
            holds = run.time >= run.ramp
            off = np.abs(run.stress / run.strain[holds, 0] / E - 1.0)
            name = f"{run.steps:,} steps".replace(",", " ")
            # it swings through zero: its largest over two periods or so is what has not settled
            ax.plot(run.time[holds] / run.dt, maximum_filter1d(off, _WINDOW), color=colour, label=name)
            ax.plot([run.steps], [abs(run.E / E - 1.0)], "D", color=colour, markersize=6, clip_on=False, zorder=5)
        ax.plot([], [], "D", color=GREY, markersize=6, label="mean of the last tenth")
        for level, name in ((1e-2, "1 %"), (1e-3, "0.1 %")):
            ax.axhline(level, color=INK, linewidth=0.9, linestyle=_DASHED)
            ax.annotate(name, (1.0, level), xycoords=("axes fraction", "data"), xytext=(-4, 2),
                        textcoords="offset points", ha="right", color=INK)  # fmt: skip
        ax.set(xlabel="step", ylabel="|E explicit / E static − 1| [-]", xscale="log", yscale="log")
        ax.set_xlim(0.4 * runs[0].steps, 1.25 * runs[-1].steps)
        ax.legend(loc="lower left", ncols=2)


def draw_vibration_energy(path: Path, run: FreeVibration) -> None:
    """What is stored and moving before and after release, the rotational share, and what the ledger misses."""
    time = run.time * 1e3
    energy = run.energy
    kinetic = energy["translation"] + energy["rotation"]
    elastic = sum((energy[name] for name in _KINDS), np.zeros(1))
    unit, name = _unit(float(elastic.max()))
    free = run.free
    with sheet(path, 8.2, 6.4, 3, 1, sharex=True, height_ratios=(2, 1.2, 1.2)) as (_, (top, middle, bottom)):
        top.plot(time, (elastic + kinetic) * unit, color=INK, linewidth=1.2, label="total")
        top.plot(time, elastic * unit, color=BLUE, linewidth=0.9, label="elastic")
        top.plot(time, kinetic * unit, color=ORANGE, linewidth=0.9, label="kinetic")
        top.set(ylabel=f"energy [{name}]", title="energy of the specimen")
        top.set_ylim(0.0, 1.3 * float((elastic + kinetic).max()) * unit)
        top.legend(loc="upper left", ncols=3)
        share = 100.0 * energy["rotation"][free] / np.maximum(kinetic[free], 1e-3 * float(kinetic.max()))
        mean = 100.0 * energy["rotation"][free].sum() / kinetic[free].sum()
        middle.plot(time[free], share, color=PURPLE, linewidth=0.8)
        middle.axhline(mean, color=INK, linestyle=_DASHED, linewidth=1.0)
        middle.set(ylabel="[%]", title=f"share of the kinetic energy in rotation of the elements: mean {mean:.2g} %",
                   ylim=(0.0, None))  # fmt: skip
        bottom.plot(time, 1e6 * energy["balance"] / float(energy["work"].max()), color=GREEN, linewidth=0.8)
        bottom.set(xlabel="time [ms]", ylabel="[10⁻⁶]", title="imbalance of the ledger, over the work of the loads")
        bottom.set_xlim(0.0, time[-1])
        for ax in (top, middle, bottom):
            ax.axvline(run.released * 1e3, color=GREY, linewidth=0.9, linestyle=(0, (1, 1.5)))
        top.annotate("let go", (run.released * 1e3, 0.04), xycoords=("data", "axes fraction"), xytext=(4, 0),
                     textcoords="offset points", color=INK)  # fmt: skip


def draw_inertia(path: Path, summary: Mapping[str, Any]) -> None:
    """Moments of the specimens against those of the continuum, and what the first frequencies owe to them.

    Args:
        path: PNG to write.
        summary: {"mean", "std"} of the quantities, by the names of `results.json`.
    """
    kinds = ("tension", "bending", "torsion")
    with sheet(path, 8.2, 3.3, 1, 2, width_ratios=(2, 3)) as (_, (left, right)):
        names = {
            "mass_excess": "mass", "axial_excess": "moment about\nthe axis", "lateral_excess": "moments\nacross it",
        }  # fmt: skip
        draw_bars(left, np.arange(3.0), [summary[name] for name in names], 0.55, BLUE, None)
        left.set_xticks(range(len(names)), list(names.values()))
        left.set(ylabel="elements / continuum − 1 [%]", title="mass and moments")
        left.margins(y=0.1)
        groups = {
            "mass": ("mass distribution", ORANGE), "stiffness": ("section of the forces", GREEN),
            "measured": ("all, as measured", GREY),
        }  # fmt: skip
        for k, (group, (label, colour)) in enumerate(groups.items()):
            shifts = [summary["frequency"][kind][group] for kind in kinds]
            draw_bars(right, np.arange(3.0) + (k - 1) * 0.27, shifts, 0.25, colour, label)
        right.set_xticks(range(len(kinds)), [f"first frequency,\n{kind}" for kind in kinds])
        right.set(ylabel="shift of the frequency [%]", title="what frequencies owe to it")
        right.margins(y=0.18)
        right.legend(loc="lower left")
        for ax in (left, right):
            ax.axhline(0.0, color=INK, linewidth=0.8)
            ax.grid(axis="x", visible=False)


def _unit(largest: float) -> tuple[float, str]:
    """Factor and name of the unit in which an energy [J] is a handy number."""
    for factor, name in ((1.0, "J"), (1e3, "mJ"), (1e6, "µJ"), (1e9, "nJ")):
        if largest * factor >= 1.0:
            return factor, name
    return 1e12, "pJ"
