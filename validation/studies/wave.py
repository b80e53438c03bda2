"""A wave along the specimen after a strike (André et al. 2012, figs 20, 21)."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

from bondem.interactions.beams.bond_law import BondLaw
from bondem.labtests.cantilever import Cantilever
from bondem.labtests.wave import Wave, first_passage, strike
from validation.figures.wave import draw_arrival, draw_faces, draw_snapshots, draw_travel
from validation.frame.files import mean_and_scatter
from validation.frame.limits import numbers
from validation.frame.study import Row
from validation.rows.bar import BarStudy, BarTest, CalibratedBar
from validation.rows.packings import PackingRequest, kept_lattice

#: Levels at which a wave may be said to have arrived, over the plateau or the first peak [-].
LEVELS = (0.01, 0.02, 0.05, 0.1, 0.25, 0.5, 0.75, 0.9)
#: Moments of the snapshots, in times the wave takes from end to end.
MOMENTS = (0.2, 0.4, 0.6, 0.8, 1.0, 1.5)
# Half the plateau is our criterion; a first sign is what one sees with the eye.
_CRITERION = 0.5
_DURATION = 2.7
_SLICES = 80

_WAYS = {"held": "face held at v", "free": "face given v, then free"}


@dataclass(frozen=True)
class WaveTest(BarTest):
    """A bar struck in both ways.

    Attributes:
        velocity: of the struck face [m/s].
        shown: whether the waves are kept, with slices and moments for the figures.
    """

    velocity: float
    shown: bool

    def tested(self, bar: CalibratedBar, folder: Path) -> dict[str, Any]:
        """Arrivals at each level, by the way it is struck."""
        passage = _passage(bar)
        row: dict[str, Any] = {"speed": (bar.tension.E / bar.rho) ** 0.5, "passage": passage}
        waves = {
            way: strike(
                bar.lattice, bar.law, density=bar.density, duration=_DURATION * passage, velocity=self.velocity,
                held=way == "held", slices=_SLICES if self.shown else 0,
                moments=tuple(passage * moment for moment in MOMENTS) if self.shown else (),
            )
            for way in _WAYS
        }  # fmt: skip
        if self.shown:
            self.keep(folder, waves)
        return row | {way: arrivals(bar, wave, held=way == "held") for way, wave in waves.items()}


@dataclass(frozen=True)
class WaveStudy(BarStudy):
    """A wave along the specimen after a strike: figures 20 and 21 of André et al. (2012).

    Attributes:
        count: spheres of a packing.
        seed: of the first packing, on which the bonds are calibrated.
        packings: how many, seeds in sequence; figures show the first.
        velocity: of the struck face [m/s].
    """

    limits: ClassVar = BarStudy.limits | {"velocity": numbers(above=0.0)}

    packings: int = 5
    velocity: float = 0.1

    def tests(self, packings: Sequence[PackingRequest], law: BondLaw, density: float) -> Sequence[WaveTest]:
        return [WaveTest(one, law, density, self.velocity, k == 0) for k, one in enumerate(packings)]

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        return rows[0]["bar"] | {
            "levels": list(LEVELS),
            "criterion": _CRITERION,
            "summary": _summary(rows),
        }

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """Figures 20 and 21, the travelling wave and the celerity over the criterion."""
        packing, shown = self.first(out)
        figures, row = out / "figures", rows[0]
        chosen = LEVELS.index(_CRITERION)
        crossings = {way: (row[way]["arrival"][chosen], _CRITERION * row[way]["reference"]) for way in _WAYS}
        lattice, passage = kept_lattice(packing, out), row["passage"]
        draw_faces(figures / "wave_faces.png", shown, passage=passage, crossings=crossings)
        draw_snapshots(figures / "wave_snapshots.png", lattice, shown, passage=passage, velocity=self.velocity)
        draw_travel(
            figures / "wave_travel.png", shown, length=lattice.particles.envelope.bounds[1][0],
            speed=row["speed"], velocity=self.velocity,
        )  # fmt: skip
        draw_arrival(figures / "wave_arrival.png", LEVELS, results["summary"])


def arrivals(bar: CalibratedBar, wave: Wave, *, held: bool) -> dict[str, Any]:
    """When the far face passes each level, and what celerity that means.

    Returns:
        "reference": the velocity that levels are shares of [m/s]; per level "arrival" [s], "celerity" [m/s] with
        L_M of eq (12), "error" of it and "error_refined", that of the path from the centres of the struck elements.
    """
    beam = Cantilever.of(bar.lattice, **bar.own)
    passage = _passage(bar)
    late = wave.time >= 1.4 * passage
    reference = float(wave.far[late].mean() if held else wave.far[wave.time <= 2.0 * passage].max())
    position = bar.lattice.particles.position
    path = float(position[beam.loaded, 0].mean() - bar.lattice.particles.envelope.bounds[0][0])
    times = [first_passage(wave.time, wave.far, level * reference) for level in LEVELS]
    speed = beam.paper.wave_speed
    return {
        "reference": reference,
        "arrival": times,
        "celerity": [beam.paper.length / moment for moment in times],
        "error": [beam.paper.length / moment / speed - 1.0 for moment in times],
        "error_refined": [path / moment / speed - 1.0 for moment in times],
    }


def _passage(bar: CalibratedBar) -> float:
    beam = Cantilever.of(bar.lattice, **bar.own).paper
    return beam.length / beam.wave_speed


def _summary(rows: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    def spread(way: str, name: str) -> list[dict[str, float | None]]:
        return [mean_and_scatter([row[way][name][k] for row in rows]) for k in range(len(LEVELS))]

    found: dict[str, Any] = {
        way: {name: spread(way, name) for name in ("celerity", "error", "error_refined")} for way in _WAYS
    }
    chosen = LEVELS.index(_CRITERION)
    return {
        "packings": len(rows),
        "speed": mean_and_scatter([row["speed"] for row in rows]),
        "celerity": found["held"]["celerity"][chosen],
        "error": found["held"]["error"][chosen],
        **found,
    }
