"""Comparison of two revisions in turns on one machine, in two processes that are controlled by pipes.

Each process (`paired_worker.py`) imports one revision of bondem, prepares once, and runs when asked. Ratios are taken
pair by pair, A B A B, so that a machine that slows down affects both.
"""

import io
import json
import os
import statistics
import subprocess
import sys
import tarfile
import tempfile
import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SOURCE = ROOT / "src"
# Bond-steps of a sample, about a second of work; the guards of a run check all bonds every 100 steps.
SAMPLE = 40_000_000
_ROUND = 100
# Share of a core that other processes may use during a sample that counts.
QUIET = 0.08
_JIFFIES = os.sysconf("SC_CLK_TCK") if hasattr(os, "sysconf") else 100


def commit_of(revision: str) -> str:
    """Return the first digits of the commit of a revision."""
    words = ["git", "-C", str(ROOT), "rev-parse", "--short=8", "--verify", revision + "^{commit}"]
    return subprocess.run(words, check=True, capture_output=True, text=True).stdout.strip()


def extracted(commit: str) -> Path:
    """Extract an older revision to a temporary folder that later calls reuse, and return its folder `src`."""
    folder = Path(tempfile.gettempdir()) / f"bondem-{commit}"
    if not (folder / "src").is_dir():
        words = ["git", "-C", str(ROOT), "archive", commit]
        archive = subprocess.run(words, check=True, capture_output=True).stdout
        with tempfile.TemporaryDirectory(dir=folder.parent) as aside:
            with tarfile.open(fileobj=io.BytesIO(archive)) as tar:
                tar.extractall(aside, filter="data")
            folder.mkdir(exist_ok=True)
            for part in ("hatch_build.py", "src"):  # in later revisions the first file compiles the core
                if (Path(aside) / part).exists():
                    (Path(aside) / part).rename(folder / part)
    return folder / "src"


class Worker:
    """Process that imports one revision of bondem and carries out tasks.

    Args:
        source: folder `src` of the revision.
        cores: largest number of threads.
    """

    def __init__(self, source: Path, *, cores: int) -> None:
        self._process = subprocess.Popen(
            [sys.executable, str(Path(__file__).parent / "paired_worker.py")],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
            env={**os.environ, "PYTHONPATH": str(source), "BONDEM_NUM_THREADS": str(cores)},
        )  # fmt: skip
        found = Path(self.ask("source")["file"])
        assert found.is_relative_to(source.resolve()), f"{found} was imported instead of {source}"

    def ask(self, task: str, **arguments: object) -> dict:
        """Send a task of `paired_worker.py` with its arguments, and return its answer.

        Raises:
            RuntimeError: The process ended, or the task raised an error.
        """
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdin.write(json.dumps({"task": task, **arguments}) + "\n")
        self._process.stdin.flush()
        line = self._process.stdout.readline()
        if not line:
            raise RuntimeError(f"the process that should do '{task}' ended (exit status {self._process.wait()})")
        answer = json.loads(line)
        if "error" in answer:
            raise RuntimeError(f"'{task}' failed:\n{answer['error']}")
        return answer

    def __enter__(self) -> "Worker":
        return self

    def __exit__(self, *_: object) -> None:
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdin.close()
        self._process.wait(timeout=60)
        self._process.stdout.close()


def specimen_file(worker: Worker, elements: int, *, largest: int = 100_000) -> Path:
    """Return the file of the specimen of `tiled.py`, which one worker makes once and both read."""
    path = Path(tempfile.gettempdir()) / f"bondem-specimen-{elements}-{largest}.npz"
    if not path.exists():
        print(f"packing {elements} elements ...", file=sys.stderr, flush=True)
        worker.ask("specimen", elements=elements, largest=largest, path=str(path))
    return path


@dataclass(frozen=True)
class Sample:
    """Speed of one revision over some steps.

    Attributes:
        rate: million bond-steps per second of wall time.
        own: million bond-steps per second of processor time of the process.
        others: share of a core that other processes used meanwhile [-].
    """

    rate: float
    others: float
    own: float


