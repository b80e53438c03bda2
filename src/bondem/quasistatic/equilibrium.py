"""Equilibria of one body after another, each a little weaker than the one before."""

from typing import Protocol

import numpy as np

from bondem._types import Floats
from bondem.errors import ConvergenceError
from bondem.quasistatic.facet_matrix import FacetMatrix
from bondem.solve.linear import Elimination, Iteration, System, conjugate_gradients

# Residual over load at which an iteration ends.
RTOL = 1e-6
# The preconditioner is made anew where iterations take so many times as many as with a new one, and at least so many.
_SLOWER, _FEW = 1.6, 25


class Equilibrium(Protocol):
    """Finds displacements and rotations that balance a load, with the matrix as it is now.

    Attributes:
        rounds: iterations so far.
    """

    rounds: int

    def solve(self, right: Floats, guess: Floats) -> Floats:
        """u (6 n,) with K u = `right` where elements are free; it begins at a guess."""
        ...


class Eliminated:
    """By elimination, each time from the beginning: small bodies."""

    def __init__(self, system: System) -> None:
        self._system, self.rounds = system, 0

    def solve(self, right: Floats, guess: Floats) -> Floats:
        """See `Equilibrium`."""
        return Elimination(self._system).solve(right, guess=guess)[0]


class Iterated:
    """By conjugate gradients from the last solution, with a preconditioner that is kept while it serves.

    Attributes:
        rounds: iterations so far.
    """

    def __init__(self, system: System, matrix: FacetMatrix, begun: Iteration) -> None:
        """Begin with the preconditioner of the whole body.

        Args:
            system: whose matrix changes.
            matrix: the same, scaled as `begun` has it.
            begun: of the matrix as it is now.
        """
        self._system, self._matrix, self._begun = system, matrix, begun
        self._fresh, self._usual, self.rounds = True, 0, 0

    def solve(self, right: Floats, guess: Floats) -> Floats:
        """See `Equilibrium`."""
        S, matrix = self._begun, self._matrix
        x = S.unscaled(guess)
        scaled = S.turned(self._system.balanced(right))
        try:
            step, rounds = conjugate_gradients(
                matrix, S.approximate, scaled - matrix @ x, RTOL * float(np.linalg.norm(scaled))
            )
        except ConvergenceError:
            if self._fresh:
                raise
            self._renew()
            return self.solve(right, guess)
        self.rounds += rounds
        found = self._system.without_rigid_motion(S.displacement(x + step))
        if self._fresh:
            self._usual, self._fresh = rounds, False
        elif rounds > max(_FEW, _SLOWER * self._usual):
            self._renew()
        return found

    def _renew(self) -> None:
        """Make the preconditioner of the matrix as it is now."""
        self._begun = Iteration(self._system)
        self._matrix.rescale(self._begun.root)
        self._fresh = True
