"""Failure criteria, one module per criterion."""
