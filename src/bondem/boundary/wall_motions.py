"""Motions of walls: prescribed, servo-controlled, or by the forces on them."""

from dataclasses import dataclass

import numpy as np

from bondem._checks import array, number, vector
from bondem._types import Floats, Triple
from bondem.boundary.schedules import Schedule, as_schedule
from bondem.errors import InputError

# Number of the component that is a turn.
TURN = 4
# Number of each component by the name of its argument, and True for a velocity.
_COMPONENTS = {
    "x": (0, False), "y": (1, False), "z": (2, False), "growth": (3, False), "vx": (0, True), "vy": (1, True),
    "vz": (2, True), "vgrowth": (3, True), "angle": (TURN, False), "spin": (TURN, True),
}  # fmt: skip


def direction(owner: str, value: object) -> Triple:
    """Return the unit vector along a given vector; raise InputError if it has no length."""
    wanted = "three finite components, not all zero"
    components = np.array(vector("", owner, value, advice=wanted))
    size = np.linalg.norm(components)
    if not size > 0.0:
        raise InputError(f"{owner} = {value}; give {wanted}")
    x, y, z = (components / size).tolist()
    return x, y, z


@dataclass(frozen=True, init=False)
class Driven:
    """Prescribed motion of a wall, such as `Driven(x=bd.Ramp(0, -1e-4, 1e-3))` or `Driven(spin=2.0, axis=(0, 1, 0))`.

    Other components stay at rest, and displacements cannot jump in a run. Several walls with the same turn about the
    same point move as one rigid body.

    Attributes:
        motion: triples of component (0 … 4 for x, y, z, growth, angle), schedule, and True for a velocity.
        axis: unit vector about which the wall turns, (3,); the z axis by default.
        about: point about which the wall turns in the reference [m], (3,), moved by x, y, z; the origin by default.

    Args:
        x, y, z: displacements [m].
        growth: change of the radius of a cylinder or sphere [m].
        vx, vy, vz, vgrowth: velocities [m/s].
        angle: angle about `axis` [rad].
        spin: angular velocity about `axis` [rad/s], in place of the angle.

    Raises:
        InputError: No component is given, one is unknown or given twice, the axis has no length, or `axis` or `about`
            is given without a turn.
    """

    motion: tuple[tuple[int, Schedule, bool], ...]
    axis: Triple
    about: Triple

    def __init__(
        self, *, axis: Triple | None = None, about: Triple | None = None, **components: float | Schedule
    ) -> None:
        unknown = sorted(set(components) - set(_COMPONENTS))
        if unknown:
            raise InputError(f"Driven: unknown component '{unknown[0]}'; choose from {', '.join(_COMPONENTS)}")
        numbers = {key: _COMPONENTS[key] for key in components}
        motion = tuple((k, as_schedule("Driven", key, components[key]), rate) for key, (k, rate) in numbers.items())
        if not motion or len({k for k, _, _ in motion}) < len(motion):
            raise InputError("Driven: name each component once, as a displacement or as a velocity")
        object.__setattr__(self, "motion", motion)
        if not self.turns and (axis is not None or about is not None):
            raise InputError("Driven: axis and about are those of a turn; give angle= [rad] or spin= [rad/s] too")
        turned = direction("Driven: axis", (0.0, 0.0, 1.0) if axis is None else axis)
        object.__setattr__(self, "axis", turned)
        point = (0.0, 0.0, 0.0) if about is None else about
        object.__setattr__(self, "about", vector("Driven", "about", point, advice="three finite coordinates [m]"))

    @property
    def turns(self) -> bool:
        """True if a turn is prescribed."""
        return any(component == TURN for component, _, _ in self.motion)

    @property
    def components(self) -> dict[str, Schedule]:
        """Schedule of each prescribed displacement, velocity, angle or spin, by the name of its argument."""
        names = {number: name for name, number in _COMPONENTS.items()}
        return {names[component, rate]: schedule for component, schedule, rate in self.motion}


@dataclass(frozen=True, init=False)
class Servo:
    """A platen pushed along its normal by a prescribed force, against the force of the elements.

    Many codes move a platen without mass in proportion to the missing force; that is unstable where grains are little
    damped. This platen has a mass, so that it follows fast flow and its energy is accounted for. Local damping brings
    the platen to rest: a share of the missing force resists its motion. Every half period multiplies the amplitude of
    an oscillation about the prescribed force by √((1 - damping) / (1 + damping)), 0.42 by default.

    Dashpots of its contacts use the mass m of the element alone, as at a driven wall. With a platen of mass M these
    dashpots are √(1 + m / M) times those of the contact law. That law uses the reduced mass, as `Free` does.

    Attributes:
        force: sum of the normal forces on the wall [N], a number or a schedule; for a pressure, multiply by the area.
        speed: largest speed [m/s].
        mass: mass of the platen [kg]; None for the mass of all elements together.
        damping: share of the missing force that resists the motion [-], in [0, 1).

    Raises:
        InputError: The force is negative at any time, or speed, mass or damping is out of range.
    """

    force: Schedule
    speed: float
    mass: float | None
    damping: float

    def __init__(
        self, force: float | Schedule, *, speed: float, mass: float | None = None, damping: float = 0.7
    ) -> None:
        schedule = as_schedule("Servo", "force", force)
        if not min(schedule.table[1]) >= 0.0:
            raise InputError("Servo: force must be zero or more [N]; elements can only press on a wall")
        number("Servo", "speed", speed, unit="m/s", above=0.0, advice="the largest speed of the wall, positive")
        if mass is not None:
            number("Servo", "mass", mass, unit="kg", above=0.0, advice="the positive mass of the platen, or None")
        object.__setattr__(self, "force", schedule)
        object.__setattr__(self, "mass", mass)
        share = number("Servo", "damping", damping, least=0.0, below=1.0, advice="a share in [0, 1)")
        object.__setattr__(self, "speed", float(speed))
        object.__setattr__(self, "damping", share)


