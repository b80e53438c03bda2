"""Statics: equilibria, natural modes and quasi-static crack paths."""
