"""Quantities evaluated for a model and its state, which they never change."""
