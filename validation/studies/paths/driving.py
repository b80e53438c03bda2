"""Bodies between smooth faces that follow a path, slowly and without jumps of their speed."""

import itertools
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

import bondem as bd

Floats = NDArray[np.float64]

#: The material of all cases that name no other: a concrete.
E, NU, RHO, TENSION, ENERGY = 40e9, 0.2, 2400.0, 4e6, 50.0
COHESION, ANGLE, SHEARED = 14.3e6, math.radians(35.0), 5000.0
LAW = bd.CellBond(E=E, nu=NU)
RANKINE = bd.Rankine(tension=TENSION, fracture_energy=ENERGY)
MOHR = bd.MohrCoulomb(
    tension=TENSION, cohesion=COHESION, friction_angle=ANGLE, fracture_energy=ENERGY, fracture_energy_shear=SHEARED
)
#: Edge of cubes [m], of a third of the length 2 E G_f / f_t² above which a bar snaps back.
SIDE = 80e-3
#: How often sound runs along a body until it is stretched by f_t / E, and the share of that in which speeds change.
TRAVERSES, RISE = 100.0, 0.2
# Share of the critical damping of the first axial vibration, steps between records.
_DAMPING, _EVERY = 0.05, 10
_RAMP = 9
AXES = "xyz"


@cache
def cube(seed: int, count: int, side: float = SIDE) -> bd.Lattice:
    """A cube of cells."""
    return bd.connect(bd.pack(bd.Box((side, side, side)), count=count, method="even", seed=seed), method="laguerre")


def travel(
    points: Floats | Sequence[Sequence[float]], speed: float, rise: float, begin: float = 0.0, hurry: float = 1.0
) -> tuple[Floats, Floats]:
    """A path through points, each leg from rest to rest, as times [s], (m,), and values, (m, d).

    Args:
        points: where it goes, (k, d).
        speed: of the component that moves furthest in a leg.
        rise: time in which the speed grows and falls at both ends of a leg; legs that are too short for it never
            reach `speed` [s].
        begin: when it begins [s].
        hurry: how much faster all legs but the first are.
    """
    place = np.asarray(points, dtype=float)
    times, values, hurried = [begin], [place[0]], hurry * speed
    for before, after in itertools.pairwise(place):
        way = float(np.abs(after - before).max())
        speed = speed if len(times) == 1 else hurried
        ramp, plateau = (rise, way / speed - rise) if way > speed * rise else (math.sqrt(way * rise / speed), 0.0)
        if way == 0.0:  # a rest
            ramp = plateau = rise
        along = np.linspace(0.0, 1.0, _RAMP)
        top = ramp + plateau  # time at the largest speed, ramps counting half
        back = along[0 if plateau else 1 :]
        t = np.concatenate([ramp * along, ramp + plateau + ramp * back])
        s = np.concatenate([0.5 * ramp * along**2, top - 0.5 * ramp * (1.0 - back) ** 2]) / top
        times += (times[-1] + t[1:]).tolist()
        values += [before + share * (after - before) for share in s[1:]]
    return np.array(times), np.array(values)


def speeds(times: Floats, values: Floats) -> Floats:
    """Of a path of `travel` at its points: linear in between, nothing at first, (m, d)."""
    found = np.zeros_like(values)
    for k, mean in enumerate(np.diff(values, axis=0) / np.diff(times)[:, None]):
        found[k + 1] = 2.0 * mean - found[k]
    return found


@dataclass(frozen=True, eq=False)
class Course:
    """What a run along a path has measured, one row a record.

    Attributes:
        run: the explicit run.
        moved: of the driven faces [m], by axis, (s,); "slide" of a face that slides.
        stress: mean of both faces over the section, tension positive [Pa], by axis, (s,); of "slide" the shear.
        section: by axis [m²].
        length: by axis [m].
    """

    run: bd.ExplicitResult
    moved: Mapping[str, Floats]
    stress: Mapping[str, Floats]
    section: Mapping[str, float]
    length: Mapping[str, float]

    def peak(self, axis: str = "x") -> float:
        """Largest tension on the faces of an axis [Pa]."""
        return float(self.stress[axis].max())

    def modulus(self, axis: str = "x", low: float = 0.1, high: float = 0.5) -> float:
        """Slope of stress over strain, where the stress is between two shares of its largest size so far [Pa]."""
        size = np.abs(self.stress[axis])
        top = int(size.argmax())
        chosen = np.flatnonzero((size > low * size[top]) & (size < high * size[top]))
        chosen = chosen[chosen < top]
        if len(chosen) < 3:
            return math.nan
        strain = self.moved[axis][chosen] / self.length[axis]
        return float(np.polyfit(strain, self.stress[axis][chosen], 1)[0])

    def left(self, axis: str = "x") -> float:
        """Tension on the faces of an axis at the end [Pa]."""
        return float(self.stress[axis][-1])

    def dissipated(self, axis: str = "x") -> float:
        """What cracks have dissipated over the section across an axis [J/m²]."""
        return float(self.run.history.released[-1]) / self.section[axis]

    @property
    def note(self) -> str:
        """How the run ended, and how far its ledger is off."""
        return f"{self.run.status.value}, imbalance {self.run.history.imbalance:.1e}, {self.run.iterations} steps"


