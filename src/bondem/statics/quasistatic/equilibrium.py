"""Successive equilibria of a body, each a little weaker than the one before."""

import math
from typing import Protocol

import numpy as np

from bondem._types import Floats, PerBond
from bondem.errors import ConvergenceError
from bondem.statics.linear import MECHANISM, Elimination, Iteration, System
from bondem.statics.quasistatic.facet_matrix import FacetMatrix
from bondem.statics.quasistatic.gradient_passes import GradientSolver

# An iteration ends where the energy of its error is this share, squared, of that of the body: tractions are off by
# 1e-4 of the largest then, a fiftieth of what facets that fail together may differ by. Residual over load would not
# do: the load of a wall that moves stays as it is while what the body bears vanishes.
_ERROR = 5e-5
# The same where no energy is known: residual over load.
_RTOL = 1e-6
# The preconditioner is made anew where all iterations since then took so many more than they would have with a new
# one: about what it costs to make. How fast a new one is the first few solutions tell.
_LOST, _NEW = 150.0, 5


class Equilibrium(Protocol):
    """Solver for displacements and rotations that balance a load, with the present matrix.

    Attributes:
        rounds: number of iterations so far.
        solutions: number of equilibria so far.
    """

    rounds: int
    solutions: int

    def solve(self, right: Floats, guess: Floats, energy: float = 0.0) -> Floats:
        """Return u (6 n,) with K u = `right` where elements are free, starting from a guess.

        Args:
            right: forces and torques [N, N·m], (6 n,).
            guess: start of the iteration, (6 n,).
            energy: about twice the energy of the body [J], 0 if unknown.
        """
        ...


class Eliminated:
    """Solver by elimination, repeated for each equilibrium; for small bodies."""

    def __init__(self, system: System) -> None:
        self._system, self.rounds, self.solutions = system, 0, 0

    def solve(self, right: Floats, guess: Floats, energy: float = 0.0) -> Floats:
        """See `Equilibrium`."""
        self.solutions += 1
        return Elimination(self._system).solve(right, guess=guess)[0]


class Iterated:
    """Solver by conjugate gradients from the last solution, with a preconditioner that is renewed when it is slow.

    Attributes:
        rounds, solutions: numbers of iterations and equilibria so far.
    """

    def __init__(self, system: System, matrix: FacetMatrix, iteration: Iteration, integrity: PerBond) -> None:
        """Begin with the preconditioner of the whole body.

        Args:
            system: system whose matrix changes.
            matrix: matrix of the present body, scaled as in `iteration`.
            iteration: iteration with the present matrix.
            integrity: integrity of its facets, which changes too, (m,).
        """
        self._system, self._matrix, self._iteration, self._integrity = system, matrix, iteration, integrity
        self.rounds = self.solutions = 0
        self._begin()

    def solve(self, right: Floats, guess: Floats, energy: float = 0.0) -> Floats:
        """See `Equilibrium`."""
        S, gradients = self._iteration, self._gradients
        scaled = S.turned(self._system.balanced(right))
        stop = _RTOL * float(np.linalg.norm(scaled)) if energy == 0.0 else 0.0
        enough = _ERROR**2 * energy
        x = gradients.solve(scaled, S.unscaled(guess), stop=stop, energy=enough)
        if x is None:
            if self._fresh:
                raise ConvergenceError(MECHANISM)
            self._renew()
            return self.solve(right, guess, energy)
        self.rounds, self.solutions = self.rounds + gradients.rounds, self.solutions + 1
        if energy > 0.0:
            self._judge(gradients.rounds, math.log10(max(gradients.first / enough, 10.0)))
        return self._system.without_rigid_motion(S.displacement(x))

    def _judge(self, rounds: int, digits: float) -> None:
        """Check whether the preconditioner still serves, by the number of iterations per digit of the energy."""
        self._fresh = False
        self._solved += 1
        if self._solved <= _NEW:
            self._rate += rounds / digits / _NEW
            return
        self._lost += rounds - self._rate * digits
        if self._lost > _LOST:
            self._renew()

    def _renew(self) -> None:
        """Make the preconditioner of the present matrix."""
        self._iteration = Iteration(self._system, (*self._matrix.sides, 1.0 - self._integrity))
        self._matrix.rescale(self._iteration.root)
        self._begin()

    def _begin(self) -> None:
        """Make the tables of the preconditioner, and reset its record."""
        self._gradients = GradientSolver(self._matrix, self._iteration)
        self._fresh, self._solved, self._rate, self._lost = True, 0, 0.0, 0.0
