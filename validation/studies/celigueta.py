"""Tests with plates of Celigueta et al. (2020) with their non-local law: compression, splitting and shear."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from pathlib import Path
from typing import Any, ClassVar

from validation.figures.celigueta import draw_broken, draw_curves
from validation.frame.files import mean_and_scatter
from validation.frame.limits import numbers, words
from validation.frame.study import Row, Stages, Study
from validation.rows.celigueta import COUNT, FRICTION, CeliguetaRun

FAILURES = ("Rankine", "Mohr-Coulomb")
AREAS = ("weighted", "facet")
#: Strengths measured on the concrete [Pa], which the paper's law with these parameters is said to agree with.
#: Of shear it prints none.
MEASURED = {"compression": 55e6, "splitting": 4e6, "shear": None}
#: How far the mean of all packings may be off: the paper prints no tolerance.
LIMIT = 0.1


@dataclass(frozen=True)
class Celigueta(Study):
    """Celigueta et al. (2020): a concrete cylinder, 100 mm × 200 mm, pressed along its axis and across it, and shear.

    E = 40 GPa, ν = 0.2; Rankine, 6 MPa, or Mohr and Coulomb, 14.5 MPa and 60°; friction 0.1 everywhere; plates at
    0.05 and 0.1 m/s. Elements in the authors' construction (spheres bonded up to a distance of 1.3 (Ri + Rj),
    weighted areas, levers on the line of centres), and with Laguerre facets. The paper leaves open and this study
    sets: density 2400 kg/m³, local damping 0.3, contacts with E = 40 GPa, kn / ks = 2 (1 + ν) and a tenth of critical
    damping (the paper has restitution 0: critical dashpots would take a ninth of the time step), plates that start in
    0.2 ms. In shear the core of a cylinder, 150 mm × 80 mm with ring borings 4 mm wide and 10 mm deep at 45 mm, is
    pushed out at 0.1 m/s by a piston as wide as the core, 41 mm, through a hole as wide as the boring, 49 mm.

    Attributes:
        count: elements; 0 for those of the paper: 12 000 in compression, 9000 in splitting and 161 000 in shear.
        seeds: packings of each.
        slower: plates by so many times slower than in the paper; given after 1 these are the check of the speed.
        failures: criteria.
        areas: constructions.
        tests: of compression, splitting and shear.
        platens: friction of the plates, one after the other.
    """

    limits: ClassVar = {
        "count": numbers(least=200, or_zero=True, advice="200 elements or more, or 0 for the paper's"),
        "seeds": numbers(least=0), "slower": numbers(above=0.0), "failures": words(FAILURES), "areas": words(AREAS),
        "tests": words(MEASURED), "platens": numbers(least=0.0),
    }  # fmt: skip

    count: int = 1000
    seeds: tuple[int, ...] = (1, 2, 3)
    slower: tuple[float, ...] = (1.0,)
    failures: tuple[str, ...] = FAILURES
    areas: tuple[str, ...] = AREAS
    tests: tuple[str, ...] = ("compression", "splitting")
    platens: tuple[float, ...] = (FRICTION,)

    def requests(self) -> list[CeliguetaRun]:
        """All runs."""
        return [
            CeliguetaRun(test, failure, areas, self.count or COUNT[test], seed, slower, friction=friction)
            for slower in self.slower for friction in self.platens for seed in self.seeds for areas in self.areas
            for test in self.tests for failure in self.failures
        ]  # fmt: skip

    def stages(self, out: Path) -> Stages:
        yield "press", self.requests()

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        """See `Study`: of each test, criterion and construction the peaks of its packings."""
        good = [row for row in rows if not row["error"]]
        cases = []
        asked = product(self.slower, self.platens, self.tests, self.failures, self.areas)
        for slower, friction, test, failure, areas in asked:
            wanted = {"test": test, "failure": failure, "areas": areas, "slower": slower, "friction": friction}
            some = [row for row in good if all(row[key] == value for key, value in wanted.items())]
            if some:
                cases.append(wanted | _judged(MEASURED[test], some))
        return {"limit": LIMIT, "cases": cases}

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """See `Study`: curves of all packings, and what the first packing is after the test."""
        for test in self.tests:
            some = [row for row in rows if row["test"] == test and row["slower"] == self.slower[0]]
            if some:
                draw_curves(out / "figures" / f"{test}.png", test, MEASURED[test], some)
        first = [one for one in self.requests() if one.seed == self.seeds[0] and one.slower == self.slower[0]]
        there = [(one.asked, one.kept(out)) for one in first if one.whole(out)]
        if there:
            draw_broken(out / "figures" / "broken.png", there)


def _judged(measured: float | None, rows: Sequence[Row]) -> dict[str, Any]:
    mean = mean_and_scatter([row["peak"] for row in rows])
    assert mean["mean"] is not None
    ratio = mean["mean"] / measured if measured else None
    verdict = "" if ratio is None else "met" if abs(ratio - 1.0) <= LIMIT else "missed"
    moduli = [row["E_plates"] for row in rows if row.get("E_plates")]
    kept = ("seed", "count", "peak", "other", "E_plates", "broken", "z", "run_seconds", "status")
    return {
        "measured": measured, "mean": mean, "ratio": ratio, "verdict": verdict,
        "mean_E": mean_and_scatter(moduli) if moduli else None,
        **{key: [row.get(key) for row in rows] for key in kept},
    }