def edges(body: bd.Lattice) -> Floats:
    """Of the box about a body [m], (3,)."""
    assert body.particles.shape is not None
    lower, upper = body.particles.shape.bounds
    return np.asarray(upper) - np.asarray(lower)


def course(
    body: bd.Lattice,
    failure: bd.FailureAssignment,
    knots: Mapping[str, Sequence[float]],
    *,
    slide: Sequence[float] = (),
    state: bd.State | None = None,
    law: bd.CellBond = LAW,
    others: Callable[[float, float], list[bd.BoundaryCondition]] | None = None,
    watch: str = "x",
    ending: float | None = None,
    strength: float = TENSION,
    traverses: float = TRAVERSES,
    hurry: float = 1.0,
) -> Course:
    """Drive opposite smooth faces of a box along a path, all axes at the same time; a first stage or a later one.

    Args:
        body: cells of a box.
        failure: criterion, or criteria by region.
        knots: displacement of the face "x_max" and so on at the points of the path [m], by axis, as many of each; the
            face "x_min" stays. Faces of other axes are free.
        slide: of the face "x_max" along y at the same points [m]; both faces are rough along y then.
        state: where to go on from; the path begins with its time.
        law: of the cells.
        others: further conditions, from the time when the path begins and how long speeds take to grow [s].
        watch: axis whose stress ends the run.
        ending: share of the largest stress at which it ends, once it was above half of the strength.
        strength: whose strain is reached after so many traverses of sound [Pa].
        traverses: number of them.
        hurry: how much faster all legs but the first are.
    """
    size = edges(body)
    long = float(size[AXES.index(watch)])
    sound = math.sqrt(law.E / RHO)
    until = traverses * long / sound
    begin, rise = 0.0 if state is None else state.time, RISE * until
    points = np.column_stack([*(np.asarray(way, dtype=float) for way in knots.values()), *([slide] if slide else [])])
    times, values = travel(points, strength / law.E * long / until, rise, begin, hurry)
    boundary = [] if others is None else others(begin, rise)
    gauges, section = {}, {}
    # a later stage goes on from where faces are, which need not be exactly where they were at first
    how, ways = ("", values) if state is None else ("v", speeds(times, values))
    for k, axis in enumerate(knots):
        near, far = bd.Face(f"{axis}_min"), bd.Face(f"{axis}_max")
        columns = {axis: k} | ({"y": -1} if slide and axis == "x" else {})
        moved: dict[str, Any] = {how + along: bd.Table(times, ways[:, at]) for along, at in columns.items()}
        drive = bd.Drive(far, **moved)
        boundary += [bd.Fix(near, translation="".join(columns), rotation=""), drive]
        gauges |= {f"{axis} near": bd.Gauge(near, "force"), f"{axis} far": bd.Gauge(far, "force")}
        section[axis] = float(np.prod(np.delete(size, AXES.index(axis))))

    def stress_of(history: bd.History, axis: str, d: int) -> Floats:
        return 0.5 * (history[f"{axis} far"][:, d] - history[f"{axis} near"][:, d]) / section[axis]

    along = 0.5 * np.eye(3)[AXES.index(watch)]
    ends = {f"{watch} far": tuple(along), f"{watch} near": tuple(-along)}
    falls = () if ending is None else bd.LoadDrop(ends, ending, 0.5 * strength * section[watch])
    run = bd.solve_explicit(
        bd.Model(body, law, RHO, failure=failure, boundary=boundary), duration=float(times[-1] - begin), state=state,
        damping=bd.MassDamping(alpha=2.0 * _DAMPING * math.pi * sound / long), gauges=gauges, every=_EVERY,
        until=falls,
    )  # fmt: skip
    history = run.history
    moved = {axis: np.interp(history.time, times, values[:, k]) for k, axis in enumerate(knots)}
    stress = {axis: stress_of(history, axis, AXES.index(axis)) for axis in knots}
    if slide:
        moved["slide"] = np.interp(history.time, times, values[:, -1])
        stress["slide"] = stress_of(history, "x", 1)
    length = {axis: float(size[AXES.index(axis)]) for axis in knots}
    return Course(run=run, section=section, length=length, moved=moved, stress=stress)


def torn(length: float = SIDE, *, strength: float = TENSION, energy: float = ENERGY, modulus: float = E) -> float:
    """Displacement at which a bar that softens along a straight line is in two parts, with some to spare [m]."""
    return 1.3 * strength / modulus * length + 3.0 * energy / strength
