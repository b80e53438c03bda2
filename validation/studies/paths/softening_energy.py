"""Fracture energy of bars and notched bars; explicit beside quasi-static results."""

import itertools
from functools import cache

import bondem as bd
from validation.studies.paths.driving import LAW, RHO, TENSION, Course, E, course
from validation.studies.paths.rows import Row

#: Fracture energies [J/m²] and curves.
ENERGIES = (50.0, 200.0)
CURVES: dict[str, bd.Bilinear | None] = {"linear": None, "bilinear": bd.Bilinear()}
#: Limits: of the mean fracture energy of a kind, the strength of a bar, explicit beside quasi-static results [-].
ENERGY_LIMIT, STRENGTH_LIMIT, SOLVER_LIMIT = 0.04, 0.005, 0.01
#: Bars, and the notch on one side: width along x and depth along y [m].
BAR, NOTCH = (80e-3, 40e-3, 40e-3), (4e-3, 13e-3)
_TRAVERSES = 30.0
# Speed at which bars are torn after their peak: so much of G_f / f_t over f_t / E of the length.
_HURRY = 0.7


@cache
def bar(kind: str, seed: int, count: int) -> bd.Lattice:
    """A bar, plain or notched to a third of its height."""
    shape: bd.Shape = bd.Box(BAR)
    if kind == "notched":
        slot = bd.Box((NOTCH[0], NOTCH[1], 2.0 * BAR[2]))
        shape = shape.cut(slot.moved((0.5 * (BAR[0] - NOTCH[0]), 0.0, -0.5 * BAR[2])), name="notch")
    return bd.connect(bd.pack(shape, count=count, method="even", seed=seed), method="laguerre")


def material(energy: float, curve: str) -> bd.Rankine:
    """Of a fracture energy [J/m²] and the name of a curve."""
    return bd.Rankine(tension=TENSION, fracture_energy=energy, curve=CURVES[curve])


def kinds() -> list[tuple[float, str]]:
    """Fracture energies and curves, each with each."""
    return list(itertools.product(ENERGIES, CURVES))


def _pulled(kind: str, energy: float, curve: str, seed: int, count: int) -> Course:
    """A bar pulled past its peak slowly, and then apart: an opening of G_f / f_t takes as long whatever G_f is."""
    stretch = 1.05 * TENSION / E * BAR[0]
    last = 1.5 * (3.6 if CURVES[curve] else 2.0) * energy / TENSION
    return course(
        bar(kind, seed, count), material(energy, curve), {"x": (0.0, stretch, stretch + last)}, ending=0.003,
        hurry=max(1.0, _HURRY * energy / TENSION / stretch),
    )  # fmt: skip


def plain(seed: int, count: int) -> list[Row]:
    """Strength and fracture energy of a bar."""
    rows = []
    for energy, curve in kinds():
        found = _pulled("plain", energy, curve, seed, count)
        ratio = float(found.run.history.energy["work"][-1]) / (BAR[1] * BAR[2] * energy)
        note = f"G_f = {energy:g} J/m², {curve}, {found.note}"
        rows += [
            Row("energy", "plain bar: f_t", found.peak() / TENSION, 1.0, STRENGTH_LIMIT, note=note),
            Row("energy", "plain bar: G_f", ratio, 1.0, ENERGY_LIMIT, mean=True, note=note),
        ]
    return rows


def notched(seed: int, count: int) -> list[Row]:
    """Fracture energy of a notched bar: work over the ligament."""
    rows = []
    for energy, curve in kinds():
        found = _pulled("notched", energy, curve, seed, count)
        ratio = float(found.run.history.energy["work"][-1]) / ((BAR[1] - NOTCH[1]) * BAR[2] * energy)
        note = f"G_f = {energy:g} J/m², {curve}, {found.note}"
        rows.append(Row("energy", "notched bar: G_f", ratio, 1.0, ENERGY_LIMIT, mean=True, note=note))
    return rows


def solvers(seed: int, count: int) -> list[Row]:
    """Peak and work of explicit runs over those of equilibria, of the same bars."""
    rows = []
    for kind in ("plain", "notched"):
        body, failure = bar(kind, seed, count), material(ENERGIES[0], "linear")
        test = bd.labtests.direct_tension(body, LAW, failure, traverses=2.0 * _TRAVERSES)
        ends = [bd.Fix(bd.Face("x_min"), translation="x", rotation=""), bd.Drive(bd.Face("x_max"), x=1e-6)]
        held = _held(body)
        path = bd.solve_quasistatic(
            bd.Model(body, LAW, RHO, failure=failure, boundary=[*ends, *held]), bd.Face("x_max"), until=0.002
        )  # fmt: skip
        section = BAR[1] * BAR[2]
        torn = (BAR[1] - NOTCH[1]) * BAR[2] if kind == "notched" else section
        work = float(path.work[-1]) / torn
        note = f"{path.end}, {len(path.load)} events"
        # direct_tension gives the stress over the section at mid-length of the shape, which notches do not narrow
        largest = float(test.run.history["far"][:, 0].max())
        rows += [
            Row("solvers", f"{kind} bar: peak", largest / path.peak, 1.0, SOLVER_LIMIT, note=note),
            Row("solvers", f"{kind} bar: work", test.work / work, 1.0, SOLVER_LIMIT, note=note),
        ]
    return rows


def _held(body: bd.Lattice) -> list[bd.BoundaryCondition]:
    """Three displacements of cells that take the rigid motion across the load out, and bear nothing."""
    place = body.particles.position
    near = int(((place - [0.0, 0.5 * BAR[1], 0.5 * BAR[2]]) ** 2).sum(axis=1).argmin())
    far = int(((place - [0.0, 0.5 * BAR[1], BAR[2]]) ** 2).sum(axis=1).argmin())
    return [
        bd.Fix(bd.Index([near]), translation="yz", rotation=""), bd.Fix(bd.Index([far]), translation="y", rotation="")
    ]  # fmt: skip
