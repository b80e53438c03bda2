"""Quantities computed from a model or a state, which they never change."""
