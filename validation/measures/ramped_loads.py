"""Tension, bending and torsion of a clamped bar by explicit dynamics: loads grow slowly (André et al. 2012, §6.1)."""

from dataclasses import dataclass, replace

import numpy as np

import bondem as bd
from bondem._types import Floats
from bondem.dynamics.explicit import integrate
from bondem.dynamics.plan import settled
from bondem.errors import UnstableRunError
from bondem.labtests.beam_tests import Bar
from bondem.labtests.gauge_length import rigid_motion

#: What is tested.
KINDS = ("tension", "bending", "torsion")

_RECORDS = 1000
_DEPTH = 0.02  # of the faces, in mean radii
_STRESS = 1e5  # Pa; so small that geometry stays linear


@dataclass(frozen=True, eq=False)
class RampedLoad:
    """A bar that is loaded slowly.

    Attributes:
        time: of the records [s], (s,).
        answer: mean displacement of the face x_max along the force [m], or its rotation about x [rad], (s,).
        ramp: how long the load grew [s].
        theory: what strength of materials says of the full load, in units of the answer.
    """

    time: Floats
    answer: Floats
    ramp: float
    theory: float

    @property
    def held(self) -> float:
        """What the answer swings about once the load is full: a mean with a window that hardly sees the swing."""
        late = self.time >= self.ramp
        weight = np.sin(np.pi * (self.time[late] - self.ramp) / (self.time[-1] - self.ramp)) ** 2
        return float(weight @ self.answer[late] / weight.sum())

    @property
    def error(self) -> float:
        """Over theory, less one [-]."""
        return self.held / self.theory - 1.0

    @property
    def swing(self) -> float:
        """Largest distance from that mean while the load is full, over it [-]."""
        return float(np.abs(self.answer[self.time >= self.ramp] / self.held - 1.0).max())


def ramped_load(
    lattice: bd.Lattice, law: bd.BondLaw, bar: Bar, kind: str, *, density: float, steps: int, ramp: float, phi: float
) -> RampedLoad:
    """Hold x_min, let a load grow on x_max, then hold the load.

    Args:
        lattice: the specimen.
        law: its bonds.
        bar: what it is for strength of materials; Euler–Bernoulli in bending, as the paper.
        kind: one of `KINDS`: a force along x, one along y, or a moment about x.
        density: of the elements, ρ_μ [kg/m³].
        steps: of 0.9 of the critical time step.
        ramp: share of the steps in which the load grows [-].
        phi: of the scheme of Tchamwa and Wielgosz, which damps [-].

    Raises:
        UnstableRunError: the run became unstable.
    """
    section = bar.section
    force, moment = _STRESS * section.area, _STRESS * section.torsion_constant / section.area**0.5
    load, theory = {
        "tension": ({"force": (force, 0.0, 0.0)}, bar.extension(force)),
        "bending": ({"force": (0.0, force, 0.0)}, bar.deflection(force)),
        "torsion": ({"moment": (moment, 0.0, 0.0)}, bar.twist(moment)),
    }[kind]
    end, held = bd.Face("x_max", _DEPTH), bd.Fix(bd.Face("x_min", _DEPTH))
    clamped = bd.Model(lattice, law, density=density, boundary=[held])
    plan = settled(clamped, bd.Plan(duration=0.0, scheme=bd.TchamwaWielgosz(phi), every=max(steps // _RECORDS, 1)))
    assert plan.dt is not None
    growing = ramp * steps * plan.dt
    model = clamped.with_boundary([held, bd.Load(end, **load, schedule=bd.Ramp(0.0, 1.0, growing))])
    loaded = end.select(lattice)
    position = lattice.particles.position[loaded]
    component = KINDS.index(kind)
    time, answer = [], []

    def read(state: bd.State, _record: bd.History) -> None:
        moved = state.displacement[loaded]
        time.append(state.time)
        answer.append(rigid_motion(position, moved)[3] if kind == "torsion" else moved[:, component].mean())

    run = integrate(model, replace(plan, duration=steps * plan.dt), callback=read)
    if run.status.failed:
        raise UnstableRunError(run.message)
    return RampedLoad(np.array(time), np.array(answer), growing, theory)
