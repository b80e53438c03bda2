"""Equilibrium, natural modes and motion of a model."""
