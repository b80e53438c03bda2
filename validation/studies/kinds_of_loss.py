"""What facets dissipate, by kind: fracture, and crushing beyond it, of balls that hit a wall and of bars.

Balls of 50 mm hit a smooth wall: E = 30 GPa, ν = 0.2, ρ = 2400 kg/m³, f_t = 4 MPa, G_f = 20 J/m², contact with a
friction of 0.4; `bd.Rankine`, and `bd.MohrCoulomb` with c = 14.3 MPa, φ = 35°, G_II = 200 J/m². They are run for 30
times their diameter over √(E/ρ). Bars of 30 × 10 × 10 mm, f_t = 3 MPa, G_f = 60 J/m², plain and with a notch to a
third of the section, are pulled apart in 840 lengths over √(E/ρ) with a mass damping of a tenth of the first mode.
Reported are, per case,

    fracture    energy of fracture of the facets that broke as cracks, over G_f times their own area
    crushing    energy of crushing over that of fracture, of all facets
    per_area    fracture and crushing of the facets that broke as cracks, over G_f times their own area
    section     fracture and crushing of a bar over G_f times its section or ligament
    ledger      largest error of the ledger over its largest entry
"""

import math
from functools import partial
from itertools import product
from typing import Any

import bondem as bd
from validation.frame.record import Record

E, DENSITY, RADIUS = 30e9, 2400.0, 25e-3
CELERITY = math.sqrt(E / DENSITY)
LAWS = {
    "Rankine": bd.Rankine(tension=4e6, fracture_energy=20.0),
    "MohrCoulomb": bd.MohrCoulomb(
        tension=4e6, cohesion=14.3e6, friction_angle=0.61, fracture_energy=20.0, fracture_energy_shear=200.0
    ),
}
SIDES, NOTCH = (30e-3, 10e-3, 10e-3), 2e-3
IN_BARS, LOSS = bd.Rankine(tension=3e6, fracture_energy=60.0), 60.0


def measured(run: bd.ExplicitResult, section: float | None = None) -> dict[str, Any]:
    """Return the kinds of loss of a run."""
    energy = {name: float(values[-1]) for name, values in run.history.energy.items()}
    (one,) = run.fracture_energy
    found = {
        "fracture": one.fractured, "crushing": energy["crushing"] / energy["fracture"], "per_area": one.ratio,
        "area": run.fracture_area, "ledger": run.history.imbalance,
    }
    if section is not None:
        found["section"] = (energy["fracture"] + energy["crushing"]) / (one.entered * section)
    return found


def impact(law: str, speed: float, count: int, seed: int) -> list[dict[str, Any]]:
    """Return the kinds of loss of a ball that hits a wall."""
    body = bd.connect(bd.pack(bd.Ball(RADIUS), count=count, method="even", seed=seed), method="laguerre")
    assert body.cells is not None
    middle = body.cells.volume @ body.centre / body.cells.volume.sum()
    wall = bd.PlaneWall(point=tuple(middle - [RADIUS, 0.0, 0.0]), normal=(1.0, 0.0, 0.0), friction=0.0)
    model = bd.Model(
        body, bd.CellBond(E=E, nu=0.2), DENSITY, failure=LAWS[law], walls=[wall],
        contact=bd.LinearContact(E=E, friction=0.4),
    )  # fmt: skip
    state = model.state()
    state.velocity = (-speed, 0.0, 0.0)
    run = bd.solve_explicit(model, duration=60.0 * RADIUS / CELERITY, every=20, state=state)
    return [measured(run)]


def bar(shape: str, count: int, seed: int) -> list[dict[str, Any]]:
    """Return the kinds of loss of a bar that is pulled apart."""
    length, width, _ = SIDES
    whole, section = bd.Box(SIDES), width * width
    if shape == "notched":
        slot = bd.Box((NOTCH, 3.0 * width, width / 3.0)).moved((0.5 * (length - NOTCH), -width, -1e-9))
        whole, section = whole.cut(slot, name="notch"), section * 2.0 / 3.0
    body = bd.connect(bd.pack(whole, count=count, method="even", seed=seed), method="laguerre")
    time = 840.0 * length / CELERITY
    last = 3.0 * LOSS / IN_BARS.tension + IN_BARS.tension / E * length
    ends = [
        bd.Fix(bd.Face("x_min"), translation="x", rotation=""),
        bd.Drive(bd.Face("x_max"), x=bd.Table([0.0, time], [0.0, last])),
    ]
    model = bd.Model(body, bd.CellBond(E=E, nu=0.2), DENSITY, failure=IN_BARS, boundary=ends)
    damping = bd.MassDamping(0.1 * math.pi * CELERITY / length)
    run = bd.solve_explicit(model, duration=time, every=50, damping=damping)
    return [measured(run, section)]


def measure(
    record: Record, *, seeds: tuple[int, ...] = (1, 2), counts: tuple[int, ...] = (400, 1200),
    bars: tuple[int, ...] = (300, 500),
) -> None:  # fmt: skip
    """Let balls hit a wall, and pull bars of several numbers of cells."""
    for law, speed, count, seed in product(LAWS, (10.0, 30.0), counts, seeds):
        case = {"law": law, "speed": speed, "count": count, "seed": seed}
        record.add(partial(impact, **case), "impacts", **case)
    for shape, count, seed in product(("plain", "notched"), bars, seeds):
        case = {"shape": shape, "count": count, "seed": seed}
        record.add(partial(bar, **case), "bars", **case)
