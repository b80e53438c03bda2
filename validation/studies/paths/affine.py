"""Boxes whose faces across x and y follow a homogeneous strain, so that principal axes may turn; z is free."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

import bondem as bd
from validation.studies.paths.driving import LAW, RHO, RISE, TENSION, TRAVERSES, E, Floats, edges, speeds, travel

_EVERY = 50


@dataclass(frozen=True, eq=False)
class Sheared:
    """What was measured along the path, one row a record.

    Attributes:
        run: the explicit run.
        strain: ε_xx, γ_xy and ε_yy that were prescribed [-], (s, 3).
        stress: mean over the volume [Pa], (s, 3, 3).
    """

    run: bd.ExplicitResult
    strain: Floats
    stress: Floats

    @property
    def principal(self) -> Floats:
        """Largest principal stress of the mean stress [Pa], (s,)."""
        return np.asarray(np.linalg.eigvalsh(self.stress)[:, 2], dtype=np.float64)

    @property
    def peak(self) -> float:
        """The largest of it [Pa]."""
        return float(self.principal.max())

    @property
    def shear_modulus(self) -> float:
        """Slope of τ over γ up to half of the largest τ [Pa]."""
        shear = self.stress[:, 0, 1]
        chosen = np.flatnonzero((shear > 0.1 * shear.max()) & (shear < 0.5 * shear.max()))
        chosen = chosen[chosen < shear.argmax()]
        return float(np.polyfit(self.strain[chosen, 1], shear[chosen], 1)[0]) if len(chosen) > 2 else math.nan


def sheared(
    body: bd.Lattice,
    failure: bd.FailureAssignment,
    points: Sequence[tuple[float, ...]],
    *,
    state: bd.State | None = None,
    ending: float | None = 0.8,
) -> Sheared:
    """Prescribe ε_xx, γ_xy and ε_yy on the faces across x and y.

    The facets of each cell on a face move as one.

    Args:
        body: cells of a box.
        failure: criterion.
        points: ε_xx, γ_xy and ε_yy at the points of the path [-]; without the last one ε_yy = -ν ε_xx, so that
            σ_yy is nothing.
        state: where to go on from, in its reference.
        ending: share of the largest σ1 at which it ends, once it was above half of f_t; None to go on to the end.
    """
    long = float(edges(body)[0])
    until = TRAVERSES * long / math.sqrt(E / RHO)
    begin = 0.0 if state is None else state.time
    whole = [point if len(point) == 3 else (*point, -LAW.nu * point[0]) for point in points]
    times, values = travel(whole, TENSION / E / until, RISE * until, begin)
    # a later stage goes on from where facets are, which need not be exactly where they were at first
    how, ways = ("", values) if state is None else ("v", speeds(times, values))
    boundary: list[bd.BoundaryCondition] = []
    assert body.cells is not None
    free = body.cells.free
    for name in ("x_min", "x_max", "y_min", "y_max"):
        facets = body.on_face(name)
        for cell in np.unique(free.cell[facets]):
            own = facets[free.cell[facets] == cell]
            x, y, _ = np.average(free.centroid[own], axis=0, weights=free.area[own])
            way = ways[:, 0] * x + 0.5 * ways[:, 1] * y, ways[:, 2] * y + 0.5 * ways[:, 1] * x
            pairs = zip("xy", way, strict=True)
            moved: dict[str, Any] = {f"{how}{axis}": bd.Table(times, one) for axis, one in pairs}
            boundary.append(bd.Drive(bd.Face(name) & bd.Index([int(cell)]), **moved))
    boundary.append(bd.Fix(bd.Face("z_min"), translation="z", rotation=""))
    model = bd.Model(body, LAW, RHO, failure=failure, boundary=boundary)
    share = body.cells.volume / body.cells.volume.sum()
    found: list[Floats] = []
    top = [0.0]

    def read(now: bd.State, _record: bd.History) -> bool:
        moving = now.step > 0 and now.time > begin
        found.append(np.einsum("n,nab->ab", share, bd.cell_stress(model, now)) if moving else np.zeros((3, 3)))
        largest = float(np.linalg.eigvalsh(found[-1])[2])
        top[0] = max(top[0], largest)
        return ending is not None and top[0] > 0.5 * TENSION and largest < ending * top[0]

    run = bd.solve_explicit(
        model, duration=float(times[-1] - begin), state=state, every=_EVERY, callback=read,
        damping=bd.MassDamping(alpha=0.1 * math.pi * math.sqrt(E / RHO) / long),
    )  # fmt: skip
    t = run.history.time[-len(found) :]
    strain = np.column_stack([np.interp(t, times, values[:, k]) for k in range(3)])
    return Sheared(run=run, strain=strain, stress=np.array(found))
