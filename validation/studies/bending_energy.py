"""Where the work of a bent beam of concrete goes: facets that part along the ligament, beside them, under rollers.

The notched beam of `concrete.py` (400 × 100 × 100 mm over 300 mm, a notch of a third of the depth; E = 40 GPa,
f_t = 4 MPa, G_f = 100 J/m²) by `bd.labtests.three_point_bending`, with several bands about the softening line. No
cell yields there and no closed crack rubs: all work is that of facets, and what is stored in the end. The energy of
an event is shared among its facets by T² Δs of each; facets are sorted by what is left of them and by depth, in
eight bands of the ligament, each over G_f times its area. "late" is what facets dissipate above their line as they
begin where T is beyond their onset; "over steps" the energy of all events over T² Δs A / 2k of their facets.
"""

import time
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from itertools import product
from typing import Literal
from unittest.mock import patch

import numpy as np

import bondem as bd
from bondem.statics.quasistatic.sawtooth import SofteningLine, Teeth
from validation.frame.record import Record
from validation.studies.concrete import BEAM, ENERGY, LAW, NOTCH, TENSION, concrete, specimen

BANDS = 8
#: A facet with at most this integrity is torn; one with less than the second has lost half [-].
TORN, HALF = 1e-6, 0.5


@contextmanager
def begun_facets() -> Iterator[list[tuple[SofteningLine, float, Teeth]]]:
    """Lines of the facets that begin, T as each begins, and its steps, in the order in which they begin."""
    found: list[tuple[SofteningLine, float, Teeth]] = []
    usual = Teeth.of

    def kept(line: SofteningLine, ripple: float, now: float = 0.0) -> Teeth:
        found.append((line, max(now, line.onset), usual(line, ripple, now)))
        return found[-1][2]

    with patch.object(Teeth, "of", kept):
        yield found


def shares(body: bd.Lattice, path: bd.QuasistaticResult, begun: list) -> np.ndarray:
    """Of each facet the energy that it has dissipated, of each event by T² Δs; that under its line; and what it has
    taken above the line as it began [J], and over all: energy of events over that of their steps [-], (m, 4).
    """
    model = bd.Model(body, LAW, 1.0, failure=bd.Rankine(tension=TENSION, fracture_energy=ENERGY))
    assert model.softening is not None
    assert body.facets is not None
    reach = np.empty(len(body.pairs))
    reach[model.layout.bond_order] = model.softening.last
    unit = ENERGY * body.facets.area / (TENSION * reach)  # A / 2k: G_f A is onset · last of it where onset is f_t
    own, done, weight = np.zeros((len(reach), 4)), {}, np.empty(len(path.bond))
    for n, (k, s) in enumerate(zip(path.bond.tolist(), path.integrity.tolist(), strict=True)):
        if k not in done:
            curve, now, teeth = begun[len(done)]
            own[k, 1], done[k] = unit[k] * curve.onset * curve.last, (teeth, 0, 1.0, now)
            borne = curve.onset * max(curve.last - now, 0.0) / (curve.last - curve.onset)  # on its straight line
            own[k, 2] = unit[k] * (now - curve.onset) * (now - borne)
        teeth, step, before, T = done[k]
        if s == before:  # from now on it softens in all directions, not in one
            weight[n] = 0.0
            continue
        weight[n] = unit[k] * T**2 * (before - s)
        done[k] = teeth, step + 1, s, float(teeth.limit[step]) if step < len(teeth.limit) else 0.0
    total = np.bincount(path.event, weights=weight, minlength=len(path.energy))
    count = np.bincount(path.event, minlength=len(path.energy))  # an event without a step belongs to all its facets
    stepless = total[path.event] == 0.0
    share = np.where(stepless, 1.0 / count[path.event], weight / np.where(stepless, 1.0, total[path.event]))
    np.add.at(own[:, 0], path.bond, path.energy[path.event] * share)
    own[:, 3] = path.energy.sum() / total[:-1].sum()
    return own


