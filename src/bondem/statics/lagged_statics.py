"""Equilibrium of laws whose stresses lag one iteration behind the motions.

The tangential force of a bond is its area times a shear stress that all forces cause. Many sets of forces satisfy
this, so that the equations of equilibrium alone do not determine them. The equilibrium is the end of a path from the
unloaded state, in rounds of

    K u' = f + nodal loads of the extra forces e,    e' = e(σ, δ_t) of the motion u'

with K of the springs alone, the mean stress σ of both elements of a bond, and the tangential part δ_t of its gap.
After one round for each of `steps` equal shares of the load, rounds continue at full load until stresses no longer
change. The number of steps has no effect on the stresses.

If the extra shear force is limited, the rounds are mixed to converge sooner (Anderson). Without this limit the
rotations may never settle although stresses have, because no spring resists them. Rounds are then not mixed.
"""

from dataclasses import dataclass

import numpy as np

from bondem._blas import one_blas_thread
from bondem._types import Floats, PerElement6
from bondem.errors import ConvergenceError
from bondem.interactions.lagged_interaction import LaggedInteraction, LaggedStrain
from bondem.statics.linear import Elimination, Iteration, System

# Largest number of elements for which all rounds share one elimination.
_DIRECT = 4000
# Stresses have converged when they change by less than this share, in this number of successive rounds.
_SETTLED, _IN_A_ROW = 2e-5, 3
_ROUNDS = 400
# Number of mixed rounds, and least eigenvalue over the largest one that counts in the mixing.
_MEMORY, _RANK = 20, 1e-13
# Stresses over those of the loading rounds above which the rounds count as divergent.
_BEYOND = 1e6


@dataclass(frozen=True, eq=False)
class Settled:
    """Equilibrium of a law whose stresses lag by one iteration, user's order.

    Attributes:
        strain: deformation of all bonds, with their forces.
        motion: (u, θ) of the elements [m, rad], (n, 6).
        rounds: number of rounds.
        change: change of the stresses in the last round, root of sums of squares over that of the stresses [-].
    """

    strain: LaggedStrain
    motion: PerElement6
    rounds: int
    change: float


class LaggedStatics:
    """Statics of a law whose stresses lag one iteration; all iterations and loads share the matrix of its springs."""

    def __init__(self, law: LaggedInteraction, system: System) -> None:
        self._law = law
        small = len(law.layout.order) <= _DIRECT
        self._solver = Elimination(system) if small else Iteration(system)

    @one_blas_thread
    def settle(
        self, load: PerElement6, *, motion: PerElement6 | None = None, slip: Floats | float = 0.0, steps: int = 1,
        limited: bool | None = None,
    ) -> Settled:  # fmt: skip
        """Compute the equilibrium of all elements under a load.

        Args:
            load: forces and moments on the elements [N, N·m], (n, 6).
            motion: prescribed motions of the fixed or driven elements [m, rad], (n, 6).
            slip: additional opening of bonds by a macroscopic strain [m], (m, 3).
            steps: number of equal steps in which load, motion and slip are applied.
            limited: True if rounds may be mixed; None for the setting of the law.

        Raises:
            ConvergenceError: Stresses grow, or do not settle.
        """
        n = len(load)
        prescribed = np.zeros((n, 6)) if motion is None else motion
        mixing = Mixing(self._law.settles if limited is None else limited)
        now = self._law.at_rest()
        found: PerElement6 | None = None
        stress, scale, quiet, change = np.zeros((n, 6)), 0.0, 0, np.inf
        for k in range(1, _ROUNDS + 1):
            share = min(1.0, k / steps)
            before = now.moved(share * prescribed, share * slip)
            total = share * load + before.nodal(before.force)
            found = share * prescribed + self._answer(total, found)
            now = now.moved(found, share * slip)
            new = now.stress
            size = float(np.linalg.norm(new))
            scale = max(scale, size) if k <= steps else scale
            if not size <= _BEYOND * scale:
                title = self._law.title
                raise ConvergenceError(f"stresses of the {title} grow without end after {k} rounds; lower nu=")
            change = float(np.linalg.norm(new - stress)) / size if size > 0.0 else 0.0
            stress = new
            quiet = quiet + 1 if k > steps and change <= _SETTLED else 0
            if quiet == _IN_A_ROW:
                return Settled(now, found, k, change)
            later = now.lagged()
            extra = later.extra if k < steps else mixing(now.extra, later.extra)
            now = later.carrying(extra)
        raise ConvergenceError(
            f"stresses of the {self._law.title} still change by {change:.2g} a round after {_ROUNDS} rounds;"
            " lower nu=, or use solve_explicit with damping"
        )

    def _answer(self, total: PerElement6, guess: PerElement6 | None) -> PerElement6:
        layout = self._law.layout
        start = None if guess is None else guess[layout.order].ravel()
        return self._solver.solve(total[layout.order].ravel(), guess=start)[0].reshape(-1, 6)[layout.rank]


class Mixing:
    """Rule for the input of the next iteration: Anderson mixing of earlier inputs and outputs, or the last output."""

    def __init__(self, mixed: bool) -> None:
        self._most = _MEMORY if mixed else 0
        self._put: list[Floats] = []
        self._left: list[Floats] = []

    def __call__(self, put: Floats, out: Floats) -> Floats:
        """Return the next input, given the last input `put` and its output `out`, arrays of one shape."""
        if not self._most:
            return out
        self._put, self._left = [*self._put, put][-self._most :], [*self._left, out - put][-self._most :]
        if len(self._put) == 1:
            return out
        before = np.stack([b.ravel() - a.ravel() for a, b in zip(self._put, self._put[1:], strict=False)], axis=1)
        less = np.stack([b.ravel() - a.ravel() for a, b in zip(self._left, self._left[1:], strict=False)], axis=1)
        weight = np.linalg.lstsq(less.T @ less, less.T @ self._left[-1].ravel(), rcond=_RANK)[0]
        return out - ((before + less) @ weight).reshape(out.shape)
