"""Figure of the speed over versions: bond-steps per second of beams, one thread, about 10 000 elements.

The numbers are those of result files in the history of the repository; this script measures nothing. The files are
`benchmarks/results/peers*.json` (elastic beams in bondem and other codes) and `against.json` (an older revision in
turns with the present one). Machines differ, so that lines join only numbers of one processor and benchmark.

Run: python benchmarks/speed_over_versions.py [docs/figures/speed_over_versions.png]
"""

import json
import subprocess
import sys
from datetime import datetime
from pathlib import Path

from bondem.report.style import sheet

ROOT = Path(__file__).parents[1]
LARGEST = 20_000  # elements

Point = tuple[datetime, float]


def git(*words: str) -> str:
    """Return the output of a command of git."""
    return subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True, check=True).stdout


def versions(name: str) -> list[dict]:
    """Return the contents of a result file in every commit that changed it, the newest first."""
    path = f"benchmarks/results/{name}.json"
    return [json.loads(git("show", f"{one}:{path}")) for one in git("log", "--format=%h", "--", path).split()]


def beside_peers(name: str) -> list[tuple[str, Point]]:
    """Return dates and median rates of bondem beside other codes [million bond-steps/s], by processor."""
    found = []
    for kept in versions(name):
        small = [one for one in kept["specimens"] if one["elements"] < LARGEST and "bondem" in one["codes"]]
        for one in small:
            processor = kept["machine"].split("x86_64, ")[1].split(" (")[0].split(", ")[0].replace("(R)", "")
            rate = one["codes"]["bondem"]["Mbond_steps_per_s_median"]
            found.append((processor, (datetime.fromisoformat(kept["started"]), rate)))
    return found


def in_turns() -> list[Point]:
    """Return dates and median rates of an older revision and, from the same pairs of runs, of the newer code."""
    kept = next(iter(versions("against")[0].values()))
    before = datetime.fromisoformat(git("show", "-s", "--format=%cI", kept["revision"]).strip())
    rates = next(one for one in kept["rates"] if one["elements"] < LARGEST and one["threads"] == 1)
    after = datetime.fromisoformat(kept["started"])
    return [(before, rates[kept["revision"]]["median"]), (after, rates["now"]["median"])]


def main(place: Path) -> None:
    """Draw the figure and print its numbers."""
    lines: dict[str, list[Point]] = {"Intel Xeon Processor, in turns (against.py)": in_turns()}
    for name in ("peers", "peers_kratos"):
        for processor, point in beside_peers(name):
            lines.setdefault(f"{processor}, beside other codes (peers/compare.py)", []).append(point)
    with sheet(place, 6.4, 3.4) as (figure, ax):
        for label, points in lines.items():
            points = sorted(set(points))
            ax.plot(*zip(*points, strict=True), "o-", label=label)
            for when, rate in points:
                print(f"{when:%Y-%m-%d}  {rate:6.1f} Mbond-steps/s  {label}")
        ax.set(ylabel="million bond-steps per second", ylim=(0.0, None))
        ax.legend(loc="upper left", frameon=False)
        figure.autofmt_xdate()


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "docs" / "figures" / "speed_over_versions.png")
