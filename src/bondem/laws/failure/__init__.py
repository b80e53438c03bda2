"""Failure criteria, one per file: parameters, coefficients of each bond, and bounds."""
