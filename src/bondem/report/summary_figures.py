"""Figure of all errors, compared with published ones."""

from pathlib import Path

import numpy as np

from bondem.report.findings import Findings
from bondem.report.style import BLUE, GREY, INK, ORANGE, legend_columns, sheet


def draw_errors(path: Path, findings: Findings) -> None:
    """Draw the errors of tests: each packing, mean, scatter, the error against Timoshenko, and published errors."""
    tests = findings.results["tests"]
    names = [name for name, row in tests.items() if row["error"] is not None]
    place = np.arange(len(names))[::-1]
    labelled: set[str] = set()

    def once(label: str) -> str | None:
        fresh = label not in labelled
        labelled.add(label)
        return label if fresh else None

    with sheet(path, 8.2, 0.48 * len(names) + 1.1) as (figure, ax):
        ax.axvline(0.0, color=INK, linewidth=0.9)
        for y, name in zip(place, names, strict=True):
            row = tests[name]
            mean = 100.0 * row["error"]
            own = [100.0 * one.outcomes[name].error for one in findings.specimens]
            ax.barh(y, mean, height=0.34, color=BLUE, label=once("mean over packings"))
            if row["scatter"] is not None:
                ax.errorbar(mean, y, xerr=100.0 * row["scatter"], color=INK, capsize=3, linewidth=1.0)
            ax.plot(own, np.full(len(own), y), "o", markersize=4.5, markerfacecolor="white", markeredgecolor=BLUE,
                    zorder=4, label=once("each packing"))  # fmt: skip
            if row["theory_timoshenko"] is not None:
                off = [one.outcomes[name].error_timoshenko or 0.0 for one in findings.specimens]
                error = 100.0 * float(np.mean(off))
                ax.plot([error], [y], "D", color=ORANGE, markersize=6, zorder=5,
                        label=once("against Timoshenko theory"))  # fmt: skip
            if name in findings.published:
                both = 100.0 * findings.published[name] * np.array([-1.0, 1.0])
                ax.plot(both, [y, y], "|", color=GREY, markersize=17, markeredgewidth=2.0,
                        label=once(f"± {findings.citation.split(',')[0]}"))  # fmt: skip
        ax.set(yticks=place, xlabel="measured / theory − 1  [%]")
        ax.set_yticklabels([name.replace("_", " ") for name in names])
        ax.grid(axis="y", visible=False)
        figure.legend(loc="outside lower center", ncols=legend_columns(4))
