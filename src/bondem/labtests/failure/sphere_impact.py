"""Impact of a ball on a rigid plane: damage, fragments and rebound."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from bondem._checks import instance, number, vector
from bondem._progress import staged
from bondem._types import Floats, Triple
from bondem.boundary.gauges import WallGauge
from bondem.boundary.walls import PlaneWall
from bondem.damage.failure_assignment import FailureAssignment
from bondem.dynamics.events import ContactEnd
from bondem.dynamics.plan import ExplicitResult
from bondem.errors import InputError
from bondem.interactions.contact.contact_law import ContactLaw
from bondem.interactions.law_catalogue import AnyLaw
from bondem.labtests.arguments import check
from bondem.labtests.ball import BallSpecimen, BrokenBall
from bondem.labtests.recorded_run import OfOneRun, run_test
from bondem.model.model import Model
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material, constant

# Steps between records, over which the impulse is integrated.
_EVERY = 2
# Time without contact after which a test ends, in diameters over the speed of sound; limit of the duration in contact
# times of a ball on a single element.
_QUIET, _CONTACTS = 3.0, 8.0
# Largest initial overlap with the plane over the diameter, for rounding [-].
_TOUCH = 1e-9


@dataclass(frozen=True, eq=False)
class SphereImpact(OfOneRun):
    """Result of an impact of a ball on a plane.

    Attributes:
        velocity: initial velocity of the ball [m/s], (3,).
        normal: normal of the plane, towards the ball [-], (3,).
        time, force: time [s] and force on the plane, positive in compression [N], of each record, (k,).
        broken: broken ball with `.pieces`, `.sizes`, `.damage`, `.fines` and `.largest`.
        restitution: normal speed of the heaviest fragment after the impact over that of the ball before [-].
        momentum: |impulse of the plane - change of momentum| over the initial momentum, an error measure [-].
        residual: error of the energy balance over its largest term [-].
        run: result of the explicit run.
    """

    velocity: tuple[float, float, float]
    normal: tuple[float, float, float]
    time: Floats
    force: Floats
    broken: BrokenBall
    restitution: float
    momentum: float
    residual: float
    run: ExplicitResult

    @property
    def damage(self) -> float:
        """Share of broken bonds or facets [-]."""
        return self.broken.damage

    @property
    def peak(self) -> float:
        """Largest force on the plane [N]."""
        return float(self.force.max(initial=0.0))

    @property
    def table(self) -> dict[str, Floats]:
        """Force on the plane in time, by name and unit, (k,) each."""
        return {"time [s]": self.time, "force [N]": self.force}


@staged("sphere impact")
def sphere_impact(
    ball: Lattice,
    law: AnyLaw,
    failure: FailureAssignment | None = None,
    *,
    density: float | Material,
    velocity: float | Triple,
    wall: PlaneWall | None = None,
    friction: float = 0.0,
    contact: ContactLaw | None = None,
    duration: float | None = None,
    fine: float = 0.2,
    out: str | Path | None = None,
    progress: Callable[[float], None] | None = None,
) -> SphereImpact:
    """Simulate the impact of a ball on a rigid plane, without damping.

    Args:
        ball: cells or bonded spheres of a `bd.Ball`.
        law: bond law, cell law or non-local law.
        failure: failure criterion, or criteria by region; None for an elastic ball.
        density: density of the elements, or of the material of cells [kg/m³], or a `bd.Material`.
        velocity: speed towards the plane, or velocity vector towards it, (3,) [m/s].
        wall: fixed plane; None for a plane across x that the ball touches on the side of x_min.
        friction: friction coefficient of the default plane [-].
        contact: contact law of fragments and plane; None for the stiffness of the median bond and a friction of 0.4
            between fragments.
        duration: duration of the run [s]; None to end once the plane has had no contact for three diameters over the
            speed of sound, or after eight contact times of a ball on a single element, plus approach and pause.
        fine: upper size limit of fines, as a share of the ball's diameter [-].
        out: run file (HDF5) from which the same call resumes a test or evaluates a complete one; None for no file.
        progress: callback, called at intervals with the completed share of the run [-], 0 … 1.

    Raises:
        InputError: a shape other than a ball, a plane that moves, lies inside the ball or is more than a diameter
            away, a velocity away from the plane, or a value out of range.
        UnstableRunError: the run became unstable or lost its energy balance.
        RunInterrupted: Ctrl-C was pressed. The `.result` of the error has the test so far, None for a short run.
    """
    density = constant("density", density)
    owner = "labtests.sphere_impact"
    check("sphere_impact", ball, faces="", density=density)
    number(owner, "friction", friction, least=0.0)
    number(owner, "fine", fine, above=0.0, below=1.0, advice="a share of the diameter in (0, 1)")
    if duration is not None:
        number(owner, "duration", duration, above=0.0, unit="s")
    bare = Model(ball, law, density, failure=failure)
    specimen = BallSpecimen.of("sphere_impact", bare)
    plane = _plane(specimen, wall, friction)
    normal, gap = np.array(plane.normal), _gap(specimen, plane)
    flight = _velocity(velocity, normal)
    fast = -float(np.dot(flight, normal))
    model = Model(ball, law, density, failure=failure, contact=specimen.contact(contact), walls=[plane])
    # for durations only: Young's modulus of a cubic lattice of equal bonds, and the mean density
    E = specimen.stiffness / (2.0 * float(np.median(specimen.radius)))
    rho = 6.0 * specimen.mass / (math.pi * specimen.diameter**3)
    quiet = _QUIET * specimen.diameter / math.sqrt(E / rho)
    longest = gap / fast + _CONTACTS * math.pi * math.sqrt(specimen.mass / specimen.stiffness) + quiet

    state = model.state()
    state.set_motion(velocity=np.tile(flight, (len(ball.particles), 1)))
    x, y, z = (-normal).tolist()
    return run_test(
        "sphere_impact", model, lambda run: _read(run, specimen, flight, normal, fine),
        duration=longest if duration is None else duration, every=_EVERY, out=out, state=state,
        until=ContactEnd("wall", (x, y, z), quiet) if duration is None else (), progress=progress,
        gauges={"wall": WallGauge(0, "force")},
    )  # fmt: skip


def _plane(ball: BallSpecimen, wall: PlaneWall | None, friction: float) -> PlaneWall:
    """Return the given plane, or a plane across x that touches the outermost element at x_min.

    Raises:
        InputError: another kind of wall, or a moving plane.
    """
    if wall is None:
        _, y, z = ball.middle.tolist()
        return PlaneWall((-ball.reach(np.array([-1.0, 0.0, 0.0])), y, z), (1.0, 0.0, 0.0), friction=friction)
    plane = instance("labtests.sphere_impact", "wall", wall, PlaneWall, "bd.PlaneWall(point, normal), or None")
    if plane.motion is not None:
        raise InputError("labtests.sphere_impact: wall moves; leave out motion= and give the velocity to the ball")
    return plane


def _gap(ball: BallSpecimen, plane: PlaneWall) -> float:
    """Compute the distance of the nearest element from the plane [m].

    Raises:
        InputError: the plane is inside the ball, or more than a diameter away.
    """
    normal = np.array(plane.normal)
    gap = -ball.reach(-normal) - float(np.dot(plane.point, normal))
    if gap < -_TOUCH * ball.diameter:
        raise InputError(
            f"labtests.sphere_impact: wall is {-gap:.3g} m inside the ball; move it outwards, or leave out wall="
        )
    if gap > ball.diameter:
        raise InputError(
            f"labtests.sphere_impact: wall is {gap:.3g} m from the ball; move it closer than a diameter,"
            f" {ball.diameter:.3g} m"
        )
    return max(gap, 0.0)


def _velocity(velocity: object, normal: Floats) -> Floats:
    """Return the initial velocity of the ball [m/s], (3,), from a speed or a vector.

    Raises:
        InputError: no velocity, or one away from the plane.
    """
    owner = "labtests.sphere_impact"
    if not isinstance(velocity, list | tuple | np.ndarray) or np.ndim(np.array(velocity, dtype=object)) == 0:
        return -number(owner, "velocity", velocity, above=0.0, unit="m/s") * normal
    advice = "a speed towards the plane, or three components [m/s]"
    found = np.array(vector(owner, "velocity", velocity, advice=advice))
    if not float(found @ normal) < 0.0:
        raise InputError(f"{owner}: velocity = {velocity}: points away from the plane; reverse its sign")
    return found


def _read(run: ExplicitResult, ball: BallSpecimen, flight: Floats, normal: Floats, fine: float) -> SphereImpact:
    history = run.history
    pushed = history["wall"]
    step = np.diff(history.time)[:, None]
    impulse = -(0.5 * (pushed[1:] + pushed[:-1]) * step).sum(axis=0)
    broken = ball.broken(run.state, fine)
    pieces = broken.pieces
    gained = (pieces.mass[:, None] * (pieces.velocity - flight)).sum(axis=0)
    initial = ball.mass * float(np.linalg.norm(flight))
    return SphereImpact(
        velocity=tuple(flight.tolist()), normal=tuple(normal.tolist()), time=history.time, force=-pushed @ normal,
        broken=broken, restitution=float(pieces.velocity[0] @ normal / -(flight @ normal)),
        momentum=float(np.linalg.norm(impulse - gained)) / initial, residual=run.residual, run=run,
    )  # fmt: skip
