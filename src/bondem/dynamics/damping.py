"""Damping of the elements' own motion and of the bonds between them."""

from dataclasses import dataclass
from typing import Any

from bondem._checks import number, shown
from bondem.errors import InputError


@dataclass(frozen=True)
class LocalDamping:
    """Local damping: each component F_i of the net force and torque becomes F_i - γ |F_i| sign(v_i).

    The damping vanishes in equilibrium and where the net force vanishes, and does not depend on the mass; it has no
    counterpart in a real material. A free oscillation keeps √((1 - γ) / (1 + γ)) of its amplitude per half period.
    Reference: Chen et al. (2022) eqs (11), (12), where the printed F U/U stands for F.

    Attributes:
        gamma: damping coefficient γ [-], in [0, 1); other values raise InputError.
    """

    gamma: float

    def __post_init__(self) -> None:
        number("LocalDamping", "gamma", self.gamma, least=0.0, below=1.0, advice="a coefficient in [0, 1)")


@dataclass(frozen=True)
class MassDamping:
    """Mass damping: a force -α m v and a moment -α I ω act on each element (Rayleigh's α).

    All modes decay as exp(-α t / 2), slow modes within fewer periods. Rigid motion decays as exp(-α t): momentum is
    not conserved. The damping does not lower the time step.

    Attributes:
        alpha: damping coefficient α [1/s]; a negative value raises InputError.
    """

    alpha: float

    def __post_init__(self) -> None:
        number("MassDamping", "alpha", self.alpha, least=0.0, advice="a rate of zero or more [1/s]")


@dataclass(frozen=True)
class BondDamping:
    """Bond damping: dashpots parallel to the springs of a bond, against the relative motion of its ends.

        c = 2 η √(k m̄) + β k for k = kn, ks,    c = 2 η √(k Ī) + β k for k = kb, kt

    with m̄ = mi mj / (mi + mj) and Ī = Ii Ij / (Ii + Ij). The motion is that at the contact point. The damping
    conserves momentum and angular momentum and does not affect rigid motion. η is the share of the critical damping
    of a pair. β damps a mode of angular frequency ω by the share β ω / 2 of its critical damping (Rayleigh's β); in
    bodies of cells, whose dilatation has no dashpots, by 0.79 to 0.94 of that share (0.86 to 1 at ν = 0). Both lower
    the critical time step.

    Reference: Chen et al. (2022) eqs (9), (10), each component with its own k.

    Attributes:
        eta: share η of the critical damping of a pair [-]; a negative value raises InputError.
        beta: coefficient β of damping in proportion to stiffness [s]; a negative value raises InputError.
    """

    eta: float = 0.0
    beta: float = 0.0

    def __post_init__(self) -> None:
        for name in ("eta", "beta"):
            number("BondDamping", name, getattr(self, name), least=0.0, advice="a value of zero or more")


AnyDamping = LocalDamping | MassDamping | BondDamping


@dataclass(frozen=True)
class DampingTerms:
    """The coefficients of all damping of a run.

    Attributes:
        gamma: coefficient of local damping [-].
        alpha: coefficient of mass damping [1/s].
        eta, beta: coefficients of bond damping [-, s].
    """

    gamma: float = 0.0
    alpha: float = 0.0
    eta: float = 0.0
    beta: float = 0.0

    @classmethod
    def of(cls, damping: Any) -> "DampingTerms":
        """Return the coefficients of one kind of damping, of several in a tuple or list, or of None (all zero).

        Raises:
            InputError: A value is not damping, or one kind is given twice.
        """
        kinds = () if damping is None else damping if isinstance(damping, tuple | list) else (damping,)
        values: dict[str, float] = {}
        for kind in kinds:
            if not isinstance(kind, AnyDamping):
                wanted = "bd.LocalDamping, bd.MassDamping, bd.BondDamping or several of them"
                raise InputError(f"damping= takes {wanted}, not {shown(kind)}")
            own = vars(kind)
            if values.keys() & own.keys():
                raise InputError(f"damping= has two {type(kind).__name__}; give one of each kind")
            values |= own
        return cls(**values)
