"""Fracture without inertia: one event after the other, each at the load factor at which it is next."""

from bondem.quasistatic.solve import QuasistaticResult, solve_quasistatic

__all__ = ["QuasistaticResult", "solve_quasistatic"]
