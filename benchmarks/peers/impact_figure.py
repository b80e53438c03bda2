"""Figure of the results of `impact.py`: python benchmarks/peers/impact_figure.py."""

import json
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent.parent))
from bondem.report.style import BLUE, GREY, INK, ORANGE, sheet
from kept import RESULTS, ROOT

LOOKS = {
    "published": (GREY, "LAMMPS as published: bonds soften before they break"),
    "matched": (ORANGE, "LAMMPS, brittle, dashpots as in bondem"),
    "bondem": (BLUE, "bondem"),
}


def main(out: Path = ROOT / "docs" / "figures" / "impact.png") -> None:
    report = json.loads((RESULTS / "impact.json").read_text())
    steps = np.arange(0, report["steps"] + 1, report["every"])
    with sheet(out, 6.3, 3.6) as (_, ax):
        for name, (colour, label) in LOOKS.items():
            for k, run in enumerate(report["runs"]):
                lost = 100.0 * np.array(run[name]["lost"]) / run["bonds"]
                ax.plot(steps, lost, color=colour, ls="--" if k else "-", label="" if k else label)
        every = report["steps"] // (len(report["log"]) - 1)
        logged = 100.0 * (1.0 - np.array(report["log"]) / report["log"][0])
        ax.plot(steps[:: every // report["every"]], logged, "+", color=INK, label="log of LAMMPS, other dashpots")
        ax.set(xlabel="step (of 0.05)", ylabel="bonds lost [%]")
        ax.legend(loc="upper left")


if __name__ == "__main__":
    main()
