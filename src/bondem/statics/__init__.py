"""Equilibria, modes and quasi-static crack paths."""
