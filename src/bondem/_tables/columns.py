"""Numbers of `core/tables/columns.hpp`, written by `python -m tests.core.tables` from the header."""

from enum import IntEnum

ELEMENTS_OF_PORTION = 1024  #: elements of a portion
BONDS_OF_PORTION = 2048  #: bonds or facets of a portion
TERMS_OF_THREAD = 32  #: elements, bonds or facets whose terms a thread of a device adds up
STRESS_COLUMN = 3  #: column of a pose, `pose.stress`, with the stress λ θ of a cell [Pa]


class ExactWord(IntEnum):
    """Words of a sum without rounding (`core/exact_sum.hpp`): its limbs, and flags of terms that are not finite."""

    FLAGS = 67
    COUNT = 68


class HistoryColumn(IntEnum):
    """Columns of a record of the history before those of gauges."""

    TIME = 0  #: [s]
    TRANSLATION = 1  #: kinetic energy [J]
    ROTATION = 2  #: kinetic energy [J]
    NORMAL = 3  #: elastic energy of bonds [J]
    SHEAR = 4  #: elastic energy of bonds [J]
    BENDING = 5  #: elastic energy of bonds [J]
    TWISTING = 6  #: elastic energy of bonds [J]
    CONTACT = 7  #: elastic energy of contacts [J]
    WORK = 8  #: work of loads, drives and walls [J]
    LOSS = 9  #: loss to damping [J]
    FRICTION = 10  #: loss to friction [J]
    EXTRA_WORK = 11  #: work of the extra forces of the non-local law [J]
    RELEASED = 12  #: energy that bonds have released [J]
    PLASTIC = 13  #: energy that cells have dissipated by yielding [J]
    CRUSHING = 14  #: part of the released energy beyond the fracture energy [J]
    COUNT = 15


class StepCount(IntEnum):
    """Counts of a call of the core: steps, records, bonds beyond safe angles (wide) and beyond valid ones (lost)."""

    STEPS = 0
    RECORDS = 1
    WIDE = 2
    LOST = 3


class GuardNumber(IntEnum):
    """Results of the guard: bonds beyond safe angles (wide) and beyond valid ones (lost), the ending of the call,
    and 1 for lists out of date.
    """

    WIDE = 0
    LOST = 1
    ENDING = 2
    OUT_OF_DATE = 3


class TurnCount(IntEnum):
    """Counts of bonds beyond safe angles (wide) and beyond valid ones (lost), and of portions not finite."""

    WIDE = 0
    LOST = 1
    NOT_FINITE = 2


class WallSum(IntEnum):
    """Sums of the forces on a wall, as `WallLoad` has them."""

    FORCE = 0
    NORMAL = 3
    TORQUE = 4
    COUNT = 7


class GuardEnergy(IntEnum):
    """Energies that bound the kinetic energy for the guard: that at the start, and the largest one supplied since."""

    START = 0
    SUPPLIED = 1


class LogCount(IntEnum):
    """Counts of a log of events: of all, and of those before the present step."""

    EVENTS = 0
    BEFORE = 1


class EventColumn(IntEnum):
    """Columns of an event, the failure of a bond."""

    TIME = 0  #: [s]
    STEP = 1  #: number of the step
    BOND = 2  #: number of the bond
    MODE = 3  #: `failure_mode`
    GAP = 4  #: how far it is open [m]
    ENERGY = 5  #: energy released [J]
    PLACE = 6  #: x of the place [m]; y and z follow
    OPENING_STEPS = 9  #: steps since the onset of softening, nan of a bond that failed at once
    COUNT = 10


class FailureMode(IntEnum):
    """Modes of failure by the largest part of the index; states and run files store the number."""

    INTACT = 0
    TENSION = 1
    SHEAR = 2
    BENDING = 3
    TWISTING = 4


class SoftColumn(IntEnum):
    """Columns of a beam that has begun to soften."""

    BOND = 0  #: number of the beam
    FIRST = 1  #: opening λ at the onset [√J]
    LAST = 2  #: opening λ at which no integrity is left [√J]
    RATE = 3  #: -∂U/∂s a step ago [J]
    SPENT = 4  #: energy dissipated [J]
    MODE = 5  #: `failure_mode` of the larger part of the index
    BEGAN = 6  #: step of onset
    COUNT = 7


