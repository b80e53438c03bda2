"""Quantities evaluated for a model and its state, without a change of either."""
