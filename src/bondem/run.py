"""The public solvers."""

from bondem.solve.static import solve_static

__all__ = ["solve_static"]