class PlasticColumn(IntEnum):
    """Columns of a cell that yields."""

    DEFORMATION = 0  #: P - 1 of its plastic deformation P in its own frame, row by row
    GAMMA = 9  #: Σ Δγ
    INCREMENT = 10  #: last increment of strain in space: xx, yy, zz, xy, xz, yz
    HEAT = 16  #: energy dissipated [J]
    COUNT = 17


class TensorColumn(IntEnum):
    """Columns of the stress of a cell: xx … yz, Σ T_b² of the bending of facets, and the size of the stress."""

    BENDING = 6
    SIZE = 7


class LoadColumn(IntEnum):
    """Columns of the sums of an element: force, energy lost to damping, torque, energy lost to friction."""

    FORCE = 0
    DAMPED = 3
    TORQUE = 4
    RUBBED = 7


class StrainDue(IntEnum):
    """Flags of stress-free strains in a step: ∂U/∂factor is needed; lengths or levers have changed."""

    POWER = 0
    LEVERS = 1


class ListCount(IntEnum):
    """Counts of the lists of cracks: active cracks, resting cracks, cells of active cracks, cracks parted in this
    step.
    """

    TREATED = 0
    RESTING = 1
    CELLS = 2
    PARTED = 3


class CrackNumber(IntEnum):
    """Numbers of cohesive cracks: how many there are, and 1 where lists are out of date."""

    CRACKS = 0
    OUT_OF_DATE = 1


class CrackKind(IntEnum):
    """Kinds of cracks. A crack of the material has an integrity for each direction. An isotropic one has a single
    integrity: on a material plane, or at a cell without cohesion. `let_go`: a crack of the material without grip.
    """

    OF_MATERIAL = 0
    ISOTROPIC = 1
    LET_GO = 2


class CrackStatus(IntEnum):
    """Statuses of cracks: `active`, evaluated by itself in each step; `resting`, a facet of reduced stiffness;
    `parted`, faces apart, no force.
    """

    ACTIVE = 0
    RESTING = 1
    PARTED = 2


class TouchState(IntEnum):
    """States of contacts. A contact that has parted in this step still counts its losses. `facing` cells touch by
    cracked faces that face each other, not as spheres. Where such faces turn away within the reach of the
    spheres, the contact is `late`: the spheres touch at the distance of that time, until the cells are apart.
    """

    SEPARATE = 0
    TOUCHING = 1
    PARTED = 2
    FACING = 3
    LATE = 4


class WallKind(IntEnum):
    """Kinds of walls: a plane, a cylinder around the elements or among them, a sphere around them or among them, a
    disc.
    """

    PLANE_WALL = 0
    CYLINDER_AROUND = 1
    CYLINDER_AMONG = 2
    SPHERE_AROUND = 3
    SPHERE_AMONG = 4
    DISC_WALL = 5


class GaugeQuantity(IntEnum):
    """Quantities of elements that gauges record."""

    DISPLACEMENT = 0
    VELOCITY = 1
    ROTATION = 2
    ANGULAR_VELOCITY = 3
    FORCE = 4
    OF_WALLS = 5


class WallQuantity(IntEnum):
    """Quantities of a wall that gauges record, after those of elements. Power is that of the wall on the elements:
    by its velocity and its growth, by its spin, and their sum.
    """

    DISPLACEMENT = 5
    FORCE = 6
    GROWTH = 7
    VELOCITY = 8
    TORQUE = 9
    ROTATION = 10
    ANGULAR_VELOCITY = 11
    POWER = 12


class GaugeReduction(IntEnum):
    """Reductions by which a gauge makes one number of many."""

    MEAN = 0
    SUM = 1
    MAX_ABS = 2


class RelaxationReport(IntEnum):
    """Columns of the report of a relaxation."""

    RMS_FORCE = 0  #: [m]
    MEAN_OVERLAP = 1  #: [m]
    CONTACTS = 2
    LARGEST_OVERLAP = 3  #: [m]
    STEPS = 4
    COUNT = 5


class GrowthReport(IntEnum):
    """Columns of the report of a growth."""

    TIME = 0  #: time that has passed
    VIRIAL = 1  #: sum of distance times exchanged momentum [m²]
    COLLISIONS = 2
    COUNT = 3
