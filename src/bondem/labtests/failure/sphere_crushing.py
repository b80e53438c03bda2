"""Crushing of a ball between two plates: single-particle strength, fragments and fines."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from bondem._checks import number
from bondem._progress import staged
from bondem._types import Floats
from bondem.boundary.gauges import WallGauge
from bondem.boundary.schedules import Ramp
from bondem.boundary.wall_motions import Driven
from bondem.boundary.walls import PlaneWall
from bondem.damage.failure_assignment import FailureAssignment
from bondem.dynamics.damping import MassDamping
from bondem.dynamics.events import LoadDrop
from bondem.dynamics.plan import ExplicitResult
from bondem.errors import InputError
from bondem.interactions.contact.contact_law import ContactLaw
from bondem.interactions.law_catalogue import AnyLaw
from bondem.labtests.arguments import check
from bondem.labtests.ball import BallSpecimen, BrokenBall
from bondem.labtests.recorded_run import OfOneRun, run_test, step_of
from bondem.model.model import Model
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material, constant

#: 2.8 / π: the tensile strength of Hiramatsu and Oka (1966) over F / D².
TENSION = 2.8 / math.pi
# Default density of a test [kg/m³].
_DENSITY = 2000.0
# Share of the critical damping of the first axial vibration; number of records; limit of the approach over that at
# the expected peak; share of the time until that peak in which the plates accelerate.
_DAMPING, _RECORDS, _REACH, _BEGIN = 0.05, 800, 4.0, 0.2
# Largest expected approach at the peak over the diameter. The plates grind balls of brittle beams down at a small
# share of the strength of their bonds, so that an estimate from the section would be too large.
_CLOSING = 0.0125
# Least share of the expected force at which a drop of the load ends the test.
_SURE = 0.3


@dataclass(frozen=True, eq=False)
class SphereCrushing(OfOneRun):
    """Result of a crushing test.

    Attributes:
        force: largest force between the plates, F [N].
        diameter: diameter of the ball, D [m].
        curve: approach of the plates over D [-] and 2.8 F / (π D²) [Pa] of each record, shape (k, 2).
        work: work of the plates until the end [J].
        broken: broken ball with `.pieces`, `.sizes`, `.damage`, `.fines` and `.largest`.
        asymmetry: largest difference of the forces on both plates up to the peak, over the peak [-].
        kinetic: largest kinetic energy up to the peak over the elastic energy at the peak [-].
        residual: error of the energy balance over its largest term [-].
        run: result of the explicit run.
    """

    force: float
    diameter: float
    curve: Floats
    work: float
    broken: BrokenBall
    asymmetry: float
    kinetic: float
    residual: float
    run: ExplicitResult

    @property
    def peak(self) -> float:
        """Nominal tensile strength 2.8 F / (π D²) of Hiramatsu and Oka (1966) [Pa], for the largest force F."""
        return TENSION * self.jaeger

    @property
    def jaeger(self) -> float:
        """Strength measure F / D² of Jaeger (1967) [Pa], for the largest force F and the diameter D."""
        return self.force / self.diameter**2

    @property
    def table(self) -> dict[str, Floats]:
        """Curve, with time and energies of its records, by name and unit, (k,) each."""
        curve = {"approach over diameter [-]": self.curve[:, 0], "2.8 F / (π D²) [Pa]": self.curve[:, 1]}
        return curve | dict(self.run.table)


@staged("sphere crushing")
def sphere_crushing(
    ball: Lattice,
    law: AnyLaw,
    failure: FailureAssignment,
    *,
    friction: float = 0.0,
    contact: ContactLaw | None = None,
    density: float | Material | None = None,
    traverses: float = 300.0,
    ending: float = 0.2,
    fine: float = 0.2,
    out: str | Path | None = None,
    progress: Callable[[float], None] | None = None,
) -> SphereCrushing:
    """Crush a ball along x between two rigid plates that approach each other, until the load has dropped.

    The plates start at the outermost elements and move at equal speeds. Elements touch them as spheres, cells as
    spheres of equal volume.

    The nominal tensile strength 2.8 F / (π D²) is a measure by which laboratories compare balls and lumps. It is not
    a closed form of f_t, as cells under the plates may crush before the ball splits. Before the peak the force rises
    in steps as further elements come into contact, so that it follows Hertz only approximately. Balls of brittle
    beams (`bd.PeripheralStress` without a fracture energy) lose one element after another at the plates. Their
    largest force is that of grinding, within an approach of at most a twentieth of the diameter.

    Args:
        ball: cells or bonded spheres of a `bd.Ball`.
        law: bond law, cell law or non-local law.
        failure: failure criterion, or criteria by region.
        friction: friction coefficient of the plates [-]; 0 is smooth.
        contact: contact law of fragments and plates; None for the stiffness of the median bond and a friction of 0.4
            between fragments.
        density: density of the elements, or of the material of cells [kg/m³], or a `bd.Material`; None for 2000.
            Results do not depend on it until fragments fly off.
        traverses: number of passes of sound along the diameter before the expected peak [-]; more is slower.
        ending: share of the peak load at which the test ends [-].
        fine: upper size limit of fines, as a share of the ball's diameter [-].
        out: run file (HDF5) from which the same call resumes a test or evaluates a complete one; None for no file.
        progress: callback, called at intervals with the completed share of the run [-], 0 … 1.

    Raises:
        InputError: a shape other than a ball, no criterion, or a value out of range.
        UnstableRunError: the run became unstable or lost its energy balance.
        RunInterrupted: Ctrl-C was pressed. The `.result` of the error has the test so far, None for a short run.

    Reference: Hiramatsu and Oka, Int. J. Rock Mech. Min. Sci. 3 (1966) 89-99; Jaeger, Can. Geotech. J. 4 (1967).
    """
    density = constant("density", density)
    owner = "labtests.sphere_crushing"
    check("sphere_crushing", ball, faces="", density=_DENSITY if density is None else density)
    number(owner, "friction", friction, least=0.0)
    number(owner, "traverses", traverses, least=1.0, advice="a number of at least 1")
    share = number(owner, "ending", ending, least=0.0, below=1.0)
    number(owner, "fine", fine, above=0.0, below=1.0, advice="a share of the diameter in (0, 1)")
    if failure is None:
        raise InputError(f"{owner}: failure = None; give a criterion such as bd.Rankine or bd.PeripheralStress")
    rho = _DENSITY if density is None else density
    bare = Model(ball, law, rho, failure=failure)
    specimen = BallSpecimen.of("sphere_crushing", bare)
    expected, way, sound = _expected(bare, specimen)
    rise = traverses * specimen.diameter / sound
    speed, begin = way / rise, _BEGIN * rise
    plates = _plates(specimen, 0.5 * speed, begin, friction)
    model = Model(ball, law, rho, failure=failure, contact=specimen.contact(contact), walls=plates)
    duration = _REACH * rise + 0.5 * begin
    damping = MassDamping(alpha=2.0 * _DAMPING * math.pi * sound / specimen.diameter)
    dt = step_of(model, damping=damping)
    dropped = LoadDrop({"far": (0.5, 0.0, 0.0), "near": (-0.5, 0.0, 0.0)}, share, _SURE * expected)
    return run_test(
        "sphere_crushing", model, lambda run: _read(run, specimen, speed, begin, fine), duration=duration, dt=dt,
        every=max(1, round(duration / _RECORDS / dt)), out=out, damping=damping, until=dropped, progress=progress,
        gauges={"near": WallGauge(0, "force"), "far": WallGauge(1, "force")},
    )  # fmt: skip


def _plates(ball: BallSpecimen, speed: float, begin: float, friction: float) -> list[PlaneWall]:
    """Create both plates, which touch the outermost elements at x_min and x_max and approach at 2 · speed [m/s].

    Each plate reaches its speed at the time `begin` [s] and has a coefficient of `friction` [-].
    """
    _, y, z = ball.middle.tolist()
    return [
        PlaneWall((side * ball.reach(np.array([side, 0.0, 0.0])), y, z), (-side, 0.0, 0.0),
                  Driven(vx=Ramp(0.0, -side * speed, begin)), friction)
        for side in (-1.0, 1.0)
    ]  # fmt: skip


def _expected(model: Model, ball: BallSpecimen) -> tuple[float, float, float]:
    """Estimate the peak force [N], the approach of the plates at the peak [m] and the speed of sound [m/s].

    These estimates only set the speed of the plates, the damping and the limits of the test.
    """
    found = model.implied_fracture
    assert found is not None
    strength = found.weakest
    if model.interaction.evaluated == "force":  # beams: their share of a section of the ball
        lattice = model.lattice
        solid = (math.pi * model.stiffness.radius**2 * lattice.length).sum() / lattice.particles.envelope.volume
        strength *= min(float(solid) / 3.0, 1.0)
    force = strength * ball.diameter**2 / TENSION
    hertz = 2.0 * (0.75 * force / (found.E * math.sqrt(0.5 * ball.diameter))) ** (2.0 / 3.0)
    way = min(hertz + 2.0 * force / ball.stiffness, _CLOSING * ball.diameter)
    return force, way, math.sqrt(found.E / found.density)


def _read(run: ExplicitResult, ball: BallSpecimen, speed: float, begin: float, fine: float) -> SphereCrushing:
    history = run.history
    t, energy = history.time, history.parts
    near, far = (history[side][:, 0] for side in ("near", "far"))
    force = 0.5 * (far - near)  # positive in compression
    top = int(np.argmax(force))
    moved = np.where(t < begin, 0.5 * t**2 / begin, t - 0.5 * begin) * speed
    peak, stored = (max(float(one[top]), 1e-300) for one in (force, energy["elastic"]))
    return SphereCrushing(
        force=float(force[top]), diameter=ball.diameter,
        curve=np.column_stack([moved / ball.diameter, TENSION * force / ball.diameter**2]),
        work=float(energy["work"][-1]), broken=ball.broken(run.state, fine),
        asymmetry=float(np.abs(far + near)[: top + 1].max()) / peak,
        kinetic=float(energy["kinetic"][: top + 1].max()) / stored,
        residual=run.residual, run=run,
    )  # fmt: skip
