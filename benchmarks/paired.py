"""Two codes in turns on one machine: long-lived processes that take turns by pipe.

Each side is a process of its own (`paired_worker.py`) that imports the bondem it is given, sets up once and then
waits for its turn. Ratios are taken pair by pair, A B A B, so that a machine that slows down slows both.
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
# Bond-steps of a sample: about a second; the guards of a run look at all bonds every 100 steps.
SAMPLE = 40_000_000
_ROUND = 100
# Share of a core that others may take in a sample which counts.
QUIET = 0.08
_JIFFIES = os.sysconf("SC_CLK_TCK") if hasattr(os, "sysconf") else 100


def extracted(revision: str) -> Path:
    """The folder `src` of an older revision, in a temporary folder that later calls find again."""
    git = ["git", "-C", str(ROOT)]
    commit = subprocess.run(
        [*git, "rev-parse", "--verify", revision + "^{commit}"], check=True, capture_output=True, text=True
    ).stdout.strip()
    folder = Path(tempfile.gettempdir()) / f"bondem-{commit[:12]}"
    if not (folder / "src").is_dir():
        archive = subprocess.run([*git, "archive", commit], check=True, capture_output=True).stdout
        with tempfile.TemporaryDirectory(dir=folder.parent) as aside:
            with tarfile.open(fileobj=io.BytesIO(archive)) as tar:
                tar.extractall(aside, filter="data")
            folder.mkdir(exist_ok=True)
            for part in ("hatch_build.py", "src"):  # the first compiles the core of the second, in later revisions
                if (Path(aside) / part).exists():
                    (Path(aside) / part).rename(folder / part)
    return folder / "src"


class Worker:
    """A process that runs one bondem, and does what it is asked.

    Args:
        source: the folder `src` it imports.
        cores: threads it may use at most.
        cache: where it keeps compiled code; None for where it always does.
        python: interpreter that has what this revision depends on; None for the present one.
    """

    def __init__(
        self, source: Path, *, cores: int, cache: Path | None = None, python: str | None = None
    ) -> None:  # fmt: skip
        # the second name is that of revisions without a core
        threads = {name: str(cores) for name in ("BONDEM_NUM_THREADS", "NUMBA_NUM_THREADS")}
        environment = {**os.environ, "PYTHONPATH": str(source), **threads}
        if cache is not None:
            environment["BONDEM_CACHE_DIR"] = str(cache)
        self._process = subprocess.Popen(
            [python or sys.executable, str(Path(__file__).parent / "paired_worker.py")],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment,
        )  # fmt: skip
        found = Path(self.ask("source")["file"])
        assert found.is_relative_to(source.resolve()), f"{found} was imported instead of {source}"

    def ask(self, task: str, **arguments: object) -> dict:
        """Have a task of `paired_worker.py` done, and wait for its answer."""
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
    """The specimen of `tiled.py`, made once by one side and read by both."""
    path = Path(tempfile.gettempdir()) / f"bondem-specimen-{elements}-{largest}.npz"
    if not path.exists():
        print(f"packing {elements} elements ...", file=sys.stderr, flush=True)
        worker.ask("specimen", elements=elements, largest=largest, path=str(path))
    return path


@dataclass(frozen=True)
class Sample:
    """Some steps of one side.

    Attributes:
        rate: million bond-steps a second, of the clock.
        own: million bond-steps a second of the processor time of the process.
        others: share of a core that other processes took meanwhile [-].
    """

    rate: float
    others: float
    own: float


@dataclass(frozen=True)
class Pairs:
    """Samples of two sides in turns, and what they say.

    Attributes:
        first, second: samples, as many of each.
    """

    first: tuple[Sample, ...]
    second: tuple[Sample, ...]

    @property
    def quiet(self) -> list[int]:
        """Pairs in which others took little of the machine; all where hardly any is."""
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
        """Largest share of a core that others took in a pair that counts [-]."""
        return max(max(self.first[k].others, self.second[k].others) for k in self.quiet)

    def spread(self, side: Sequence[Sample]) -> dict[str, float]:
        """Smallest, median and largest rate of a side in the pairs that count [M/s]."""
        rates = [side[k].rate for k in self.quiet]
        return {"min": min(rates), "median": statistics.median(rates), "max": max(rates)}

    def report(self, names: tuple[str, str]) -> dict:
        """Everything, for a file."""
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
        """Both rates (min / median / max), the gain, and how busy the machine was."""
        sides = [self.spread(side) for side in (self.first, self.second)]
        rates = "".join(f"  {s['min']:6.1f} /{s['median']:6.1f} /{s['max']:6.1f}" for s in sides)
        own = "/".join(f"{value:5.2f}" for value in self.own_gain.values())
        return f"{rates}  {self.gain:6.2f}  {own}  {len(self.quiet):3d} of {len(self.first)}  {self.busy:6.0%}"


HEAD = "  {0:>22}  {1:>22}  {2:>6}  processor time     {3:>8}  {4:>6}"


def head(names: tuple[str, str]) -> str:
    """The line above those of `Pairs.line`."""
    rates = [f"{name}, M/s" for name in names]
    return HEAD.format(*rates, "gain", "pairs", "others")


def steps_of(bonds: int) -> int:
    """Steps of a sample, whole rounds of guards."""
    return _ROUND * max(1, round(SAMPLE / bonds / _ROUND))


def in_turns(first: Worker, second: Worker, bonds: int, *, threads: int, repeat: int, steps: int | None) -> Pairs:
    """`repeat` pairs of samples of two sides that are loaded."""
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
    """Time that all cores together have worked for anybody [s]; 0 where the system does not tell."""
    path = Path("/proc/stat")
    if not path.exists():
        return 0.0
    user, nice, system, _, _, irq, soft, steal, *_ = (int(word) for word in path.read_text().split()[1:10])
    return (user + nice + system + irq + soft + steal) / _JIFFIES