@dataclass(frozen=True)
class Pairs:
    """Samples of two revisions in turns, with statistics of their ratios.

    Attributes:
        first, second: samples of each, in equal number.
    """

    first: tuple[Sample, ...]
    second: tuple[Sample, ...]

    @property
    def quiet(self) -> list[int]:
        """Indices of the pairs with little load by other processes; those of all pairs if fewer than three."""
        pairs = range(len(self.first))
        found = [k for k in pairs if max(self.first[k].others, self.second[k].others) < QUIET]
        return found if len(found) >= 3 else list(pairs)

    @property
    def gain(self) -> float:
        """Median over the quiet pairs of the second rate over the first [-]."""
        return statistics.median(self.second[k].rate / self.first[k].rate for k in self.quiet)

    @property
    def own_gain(self) -> dict[str, float]:
        """Smallest, median and largest ratio of processor times of all pairs, the first over the second [-]."""
        ratios = [b.own / a.own for a, b in zip(self.first, self.second, strict=True)]
        return {"min": min(ratios), "median": statistics.median(ratios), "max": max(ratios)}

    @property
    def busy(self) -> float:
        """Largest share of a core that other processes used in a pair that counts [-]."""
        return max(max(self.first[k].others, self.second[k].others) for k in self.quiet)

    def spread(self, side: Sequence[Sample]) -> dict[str, float]:
        """Return smallest, median and largest rate of a revision in the pairs that count [million bond-steps/s]."""
        rates = [side[k].rate for k in self.quiet]
        return {"min": min(rates), "median": statistics.median(rates), "max": max(rates)}

    def report(self, names: tuple[str, str]) -> dict:
        """Return all statistics and samples as a dictionary for a result file, with the names of both revisions."""
        return {
            "gain": round(self.gain, 3),
            "gain by processor time": {key: round(value, 3) for key, value in self.own_gain.items()},
            "pairs": len(self.first),
            "pairs that count": len(self.quiet),
            "others": round(self.busy, 3),
            **{
                name: {key: round(value, 2) for key, value in self.spread(side).items()}
                for name, side in zip(names, (self.first, self.second), strict=True)
            },
            "samples": {
                name: [{key: round(value, 3) for key, value in asdict(sample).items()} for sample in side]
                for name, side in zip(names, (self.first, self.second), strict=True)
            },
        }

    def line(self) -> str:
        """Return a line with both rates (min / median / max), the gain, and the load by other processes."""
        sides = [self.spread(side) for side in (self.first, self.second)]
        rates = "".join(f"  {s['min']:6.1f} /{s['median']:6.1f} /{s['max']:6.1f}" for s in sides)
        own = "/".join(f"{value:5.2f}" for value in self.own_gain.values())
        return f"{rates}  {self.gain:6.2f}  {own}  {len(self.quiet):3d} of {len(self.first)}  {self.busy:6.0%}"


HEAD = "  {0:>22}  {1:>22}  {2:>6}  processor time     {3:>8}  {4:>6}"


def head(names: tuple[str, str]) -> str:
    """Return the header of a table of `Pairs.line`."""
    rates = [f"{name}, M/s" for name in names]
    return HEAD.format(*rates, "gain", "pairs", "others")


def steps_of(bonds: int) -> int:
    """Return the number of steps of a sample, a multiple of 100 (the interval of guards)."""
    return _ROUND * max(1, round(SAMPLE / bonds / _ROUND))


def in_turns(first: Worker, second: Worker, bonds: int, *, threads: int, repeat: int, steps: int | None) -> Pairs:
    """Return `repeat` pairs of samples of two workers that have loaded a body, after a warm-up."""
    count = steps if steps is not None else steps_of(bonds)
    sides = (first, second)
    for worker in sides:
        worker.ask("go", threads=threads, steps=max(2, count // 10))
    samples: tuple[list[Sample], list[Sample]] = ([], [])
    for _ in range(repeat):
        for worker, found in zip(sides, samples, strict=True):
            found.append(_sample(worker, bonds, threads, count))
    return Pairs(tuple(samples[0]), tuple(samples[1]))


def _sample(worker: Worker, bonds: int, threads: int, steps: int) -> Sample:
    busy, start = _busy(), time.perf_counter()
    answer = worker.ask("go", threads=threads, steps=steps)
    wall = time.perf_counter() - start
    others = max(0.0, _busy() - busy - answer["cpu"]) / wall
    done = bonds * steps / 1e6
    return Sample(done / answer["seconds"], others, done / answer["cpu"])


def _busy() -> float:
    """Return the total working time of all cores since boot [s]; 0 if the system has no /proc/stat."""
    path = Path("/proc/stat")
    if not path.exists():
        return 0.0
    user, nice, system, _, _, irq, soft, steal, *_ = (int(word) for word in path.read_text().split()[1:10])
    return (user + nice + system + irq + soft + steal) / _JIFFIES