@dataclass(frozen=True)
class Free:
    """A rigid body pushed by elements: an impactor, a dropped weight, a flyer plate or a paddle.

    The centre of the body is the `point` of a plane or a cylinder, or the `centre` of a sphere. With `inertia` the
    body also turns about its centre, after Euler's equations (Dullweber, Leimkuhler and McLachlan, J. Chem. Phys.
    107, 1997, 5840-5851: symplectic, of second order in the step). Dashpots at its contacts are those for the reduced
    mass of body and element.

    The energy balance counts the work of the body on the elements as "work", and not the kinetic energy of the body;
    `bd.WallGauge(..., "velocity")` and `"angular_velocity"` record its motion. In a later stage the body continues
    with its velocities.

    Attributes:
        mass: mass of the body [kg].
        velocity: initial velocity [m/s], (3,).
        force: force on the body besides that of the elements, such as its weight [N], (3,).
        inertia: moments of inertia about x, y and z, or the matrix of inertia in the reference, about the centre
            [kg·m²], (3,) or (3, 3); None for a body that does not turn.
        spin: initial angular velocity [rad/s], (3,).
        torque: torque on the body about its centre besides that of the elements [N·m], (3,).

    Raises:
        InputError: The mass is not positive; a vector is not three finite numbers; the inertia is not symmetric, not
            positive, or not that of a body; or a spin or a torque is given without inertia.
    """

    mass: float
    velocity: Triple = (0.0, 0.0, 0.0)
    force: Triple = (0.0, 0.0, 0.0)
    inertia: Triple | tuple[Triple, Triple, Triple] | None = None
    spin: Triple = (0.0, 0.0, 0.0)
    torque: Triple = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        number("Free", "mass", self.mass, unit="kg", above=0.0, advice="the positive mass of the body in kg")
        for name, unit in (("velocity", "m/s"), ("force", "N"), ("spin", "rad/s"), ("torque", "N·m")):
            given = vector("Free", name, getattr(self, name), advice=f"three finite components [{unit}]")
            object.__setattr__(self, name, given)
        if self.inertia is not None:
            object.__setattr__(self, "inertia", _inertia(self.inertia))
        elif any(self.spin) or any(self.torque):
            raise InputError("Free: spin and torque turn a body that has inertia; give inertia= [kg·m²] too")

    @property
    def matrix(self) -> Floats:
        """Matrix of inertia in the reference [kg·m²], (3, 3); zero for a body that does not turn."""
        given = np.zeros(3) if self.inertia is None else np.array(self.inertia)
        return np.diag(given) if given.ndim == 1 else given


def _inertia(given: object) -> Triple | tuple[Triple, Triple, Triple]:
    """Return moments (3,) or a matrix (3, 3) of inertia [kg·m²]; raise InputError if no body can have them."""
    wanted = "three positive moments or a symmetric matrix of 3 x 3 [kg·m²]"
    values = array("Free", "inertia", given, wanted=wanted)
    matrix = np.diag(values) if values.shape == (3,) else values
    if matrix.shape != (3, 3) or not np.isfinite(matrix).all():
        raise InputError(f"Free: inertia has the shape {values.shape} or values that are not finite; give {wanted}")
    if not np.allclose(matrix, matrix.T, rtol=1e-9, atol=0.0):
        raise InputError(f"Free: the matrix of inertia is not symmetric; give {wanted}")
    least, middle, largest = np.linalg.eigvalsh(matrix)
    if not least > 0.0:
        raise InputError(f"Free: a principal moment of inertia is {least:.4g} kg·m²; give {wanted}")
    if largest > (1.0 + 1e-9) * (least + middle):
        raise InputError(
            f"Free: no body has the principal moments {least:.4g}, {middle:.4g} and {largest:.4g} kg·m², the largest"
            " of which is above the sum of the others; check inertia="
        )
    if values.ndim == 1:
        x, y, z = values.tolist()
        return x, y, z
    a, b, c = (tuple(row) for row in values.tolist())
    return a, b, c
