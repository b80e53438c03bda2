"""Solvers for successive equilibria of a body that loses stiffness from one to the next."""

import math
from typing import Protocol

import numpy as np

from bondem._types import Floats, PerBond
from bondem.errors import ConvergenceError
from bondem.statics.linear import MECHANISM, Elimination, Iteration, System
from bondem.statics.quasistatic.facet_matrix import FacetMatrix
from bondem.statics.quasistatic.gradient_passes import GradientSolver

# Root of the energy of the error over that of the body at which an iteration ends. Tractions are then off by 1e-4 of
# the largest, a fiftieth of the range of facets that fail together. The residual over the load is no measure: the
# load of a moving wall stays while the forces in the body vanish.
_ERROR = 5e-5
# Residual over load at which an iteration ends if no energy is known.
_RTOL = 1e-6
# Number of iterations, above those of a new preconditioner, after which it is renewed: about its cost. The first
# solutions determine the rate of a new one.
_LOST, _NEW = 150.0, 5


class Equilibrium(Protocol):
    """Interface of solvers for the displacements and rotations that balance a load, with the present matrix.

    Attributes:
        rounds: number of iterations so far.
        solutions: number of equilibria so far.
    """

    rounds: int
    solutions: int

    def solve(self, right: Floats, guess: Floats, energy: float = 0.0) -> Floats:
        """Return u (6 n,) [m, rad] with K u = `right` where elements are free.

        Args:
            right: forces and torques [N, N·m], (6 n,).
            guess: start of the iteration [m, rad], (6 n,).
            energy: about twice the energy of the body [J], 0 if unknown.
        """
        ...


class Eliminated:
    """Solver for small bodies, by a new elimination for each equilibrium."""

    def __init__(self, system: System) -> None:
        self._system, self.rounds, self.solutions = system, 0, 0

    def solve(self, right: Floats, guess: Floats, energy: float = 0.0) -> Floats:
        """Return the solution by a new elimination; arguments as for `Equilibrium.solve`."""
        self.solutions += 1
        return Elimination(self._system).solve(right, guess=guess)[0]


class Iterated:
    """Solver by conjugate gradients from a guess, with a preconditioner that is renewed when it is slow.

    Attributes:
        rounds, solutions: numbers of iterations and equilibria so far.
    """

    def __init__(self, system: System, matrix: FacetMatrix, iteration: Iteration, integrity: PerBond) -> None:
        """Prepare the solver with the preconditioner of the uncracked body.

        Args:
            system: system whose matrix the caller changes in place.
            matrix: matrix of the present body, scaled as in `iteration`.
            iteration: iteration with the present matrix.
            integrity: integrity of the facets, an array that the caller changes in place, (m,).
        """
        self._system, self._matrix, self._iteration, self._integrity = system, matrix, iteration, integrity
        self.rounds = self.solutions = 0
        self._begin()

    def solve(self, right: Floats, guess: Floats, energy: float = 0.0) -> Floats:
        """Return the solution by conjugate gradients; arguments as for `Equilibrium.solve`."""
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
        """Renew the preconditioner if iterations per decimal digit of the energy have become too many."""
        self._fresh = False
        self._solved += 1
        if self._solved <= _NEW:
            self._rate += rounds / digits / _NEW
            return
        self._lost += rounds - self._rate * digits
        if self._lost > _LOST:
            self._renew()

    def _renew(self) -> None:
        """Compute the preconditioner of the present matrix."""
        self._iteration = Iteration(self._system, (*self._matrix.sides, 1.0 - self._integrity))
        self._matrix.rescale(self._iteration.root)
        self._begin()

    def _begin(self) -> None:
        """Make the tables of the preconditioner, and reset the statistics of its iterations."""
        self._gradients = GradientSolver(self._matrix, self._iteration)
        self._fresh, self._solved, self._rate, self._lost = True, 0, 0.0, 0.0