def account(body: bd.Lattice, test: bd.labtests.BendingTest, lines: list) -> dict:
    """What facets took, over G_f times the ligament or times a band of it."""
    assert body.facets is not None
    assert body.cells is not None
    path, place = test.path, body.facets.centroid
    assert isinstance(path, bd.QuasistaticResult)
    (spent, under, late, over), left = shares(body, path, lines).T, path.bond_integrity
    plane = BEAM[2] * test.ligament
    area = body.facets.area * np.abs(body.facets.normal[:, 0])
    torn, half = left <= TORN, left < HALF
    begun = left < 1.0
    depth = (place[:, 1] - (BEAM[1] - test.ligament)) / test.ligament
    band = np.clip(np.floor(depth * BANDS), 0, BANDS - 1).astype(int)
    beam = depth > 0.0
    centre = place[torn & beam, 0].mean() if (torn & beam).any() else 0.5 * BEAM[0]
    size = float(np.cbrt(body.cells.volume.mean()))
    near = np.abs(place[:, 0] - centre) < 2.0 * size
    scale = ENERGY * plane

    def by_band(values: np.ndarray) -> list[float]:
        return (np.bincount(band[beam], weights=values[beam], minlength=BANDS) * BANDS).tolist()

    end = 0.5 * path.load[-1] * -0.5 * (path.gauge["left"] + path.gauge["right"])[-1, 1]
    below = ~beam
    return {
        "facets begun": int(begun.sum()), "facets half": int(half.sum()), "facets torn": int(torn.sum()),
        "cell over notch": size / NOTCH[0], "volume": float(body.cells.volume.sum() / body.particles.envelope.volume),
        "torn area": float(area[torn].sum() / plane),
        "torn facets' own area": float(body.facets.area[torn].sum() / plane),
        "torn facets' lines": float(under[torn].sum() / scale),
        "late": float(late.sum() / scale), "over steps": float(over[0]),
        "energy": float(path.energy.sum() / scale), "stored": float(end / scale),
        "torn": float(spent[torn].sum() / scale), "half": float(spent[half & ~torn].sum() / scale),
        "less": float(spent[~half].sum() / scale), "far": float(spent[~near].sum() / scale),
        "below the tip": float(spent[below].sum() / scale),
        "bands": {
            "torn area": by_band(area * torn / plane), "torn": by_band(spent * torn / scale),
            "others": by_band(spent * ~torn / scale),
        },
    }  # fmt: skip


def measured(body: bd.Lattice, ripple: float, together: float) -> dict:
    """One beam."""
    began, busy = time.perf_counter(), time.process_time()
    with begun_facets() as lines:
        test = bd.labtests.three_point_bending(body, LAW, concrete(), ripple=ripple, together=together)
    seconds, busy = time.perf_counter() - began, time.process_time() - busy
    path = test.path
    assert isinstance(path, bd.QuasistaticResult)
    return {
        "facets": len(body.pairs), "peak": test.peak / TENSION, "load": path.peak,
        "work": test.work / ENERGY, "events": len(path.load), "failures": len(path.bond),
        "solutions": path.solutions, "iterations": path.iterations, "end": path.end,
        "seconds": seconds, "processor seconds": busy, **account(body, test, lines),
    }  # fmt: skip


def measure(
    record: Record, *, counts: tuple[int, ...] = (1000,), seeds: tuple[int, ...] = (1, 2, 3),
    ripples: tuple[float, ...] = (0.1, 0.02), together: tuple[float, ...] = (0.01, 0.005),
    kinds: tuple[Literal["notched", "bending"], ...] = ("notched",),
) -> None:  # fmt: skip
    """Measure beams with bands of several widths, and shares of events that are carried out together."""
    for kind, count, seed in product(kinds, counts, seeds):
        body = specimen(kind, count, seed)
        for ripple, one in product(ripples, together):
            record.add(partial(measured, body, ripple, one), kind=kind, count=count, seed=seed, ripple=ripple,
                       together=one)  # fmt: skip
