"""Figure of a calibration: its curves, its result and the scatter of packings."""

from pathlib import Path

import numpy as np

from bondem.calibration.abacus import curve
from bondem.calibration.elastic import Calibration
from bondem.interactions.law_catalogue import named
from bondem.report.numbers import with_unit
from bondem.report.style import BLUE, GREY, INK, ORANGE, sheet


def draw_calibration(path: Path, fit: Calibration) -> None:
    """Draw ν and E/E_μ over the free parameter, and E and ν of every calibrating packing, into a PNG."""
    known, free = curve(type(fit.law)), fit.law.free
    trial = np.array([(one.value, one.nu, one.stiffness_ratio) for one in fit.table]).T
    with sheet(path, 10.2, 3.5, 1, 3) as (_, (left, middle, right)):
        for ax, row, label, name in (
            (left, 1, "Poisson's ratio ν [-]", "nu"), (middle, 2, r"$E\,/\,E_\mu$ [-]", "stiffness_ratio"),
        ):  # fmt: skip
            if known is not None and known.parameter == free.name:
                ax.plot(known.values, getattr(known, name), color=GREY, linewidth=1.2, label="curve in bulk")
            ax.plot(trial[0], trial[row], "o", color=BLUE, markersize=4.5, label="evaluations")
            ax.axvline(fit.value, color=ORANGE, linewidth=1.0)
            ax.set(xlabel=free.label, xscale=free.scale, ylabel=label)
        left.axhline(fit.material.nu, color=ORANGE, linewidth=1.0, label=f"wanted: {fit.material.nu:g}")
        left.set_title(f"{named(type(fit.law).__name__)} bonds, {free.tex} = {fit.value:.4g}")
        middle.set_title(f"$E_\\mu$ = {with_unit(fit.law.E, 'Pa')}")
        for ax in (left, middle):
            ax.legend(fontsize=8.0)
        E, nu = (fit.sample(name).values for name in ("E", "nu"))
        off = 100.0 * np.stack([E / fit.material.E - 1.0, nu / fit.material.nu - 1.0])
        right.plot(*off, "o", color=BLUE)
        for line in (right.axhline, right.axvline):
            line(0.0, color=INK, linewidth=0.8)
        size = 1.3 * max(np.abs(off).max(), 0.01)
        right.set(xlim=(-size, size), ylim=(-size, size), title=f"{len(E)} packing" + ("s" if len(E) > 1 else ""),
                  xlabel="E against target [%]", ylabel="ν against target [%]")  # fmt: skip
