"""Fracture by load factors beside slow explicit runs: notched bars of concrete, and what finer steps change.

E = 40 GPa, ν = 0.2, f_t = 4 MPa, G_f = 20 J/m². A prism 60 × 30 × 30 mm with a notch 3 mm wide and 10 mm deep is
pulled between smooth platens: by `bd.solve_quasistatic` with bands of several widths about the softening line; by
`bd.labtests.direct_tension`, damped, at its usual speed and at a quarter of it; and by displacements that grow by one
and by half a per cent of that of the peak (`measures/displacement_steps.py`), where nothing snaps back.
Peaks over that of the slower explicit run, work over the ligament and G_f, events, facets, and time.
"""

from itertools import product

import bondem as bd
from validation.frame.record import Record
from validation.measures.displacement_steps import pulled_in_steps

LAW = bd.CellBond(E=40e9, nu=0.2)
ENERGY = 20.0
FAILURE = bd.Rankine(tension=4e6, fracture_energy=ENERGY)
SIZE, NOTCH = (60e-3, 30e-3, 30e-3), (3e-3, 10e-3)
LIGAMENT = SIZE[2] * (SIZE[1] - NOTCH[1])
#: Traverses of sound until the expected peak of the explicit runs.
TRAVERSES = (60.0, 240.0)


def body(count: int, seed: int) -> bd.Lattice:
    """The notched prism."""
    slot = bd.Box((NOTCH[0], NOTCH[1], 2.0 * SIZE[2])).moved((0.5 * (SIZE[0] - NOTCH[0]), -1e-6, -0.5 * SIZE[2]))
    shape = bd.Box(SIZE).cut(slot, name="notch")
    return bd.connect(bd.pack(shape, count=count, method="even", seed=seed), method="laguerre")


def explicit(bar: bd.Lattice, traverses: float) -> dict:
    test = bd.labtests.direct_tension(bar, LAW, FAILURE, traverses=traverses)
    return {"traverses": traverses, "peak": test.peak, "work": test.work / ENERGY}


def by_steps(bar: bd.Lattice, way: float, part: float) -> dict:
    """By displacements from 0.7 of that of the peak on, `part` of it each, until a tenth of the peak is lost."""
    found = pulled_in_steps(model_of(bar), bd.Face("x_max"), 0.7 * way, part * way, 0.9)
    return {
        "part": part, "peak": float(found.load.max()) / LIGAMENT,
        "most rounds": int(found.rounds[: found.load.argmax() + 1].max()),
    }


def model_of(bar: bd.Lattice) -> bd.Model:
    ends = [bd.Fix(bd.Face("x_min"), translation="x", rotation=""), bd.Drive(bd.Face("x_max"), x=1e-6)]
    return bd.Model(bar, LAW, density=2400.0, failure=FAILURE, boundary=ends)


def by_factors(bar: bd.Lattice, ripple: float, together: float) -> dict:
    path = bd.solve_quasistatic(model_of(bar), bd.Face("x_max"), ripple=ripple, together=together)
    return {
        "ripple": ripple, "together": together, "peak": path.peak / LIGAMENT,
        "way": float(path.displacement[path.load.argmax()]),
        "work": float(path.work[-1]) / LIGAMENT / ENERGY, "events": len(path.load),
        "closure": float(path.work[-1] - path.stored[-1] - path.energy.sum()) / path.work[-1], "end": path.end,
    }  # fmt: skip


def measure(
    record: Record, *, counts: tuple[int, ...] = (300, 1000, 3000), seeds: tuple[int, ...] = (1,),
    ripples: tuple[float, ...] = (0.2, 0.1, 0.05, 0.02), together: float = 0.005,
    steps: tuple[float, ...] = (0.01, 0.005), traverses: tuple[float, ...] = TRAVERSES,
) -> None:  # fmt: skip
    """Break bars in all three ways.

    Args:
        counts: numbers of cells.
        seeds: of the packings.
        ripples: half widths of the band about the softening line, over the strength.
        together: share of the load within which events are carried out together.
        steps: of the displacement, over that of the peak.
        traverses: of sound until the expected peak of explicit runs.
    """
    for count, seed in product(counts, seeds):
        bar = body(count, seed)
        empty: dict = {"facets": len(bar.pairs), "explicit": [], "load factors": [], "displacements": []}
        record.add(empty.copy, count=count, seed=seed)
        case = next(one for one in record.rows() if (one["count"], one["seed"]) == (count, seed))
        for one in traverses:
            if one not in [known["traverses"] for known in case["explicit"]]:
                case["explicit"].append(explicit(bar, one))
        slow = case["explicit"][-1]["peak"] if case["explicit"] else None
        for ripple in ripples:
            if (ripple, together) not in [(known["ripple"], known["together"]) for known in case["load factors"]]:
                case["load factors"].append(by_factors(bar, ripple, together))
        for part in steps:
            if part not in [known["part"] for known in case["displacements"]]:
                case["displacements"].append(by_steps(bar, case["load factors"][-1]["way"], part))
        for found in (*case["displacements"], *case["load factors"]):
            found["over explicit"] = found["peak"] / slow if slow else None
            print(count, seed, found, flush=True)
        record.keep()
