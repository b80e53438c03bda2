"""Equilibrium by dynamic relaxation, with adaptive damping, and masses chosen for fast convergence."""

import numpy as np

from bondem._cache_lines import lines
from bondem._checks import count, instance, number
from bondem._core import run_pass
from bondem._passes import calls
from bondem._progress import staged
from bondem._tables.statics_tables import DynamicRelaxation, RelaxationSpan
from bondem._tables.step_tables import Beams, BeamSums, UniformBeams
from bondem._types import PerElement
from bondem.errors import ConvergenceError, InputError
from bondem.interactions.beams.beam_tables import beam_tables, count_turned
from bondem.model.highest_frequency import stiffest
from bondem.model.model import Model
from bondem.model.state import State
from bondem.statics.floating import refuse_floating
from bondem.statics.linear import require_lasting
from bondem.statics.nonlinear import moved_from_rest, strained
from bondem.statics.static import StaticResult

# Intended ω_max of the relaxing motion for its time step of 1, whose stability limit is 2.
_FREQUENCY = 1.8
# Largest motion of supports in one step: rotation [rad], and displacement over the shortest bond.
_PACE = 0.01
# Steps in one call of the core.
_CHUNK = 2_000
# Steps in one call of the core if forces of moments rotate with their regions.
_TURNING = 20


@staged("relaxation")
def solve_relaxed(model: Model, *, tolerance: float = 1e-6, most: int = 1_000_000) -> StaticResult:
    """Compute the equilibrium at any rotation under the loads and prescribed motions at the end of their schedules.

    Dynamic relaxation needs no matrix and no more memory than an explicit run. The mass of each element is
    proportional to the stiffness at the element, so that all elements move about as fast. The time step is 1. Damping
    is critical for the present frequency of the specimen. `solve_static` is much faster if K can be stored.

    Args:
        model: model to solve, of either formulation; its supports must prevent all rigid motions.
        tolerance: unbalanced force over the sum of applied and supporting force at which to stop [-]. These are roots
            of sums of squares, with torques divided by the mean radius.
        most: largest number of steps.

    Raises:
        InputError: The model has contacts, walls, a criterion, cells, no potential, too few supports or a prescribed
            velocity. Or `tolerance` or `most` is out of range.
        ConvergenceError: Forces do not balance in `most` steps, or bonds turned too far.
    """
    instance("solve_relaxed", "model", model, Model, "bd.Model(...)")
    number("", "tolerance", tolerance, above=0.0, below=1.0, advice="a share of the force in (0, 1), such as 1e-6")
    count("solve_relaxed", "most", most, least=1)
    require_lasting(model, "use solve_explicit with damping instead")
    if not model.interaction.has_potential:
        title = model.interaction.title
        raise InputError(f"solve_relaxed needs a potential, which the {title} lacks; use solve_static")
    model.interaction.refuse_facets("solve_relaxed supports no cells; use solve_static, also with nonlinear=True")
    layout, constraints = model.layout, model.constraints
    n = len(layout.order)
    prescribed = constraints.prescribed(n)
    if prescribed.sum() < 6:
        raise InputError("solve_relaxed needs a specimen that is held; fix all six rigid motions with Fix")
    refuse_floating(model, model.lattice.centre[layout.order], prescribed)
    connected = model.lattice.connected[layout.order]
    free = connected[:, None] & ~prescribed
    motion, load = constraints.final_motion(n), constraints.final_load(n)
    length = model.lattice.particles.mean_radius
    mass, inertia = masses(model)
    inverse = np.column_stack([1.0 / mass, 1.0 / inertia]) * connected[:, None]

    state, model = State(model), strained(model, 1.0)
    bonds = model.bonds
    beams, uniform = beam_tables(bonds, model.layout, model.period, state.integrity)
    sums = BeamSums(beams.i, beams.j, lines(n))
    fastest = max(np.abs(motion[:, :3]).max() / bonds.length.min(initial=np.inf), np.abs(motion[:, 3:]).max())
    relaxation = DynamicRelaxation(
        pose=state.pose, velocity=np.zeros((n, 6)), before=np.zeros((n, 6)), load=load, inverse=inverse,
        free=free.astype(np.uint8), motion=motion, memory=np.zeros(2), ramp=max(1, int(np.ceil(fastest / _PACE))),
        length=length, tolerance=tolerance,
        noise=1e-14 * float((bonds.kn * bonds.length).max(initial=0.0)) * np.sqrt(n),
    )  # fmt: skip
    done, ratio, finished = 0, np.inf, False
    turning = bool(constraints.couples)
    while done < most and not finished:
        goal = min(_TURNING if turning else _CHUNK, most - done)
        if turning:  # the forces of moments turn with their regions
            load[:] = constraints.final_load(n, state.pose)
        taken, ratio, balanced = relaxed(beams, uniform, sums, relaxation, done, goal)
        finished = taken == 0 if turning else balanced
        done += taken
        _, lost, sick = count_turned(state.pose, beams)
        if lost or sick:
            raise ConvergenceError(
                f"{lost} bonds are turned beyond 90 degrees after {done} steps; lower the load, or bond with more and"
                " shorter bonds"
            )
    if not finished:
        raise ConvergenceError(
            f"forces do not balance after {done} steps: {ratio:.3g} of them remain; raise tolerance= or most=, or"
            " use solve_static"
        )
    values = moved_from_rest(state)[layout.rank]
    reaction = np.where(prescribed, -relaxation.before - load, 0.0)[layout.rank]
    energy = model.interaction.energy(state.pose, state.rest, state.integrity, state.eigenstrain)
    return StaticResult(
        values[:, :3].copy(), values[:, 3:].copy(), reaction, energy, model, True,
        iterations=done, residual=float(ratio),
    )  # fmt: skip


def relaxed(
    beams: Beams, uniform: UniformBeams | None, sums: BeamSums, relaxation: DynamicRelaxation, first: int, most: int
) -> tuple[int, float, bool]:
    """Take at most `most` steps of dynamic relaxation, from step `first` on.

    Returns:
        Number of steps taken, unbalanced force over applied and supporting force [-], and True if the forces balance.
    """
    span = RelaxationSpan(first, most, np.zeros(1, dtype=np.int64), np.full(1, np.inf))
    if uniform is None:
        ending = run_pass(calls.relax_beams(beams, sums, relaxation, span))
    else:
        ending = run_pass(calls.relax_uniform_beams(beams, uniform, sums, relaxation, span))
    return int(span.done[0]), float(span.ratio[0]), ending == "balanced"


def masses(model: Model) -> tuple[PerElement, PerElement]:
    """Return masses and moments of inertia of the elements for relaxation in steps of 1, internal order, (n,) each.

    Both are proportional to the translational and rotational stiffness at the element, so that all elements by
    themselves move at one frequency. Their size follows from the highest frequency of the lattice.
    """
    layout, bonds = model.layout, model.bonds
    n = len(layout.order)
    kn, kt = bonds.kn, bonds.kt
    along, about = np.zeros(n), np.zeros(n)
    for end, arm in ((layout.i, bonds.lever), (layout.j, bonds.length - bonds.lever)):
        along += np.bincount(end, weights=np.maximum(kn, bonds.ks), minlength=n)
        about += np.bincount(end, weights=np.maximum(kt, bonds.kb + bonds.ks * arm**2), minlength=n)
    along[along == 0.0] = 1.0
    about[about == 0.0] = 1.0
    scale = stiffest(model, along, about) / _FREQUENCY**2 or 1.0
    return along * scale, about * scale
