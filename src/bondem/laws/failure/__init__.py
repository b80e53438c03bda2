"""Failure criteria, one per file: parameters, and the scalar function that evaluates one bond."""
